#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <tuple>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/CheckParts.h"
#include "sim2d/scenario/Defaults.h"

namespace sim2d {
namespace {

std::string pointText(const Vec2& point) {
  const auto rounded = [](double value) {
    return base::formatDouble(std::round(value * 1000.0) / 1000.0);
  };
  return "(" + rounded(point.x()) + ", " + rounded(point.y()) + ")";
}

/// A place that a body is to stand at.
struct Place {
  Vec2 point = Vec2::Zero();
  std::string what;  // "anna: init_pose", "goal 3"
  EntityId entity;
};

/// The way of one person or robot: where it starts and the goals in order.
struct Round {
  Place start;
  std::vector<Place> goals;
  double radius = 0.0;
  bool planned = true;
  std::string name;
  EntityId entity;
};

class PlacesCheck {
 public:
  PlacesCheck(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report)
      : scenario_(scenario),
        grid_(surroundings.grid),
        obstacles_(surroundings.obstacles),
        layers_(*surroundings.layers),
        report_(report) {
    openDoors(surroundings.firstDoorPart);
  }

  void check() {
    const std::vector<Round> rounds = allRounds();
    if (nothingStands() || isTooWide(rounds)) {
      return;
    }
    std::vector<Vec2> points;
    for (const Round& round : rounds) {
      points.push_back(round.start.point);
      for (const Place& goal : round.goals) {
        points.push_back(goal.point);
      }
    }
    layer_ = layers_.of(grid_, obstacles_, points);
    for (const Round& round : rounds) {
      checkRound(round);
    }
  }

 private:
  /// A door that will be open some time does not cut anybody off.
  void openDoors(int part) {
    for (const Door& door : scenario_.doors) {
      if (door.listed) {
        if (!door.toggles.empty() && part < obstacles_.partCount()) {  // else without walls
          obstacles_.setEnabled(part, false);
        }
        ++part;
      }
    }
  }

  bool nothingStands() const {
    if (!grid_.isEmpty()) {
      return false;
    }
    for (int part = 0; part < obstacles_.partCount(); ++part) {
      if (obstacles_.isEnabled(part) && !obstacles_.outlines(part).empty()) {
        return false;
      }
    }
    return true;
  }

  /// On the open plane the planning grid spans everything: no more than 40 million cells of 0.1 m.
  bool isTooWide(const std::vector<Round>& rounds) {
    if (!grid_.isEmpty()) {
      return false;
    }
    Vec2 low = Vec2::Constant(1e9);
    Vec2 high = Vec2::Constant(-1e9);
    const auto include = [&](const Vec2& point) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    };
    for (const Round& round : rounds) {
      include(round.start.point);
      for (const Place& goal : round.goals) {
        include(goal.point);
      }
    }
    for (int part = 0; part < obstacles_.partCount(); ++part) {
      for (const Outline& outline : obstacles_.outlines(part)) {
        std::for_each(outline.points.begin(), outline.points.end(), include);
      }
    }
    const Vec2 size = high - low;
    if (size.x() * size.y() <= 4e5) {
      return false;
    }
    report_.warning({base::EntityKind::Scenario, 0},
                    "starts, goals and obstacles lie too far apart to check for ways round "
                    "obstacles without a map");
    return true;
  }

  std::vector<Round> allRounds() const {
    std::vector<Round> rounds;
    for (const Human& human : scenario_.humans) {
      if (human.listed) {
        rounds.push_back(roundOf(human));
      }
    }
    for (const Robot& robot : scenario_.robots) {
      if (robot.listed) {
        rounds.push_back(roundOf(robot));
      }
    }
    return rounds;
  }

  Place placeOf(const GlobalGoal& goal) const {
    return {goal.position, "goal " + std::to_string(goal.id), goal.key};
  }

