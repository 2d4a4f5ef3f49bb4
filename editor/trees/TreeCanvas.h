#pragma once

#include <QWidget>

#include "editor/trees/TreeGraph.h"

namespace editor {

/// Displays a tree and handles mouse and keys. It emits the requested edits as signals and does not
/// edit the tree. The wheel zooms, dragging the background pans, and with Shift or Ctrl it selects
/// the nodes that the band touches; a click with these keys toggles the selection of a node.
class TreeCanvas : public QWidget {
  Q_OBJECT
 public:
  static constexpr const char* kMime = "application/x-hunavsim-node";  // XML of a node.

  explicit TreeCanvas(const Theme& theme);
  void setTheme(const Theme& theme);
  TreeGraph& graph() { return graph_; }
  const TreeView& shown() const { return view_; }

  void showTree(const PersonTree& tree);
  void showStatuses(std::vector<base::NodeStatus> statuses);
  void showBreakpoints(std::vector<sim2d::TreeBreakpoint> points);
  /// Chooses a node without emitting `choiceChanged`, unfolds its ancestors and scrolls it into
  /// view.
  void choose(int node);
  int chosen() const { return view_.chosen; }
  /// Selects several nodes; `chosen`: the current one of them, else the last.
  void select(std::vector<int> nodes, int chosen);
  const std::vector<int>& selected() const { return view_.selected; }  // Ascending.
  void setDirection(TreeDirection direction);
  void setPositionSource(TreeGraph::PositionSource positionSource);
  void fit();  // Fits the tree, up to 100 %; it stays fitted until the user zooms or pans.
  double zoom() const { return zoom_; }
  void zoomBy(double factor, const QPointF& about);
  void relayout();                        // Call it after folds have changed.
  bool isFree(const QRect& place) const;  // No part of the tree is in the rectangle.
  QPointF toGraph(const QPointF& at) const { return (at - origin_) / zoom_; }
  QPointF fromGraph(const QPointF& at) const { return at * zoom_ + origin_; }
  QRect placeOf(int node) const {
    return QRectF(fromGraph(graph_.box(node).topLeft()), zoom_ * graph_.box(node).size()).toRect();
  }
  QPoint centreOf(int node) const { return fromGraph(graph_.box(node).center()).toPoint(); }

 Q_SIGNALS:
  void choiceChanged(int node);  // -1 = none.
  void openRequested(int node);
  void menuRequested(int node, const QPoint& global);
  void moveRequested(int node, const editor::DropTarget& to);
  void dropRequested(const QString& xml, const editor::DropTarget& to);
  void escaped();
  void moved();                                               // The tree has moved in the widget.
  void keyCommand(int key, Qt::KeyboardModifiers modifiers);  // For keys accepted by `isCommand`.

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragMoveEvent(QDragMoveEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  enum class Gesture { None, Pressed, Moving, Panning, Band };
  bool isCommand(const QKeyEvent& event) const;
  bool moveChosen(const QKeyEvent& event);
  void hover(const QPoint& at);
  void endGesture();
  bool isCrossedByLine(const QRectF& place, int node) const;
  void keepPartlyVisible();
  void fitTo(double leastZoom);
  void bringIntoView(int node);
  void chooseByUser(int node);
  void toggleByUser(int node);
  bool pressFoldHandle(const QPointF& at);
  std::vector<int> movedNodes() const;
  void selectBand(const QRectF& band);
  QString tipOf(int node) const;

  Theme theme_;
  TreeGraph graph_;
  TreeView view_;
  double zoom_ = 1.0;
  QPointF origin_;         // Position of the graph in the widget [px].
  bool isAutoFit_ = true;  // Until the user zooms or pans.
  double fitLeast_;        // Minimum zoom for fitting.
  Gesture gesture_ = Gesture::None;
  QPoint pressedAt_;
  QPointF originBefore_;
  int pressedNode_ = -1;
  bool choosesOnRelease_ = false;
};

}  // namespace editor
