#include "bt/tree/TreeSpec.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "bt/tree/NodeCatalogue.h"
#include "bt/tree/XmlText.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace bt {

const std::string* findAttribute(const Attributes& attributes, std::string_view name) {
  const Attribute* const found = base::findBy(attributes, &Attribute::name, name);
  return found != nullptr ? &found->text : nullptr;
}

void setAttribute(Attributes& attributes, std::string_view name, std::string text) {
  if (Attribute* const found = base::findBy(attributes, &Attribute::name, name)) {
    found->text = std::move(text);
  } else {
    attributes.push_back({std::string(name), std::move(text)});
  }
}

void removeAttribute(Attributes& attributes, std::string_view name) {
  attributes.erase(std::remove_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& a) { return a.name == name; }),
                   attributes.end());
}

const std::string& NodeSpec::label() const {
  if (!name.empty()) {
    return name;
  }
  return isSubTree() && !subTree.empty() ? subTree : id;
}

bool operator==(const NodeSpec& a, const NodeSpec& b) {
  const auto own = [](const NodeSpec& n) {
    return std::tie(n.id, n.subTree, n.name, n.ports, n.conditions, n.autoRemap, n.others);
  };
  return own(a) == own(b) && a.children == b.children;
}

bool operator==(const TreeSpec& a, const TreeSpec& b) {
  return a.id == b.id && a.others == b.others && a.root == b.root;
}

bool operator==(const Include& a, const Include& b) {
  return a.path == b.path && a.rosPackage == b.rosPackage;
}

bool operator==(const XmlElement& a, const XmlElement& b) {
  return std::tie(a.tag, a.attributes, a.text, a.children) ==
         std::tie(b.tag, b.attributes, b.text, b.children);
}

bool operator==(const TreeFile& a, const TreeFile& b) {
  const auto all = [](const TreeFile& f) {
    return std::tie(f.mainTree, f.includes, f.trees, f.model, f.blocks);
  };
  return all(a) == all(b);
}

const TreeSpec* TreeFile::find(std::string_view treeId) const {
  return base::findBy(trees, &TreeSpec::id, treeId);
}

TreeSpec* TreeFile::find(std::string_view treeId) {
  return const_cast<TreeSpec*>(std::as_const(*this).find(treeId));
}

const TreeTable::Entry* TreeTable::find(std::string_view treeId) const {
  const auto place = entries.find(treeId);
  return place == entries.end() ? nullptr : &place->second;
}

const NodeSpec* nodeAt(const TreeSpec& tree, const NodePath& path) {
  if (tree.root.id.empty()) {
    return nullptr;
  }
  const NodeSpec* node = &tree.root;
  for (const int index : path) {
    if (index < 0 || static_cast<std::size_t>(index) >= node->children.size()) {
      return nullptr;
    }
    node = &node->children[static_cast<std::size_t>(index)];
  }
  return node;
}

NodeSpec* nodeAt(TreeSpec& tree, const NodePath& path) {
  return const_cast<NodeSpec*>(nodeAt(std::as_const(tree), path));
}

std::optional<std::string> referencedKey(std::string_view text, std::string_view portName) {
  if (text == "=") {
    return std::string(portName);
  }
  const std::string inner = base::trimmed(text);
  if (inner.size() < 3 || inner.front() != '{' || inner.back() != '}') {
    return std::nullopt;
  }
  const std::string key = inner.substr(1, inner.size() - 2);
  return key == "=" ? std::string(portName) : key;
}

std::vector<std::string> uniqueChildLabels(const std::vector<NodeSpec>& children) {
  std::map<std::string, int> total;
  for (const NodeSpec& child : children) {
    ++total[child.label()];
  }
  std::map<std::string, int> seen;
  std::vector<std::string> names;
  names.reserve(children.size());
  for (const NodeSpec& child : children) {
    const std::string& label = child.label();
    names.push_back(total[label] == 1 ? label : label + "[" + std::to_string(++seen[label]) + "]");
  }
  return names;
}

