#include "editor/document/BehaviorValues.h"

#include "sim2d/scenario/Defaults.h"

namespace editor {

namespace {

using sim2d::BehaviorType;

/// The numbers that the reaction uses; those that are written stay unless `overwrite`.
void writeReaction(const sim2d::ResolvedHuman& counts, sim2d::Behavior& to, bool overwrite) {
  const auto put = [overwrite](std::optional<double>& place, double value) {
    place = overwrite ? value : place.value_or(value);
  };
  const BehaviorType type = counts.behavior;
  put(to.dist, counts.noticeDistance);
  put(to.duration, counts.reactionDuration);
  if (type == BehaviorType::Scared || type == BehaviorType::Curious) {
    put(to.vel, counts.reactionSpeed);
  }
  if (type == BehaviorType::Scared) {
    put(to.safeDistance, counts.safeDistance);
  } else if (type == BehaviorType::Curious) {
    put(to.stopDist, counts.stopDistance);
  } else if (type == BehaviorType::Threatening) {
    put(to.frontDist, counts.frontDistance);
  }
}

}  // namespace

void completeReaction(const sim2d::Scenario& scenario, sim2d::Human& human) {
  if (!reactsToRobot(human.behavior.type.value_or(BehaviorType::Regular))) {
    return;
  }
  const sim2d::ResolvedHuman counts = sim2d::resolveHuman(scenario, human, 0);
  human.behavior.once = human.behavior.once.value_or(counts.reactionOnce);
  if (!isDrawn(human)) {
    writeReaction(counts, human.behavior, false);
  }
}

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
  if (reactsToRobot(drawn.behavior)) {
    writeReaction(drawn, frozen, true);
  }
  return frozen;
}

}  // namespace editor
