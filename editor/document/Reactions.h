#pragma once

#include "sim2d/scenario/Scenario.h"

namespace editor {

/// Writes what the reaction of a person needs and their block leaves out, with the values that
/// count anyway. HuNavSim wants these keys; what is drawn at random stays to be drawn.
void completeReaction(const sim2d::Scenario& scenario, sim2d::Human& human);

}  // namespace editor
