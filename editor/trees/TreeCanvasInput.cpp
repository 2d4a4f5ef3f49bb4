

// Keyboard and mouse handling of TreeCanvas.
#include <cmath>
#include <iterator>
#include <utility>

#include "editor/trees/TreeCanvas.h"

namespace editor {

/// Keys that the canvas handles although window shortcuts use them.
bool TreeCanvas::isCommand(const QKeyEvent& event) const {
  const QKeySequence::StandardKey standard[] = {QKeySequence::Copy, QKeySequence::Cut,
                                                QKeySequence::Paste};
  const bool isStandard = std::any_of(std::begin(standard), std::end(standard),
                                      [&event](auto key) { return event.matches(key); });
  const int plain[] = {Qt::Key_Delete, Qt::Key_Backspace, Qt::Key_F2,
                       Qt::Key_F,      Qt::Key_Insert,    Qt::Key_Plus,
                       Qt::Key_Minus,  Qt::Key_Return,    Qt::Key_Enter};
  const Qt::KeyboardModifiers held = event.modifiers() & ~Qt::KeypadModifier;
  const bool isPlain =
      held == Qt::NoModifier && std::count(std::begin(plain), std::end(plain), event.key()) > 0;
  const bool isCtrl =
      held == Qt::ControlModifier && (event.key() == Qt::Key_D || event.key() == Qt::Key_A);
  const bool isArrow =
      event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down &&
      (held == Qt::NoModifier || held == Qt::AltModifier || held == Qt::ShiftModifier);
  return isStandard || isPlain || isCtrl || isArrow;
}

bool TreeCanvas::moveChosen(const QKeyEvent& event) {
  using Way = TreeGraph::Way;
  const std::pair<int, Way> ways[] = {{Qt::Key_Up, Way::Up},
                                      {Qt::Key_Down, Way::Down},
                                      {Qt::Key_Left, Way::Left},
                                      {Qt::Key_Right, Way::Right}};
  for (const auto& [key, way] : ways) {
    if (event.key() == key && (event.modifiers() & Qt::AltModifier) == 0) {
      const int next = graph_.beside(view_.chosen, way);
      if ((event.modifiers() & Qt::ShiftModifier) == 0) {
        chooseByUser(next);
      } else if (next >= 0) {
        std::vector<int> nodes = view_.selected;
        nodes.push_back(next);
        select(std::move(nodes), next);
        Q_EMIT choiceChanged(view_.chosen);
      }
      return true;
    }
  }
  return false;
}

void TreeCanvas::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && gesture_ != Gesture::None) {
    origin_ = gesture_ == Gesture::Panning ? originBefore_ : origin_;
    endGesture();
    return;
  }
  if (!isCommand(*event)) {
    if (event->key() == Qt::Key_Escape) {
      Q_EMIT escaped();
    }
    QWidget::keyPressEvent(event);
    return;
  }
  if (moveChosen(*event)) {
    return;
  }
  if (event->key() == Qt::Key_F) {
    fit();
  } else if (event->key() == Qt::Key_A) {
    select(graph_.shown(), view_.chosen);
    Q_EMIT choiceChanged(view_.chosen);
  } else if (event->key() == Qt::Key_Plus || event->key() == Qt::Key_Minus) {
    const bool hasFold = view_.chosen >= 0 && !graph_.childrenOf(view_.chosen).empty();
    if (hasFold) {
      graph_.setFolded(view_.chosen, event->key() == Qt::Key_Minus);
      relayout();
    }
  } else {
    Q_EMIT keyCommand(event->key(), event->modifiers());
  }
}

// Mouse.

namespace {

constexpr double kTreeWheelFactor = 1.0015;  // Per wheel unit.
constexpr Qt::KeyboardModifiers kMore = Qt::ShiftModifier | Qt::ControlModifier;

bool isAdding(const QMouseEvent& event) {
  return (event.modifiers() & kMore) != 0;
}

}  // namespace

void TreeCanvas::hover(const QPoint& at) {
  int node = graph_.nodeAt(toGraph(at));
  if (node < 0 && view_.hovered >= 0 &&
      TreePainter::foldHandleRect(graph_, view_.hovered).contains(toGraph(at))) {
    node = view_.hovered;
  }
  if (node != view_.hovered) {
    view_.hovered = node;
    update();
  }
}

