#include <algorithm>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/BlockShapes.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

constexpr long long kLargestInt = 2147483647;

template <class Enum>
std::optional<Enum> choiceOf(YamlMap& view, const std::string& key,
                             const std::vector<std::string>& words) {
  const auto index = view.choice(key, words);
  return index ? std::optional<Enum>(static_cast<Enum>(*index)) : std::nullopt;
}

void readPerson(YamlMap view, Human& human) {
  PersonExtension& to = human.ours;
  to.startTime = view.number("start_time", kNotNegative);
  to.kind = choiceOf<PersonKind>(view, "kind", kindWords());
  to.mass = view.number("mass", kPositive);
  to.model = view.text("model");
  to.route = choiceOf<Route>(view, "route", routeWords());
  to.atEnd = choiceOf<AtEnd>(view, "at_end", atEndWords());
  to.wait = view.numbers("wait", kNotNegative);
  to.tree = view.text("tree");
  to.unknown = view.takeUnknown();
}

void readRobotGoal(YamlMap& view, Robot& robot) {
  const bool both = view.node().find("goal") != nullptr && view.node().find("goals") != nullptr;
  if (both) {
    view.error("goals", "a robot has either 'goal' or 'goals'");
  }
  if (view.find("goal") != nullptr) {
    YamlMap point = view.map("goal");
    robot.goal.point = readPoint(point);
    refuseUnknown(point);
  }
  robot.goal.goals = view.integers("goals");
  if (both) {
    robot.goal.goals.clear();
  }
}

void readFootprint(YamlMap& view, Robot& robot) {
  robot.footprintX = view.numbers("footprint_x");
  robot.footprintY = view.numbers("footprint_y");
  if (robot.footprintX.size() != robot.footprintY.size()) {
    view.error("footprint_y", "must have as many numbers as footprint_x");
  } else if (!robot.footprintX.empty() && robot.footprintX.size() < 3) {
    view.error("footprint_x", "a footprint needs at least 3 corners");
  }
}

void readPlannerParameters(YamlMap& view, Robot& robot) {
  YamlMap parameters = view.map("planner_parameters");
  for (const YamlNode& item : parameters.node().items) {
    parameters.know(item.key);
    if (item.isScalar()) {
      robot.plannerParameters.emplace_back(item.key, emitYaml(item));
    } else {
      parameters.error(item.key, "must be one value");
    }
  }
}

Robot readRobot(YamlMap view) {
  Robot robot;
  robot.type = view.text("type");
  robot.planner = view.text("planner");
  readPlannerParameters(view, robot);
  if (view.find("start") == nullptr) {
    view.error("start", "is missing");
  } else {
    YamlMap start = view.map("start");
    robot.start.position = readPoint(start);
    robot.start.heading = start.number("h").value_or(0.0);
    refuseUnknown(start);
  }
  readRobotGoal(view, robot);
  robot.goalRadius = view.number("goal_radius", kPositive);
  robot.startTime = view.number("start_time", kNotNegative);
  robot.radius = view.number("radius", {0.0, 100.0, true});
  robot.mass = view.number("mass", kPositive);
  robot.maxVel = view.number("max_vel", {0.0, 100.0, true});
  robot.maxAcc = view.number("max_acc", kPositive);
  robot.maxOmega = view.number("max_omega", kPositive);
  robot.maxAlpha = view.number("max_alpha", kPositive);
  readFootprint(view, robot);
  robot.unknown = view.takeUnknown();
  return robot;
}

/// "goal", "time 5.0", "event contact": one of `words`, or one of these two with its argument.
std::optional<std::string> readMoment(YamlMap& view, const std::string& key,
                                      const std::vector<std::string>& words) {
  const auto written = view.text(key);
  if (!written) {
    return std::nullopt;
  }
  const std::string text = base::trimmed(*written);
  const std::size_t space = text.find(' ');
  const std::string argument =
      space == std::string::npos ? std::string() : base::trimmed(text.substr(space + 1));
  const std::string first = text.substr(0, space);
  const bool simple =
      argument.empty() && std::find(words.begin(), words.end(), first) != words.end();
  const double time = base::parseDouble(argument).value_or(-1.0);
  const bool timed = first == "time" && time >= 0.0 && time < 1e9;
  const bool event = first == "event" && !argument.empty();
  if (simple || event || timed) {
    return text;
  }
  std::string all;
  for (const std::string& word : words) {
    all += word + ", ";
  }
  view.error(key, "'" + *written + "' is unknown (one of " + all + "time T, event KIND)");
  return std::nullopt;
}

