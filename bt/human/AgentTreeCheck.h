#pragma once

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/TreeSpec.h"
#include "sim2d/scenario/Scenario.h"

namespace bt {

/// Checks whether a tree fits its person: constant ids of people, goals and areas exist, and the
/// tree sets the goals of the scenario in the same order. Returns only warnings, with line numbers.
base::Diagnostics checkAgentTree(const TreeTable& table, const sim2d::Human& human,
                                 const sim2d::Scenario& scenario, const NodeCatalogue& catalogue);

/// The goals that SetGoal nodes assign to the person, in tree order, including SubTrees.
std::vector<int> treeGoals(const TreeTable& table);

}  // namespace bt
