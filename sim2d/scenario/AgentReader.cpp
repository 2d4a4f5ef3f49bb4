#include <algorithm>
#include <array>
#include <map>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioYaml.h"

namespace sim2d {
namespace {

void setDefaultFactors(Behavior& behavior) {
  behavior.goalForceFactor = 2.0;
  behavior.obstacleForceFactor = 10.0;
  behavior.socialForceFactor = 5.0;
}

/// Values that the loader of 2024 used instead of the file's with configuration 0; `dist` in its
/// meaning of that time.
void applyDialectBDefaults(Human& human) {
  Behavior& behavior = human.behavior;
  setDefaultFactors(behavior);
  if (!behavior.type || !reactsToRobot(*behavior.type)) {
    return;
  }
  static const std::map<BehaviorType, double> kDistances = {{BehaviorType::Surprised, 4.0},
                                                            {BehaviorType::Scared, 3.0},
                                                            {BehaviorType::Curious, 1.5},
                                                            {BehaviorType::Threatening, 1.4}};
  behavior.once = true;
  behavior.duration = behavior.type == BehaviorType::Surprised ? 30.0 : 40.0;
  behavior.dist = kDistances.at(*behavior.type);
  if (behavior.type == BehaviorType::Scared) {
    behavior.vel = 0.6;
    behavior.otherForceFactor = 20.0;
  } else if (behavior.type == BehaviorType::Curious) {
    behavior.vel = human.maxVel;
  }
}

void reportInfo(const Human& human, const YamlNode& at, const char* code,
                base::ProblemValues values, ReadReport& report) {
  report.add(
      at,
      base::withContext(human.name, base::problem(base::Severity::Info, code, std::move(values))),
      human.key);
}

/// For two types `dist` was the distance kept from the robot, which they noticed within a fixed
/// distance.
void convertDistance(Human& human, const YamlNode& at, ReadReport& report) {
  Behavior& behavior = human.behavior;
  if (behavior.type == BehaviorType::Curious) {
    behavior.stopDist = behavior.dist;
    behavior.dist = 10.0;
    reportInfo(human, at, "scenario.distance-becomes-stop", {}, report);
  } else if (behavior.type == BehaviorType::Threatening) {
    behavior.frontDist = behavior.dist;
    behavior.dist = 4.5;
    reportInfo(human, at, "scenario.distance-becomes-front", {}, report);
  } else if (behavior.type == BehaviorType::Scared && !behavior.safeDistance) {
    behavior.safeDistance = 5.0;
  }
}

/// Converts dialect B: for some types `dist` had another meaning, and configuration 0 overrode the
/// file.
void convertFromB(Human& human, const YamlNode& at, ReadReport& report) {
  const Configuration configuration = human.behavior.configuration.value_or(Configuration::Default);
  if (configuration == Configuration::Default) {
    const Behavior before = human.behavior;
    applyDialectBDefaults(human);
    if (!(before == human.behavior)) {
      reportInfo(human, at, "scenario.configuration-overruled", {}, report);
    }
  } else if (configuration != Configuration::Custom) {
    reportInfo(human, at, "scenario.configuration-drew", {static_cast<int>(configuration)}, report);
  }
  convertDistance(human, at, report);
}

struct DialectAReaction {
  double dist, duration;
  bool once = true;
  double vel = 0.0;
  std::optional<double> Behavior::*kept = nullptr;  // distance from the robot, set with `vel`
  double storedAt = 0.0;
};

/// Converts dialect A, which has only a type number: sets the parameters of the program of that
/// time.
void convertFromA(Human& human, const YamlNode& at, ReadReport& report) {
  Behavior& behavior = human.behavior;
  behavior.configuration = Configuration::Default;
  setDefaultFactors(behavior);
  behavior.otherForceFactor = 20.0;
  static const std::map<BehaviorType, DialectAReaction> kDialectAReactions = {
      {BehaviorType::Surprised, {4.0, 30.0}},
      {BehaviorType::Scared, {3.0, 40.0, false, 0.6, &Behavior::safeDistance, 5.0}},
      {BehaviorType::Curious, {10.0, 30.0, true, 1.8, &Behavior::stopDist, 1.5}},
      {BehaviorType::Threatening, {4.0, 40.0, true, 2.0, &Behavior::frontDist, 1.1}}};
  const auto found = kDialectAReactions.find(behavior.type.value_or(BehaviorType::Regular));
  if (found == kDialectAReactions.end()) {
    return;
  }
  const DialectAReaction& reaction = found->second;
  behavior.dist = reaction.dist;
  behavior.duration = reaction.duration;
  behavior.once = reaction.once;
  if (reaction.kept != nullptr) {
    behavior.vel = reaction.vel;
    behavior.*reaction.kept = reaction.storedAt;
  }
  if (behavior.type == BehaviorType::Curious) {
    reportInfo(human, at, "scenario.curious-slowed", {}, report);
  }
}

constexpr long long kLargestInt = 2147483647;

std::optional<int> behaviorNumber(const std::string& text) {
  const auto number = base::parseInt(text);
  return number && *number >= 1 && *number <= 6 ? std::optional<int>(static_cast<int>(*number))
                                                : std::nullopt;
}

void readBehaviorMap(YamlMap& view, Human& human, LoaderReading& reading) {
  readObject(view, human.behavior, reading.tables);
  const YamlNode* type = view.node().find("type");
  if (type != nullptr && behaviorNumber(type->text)) {
    reading.hasNumberedType = true;
    convertFromB(human, view.node(), reading.report);
  }
}

void readBehavior(YamlMap& agent, Human& human, LoaderReading& reading) {
  const YamlNode* node = agent.find("behavior");
  if (node == nullptr) {
    return;
  }
  if (!node->isScalar()) {
    YamlMap behavior(node, agent.pathOf("behavior"), human.key, reading.report);
    readBehaviorMap(behavior, human, reading);
    return;
  }
  if (node->text.empty()) {
    agent.warning("behavior", "scenario.empty-behavior");
    return;
  }
  setBehaviorType(human.behavior, node->text);
  warnUnknownBehavior(human.behavior, *node, "behavior", agent);
  if (base::parseInt(node->text)) {
    reading.hasScalarBehavior = true;
    convertFromA(human, *node, reading.report);
  }
}

void readPose(YamlMap& agent, Human& human) {
  const YamlNode* node = agent.find("init_pose");
  human.hasInitPose = node != nullptr && node->isMap();
  if (node == nullptr) {
    return;
  }
  YamlMap view(node, agent.pathOf("init_pose"), human.key, agent.report());
  human.initPose.position = {view.number("x", base::kCoordinateRange).value_or(0.0),
                             view.number("y", base::kCoordinateRange).value_or(0.0)};
  human.initZ = view.number("z", base::kCoordinateRange);
  human.initPose.heading = view.number("h", base::kHeading).value_or(0.0);
  human.initPoseUnknown = view.takeUnknownKeys();
}

/// The goal defined in the agent's block under this name; 0: there is none.
int namedGoal(YamlMap& agent, const std::string& name, LoaderReading& reading) {
  const YamlNode* node = agent.node().find(name);
  if (node == nullptr || !node->isMap()) {
    return 0;
  }
  agent.markKnown(name);
  YamlMap view(node, agent.pathOf(name), agent.entity(), agent.report());
  const Vec2 position = readPoint(view);
  const auto heading = view.number("h", base::kHeading);
  UnknownKeys unknown;
  // The first editor wrote the height of the click, 1.25, instead of the heading.
  if (heading && *heading != 0.0 && *heading != 1.25) {
    unknown.push_back(unknownKey(*node->find("h")));
  }
  for (UnknownKey& key : view.takeUnknownKeys()) {
    unknown.push_back(std::move(key));
  }
  reading.hasNamedGoals = true;
  return reading.addGoal(position, std::move(unknown), *node);
}

/// The global goal of an item of the list `goals`; none if it is not defined.
std::optional<int> goalOf(const YamlNode& item, YamlMap& agent, std::map<std::string, int>& named,
                          LoaderReading& reading) {
  const bool isWord = item.isScalar() && !item.text.empty();
  const auto number = isWord ? base::parseInt(item.text) : std::nullopt;
  const bool isNumber = number && *number > 0 && *number <= kLargestInt;
  const int id = isNumber ? static_cast<int>(*number) : 0;
  if (isNumber && named.count(item.text) == 0 && reading.scenario.goal(id) != nullptr) {
    return id;
  }
  if (isWord && named.count(item.text) == 0) {
    named[item.text] = namedGoal(agent, item.text, reading);
  }
  if (isWord && named[item.text] != 0) {
    return named[item.text];
  }
  if (isNumber) {
    reading.hasUndefinedGoal = true;  // reported by checkScenario
    return id;
  }
  if (isWord && base::parseDouble(item.text)) {
    const auto integral = agent.integerOf(item, "goals");
    if (!integral || (*integral > 0 && *integral <= kLargestInt)) {
      return integral ? std::optional<int>(static_cast<int>(*integral)) : std::nullopt;
    }
  }
  agent.add(item, "goals", base::error("scenario.goal-not-defined", {item.text}));
  return std::nullopt;
}

/// Whether the value contains any scalar; empty maps and lists are not written again.
bool hasAnyScalar(const YamlNode& value) {
  return value.isScalar() ? !value.text.empty()
                          : std::any_of(value.items.begin(), value.items.end(), hasAnyScalar);
}

void readGoalList(YamlMap& agent, Human& human, LoaderReading& reading) {
  const YamlNode* list = agent.find("goals");
  if (list == nullptr) {
    return;
  }
  if (!list->isList()) {
    agent.error("goals", "scenario.goals-no-list");
    return;
  }
  std::map<std::string, int> named;
  for (const YamlNode& item : list->items) {
    if (const auto id = goalOf(item, agent, named, reading)) {
      human.goals.push_back(*id);
    }
  }
}

}  // namespace

int LoaderReading::addGoal(const Vec2& position, UnknownKeys unknown, const YamlNode& at) {
  GlobalGoal goal;
  goal.key = newEntity(base::EntityKind::Goal, at);
  for (; goalsSeen < scenario.goals.size(); ++goalsSeen) {
    largestGoal = std::max(largestGoal, scenario.goals[goalsSeen].id);
  }
  goal.id = largestGoal + 1;
  goal.position = position;
  goal.unknown = std::move(unknown);
  scenario.goals.push_back(goal);
  return goal.id;
}

EntityId LoaderReading::newEntity(base::EntityKind kind, const YamlNode& at) {
  const EntityId entity{kind, ++lastKey};
  report.lines[entity] = at.keyLine > 0 ? at.keyLine : at.line;
  return entity;
}

bool looksLikeAgent(const YamlNode& block) {
  if (!block.isMap()) {
    return false;
  }
  const auto has = [&](const char* key) {
    const YamlNode* value = block.find(key);
    return value != nullptr && hasAnyScalar(*value);
  };
  static constexpr std::array<const char*, 6> kUsual = {"id",      "group_id", "skin",
                                                        "max_vel", "radius",   "goals"};
  return has("init_pose") || has("behavior") ||
         std::count_if(kUsual.begin(), kUsual.end(), has) >= 2;
}

Human readHuman(const YamlNode& block, bool listed, LoaderReading& reading) {
  Human human;
  human.key = reading.newEntity(base::EntityKind::Human, block);
  human.name = block.key;
  human.listed = listed;
  YamlMap view(&block, block.key, human.key, reading.report);
  readFields(view, human, reading.tables);
  readPose(view, human);
  readBehavior(view, human, reading);
  readGoalList(view, human, reading);
  human.unknown = view.takeUnknownKeys();
  return human;
}

void warnUnknownBehavior(const Behavior& behavior, const YamlNode& at, const std::string& key,
                         YamlMap& view) {
  if (!behavior.unknownType.empty()) {
    view.add(at, key, base::warning("scenario.foreign-behavior", {behavior.unknownType}));
  }
}

void setBehaviorType(Behavior& behavior, const std::string& text) {
  const std::string word = base::trimmed(text);
  behavior.unknownType.clear();
  if (const auto number = behaviorNumber(word)) {
    behavior.type = static_cast<BehaviorType>(*number);
  } else if (const auto named = behaviorFromName(word)) {
    behavior.type = named;
  } else {
    behavior.type = BehaviorType::Regular;
    behavior.unknownType = text;
  }
}

}  // namespace sim2d
