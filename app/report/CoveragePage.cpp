#include "app/report/CoveragePage.h"

#include <algorithm>
#include <filesystem>

#include "app/report/Figure.h"
#include "app/report/Markup.h"
#include "app/report/Methods.h"
#include "app/report/PageParts.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

using app::SearchedRun;
using app::SearchedTree;
using app::SearchStudy;

constexpr double kCoverageWidth = 720.0;  // [px]

struct NodeCounts {
  std::size_t nodes = 0, reached = 0, missing = 0, unreachable = 0;
};

NodeCounts nodeCounts(const SearchStudy& study) {
  NodeCounts counts;
  for (const SearchedTree& tree : study.result.coverage.trees()) {
    counts.nodes += tree.counts.nodes.size();
    counts.reached += tree.counts.executedNodes();
    counts.missing += tree.missing();
    counts.unreachable += tree.unreachable();
  }
  return counts;
}

std::string shareText(std::size_t part, std::size_t whole) {
  return percentText(static_cast<double>(part) /
                     static_cast<double>(std::max<std::size_t>(1, whole)));
}

/// Paths of a tree's nodes for which `isShown` says so.
template <class Shown>
std::string nodeList(const SearchedTree& tree, const Shown& isShown) {
  std::vector<std::string> paths;
  for (std::size_t node = 0; node < tree.firstRuns.size(); ++node) {
    if (isShown(node)) {
      paths.push_back(tree.counts.nodes[node].path);
    }
  }
  return paths.empty() ? std::string("–") : base::join(paths, ", ");
}

Table treesTable(const SearchStudy& study) {
  Table table{
      "trees",
      "Behaviour trees over all runs; equal trees are one. A node is reached if it was executed at "
      "least once. Unreachable: the structure of the tree proves that it never is.",
      {{"Tree", {}, true},
       {"Trees of", {}, false},
       {"Scenarios", {}, false},
       {"Runs", {}, true},
       {"Nodes", {}, true},
       {"Reached", {}, true},
       {"Unreachable", {}, false},
       {"Last new node in run", {}, true}},
      {}};
  const std::vector<SearchedTree>& trees = study.result.coverage.trees();
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const SearchedTree& tree = trees[k];
    const std::size_t reached = tree.counts.executedNodes();
    const auto last = std::max_element(tree.firstRuns.begin(), tree.firstRuns.end());
    table.rows.push_back(
        {{std::to_string(k + 1)},
         {tree.counts.owners},
         {base::join(tree.scenarios, ", ")},
         {std::to_string(tree.counts.runs)},
         {std::to_string(tree.counts.nodes.size())},
         {std::to_string(reached),
          shareText(reached, tree.counts.nodes.size() - tree.unreachable())},
         {nodeList(tree, [&](std::size_t node) { return tree.counts.nodes[node].isUnreachable; })},
         {last != tree.firstRuns.end() && *last ? std::to_string(**last) : std::string("–")}});
  }
  return table;
}

Table neverTable(const SearchStudy& study) {
  Table table{"never",
              "Nodes that no run has reached, although nothing proves that it is impossible.",
              {{"Tree", {}, true}, {"Trees of", {}, false}, {"Node", {}, false}},
              {}};
  const std::vector<SearchedTree>& trees = study.result.coverage.trees();
  for (std::size_t k = 0; k < trees.size(); ++k) {
    for (std::size_t node = 0; node < trees[k].firstRuns.size(); ++node) {
      if (trees[k].isMissing(node)) {
        table.rows.push_back({{std::to_string(k + 1)},
                              {trees[k].counts.owners},
                              {trees[k].counts.nodes[node].path}});
      }
    }
  }
  return table;
}

/// The runs that reached a node first.
Table coveringTable(const SearchStudy& study) {
  Table table{
      "archive",
      "The archive: runs that reached a node before all others, with the command that plays each "
      "in the window; hunavsim run with the same arguments repeats it without the window.",
      {{"Run", {}, true},
       {"Scenario", {}, false},
       {"Seed", {}, true},
       {"New nodes", {}, true},
       {"End", {}, false},
       {"Play", {}, false}},
      {}};
  for (const std::size_t number : study.result.coveringRuns()) {
    const SearchedRun& run = study.result.runs[number];
    table.rows.push_back({{std::to_string(number)},
                          {study.space->scenarioName(run.candidate)},
                          {std::to_string(study.space->seedOf(run.candidate))},
                          {std::to_string(run.newNodes)},
                          {run.reason},
                          commandCell(searchedRunCommand(study, number, app::RunUse::Play))});
  }
  return table;
}

