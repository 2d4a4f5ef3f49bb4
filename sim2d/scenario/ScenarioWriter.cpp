#include <algorithm>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

template <class T, class Make>
YamlNode listOf(const std::vector<T>& values, Make make) {
  YamlNode list(YamlNode::Kind::List);
  std::transform(values.begin(), values.end(), std::back_inserter(list.items), make);
  return list;
}

template <class T>
YamlNode listedNames(const std::vector<T>& entities) {
  YamlNode list(YamlNode::Kind::List);
  forEachListed(entities, [&](const T& each) { list.items.push_back(stringNode(each.name)); });
  return list;
}

/// Listed objects first.
template <class T, class Visit>
void forEachListedFirst(const std::vector<T>& entities, Visit visit) {
  for (const bool listed : {true, false}) {
    for (const T& entity : entities) {
      if (entity.listed == listed) {
        visit(entity);
      }
    }
  }
}

YamlNode goalsTree(const std::vector<GlobalGoal>& goals) {
  YamlNode tree;
  for (const GlobalGoal& goal : goals) {
    YamlNode& point = tree.child(std::to_string(goal.id));
    setPoint(point, goal.position, 3);
    setUnknown(point, goal.unknown);
  }
  return tree;
}

YamlNode behaviorTree(const Behavior& behavior, const FieldTables& tables) {
  YamlNode tree;
  writeFields(tree, behavior, tables);
  if (behavior.type == BehaviorType::Scared) {  // order of HuNavSim's editor
    static const std::set<std::string> kFirst = {"type", "dist", "duration",
                                                 "once", "vel",  "other_force_factor"};
    std::stable_partition(tree.items.begin(), tree.items.end(),
                          [](const YamlNode& item) { return kFirst.count(item.key) != 0; });
  }
  setUnknown(tree, behavior.unknown);
  return tree;
}

/// Keys before `behavior`, common to all dialects.
YamlNode bodyTree(const Human& human, const FieldTables& tables) {
  YamlNode tree(YamlNode::Kind::Map);
  writeFields(tree, human, tables);
  if (human.hasInitPose) {
    YamlNode& pose = tree.child("init_pose");
    setPoint(pose, human.initPose.position, 3);
    if (human.initZ) {
      setChild(pose, "z", decimals(*human.initZ, 3));
    }
    setChild(pose, "h", decimals(human.initPose.heading, 3));
    setUnknown(pose, human.initPoseUnknown);
  }
  return tree;
}

YamlNode humanTree(const Human& human, const FieldTables& tables) {
  YamlNode tree = bodyTree(human, tables);
  YamlNode behavior = behaviorTree(human.behavior, tables);
  if (!behavior.isNull()) {
    setChild(tree, "behavior", std::move(behavior));
  }
  if (!human.goals.empty()) {
    setChild(tree, "goals", integerList(human.goals));
  }
  setUnknown(tree, human.unknown);
  return tree;
}

void addLoss(base::Diagnostics& losses, const Human& human, const std::string& message) {
  losses.push_back({base::Severity::Warning, {}, 0, 0, human.name + ": " + message, human.key});
}

/// Writes `dist` as dialect B defines it, and reports what is lost.
void setOldDistance(YamlNode& tree, const Human& human, base::Diagnostics& losses) {
  const Behavior& behavior = human.behavior;
  const bool isCurious = behavior.type == BehaviorType::Curious;
  const bool isScared = behavior.type == BehaviorType::Scared;
  if (isCurious || behavior.type == BehaviorType::Threatening) {
    const double noticed = behavior.dist.value_or(5.0);
    const double fixed = isCurious ? 10.0 : 4.5;
    const auto& kept = isCurious ? behavior.stopDist : behavior.frontDist;
    setChild(tree, "dist", decimals(kept.value_or(1.5)));
    if (noticed != fixed) {
      addLoss(losses, human,
              "dist " + base::formatDouble(noticed) +
                  " is lost: in this format the robot is noticed at " + base::formatDouble(fixed) +
                  " m");
    }
    return;
  }
  const bool notices = isScared || behavior.type == BehaviorType::Surprised;
  setChild(tree, "dist", decimals(behavior.dist.value_or(notices ? 5.0 : 0.0)));
  if (isScared && behavior.safeDistance.value_or(5.0) != 5.0) {
    addLoss(losses, human,
            "safe_distance " + base::formatDouble(*behavior.safeDistance) +
                " is lost: this format has none");
  }
}

/// Dialect B has type numbers: an unknown number is kept, a name cannot be.
long long oldTypeOf(const Human& human, base::Diagnostics& losses) {
  const Behavior& behavior = human.behavior;
  const auto type = static_cast<long long>(behavior.type.value_or(BehaviorType::Regular));
  if (behavior.unknownType.empty()) {
    return type;
  }
  const std::optional<long long> foreign = base::parseInt(behavior.unknownType);
  if (!foreign) {
    addLoss(losses, human, "behavior '" + behavior.unknownType + "' is lost: Regular is written");
  }
  return foreign.value_or(type);
}

