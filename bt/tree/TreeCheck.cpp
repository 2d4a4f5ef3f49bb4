#include <algorithm>
#include <set>
#include <utility>

#include "bt/tree/TextValue.h"
#include "bt/tree/TreeSpec.h"
#include "bt/tree/TreeXmlV3.h"
#include "bt/tree/XmlText.h"
#include "sim2d/base/Text.h"

namespace bt {
namespace {

std::string meant(const std::optional<std::string>& name) {
  return name ? " (did you mean '" + *name + "'?)" : std::string();
}

using TreeIds = std::set<std::string, std::less<>>;

constexpr std::size_t kMaxIssues = 500;         // of one tree; nobody reads more
constexpr std::size_t kMaxNamesCompared = 500;  // when a nearest tree ID is looked for

std::optional<std::string> nearestTree(const std::string& id, const TreeIds& ids) {
  return ids.size() > kMaxNamesCompared
             ? std::nullopt
             : base::nearestName(id, std::vector<std::string>(ids.begin(), ids.end()));
}

TreeIds idsOf(const TreeTable& table) {
  TreeIds ids;
  for (const auto& [id, entry] : table.entries) {
    ids.insert(id);
  }
  return ids;
}

/// Walks one tree and notes what is wrong with it.
class Checker {
 public:
  Checker(const TreeSpec& tree, const NodeCatalogue& catalogue, const TreeIds& treeIds,
          const std::string& fileName)
      : tree_(tree), catalogue_(catalogue), treeIds_(treeIds), fileName_(fileName) {}

  TreeIssues run();

 private:
  void report(base::Severity severity, int line, const std::string& message) {
    TreeIssue issue{{severity, fileName_, line, 0, message, {}}, tree_.id, path_};
    issues_.push_back(std::move(issue));
  }
  void error(const NodeSpec& node, const std::string& message) {
    report(base::Severity::Error, node.line, where() + message);
  }
  void warn(const NodeSpec& node, const std::string& message) {
    report(base::Severity::Warning, node.line, where() + message);
  }
  std::string where() const;
  void visit(const NodeSpec& node);
  void checkUnknown(const NodeSpec& node);
  void checkSubTree(const NodeSpec& node);
  void checkChildren(const NodeSpec& node, const NodeManifest& manifest);
  void checkPorts(const NodeSpec& node, const NodeManifest& manifest);
  void checkPort(const NodeSpec& node, const Attribute& given, const PortSpec& port);
  void checkRange(const NodeSpec& node, const Attribute& given, const PortSpec& port);
  void checkOthers(const NodeSpec& node);