  Round roundOf(const Human& human) const {
    const ResolvedHuman resolved = resolveHuman(scenario_, human, 0);
    Round round;
    round.start = {resolved.start.position, human.name + ": init_pose", human.key};
    round.radius = resolved.radius;
    round.planned = resolved.route == Route::Planned;
    round.name = human.name;
    round.entity = human.key;
    for (const int id : human.goals) {
      if (const GlobalGoal* goal = scenario_.goal(id)) {
        round.goals.push_back(placeOf(*goal));
      }
    }
    return round;
  }

  Round roundOf(const Robot& robot) const {
    const ResolvedRobot resolved = resolveRobot(scenario_, robot, -1);
    Round round;
    round.start = {resolved.start.position, robot.name + ": start", robot.key};
    round.radius = resolved.radius;
    round.name = robot.name;
    round.entity = robot.key;
    if (robot.goal.point) {
      round.goals.push_back({*robot.goal.point, robot.name + ": goal", robot.key});
      return round;
    }
    for (const int id : robot.goal.goals) {
      if (const GlobalGoal* goal = scenario_.goal(id)) {
        round.goals.push_back(placeOf(*goal));
      }
    }
    return round;
  }

  /// Where the body will stand; told once per place and radius.
  std::optional<Vec2> fit(const Place& place, double radius) {
    std::optional<Vec2> taken = layer_->plannerFor(radius).nearestFit(place.point);
    const auto told = told_.insert(std::make_tuple(place.entity, place.what, radius));
    if (!told.second) {
      return taken;
    }
    const std::string body = "a body of radius " + base::formatDouble(radius);
    if (!taken) {
      report_.error(place.entity, place.what + " " + pointText(place.point) + ": " + body +
                                      " fits neither there nor anywhere within 1 m");
    } else if (*taken != place.point) {
      report_.warning(place.entity, place.what + " " + pointText(place.point) + ": " + body +
                                        " does not fit, a run takes " + pointText(*taken));
    } else if (!grid_.isEmpty() && grid_.isUnknown(grid_.worldToCell(place.point))) {
      report_.warning(place.entity, place.what + " " + pointText(place.point) +
                                        ": the map does not know "
                                        "this place");
    }
    return taken;
  }

  void checkRound(const Round& round) {
    const std::optional<Vec2> start = fit(round.start, round.radius);
    std::set<std::string> unreachable;
    const Place* from = &round.start;
    std::string blocked;
    for (const Place& goal : round.goals) {
      const std::optional<Vec2> point = fit(goal, round.radius);
      if (start && point && round.planned &&
          !layer_->plannerFor(round.radius).isReachable(*start, *point) &&
          unreachable.insert(goal.what).second) {
        report_.warning(round.entity, round.name + ": there is no way from the start to " +
                                          goal.what + " " + pointText(goal.point) +
                                          ", it is left out");
      }
      if (start && point && blocked.empty() && !obstacles_.isVisible(from->point, goal.point)) {
        blocked = goal.what;
      }
      from = &goal;
    }
    tellBlocked(round, blocked);
  }

  /// HuNavSim's people walk straight from goal to goal.
  void tellBlocked(const Round& round, const std::string& goal) {
    if (goal.empty() || round.entity.kind != base::EntityKind::Human) {
      return;
    }
    const std::string message = round.name + ": a wall stands in the straight line to " + goal;
    if (round.planned) {
      report_.info(round.entity, message + " (HuNavSim's people walk straight)");
    } else {
      report_.warning(round.entity, message);
    }
  }

  const Scenario& scenario_;
  const OccupancyGrid& grid_;
  Obstacles obstacles_;
  NavigationLayers& layers_;
  CheckReport& report_;
  std::shared_ptr<const NavigationLayer> layer_;
  std::set<std::tuple<EntityId, std::string, double>> told_;
};

}  // namespace

void checkPlaces(const Scenario& scenario, const Surroundings& surroundings, CheckReport& report) {
  PlacesCheck(scenario, surroundings, report).check();
}

}  // namespace sim2d