namespace {

constexpr std::size_t kShownLabel = 80;         // characters of a name in a message
constexpr std::size_t kMaxIssues = 500;         // per tree
constexpr std::size_t kMaxNamesCompared = 500;  // limit for the search of a similar tree ID

std::optional<std::string> nearestTree(const std::string& id, const TreeIds& ids) {
  return ids.size() > kMaxNamesCompared
             ? std::nullopt
             : base::nearestName(id, std::vector<std::string>(ids.begin(), ids.end()));
}

/// Traverses one tree and reports its problems.
class Checker {
 public:
  Checker(const TreeSpec& tree, const NodeCatalogue& catalogue, const TreeIds& treeIds,
          const std::string& fileName, const TreeIds& declaredNodes)
      : tree_(tree),
        catalogue_(catalogue),
        treeIds_(treeIds),
        fileName_(fileName),
        declaredNodes_(declaredNodes) {}

  TreeIssues run();

 private:
  void report(base::Diagnostic problem) {
    issues_.push_back({std::move(problem), tree_.id, path_});
  }
  void error(const NodeSpec& node, std::string_view code, base::ProblemValues values = {}) {
    report(base::withContext(where(), base::error(code, std::move(values), fileName_, node.line)));
  }
  void warn(const NodeSpec& node, std::string_view code, base::ProblemValues values = {}) {
    report(
        base::withContext(where(), base::warning(code, std::move(values), fileName_, node.line)));
  }
  std::string where() const;
  void visit(const NodeSpec& node);
  void checkUnknown(const NodeSpec& node);
  void checkSubTree(const NodeSpec& node);
  void checkChildren(const NodeSpec& node, const NodeManifest& manifest);
  void checkPorts(const NodeSpec& node, const NodeManifest& manifest);
  static bool isLacking(const NodeSpec& node, const PortSpec& port);
  void checkPort(const NodeSpec& node, const Attribute& given, const PortSpec& port);
  void checkRange(const NodeSpec& node, const Attribute& given, const PortSpec& port);
  void checkUnknownAttributes(const NodeSpec& node);

  const TreeSpec& tree_;
  const NodeCatalogue& catalogue_;
  const TreeIds& treeIds_;
  const std::string& fileName_;
  const TreeIds& declaredNodes_;
  NodePath path_;
  std::vector<const NodeSpec*> parents_;
  std::set<std::string> subTreeNames_;
  TreeIssues issues_;
};

TreeIssues Checker::run() {
  if (catalogue_.find(tree_.id)) {
    report(base::error("tree.id-is-node", {tree_.id}, fileName_, tree_.line));
  }
  if (tree_.root.id.empty()) {
    report(base::error("tree.empty", {tree_.id}, fileName_, tree_.line));
  } else {
    visit(tree_.root);
  }
  return std::move(issues_);
}

/// "Tree/Fallback/Sequence", the path to the node.
std::string Checker::where() const {
  std::string text = tree_.id;
  const std::size_t shown = 8;  // only the end of a deep path
  const std::size_t first = parents_.size() > shown ? parents_.size() - shown : 0;
  text += first > 0 ? "/…" : "";
  for (std::size_t i = first; i < parents_.size(); ++i) {
    text += "/" + parents_[i]->label().substr(0, kShownLabel);
  }
  return text;
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
  checkUnknownAttributes(node);
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    path_.push_back(static_cast<int>(i));
    visit(node.children[i]);
    path_.pop_back();
  }
  parents_.pop_back();
}

void Checker::checkUnknown(const NodeSpec& node) {
  if (isVersion3Name(node.id)) {
    error(node, "tree.node-of-format-three", {node.id});
  } else if (treeIds_.count(node.id) > 0) {
    error(node, "tree.node-is-tree", {node.id});
  } else if (declaredNodes_.count(node.id) > 0) {
    error(node, "tree.node-only-declared", {node.id});
  } else {
    error(node, "tree.unknown-node", {node.id, catalogue_.nearest(node.id)});
  }
}

