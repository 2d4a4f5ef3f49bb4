#pragma once

#include <optional>

#include <QWidget>

#include "editor/trees/TreePainter.h"

namespace editor {

/// A tree that can be looked at and edited by mouse and keys: it tells what is wanted, others do
/// it. Wheel zooms, dragging the ground moves the picture, with Shift or Ctrl it selects what the
/// frame touches; a click with these adds a node to those that are selected, or takes it away.
class TreeCanvas : public QWidget {
  Q_OBJECT
 public:
  static constexpr const char* kMime = "application/x-hunavsim-node";  // XML of a node

  explicit TreeCanvas(const Theme& theme);
  void setTheme(const Theme& theme);
  TreeGraph& graph() { return graph_; }
  const TreeView& shown() const { return view_; }

  void showTree(const PersonTree& tree);
  void showStatuses(std::vector<base::NodeStatus> statuses);
  void showBreakpoints(std::vector<sim2d::TreeBreakpoint> points);
  /// Without `chosen`; what hides it is unfolded, and it comes into view.
  void choose(int node);
  int chosen() const { return view_.chosen; }
  /// Several at once; `chosen`: the one among them that others show, else the last.
  void select(std::vector<int> nodes, int chosen);
  const std::vector<int>& selected() const { return view_.selected; }  // rising
  void setDirection(TreeDirection direction);
  void setPlacing(TreeGraph::Placing placing);
  void fit();  // all of it, at most at 100 %; it stays so until the user zooms or moves it
  double zoom() const { return zoom_; }
  void zoomBy(double factor, const QPointF& about);
  void relayout();                        // folds have changed
  bool isFree(const QRect& place) const;  // nothing of the tree lies there
  QPointF toGraph(const QPointF& at) const { return (at - origin_) / zoom_; }
  QPointF fromGraph(const QPointF& at) const { return at * zoom_ + origin_; }
  QPoint centreOf(int node) const { return fromGraph(graph_.box(node).center()).toPoint(); }

 Q_SIGNALS:
  void chose(int node);  // -1 = none
  void openWanted(int node);
  void menuWanted(int node, const QPoint& global);
  void moveWanted(int node, const editor::DropPlace& to);
  void dropWanted(const QString& xml, const editor::DropPlace& to);
  void escaped();
  void moved();  // other things lie in other places of the widget now
  void keyCommand(int key, Qt::KeyboardModifiers modifiers);  // of those in `isCommand`

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
  void keepInView();
  void fitTo(double leastZoom);
  void bringIntoView(int node);
  void chooseByUser(int node);
  void toggleByUser(int node);
  bool pressKnob(const QPointF& at);
  std::vector<int> movedNodes() const;
  void selectBand(const QRectF& band);
  QString tipOf(int node) const;

  Theme theme_;
  TreeGraph graph_;
  TreeView view_;
  double zoom_ = 1.0;
  QPointF origin_;          // of the graph, in the widget [px]
  bool fitsItself_ = true;  // until the user zooms or moves it
  double fitLeast_;         // zoom then
  Gesture gesture_ = Gesture::None;
  QPoint pressedAt_;
  QPointF originBefore_;
  int pressedNode_ = -1;
  bool choosesOnRelease_ = false;
};

}  // namespace editor
