#include "sim2d/scenario/Scenario.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr std::array<const char*, 6> kBehaviorNames = {"Regular", "Impassive", "Surprised",
                                                       "Scared",  "Curious",   "Threatening"};

template <class T>
int largestKey(const std::vector<T>& all, int atLeast) {
  for (const T& entity : all) {
    atLeast = std::max(atLeast, entity.key.key);
  }
  return atLeast;
}

}  // namespace

const char* behaviorName(BehaviorType type) {
  return kBehaviorNames.at(static_cast<std::size_t>(type) - 1);
}

std::optional<BehaviorType> behaviorFromName(const std::string& word) {
  const std::string lower = base::lowered(word);
  for (std::size_t i = 0; i < kBehaviorNames.size(); ++i) {
    if (base::lowered(kBehaviorNames[i]) == lower) {
      return static_cast<BehaviorType>(i + 1);
    }
  }
  return std::nullopt;
}

const GlobalGoal* Scenario::goal(int id) const {
  const auto usual = static_cast<std::size_t>(id) - 1;  // most files count from 1
  if (id >= 1 && usual < goals.size() && goals[usual].id == id) {
    return &goals[usual];
  }
  const auto found =
      std::find_if(goals.begin(), goals.end(), [id](const GlobalGoal& g) { return g.id == id; });
  return found == goals.end() ? nullptr : &*found;
}

const Human* Scenario::human(const std::string& name) const {
  const auto found =
      std::find_if(humans.begin(), humans.end(), [&](const Human& h) { return h.name == name; });
  return found == humans.end() ? nullptr : &*found;
}

const Human* Scenario::humanById(int id) const {
  const auto usual = static_cast<std::size_t>(id) - 1;
  if (id >= 1 && usual < humans.size() && humans[usual].id == id && humans[usual].listed) {
    return &humans[usual];
  }
  const Human* unlisted = nullptr;
  for (const Human& human : humans) {
    if (human.id == id && human.listed) {
      return &human;
    }
    if (human.id == id && unlisted == nullptr) {
      unlisted = &human;
    }
  }
  return unlisted;
}

int Scenario::nextKey() const {
  int largest = largestKey(goals, 0);
  largest = largestKey(humans, largest);
  largest = largestKey(robots, largest);
  largest = largestKey(obstacles, largest);
  largest = largestKey(doors, largest);
  return largestKey(areas, largest) + 1;
}

bool operator==(const Behavior& a, const Behavior& b) {
  const auto content = [](const Behavior& v) {
    return std::tie(v.type, v.foreignType, v.configuration, v.dist, v.duration, v.once, v.vel,
                    v.safeDistance, v.stopDist, v.frontDist, v.goalForceFactor,
                    v.obstacleForceFactor, v.socialForceFactor, v.otherForceFactor, v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const GlobalGoal& a, const GlobalGoal& b) {
  return std::tie(a.id, a.position, a.unknown) == std::tie(b.id, b.position, b.unknown);
}

bool operator==(const PersonExtension& a, const PersonExtension& b) {
  const auto content = [](const PersonExtension& v) {
    return std::tie(v.startTime, v.kind, v.mass, v.model, v.route, v.atEnd, v.wait, v.tree,
                    v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const Human& a, const Human& b) {
  const auto content = [](const Human& v) {
    return std::tie(v.name, v.id, v.listed, v.groupId, v.skin, v.maxVel, v.radius, v.goalRadius,
                    v.cyclicGoals, v.initPose, v.hasInitPose, v.initZ, v.initPoseUnknown,
                    v.behavior, v.goals, v.unknown, v.ours);
  };
  return content(a) == content(b);
}

bool operator==(const RobotGoal& a, const RobotGoal& b) {
  return a.point == b.point && a.goals == b.goals;
}

bool operator==(const Robot& a, const Robot& b) {
  const auto content = [](const Robot& v) {
    return std::tie(v.name, v.listed, v.type, v.planner, v.plannerParameters, v.start, v.goal,
                    v.goalRadius, v.startTime, v.radius, v.mass, v.maxVel, v.maxAcc, v.maxOmega,
                    v.maxAlpha, v.footprintX, v.footprintY, v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const Obstacle& a, const Obstacle& b) {
  const auto content = [](const Obstacle& v) {
    return std::tie(v.name, v.listed, v.kind, v.pose, v.length, v.width, v.radius, v.points,
                    v.thickness, v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const Door& a, const Door& b) {
  const auto content = [](const Door& v) {
    return std::tie(v.name, v.listed, v.from, v.to, v.thickness, v.open, v.toggles, v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const Area& a, const Area& b) {
  const auto content = [](const Area& v) {
    return std::tie(v.name, v.listed, v.kind, v.points, v.like, v.rate, v.from, v.until, v.count,
                    v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const MetricsSettings& a, const MetricsSettings& b) {
  const auto content = [](const MetricsSettings& v) {
    return std::tie(v.from, v.until, v.frequency, v.tag, v.runId, v.file, v.parameters, v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const DesktopSettings& a, const DesktopSettings& b) {
  const auto content = [](const DesktopSettings& v) {
    return std::tie(v.mapFile, v.mapRule, v.seed, v.duration, v.dt, v.recordEvery, v.model, v.route,
                    v.obstaclePoints, v.loopTrees, v.wrapX, v.groups, v.metrics, v.unknown);
  };
  return content(a) == content(b);
}

bool operator==(const Scenario& a, const Scenario& b) {
  const auto content = [](const Scenario& v) {
    return std::tie(v.yamlBaseName, v.simulator, v.map, v.publishPeople, v.goals, v.humans,
                    v.robots, v.obstacles, v.doors, v.areas, v.desktop, v.unknown, v.otherNodes);
  };
  return content(a) == content(b);
}

}  // namespace sim2d