void Checker::checkSubTree(const NodeSpec& node) {
  if (treeIds_.count(node.subTree) == 0) {
    error(node, "tree.unknown-subtree", {node.subTree, nearestTree(node.subTree, treeIds_)});
  }
  if (!node.name.empty() && !subTreeNames_.insert(node.name).second) {
    error(node, "tree.subtree-name-twice", {node.name});
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
    error(node, "tree.child-count",
          {node.id, std::to_string(count) + (count == 1 ? " child" : " children"), wanted});
  }
  if (node.id == "ReactiveSequence") {
    const auto asynchronous =
        std::count_if(node.children.begin(), node.children.end(),
                      [](const NodeSpec& child) { return child.id == "AsyncSequence"; });
    if (asynchronous > 1) {
      error(node, "tree.async-twice");
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
      names.push_back(port.key);
    }
    warn(node, "tree.unknown-port", {node.id, given.name, base::nearestName(given.name, names)});
  }
  for (const PortSpec& port : manifest.ports) {
    if (isLacking(node, port)) {
      warn(node, "tree.port-missing",
           {port.key, node.id,
            port.suggested.empty() ? port.help : "for example " + port.suggested});
    }
  }
}

/// Whether a required port is absent and not replaced by other ports.
bool Checker::isLacking(const NodeSpec& node, const PortSpec& port) {
  if (port.fallbackText() || findAttribute(node.ports, port.key)) {
    return false;
  }
  const auto isAbsent = [&node](const std::string& other) {
    return !findAttribute(node.ports, other);
  };
  return port.required || std::any_of(port.replacedBy.begin(), port.replacedBy.end(), isAbsent);
}

void Checker::checkPort(const NodeSpec& node, const Attribute& given, const PortSpec& port) {
  if (referencedKey(given.text, port.key)) {
    return;
  }
  if (!isConvertible(given.text, port.portType)) {  // also for an output, as in BehaviorTree.CPP
    error(node, "tree.port-type", {given.name, given.text, portTypeName(port.portType)});
    return;
  }
  if (port.direction == PortDirection::Output) {
    warn(node, "tree.output-not-key", {given.name, given.text, "{key}"});
    return;
  }
  if (const std::optional<double> read = partiallyReadNumber(given.text, port.portType)) {
    warn(node, "tree.number-cut", {given.name, given.text, *read});
  }
  checkRange(node, given, port);
}

void Checker::checkRange(const NodeSpec& node, const Attribute& given, const PortSpec& port) {
  const bool isNumber = port.portType == PortType::Double || port.portType == PortType::Int ||
                        port.portType == PortType::Unsigned;
  if (!isNumber) {
    return;
  }
  const double value = *doubleFromText(given.text);
  if (value < port.range.low) {
    warn(node, "tree.port-too-low", {given.name, given.text, port.range.low});
  } else if (value > port.range.high) {
    warn(node, "tree.port-too-high", {given.name, given.text, port.range.high});
  }
}

/// Reports mistyped conditions, which would otherwise be ignored silently.
void Checker::checkUnknownAttributes(const NodeSpec& node) {
  std::vector<std::string> names(kConditionNames.begin(), kConditionNames.end());
  names.emplace_back("_autoremap");
  for (const Attribute& other : node.others) {
    const std::optional<std::string> near = base::nearestName(other.name, names);
    if (near) {
      warn(node, "tree.unknown-attribute", {other.name, near});
    }
  }
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

TreeIssues checkTree(const TreeSpec& tree, const NodeCatalogue& catalogue, const TreeIds& treeIds,
                     const std::string& fileName, const TreeIds& declaredNodes) {
  return Checker(tree, catalogue, treeIds, fileName, declaredNodes).run();
}

}  // namespace bt
