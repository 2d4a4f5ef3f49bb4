#include "editor/trees/TreeCanvas.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <QApplication>
#include <QHelpEvent>
#include <QMimeData>
#include <QMouseEvent>
#include <QToolTip>

#include "editor/document/TreeFiles.h"

namespace editor {

namespace {

constexpr double kLeastZoom = 0.2, kMostZoom = 2.0;
constexpr double kReadableZoom = 0.6;        // smaller only when asked for
constexpr double kTreeWheelFactor = 1.0015;  // per unit of the wheel
constexpr double kDots = 20.0;               // of the ground [px]
constexpr double kEdgeRoom = 40.0;           // of the tree that stays in the window [px]

}  // namespace

TreeCanvas::TreeCanvas(const Theme& theme)
    : theme_(theme), graph_(theme), fitLeast_(kReadableZoom) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAcceptDrops(true);
  setMinimumSize(200, 120);
  setAccessibleName(tr("Behaviour tree as a graph"));
}

void TreeCanvas::setTheme(const Theme& theme) {
  theme_ = theme;
  update();
}

void TreeCanvas::showTree(const PersonTree& tree) {
  graph_.setTree(tree);
  view_.statuses.clear();
  view_.drop.reset();
  view_.hovered = -1;
  if (!graph_.has(view_.chosen)) {
    view_.chosen = -1;
  }
  endGesture();
  relayout();
}

void TreeCanvas::relayout() {
  fitsItself_ ? fitTo(fitLeast_) : keepInView();
  update();
  Q_EMIT moved();
}

bool TreeCanvas::isFree(const QRect& place) const {
  const QRectF there(toGraph(place.topLeft()), QSizeF(place.size()) / zoom_);
  return std::none_of(graph_.shown().begin(), graph_.shown().end(), [&](int node) {
    return graph_.box(node).adjusted(-8, -8, 8, 12).intersects(there);
  });
}

void TreeCanvas::showStatuses(std::vector<base::NodeStatus> statuses) {
  if (statuses != view_.statuses) {
    view_.statuses = std::move(statuses);
    update();
  }
}

void TreeCanvas::showBreakpoints(std::vector<sim2d::TreeBreakpoint> points) {
  view_.breakpoints = std::move(points);
  update();
}

void TreeCanvas::choose(int node) {
  view_.chosen = graph_.has(node) ? node : -1;
  if (view_.chosen >= 0) {
    const bool wasHidden = !graph_.isShown(node);
    graph_.show(node);
    if (wasHidden) {
      relayout();
    }
    bringIntoView(node);
  }
  update();
}

void TreeCanvas::chooseByUser(int node) {
  choose(node);
  Q_EMIT chose(view_.chosen);
}

void TreeCanvas::setDirection(TreeDirection direction) {
  graph_.setDirection(direction);
  fit();
}

void TreeCanvas::fit() {
  fitTo(kLeastZoom);
}

void TreeCanvas::fitTo(double leastZoom) {
  const QRectF all = graph_.bounds();
  const double wide = width() / std::max(all.width(), 1.0);
  const double high = height() / std::max(all.height(), 1.0);
  zoom_ = std::clamp(std::min({wide, high, 1.0}), leastZoom, kMostZoom);
  const bool isDown = graph_.direction() == TreeDirection::Down;
  const QPointF middle(0.5 * (width() - zoom_ * all.width()),
                       0.5 * (height() - zoom_ * all.height()));
  origin_ = isDown ? QPointF(middle.x(), std::min(middle.y(), 16.0))
                   : QPointF(std::min(middle.x(), 16.0), middle.y());
  origin_ = {std::round(origin_.x()), std::round(origin_.y())};
  if (!graph_.nodes().empty() && (wide < zoom_ || high < zoom_)) {  // too large: the root is seen
    const QPointF root = zoom_ * graph_.box(0).center();
    origin_ = isDown
                  ? QPointF(wide < zoom_ ? std::round(0.5 * width() - root.x()) : origin_.x(), 8)
                  : QPointF(8, high < zoom_ ? std::round(0.5 * height() - root.y()) : origin_.y());
  }
  fitLeast_ = leastZoom;
  fitsItself_ = true;
  update();
  Q_EMIT moved();
}

void TreeCanvas::zoomBy(double factor, const QPointF& about) {
  const QPointF held = toGraph(about);
  zoom_ = std::clamp(zoom_ * factor, kLeastZoom, kMostZoom);
  origin_ = about - zoom_ * held;
  fitsItself_ = false;
  keepInView();
  update();
  Q_EMIT moved();
}

/// Some of it is always seen.
void TreeCanvas::keepInView() {
  const QRectF all(origin_, zoom_ * graph_.bounds().size());
  const auto within = [](double begin, double length, double room) {
    const double most = room - kEdgeRoom, least = kEdgeRoom - length;
    return least < most ? std::clamp(begin, least, most) : begin;
  };
  origin_ = {within(all.x(), all.width(), width()), within(all.y(), all.height(), height())};
}

void TreeCanvas::bringIntoView(int node) {
  const QRectF box(fromGraph(graph_.box(node).topLeft()), zoom_ * graph_.box(node).size());
  const QRectF room = QRectF(rect()).adjusted(12, 12, -12, -12);
  const auto shift = [](double low, double high, double least, double most) {
    return low < least ? least - low : high > most ? most - high : 0.0;
  };
  const QPointF by(shift(box.left(), box.right(), room.left(), room.right()),
                   shift(box.top(), box.bottom(), room.top(), room.bottom()));
  if (!by.isNull() && room.width() > box.width() && room.height() > box.height()) {
    origin_ += by;
    fitsItself_ = false;
    Q_EMIT moved();
  }
}

void TreeCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  relayout();
}

void TreeCanvas::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), theme_.color(Role::Window));
  painter.setPen(theme_.color(Role::Line));
  const double step = kDots * std::max(1.0, std::round(1.0 / zoom_));
  for (double x = std::fmod(origin_.x(), step); x < width(); x += step) {
    for (double y = std::fmod(origin_.y(), step); y < height(); y += step) {
      painter.drawPoint(QPointF(x, y));
    }
  }
  painter.translate(origin_);
  painter.scale(zoom_, zoom_);
  const QRectF seen(toGraph({}), toGraph(QPointF(width(), height())));
  TreePainter(graph_, view_, theme_).paint(painter, seen);
}

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
  for (const int node : graph_.shown()) {
    const bool isKnob = TreePainter::knobOf(graph_, node).contains(at);
    if (isKnob && event->button() == Qt::LeftButton &&
        (graph_.isFolded(node) || !graph_.box(node).contains(at))) {
      graph_.setFolded(node, !graph_.isFolded(node));
      relayout();
      return;
    }
  }
  pressedNode_ = graph_.nodeAt(at);
  chooseByUser(pressedNode_);
  if (event->button() == Qt::LeftButton) {
    gesture_ = Gesture::Pressed;
    originBefore_ = origin_;  // choosing may have moved it
  }
}

void TreeCanvas::mouseMoveEvent(QMouseEvent* event) {
  const QPoint by = event->pos() - pressedAt_;
  if (gesture_ == Gesture::Pressed && by.manhattanLength() >= QApplication::startDragDistance()) {
    const bool canMove = pressedNode_ > 0 && graph_.has(pressedNode_) &&
                         graph_.isEditable(pressedNode_) && !graph_.placeOf(pressedNode_).isRoot();
    gesture_ = pressedNode_ < 0 || !canMove ? Gesture::Panning : Gesture::Moving;
    setCursor(Qt::ClosedHandCursor);
  }
  if (gesture_ == Gesture::Panning) {
    origin_ = originBefore_ + by;
    fitsItself_ = false;
    keepInView();
    Q_EMIT moved();
  } else if (gesture_ == Gesture::Moving) {
    view_.dragged = pressedNode_;
    view_.drop =
        graph_.dropAt(toGraph(event->pos()), *graph_.node(pressedNode_).node, pressedNode_);
  } else {
    hover(event->pos());
    return;
  }
  update();
}

void TreeCanvas::endGesture() {
  gesture_ = Gesture::None;
  view_.dragged = -1;
  view_.drop.reset();
  unsetCursor();
  update();
}

void TreeCanvas::mouseReleaseEvent(QMouseEvent* /*event*/) {
  const bool isMoved = gesture_ == Gesture::Moving;
  const std::optional<DropPlace> drop = view_.drop;
  endGesture();
  if (isMoved && drop) {
    Q_EMIT moveWanted(pressedNode_, *drop);
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
  chooseByUser(node);
  Q_EMIT menuWanted(node, event->globalPos());
}

/// Keys that are the canvas's own although commands of the window wait for them.
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
  const bool isCtrl = held == Qt::ControlModifier && event.key() == Qt::Key_D;
  const bool isArrow = event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down &&
                       (held == Qt::NoModifier || held == Qt::AltModifier);
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
      chooseByUser(graph_.beside(view_.chosen, way));
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

QString TreeCanvas::tipOf(int node) const {
  const bt::NodeSpec& spec = *graph_.node(node).node;
  const bt::NodeManifest* manifest = treeCatalogue().find(spec.id);
  QStringList lines = {QString::fromStdString(spec.isSubTree() ? spec.subTree : spec.id)};
  lines << (manifest == nullptr ? tr("This program does not know the node; it is kept as it is.")
                                : QString::fromStdString(manifest->description));
  if (!graph_.isEditable(node)) {
    lines << tr("In an included file: not edited here");
  }
  for (const TreeGraph::Problem& problem : graph_.problemsOf(node)) {
    lines << QStringLiteral("⚠ ") + problem.text;
  }
  return lines.join(QLatin1Char('\n'));
}

bool TreeCanvas::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      isCommand(static_cast<const QKeyEvent&>(*event))) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::ToolTip) {
    const auto& help = static_cast<const QHelpEvent&>(*event);
    const int node = graph_.nodeAt(toGraph(help.pos()));
    node < 0 ? QToolTip::hideText() : QToolTip::showText(help.globalPos(), tipOf(node), this);
    return true;
  }
  return QWidget::event(event);
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
  view_.drop = graph_.dropAt(toGraph(event->pos()), draggedNode(event->mimeData()), -1);
  event->setAccepted(view_.drop.has_value());
  update();
}

void TreeCanvas::dragLeaveEvent(QDragLeaveEvent* /*event*/) {
  view_.drop.reset();
  update();
}

void TreeCanvas::dropEvent(QDropEvent* event) {
  const std::optional<DropPlace> drop =
      graph_.dropAt(toGraph(event->pos()), draggedNode(event->mimeData()), -1);
  view_.drop.reset();
  update();
  if (drop) {
    event->acceptProposedAction();
    Q_EMIT dropWanted(QString::fromUtf8(event->mimeData()->data(QString::fromLatin1(kMime))),
                      *drop);
  }
}

}  // namespace editor
