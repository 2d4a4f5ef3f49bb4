#include "app/studies/SearchCoverage.h"

#include <algorithm>

namespace app {

std::size_t SearchedTree::missing() const {
  std::size_t count = 0;
  for (std::size_t node = 0; node < firstRuns.size(); ++node) {
    count += isMissing(node) ? 1 : 0;
  }
  return count;
}

std::size_t SearchedTree::unreachable() const {
  return static_cast<std::size_t>(
      std::count_if(counts.nodes.begin(), counts.nodes.end(),
                    [](const CoveredNode& node) { return node.isUnreachable; }));
}

std::size_t SearchCoverage::add(std::size_t run, const std::string& scenario,
                                const std::vector<TreeRow>& rows) {
  byScenario_.add(scenario, rows);
  const std::vector<std::size_t> indices = all_.add({}, rows);
  trees_.resize(all_.trees().size());
  executed_.resize(std::max(executed_.size(), run + 1));
  std::size_t found = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    SearchedTree& tree = trees_[indices[k]];
    tree.counts = all_.trees()[indices[k]];
    tree.firstRuns.resize(tree.counts.nodes.size());
    std::vector<std::string>& names = tree.scenarios;
    if (std::find(names.begin(), names.end(), scenario) == names.end()) {
      names.push_back(scenario);
    }
    const std::size_t nodes = std::min(tree.firstRuns.size(), rows[k].returned.size());
    for (std::size_t node = 0; node < nodes; ++node) {
      if (isExecuted(rows[k].returned[node])) {
        executed_[run].emplace_back(indices[k], node);
        found += tree.isReached(node) ? 0 : 1;
        tree.firstRuns[node] = tree.firstRuns[node].value_or(run);
      }
    }
  }
  return found;
}

std::vector<double> SearchCoverage::rarities() const {
  std::vector<bool> hasMissing;
  for (const SearchedTree& tree : trees_) {
    hasMissing.push_back(tree.missing() > 0);
  }
  std::vector<double> sums;
  sums.reserve(executed_.size());
  for (const std::vector<NodeIndex>& nodes : executed_) {
    double& sum = sums.emplace_back(0.0);
    for (const auto& [tree, node] : nodes) {
      const std::size_t runs = trees_[tree].counts.nodes[node].executed;
      sum += hasMissing[tree] ? 1.0 / static_cast<double>(runs) : 0.0;
    }
  }
  return sums;
}

bool SearchCoverage::isComplete() const {
  return !trees_.empty() && std::all_of(trees_.begin(), trees_.end(), [](const SearchedTree& tree) {
    return tree.missing() == 0;
  });
}

}  // namespace app
