#include <algorithm>
#include <array>
#include <map>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioTree.h"

namespace sim2d {
namespace {

void setDefaultFactors(Behavior& behavior) {
  behavior.goalForceFactor = 2.0;
  behavior.obstacleForceFactor = 10.0;
  behavior.socialForceFactor = 5.0;
}

/// What the loader of 2024 put in the place of the file's numbers with configuration 0; `dist` in
/// the meaning of that time.
void applyOldDefaults(Human& human) {
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

void tell(const Human& human, const YamlNode& at, const char* code, base::ProblemValues values,
          ReadReport& report) {
  report.add(at,
             base::within(human.name, base::problem(base::Severity::Info, code, std::move(values))),
             human.key);
}

/// `dist` was the distance kept from the robot for two of the types, which noticed it within a
/// fixed distance.
void moveDistance(Human& human, const YamlNode& at, ReadReport& report) {
  Behavior& behavior = human.behavior;
  if (behavior.type == BehaviorType::Curious) {
    behavior.stopDist = behavior.dist;
    behavior.dist = 10.0;
    tell(human, at, "scenario.distance-becomes-stop", {}, report);
  } else if (behavior.type == BehaviorType::Threatening) {
    behavior.frontDist = behavior.dist;
    behavior.dist = 4.5;
    tell(human, at, "scenario.distance-becomes-front", {}, report);
  } else if (behavior.type == BehaviorType::Scared && !behavior.safeDistance) {
    behavior.safeDistance = 5.0;
  }
}

/// Dialect B: `dist` had another meaning for some types, configuration 0 overruled the file.
void convertFromB(Human& human, const YamlNode& at, ReadReport& report) {
  const Configuration configuration = human.behavior.configuration.value_or(Configuration::Default);
  if (configuration == Configuration::Default) {
    const Behavior before = human.behavior;
    applyOldDefaults(human);
    if (!(before == human.behavior)) {
      tell(human, at, "scenario.configuration-overruled", {}, report);
    }
  } else if (configuration != Configuration::Custom) {
    tell(human, at, "scenario.configuration-drew", {static_cast<int>(configuration)}, report);
  }
  moveDistance(human, at, report);
}

struct FirstReaction {
  double dist, duration;
  bool once = true;
  double vel = 0.0;
  std::optional<double> Behavior::*kept = nullptr;  // the distance from the robot, with `vel`
  double keptAt = 0.0;
};

/// Dialect A had a number and no parameters: what the program of that time did, as parameters.
void convertFromA(Human& human, const YamlNode& at, ReadReport& report) {
  Behavior& behavior = human.behavior;
  behavior.configuration = Configuration::Default;
  setDefaultFactors(behavior);
  behavior.otherForceFactor = 20.0;
  static const std::map<BehaviorType, FirstReaction> kFirstReactions = {
      {BehaviorType::Surprised, {4.0, 30.0}},
      {BehaviorType::Scared, {3.0, 40.0, false, 0.6, &Behavior::safeDistance, 5.0}},
      {BehaviorType::Curious, {10.0, 30.0, true, 1.8, &Behavior::stopDist, 1.5}},
      {BehaviorType::Threatening, {4.0, 40.0, true, 2.0, &Behavior::frontDist, 1.1}}};
  const auto found = kFirstReactions.find(behavior.type.value_or(BehaviorType::Regular));
  if (found == kFirstReactions.end()) {
    return;
  }
  const FirstReaction& reaction = found->second;
  behavior.dist = reaction.dist;
  behavior.duration = reaction.duration;
  behavior.once = reaction.once;
  if (reaction.kept != nullptr) {
    behavior.vel = reaction.vel;
    behavior.*reaction.kept = reaction.keptAt;
  }
  if (behavior.type == BehaviorType::Curious) {
    tell(human, at, "scenario.curious-slowed", {}, report);
  }
}

constexpr long long kLargestInt = 2147483647;

std::optional<int> behaviorNumber(const std::string& text) {
  const auto number = base::parseInt(text);
  return number && *number >= 1 && *number <= 6 ? std::optional<int>(static_cast<int>(*number))
                                                : std::nullopt;
}

void readBehaviorMap(YamlMap& view, Human& human, LoaderReading& reading) {
  readThing(view, human.behavior, reading.tables);
  const YamlNode* type = view.node().find("type");
  if (type != nullptr && behaviorNumber(type->text)) {
    reading.numberedType = true;
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
  warnForeign(human.behavior, *node, "behavior", agent);
  if (base::parseInt(node->text)) {
    reading.scalarBehavior = true;
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
  human.initPose.position = {view.number("x", base::kWithinReach).value_or(0.0),
                             view.number("y", base::kWithinReach).value_or(0.0)};
  human.initZ = view.number("z", base::kWithinReach);
  human.initPose.heading = view.number("h", base::kHeading).value_or(0.0);
  human.initPoseUnknown = view.takeUnknown();
}

/// The goal that an agent's own name stands for; 0 = there is none of that name.
int namedGoal(YamlMap& agent, const std::string& name, LoaderReading& reading) {
  const YamlNode* node = agent.node().find(name);
  if (node == nullptr || !node->isMap()) {
    return 0;
  }
  agent.know(name);
  YamlMap view(node, agent.pathOf(name), agent.entity(), agent.report());
  const Vec2 position = readPoint(view);
  const auto heading = view.number("h", base::kHeading);
  UnknownKeys unknown;
  // the first editor put the height of the click, 1.25, where the heading belongs
  if (heading && *heading != 0.0 && *heading != 1.25) {
    unknown.push_back(unknownKey(*node->find("h")));
  }
  for (UnknownKey& key : view.takeUnknown()) {
    unknown.push_back(std::move(key));
  }
  reading.namedGoals = true;
  return reading.addGoal(position, std::move(unknown), *node);
}

/// The global goal that an item of the list `goals` means; nothing when it is not defined.
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
    reading.undefinedNumber = true;  // the check of the meaning tells
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

/// Whether there is a value somewhere in it; empty maps and lists are not written again.
bool saysAnything(const YamlNode& value) {
  return value.isScalar() ? !value.text.empty()
                          : std::any_of(value.items.begin(), value.items.end(), saysAnything);
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
    return value != nullptr && saysAnything(*value);
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
  human.unknown = view.takeUnknown();
  return human;
}

void warnForeign(const Behavior& behavior, const YamlNode& at, const std::string& key,
                 YamlMap& view) {
  if (!behavior.foreignType.empty()) {
    view.add(at, key, base::warning("scenario.foreign-behavior", {behavior.foreignType}));
  }
}

void setBehaviorType(Behavior& behavior, const std::string& text) {
  const std::string word = base::trimmed(text);
  behavior.foreignType.clear();
  if (const auto number = behaviorNumber(word)) {
    behavior.type = static_cast<BehaviorType>(*number);
  } else if (const auto named = behaviorFromName(word)) {
    behavior.type = named;
  } else {
    behavior.type = BehaviorType::Regular;
    behavior.foreignType = text;
  }
}

}  // namespace sim2d
