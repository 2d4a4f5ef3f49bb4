#include "app/run/TreeCoverage.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include "sim2d/base/Files.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace app {

namespace {

using base::NodeStatus;

constexpr char kHexDigits[] = "0123456789abcdef";
constexpr char kUnreachable = 'u';  // in place of a digit
constexpr const char* kCoverageColumns =
    "scenario,tree,owners,runs,node,executed,running,success,failure,skipped";

/// The statuses of a node as a digit; without IDLE, which is not returned.
char digitOf(base::StatusSet set) {
  return kHexDigits[static_cast<unsigned>(set) >> 1U & 15U];
}
base::StatusSet setOf(char digit) {
  const std::size_t value = std::string_view(kHexDigits).find(digit);
  return static_cast<base::StatusSet>(value == std::string_view::npos ? 0U : value << 1U);
}

/// Adds owners that are not among those yet.
void addOwners(const std::string& more, std::string& owners) {
  std::vector<std::string> all = base::split(owners, ',');
  for (std::string& each : all) {
    each = base::trimmed(each);
  }
  for (const std::string& each : base::split(more, ',')) {
    const std::string name = base::trimmed(each);
    if (std::find(all.begin(), all.end(), name) == all.end()) {
      owners += (owners.empty() ? "" : ", ") + name;
      all.push_back(name);
    }
  }
}

/// The digit of each node, or the mark of nodes that are never executed.
std::string returnedText(const base::TreeResults& results) {
  std::string text;
  for (std::size_t node = 0; node < results.returned.size(); ++node) {
    const char digit = digitOf(results.returned[node]);
    const bool isUnreachable = results.unreachable && (*results.unreachable)[node];
    text += isUnreachable && digit == kHexDigits[0] ? kUnreachable : digit;
  }
  return text;
}

void addRun(const TreeRow& row, CoveredTree& tree) {
  ++tree.runs;
  addOwners(row.owners, tree.owners);
  for (std::size_t k = 0; k < tree.nodes.size() && k < row.returned.size(); ++k) {
    const base::StatusSet set = setOf(row.returned[k]);
    CoveredNode& node = tree.nodes[k];
    const auto count = [set](NodeStatus status) { return base::contains(set, status) ? 1U : 0U; };
    node.running += count(NodeStatus::Running);
    node.success += count(NodeStatus::Success);
    node.failure += count(NodeStatus::Failure);
    node.skipped += count(NodeStatus::Skipped);
    node.executed += isExecuted(row.returned[k]) ? 1 : 0;
    node.isUnreachable = node.isUnreachable && row.returned[k] == kUnreachable;
  }
}

CoveredTree newTree(const std::string& scenario, const TreeRow& row) {
  CoveredTree tree;
  tree.scenario = scenario;
  for (const std::string& path : base::split(row.paths, '\n')) {
    CoveredNode& node = tree.nodes.emplace_back();
    node.path = path;
    node.isUnreachable = true;  // until a run says otherwise
  }
  return tree;
}

}  // namespace

bool isExecuted(char returned) {
  const base::StatusSet set = setOf(returned);
  return base::contains(set, NodeStatus::Running) || base::contains(set, NodeStatus::Success) ||
         base::contains(set, NodeStatus::Failure);
}

std::size_t CoveredTree::executedNodes() const {
  return static_cast<std::size_t>(std::count_if(
      nodes.begin(), nodes.end(), [](const CoveredNode& node) { return node.executed > 0; }));
}

std::vector<TreeRow> treeRowsOf(const std::vector<base::TreeResults>& results) {
  std::vector<base::TreeResults> merged;
  std::vector<std::string> owners;
  for (base::TreeResults each : results) {
    const std::string owner = std::exchange(each.owner, {});
    base::addTreeResults(each, merged);  // without owners, equal trees are one
    owners.resize(merged.size());
    const auto place = std::find_if(merged.begin(), merged.end(), [&](const auto& known) {
      return known.paths == each.paths || *known.paths == *each.paths;
    });
    addOwners(owner, owners[static_cast<std::size_t>(place - merged.begin())]);
  }
  std::vector<TreeRow> rows;
  for (std::size_t k = 0; k < merged.size(); ++k) {
    TreeRow& row = rows.emplace_back();
    row.owners = owners[k];
    row.paths = base::join(*merged[k].paths, "\n");
    row.returned = returnedText(merged[k]);
  }
  return rows;
}

std::vector<std::size_t> TreeCoverage::add(const std::string& scenario,
                                           const std::vector<TreeRow>& rows) {
  std::vector<std::size_t> indices;
  for (const TreeRow& row : rows) {
    const auto [place, isNew] = places_.emplace(std::pair(scenario, row.paths), trees_.size());
    if (isNew) {
      trees_.push_back(newTree(scenario, row));
    }
    addRun(row, trees_[place->second]);
    indices.push_back(place->second);
  }
  return indices;
}

base::Result<std::vector<CoveredTree>> treeCoverageOf(const ResultStore& store) {
  TreeCoverage coverage;
  base::Diagnostics problems =
      store.forEach([&](const StoredRun& run) { coverage.add(run.scenario, run.row.trees); });
  return base::resultOf(std::vector<CoveredTree>(coverage.trees()), std::move(problems));
}

std::string treeCoverageCsv(const std::vector<CoveredTree>& trees) {
  std::string text = std::string(kCoverageColumns) + '\n';
  for (std::size_t k = 0; k < trees.size(); ++k) {
    for (const CoveredNode& node : trees[k].nodes) {
      sim2d::appendCsvField(text, trees[k].scenario);
      text += ',' + std::to_string(k + 1) + ',';
      sim2d::appendCsvField(text, trees[k].owners);
      text += ',' + std::to_string(trees[k].runs) + ',';
      sim2d::appendCsvField(text, node.path);
      for (const std::size_t count :
           {node.executed, node.running, node.success, node.failure, node.skipped}) {
        text += ',' + std::to_string(count);
      }
      text += '\n';
    }
  }
  return text;
}

base::Result<std::vector<CoveredTree>> readTreeCoverage(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path, base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  base::Diagnostics problems;
  std::vector<CoveredTree> trees;
  sim2d::CsvTable table(*text, path, problems);
  if (!table.readColumns(kCoverageColumns)) {
    return problems;
  }
  const auto count = [&](std::size_t column) {
    const std::optional<long long> number = base::parseInt(table[column].text);
    if (!number || *number < 0) {
      table.error(column, "trees.bad-coverage");
    }
    return static_cast<std::size_t>(std::max(0LL, number.value_or(0)));
  };
  std::string last;  // number of the last tree
  while (table.next()) {
    if (trees.empty() || table[1].text != last) {
      last = table[1].text;
      trees.push_back({table[0].text, table[2].text, count(3), {}});
    }
    trees.back().nodes.push_back({table[4].text, count(6), count(7), count(8), count(9), count(5)});
  }
  return base::resultOf(std::move(trees), std::move(problems));
}

}  // namespace app
