#pragma once

#include <optional>
#include <vector>

#include <QPointF>

#include "bt/tree/TreeSpec.h"

namespace editor {

/// A node for the layout. Parents precede children, and siblings are in order.
struct LayoutNode {
  int parent = -1;                   // Index in the list, -1 = a root.
  double width = 0.0, height = 0.0;  // [px]
};

enum class TreeDirection { Down, Right };  // From the root to the leaves.

struct LayoutGaps {
  double sibling = 8.0;  // Between nodes of a level [px].
  double level = 44.0;   // Between levels [px].
};

struct LayoutBox {
  double x = 0.0, y = 0.0;  // Top left corner; x right, y down [px].
  double width = 0.0, height = 0.0;
};

struct TreeLayoutResult {
  std::vector<LayoutBox> boxes;      // One per node, without overlaps.
  double width = 0.0, height = 0.0;  // Total size, starting at (0, 0).
};

/// Tidy drawing of a tree: a parent is centred over its children, equal subtrees look equal, levels
/// are aligned at their tops and nodes of a level are at least `sibling` apart. Time and memory are
/// linear in the number of nodes. Source: Buchheim, Juenger, Leipert: Improving Walker's algorithm
/// to run in linear time (2002), with node widths for its distances. Further roots are placed
/// beside the first.
TreeLayoutResult layOutTree(const std::vector<LayoutNode>& nodes, TreeDirection direction,
                            const LayoutGaps& gaps = {});

/// The node position stored by a tree editor in attributes that the engine ignores: `_x` and `_y`,
/// or `_pos` or `_position` with "x;y" or "x,y" [px, y down]. None if the file contains no
/// position.
std::optional<QPointF> storedNodePosition(const bt::NodeSpec& node);

}  // namespace editor
