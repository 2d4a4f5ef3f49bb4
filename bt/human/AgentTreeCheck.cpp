#include "bt/human/AgentTreeCheck.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "bt/human/HumanContext.h"
#include "bt/tree/PortTextConversion.h"
#include "sim2d/base/Text.h"

namespace bt {

using base::Diagnostics;

namespace {

struct CollectedNode {
  const NodeSpec* node;
  const std::string* file;
};

/// Collects the nodes of the main tree and of the trees it calls, each tree once.
class NodeCollector {
 public:
  explicit NodeCollector(const TreeTable& table) : table_(table) { enter(table.mainTree); }
  std::vector<CollectedNode> take() { return std::move(found_); }

 private:
  void enter(const std::string& treeId) {
    const TreeTable::Entry* entry = table_.find(treeId);
    if (entry && seen_.insert(treeId).second) {
      visit(entry->tree.root, entry->file);
    }
  }
  void visit(const NodeSpec& node, const std::string& file) {
    found_.push_back({&node, &file});
    for (const NodeSpec& child : node.children) {
      visit(child, file);
    }
    if (node.isSubTree()) {
      enter(node.subTree);
    }
  }

  const TreeTable& table_;
  std::set<std::string> seen_;
  std::vector<CollectedNode> found_;
};

struct Problem {
  std::string_view code;
  base::ProblemValues values;
};

/// Checks a constant of a port that is not a list.
std::optional<Problem> problemOf(const NodeSpec& node, const Attribute& port,
                                 const sim2d::Scenario& scenario) {
  if (port.name == "goal_id") {
    const std::optional<int> id = intFromText(port.text);
    return id && !scenario.goal(*id) ? std::optional<Problem>({"tree.no-goal", {*id}})
                                     : std::nullopt;
  }
  if (port.name == "area") {
    const auto isIt = [&port](const sim2d::Area& area) { return area.name == port.text; };
    const bool exists = std::any_of(scenario.areas.begin(), scenario.areas.end(), isIt);
    return exists || port.text.empty() ? std::nullopt
                                       : std::optional<Problem>({"tree.no-area", {port.text}});
  }
  if (port.name != "weights") {
    return std::nullopt;
  }
  const std::optional<std::vector<double>> weights = parseWeights(port.text);
  if (!weights) {
    return Problem{"tree.weights-not-numbers", {port.text}};
  }
  return weights->size() == node.children.size()
             ? std::nullopt
             : std::optional<Problem>(
                   {"tree.weights-count", {node.children.size(), weights->size()}});
}

std::vector<Problem> problemsOf(const NodeSpec& node, const NodeManifest& manifest,
                                const sim2d::Scenario& scenario) {
  std::vector<Problem> problems;
  for (const Attribute& port : node.ports) {
    const PortSpec* spec = manifest.port(port.name);
    if (!spec || spec->direction != PortDirection::Input || referencedKey(port.text, port.name)) {
      continue;
    }
    if (std::optional<Problem> problem = problemOf(node, port, scenario)) {
      problems.push_back(*std::move(problem));
    }
    const bool hasIds = isAgentPort(port.name);
    for (const int id :
         hasIds ? parseIds(port.text).value_or(std::vector<int>{}) : std::vector<int>{}) {
      if (!scenario.humanById(id)) {
        problems.push_back({"tree.no-person", {id}});
      }
    }
  }
  return problems;
}

std::string listText(const std::vector<int>& ids) {
  std::vector<std::string> words;
  words.reserve(ids.size());
  for (const int id : ids) {
    words.push_back(std::to_string(id));
  }
  return "[" + base::join(words, ", ") + "]";
}

/// Goals with equal positions count as equal.
bool haveSamePositions(const std::vector<int>& a, const std::vector<int>& b,
                       const sim2d::Scenario& scenario) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&scenario](int one, int other) {
    const sim2d::GlobalGoal* const first = scenario.goal(one);
    const sim2d::GlobalGoal* const second = scenario.goal(other);
    return one == other || (first && second && first->position == second->position);
  });
}

}  // namespace

std::vector<int> treeGoals(const TreeTable& table) {
  std::vector<int> goals;
  for (const auto& [node, file] : NodeCollector(table).take()) {
    const std::string* text =
        node->id == "SetGoal" ? findAttribute(node->ports, "goal_id") : nullptr;
    const std::optional<int> id = text ? intFromText(*text) : std::nullopt;
    if (id) {
      goals.push_back(*id);
    }
  }
  return goals;
}

Diagnostics checkAgentTree(const TreeTable& table, const sim2d::Human& human,
                           const sim2d::Scenario& scenario, const NodeCatalogue& catalogue) {
  Diagnostics found;
  for (const auto& [node, file] : NodeCollector(table).take()) {
    const NodeManifest* manifest = catalogue.find(node->id);
    if (!manifest || manifest->origin == NodeOrigin::BehaviorTreeCpp) {
      continue;
    }
    for (Problem& problem : problemsOf(*node, *manifest, scenario)) {
      found.push_back(base::withContext(
          node->label(),
          base::warning(problem.code, std::move(problem.values), *file, node->line)));
    }
  }
  const std::vector<int> goals = treeGoals(table);
  if (!goals.empty() && !haveSamePositions(goals, human.goals, scenario)) {
    found.push_back(base::warning(
        "tree.other-goals", {human.name, listText(goals), listText(human.goals)}, table.file));
  }
  for (base::Diagnostic& diagnostic : found) {
    diagnostic.entity = human.key;
  }
  return found;
}

}  // namespace bt
