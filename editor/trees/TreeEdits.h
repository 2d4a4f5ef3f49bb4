#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bt/tree/TreeSpec.h"

/// Edits of a tree file by value. Each function returns the position of the node to be chosen
/// afterwards, or none if the edit is impossible; the file is unchanged then.
namespace editor {

/// The position of a node: its tree and its path.
struct NodeLocation {
  std::string tree;  // ID
  bt::NodePath path;

  NodeLocation parent() const;  // For nodes other than roots.
  NodeLocation child(int index) const;
  bool isRoot() const { return path.empty(); }
  /// Returns true for the same node or a descendant.
  bool holds(const NodeLocation& other) const;
  friend bool operator==(const NodeLocation& a, const NodeLocation& b) {
    return a.tree == b.tree && a.path == b.path;
  }
};
using OptionalLocation = std::optional<NodeLocation>;

const bt::NodeSpec* nodeAt(const bt::TreeFile& file, const NodeLocation& place);  // Null = none.

/// Maximum number of children: -1 = unlimited, also for unknown nodes.
int maxChildCount(const bt::NodeSpec& node);
bool canHaveChildren(const bt::NodeSpec& node);
/// Whether the node or a descendant runs this tree.
bool runsTree(const bt::NodeSpec& node, const std::string& tree);
/// A node of this kind with default values.
bt::NodeSpec defaultNode(const std::string& id);

/// Replaces the node by its children.
OptionalLocation unwrapNode(bt::TreeFile& file, const NodeLocation& place);
/// Replaces the node by another kind; children and values of common ports stay.
OptionalLocation replaceNode(bt::TreeFile& file, const NodeLocation& place, const bt::NodeSpec& by);
/// Moves the node into a new tree of the file and replaces it by a SubTree that shares all entries.
/// `wanted`: ID of the tree; a number is appended if it is taken. Not for roots.
OptionalLocation extractTree(bt::TreeFile& file, const NodeLocation& place,
                             const std::string& wanted);
/// The inverse: replaces a SubTree by the content of its tree. Only if it shares all entries and
/// the file contains the tree. A tree that is no longer used is removed from the file.
OptionalLocation inlineTree(bt::TreeFile& file, const NodeLocation& place);
OptionalLocation renameNode(bt::TreeFile& file, const NodeLocation& place, const std::string& name);

/// A node as XML for the clipboard, and the inverse. The text is an element, or a file whose main
/// tree has the node as its root; its trees that `into` lacks are added to it.
std::string nodeText(const bt::NodeSpec& node);
base::Result<bt::NodeSpec> nodeFromText(const std::string& text, bt::TreeFile& into);

/// Edits of several nodes of a tree file. Each function returns their positions afterwards, or none
/// if the edit is impossible for any of them; the file must be discarded then.

using OptionalLocations = std::optional<std::vector<NodeLocation>>;

/// In file order, without descendants of other elements.
std::vector<NodeLocation> withoutDescendants(std::vector<NodeLocation> places);
bool areSiblings(const std::vector<NodeLocation>& places);  // Children of the same parent.

/// Removes the nodes with all their descendants; not for roots. Returns the position of the sibling
/// beside the first removed node, or of its parent if there is none.
OptionalLocations removeNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places);
/// Moves nodes to before the current child `index` of `parent`, in their order; not into one of
/// them.
OptionalLocations moveNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places,
                            const NodeLocation& parent, int index);
/// Inserts before the child that is at `index` now, or appends.
OptionalLocations addNodes(bt::TreeFile& file, const NodeLocation& parent, int index,
                           const std::vector<bt::NodeSpec>& nodes);
/// Replaces the first node by `around`, which gets all of them as its last children; they must be
/// siblings. A root can be wrapped alone.
OptionalLocations wrapNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places,
                            bt::NodeSpec around);
/// Inserts each copy after its node; copies of siblings after the last of them.
OptionalLocations duplicateNodes(bt::TreeFile& file, const std::vector<NodeLocation>& places);

/// Nodes as consecutive XML elements, and the inverse, which reads whatever nodeFromText() reads,
/// or several elements.
std::string nodesText(const std::vector<const bt::NodeSpec*>& nodes);
base::Result<std::vector<bt::NodeSpec>> nodesFromText(const std::string& text, bt::TreeFile& into);

}  // namespace editor
