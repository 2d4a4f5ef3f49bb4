#include "sim2d/scenario/Scenario.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/Fields.h"

namespace sim2d {
namespace {

constexpr std::array<const char*, 6> kBehaviorNames = {"Regular", "Impassive", "Surprised",
                                                       "Scared",  "Curious",   "Threatening"};

/// Of two drawn things or robots.
template <class T>
bool areSame(const T& a, const T& b) {
  return a.name == b.name && a.listed == b.listed && haveSameValues(a, b) && a.unknown == b.unknown;
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
  int largest = 0;
  const auto look = [&largest](const auto& all) {
    for (const auto& entity : all) {
      largest = std::max(largest, entity.key.key);
    }
  };
  look(goals);
  look(humans);
  look(robots);
  look(obstacles);
  look(doors);
  look(areas);
  return largest + 1;
}

bool operator==(const Behavior& a, const Behavior& b) {
  return haveSameValues(a, b) && a.unknown == b.unknown;
}

bool operator==(const GlobalGoal& a, const GlobalGoal& b) {
  return std::tie(a.id, a.position, a.unknown) == std::tie(b.id, b.position, b.unknown);
}

bool operator==(const PersonExtension& a, const PersonExtension& b) {
  return haveSameValues(a, b) && a.unknown == b.unknown;
}

bool operator==(const Human& a, const Human& b) {
  const auto rest = [](const Human& v) {
    return std::tie(v.name, v.listed, v.initPose, v.hasInitPose, v.initZ, v.initPoseUnknown,
                    v.behavior, v.goals, v.unknown, v.ours);
  };
  return haveSameValues(a, b) && rest(a) == rest(b);
}

bool operator==(const RobotGoal& a, const RobotGoal& b) {
  return a.point == b.point && a.goals == b.goals;
}

bool operator==(const Robot& a, const Robot& b) {
  return areSame(a, b);
}

bool operator==(const Obstacle& a, const Obstacle& b) {
  return areSame(a, b);
}

bool operator==(const Door& a, const Door& b) {
  return areSame(a, b);
}

bool operator==(const Area& a, const Area& b) {
  return areSame(a, b);
}

bool operator==(const MetricsSettings& a, const MetricsSettings& b) {
  return haveSameValues(a, b) && a.unknown == b.unknown;
}

bool operator==(const DesktopSettings& a, const DesktopSettings& b) {
  return haveSameValues(a, b) && a.metrics == b.metrics && a.unknown == b.unknown;
}

bool operator==(const ScenarioSettings& a, const ScenarioSettings& b) {
  return haveSameValues(a, b) && a.desktop == b.desktop;
}

bool operator==(const Scenario& a, const Scenario& b) {
  const auto rest = [](const Scenario& v) {
    return std::tie(v.goals, v.humans, v.robots, v.obstacles, v.doors, v.areas, v.unknown,
                    v.otherNodes);
  };
  return static_cast<const ScenarioSettings&>(a) == b && rest(a) == rest(b);
}

}  // namespace sim2d
