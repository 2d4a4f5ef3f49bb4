#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include <QPainter>

#include "editor/trees/TreeGraph.h"
#include "sim2d/world/TreeBreakpoint.h"

namespace editor {

/// What is shown of a tree beside the tree itself.
struct TreeView {
  std::vector<base::NodeStatus> statuses;  // by node; empty: no run is shown
  std::vector<sim2d::TreeBreakpoint> breakpoints;
  int chosen = -1, hovered = -1;
  std::vector<int> selected;  // with the one that is chosen
  std::vector<int> dragged;
  std::optional<DropPlace> drop;
  std::optional<QRectF> band;  // that selects

  bool isSelected(int node) const {
    return std::find(selected.begin(), selected.end(), node) != selected.end();
  }

  const base::NodeStatus* statusOf(int node) const;  // null: no run is shown
};

/// Draws a tree, the same way on the screen and in pictures. One unit = one pixel at 100 %.
class TreePainter {
 public:
  static constexpr double kKnob = 16.0;  // where a node is folded, its height [px]

  TreePainter(const TreeGraph& graph, const TreeView& view, const Theme& theme)
      : graph_(graph), view_(view), theme_(theme) {}
  void paint(QPainter& painter, const QRectF& visible) const;
  /// Where a click folds what is below a node; null: nothing is.
  static QRectF knobOf(const TreeGraph& graph, int node);

 private:
  void paintLine(QPainter& painter, int child) const;
  void paintNode(QPainter& painter, int node) const;
  void paintTexts(QPainter& painter, int node, bool isPale) const;
  void paintMarks(QPainter& painter, int node) const;
  void paintKnob(QPainter& painter, int node) const;
  void paintDrop(QPainter& painter) const;
  void paintBand(QPainter& painter) const;
  QPen penOf(int node, double width) const;
  bool isStopped(int node) const;

  const TreeGraph& graph_;
  const TreeView& view_;
  const Theme& theme_;
};

/// The sign that tells the kind of a node without colour, 14 px wide around `centre`: an arrow for
/// sequences, "?" for fallbacks, a diamond for decorators, a hexagon for conditions, a flash for
/// actions, a plus in a box for subtrees.
void paintNodeSign(QPainter& painter, const bt::NodeSpec& node, const QPointF& centre,
                   const QColor& color);

}  // namespace editor
