#include <algorithm>
#include <cmath>

#include "sim2d/base/Text.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/CheckParts.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

constexpr EntityId kScenario{base::EntityKind::Scenario, 0};
constexpr double kFarthest = 1e6;  // [m]

struct Limits {
  const char* key;
  std::optional<double> value;
  double low, high;
};

void checkLimits(const Human& human, CheckReport& report) {
  const Behavior& behavior = human.behavior;
  const std::vector<Limits> factors = {
      {"goal_force_factor", behavior.goalForceFactor, 2.0, 5.0},
      {"obstacle_force_factor", behavior.obstacleForceFactor, 2.0, 50.0},
      {"social_force_factor", behavior.socialForceFactor, 5.0, 20.0},
      {"other_force_factor", behavior.otherForceFactor, 0.0, 25.0},
  };
  const bool custom = behavior.configuration == Configuration::Custom;
  for (const Limits& limits : factors) {
    if (!custom && limits.value && (*limits.value < limits.low || *limits.value > limits.high)) {
      report.warning(human, "person.out-of-range",
                     {limits.key, *limits.value, limits.low, limits.high});
    }
  }
  if (behavior.vel && *behavior.vel > 1.8) {
    report.warning(human, "person.vel-too-high", {*behavior.vel});
  }
}

/// Keys that a reaction needs and the file leaves out, with the value that counts.
void checkReaction(const Scenario& scenario, const Human& human, CheckReport& report) {
  const Behavior& behavior = human.behavior;
  const BehaviorType type = behavior.type.value_or(BehaviorType::Regular);
  if (type == BehaviorType::Regular || type == BehaviorType::Impassive) {
    return;
  }
  const ResolvedHuman counts = resolveHuman(scenario, human, 0);
  const bool drawn = behavior.configuration == Configuration::Normal ||
                     behavior.configuration == Configuration::Uniform;
  std::string missing;
  const auto need = [&](bool present, const char* key, const std::string& value, bool isDrawn) {
    if (!present && !(drawn && isDrawn)) {
      missing += (missing.empty() ? "" : ", ") + std::string(key) + " " + value;
    }
  };
  const auto needNumber = [&](const std::optional<double>& value, const char* key, double used) {
    need(value.has_value(), key, base::formatDouble(used), true);
  };
  needNumber(behavior.dist, "dist", counts.noticeDistance);
  needNumber(behavior.duration, "duration", counts.reactionDuration);
  need(behavior.once.has_value(), "once", "false", false);
  if (type == BehaviorType::Scared) {
    needNumber(behavior.vel, "vel", counts.reactionSpeed);
    needNumber(behavior.safeDistance, "safe_distance", counts.safeDistance);
  } else if (type == BehaviorType::Curious) {
    needNumber(behavior.vel, "vel", counts.reactionSpeed);
    needNumber(behavior.stopDist, "stop_dist", counts.stopDistance);
  } else if (type == BehaviorType::Threatening) {
    needNumber(behavior.frontDist, "front_dist", counts.frontDistance);
  }
  if (!missing.empty()) {
    report.warning(human, "person.behavior-incomplete", {missing});
  }
}

void checkPerson(const Scenario& scenario, const Human& human, CheckReport& report) {
  checkLimits(human, report);
  checkReaction(scenario, human, report);
  const int most = largestSkin(scenario.simulator.value_or(""));
  if (human.skin && *human.skin != -1 && (*human.skin < 0 || *human.skin > most)) {
    report.warning(human, "person.skin-unknown",
                   {*human.skin, std::clamp(*human.skin, 0, most), most,
                    scenario.simulator.value_or("no simulator named")});
  }
  if (!human.hasInitPose) {
    report.warning(human, "person.no-init-pose");
  }
  if (human.goals.empty()) {
    report.warning(human, "person.no-goals");
  }
  if (!human.ours.wait.empty() && human.ours.wait.size() != human.goals.size()) {
    report.error(human, "person.wait-count", {human.goals.size(), human.ours.wait.size()});
  }
  if (!(human.ours == PersonExtension{}) && blockKeys().count(human.name) != 0) {
    report.error(human.key, "person.name-is-key", {human.name});
  }
}