/// With 0 HuNavSim 1.5 replaces the values of a reaction by its own; with 1 it uses the given ones,
/// which are the same here.
Configuration oldConfigurationOf(const Behavior& behavior) {
  const Configuration mode = behavior.configuration.value_or(Configuration::Default);
  return mode == Configuration::Default ? Configuration::Custom : mode;
}

/// Heading of a goal from an older file [rad].
double headingOf(const GlobalGoal& goal) {
  for (const UnknownKey& key : goal.unknown) {
    if (key.key == "h") {
      return base::parseDouble(base::trimmed(key.yaml)).value_or(0.0);
    }
  }
  return 0.0;
}

constexpr double kFastestReaction = 1.8;  // [m/s], limit of HuNavSim's loader

YamlNode behaviorTreeB(const Human& human, base::Diagnostics& losses) {
  const Behavior& behavior = human.behavior;
  YamlNode tree;
  setChild(tree, "type", number(oldTypeOf(human, losses)));
  setChild(tree, "configuration", number(static_cast<int>(oldConfigurationOf(behavior))));
  setChild(tree, "duration", decimals(behavior.duration.value_or(40.0)));
  setChild(tree, "once", flag(behavior.once.value_or(false)));
  const double walks = std::min(human.maxVel.value_or(1.0), kFastestReaction);
  setChild(tree, "vel", decimals(behavior.vel.value_or(walks)));
  setOldDistance(tree, human, losses);
  setChild(tree, "goal_force_factor", decimals(behavior.goalForceFactor.value_or(2.0)));
  setChild(tree, "obstacle_force_factor", decimals(behavior.obstacleForceFactor.value_or(10.0)));
  setChild(tree, "social_force_factor", decimals(behavior.socialForceFactor.value_or(5.0)));
  setChild(tree, "other_force_factor", decimals(behavior.otherForceFactor.value_or(20.0)));
  setUnknown(tree, behavior.unknown);
  return tree;
}

YamlNode humanTreeB(const Scenario& scenario, const Human& human, base::Diagnostics& losses) {
  YamlNode tree = bodyTree(human, fieldTables());
  setChild(tree, "behavior", behaviorTreeB(human, losses));
  tree.child("goals").kind = YamlNode::Kind::List;
  std::set<std::string> taken;
  for (const UnknownKey& key : human.unknown) {
    taken.insert(key.key);
  }
  int count = 0;
  for (const int id : human.goals) {
    const GlobalGoal* goal = scenario.goal(id);
    if (goal == nullptr) {
      addLoss(losses, human, "goal " + std::to_string(id) + " is not defined and is not written");
      continue;
    }
    std::string name;
    do {
      name = "g" + std::to_string(count++);
    } while (taken.count(name) != 0);
    tree.child("goals").items.push_back(stringNode(name));
    YamlNode& place = tree.child(name);
    setPoint(place, goal->position, 3);
    setChild(place, "h", decimals(headingOf(*goal), 3));
  }
  setUnknown(tree, human.unknown);
  return tree;
}

/// Completes the loader's map: the list, each agent by `make`, then unknown keys.
template <class Make>
void setPeople(YamlNode& tree, const Scenario& scenario, Make make) {
  setChild(tree, "agents", listedNames(scenario.humans));
  forEachListedFirst(scenario.humans,
                     [&](const Human& human) { setChild(tree, human.name, make(human)); });
  setUnknown(tree, scenario.unknown);
}

/// Null if only the format would be written.
YamlNode desktopTree(const Scenario& given, const FieldTables& tables) {
  const Scenario scenario = withoutDefaults(given, tables);
  YamlNode tree;
  setChild(tree, "format", number(kDesktopFormat));
  writeFields(tree, scenario.desktop, tables);
  forEachListedFirst(scenario.humans, [&](const Human& human) {
    YamlNode person = objectTree(human.ours, tables);
    if (!person.isNull()) {
      setChild(tree, human.name, std::move(person));
    }
  });
  forEachEntityList(scenario, [&](const char* key, base::EntityKind /*kind*/, const auto& list) {
    YamlNode names = listedNames(list);
    if (!names.items.empty()) {
      setChild(tree, key, std::move(names));
    }
    forEachListedFirst(
        list, [&](const auto& each) { setChild(tree, each.name, objectTree(each, tables)); });
  });
  YamlNode metrics = objectTree(scenario.desktop.metrics, tables);
  if (!metrics.isNull()) {
    setChild(tree, "metrics", std::move(metrics));
  }
  setUnknown(tree, scenario.desktop.unknown);
  return tree.items.size() > 1 ? tree : YamlNode();
}

