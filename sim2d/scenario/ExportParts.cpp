#include "sim2d/scenario/ExportParts.h"

#include <algorithm>

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
    report.push_back(base::makeWarning(what + " (" + names +
                                       ") stays in our own block, which is not read there"));
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

void checkFactor(const Human& human, const char* key, double value, double low, double high,
                 base::Diagnostics& report) {
  if (value < low || value > high) {
    base::Diagnostic found =
        base::makeWarning(human.name + ": " + key + " " + base::formatDouble(value) +
                          " is outside the range that is "
                          "sensible in Isaac Sim (" +
                          base::formatDouble(low) + " to " + base::formatDouble(high) + ")");
    found.entity = human.key;
    report.push_back(std::move(found));
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
      base::Diagnostic found = base::makeWarning(human.name + ": " + keys + " is not known there");
      found.entity = human.key;
      report.push_back(std::move(found));
    }
  }
  const DesktopSettings& desktop = scenario.desktop;
  if (!desktop.wrapX.empty()) {
    report.push_back(base::makeWarning("the periodic corridor (wrap_x) is not known there"));
  }
  if (desktop.model && *desktop.model != "sfm" && *desktop.model != "sfm-hunav2") {
    report.push_back(
        base::makeWarning("people walk by HuNavSim's own forces there, not by " + *desktop.model));
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
    report.push_back({base::Severity::Info,
                      {},
                      0,
                      0,
                      human.name + ": skin " + std::to_string(*human.skin) + " becomes " +
                          std::to_string(skin) + ", " + target.title + " has 0 to " +
                          std::to_string(largest),
                      human.key});
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

std::string worldOfMap(const std::string& map, const TargetInfo& target) {
  if (target.target == ExportTarget::GazeboFortress) {
    return std::string(target.title) + " starts its world '" + target.worlds.front() +
           "' whatever the map is, here '" + map + "'";
  }
  return "the 3-D world '" + map + "' must be there in " + target.package +
         " (it has: " + base::join(target.worlds, ", ") + ")";
}

std::string worldWithoutMap(const TargetInfo& target) {
  if (target.target == ExportTarget::Isaac) {
    return std::string("the scenario names no map: ") + target.title + " starts its world '" +
           kIsaacPlane + "'";
  }
  const std::string usual = "the scenario names no map: " + target.title + " starts its world '" +
                            target.worlds.front() + "'";
  const std::vector<std::string> others(target.worlds.begin() + 1, target.worlds.end());
  return others.empty() ? usual
                        : usual + " (environment_name:=" + others.front() +
                              " takes another; it has " + base::join(target.worlds, ", ") + ")";
}

}  // namespace sim2d
