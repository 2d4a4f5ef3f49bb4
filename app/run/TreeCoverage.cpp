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
    const bool isExecuted =
        count(NodeStatus::Running) + count(NodeStatus::Success) + count(NodeStatus::Failure) > 0;
    node.executed += isExecuted ? 1 : 0;
  }
}

}  // namespace

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
    std::transform(merged[k].returned.begin(), merged[k].returned.end(),
                   std::back_inserter(row.returned), digitOf);
  }
  return rows;
}

base::Result<std::vector<CoveredTree>> treeCoverageOf(const ResultStore& store) {
  std::vector<CoveredTree> trees;
  std::map<std::pair<std::string, std::string>, std::size_t> places;  // by scenario and paths
  base::Diagnostics problems = store.forEach([&](const StoredRun& run) {
    for (const TreeRow& row : run.row.trees) {
      const auto [place, isNew] = places.emplace(std::pair(run.scenario, row.paths), trees.size());
      if (isNew) {
        trees.push_back({run.scenario, {}, 0, {}});
        for (const std::string& path : base::split(row.paths, '\n')) {
          trees.back().nodes.push_back({path});
        }
      }
      addRun(row, trees[place->second]);
    }
  });
  return base::resultOf(std::move(trees), std::move(problems));
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
