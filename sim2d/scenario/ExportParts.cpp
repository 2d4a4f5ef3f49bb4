#include "sim2d/scenario/ExportParts.h"

#include <algorithm>

#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/Defaults.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace sim2d {

namespace {

constexpr const char* kIsaacPlane = "empty_world";

template <class T>
void setDefault(std::optional<T>& value, T otherwise) {
  if (!value) {
    value = otherwise;
  }
}

template <class T>
std::string namesOf(const std::vector<T>& list) {
  constexpr int kMostNamed = 4;
  std::string names;
  int count = 0;
  for (const T& value : list) {
    if (value.listed && ++count <= kMostNamed) {
      names += (names.empty() ? "" : ", ") + value.name;
    }
  }
  return count > kMostNamed ? names + " and " + std::to_string(count - kMostNamed) + " more"
                            : names;
}

void lose(base::Diagnostics& report, const std::string& what, const std::string& names) {
  if (!names.empty()) {
    report.push_back(base::warning("export.stays-here", {what, names}));
  }
}

/// The keys of one person that no other program reads.
std::string ownKeysOf(const Human& human) {
  const PersonExtension& ours = human.ours;
  std::string keys;
  const auto add = [&keys](bool isSet, const char* key) {
    if (isSet) {
      keys += (keys.empty() ? "" : ", ") + std::string(key);
    }
  };
  add(ours.startTime.value_or(0.0) > 0.0, "start_time");
  add(ours.kind.value_or(PersonKind::Adult) != PersonKind::Adult, "kind");
  add(ours.mass.has_value(), "mass");
  add(ours.model.has_value(), "model");
  add(ours.route.has_value(), "route");
  add(ours.atEnd.value_or(AtEnd::Stop) != AtEnd::Stop, "at_end");
  add(!ours.wait.empty(), "wait");
  return keys;
}

base::Diagnostic about(const Human& human, base::Diagnostic said) {
  said.entity = human.key;
  return base::within(human.name, std::move(said));
}

void checkFactor(const Human& human, const char* key, double value, double low, double high,
                 base::Diagnostics& report) {
  if (value < low || value > high) {
    report.push_back(
        about(human, base::warning("export.factor-out-of-range", {key, value, low, high})));
  }
}

void completeBehavior(Human& human, const ResolvedHuman& counts, bool allKeys) {
  Behavior& behavior = human.behavior;
  setDefault(behavior.type, BehaviorType::Regular);
  setDefault(behavior.configuration, Configuration::Default);
  setDefault(behavior.goalForceFactor, counts.goalFactor);
  setDefault(behavior.obstacleForceFactor, counts.obstacleFactor);
  setDefault(behavior.socialForceFactor, counts.socialFactor);
  setDefault(behavior.otherForceFactor, counts.otherFactor);
  if (allKeys) {
    setDefault(behavior.dist, counts.noticeDistance);
    setDefault(behavior.duration, counts.reactionDuration);
    setDefault(behavior.once, counts.reactionOnce);
    setDefault(behavior.vel, counts.reactionSpeed);
  }
}

/// As one word of a shell's command.
std::string shellWord(const std::string& text) {
  static constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./:=-+,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) {
    return text;
  }
  std::string quoted = "'";
  for (const char c : text) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace

void addExportLosses(const Scenario& scenario, base::Diagnostics& report) {
  lose(report, "the robot", namesOf(scenario.robots));
  lose(report, "what was drawn as obstacle", namesOf(scenario.obstacles));
  lose(report, "the door", namesOf(scenario.doors));
  lose(report, "the area", namesOf(scenario.areas));
  for (const Human& human : scenario.humans) {
    const std::string keys = ownKeysOf(human);
    if (human.listed && !keys.empty()) {
      report.push_back(about(human, base::warning("export.keys-unknown", {keys})));
    }
  }
  const DesktopSettings& desktop = scenario.desktop;
  if (!desktop.wrapX.empty()) {
    report.push_back(base::warning("export.no-ring"));
  }
  if (desktop.model && *desktop.model != "sfm" && *desktop.model != "sfm-hunav2") {
    report.push_back(base::warning("export.own-forces", {*desktop.model}));
  }
}

void completeExported(const Scenario& scenario, Human& human, const TargetInfo& target,
                      base::Diagnostics& report) {
  const ResolvedHuman counts = resolveHuman(scenario, human, scenario.desktop.seed.value_or(1));
  setDefault(human.groupId, -1);
  setDefault(human.maxVel, counts.desiredSpeed);
  setDefault(human.radius, counts.radius);
  setDefault(human.goalRadius, counts.goalRadius);
  setDefault(human.cyclicGoals, counts.cyclicGoals);
  setDefault(human.skin, 0);
  human.hasInitPose = true;
  human.initZ = target.startHeight;
  const int largest = largestSkin(target.simulator);
  if (*human.skin < 0 || *human.skin > largest) {
    const int skin = std::max(0, *human.skin) % (largest + 1);
    report.push_back(about(human, base::problem(base::Severity::Info, "export.skin-changed",
                                                {*human.skin, skin, target.title, largest})));
    human.skin = skin;
  }
  const BehaviorType type = human.behavior.type.value_or(BehaviorType::Regular);
  const bool reacts = type != BehaviorType::Regular && type != BehaviorType::Impassive;
  completeBehavior(human, counts, reacts);
  const bool ownFactors = human.behavior.configuration == Configuration::Custom;
  if (target.target == ExportTarget::Isaac && ownFactors) {
    checkFactor(human, "goal_force_factor", *human.behavior.goalForceFactor, 5.0, 10.0, report);
    checkFactor(human, "obstacle_force_factor", *human.behavior.obstacleForceFactor, 0.5, 5.0,
                report);
    checkFactor(human, "social_force_factor", *human.behavior.socialForceFactor, 5.0, 20.0, report);
  }
}

std::string exportStartCommand(const Scenario& scenario, const TargetInfo& target) {
  const std::string map = mapBaseName(scenario.map.value_or(""));
  const std::string file = scenario.yamlBaseName.value_or("") + ".yaml";
  const std::string world =  // without: its usual one
      map.empty() ? "" : " " + shellWord("environment_name:=" + map);
  const std::string configuration = " " + shellWord("configuration_file:=" + file);
  switch (target.target) {
    case ExportTarget::GazeboClassic:
      return "ros2 launch hunav_gazebo_wrapper simulation.launch.py" + world + configuration;
    case ExportTarget::GazeboFortress:
      return "ros2 launch hunav_gazebo_fortress_wrapper cafe_fortress_test.launch.py" +
             configuration;
    case ExportTarget::Isaac:
      return "ros2 run hunav_isaac_wrapper hunav_isaac_launcher --config " + shellWord(file) +
             " --world " + shellWord(map.empty() ? kIsaacPlane : map) + " --batch";
    case ExportTarget::Webots:
      return "ros2 launch hunav_webots_wrapper hunavsim_webots.launch.py" + world + configuration;
    case ExportTarget::Native:
      break;
  }
  return {};
}

base::Diagnostic worldOfMap(const std::string& map, const TargetInfo& target) {
  if (target.target == ExportTarget::GazeboFortress) {
    return base::warning("export.fixed-world", {target.title, target.worlds.front(), map});
  }
  return base::warning("export.world-needed",
                       {map, target.package, base::join(target.worlds, ", ")});
}

base::Diagnostic worldWithoutMap(const TargetInfo& target) {
  if (target.target == ExportTarget::Isaac) {
    return base::warning("export.no-map", {target.title, kIsaacPlane});
  }
  const std::vector<std::string>& worlds = target.worlds;
  return worlds.size() == 1
             ? base::warning("export.no-map", {target.title, worlds.front()})
             : base::warning("export.no-map-other-worlds",
                             {target.title, worlds.front(), worlds[1], base::join(worlds, ", ")});
}

}  // namespace sim2d