void checkPolygon(const std::vector<Vec2>& points, const std::string& name, EntityId entity,
                  CheckReport& report) {
  if (points.size() >= 3 && !isSimple(points)) {
    report.add(base::Severity::Error, entity, name, "shape.sides-cross");
  }
}

class CoordinateCheck {
 public:
  explicit CoordinateCheck(CheckReport& report) : report_(report) {}

  void point(const Vec2& point, EntityId entity, const std::string& what) {
    const bool good = std::fabs(point.x()) <= kFarthest && std::fabs(point.y()) <= kFarthest;
    if (!good) {
      refuse(entity, what, "shape.too-far", {point.x(), point.y()});
    }
  }
  void points(const std::vector<Vec2>& all, EntityId entity, const std::string& what) {
    for (const Vec2& each : all) {
      point(each, entity, what);
    }
  }
  void heading(double angle, EntityId entity, const std::string& what) {
    if (!(std::fabs(angle) <= kFarthest)) {
      refuse(entity, what, "shape.no-angle", {angle});
    }
  }
  bool good() const { return good_; }

 private:
  void refuse(EntityId entity, const std::string& what, std::string_view code,
              base::ProblemValues values) {
    report_.add(base::Severity::Error, entity, what, code, std::move(values));
    good_ = false;
  }

  CheckReport& report_;
  bool good_ = true;
};

}  // namespace

void checkPeople(const Scenario& scenario, CheckReport& report) {
  for (const Human& human : scenario.humans) {
    if (human.listed) {
      checkPerson(scenario, human, report);
    }
  }
  const auto anyone = [](const auto& all) {
    return std::any_of(all.begin(), all.end(), [](const auto& each) { return each.listed; });
  };
  if (!anyone(scenario.humans) && !anyone(scenario.robots)) {
    report.warning(kScenario, "scenario.nobody");
  }
}

void checkShapes(const Scenario& scenario, CheckReport& report) {
  for (const Obstacle& obstacle : scenario.obstacles) {
    if (obstacle.listed && obstacle.kind == ObstacleKind::Polygon) {
      checkPolygon(obstacle.points, obstacle.name, obstacle.key, report);
    }
  }
  for (const Area& area : scenario.areas) {
    if (area.listed) {
      checkPolygon(area.points, area.name, area.key, report);
    }
  }
  for (const Robot& robot : scenario.robots) {
    if (robot.listed) {
      checkPolygon(resolveRobot(scenario, robot, -1).footprint, robot.name + ": footprint",
                   robot.key, report);
    }
  }
  for (const Door& door : scenario.doors) {
    if (door.listed && door.from == door.to) {
      report.error(door, "shape.door-without-length");
    }
  }
}

bool checkCoordinates(const Scenario& scenario, CheckReport& report) {
  CoordinateCheck check(report);
  for (const GlobalGoal& goal : scenario.goals) {
    check.point(goal.position, goal.key, "goal " + std::to_string(goal.id));
  }
  for (const Human& human : scenario.humans) {
    if (human.listed) {
      check.point(human.initPose.position, human.key, human.name + ": init_pose");
      check.heading(human.initPose.heading, human.key, human.name + ": init_pose");
    }
  }
  for (const Robot& robot : scenario.robots) {
    if (robot.listed) {
      check.point(robot.start.position, robot.key, robot.name + ": start");
      check.heading(robot.start.heading, robot.key, robot.name + ": start");
      check.point(robot.goal.point.value_or(Vec2::Zero()), robot.key, robot.name + ": goal");
    }
  }
  for (const Obstacle& obstacle : scenario.obstacles) {
    if (obstacle.listed) {
      check.point(obstacle.pose.position, obstacle.key, obstacle.name);
      check.points({{obstacle.length, obstacle.width}, {obstacle.radius, 0.0}}, obstacle.key,
                   obstacle.name + ": size");
      check.points(obstacle.points, obstacle.key, obstacle.name);
    }
  }
  for (const Door& door : scenario.doors) {
    if (door.listed) {
      check.points({door.from, door.to}, door.key, door.name);
    }
  }
  for (const Area& area : scenario.areas) {
    if (area.listed) {
      check.points(area.points, area.key, area.name);
    }
  }
  return check.good();
}

}  // namespace sim2d
