#pragma once

#include <vector>

namespace editor {

/// A node as the layout sees it. Parents stand before their children, siblings in their order.
struct LayoutNode {
  int parent = -1;                   // place in the list, -1 = a root
  double width = 0.0, height = 0.0;  // [px]
};

enum class TreeDirection { Down, Right };  // from the root to the leaves

struct LayoutGaps {
  double sibling = 8.0;  // between nodes of a level [px]
  double level = 44.0;   // from level to level [px]
};

struct LayoutBox {
  double x = 0.0, y = 0.0;  // top left; x right, y down [px]
  double width = 0.0, height = 0.0;
};

struct TreePlaces {
  std::vector<LayoutBox> boxes;      // one per node, no two of which overlap
  double width = 0.0, height = 0.0;  // of all together, from (0, 0)
};

/// Tidy drawing of a tree: a parent stands over the middle of its children, equal subtrees look
/// equal, levels are aligned at their tops and nodes of a level are at least `sibling` apart. Time
/// and memory grow linearly with the number of nodes.
/// Source: Buchheim, Juenger, Leipert: Improving Walker's algorithm to run in linear time (2002),
/// with the widths of the nodes for its distances. Roots beyond the first stand beside it.
TreePlaces layOutTree(const std::vector<LayoutNode>& nodes, TreeDirection direction,
                      const LayoutGaps& gaps = {});

}  // namespace editor
