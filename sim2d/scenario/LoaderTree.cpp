#include <algorithm>
#include <set>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

YamlNode goalsTree(const std::vector<GlobalGoal>& goals) {
  YamlNode tree;
  for (const GlobalGoal& goal : goals) {
    YamlNode& point = tree.child(std::to_string(goal.id));
    setChild(point, "x", decimals(goal.position.x(), 3));
    setChild(point, "y", decimals(goal.position.y(), 3));
    setUnknown(point, goal.unknown);
  }
  return tree;
}

YamlNode behaviorTree(const Behavior& behavior, const FieldTables& tables) {
  YamlNode tree;
  writeFields(tree, behavior, tables);
  if (behavior.type == BehaviorType::Scared) {  // as HuNavSim's editor writes them
    static const std::set<std::string> kFirst = {"type", "dist", "duration",
                                                 "once", "vel",  "other_force_factor"};
    std::stable_partition(tree.items.begin(), tree.items.end(),
                          [](const YamlNode& item) { return kFirst.count(item.key) != 0; });
  }
  setUnknown(tree, behavior.unknown);
  return tree;
}

/// Keys before `behavior`; every dialect has them.
YamlNode bodyTree(const Human& human, const FieldTables& tables) {
  YamlNode tree;
  tree.kind = YamlNode::Kind::Map;
  writeFields(tree, human, tables);
  if (human.hasInitPose) {
    YamlNode& pose = tree.child("init_pose");
    setChild(pose, "x", decimals(human.initPose.position.x(), 3));
    setChild(pose, "y", decimals(human.initPose.position.y(), 3));
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

YamlNode agentList(const Scenario& scenario) {
  YamlNode list;
  list.kind = YamlNode::Kind::List;
  for (const Human& human : scenario.humans) {
    if (human.listed) {
      list.items.push_back(stringNode(human.name));
    }
  }
  return list;
}

/// What was the parameter `dist` in dialect B, and what gets lost.
void setOldDistance(YamlNode& tree, const Human& human, base::Diagnostics& losses) {
  const Behavior& behavior = human.behavior;
  const auto lost = [&](const std::string& message) {
    losses.push_back({base::Severity::Warning, {}, 0, 0, human.name + ": " + message, human.key});
  };
  const double noticed = behavior.dist.value_or(5.0);
  if (behavior.type == BehaviorType::Curious || behavior.type == BehaviorType::Threatening) {
    const bool curious = behavior.type == BehaviorType::Curious;
    const double fixed = curious ? 10.0 : 4.5;
    setChild(tree, "dist",
             decimals((curious ? behavior.stopDist : behavior.frontDist).value_or(1.5)));
    if (noticed != fixed) {
      lost("dist " + base::formatDouble(noticed) + " is lost, this format notices the robot at " +
           base::formatDouble(fixed) + " m");
    }
    return;
  }
  const bool reacts =
      behavior.type == BehaviorType::Surprised || behavior.type == BehaviorType::Scared;
  setChild(tree, "dist", decimals(behavior.dist.value_or(reacts ? 5.0 : 0.0)));
  if (behavior.type == BehaviorType::Scared && behavior.safeDistance.value_or(5.0) != 5.0) {
    lost("safe_distance " + base::formatDouble(*behavior.safeDistance) +
         " is lost, this format has none");
  }
}

YamlNode behaviorTreeB(const Human& human, base::Diagnostics& losses) {
  const Behavior& behavior = human.behavior;
  const BehaviorType type = behavior.type.value_or(BehaviorType::Regular);
  YamlNode tree;
  setChild(tree, "type",
           behavior.foreignType.empty() ? number(static_cast<int>(type))
                                        : stringNode(behavior.foreignType));
  setChild(tree, "configuration",
           number(static_cast<int>(behavior.configuration.value_or(Configuration::Default))));
  setChild(tree, "duration", decimals(behavior.duration.value_or(40.0)));
  setChild(tree, "once", flag(behavior.once.value_or(false)));
  setChild(tree, "vel", decimals(behavior.vel ? *behavior.vel : human.maxVel.value_or(1.0)));
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
  YamlNode& names = tree.child("goals");
  names.kind = YamlNode::Kind::List;
  YamlNode places;
  int count = 0;
  for (const int id : human.goals) {
    const GlobalGoal* goal = scenario.goal(id);
    if (goal == nullptr) {
      losses.push_back({base::Severity::Warning,
                        {},
                        0,
                        0,
                        human.name + ": goal " + std::to_string(id) + " is not defined, left out",
                        human.key});
      continue;
    }
    const std::string name = "g" + std::to_string(count++);
    names.items.push_back(stringNode(name));
    YamlNode& place = places.child(name);
    setChild(place, "x", decimals(goal->position.x(), 3));
    setChild(place, "y", decimals(goal->position.y(), 3));
    setChild(place, "h", decimals(0.0, 1));
  }
  for (YamlNode& place : places.items) {
    const std::string name = place.key;
    setChild(tree, name, std::move(place));
  }
  setUnknown(tree, human.unknown);
  return tree;
}

YamlNode oneNode(YamlNode parameters) {
  YamlNode node;
  setChild(node, kParameters, std::move(parameters));
  return node;
}

std::string fileText(const YamlNode& tree) {
  const bool hasBlock = tree.find(kBlockNode) != nullptr;
  return emitYaml(tree) + (hasBlock ? "\n" : "");
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
  YamlNode list;
  list.kind = YamlNode::Kind::List;
  for (const double value : values) {
    list.items.push_back(decimals(value));
  }
  return list;
}

YamlNode integerList(const std::vector<int>& values) {
  YamlNode list;
  list.kind = YamlNode::Kind::List;
  for (const int value : values) {
    list.items.push_back(number(value));
  }
  return list;
}

void setPoint(YamlNode& map, const Vec2& point) {
  setChild(map, "x", decimals(point.x()));
  setChild(map, "y", decimals(point.y()));
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
      value = stringNode(key.yaml);  // an editor may have put any text there
    }
    setChild(map, key.key, std::move(value));
  }
}