  const TreeSpec& tree_;
  const NodeCatalogue& catalogue_;
  const TreeIds& treeIds_;
  const std::string& fileName_;
  NodePath path_;
  std::vector<const NodeSpec*> parents_;
  std::set<std::string> subTreeNames_;
  TreeIssues issues_;
};

TreeIssues Checker::run() {
  if (catalogue_.find(tree_.id)) {
    report(base::Severity::Error, tree_.line,
           "tree ID '" + tree_.id + "' is the name of a node (choose another ID)");
  }
  if (tree_.root.id.empty()) {
    report(base::Severity::Error, tree_.line, "tree '" + tree_.id + "' has no node (put one in)");
  } else {
    visit(tree_.root);
  }
  return std::move(issues_);
}

/// "Tree/Fallback/Sequence: ", the way down to the node.
std::string Checker::where() const {
  std::string text = tree_.id;
  const std::size_t shown = 8;  // of a deep tree only the end
  const std::size_t first = parents_.size() > shown ? parents_.size() - shown : 0;
  text += first > 0 ? "/…" : "";
  for (std::size_t i = first; i < parents_.size(); ++i) {
    text += "/" + parents_[i]->label();
  }
  return text + ": ";
}

void Checker::visit(const NodeSpec& node) {
  if (issues_.size() >= kMaxIssues) {
    return;
  }
  parents_.push_back(&node);
  const NodeManifest* const manifest = catalogue_.find(node.id);
  if (!manifest) {
    checkUnknown(node);
  } else {
    checkChildren(node, *manifest);
    if (node.isSubTree()) {
      checkSubTree(node);
    } else {
      checkPorts(node, *manifest);
    }
  }
  checkOthers(node);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    path_.push_back(static_cast<int>(i));
    visit(node.children[i]);
    path_.pop_back();
  }
  parents_.pop_back();
}

void Checker::checkUnknown(const NodeSpec& node) {
  if (isVersion3Name(node.id)) {
    error(node, "node '" + node.id + "' is of format 3 (remove BTCPP_format=\"4\" to convert it)");
    return;
  }
  const bool isTree = treeIds_.count(node.id) > 0;
  const std::string hint = isTree ? " (write <SubTree ID=\"" + node.id + "\"/> to run that tree)"
                                  : meant(catalogue_.nearest(node.id));
  error(node, "unknown node '" + node.id + "'" + hint);
}

void Checker::checkSubTree(const NodeSpec& node) {
  if (treeIds_.count(node.subTree) == 0) {
    error(node,
          "there is no tree '" + node.subTree + "'" + meant(nearestTree(node.subTree, treeIds_)));
  }
  if (!node.name.empty() && !subTreeNames_.insert(node.name).second) {
    error(node, "two SubTrees of this tree have the name '" + node.name + "' (rename one)");
  }
}

void Checker::checkChildren(const NodeSpec& node, const NodeManifest& manifest) {
  const int count = static_cast<int>(node.children.size());
  const int least = manifest.minChildren;
  const int most = manifest.maxChildren;
  if (count < least || (most >= 0 && count > most)) {
    std::string wanted = std::to_string(least);
    if (most < 0) {
      wanted += " or more";
    } else if (most != least) {
      wanted += " to " + std::to_string(most);
    }
    error(node,
          "'" + node.id + "' has " + std::to_string(count) + " children (needs " + wanted + ")");
  }
  if (node.id == "ReactiveSequence") {
    const auto asynchronous =
        std::count_if(node.children.begin(), node.children.end(),
                      [](const NodeSpec& child) { return child.id == "AsyncSequence"; });
    if (asynchronous > 1) {
      error(node, "a ReactiveSequence can hold one AsyncSequence only (use Sequence)");
    }
  }
}

void Checker::checkPorts(const NodeSpec& node, const NodeManifest& manifest) {
  for (const Attribute& given : node.ports) {
    if (const PortSpec* const port = manifest.port(given.name)) {
      checkPort(node, given, *port);
      continue;
    }
    std::vector<std::string> names;
    for (const PortSpec& port : manifest.ports) {
      names.push_back(port.name);
    }
    warn(node, "'" + node.id + "' has no port '" + given.name + "'" +
                   meant(base::nearestName(given.name, names)));
  }
  for (const PortSpec& port : manifest.ports) {
    if (port.required && !port.defaultText && !findText(node.ports, port.name)) {
      warn(node, "port '" + port.name + "' of '" + node.id + "' is missing (" +
                     (port.suggested.empty() ? port.description : "e.g. " + port.suggested) + ")");
    }
  }
}

void Checker::checkPort(const NodeSpec& node, const Attribute& given, const PortSpec& port) {
  if (referencedKey(given.text, port.name)) {
    return;
  }
  if (port.direction == PortDirection::Output) {
    warn(node, "output port '" + given.name + "' is '" + given.text +
                   "', so nothing is written (use {key})");
    return;
  }
  if (!isConvertible(given.text, port.type)) {
    error(node, "port '" + given.name + "' is '" + given.text + "', which is no " +
                    portTypeName(port.type));
    return;
  }
  checkRange(node, given, port);
}

void Checker::checkRange(const NodeSpec& node, const Attribute& given, const PortSpec& port) {
  const bool isNumber = port.type == PortType::Double || port.type == PortType::Int ||
                        port.type == PortType::Unsigned;
  if (!isNumber) {
    return;
  }
  const double value = *doubleFromText(given.text);
  if (port.min && value < *port.min) {
    warn(node, "port '" + given.name + "' is " + given.text + ", less than " +
                   base::formatDouble(*port.min));
  } else if (port.max && value > *port.max) {
    warn(node, "port '" + given.name + "' is " + given.text + ", more than " +
                   base::formatDouble(*port.max));
  }
}

/// A condition that was mistyped would be ignored without a word.
void Checker::checkOthers(const NodeSpec& node) {
  const std::vector<std::string> names = {"_failureIf", "_successIf", "_skipIf",
                                          "_while",     "_onSuccess", "_onFailure",
                                          "_post",      "_onHalted",  "_autoremap"};
  for (const Attribute& other : node.others) {
    const std::optional<std::string> near = base::nearestName(other.name, names);
    if (near) {
      warn(node, "attribute '" + other.name + "' has no meaning" + meant(near));
    }
  }
}

/// Looks for SubTrees that contain themselves.
class RecursionFinder {
 public:
  explicit RecursionFinder(const TreeTable& table) : table_(table) {}

  void visit(const TreeTable::Entry& entry);
  TreeIssues takeIssues() { return std::move(issues_); }

 private:
  void visit(const NodeSpec& node, const TreeTable::Entry& entry, NodePath& path);

