#include "editor/trees/TreeCanvas.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "editor/document/PersonTree.h"
#include "editor/look/CoreText.h"
#include "editor/panels/behavior/TreeOutline.h"

namespace editor {

namespace {

constexpr double kMinZoom = 0.2, kMaxZoom = 2.0;
constexpr double kReadableZoom = 0.6;  // Smaller zooms only on request.
constexpr double kDots = 20.0;         // Grid spacing of the background [px].
constexpr double kEdgeRoom = 40.0;     // Minimum visible part of the tree [px].

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
  view_.selected = view_.chosen < 0 ? std::vector<int>() : std::vector<int>{view_.chosen};
  endGesture();
  relayout();
}

void TreeCanvas::relayout() {
  isAutoFit_ ? fitTo(fitLeast_) : keepPartlyVisible();
  update();
  Q_EMIT moved();
}

bool TreeCanvas::isFree(const QRect& place) const {
  const QRectF there(toGraph(place.topLeft()), QSizeF(place.size()) / zoom_);
  return std::none_of(graph_.shown().begin(), graph_.shown().end(), [&](int node) {
    return graph_.box(node).adjusted(-8, -8, 8, 12).intersects(there) ||
           isCrossedByLine(there, node);
  });
}

/// Whether the line from the node's parent passes through the rectangle of the graph.
bool TreeCanvas::isCrossedByLine(const QRectF& place, int node) const {
  const int parent = graph_.node(node).parent;
  if (parent < 0) {
    return false;
  }
  const bool isDown = graph_.direction() == TreeDirection::Down;
  const QPointF from = graph_.outlet(parent), to = graph_.inlet(node);
  const QPointF half = 0.5 * (from + to);
  const QPointF first = isDown ? QPointF(from.x(), half.y()) : QPointF(half.x(), from.y());
  const QPointF last = isDown ? QPointF(to.x(), half.y()) : QPointF(half.x(), to.y());
  const std::pair<QPointF, QPointF> parts[] = {{from, first}, {first, last}, {last, to}};
  return std::any_of(std::begin(parts), std::end(parts), [&place](const auto& part) {
    return QRectF(part.first, part.second).normalized().adjusted(-2, -2, 2, 2).intersects(place);
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
  select({node}, node);
}

void TreeCanvas::select(std::vector<int> nodes, int chosen) {
  const auto isGone = [this](int node) { return !graph_.has(node); };
  nodes.erase(std::remove_if(nodes.begin(), nodes.end(), isGone), nodes.end());
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  const bool isOf = std::count(nodes.begin(), nodes.end(), chosen) > 0;
  const int node = isOf ? chosen : nodes.empty() ? -1 : nodes.back();
  view_.chosen = node;
  view_.selected = std::move(nodes);
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
  Q_EMIT choiceChanged(view_.chosen);
}

void TreeCanvas::setDirection(TreeDirection direction) {
  graph_.setDirection(direction);
  fit();
}

void TreeCanvas::setPositionSource(TreeGraph::PositionSource positionSource) {
  graph_.setPositionSource(positionSource);
  fit();
}

void TreeCanvas::fit() {
  fitTo(kMinZoom);
}

void TreeCanvas::fitTo(double leastZoom) {
  const QRectF all = graph_.bounds();
  const double wide = width() / std::max(all.width(), 1.0);
  const double high = height() / std::max(all.height(), 1.0);
  zoom_ = std::clamp(std::min({wide, high, 1.0}), leastZoom, kMaxZoom);
  const bool isDown = graph_.direction() == TreeDirection::Down;
  const QPointF middle(0.5 * (width() - zoom_ * all.width()),
                       0.5 * (height() - zoom_ * all.height()));
  origin_ = isDown ? QPointF(middle.x(), std::min(middle.y(), 16.0))
                   : QPointF(std::min(middle.x(), 16.0), middle.y());
  origin_ = {std::round(origin_.x()), std::round(origin_.y())};
  if (!graph_.nodes().empty() && (wide < zoom_ || high < zoom_)) {  // Too large: root visible.
    const QPointF root = zoom_ * graph_.box(0).center();
    origin_ = isDown
                  ? QPointF(wide < zoom_ ? std::round(0.5 * width() - root.x()) : origin_.x(), 8)
                  : QPointF(8, high < zoom_ ? std::round(0.5 * height() - root.y()) : origin_.y());
  }
  fitLeast_ = leastZoom;
  isAutoFit_ = true;
  update();
  Q_EMIT moved();
}

void TreeCanvas::zoomBy(double factor, const QPointF& about) {
  const QPointF held = toGraph(about);
  zoom_ = std::clamp(zoom_ * factor, kMinZoom, kMaxZoom);
  origin_ = about - zoom_ * held;
  isAutoFit_ = false;
  keepPartlyVisible();
  update();
  Q_EMIT moved();
}

/// Keeps a part of the tree visible.
void TreeCanvas::keepPartlyVisible() {
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
    isAutoFit_ = false;
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
  const QPointF first(std::fmod(origin_.x(), step), std::fmod(origin_.y(), step));
  for (int column = 0; first.x() + column * step < width(); ++column) {
    for (int row = 0; first.y() + row * step < height(); ++row) {
      painter.drawPoint(first + step * QPointF(column, row));
    }
  }
  painter.translate(origin_);
  painter.scale(zoom_, zoom_);
  const QRectF seen(toGraph({}), toGraph(QPointF(width(), height())));
  TreePainter(graph_, view_, theme_).paint(painter, seen);
}

QString TreeCanvas::tipOf(int node) const {
  const bt::NodeSpec& spec = *graph_.node(node).node;
  const bt::NodeManifest* manifest = treeCatalogue().find(spec.id);
  QStringList lines = {nodeTitle(spec),
                       QString::fromStdString(spec.isSubTree() ? spec.subTree : spec.id)};
  const QString values = nodeValues(spec);
  lines << (values.isEmpty() ? QStringList() : QStringList(values));
  lines.removeDuplicates();
  lines << (manifest == nullptr ? tr("Unknown node type; it is kept unchanged.")
                                : coreText(manifest->description));
  if (!graph_.isEditable(node)) {
    lines << tr("In an included file: read-only here");
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

}  // namespace editor
