#include "bt/human/AgentTreeCheck.h"

#include <algorithm>
#include <functional>
#include <set>
#include <string_view>
#include <utility>

#include "bt/human/Ports.h"
#include "bt/tree/TextValue.h"
#include "sim2d/base/Problems.h"

namespace bt {

using base::Diagnostics;

namespace {

using Visit = std::function<void(const NodeSpec& node, const std::string& file)>;

/// All nodes of the tree that is run and of those it calls, each tree once.
class Walk {
 public:
  Walk(const TreeTable& table, Visit visit) : table_(table), visit_(std::move(visit)) {}

  void enter(const std::string& treeId) {
    const TreeTable::Entry* entry = table_.find(treeId);
    if (entry && seen_.insert(treeId).second) {
      visit(entry->tree.root, entry->file);
    }
  }

 private:
  void visit(const NodeSpec& node, const std::string& file) {
    visit_(node, file);
    for (const NodeSpec& child : node.children) {
      visit(child, file);
    }
    if (node.isSubTree()) {
      enter(node.subTree);
    }
  }

  const TreeTable& table_;
  Visit visit_;
  std::set<std::string> seen_;
};

void walkMain(const TreeTable& table, const Visit& visit) {
  Walk(table, visit).enter(table.mainTree);
}

class Checker {
 public:
  Checker(const sim2d::Scenario& scenario, const NodeCatalogue& catalogue)
      : scenario_(scenario), catalogue_(catalogue) {}

  void check(const NodeSpec& node, const std::string& file) {
    const NodeManifest* manifest = catalogue_.find(node.id);
    if (!manifest || manifest->origin == NodeOrigin::BehaviorTreeCpp) {
      return;
    }
    for (const Attribute& port : node.ports) {
      const PortSpec* spec = manifest->port(port.name);
      if (spec && spec->direction == PortDirection::Input && !referencedKey(port.text, port.name)) {
        checkPort(node, port, file);
      }
    }
  }
  Diagnostics take() { return std::move(found_); }

 private:
  void checkPort(const NodeSpec& node, const Attribute& port, const std::string& file) {
    if (isPersonPort(port.name)) {
      for (const int id : parseIds(port.text).value_or(std::vector<int>{})) {
        if (!scenario_.humanById(id)) {
          warn(node, file, "tree.no-person", {id});
        }
      }
    } else if (port.name == "goal_id") {
      const std::optional<int> id = intFromText(port.text);
      if (id && !scenario_.goal(*id)) {
        warn(node, file, "tree.no-goal", {*id});
      }
    } else if (port.name == "area") {
      checkArea(node, port.text, file);
    } else if (port.name == "weights") {
      checkWeights(node, port.text, file);
    }
  }

  void checkWeights(const NodeSpec& node, const std::string& text, const std::string& file) {
    const std::optional<std::vector<double>> weights = parseWeights(text);
    if (!weights) {
      warn(node, file, "tree.weights-not-numbers", {text});
    } else if (weights->size() != node.children.size()) {
      warn(node, file, "tree.weights-count", {node.children.size(), weights->size()});
    }
  }

  void checkArea(const NodeSpec& node, const std::string& name, const std::string& file) {
    const auto hasName = [&name](const sim2d::Area& area) { return area.name == name; };
    if (!name.empty() && std::none_of(scenario_.areas.begin(), scenario_.areas.end(), hasName)) {
      warn(node, file, "tree.no-area", {name});
    }
  }

  void warn(const NodeSpec& node, const std::string& file, std::string_view code,
            base::ProblemValues values) {
    found_.push_back(
        base::within(node.label(), base::warning(code, std::move(values), file, node.line)));
  }

  const sim2d::Scenario& scenario_;
  const NodeCatalogue& catalogue_;
  Diagnostics found_;
};

std::string listText(const std::vector<int>& ids) {
  std::string text;
  for (const int id : ids) {
    text += (text.empty() ? "" : ", ") + std::to_string(id);
  }
  return "[" + text + "]";
}

}  // namespace

std::vector<int> goalsOfTree(const TreeTable& table) {
  std::vector<int> goals;
  walkMain(table, [&goals](const NodeSpec& node, const std::string&) {
    const std::string* text = node.id == "SetGoal" ? findText(node.ports, "goal_id") : nullptr;
    const std::optional<int> id = text ? intFromText(*text) : std::nullopt;
    if (id) {
      goals.push_back(*id);
    }
  });
  return goals;
}

Diagnostics checkAgentTree(const TreeTable& table, const sim2d::Human& human,
                           const sim2d::Scenario& scenario, const NodeCatalogue& catalogue) {
  Checker checker(scenario, catalogue);
  walkMain(table, [&checker](const NodeSpec& node, const std::string& file) {
    checker.check(node, file);
  });
  Diagnostics found = checker.take();
  const std::vector<int> goals = goalsOfTree(table);
  if (!goals.empty() && goals != human.goals) {
    found.push_back(base::warning(
        "tree.other-goals", {human.name, listText(goals), listText(human.goals)}, table.file));
  }
  for (base::Diagnostic& diagnostic : found) {
    diagnostic.entity = human.key;
  }
  return found;
}

}  // namespace bt
