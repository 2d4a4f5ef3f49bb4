#include "app/report/CoverageTable.h"

#include <algorithm>
#include <set>

#include "sim2d/base/Text.h"

namespace report {

namespace {

std::string parentOf(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? std::string() : path.substr(0, slash);
}

}  // namespace

std::vector<std::string> unexecutedBranches(const app::CoveredTree& tree) {
  std::set<std::string> executed = {""};  // the parent of the root
  for (const app::CoveredNode& node : tree.nodes) {
    if (node.executed > 0) {
      executed.insert(node.path);
    }
  }
  std::vector<std::string> branches;
  for (const app::CoveredNode& node : tree.nodes) {
    if (node.executed == 0 && executed.count(parentOf(node.path)) > 0) {
      branches.push_back(node.path);
    }
  }
  return branches;
}

std::optional<Table> coverageTable(const std::vector<app::CoveredTree>& trees, bool all) {
  constexpr std::size_t kMostBranches = 8;
  if (trees.empty()) {
    return std::nullopt;
  }
  Table table;
  table.name = "tree_coverage";
  table.caption =
      "Coverage of behaviour trees over all runs: nodes that were executed at least once, and "
      "branches that never were (the node at the top of each). Equal trees of a scenario are one "
      "row. tree_coverage.csv contains all nodes and their statuses; hunavsim trees FILE --picture "
      "tree.svg --coverage DIR draws them.";
  table.columns = {{"Scenario", "", false}, {"Trees of", "", false}, {"Runs", ""},
                   {"Nodes", ""},           {"Executed", ""},        {"Never executed", "", false}};
  for (const app::CoveredTree& tree : trees) {
    const double share = static_cast<double>(tree.executedNodes()) /
                         static_cast<double>(std::max<std::size_t>(1, tree.nodes.size()));
    std::vector<std::string> branches = unexecutedBranches(tree);
    const std::size_t count = branches.size();
    branches.resize(all ? count : std::min(count, kMostBranches));
    Table::Cell executed{std::to_string(tree.executedNodes()), percentText(share)};
    Table::Cell never{count == 0 ? "–" : base::join(branches, ", ")};
    never.below = branches.size() < count
                      ? "and " + std::to_string(count - branches.size()) + " more"
                      : std::string();
    table.rows.push_back({{tree.scenario},
                          {tree.owners},
                          {std::to_string(tree.runs)},
                          {std::to_string(tree.nodes.size())},
                          executed,
                          never});
  }
  return table;
}

}  // namespace report
