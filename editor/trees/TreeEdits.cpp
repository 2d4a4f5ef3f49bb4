#include "editor/trees/TreeEdits.h"

#include <algorithm>
#include <functional>
#include <tuple>
#include <utility>

#include "bt/tree/TreeXml.h"
#include "editor/document/PersonTree.h"
#include "sim2d/base/Text.h"

namespace editor {

namespace {

bt::NodeSpec* mutableNode(bt::TreeFile& file, const NodeLocation& place) {
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

int usageCount(const bt::TreeFile& file, const std::string& tree) {
  int uses = file.mainTree == tree || file.trees.size() == 1 ? 1 : 0;
  for (const bt::TreeSpec& each : file.trees) {
    forEachNode(each.root, [&](const bt::NodeSpec& node) {
      uses += node.isSubTree() && node.subTree == tree ? 1 : 0;
    });
  }
  return uses;
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

NodeLocation NodeLocation::parent() const {
  NodeLocation place = *this;
  place.path.pop_back();
  return place;
}

NodeLocation NodeLocation::child(int index) const {
  NodeLocation place = *this;
  place.path.push_back(index);
  return place;
}

bool NodeLocation::holds(const NodeLocation& other) const {
  return tree == other.tree && path.size() <= other.path.size() &&
         std::equal(path.begin(), path.end(), other.path.begin());
}

const bt::NodeSpec* nodeAt(const bt::TreeFile& file, const NodeLocation& place) {
  const bt::TreeSpec* tree = file.find(place.tree);
  return tree == nullptr ? nullptr : bt::nodeAt(*tree, place.path);
}

bool runsTree(const bt::NodeSpec& node, const std::string& tree) {
  bool found = false;
  forEachNode(node, [&](const bt::NodeSpec& each) {
    found = found || (each.isSubTree() && each.subTree == tree);
  });
  return found;
}

int maxChildCount(const bt::NodeSpec& node) {
  if (node.isSubTree()) {
    return 0;
  }
  const bt::NodeManifest* manifest = treeCatalogue().find(node.id);
  return manifest == nullptr ? -1 : manifest->maxChildren;
}

bool canHaveChildren(const bt::NodeSpec& node) {
  const int most = maxChildCount(node);
  return most < 0 || static_cast<int>(node.children.size()) < most;
}

bt::NodeSpec defaultNode(const std::string& id) {
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

OptionalLocation unwrapNode(bt::TreeFile& file, const NodeLocation& place) {
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
  const int most = above == nullptr ? 0 : maxChildCount(*above);
  if (above == nullptr || (most >= 0 && above->children.size() - 1 + children.size() >
                                            static_cast<std::size_t>(most))) {
    return std::nullopt;
  }
  const auto at = above->children.begin() + place.path.back();
  above->children.insert(above->children.erase(at), children.begin(), children.end());
  return place;
}

OptionalLocation replaceNode(bt::TreeFile& file, const NodeLocation& place,
                             const bt::NodeSpec& by) {
  bt::NodeSpec* node = mutableNode(file, place);
  const int most = maxChildCount(by);
  if (node == nullptr || (most >= 0 && static_cast<int>(node->children.size()) > most)) {
    return std::nullopt;
  }
  bt::NodeSpec other = by;
  const bt::NodeManifest* manifest = treeCatalogue().find(by.id);
  for (const bt::Attribute& port : node->ports) {
    if (manifest != nullptr && manifest->port(port.name) != nullptr) {
      bt::setAttribute(other.ports, port.name, port.text);
    }
  }
  other.name = node->name;
  other.conditions = node->conditions;
  other.others = node->others;
  other.children = std::move(node->children);
  *node = std::move(other);
  return place;
}

OptionalLocation extractTree(bt::TreeFile& file, const NodeLocation& place,
                             const std::string& wanted) {
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
    file.mainTree = file.trees.front().id;  // Required if there are two trees.
  }
  file.trees.push_back(std::move(tree));
  return place;
}

OptionalLocation inlineTree(bt::TreeFile& file, const NodeLocation& place) {
  bt::NodeSpec* node = mutableNode(file, place);
  const bool isWhole = node != nullptr && node->isSubTree() && node->autoRemap &&
                       node->ports.empty() && node->conditions.empty();
  const bt::TreeSpec* tree = isWhole ? file.find(node->subTree) : nullptr;
  if (tree == nullptr || tree->root.id.empty() || runsTree(tree->root, tree->id)) {
    return std::nullopt;
  }
  const std::string id = tree->id;
  *node = bt::NodeSpec(tree->root);
  if (usageCount(file, id) == 0) {
    file.trees.erase(std::find_if(file.trees.begin(), file.trees.end(),
                                  [&id](const bt::TreeSpec& each) { return each.id == id; }));
  }
  return place;
}

OptionalLocation renameNode(bt::TreeFile& file, const NodeLocation& place,
                            const std::string& name) {
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
    const bool isElement = !base::startsWith(element, "<root") && !base::startsWith(element, "<?");
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

namespace {

OptionalLocation addNode(bt::TreeFile& file, const NodeLocation& parent, int index,
                         bt::NodeSpec node) {
  bt::NodeSpec* above = mutableNode(file, parent);
  if (above == nullptr || !canHaveChildren(*above)) {
    return std::nullopt;
  }
  const int place = std::clamp(index, 0, static_cast<int>(above->children.size()));
  above->children.insert(above->children.begin() + place, std::move(node));
  return parent.child(place);
}

OptionalLocation removeNode(bt::TreeFile& file, const NodeLocation& place) {
  if (place.isRoot() || nodeAt(file, place) == nullptr) {
    return std::nullopt;
  }
  bt::NodeSpec& above = *mutableNode(file, place.parent());
  above.children.erase(above.children.begin() + place.path.back());
  const int left = static_cast<int>(above.children.size());
  return left == 0 ? place.parent() : place.parent().child(std::min(place.path.back(), left - 1));
}

/// Adjusts a position after the removal of the node `gone`; `index` counts its children.
void follow(const NodeLocation& gone, NodeLocation& parent, int& index) {
  const NodeLocation above = gone.parent();
  if (!above.holds(parent)) {
    return;
  }
  const std::size_t level = gone.path.size() - 1;
  if (parent.path.size() > level) {
    parent.path[level] -= parent.path[level] > gone.path.back() ? 1 : 0;
  } else {
    index -= index > gone.path.back() ? 1 : 0;
  }
}

}  // namespace

std::vector<NodeLocation> withoutDescendants(std::vector<NodeLocation> places) {
  std::sort(places.begin(), places.end(), [](const NodeLocation& a, const NodeLocation& b) {
    return std::tie(a.tree, a.path) < std::tie(b.tree, b.path);
  });
  std::vector<NodeLocation> outer;
  for (NodeLocation& place : places) {  // Parents precede children.
    if (outer.empty() || !outer.back().holds(place)) {
      outer.push_back(std::move(place));
    }
  }
  return outer;
}

bool areSiblings(const std::vector<NodeLocation>& places) {
  return std::all_of(places.begin(), places.end(), [&places](const NodeLocation& each) {
    return !each.isRoot() && !places.front().isRoot() && each.parent() == places.front().parent();
  });
}

OptionalLocations removeNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places) {
  const std::vector<NodeLocation> outer = withoutDescendants(places);
  OptionalLocation left;
  for (auto place = outer.rbegin(); place != outer.rend(); ++place) {
    left = removeNode(file, *place);
    if (!left) {
      return std::nullopt;
    }
  }
  return left ? OptionalLocations({*left}) : std::nullopt;
}

OptionalLocations addNodes(bt::TreeFile& file, const NodeLocation& parent, int index,
                           const std::vector<bt::NodeSpec>& nodes) {
  std::vector<NodeLocation> added;
  for (const bt::NodeSpec& node : nodes) {
    const OptionalLocation place =
        addNode(file, parent, index + static_cast<int>(added.size()), node);
    if (!place) {
      return std::nullopt;
    }
    added.push_back(*place);
  }
  return added.empty() ? std::nullopt : OptionalLocations(std::move(added));
}

OptionalLocations moveNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places,
                            const NodeLocation& parent, int index) {
  const std::vector<NodeLocation> outer = withoutDescendants(places);
  std::vector<bt::NodeSpec> nodes;
  for (const NodeLocation& place : outer) {
    const bt::NodeSpec* node = nodeAt(file, place);
    if (node == nullptr || place.isRoot() || place.holds(parent)) {
      return std::nullopt;
    }
    nodes.push_back(*node);
  }
  const bool isThere = areSiblings(outer) && !outer.empty() && outer.front().parent() == parent;
  const int first = outer.empty() ? 0 : outer.front().path.back();
  const int count = static_cast<int>(outer.size());
  const bool isOneRow = isThere && outer.back().path.back() == first + count - 1;
  if (isOneRow && index >= first && index <= first + count) {
    return std::nullopt;  // The nodes are already at that position.
  }
  bt::TreeFile edited = file;
  NodeLocation to = parent;
  for (auto place = outer.rbegin(); place != outer.rend(); ++place) {
    if (!removeNode(edited, *place)) {
      return std::nullopt;
    }
    follow(*place, to, index);
  }
  OptionalLocations moved = addNodes(edited, to, index, nodes);
  if (moved) {
    file = std::move(edited);
  }
  return moved;
}

OptionalLocations wrapNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places,
                            bt::NodeSpec around) {
  const std::vector<NodeLocation> outer = withoutDescendants(places);
  if (outer.size() == 1) {
    bt::NodeSpec* node = mutableNode(file, outer.front());
    if (node == nullptr || !canHaveChildren(around)) {
      return std::nullopt;
    }
    around.children.push_back(std::move(*node));
    *node = std::move(around);
    return outer;
  }
  if (outer.empty() || !areSiblings(outer)) {
    return std::nullopt;
  }
  for (const NodeLocation& place : outer) {
    const bt::NodeSpec* node = nodeAt(file, place);
    if (node == nullptr || !canHaveChildren(around)) {
      return std::nullopt;
    }
    around.children.push_back(*node);
  }
  if (!removeNodes(file, outer)) {
    return std::nullopt;
  }
  return addNodes(file, outer.front().parent(), outer.front().path.back(), {std::move(around)});
}

OptionalLocations duplicateNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places) {
  const std::vector<NodeLocation> outer = withoutDescendants(places);
  std::vector<NodeLocation> added;
  if (areSiblings(outer) && !outer.empty()) {
    std::vector<bt::NodeSpec> copies;
    for (const NodeLocation& place : outer) {
      const bt::NodeSpec* node = nodeAt(file, place);
      copies.push_back(node == nullptr ? bt::NodeSpec() : *node);
    }
    return addNodes(file, outer.front().parent(), outer.back().path.back() + 1, copies);
  }
  for (auto place = outer.rbegin(); place != outer.rend(); ++place) {
    const bt::NodeSpec* node = nodeAt(file, *place);
    const OptionalLocation copy =
        node == nullptr || place->isRoot()
            ? std::nullopt
            : addNode(file, place->parent(), place->path.back() + 1, bt::NodeSpec(*node));
    if (!copy) {
      return std::nullopt;
    }
    for (NodeLocation& later : added) {  // Following siblings are shifted by one.
      const std::size_t level = copy->path.size() - 1;
      if (copy->parent().holds(later) && later.path.size() > level &&
          later.path[level] >= copy->path.back()) {
        ++later.path[level];
      }
    }
    added.insert(added.begin(), *copy);
  }
  return added.empty() ? std::nullopt : OptionalLocations(std::move(added));
}

std::string nodesText(const std::vector<const bt::NodeSpec*>& nodes) {
  std::string text;
  for (const bt::NodeSpec* node : nodes) {
    text += nodeText(*node);
  }
  return text;
}

base::Result<std::vector<bt::NodeSpec>> nodesFromText(const std::string& text, bt::TreeFile& into) {
  const base::Result<bt::NodeSpec> one = nodeFromText(text, into);
  if (one) {
    return std::vector<bt::NodeSpec>{*one};
  }
  const base::Result<bt::NodeSpec> row =
      nodeFromText("<Sequence>" + base::trimmed(text) + "</Sequence>", into);
  if (!row || row->children.empty()) {
    return one.diagnostics();
  }
  return row->children;
}

}  // namespace editor