void readMetrics(YamlMap view, MetricsSettings& to) {
  to.from = readMoment(view, "from", {"begin", "goal", "motion"});
  to.until = readMoment(view, "until", {"end", "arrival"});
  to.frequency = view.number("frequency", kNotNegative);
  to.tag = view.text("tag");
  to.runId = view.integer("run_id", -kLargestInt, kLargestInt);
  to.file = view.text("file");
  YamlMap parameters = view.map("parameters");
  for (const YamlNode& item : parameters.node().items) {
    if (const auto value = parameters.number(item.key)) {
      to.parameters.emplace_back(item.key, *value);
    }
  }
  to.unknown = view.takeUnknown();
}

/// Reads the whole block. Entities are maps beside the keys, so those come first.
class BlockReader {
 public:
  BlockReader(const YamlNode& parameters, LoaderReading& reading)
      : reading_(reading),
        scenario_(reading.scenario),
        view_(&parameters, "", {base::EntityKind::Scenario, 0}, reading.report) {}

  void read() {
    readFormat();
    readSettings();
    const std::vector<std::string> robots = view_.names("robots");
    const std::vector<std::string> obstacles = view_.names("obstacles");
    const std::vector<std::string> doors = view_.names("doors");
    const std::vector<std::string> areas = view_.names("areas");
    readPeople();
    listed("robots", robots, base::EntityKind::Robot);
    listed("obstacles", obstacles, base::EntityKind::Obstacle);
    listed("doors", doors, base::EntityKind::Door);
    listed("areas", areas, base::EntityKind::Area);
    readUnlisted();
    scenario_.desktop.unknown = view_.takeUnknown();
  }

 private:
  void readFormat() {
    const auto format = view_.bigInteger("format", 1);
    if (view_.node().find("format") == nullptr) {
      view_.error("format", std::string("is missing in ") + kBlockNode);
    } else if (format && *format > kBlockFormat) {
      view_.error("format", std::to_string(*format) +
                                " is newer than this program (it knows format " +
                                std::to_string(kBlockFormat) + ")");
    }
  }

  void readSettings() {
    DesktopSettings& to = scenario_.desktop;
    to.mapFile = view_.text("map_file");
    if (const auto rule = view_.choice("map_rule", mapRuleWords())) {
      to.mapRule = mapRuleWords()[static_cast<std::size_t>(*rule)];
    }
    to.seed = view_.bigInteger("seed", 0);
    to.duration = view_.number("duration", {0.0, 1e6, true});
    to.dt = view_.number("dt", {0.001, 0.1});
    to.recordEvery = view_.integer("record_every", 1, kLargestInt);
    to.model = view_.text("model");
    to.route = choiceOf<Route>(view_, "route", routeWords());
    to.obstaclePoints = choiceOf<ObstaclePoints>(view_, "obstacle_points", obstaclePointWords());
    to.loopTrees = view_.boolean("loop_trees");
    to.wrapX = view_.numbers("wrap_x");
    if (!to.wrapX.empty() && (to.wrapX.size() != 2 || to.wrapX[0] >= to.wrapX[1])) {
      view_.error("wrap_x", "needs two numbers, the smaller one first");
      to.wrapX.clear();
    }
    readGroups();
    readMetrics(view_.map("metrics"), to.metrics);
  }

  void readGroups() {
    YamlMap groups = view_.map("groups");
    std::set<long long> ids;  // 3 and 03 are one group
    for (const YamlNode& item : groups.node().items) {
      const auto id = base::parseInt(item.key);
      const auto name = groups.text(item.key);
      if (!id || *id < 0 || *id > kLargestInt) {
        groups.error(item.key, "a group needs a number as its key");
      } else if (!ids.insert(*id).second) {
        groups.error(item.key, "group " + std::to_string(*id) + " is named twice");
      } else if (name) {
        scenario_.desktop.groups.emplace_back(static_cast<int>(*id), *name);
      }
    }
  }