YamlNode loaderTree(const Scenario& scenario, const FieldTables& tables) {
  YamlNode tree;
  writeFields<Environment>(tree, scenario, tables);
  if (!scenario.goals.empty()) {
    setChild(tree, "global_goals", goalsTree(scenario.goals));
  }
  setChild(tree, "agents", agentList(scenario));
  for (const bool listed : {true, false}) {
    for (const Human& human : scenario.humans) {
      if (human.listed == listed) {
        setChild(tree, human.name, humanTree(human, tables));
      }
    }
  }
  setUnknown(tree, scenario.unknown);
  return tree;
}

YamlNode fileTree(const Scenario& scenario, const FieldTables& tables) {
  YamlNode tree;
  setChild(tree, kLoaderNode, oneNode(loaderTree(scenario, tables)));
  YamlNode block = blockTree(scenario, tables);
  if (!block.isNull()) {
    setChild(tree, kBlockNode, oneNode(std::move(block)));
  }
  setUnknown(tree, scenario.otherNodes);
  return tree;
}

std::string writeScenario(const Scenario& scenario) {
  return fileText(fileTree(scenario));
}

std::string writeScenarioB(const Scenario& scenario, base::Diagnostics& losses) {
  YamlNode parameters;
  for (const char* key : {"map", "publish_people"}) {
    const Field<Environment>& field = *fieldOf<Environment>(key);
    writeValue(parameters, field.spec, field.value(scenario), field.digits);
  }
  setChild(parameters, "agents", agentList(scenario));
  for (const bool listed : {true, false}) {
    for (const Human& human : scenario.humans) {
      if (human.listed == listed) {
        setChild(parameters, human.name, humanTreeB(scenario, human, losses));
      }
    }
  }
  setUnknown(parameters, scenario.unknown);
  YamlNode tree;
  setChild(tree, kLoaderNode, oneNode(std::move(parameters)));
  YamlNode block = blockTree(scenario);
  if (!block.isNull()) {
    setChild(tree, kBlockNode, oneNode(std::move(block)));
  }
  setUnknown(tree, scenario.otherNodes);
  return fileText(tree);
}

}  // namespace sim2d
