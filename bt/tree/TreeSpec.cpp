#include "bt/tree/TreeSpec.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "sim2d/base/Text.h"

namespace bt {
namespace {

/// The first `count` steps of a path.
NodePath head(const NodePath& path, std::size_t count) {
  return {path.begin(), path.begin() + static_cast<std::ptrdiff_t>(count)};
}

bool startsWith(const NodePath& path, const NodePath& beginning) {
  return path.size() >= beginning.size() &&
         std::equal(beginning.begin(), beginning.end(), path.begin());
}

/// Where `path` leads once the node at `removed` is gone.
NodePath afterRemoval(NodePath path, const NodePath& removed) {
  const std::size_t last = removed.size() - 1;
  if (path.size() > last && startsWith(path, head(removed, last)) && path[last] > removed[last]) {
    --path[last];
  }
  return path;
}

template <class Visit>
void forEachNode(NodeSpec& node, const Visit& visit) {
  visit(node);
  for (NodeSpec& child : node.children) {
    forEachNode(child, visit);
  }
}

bool findUidBelow(const NodeSpec& node, int uid, NodePath& path) {
  if (node.uid == uid) {
    return true;
  }
  for (std::size_t i = 0; i < node.children.size(); ++i) {
    path.push_back(static_cast<int>(i));
    if (findUidBelow(node.children[i], uid, path)) {
      return true;
    }
    path.pop_back();
  }
  return false;
}

}  // namespace

const std::string* findText(const Attributes& attributes, std::string_view name) {
  const auto place = std::find_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& a) { return a.name == name; });
  return place == attributes.end() ? nullptr : &place->text;
}

void setText(Attributes& attributes, std::string_view name, std::string text) {
  const auto place = std::find_if(attributes.begin(), attributes.end(),
                                  [name](const Attribute& a) { return a.name == name; });
  if (place == attributes.end()) {
    attributes.push_back({std::string(name), std::move(text)});
  } else {
    place->text = std::move(text);
  }
}

void removeText(Attributes& attributes, std::string_view name) {
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

bool operator==(const XmlBlock& a, const XmlBlock& b) {
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
  const auto place = std::find_if(trees.begin(), trees.end(),
                                  [treeId](const TreeSpec& tree) { return tree.id == treeId; });
  return place == trees.end() ? nullptr : &*place;
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

bool insertNode(TreeSpec& tree, const NodePath& parent, int index, NodeSpec node) {
  if (tree.root.id.empty() && parent.empty()) {
    tree.root = std::move(node);
    return true;
  }
  NodeSpec* const to = nodeAt(tree, parent);
  if (!to) {
    return false;
  }
  const int place = std::clamp(index, 0, static_cast<int>(to->children.size()));
  to->children.insert(to->children.begin() + place, std::move(node));
  return true;
}

std::optional<NodeSpec> removeNode(TreeSpec& tree, const NodePath& path) {
  if (!nodeAt(tree, path)) {
    return std::nullopt;
  }
  if (path.empty()) {
    return std::exchange(tree.root, NodeSpec());
  }
  std::vector<NodeSpec>& siblings = nodeAt(tree, head(path, path.size() - 1))->children;
  const auto place = siblings.begin() + path.back();
  NodeSpec removed = std::move(*place);
  siblings.erase(place);
  return removed;
}

bool moveNode(TreeSpec& tree, const NodePath& from, const NodePath& parent, int index) {
  if (from.empty() || startsWith(parent, from) || !nodeAt(tree, from) || !nodeAt(tree, parent)) {
    return false;
  }
  NodePath place = parent;
  place.push_back(index);
  place = afterRemoval(std::move(place), from);
  NodeSpec node = *removeNode(tree, from);
  return insertNode(tree, head(place, place.size() - 1), place.back(), std::move(node));
}

void assignUids(TreeFile& file) {
  int largest = 0;
  for (TreeSpec& tree : file.trees) {
    forEachNode(tree.root, [&](const NodeSpec& node) { largest = std::max(largest, node.uid); });
  }
  for (TreeSpec& tree : file.trees) {
    forEachNode(tree.root, [&](NodeSpec& node) {
      if (node.uid == 0) {
        node.uid = ++largest;
      }
    });
  }
}

std::optional<NodePath> findUid(const TreeSpec& tree, int uid) {
  NodePath path;
  if (tree.root.id.empty() || !findUidBelow(tree.root, uid, path)) {
    return std::nullopt;
  }
  return path;
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

std::vector<std::string> siblingNames(const std::vector<NodeSpec>& children) {
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
