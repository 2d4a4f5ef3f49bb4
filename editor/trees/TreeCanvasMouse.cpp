// What the mouse does on a tree; how it lies there: TreeCanvas.cpp.
#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QMimeData>
#include <QMouseEvent>

#include "editor/trees/TreeCanvas.h"

namespace editor {

namespace {

constexpr double kTreeWheelFactor = 1.0015;  // per unit of the wheel
constexpr Qt::KeyboardModifiers kMore = Qt::ShiftModifier | Qt::ControlModifier;

bool isAdding(const QMouseEvent& event) {
  return (event.modifiers() & kMore) != 0;
}

}  // namespace

void TreeCanvas::hover(const QPoint& at) {
  int node = graph_.nodeAt(toGraph(at));
  if (node < 0 && view_.hovered >= 0 &&
      TreePainter::knobOf(graph_, view_.hovered).contains(toGraph(at))) {
    node = view_.hovered;
  }
  if (node != view_.hovered) {
    view_.hovered = node;
    update();
  }
}

/// Where a node is folded or unfolded; whether it was.
bool TreeCanvas::pressKnob(const QPointF& at) {
  for (const int node : graph_.shown()) {
    const bool isKnob = TreePainter::knobOf(graph_, node).contains(at);
    if (isKnob && (graph_.isFolded(node) || !graph_.box(node).contains(at))) {
      graph_.setFolded(node, !graph_.isFolded(node));
      relayout();
      return true;
    }
  }
  return false;
}

void TreeCanvas::mousePressEvent(QMouseEvent* event) {
  setFocus();
  pressedAt_ = event->pos();
  originBefore_ = origin_;
  hover(event->pos());
  const QPointF at = toGraph(event->pos());
  if (event->button() == Qt::MiddleButton) {
    gesture_ = Gesture::Panning;
    return;
  }
  if (event->button() == Qt::LeftButton && pressKnob(at)) {
    return;
  }
  pressedNode_ = graph_.nodeAt(at);
  choosesOnRelease_ = false;
  if (isAdding(*event) && event->button() == Qt::LeftButton) {
    if (pressedNode_ >= 0) {
      toggleByUser(pressedNode_);
    } else {
      view_.band = QRectF(at, QSizeF());
    }
  } else if (pressedNode_ >= 0 && view_.isSelected(pressedNode_) && view_.selected.size() > 1) {
    choosesOnRelease_ = true;  // a click on one of several leaves only that one
  } else {
    chooseByUser(pressedNode_);
  }
  if (event->button() == Qt::LeftButton) {
    gesture_ = view_.band ? Gesture::Band : Gesture::Pressed;
    originBefore_ = origin_;  // choosing may have moved it
  }
}

void TreeCanvas::toggleByUser(int node) {
  std::vector<int> nodes = view_.selected;
  const auto found = std::find(nodes.begin(), nodes.end(), node);
  found == nodes.end() ? nodes.push_back(node) : (void)nodes.erase(found);
  select(std::move(nodes), node);
  Q_EMIT chose(view_.chosen);
}

/// What a drag from the pressed node moves: all that is selected when it is.
std::vector<int> TreeCanvas::movedNodes() const {
  std::vector<int> nodes;
  const std::vector<int> one = {pressedNode_};
  const bool isOfSelected = view_.isSelected(pressedNode_);
  for (const int node : isOfSelected ? view_.selected : one) {  // parents come first
    int above = graph_.has(node) ? graph_.node(node).parent : -1;
    while (above >= 0 && std::find(nodes.begin(), nodes.end(), above) == nodes.end()) {
      above = graph_.node(above).parent;
    }
    if (above < 0 && graph_.has(node) && graph_.isEditable(node) &&
        !graph_.placeOf(node).isRoot()) {
      nodes.push_back(node);
    }
  }
  return nodes;
}

void TreeCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPoint by = event->pos() - pressedAt_;
  if (gesture_ == Gesture::Pressed && by.manhattanLength() >= QApplication::startDragDistance()) {
    const bool canMove = pressedNode_ > 0 && graph_.has(pressedNode_) && !movedNodes().empty() &&
                         graph_.isEditable(pressedNode_) && !graph_.placeOf(pressedNode_).isRoot();
    gesture_ = canMove ? Gesture::Moving : Gesture::Panning;
    setCursor(Qt::ClosedHandCursor);
  }
  if (gesture_ == Gesture::Panning) {
    origin_ = originBefore_ + by;
    fitsItself_ = false;
    keepInView();
    Q_EMIT moved();
  } else if (gesture_ == Gesture::Moving) {
    view_.dragged = movedNodes();
    view_.drop =
        graph_.dropAt(toGraph(event->pos()), *graph_.node(pressedNode_).node, view_.dragged);
  } else if (gesture_ == Gesture::Band) {
    view_.band = QRectF(toGraph(pressedAt_), toGraph(event->pos())).normalized();
  } else {
    hover(event->pos());
    return;
  }
  update();
}

