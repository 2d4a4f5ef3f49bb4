#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <QPainter>

#include "editor/trees/TreeGraph.h"
#include "sim2d/world/HumanBehavior.h"

namespace editor {

/// The view state of a tree.
struct TreeView {
  std::vector<base::NodeStatus> statuses;  // By node; empty: no run is shown.
  std::vector<sim2d::TreeBreakpoint> breakpoints;
  int chosen = -1, hovered = -1;
  std::vector<int> selected;  // Includes the chosen node.
  std::vector<int> dragged;
  std::optional<DropTarget> drop;
  std::optional<QRectF> band;  // Selection band.

  bool isSelected(int node) const {
    return std::find(selected.begin(), selected.end(), node) != selected.end();
  }

  const base::NodeStatus* statusOf(int node) const;  // Null: no run is shown.
};

/// Draws a tree on the screen and in pictures. One unit = one pixel at 100 %.
class TreePainter {
 public:
  static constexpr double kFoldHandle = 16.0;  // Height of the fold knob [px].

  TreePainter(const TreeGraph& graph, const TreeView& view, const Theme& theme)
      : graph_(graph), view_(view), theme_(theme) {}
  void paint(QPainter& painter, const QRectF& visible) const;
  /// Click area of the fold knob; null: the node has no descendants.
  static QRectF foldHandleRect(const TreeGraph& graph, int node);

 private:
  void paintLine(QPainter& painter, int child) const;
  void paintNode(QPainter& painter, int node) const;
  void paintTexts(QPainter& painter, int node, bool isDimmed) const;
  void paintMarks(QPainter& painter, int node) const;
  void paintFoldHandle(QPainter& painter, int node) const;
  void paintDrop(QPainter& painter) const;
  void paintBand(QPainter& painter) const;
  QPen penOf(int node, double width) const;
  bool isStopped(int node) const;

  const TreeGraph& graph_;
  const TreeView& view_;
  const Theme& theme_;
};

/// Draws a colour-free sign for the kind of a node, 14 px wide around `centre`: an arrow for
/// sequences, "?" for fallbacks, a diamond for decorators, a hexagon for conditions, a flash for
/// actions, a plus in a box for subtrees.
void paintNodeSign(QPainter& painter, const bt::NodeSpec& node, const QPointF& centre,
                   const QColor& color);

}  // namespace editor
