#include "editor/document/Sampling.h"

#include "sim2d/scenario/Defaults.h"

namespace editor {

bool isDrawn(const sim2d::Human& human) {
  const auto mode = human.behavior.configuration.value_or(sim2d::Configuration::Default);
  return mode == sim2d::Configuration::Normal || mode == sim2d::Configuration::Uniform;
}

sim2d::Behavior frozenBehavior(const sim2d::Scenario& scenario, const sim2d::Human& human,
                               long long seed) {
  sim2d::Behavior frozen = human.behavior;
  if (!isDrawn(human)) {
    return frozen;
  }
  const sim2d::ResolvedHuman drawn = sim2d::resolveHuman(scenario, human, seed);
  frozen.configuration = sim2d::Configuration::Custom;
  frozen.goalForceFactor = drawn.goalFactor;
  frozen.obstacleForceFactor = drawn.obstacleFactor;
  frozen.socialForceFactor = drawn.socialFactor;
  frozen.otherForceFactor = drawn.otherFactor;
  const sim2d::BehaviorType type = drawn.behavior;
  if (type == sim2d::BehaviorType::Regular || type == sim2d::BehaviorType::Impassive) {
    return frozen;
  }
  frozen.dist = drawn.noticeDistance;
  frozen.duration = drawn.reactionDuration;
  if (type == sim2d::BehaviorType::Scared) {
    frozen.vel = drawn.reactionSpeed;
    frozen.safeDistance = drawn.safeDistance;
  } else if (type == sim2d::BehaviorType::Curious) {
    frozen.vel = drawn.reactionSpeed;
    frozen.stopDist = drawn.stopDistance;
  } else if (type == sim2d::BehaviorType::Threatening) {
    frozen.frontDist = drawn.frontDistance;
  }
  return frozen;
}

}  // namespace editor
