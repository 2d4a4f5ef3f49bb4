#include "sim2d/base/Problems.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/AgentReader.h"

namespace sim2d {
namespace {

void setDefaultFactors(Behavior& behavior) {
  behavior.goalForceFactor = 2.0;
  behavior.obstacleForceFactor = 10.0;
  behavior.socialForceFactor = 5.0;
}

bool reacts(const Behavior& behavior) {
  return behavior.type && *behavior.type != BehaviorType::Regular &&
         *behavior.type != BehaviorType::Impassive;
}

/// What the loader of 2024 put in the place of the file's numbers with configuration 0; `dist` in
/// the meaning of that time.
void applyOldDefaults(Human& human) {
  Behavior& behavior = human.behavior;
  setDefaultFactors(behavior);
  if (!reacts(behavior)) {
    return;
  }
  behavior.once = true;
  behavior.duration = 40.0;
  switch (*behavior.type) {
    case BehaviorType::Surprised:
      behavior.duration = 30.0;
      behavior.dist = 4.0;
      break;
    case BehaviorType::Scared:
      behavior.vel = 0.6;
      behavior.dist = 3.0;
      behavior.otherForceFactor = 20.0;
      break;
    case BehaviorType::Curious:
      behavior.vel = human.maxVel;
      behavior.dist = 1.5;
      break;
    case BehaviorType::Threatening:
      behavior.dist = 1.4;
      break;
    case BehaviorType::Regular:
    case BehaviorType::Impassive:
      break;
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

}  // namespace

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

void convertFromA(Human& human, const YamlNode& at, ReadReport& report) {
  Behavior& behavior = human.behavior;
  behavior.configuration = Configuration::Default;
  setDefaultFactors(behavior);
  behavior.otherForceFactor = 20.0;
  switch (behavior.type.value_or(BehaviorType::Regular)) {
    case BehaviorType::Surprised:
      behavior.dist = 4.0;
      behavior.duration = 30.0;
      behavior.once = true;
      break;
    case BehaviorType::Scared:
      behavior.dist = 3.0;
      behavior.duration = 40.0;
      behavior.once = false;
      behavior.vel = 0.6;
      behavior.safeDistance = 5.0;
      break;
    case BehaviorType::Curious:
      behavior.dist = 10.0;
      behavior.duration = 30.0;
      behavior.once = true;
      behavior.vel = 1.8;
      behavior.stopDist = 1.5;
      tell(human, at, "scenario.curious-slowed", {}, report);
      break;
    case BehaviorType::Threatening:
      behavior.dist = 4.0;
      behavior.duration = 40.0;
      behavior.once = true;
      behavior.vel = 2.0;
      behavior.frontDist = 1.1;
      break;
    case BehaviorType::Regular:
    case BehaviorType::Impassive:
      break;
  }
}

std::optional<std::string> suggestedSimulator(const Scenario& scenario) {
  for (const Human& human : scenario.humans) {
    if (!human.initZ) {
      continue;
    }
    if (*human.initZ == 1.25) {
      return "Gazebo Classic";
    }
    if (*human.initZ == 0.03) {
      return "Gazebo Fortress";
    }
    if (*human.initZ == 0.01) {
      return "Webots";
    }
    if (*human.initZ == 0.0) {
      return "Isaac Sim";
    }
  }
  return std::nullopt;
}

}  // namespace sim2d
