#pragma once

#include <optional>
#include <string>

#include "bt/tree/TreeSpec.h"

/// Edits of a tree file as a value. Each returns where the node stands that is looked at
/// afterwards; nothing: it cannot be done, and nothing has changed.
namespace editor {

/// A node of a file: its tree and its place there.
struct TreePlace {
  std::string tree;  // ID
  bt::NodePath path;

  TreePlace parent() const;  // of a node that is no root
  TreePlace child(int index) const;
  bool isRoot() const { return path.empty(); }
  /// The same node, or one above it.
  bool holds(const TreePlace& other) const;
  friend bool operator==(const TreePlace& a, const TreePlace& b) {
    return a.tree == b.tree && a.path == b.path;
  }
};
using MaybePlace = std::optional<TreePlace>;

const bt::NodeSpec* nodeAt(const bt::TreeFile& file, const TreePlace& place);  // null = none

/// How many children a node may have: -1 = any number; unknown nodes may have any.
int mostChildren(const bt::NodeSpec& node);
bool takesChild(const bt::NodeSpec& node);
/// A node of this kind with the values that a new one has.
bt::NodeSpec freshNode(const std::string& id);

/// Before the child that stands at `index` now, or behind all.
MaybePlace addNode(bt::TreeFile& file, const TreePlace& parent, int index, bt::NodeSpec node);
/// With all that is below. No root.
MaybePlace removeNode(bt::TreeFile& file, const TreePlace& place);
/// To before what stands at `index` of `parent` now. Not into itself.
MaybePlace moveNode(bt::TreeFile& file, const TreePlace& from, const TreePlace& parent, int index);
/// `around` takes the place of the node and gets it as its last child.
MaybePlace wrapNode(bt::TreeFile& file, const TreePlace& place, bt::NodeSpec around);
/// The children take the place of the node.
MaybePlace unwrapNode(bt::TreeFile& file, const TreePlace& place);
/// Behind the node; no root.
MaybePlace duplicateNode(bt::TreeFile& file, const TreePlace& place);
/// Another kind of node in the same place: children stay, and values of ports that it has too.
MaybePlace replaceNode(bt::TreeFile& file, const TreePlace& place, const bt::NodeSpec& by);
/// The node becomes a tree of the file, with a SubTree in its place that shares all entries.
/// `wanted`: the ID of the tree; a number is put behind it when it is taken. No root.
MaybePlace extractTree(bt::TreeFile& file, const TreePlace& place, const std::string& wanted);
/// The opposite: what the SubTree runs stands in its place. Only where it shares all entries and
/// the file has the tree; a tree that nobody runs then is taken out of the file.
MaybePlace inlineTree(bt::TreeFile& file, const TreePlace& place);
MaybePlace renameNode(bt::TreeFile& file, const TreePlace& place, const std::string& name);

/// A node as XML, for the clipboard, and back: an element, or a file, of whose main tree it is the
/// root; trees of it that `into` lacks come along.
std::string nodeText(const bt::NodeSpec& node);
base::Result<bt::NodeSpec> nodeFromText(const std::string& text, bt::TreeFile& into);

}  // namespace editor
