#include <algorithm>

#include <nlohmann/json.hpp>

#include "app/studies/SearchFields.h"
#include "app/studies/SearchStudy.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

// Files of a search that covers behaviour trees.
namespace app {

namespace {

using CoverageJson = nlohmann::ordered_json;

const char* stateName(const SearchedTree& tree, std::size_t node) {
  return tree.isReached(node) ? "reached" : tree.isMissing(node) ? "never" : "unreachable";
}

/// Paths of the nodes in this state.
CoverageJson pathsJson(const SearchedTree& tree, const std::string& state) {
  CoverageJson paths = CoverageJson::array();
  for (std::size_t node = 0; node < tree.firstRuns.size(); ++node) {
    if (stateName(tree, node) == state) {
      paths.push_back(tree.counts.nodes[node].path);
    }
  }
  return paths;
}

CoverageJson treeJson(const SearchedTree& tree, std::size_t number) {
  return {{"tree", number},
          {"owners", tree.counts.owners},
          {"scenarios", tree.scenarios},
          {"runs", tree.counts.runs},
          {"nodes", tree.counts.nodes.size()},
          {"reached", tree.counts.executedNodes()},
          {"never_reached", pathsJson(tree, "never")},
          {"unreachable", pathsJson(tree, "unreachable")}};
}

/// The nodes that this run was the first to execute.
CoverageJson foundJson(const SearchStudy& study, std::size_t run) {
  CoverageJson nodes = CoverageJson::array();
  const std::vector<SearchedTree>& trees = study.result.coverage.trees();
  for (std::size_t k = 0; k < trees.size(); ++k) {
    for (std::size_t node = 0; node < trees[k].firstRuns.size(); ++node) {
      if (trees[k].firstRuns[node] == run) {
        nodes.push_back({{"tree", k + 1}, {"node", trees[k].counts.nodes[node].path}});
      }
    }
  }
  return nodes;
}

CoverageJson coveringRunJson(const SearchStudy& study, std::size_t number) {
  CoverageJson json = searchedRunJson<CoverageJson>(study, number);
  json["new_nodes"] = study.result.runs[number].newNodes;
  json["nodes"] = foundJson(study, number);
  json["play"] = searchedRunCommand(study, number, RunUse::Play);
  json["command"] = searchedRunCommand(study, number, RunUse::Run);
  return json;
}

}  // namespace

std::string searchedRunCommand(const SearchStudy& study, std::size_t run, RunUse use) {
  std::vector<std::string> words = commandLineOf(
      specOf(study.space->requestOf(study.result.runs[run].candidate)));  // begins with "run"
  if (use == RunUse::Play) {
    words.erase(words.begin());
  }
  std::string command = "hunavsim";
  for (const std::string& word : words) {
    command += " " + base::shellWord(word);
  }
  return command;
}

std::string coverageJson(const SearchStudy& study) {
  const SearchResult& result = study.result;
  std::size_t nodes = 0, reached = 0, unreachable = 0;
  CoverageJson trees = CoverageJson::array(), archive = CoverageJson::array();
  for (const SearchedTree& tree : result.coverage.trees()) {
    nodes += tree.counts.nodes.size();
    reached += tree.counts.executedNodes();
    unreachable += tree.unreachable();
    trees.push_back(treeJson(tree, trees.size() + 1));
  }
  for (const std::size_t run : result.coveringRuns()) {
    archive.push_back(coveringRunJson(study, run));
  }
  const CoverageJson json = {{"hunavsim_search", 1},
                             {"cover", true},
                             {"search_seed", study.plan.seed},
                             {"runs", result.runs.size()},
                             {"not_simulated", result.notSimulated},
                             {"nodes", nodes},
                             {"reached", reached},
                             {"unreachable", unreachable},
                             {"complete", result.coverage.isComplete()},
                             {"trees", trees},
                             {"archive", archive}};
  return base::jsonText(json) + "\n";
}

std::string coverageCsv(const SearchStudy& study) {
  std::string text = "tree,owners,scenarios,runs,node,state,executed,first_run,command\n";
  const std::vector<SearchedTree>& trees = study.result.coverage.trees();
  for (std::size_t k = 0; k < trees.size(); ++k) {
    const SearchedTree& tree = trees[k];
    for (std::size_t node = 0; node < tree.firstRuns.size(); ++node) {
      const std::optional<std::size_t> first = tree.firstRuns[node];
      text += std::to_string(k + 1);
      addCsvField(text, tree.counts.owners);
      addCsvField(text, base::join(tree.scenarios, "; "));
      addCsvField(text, std::to_string(tree.counts.runs));
      addCsvField(text, tree.counts.nodes[node].path);
      addCsvField(text, stateName(tree, node));
      addCsvField(text, std::to_string(tree.counts.nodes[node].executed));
      addCsvField(text, first ? std::to_string(*first) : std::string());
      addCsvField(text, first ? searchedRunCommand(study, *first, RunUse::Run) : std::string());
      text += '\n';
    }
  }
  return text;
}

}  // namespace app
