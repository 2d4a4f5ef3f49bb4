#pragma once

#include <algorithm>
#include <map>

#include <QPainter>
#include <QtWidgets>

#include "editor/document/PersonTree.h"
#include "editor/look/Theme.h"
#include "editor/trees/TreeEdits.h"
#include "editor/trees/TreeLayout.h"
#include "sim2d/world/HumanBehavior.h"

namespace editor {

/// The drop target of a drag.
struct DropTarget {
  enum class How { Below, Around };
  How how = How::Below;
  int node = -1;   // Below: the parent; Around: the node to be wrapped.
  int index = 0;   // Below: index of the following child.
  QLineF mark;     // Indicator line for Below.
  QPointF centre;  // Centre of the target.
};

/// The layout of a person's tree: visible nodes with their positions, and their problems. Node
/// numbers are those of outlineOf(). Coordinates: x right, y down [px at 100 %].
class TreeGraph {
 public:
  static constexpr double kNodeHeight = 46.0;
  static constexpr double kMargin = 24.0;  // Around the whole tree.

  explicit TreeGraph(const Theme& theme) : theme_(theme) {}
  ~TreeGraph() = default;
  Q_DISABLE_COPY_MOVE(TreeGraph)  // Nodes point into the tree.

  /// Keeps folds by node names.
  void setTree(const PersonTree& tree);
  const PersonTree& tree() const { return tree_; }
  const std::vector<OutlineNode>& nodes() const { return nodes_; }
  const OutlineNode& node(int number) const { return nodes_[static_cast<std::size_t>(number)]; }
  const std::vector<std::string>& names() const { return names_; }  // As in recordings.
  const std::vector<int>& childrenOf(int node) const {
    return children_[static_cast<std::size_t>(node)];
  }
  bool has(int node) const { return node >= 0 && node < static_cast<int>(nodes_.size()); }
  NodeLocation locationOf(int node) const;
  /// The node at that position; if a tree is used several times, the one nearest to `beside`; -1 =
  /// none.
  int nodeAtLocation(const NodeLocation& place, int beside = 0) const;
  bool isEditable(int number) const { return node(number).isEditable; }
  bool isUnknown(int node) const;

  /// The content of a SubTree from an included file is initially folded.
  bool isFolded(int node) const;
  void setFolded(int node, bool folded);
  void unfoldAll();
  void foldAll();             // Folds everything below the children of the root.
  void show(int node);        // Unfolds all ancestors.
  int below(int node) const;  // Number of descendants, visible or not.

  /// Automatic layout, or the positions of the file; nodes without a position keep their offset
  /// from the parent.
  enum class PositionSource { Automatic, File };
  void setPositionSource(PositionSource positionSource);
  PositionSource positionSource() const { return positionSource_; }
  bool hasStoredPositions() const;  // The root and at least one other node have positions.
  void setDirection(TreeDirection direction);
  TreeDirection direction() const { return direction_; }
  const std::vector<int>& shown() const { return shown_; }  // Parents precede children.
  bool isShown(int node) const { return has(node) && !box(node).isNull(); }
  const QRectF& box(int node) const { return boxes_[static_cast<std::size_t>(node)]; }
  QRectF bounds() const { return bounds_; }
  int nodeAt(const QPointF& at) const;  // -1 = none.
  /// The ends of a connecting line at the parent and at the child.
  QPointF outlet(int node) const;
  QPointF inlet(int node) const;
  /// The neighbouring visible node: parent, first child, previous or next sibling.
  enum class Way { Up, Down, Left, Right };  // On the screen.
  int beside(int node, Way way) const;

  /// For a node like this, or for moving the nodes `moving` of the tree with all their descendants.
  std::optional<DropTarget> dropTargetAt(const QPointF& at, const bt::NodeSpec& what,
                                         const std::vector<int>& moving) const;

  struct Problem {
    base::Severity severity = base::Severity::Warning;
    QString text;
  };
  const std::vector<Problem>& problemsOf(int node) const {
    return problems_[static_cast<std::size_t>(node)];
  }

 private:
  void findProblems();
  void layOut();
  void applyStoredPositions();
  double widthOf(int node) const;
  bool isBelow(int node, int above) const;  // True also for the same node.
  std::vector<DropTarget> dropTargets(const bt::NodeSpec& what,
                                      const std::vector<int>& moving) const;
  bool canHoldChildren(int parent, const std::vector<int>& moving) const;
  int nextOnLevel(int number, double sign) const;
  DropTarget onlyTargetBelow(int parent) const;
  void addTargetsBelow(int parent, std::vector<DropTarget>& places) const;

  const Theme theme_;  // For text widths.
  PersonTree tree_;
  std::vector<OutlineNode> nodes_;
  std::vector<std::string> names_;
  std::vector<std::vector<int>> children_;
  std::vector<std::vector<Problem>> problems_;
  std::map<std::string, bool> folds_;  // Explicit folds.
  TreeDirection direction_ = TreeDirection::Down;
  PositionSource positionSource_ = PositionSource::Automatic;
  std::vector<int> shown_;
  std::vector<QRectF> boxes_;  // Null: hidden.
  QRectF bounds_;
};

/// The second line of a node: the type of a renamed node and the values, "Wait · 3 s"; else its
/// kind.
QString nodeDetail(const bt::NodeSpec& node);

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