  const TreeTable& table_;
  std::set<std::string> open_;
  std::set<std::string> done_;
  TreeIssues issues_;
  int depth_ = 0;
};

void RecursionFinder::visit(const TreeTable::Entry& entry) {
  constexpr int kMaxSubTreeDepth = 200;
  if (done_.count(entry.tree.id) > 0) {
    return;
  }
  if (depth_ >= kMaxSubTreeDepth) {
    issues_.push_back(
        {base::makeError("SubTrees are nested deeper than " + std::to_string(kMaxSubTreeDepth),
                         entry.file, entry.tree.line),
         entry.tree.id,
         {}});
    return;
  }
  ++depth_;
  open_.insert(entry.tree.id);
  NodePath path;
  visit(entry.tree.root, entry, path);
  open_.erase(entry.tree.id);
  done_.insert(entry.tree.id);
  --depth_;
}

void RecursionFinder::visit(const NodeSpec& node, const TreeTable::Entry& entry, NodePath& path) {
  if (node.isSubTree()) {
    const TreeTable::Entry* const called = table_.find(node.subTree);
    if (called && open_.count(node.subTree) > 0) {
      issues_.push_back({base::makeError("tree '" + node.subTree + "' contains itself (in tree '" +
                                             entry.tree.id + "')",
                                         entry.file, node.line),
                         entry.tree.id, path});
    } else if (called) {
      visit(*called);
    }
  }
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    path.push_back(static_cast<int>(i));
    visit(node.children[i], entry, path);
    path.pop_back();
  }
}

void append(TreeIssues& to, TreeIssues more) {
  to.insert(to.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Keys that are read, and keys that the trees give a value themselves.
void collectKeys(const NodeSpec& node, std::set<std::string>& read,
                 std::set<std::string>& written) {
  for (const Attribute& port : node.ports) {
    const std::optional<std::string> key = referencedKey(port.text, port.name);
    if (node.id == "SetBlackboard" && port.name == "output_key") {
      written.insert(key.value_or(port.text));
    } else if (key) {
      read.insert(*key);
    }
    if (node.isSubTree()) {
      written.insert(port.name);
    }
  }
  for (const NodeSpec& child : node.children) {
    collectKeys(child, read, written);
  }
}

base::Diagnostics fileProblems(const TreeTable& table) {
  base::Diagnostics problems;
  if (table.mainTree.empty()) {
    problems.push_back(
        base::makeError("which tree is to run is not said (set main_tree_to_execute)", table.file));
  } else if (!table.find(table.mainTree)) {
    problems.push_back(base::makeError("there is no tree '" + table.mainTree + "' to run" +
                                           meant(nearestTree(table.mainTree, idsOf(table))),
                                       table.file));
  }
  for (const TreeTable::TemplateText& text : table.templates) {
    problems.push_back(base::makeError(
        "{GOAL_SEQUENCE} is left over: a template, not a tree (generate the tree from it)",
        text.file, text.line));
  }
  const std::vector<std::string> placeholders = placeholdersIn(table);
  if (!placeholders.empty()) {
    std::string list;
    for (const std::string& name : placeholders) {
      list += (list.empty() ? "{" : ", {") + name + "}";
    }
    problems.push_back(base::makeWarning(
        "a tree of HuNavSim 1.5: " + list + " come from the behaviour of the agent", table.file));
  }
  return problems;
}

}  // namespace

base::Diagnostics diagnosticsOf(const TreeIssues& issues) {
  base::Diagnostics all;
  all.reserve(issues.size());
  for (const TreeIssue& issue : issues) {
    all.push_back(issue.diagnostic);
  }
  return all;
}

TreeIssues checkTree(const TreeSpec& tree, const NodeCatalogue& catalogue,
                     const std::vector<std::string>& treeIds, const std::string& fileName) {
  const TreeIds ids(treeIds.begin(), treeIds.end());
  return Checker(tree, catalogue, ids, fileName).run();
}

TreeIssues checkTrees(const TreeTable& table, const NodeCatalogue& catalogue) {
  TreeIssues issues;
  const TreeIds ids = idsOf(table);
  RecursionFinder recursion(table);
  for (const auto& [id, entry] : table.entries) {
    append(issues, Checker(entry.tree, catalogue, ids, entry.file).run());
    recursion.visit(entry);
  }
  append(issues, recursion.takeIssues());
  return issues;
}

TreeIssues checkTable(const TreeTable& table, const NodeCatalogue& catalogue) {
  TreeIssues issues;
  for (base::Diagnostic& problem : fileProblems(table)) {
    issues.push_back({std::move(problem), {}, {}});
  }
  append(issues, checkTrees(table, catalogue));
  return issues;
}

std::vector<std::string> placeholdersIn(const TreeTable& table) {
  std::set<std::string> read;
  std::set<std::string> written;
  for (const auto& [id, entry] : table.entries) {
    collectKeys(entry.tree.root, read, written);
  }
  std::vector<std::string> found;
  for (const char* const name : {"dist", "duration", "once", "maxvel", "forcefactor", "stopdist",
                                 "frontdist", "safe_distance"}) {
    if (read.count(name) > 0 && written.count(name) == 0) {
      found.emplace_back(name);
    }
  }
  return found;
}

}  // namespace bt
