#include "sim2d/scenario/BlockShapes.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

void setDecimals(YamlNode& map, const std::string& key, const std::optional<double>& value) {
  if (value) {
    setChild(map, key, decimals(*value));
  }
}

void setNumber(YamlNode& map, const std::string& key, const std::optional<long long>& value) {
  if (value) {
    setChild(map, key, number(*value));
  }
}

void setText(YamlNode& map, const std::string& key, const std::optional<std::string>& value) {
  if (value) {
    setChild(map, key, stringNode(*value));
  }
}

void setFlag(YamlNode& map, const std::string& key, const std::optional<bool>& value) {
  if (value) {
    setChild(map, key, flag(*value));
  }
}

template <class Enum>
void setWord(YamlNode& map, const std::string& key, const std::optional<Enum>& value,
             const std::vector<std::string>& words) {
  if (value) {
    setChild(map, key, stringNode(words[static_cast<std::size_t>(*value)]));
  }
}

void setList(YamlNode& map, const std::string& key, const std::vector<double>& values) {
  if (!values.empty()) {
    setChild(map, key, decimalList(values));
  }
}

YamlNode personTree(const PersonExtension& person) {
  YamlNode tree;
  setDecimals(tree, "start_time", person.startTime);
  setWord(tree, "kind", person.kind, kindWords());
  setDecimals(tree, "mass", person.mass);
  setText(tree, "model", person.model);
  setWord(tree, "route", person.route, routeWords());
  setWord(tree, "at_end", person.atEnd, atEndWords());
  setList(tree, "wait", person.wait);
  setText(tree, "tree", person.tree);
  setUnknown(tree, person.unknown);
  return tree;
}

void setRobotGoal(YamlNode& tree, const RobotGoal& goal) {
  if (goal.point) {
    YamlNode& point = tree.child("goal");
    setChild(point, "x", decimals(goal.point->x()));
    setChild(point, "y", decimals(goal.point->y()));
  } else if (!goal.goals.empty()) {
    YamlNode list;
    list.kind = YamlNode::Kind::List;
    for (const int id : goal.goals) {
      list.items.push_back(number(id));
    }
    setChild(tree, "goals", std::move(list));
  }
}

YamlNode robotTree(const Robot& robot) {
  YamlNode tree;
  setText(tree, "type", robot.type);
  setText(tree, "planner", robot.planner);
  UnknownKeys parameters;
  for (const auto& parameter : robot.plannerParameters) {
    parameters.push_back({parameter.first, parameter.second});
  }
  if (!parameters.empty()) {
    setUnknown(tree.child("planner_parameters"), parameters);
  }
  YamlNode& start = tree.child("start");
  setChild(start, "x", decimals(robot.start.position.x()));
  setChild(start, "y", decimals(robot.start.position.y()));
  setChild(start, "h", decimals(robot.start.heading));
  setRobotGoal(tree, robot.goal);
  setDecimals(tree, "goal_radius", robot.goalRadius);
  setDecimals(tree, "start_time", robot.startTime);
  setDecimals(tree, "radius", robot.radius);
  setDecimals(tree, "mass", robot.mass);
  setDecimals(tree, "max_vel", robot.maxVel);
  setDecimals(tree, "max_acc", robot.maxAcc);
  setDecimals(tree, "max_omega", robot.maxOmega);
  setDecimals(tree, "max_alpha", robot.maxAlpha);
  setList(tree, "footprint_x", robot.footprintX);
  setList(tree, "footprint_y", robot.footprintY);
  setUnknown(tree, robot.unknown);
  return tree;
}

YamlNode metricsTree(const MetricsSettings& metrics) {
  YamlNode tree;
  setText(tree, "from", metrics.from);
  setText(tree, "until", metrics.until);
  setDecimals(tree, "frequency", metrics.frequency);
  setText(tree, "tag", metrics.tag);
  setNumber(tree, "run_id", metrics.runId);
  setText(tree, "file", metrics.file);
  for (const auto& parameter : metrics.parameters) {
    setChild(tree.child("parameters"), parameter.first, decimals(parameter.second));
  }
  setUnknown(tree, metrics.unknown);
  return tree;
}

YamlNode settingsTree(const DesktopSettings& desktop) {
  YamlNode tree;
  setChild(tree, "format", number(kBlockFormat));
  setText(tree, "map_file", desktop.mapFile);
  setText(tree, "map_rule", desktop.mapRule);
  setNumber(tree, "seed", desktop.seed);
  setDecimals(tree, "duration", desktop.duration);
  setDecimals(tree, "dt", desktop.dt);
  setNumber(tree, "record_every", desktop.recordEvery);
  setText(tree, "model", desktop.model);
  setWord(tree, "route", desktop.route, routeWords());
  setWord(tree, "obstacle_points", desktop.obstaclePoints, obstaclePointWords());
  setFlag(tree, "loop_trees", desktop.loopTrees);
  setList(tree, "wrap_x", desktop.wrapX);
  for (const auto& group : desktop.groups) {
    setChild(tree.child("groups"), std::to_string(group.first), stringNode(group.second));
  }
  return tree;
}

/// The list of names and the maps beside it, those switched off last.
template <class T, class Tree>
void setEntities(YamlNode& tree, const std::string& key, const std::vector<T>& entities,
                 Tree treeOf) {
  YamlNode names;
  names.kind = YamlNode::Kind::List;
  for (const T& entity : entities) {
    if (entity.listed) {
      names.items.push_back(stringNode(entity.name));
    }
  }
  if (!names.items.empty()) {
    setChild(tree, key, std::move(names));
  }
  for (const bool listed : {true, false}) {
    for (const T& entity : entities) {
      if (entity.listed == listed) {
        setChild(tree, entity.name, treeOf(entity));
      }
    }
  }
}

}  // namespace

YamlNode blockTree(const Scenario& given) {
  const Scenario scenario = withoutDefaults(given);
  YamlNode tree = settingsTree(scenario.desktop);
  for (const bool listed : {true, false}) {
    for (const Human& human : scenario.humans) {
      YamlNode person = personTree(human.ours);
      if (human.listed == listed && !person.isNull()) {
        setChild(tree, human.name, std::move(person));
      }
    }
  }
  setEntities(tree, "robots", scenario.robots, robotTree);
  setEntities(tree, "obstacles", scenario.obstacles, obstacleTree);
  setEntities(tree, "doors", scenario.doors, doorTree);
  setEntities(tree, "areas", scenario.areas, areaTree);
  YamlNode metrics = metricsTree(scenario.desktop.metrics);
  if (!metrics.isNull()) {
    setChild(tree, "metrics", std::move(metrics));
  }
  setUnknown(tree, scenario.desktop.unknown);
  return tree.items.size() > 1 ? tree : YamlNode();
}

}  // namespace sim2d
