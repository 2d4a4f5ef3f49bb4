#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/Markup.h"
#include "app/run/TreeCoverage.h"

namespace report {

/// The branches of a tree that were never executed: paths of nodes that were not, although their
/// parent was; the root if no node was.
std::vector<std::string> unexecutedBranches(const app::CoveredTree& tree);

/// Coverage of behaviour trees: a row per tree with the branches that were never executed. Nothing:
/// there are no trees. `all`: all branches, otherwise the first ones.
std::optional<Table> coverageTable(const std::vector<app::CoveredTree>& trees, bool all);

}  // namespace report
