#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/run/ResultStore.h"
#include "sim2d/base/TreeResults.h"

/// Coverage of behaviour trees over a batch: in how many runs each node returned which status.
namespace app {

/// Whether a node was executed in a run: a character of TreeRow::returned.
bool isExecuted(char returned);
/// The trees of a run; equal trees of several owners are one.
std::vector<TreeRow> treeRowsOf(const std::vector<base::TreeResults>& results);

struct CoveredNode {
  std::string path;  // as in trees.csv
  // Numbers of runs in which the node returned this at least once:
  std::size_t running = 0, success = 0, failure = 0, skipped = 0;
  std::size_t executed = 0;    // anything but SKIPPED
  bool isUnreachable = false;  // the structure of the tree proves it; not in files
};
/// A tree of a scenario, over all runs that have it.
struct CoveredTree {
  std::string scenario;
  std::string owners;    // people and robots, separated by ", "
  std::size_t runs = 0;  // with this tree
  std::vector<CoveredNode> nodes;

  std::size_t executedNodes() const;
};

/// Adds up the trees of runs.
class TreeCoverage {
 public:
  /// Result: the index in trees() of each row. Equal trees of a scenario are one.
  std::vector<std::size_t> add(const std::string& scenario, const std::vector<TreeRow>& rows);
  const std::vector<CoveredTree>& trees() const { return trees_; }  // by first occurrence

 private:
  std::vector<CoveredTree> trees_;
  std::map<std::pair<std::string, std::string>, std::size_t> places_;  // by scenario and paths
};

constexpr const char* kTreeCoverageFile = "tree_coverage.csv";

/// All trees of the store, by the run and place of their first occurrence; empty: none is stored.
base::Result<std::vector<CoveredTree>> treeCoverageOf(const ResultStore& store);
std::string treeCoverageCsv(const std::vector<CoveredTree>& trees);
/// Reads the file of a batch folder. Errors: it is missing or damaged.
base::Result<std::vector<CoveredTree>> readTreeCoverage(const std::string& path);

}  // namespace app