void TreeCanvas::endGesture() {
  gesture_ = Gesture::None;
  view_.dragged.clear();
  view_.band.reset();
  view_.drop.reset();
  unsetCursor();
  update();
}

/// Beside those that were selected before.
void TreeCanvas::selectBand(const QRectF& band) {
  std::vector<int> nodes = view_.selected;
  int last = view_.chosen;
  for (const int node : graph_.shown()) {
    if (graph_.box(node).intersects(band)) {
      nodes.push_back(node);
      last = node;
    }
  }
  select(std::move(nodes), last);
  Q_EMIT chose(view_.chosen);
}

void TreeCanvas::mouseReleaseEvent(QMouseEvent* /*event*/) {
  const Gesture gesture = gesture_;
  const std::optional<DropPlace> drop = view_.drop;
  const std::optional<QRectF> band = view_.band;
  endGesture();
  if (gesture == Gesture::Moving && drop) {
    Q_EMIT moveWanted(pressedNode_, *drop);
  } else if (gesture == Gesture::Band && band) {
    selectBand(*band);
  } else if (gesture == Gesture::Pressed && std::exchange(choosesOnRelease_, false)) {
    chooseByUser(pressedNode_);
  }
}

void TreeCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  const int node = graph_.nodeAt(toGraph(event->pos()));
  if (node >= 0 && event->button() == Qt::LeftButton) {
    Q_EMIT openWanted(node);
  }
}

void TreeCanvas::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  view_.hovered = -1;
  update();
}

void TreeCanvas::wheelEvent(QWheelEvent* event) {
  zoomBy(std::pow(kTreeWheelFactor, event->angleDelta().y()), event->position());
  event->accept();
}

void TreeCanvas::contextMenuEvent(QContextMenuEvent* event) {
  if (event->reason() == QContextMenuEvent::Keyboard) {
    const int node = view_.chosen;
    const QPoint at = node >= 0 ? centreOf(node) : rect().center();
    Q_EMIT menuWanted(node, mapToGlobal(at));
    return;
  }
  const int node = graph_.nodeAt(toGraph(event->pos()));
  if (!view_.isSelected(node)) {
    chooseByUser(node);
  }
  Q_EMIT menuWanted(node, event->globalPos());
}

namespace {

/// What a drag holds; an empty ID: nothing of ours.
bt::NodeSpec draggedNode(const QMimeData* data) {
  bt::TreeFile alone;
  const QString type = QString::fromLatin1(TreeCanvas::kMime);
  if (data == nullptr || !data->hasFormat(type)) {
    return {};
  }
  const base::Result<bt::NodeSpec> node = nodeFromText(data->data(type).toStdString(), alone);
  return node ? *node : bt::NodeSpec();
}

}  // namespace

void TreeCanvas::dragEnterEvent(QDragEnterEvent* event) {
  if (!draggedNode(event->mimeData()).id.empty()) {
    event->acceptProposedAction();
  }
}

void TreeCanvas::dragMoveEvent(QDragMoveEvent* event) {
  view_.drop = graph_.dropAt(toGraph(event->pos()), draggedNode(event->mimeData()), {});
  event->setAccepted(view_.drop.has_value());
  update();
}

void TreeCanvas::dragLeaveEvent(QDragLeaveEvent* /*event*/) {
  view_.drop.reset();
  update();
}

void TreeCanvas::dropEvent(QDropEvent* event) {
  const std::optional<DropPlace> drop =
      graph_.dropAt(toGraph(event->pos()), draggedNode(event->mimeData()), {});
  view_.drop.reset();
  update();
  if (drop) {
    event->acceptProposedAction();
    Q_EMIT dropWanted(QString::fromUtf8(event->mimeData()->data(QString::fromLatin1(kMime))),
                      *drop);
  }
}

}  // namespace editor
