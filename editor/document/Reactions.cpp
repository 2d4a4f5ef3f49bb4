#include "editor/document/Reactions.h"

#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

void writeNumbers(const sim2d::ResolvedHuman& counts, sim2d::Behavior& to) {
  const sim2d::BehaviorType type = counts.behavior;
  to.dist = to.dist.value_or(counts.noticeDistance);
  to.duration = to.duration.value_or(counts.reactionDuration);
  if (type == sim2d::BehaviorType::Scared || type == sim2d::BehaviorType::Curious) {
    to.vel = to.vel.value_or(counts.reactionSpeed);
  }
  if (type == sim2d::BehaviorType::Scared) {
    to.safeDistance = to.safeDistance.value_or(counts.safeDistance);
  } else if (type == sim2d::BehaviorType::Curious) {
    to.stopDist = to.stopDist.value_or(counts.stopDistance);
  } else if (type == sim2d::BehaviorType::Threatening) {
    to.frontDist = to.frontDist.value_or(counts.frontDistance);
  }
}

}  // namespace

void completeReaction(const sim2d::Scenario& scenario, sim2d::Human& human) {
  using sim2d::BehaviorType;
  using sim2d::Configuration;
  sim2d::Behavior& behavior = human.behavior;
  const BehaviorType type = behavior.type.value_or(BehaviorType::Regular);
  if (type == BehaviorType::Regular || type == BehaviorType::Impassive) {
    return;
  }
  const sim2d::ResolvedHuman counts = sim2d::resolveHuman(scenario, human, 0);
  behavior.once = behavior.once.value_or(counts.reactionOnce);
  if (behavior.configuration != Configuration::Normal &&
      behavior.configuration != Configuration::Uniform) {
    writeNumbers(counts, behavior);
  }
}

}  // namespace editor