/// Folds or unfolds the node whose knob is at the point. Returns true if there is one.
bool TreeCanvas::pressFoldHandle(const QPointF& at) {
  for (const int node : graph_.shown()) {
    const bool isKnob = TreePainter::foldHandleRect(graph_, node).contains(at);
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
  if (event->button() == Qt::LeftButton && pressFoldHandle(at)) {
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
    choosesOnRelease_ = true;  // A click on one of several selected nodes selects only that one.
  } else {
    chooseByUser(pressedNode_);
  }
  if (event->button() == Qt::LeftButton) {
    gesture_ = view_.band ? Gesture::Band : Gesture::Pressed;
    originBefore_ = origin_;  // Choosing may have moved the graph.
  }
}

void TreeCanvas::toggleByUser(int node) {
  std::vector<int> nodes = view_.selected;
  const auto found = std::find(nodes.begin(), nodes.end(), node);
  found == nodes.end() ? nodes.push_back(node) : (void)nodes.erase(found);
  select(std::move(nodes), node);
  Q_EMIT choiceChanged(view_.chosen);
}

/// The nodes that a drag from the pressed node moves: all selected ones if it is selected.
std::vector<int> TreeCanvas::movedNodes() const {
  std::vector<int> nodes;
  const std::vector<int> one = {pressedNode_};
  const bool isOfSelected = view_.isSelected(pressedNode_);
  for (const int node : isOfSelected ? view_.selected : one) {  // Parents precede children.
    int above = graph_.has(node) ? graph_.node(node).parent : -1;
    while (above >= 0 && std::find(nodes.begin(), nodes.end(), above) == nodes.end()) {
      above = graph_.node(above).parent;
    }
    if (above < 0 && graph_.has(node) && graph_.isEditable(node) &&
        !graph_.locationOf(node).isRoot()) {
      nodes.push_back(node);
    }
  }
  return nodes;
}

void TreeCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPoint by = event->pos() - pressedAt_;
  if (gesture_ == Gesture::Pressed && by.manhattanLength() >= QApplication::startDragDistance()) {
    const bool canMove = pressedNode_ > 0 && graph_.has(pressedNode_) && !movedNodes().empty() &&
                         graph_.isEditable(pressedNode_) &&
                         !graph_.locationOf(pressedNode_).isRoot();
    gesture_ = canMove ? Gesture::Moving : Gesture::Panning;
    setCursor(Qt::ClosedHandCursor);
  }
  if (gesture_ == Gesture::Panning) {
    origin_ = originBefore_ + by;
    isAutoFit_ = false;
    keepPartlyVisible();
    Q_EMIT moved();
  } else if (gesture_ == Gesture::Moving) {
    view_.dragged = movedNodes();
    view_.drop =
        graph_.dropTargetAt(toGraph(event->pos()), *graph_.node(pressedNode_).node, view_.dragged);
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

/// In addition to the previous selection.
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
  Q_EMIT choiceChanged(view_.chosen);
}

void TreeCanvas::mouseReleaseEvent(QMouseEvent* /*event*/) {
  const Gesture gesture = gesture_;
  const std::optional<DropTarget> drop = view_.drop;
  const std::optional<QRectF> band = view_.band;
  endGesture();
  if (gesture == Gesture::Moving && drop) {
    Q_EMIT moveRequested(pressedNode_, *drop);
  } else if (gesture == Gesture::Band && band) {
    selectBand(*band);
  } else if (gesture == Gesture::Pressed && std::exchange(choosesOnRelease_, false)) {
    chooseByUser(pressedNode_);
  }
}

void TreeCanvas::mouseDoubleClickEvent(QMouseEvent* event) {
  const int node = graph_.nodeAt(toGraph(event->pos()));
  if (node >= 0 && event->button() == Qt::LeftButton) {
    Q_EMIT openRequested(node);
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
    Q_EMIT menuRequested(node, mapToGlobal(at));
    return;
  }
  const int node = graph_.nodeAt(toGraph(event->pos()));
  if (!view_.isSelected(node)) {
    chooseByUser(node);
  }
  Q_EMIT menuRequested(node, event->globalPos());
}

namespace {

/// The dragged node; its ID is empty if the data has another format.
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
  view_.drop = graph_.dropTargetAt(toGraph(event->pos()), draggedNode(event->mimeData()), {});
  event->setAccepted(view_.drop.has_value());
  update();
}

void TreeCanvas::dragLeaveEvent(QDragLeaveEvent* /*event*/) {
  view_.drop.reset();
  update();
}

void TreeCanvas::dropEvent(QDropEvent* event) {
  const std::optional<DropTarget> drop =
      graph_.dropTargetAt(toGraph(event->pos()), draggedNode(event->mimeData()), {});
  view_.drop.reset();
  update();
  if (drop) {
    event->acceptProposedAction();
    Q_EMIT dropRequested(QString::fromUtf8(event->mimeData()->data(QString::fromLatin1(kMime))),
                         *drop);
  }
}

}  // namespace editor
