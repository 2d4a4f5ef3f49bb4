#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/TreeCoverage.h"

namespace app {

/// A behaviour tree with the runs of a search that have executed its nodes.
struct SearchedTree {
  CoveredTree counts;                                 // over all scenarios; its `scenario` is empty
  std::vector<std::string> scenarios;                 // with this tree, by first occurrence
  std::vector<std::optional<std::size_t>> firstRuns;  // per node, the first run that executed it

  bool isReached(std::size_t node) const { return firstRuns[node].has_value(); }
  /// Not yet executed, although nothing proves that it cannot be.
  bool isMissing(std::size_t node) const {
    return !isReached(node) && !counts.nodes[node].isUnreachable;
  }
  std::size_t missing() const;      // number of those nodes
  std::size_t unreachable() const;  // number of nodes that are never executed, as is proven
};

/// Which nodes of behaviour trees the runs of a search have executed. Trees with equal paths are
/// one, also those of several scenarios.
class SearchCoverage {
 public:
  /// Adds the trees of a run; numbers of runs count from 0 without gaps. Result: the number of
  /// nodes that no earlier run had executed.
  std::size_t add(std::size_t run, const std::string& scenario, const std::vector<TreeRow>& rows);

  /// Per run, how rare the nodes are that it has executed: the sum of 1/(number of runs so far that
  /// have executed it), over the nodes of trees that have missing nodes.
  std::vector<double> rarities() const;
  /// There are trees, and none has a missing node.
  bool isComplete() const;

  const std::vector<SearchedTree>& trees() const { return trees_; }  // by first occurrence
  /// The same by scenario, as studies count them.
  const std::vector<CoveredTree>& byScenario() const { return byScenario_.trees(); }

 private:
  using NodeIndex = std::pair<std::size_t, std::size_t>;  // tree and node

  TreeCoverage all_, byScenario_;
  std::vector<SearchedTree> trees_;
  std::vector<std::vector<NodeIndex>> executed_;  // per run
};

}  // namespace app
