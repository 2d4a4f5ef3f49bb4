#pragma once

#include "sim2d/scenario/Scenario.h"

namespace editor {

/// Writes what the reaction of a person needs and their block leaves out, with the values that
/// count anyway. HuNavSim wants these keys; what is drawn at random stays to be drawn.
void completeReaction(const sim2d::Scenario& scenario, sim2d::Human& human);
/// The numbers of that person are drawn (configuration normal or uniform).
bool isDrawn(const sim2d::Human& human);
/// The behaviour with the numbers that a run of that seed draws, written down: its configuration is
/// custom. Unchanged when nothing is drawn.
sim2d::Behavior frozenBehavior(const sim2d::Scenario& scenario, const sim2d::Human& human,
                               long long seed);

}  // namespace editor
