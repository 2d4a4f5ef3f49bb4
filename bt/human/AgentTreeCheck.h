#pragma once

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/scenario/Scenario.h"

namespace bt {

/// Whether a tree fits the person who has it: ids of people, goals and areas that are written as
/// constants exist, and the goals that it sets are those of the scenario, in order. Warnings only,
/// with the lines of the tree.
base::Diagnostics checkAgentTree(const TreeTable& table, const sim2d::Human& human,
                                 const sim2d::Scenario& scenario, const NodeCatalogue& catalogue);

/// The goals that SetGoal nodes give the person, in the order of the tree; SubTrees followed.
std::vector<int> goalsOfTree(const TreeTable& table);

}  // namespace bt