Table nodesTable(const SearchStudy& study) {
  Table table{"nodes",
              "Nodes that were reached, with the first run that did.",
              {{"Tree", {}, true},
               {"Node", {}, false},
               {"Runs", {}, true},
               {"First run", {}, true},
               {"Play", {}, false}},
              {}};
  const std::vector<SearchedTree>& trees = study.result.coverage.trees();
  for (std::size_t k = 0; k < trees.size(); ++k) {
    for (std::size_t node = 0; node < trees[k].firstRuns.size(); ++node) {
      if (const std::optional<std::size_t> first = trees[k].firstRuns[node]) {
        table.rows.push_back({{std::to_string(k + 1)},
                              {trees[k].counts.nodes[node].path},
                              {std::to_string(trees[k].counts.nodes[node].executed)},
                              {std::to_string(*first)},
                              commandCell(searchedRunCommand(study, *first, app::RunUse::Play))});
      }
    }
  }
  return table;
}

/// The number of reached nodes after each run.
Figure coverageCourse(const SearchStudy& study) {
  constexpr double kLeft = 60.0, kTop = 10.0, kHeight = 160.0;
  Figure figure("course", kCoverageWidth, kTop + kHeight + 40.0);
  figure.caption = "Reached nodes of all trees after each run.";
  const std::vector<SearchedRun>& runs = study.result.runs;
  const double reached = std::max(1.0, static_cast<double>(nodeCounts(study).reached));
  const Scale across{0.0, std::max(1.0, static_cast<double>(runs.size()) - 1.0), kLeft,
                     kCoverageWidth - 10.0};
  const Scale up = paddedScale(0.0, reached, kTop + kHeight, kTop);
  std::vector<base::Vec2> points;
  std::size_t sum = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    sum += runs[k].newNodes;
    points.emplace_back(across.at(static_cast<double>(k)), up.at(static_cast<double>(sum)));
  }
  verticalAxis(figure, up, ticks(0.0, up.high, 5), kLeft, kCoverageWidth - 10.0);
  horizontalAxis(figure, across, kTop + kHeight);
  figure.polyline(points, strokeOf(0), 1.5);
  return figure;
}

std::string coverageLead(const SearchStudy& study) {
  const app::SearchResult& result = study.result;
  const NodeCounts counts = nodeCounts(study);
  std::string text = counted(result.runs.size(), "run") + "; " + std::to_string(counts.reached) +
                     " of " + counted(counts.nodes - counts.unreachable, "reachable node") +
                     " in " + counted(result.coverage.trees().size(), "behaviour tree") + " (" +
                     shareText(counts.reached, counts.nodes - counts.unreachable) + ").";
  if (result.notSimulated > 0) {
    text += " " + counted(result.notSimulated, "run") + " could not start: " + result.firstProblem;
  }
  return text;
}

constexpr const char* kCoverageMethods =
    "Candidates: CMA-ES with restarts (Hansen, arXiv:1604.00772) and the improvement emitter of "
    "CMA-ME (Fontaine et al. 2020, arXiv:1912.02400) over the continuous values; lists and seeds "
    "change at random. The fitness of a run is the sum of 1/(number of runs so far that have "
    "executed the node) over the nodes that it executes, in trees with unreached nodes. New "
    "batches start near runs that reached a node first. coverage.csv contains all nodes; "
    "hunavsim trees FILE --picture tree.svg --coverage DIR draws a tree.";

}  // namespace

std::string coveragePage(const SearchStudy& study, const std::vector<std::string>& command) {
  const std::string title =
      "Coverage of " + std::filesystem::path(study.experiment->path).filename().string();
  PageParts page;
  page.section("trees", "Trees");
  if (study.result.coverage.trees().empty()) {
    page.body += paragraph("No run has a behaviour tree.");
    return page.page(title, coverageLead(study), {});
  }
  page.add(treesTable(study));
  page.section("never", "Never reached");
  if (nodeCounts(study).missing == 0) {
    page.body += paragraph("All nodes that can be reached were reached.");
  } else {
    page.add(neverTable(study));
  }
  page.section("archive", "Runs");
  page.add(coveringTable(study));
  page.section("course", "Course");
  page.add(coverageCourse(study));
  page.section("nodes", "Nodes");
  page.add(nodesTable(study));
  page.section("methods", "Methods");
  page.body += paragraph(kCoverageMethods) + provenanceMarkup({}, command);
  return page.page(title, coverageLead(study), {});
}

}  // namespace report
