#include "editor/trees/TreeEdits.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "bt/tree/TreeXml.h"
#include "editor/document/TreeFiles.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

bt::NodeSpec* mutableNode(bt::TreeFile& file, const TreePlace& place) {
  bt::TreeSpec* tree = file.find(place.tree);
  return tree == nullptr ? nullptr : bt::nodeAt(*tree, place.path);
}

bool isTreeTaken(const bt::TreeFile& file, const std::string& id) {
  return file.find(id) != nullptr || treeCatalogue().find(id) != nullptr;
}

void forEachNode(const bt::NodeSpec& node, const std::function<void(const bt::NodeSpec&)>& see) {
  see(node);
  for (const bt::NodeSpec& child : node.children) {
    forEachNode(child, see);
  }
}

int usesOf(const bt::TreeFile& file, const std::string& tree) {
  int uses = file.mainTree == tree || file.trees.size() == 1 ? 1 : 0;
  for (const bt::TreeSpec& each : file.trees) {
    forEachNode(each.root, [&](const bt::NodeSpec& node) {
      uses += node.isSubTree() && node.subTree == tree ? 1 : 0;
    });
  }
  return uses;
}

bool runs(const bt::NodeSpec& node, const std::string& tree) {
  bool found = false;
  forEachNode(node, [&](const bt::NodeSpec& each) {
    found = found || (each.isSubTree() && each.subTree == tree);
  });
  return found;
}

/// Letters, digits and underscores of a text, for the ID of a tree.
std::string treeIdOf(const std::string& wanted) {
  std::string id;
  for (const char c : wanted) {
    const bool isWord = (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                        (c >= 'a' && c <= 'z') || c == '_' || c == '-';
    id += isWord ? std::string(1, c) : std::string();
  }
  return id.empty() ? "Tree" : id;
}

}  // namespace

TreePlace TreePlace::parent() const {
  TreePlace place = *this;
  place.path.pop_back();
  return place;
}

TreePlace TreePlace::child(int index) const {
  TreePlace place = *this;
  place.path.push_back(index);
  return place;
}

bool TreePlace::holds(const TreePlace& other) const {
  return tree == other.tree && path.size() <= other.path.size() &&
         std::equal(path.begin(), path.end(), other.path.begin());
}

const bt::NodeSpec* nodeAt(const bt::TreeFile& file, const TreePlace& place) {
  const bt::TreeSpec* tree = file.find(place.tree);
  return tree == nullptr ? nullptr : bt::nodeAt(*tree, place.path);
}

int mostChildren(const bt::NodeSpec& node) {
  if (node.isSubTree()) {
    return 0;
  }
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  return manifest == nullptr ? -1 : manifest->maxChildren;
}

bool takesChild(const bt::NodeSpec& node) {
  const int most = mostChildren(node);
  return most < 0 || static_cast<int>(node.children.size()) < most;
}

bt::NodeSpec freshNode(const std::string& id) {
  bt::NodeSpec node;
  node.id = id;
  if (const bt::NodeManifest* manifest = treeCatalogue().find(id)) {
    for (const bt::PortSpec& port : manifest->ports) {
      if (!port.suggested.empty()) {
        node.ports.push_back({port.key, port.suggested});
      }
    }
  }
  return node;
}

MaybePlace addNode(bt::TreeFile& file, const TreePlace& parent, int index, bt::NodeSpec node) {
  bt::NodeSpec* above = mutableNode(file, parent);
  if (above == nullptr || !takesChild(*above)) {
    return std::nullopt;
  }
  const int place = std::clamp(index, 0, static_cast<int>(above->children.size()));
  above->children.insert(above->children.begin() + place, std::move(node));
  return parent.child(place);
}

MaybePlace removeNode(bt::TreeFile& file, const TreePlace& place) {
  if (place.isRoot() || nodeAt(file, place) == nullptr) {
    return std::nullopt;
  }
  bt::NodeSpec& above = *mutableNode(file, place.parent());
  above.children.erase(above.children.begin() + place.path.back());
  const int left = static_cast<int>(above.children.size());
  return left == 0 ? place.parent() : place.parent().child(std::min(place.path.back(), left - 1));
}

MaybePlace moveNode(bt::TreeFile& file, const TreePlace& from, const TreePlace& parent, int index) {
  const bt::NodeSpec* node = nodeAt(file, from);
  const bt::NodeSpec* above = nodeAt(file, parent);
  if (from.isRoot() || node == nullptr || above == nullptr || from.holds(parent)) {
    return std::nullopt;
  }
  const bool staysBelow = from.parent() == parent;
  if (!staysBelow && !takesChild(*above)) {
    return std::nullopt;
  }
  if (staysBelow && (index == from.path.back() || index == from.path.back() + 1)) {
    return std::nullopt;
  }
  bt::NodeSpec moved = *node;
  bt::NodeSpec& before = *mutableNode(file, from.parent());
  before.children.erase(before.children.begin() + from.path.back());
  TreePlace to = parent;  // as it is now that the node is gone
  const std::size_t level = from.path.size() - 1;
  if (from.parent().holds(parent) && parent.path.size() > level &&
      parent.path[level] > from.path.back()) {
    --to.path[level];
  }
  const int place = staysBelow && index > from.path.back() ? index - 1 : index;
  return addNode(file, to, place, std::move(moved));
}

