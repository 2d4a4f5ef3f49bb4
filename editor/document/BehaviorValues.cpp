#include "editor/document/BehaviorValues.h"

#include "sim2d/scenario/Fields.h"

namespace editor {

void completeReaction(const sim2d::Scenario& scenario, sim2d::Human& human) {
  const sim2d::ResolvedHuman counts = sim2d::resolveHuman(scenario, human, 0);
  if (!isDrawn(human)) {
    sim2d::fillFields(human.behavior, counts, sim2d::reactionKeys(counts.behavior));
  } else if (reactsToRobot(counts.behavior)) {
    sim2d::fillFields(human.behavior, counts, {"once"});
  }
}

bool isDrawn(const sim2d::Human& human) {
  return isDrawn(human.behavior.configuration.value_or(sim2d::Configuration::Default));
}

sim2d::Behavior frozenBehavior(const sim2d::Scenario& scenario, const sim2d::Human& human,
                               long long seed) {
  sim2d::Behavior frozen = human.behavior;
  if (!isDrawn(human)) {
    return frozen;
  }
  const sim2d::ResolvedHuman drawn = sim2d::resolveHuman(scenario, human, seed);
  frozen.configuration = sim2d::Configuration::Custom;
  sim2d::fillFields(frozen, drawn, sim2d::factorKeys(), true);
  sim2d::fillFields(frozen, drawn, sim2d::reactionKeys(drawn.behavior), true);
  frozen.once = human.behavior.once;  // is not drawn
  return frozen;
}

}  // namespace editor
