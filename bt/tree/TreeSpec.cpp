#include "bt/tree/TreeSpec.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"

namespace bt {

const std::string* findAttribute(const Attributes& attributes, std::string_view name) {
  const auto place = std::find_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& a) { return a.name == name; });
  return place == attributes.end() ? nullptr : &place->text;
}

void setAttribute(Attributes& attributes, std::string_view name, std::string text) {
  const auto place = std::find_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& a) { return a.name == name; });
  if (place == attributes.end()) {
    attributes.push_back({std::string(name), std::move(text)});
  } else {
    place->text = std::move(text);
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

}  // namespace bt