MaybePlace wrapNode(bt::TreeFile& file, const TreePlace& place, bt::NodeSpec around) {
  bt::NodeSpec* node = mutableNode(file, place);
  if (node == nullptr || !takesChild(around)) {
    return std::nullopt;
  }
  around.children.push_back(std::move(*node));
  *node = std::move(around);
  return place;
}

MaybePlace unwrapNode(bt::TreeFile& file, const TreePlace& place) {
  bt::NodeSpec* node = mutableNode(file, place);
  if (node == nullptr || node->children.empty()) {
    return std::nullopt;
  }
  std::vector<bt::NodeSpec> children = node->children;
  if (children.size() == 1) {
    *node = std::move(children.front());
    return place;
  }
  bt::NodeSpec* above = place.isRoot() ? nullptr : mutableNode(file, place.parent());
  if (above == nullptr || mostChildren(*above) >= 0) {  // one place for several nodes
    return std::nullopt;
  }
  const auto at = above->children.begin() + place.path.back();
  above->children.insert(above->children.erase(at), children.begin(), children.end());
  return place;
}

MaybePlace duplicateNode(bt::TreeFile& file, const TreePlace& place) {
  const bt::NodeSpec* node = nodeAt(file, place);
  return node == nullptr || place.isRoot()
             ? std::nullopt
             : addNode(file, place.parent(), place.path.back() + 1, *node);
}

MaybePlace replaceNode(bt::TreeFile& file, const TreePlace& place, const bt::NodeSpec& by) {
  bt::NodeSpec* node = mutableNode(file, place);
  const int most = mostChildren(by);
  if (node == nullptr || (most >= 0 && static_cast<int>(node->children.size()) > most)) {
    return std::nullopt;
  }
  bt::NodeSpec other = by;
  const bt::NodeManifest* manifest = treeCatalogue().find(by.id);
  for (const bt::Attribute& port : node->ports) {
    if (manifest != nullptr && manifest->port(port.name) != nullptr) {
      bt::setText(other.ports, port.name, port.text);
    }
  }
  other.name = node->name;
  other.conditions = node->conditions;
  other.others = node->others;
  other.children = std::move(node->children);
  *node = std::move(other);
  return place;
}

MaybePlace extractTree(bt::TreeFile& file, const TreePlace& place, const std::string& wanted) {
  bt::NodeSpec* node = mutableNode(file, place);
  if (node == nullptr || place.isRoot()) {
    return std::nullopt;
  }
  const std::string id = treeIdOf(wanted);
  bt::TreeSpec tree;
  tree.id = id;
  for (int number = 2; isTreeTaken(file, tree.id); ++number) {
    tree.id = id + std::to_string(number);
  }
  tree.root = std::move(*node);
  *node = {};
  node->id = "SubTree";
  node->subTree = tree.id;
  node->autoRemap = true;
  if (file.mainTree.empty() && file.trees.size() == 1) {
    file.mainTree = file.trees.front().id;  // with two trees it has to be said
  }
  file.trees.push_back(std::move(tree));
  return place;
}

MaybePlace inlineTree(bt::TreeFile& file, const TreePlace& place) {
  bt::NodeSpec* node = mutableNode(file, place);
  const bool isWhole = node != nullptr && node->isSubTree() && node->autoRemap &&
                       node->ports.empty() && node->conditions.empty();
  const bt::TreeSpec* tree = isWhole ? file.find(node->subTree) : nullptr;
  if (tree == nullptr || tree->root.id.empty() || runs(tree->root, tree->id)) {
    return std::nullopt;
  }
  const std::string id = tree->id;
  *node = bt::NodeSpec(tree->root);
  if (usesOf(file, id) == 0) {
    file.trees.erase(std::find_if(file.trees.begin(), file.trees.end(),
                                  [&id](const bt::TreeSpec& each) { return each.id == id; }));
  }
  return place;
}

MaybePlace renameNode(bt::TreeFile& file, const TreePlace& place, const std::string& name) {
  bt::NodeSpec* node = mutableNode(file, place);
  if (node == nullptr || node->name == name) {
    return std::nullopt;
  }
  node->name = name;
  return place;
}

std::string nodeText(const bt::NodeSpec& node) {
  return bt::writeNode(node, treeCatalogue());
}

base::Result<bt::NodeSpec> nodeFromText(const std::string& text, bt::TreeFile& into) {
  base::Result<bt::TreeFile> file = bt::readTreeText(text);
  if (!file) {
    const std::string element = base::trimmed(text);
    const base::Result<bt::TreeFile> around =
        bt::readTreeText("<root BTCPP_format=\"4\"><BehaviorTree ID=\"Pasted\">" + element +
                         "</BehaviorTree></root>");
    const bool isElement = element.rfind("<root", 0) != 0 && element.rfind("<?", 0) != 0;
    if (!around || !isElement) {
      return isElement ? around.diagnostics() : file.diagnostics();
    }
    return around->trees.front().root;
  }
  const bt::TreeSpec* main = file->find(file->mainTree);
  main = main == nullptr && !file->trees.empty() ? &file->trees.front() : main;
  if (main == nullptr || main->root.id.empty()) {
    return base::Diagnostics{base::error("tree.no-tree")};
  }
  for (const bt::TreeSpec& tree : file->trees) {
    if (&tree != main && !isTreeTaken(into, tree.id)) {
      into.trees.push_back(tree);
    }
  }
  return main->root;
}

}  // namespace editor