/// `loader`: content of its ros__parameters.
YamlNode fileOf(YamlNode loader, const Scenario& scenario, const FieldTables& tables) {
  YamlNode tree;
  setChild(tree.child(kLoaderNode), kParameters, std::move(loader));
  YamlNode block = desktopTree(scenario, tables);
  if (!block.isNull()) {
    setChild(tree.child(kDesktopNode), kParameters, std::move(block));
  }
  setUnknown(tree, scenario.otherNodes);
  return tree;
}

std::string fileText(const YamlNode& tree) {
  return emitYaml(tree) + (tree.find(kDesktopNode) != nullptr ? "\n" : "");
}

}  // namespace

YamlNode decimals(double value, int digits) {
  return scalarNode(base::formatDecimals(value, digits));
}

YamlNode number(long long value) {
  return scalarNode(std::to_string(value));
}

YamlNode flag(bool value) {
  return scalarNode(value ? "true" : "false");
}

YamlNode decimalList(const std::vector<double>& values) {
  return listOf(values, [](double value) { return decimals(value); });
}

YamlNode integerList(const std::vector<int>& values) {
  return listOf(values, number);
}

void setPoint(YamlNode& map, const Vec2& point, int digits) {
  setChild(map, "x", decimals(point.x(), digits));
  setChild(map, "y", decimals(point.y(), digits));
}

void setChild(YamlNode& map, const std::string& key, YamlNode value) {
  value.key = key;
  map.child(key) = std::move(value);
}

void setUnknown(YamlNode& map, const UnknownKeys& unknown) {
  for (const UnknownKey& key : unknown) {
    base::Diagnostics problems;
    YamlNode value = parseYaml(key.yaml, {}, problems);
    if (base::hasErrors(problems)) {
      value = stringNode(key.yaml);  // the editor accepts any text
    }
    setChild(map, key.key, std::move(value));
  }
}

Scenario withoutDefaults(Scenario scenario, const FieldTables& tables) {
  const DesktopSettings desktop = scenario.desktop;
  for (Human& human : scenario.humans) {
    dropDefaults(human.ours, desktop, tables);
  }
  forEachEntityList(scenario, [&](const char* /*key*/, base::EntityKind /*kind*/, auto& list) {
    for (auto& each : list) {
      dropDefaults(each, desktop, tables);
      if constexpr (std::is_same_v<std::decay_t<decltype(each)>, Robot>) {
        dropDefaults(each.lidar, desktop, tables);
        dropDefaults(each.detector, desktop, tables);
        dropDefaults(each.odometryNoise, desktop, tables);
        dropDefaults(each.localization, desktop, tables);
        dropDefaults(each.battery, desktop, tables);
      }
    }
  });
  dropDefaults(scenario.desktop, desktop, tables);
  dropDefaults(scenario.desktop.variation, desktop, tables);
  dropDefaults(scenario.desktop.metrics, desktop, tables);
  return scenario;
}

YamlNode fileTree(const Scenario& scenario, const FieldTables& tables) {
  YamlNode loader;
  writeFields<ScenarioSettings>(loader, scenario, tables);
  if (!scenario.goals.empty()) {
    setChild(loader, "global_goals", goalsTree(scenario.goals));
  }
  setPeople(loader, scenario, [&](const Human& human) { return humanTree(human, tables); });
  return fileOf(std::move(loader), scenario, tables);
}

std::string writeScenario(const Scenario& scenario) {
  return fileText(fileTree(scenario));
}

std::vector<GlobalGoal> unusedGoals(const Scenario& scenario) {
  std::set<int> ofPeople;
  for (const Human& human : scenario.humans) {
    ofPeople.insert(human.goals.begin(), human.goals.end());
  }
  std::vector<GlobalGoal> goals;
  std::copy_if(scenario.goals.begin(), scenario.goals.end(), std::back_inserter(goals),
               [&](const GlobalGoal& goal) { return ofPeople.count(goal.id) == 0; });
  return goals;
}

std::string writeScenarioB(const Scenario& scenario, base::Diagnostics& losses) {
  YamlNode loader;
  for (const char* key : {"map", "publish_people"}) {
    const Field<ScenarioSettings>& field = *fieldOf<ScenarioSettings>(key);
    writeValue(loader, field.spec, field.value(scenario), field.digits);
  }
  if (const std::vector<GlobalGoal> goals = unusedGoals(scenario); !goals.empty()) {
    setChild(loader, "global_goals", goalsTree(goals));
  }
  setPeople(loader, scenario,
            [&](const Human& human) { return humanTreeB(scenario, human, losses); });
  return fileText(fileOf(std::move(loader), scenario, fieldTables()));
}

}  // namespace sim2d