  void readPeople() {
    for (Human& human : scenario_.humans) {
      const YamlNode* node = view_.node().find(human.name);
      if (node != nullptr && view_.isKnown(human.name)) {
        view_.error(human.name, "a person may not have the name of a key of this block");
      } else if (node != nullptr) {
        view_.know(human.name);
        readPerson({node, human.name, human.key, reading_.report}, human);
      } else {
        registerPersonKeys(human.name);
      }
    }
  }

  /// So that `--set` knows the keys of people that have no map here yet.
  void registerPersonKeys(const std::string& name) {
    for (const char* key :
         {"start_time", "kind", "mass", "model", "route", "at_end", "wait", "tree"}) {
      reading_.report.knownPaths.insert(name + "." + key);
    }
  }

  void listed(const std::string& list, const std::vector<std::string>& names,
              base::EntityKind kind) {
    for (const std::string& name : names) {
      const YamlNode* node = view_.node().find(name);
      if (view_.isKnown(name) || scenario_.human(name) != nullptr || name == "map") {
        view_.error(list, "the name '" + name + "' is taken");
      } else if (node == nullptr) {
        view_.error(list, "'" + name + "' is listed but has no map");
      } else if (!isEntityName(name)) {
        view_.know(name);
        view_.error(list, "'" + name +
                              "': a name consists of letters, digits and _, and begins "
                              "with a letter");
      } else {
        addEntity(*node, kind, true);
      }
    }
  }

  void readUnlisted() {
    for (const YamlNode& item : view_.node().items) {
      if (!view_.isKnown(item.key) && item.isMap()) {
        const base::EntityKind kind = kindOf(item);
        if (kind != base::EntityKind::None && isEntityName(item.key)) {
          addEntity(item, kind, false);
        }
      }
    }
  }

  static base::EntityKind kindOf(const YamlNode& node) {
    const YamlNode* kind = node.find("kind");
    const auto among = [&](const std::vector<std::string>& words) {
      return kind != nullptr && std::find(words.begin(), words.end(), kind->text) != words.end();
    };
    if (among(obstacleKindWords())) {
      return base::EntityKind::Obstacle;
    }
    if (among(areaKindWords())) {
      return base::EntityKind::Area;
    }
    if (node.find("x1") != nullptr && node.find("x2") != nullptr) {
      return base::EntityKind::Door;
    }
    return node.find("start") != nullptr ? base::EntityKind::Robot : base::EntityKind::None;
  }

  void addEntity(const YamlNode& node, base::EntityKind kind, bool isListed) {
    view_.know(node.key);
    const EntityId entity = reading_.newEntity(kind, node);
    YamlMap view(&node, node.key, entity, reading_.report);
    const auto keep = [&](auto value, auto& to) {
      value.key = entity;
      value.name = node.key;
      value.listed = isListed;
      to.push_back(std::move(value));
    };
    switch (kind) {
      case base::EntityKind::Robot:
        keep(readRobot(std::move(view)), scenario_.robots);
        break;
      case base::EntityKind::Obstacle:
        keep(readObstacle(std::move(view)), scenario_.obstacles);
        break;
      case base::EntityKind::Door:
        keep(readDoor(std::move(view)), scenario_.doors);
        break;
      default:
        keep(readArea(std::move(view)), scenario_.areas);
        break;
    }
  }

  LoaderReading& reading_;
  Scenario& scenario_;
  YamlMap view_;
};

}  // namespace

Vec2 readPoint(YamlMap& view) {
  return {view.required("x"), view.required("y")};
}

/// Maps inside an entity that have no place for keys of others.
void refuseUnknown(YamlMap& view) {
  for (const UnknownKey& key : view.takeUnknown()) {
    view.warning(key.key, "is lost when the scenario is saved");
  }
}

void readBlock(const YamlNode& parameters, LoaderReading& reading) {
  BlockReader(parameters, reading).read();
}

}  // namespace sim2d
