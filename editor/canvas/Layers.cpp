#include "editor/canvas/Layers.h"

#include <cmath>
#include <limits>

#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/ViewOverlays.h"
#include "editor/document/PeopleEdits.h"

namespace editor {

namespace {

constexpr double kTurnPx = 52.0;
constexpr double kShapeTurnPx = 24.0;   // Distance beyond the outline.
constexpr std::size_t kMaxHandles = 8;  // Maximum number of selected entities that show handles.
constexpr double kHandlePx = 8.0;
constexpr double kTurnHandlePx = 10.0;
constexpr double kHandleReachPx = 8.0;
constexpr double kCornerPx = 6.0;
constexpr double kSnapMarkPx = 7.0;
constexpr double kTextPx = 16.0;      // Height of the length of a dimension line.
constexpr double kTextRoomPx = 14.0;  // Free part of the line at both ends of its length.
constexpr double kGapTickPx = 4.0;    // Half length of the ends of a dimension line.
constexpr double kRingGapPx = 3.0;    // Distance between a body and its group ring.
constexpr double kMinRingPx = 7.0;

QPen accentPen(const QPainter& painter, const Theme& theme, double widthPx) {
  return screenPen(painter, theme.color(Role::Accent), widthPx, Qt::SolidLine, Qt::SquareCap);
}

void paintGrid(QPainter& painter, const QColor& color, const QRectF& area, double step,
               double alpha) {
  painter.setPen(cosmetic(QPen(withAlpha(color, alpha), 1.0), painter));
  QVector<QLineF> lines;
  for (const double x : multiplesIn(area.left(), area.right(), step)) {
    lines << QLineF(x, area.top(), x, area.bottom());
  }
  for (const double y : multiplesIn(area.top(), area.bottom(), step)) {
    lines << QLineF(area.left(), y, area.right(), y);
  }
  painter.drawLines(lines);
}

}  // namespace

void GridItem::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (!options().grid) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing, false);
  const QRectF area = boundingRect() & option->exposedRect.adjusted(-0.1, -0.1, 0.1, 0.1);
  const double strength = theme().isDark() ? 0.055 : 0.07;
  for (const double step : {1.0, 5.0, 25.0}) {
    const double px = pixelsPerMetreOf(*painter) * step;
    const double alpha = strength * std::clamp((px - 8.0) / 22.0, 0.0, 1.0);  // Fades if dense.
    if (alpha > 0.0) {
      paintGrid(*painter, theme().color(Role::Text), area, step, alpha);
    }
  }
}

std::vector<std::pair<std::size_t, std::size_t>> minimumSpanningTree(
    const std::vector<Vec2>& points) {
  std::vector<std::pair<std::size_t, std::size_t>> links;
  std::vector<std::size_t> nearest(points.size(), 0);  // The nearest joined point, for each point.
  std::vector<double> distance(points.size(), std::numeric_limits<double>::max());
  std::vector<bool> joined(points.size(), false);
  std::size_t newest = 0;
  for (std::size_t count = 1; count < points.size(); ++count) {
    joined[newest] = true;
    std::size_t next = points.size();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double toNewest = (points[i] - points[newest]).norm();
      if (!joined[i] && toNewest < distance[i]) {
        distance[i] = toNewest;
        nearest[i] = newest;
      }
      if (!joined[i] && (next == points.size() || distance[i] < distance[next])) {
        next = i;
      }
    }
    links.emplace_back(nearest[next], next);
    newest = next;
  }
  return links;
}

/// A group with a moving member belongs to the moving part.
bool GroupLayer::isPartOf(const std::vector<EntityId>& people) const {
  const auto isPainted = [this](EntityId id) { return mapScene().isPainted(id); };
  return mapScene().paintedPart() == CanvasPart::Moving
             ? std::any_of(people.begin(), people.end(), isPainted)
             : std::all_of(people.begin(), people.end(), isPainted);
}

void GroupLayer::paintGroup(QPainter& painter, const QColor& color,
                            const std::vector<EntityId>& people) const {
  std::vector<Vec2> places;
  std::vector<double> radii;  // [m]
  for (const EntityId id : people) {
    const std::optional<Entity> value = mapScene().shown(id);
    const auto* human = value ? std::get_if<sim2d::Human>(&*value) : nullptr;
    if (human == nullptr || !human->listed) {
      continue;
    }
    const std::optional<Vec2> at = mapScene().isRunMode()
                                       ? mapScene().frameLayer().positionOf(human->id)
                                       : std::optional(human->initPose.position);
    if (at) {
      places.push_back(*at);
      radii.push_back(mapScene().figureRadius(*value));
    }
  }
  painter.setPen(cosmetic(dashedPen(color, 1.5, {1.0, 3.0}, Qt::RoundCap), painter));
  for (const auto& [from, to] : minimumSpanningTree(places)) {
    painter.drawLine(toScene(places[from]), toScene(places[to]));
  }
  const double pixelsPerMetre = pixelsPerMetreOf(painter);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PixelFrame frame(painter, toScene(places[i]));
    paintRing(painter, QPen(color, 2.0),
              std::max(radii[i] * pixelsPerMetre + kRingGapPx, kMinRingPx));
  }
}

void GroupLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  if (!options().groups || !options().people) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  for (const auto& [group, people] : groupsOf(document().scenario())) {
    if (isPartOf(people)) {
      paintGroup(*painter, groupColor(group, theme()), people);
    }
  }
}

std::vector<Handle> SelectionLayer::handlesFor(const Entity& entity) const {
  const double pixelsPerMetre = mapScene().pixelsPerMetre();
  HandleSizes sizes;
  sizes.bodyRadius = mapScene().bodyRadius(entity);
  sizes.turnDistance = kTurnPx / pixelsPerMetre;
  if (kindOf(entity) != EntityKind::Human && kindOf(entity) != EntityKind::Robot) {
    sizes.turnDistance = kShapeTurnPx / pixelsPerMetre;
  }
  std::vector<Handle> handles = handlesOf(entity, sizes);
  const bool isSmall = sizes.bodyRadius * pixelsPerMetre < 12.0;
  if ((isSmall && kindOf(entity) == EntityKind::Human) ||  // Handles would hide the figure.
      !mapScene().isSizable(entity)) {
    handles.erase(
        std::remove_if(handles.begin(), handles.end(),
                       [](const Handle& handle) { return handle.kind == Handle::Kind::Size; }),
        handles.end());
  }
  return handles;
}

/// The visible handles, each with its entity.
std::vector<std::pair<EntityId, Handle>> SelectionLayer::handles() const {
  std::vector<std::pair<EntityId, Handle>> all;
  const std::vector<EntityId>& selection = document().selection();
  for (const EntityId id : selection.size() > kMaxHandles ? std::vector<EntityId>() : selection) {
    if (const std::optional<Entity> entity = mapScene().shown(id)) {
      for (const Handle& handle : handlesFor(*entity)) {
        all.emplace_back(id, handle);
      }
    }
  }
  return all;
}

std::pair<EntityId, Handle> SelectionLayer::handleAt(const Vec2& world) const {
  const double reach = kHandleReachPx / mapScene().pixelsPerMetre();
  for (const auto& [id, handle] : handles()) {
    if ((handle.position - world).cwiseAbs().maxCoeff() <= reach) {
      return {id, handle};
    }
  }
  return {};
}

std::vector<QRectF> SelectionLayer::labelObstacles() const {
  const double reach = 0.75 * kTurnHandlePx / mapScene().pixelsPerMetre();
  std::vector<QRectF> parts;
  for (const auto& [id, handle] : handles()) {
    parts.push_back(around(toScene(handle.position), reach));
  }
  return parts;
}

void SelectionLayer::paintFrame(QPainter& painter, const Entity& entity,
                                const std::vector<Handle>& handles) const {
  setPenAndBrush(painter, accentPen(painter, theme(), 2.0));
  QPolygonF frame;
  for (const Handle& handle : handles) {
    if (handle.kind == Handle::Kind::Size || handle.kind == Handle::Kind::Vertex) {
      frame << toScene(handle.position);
    }
  }
  if (kindOf(entity) == EntityKind::Door || isOpenPolyline(entity)) {
    painter.drawPolyline(frame);
  } else if (frame.size() > 2) {
    painter.drawPolygon(frame);
  } else if (kindOf(entity) == EntityKind::Human || kindOf(entity) == EntityKind::Robot ||
             kindOf(entity) == EntityKind::Dock) {
    const double radius = mapScene().figureRadius(entity) + 4.0 / pixelsPerMetreOf(painter);
    painter.drawEllipse(toScene(*positionOf(entity)), radius, radius);
  }
}

void SelectionLayer::paintHandle(QPainter& painter, const Entity& entity,
                                 const Handle& handle) const {
  const QPointF at = toScene(handle.position);
  const bool isTurn = handle.kind == Handle::Kind::Turn;
  if (isTurn) {
    painter.setPen(accentPen(painter, theme(), 1.5));
    const QLineF arm(toScene(*positionOf(entity)), at);
    painter.drawLine(arm.pointAt(0.5), at);
  }
  const PixelFrame frame(painter, at);
  setPenAndBrush(painter, QPen(theme().color(Role::Accent), 2.0), theme().color(Role::Panel));
  if (isTurn) {
    painter.drawEllipse(QPointF(), 0.5 * kTurnHandlePx, 0.5 * kTurnHandlePx);
  } else if (handle.kind == Handle::Kind::RobotGoal) {
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(QPointF(), 14.0, 14.0);
  } else {
    painter.setPen(QPen(theme().color(Role::Accent), 1.5));
    painter.drawRect(QRectF(-0.5 * kHandlePx, -0.5 * kHandlePx, kHandlePx, kHandlePx));
  }
}

void SelectionLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem* option, QWidget*) {
  if (mapScene().isRunMode()) {
    return;
  }
  painter->setRenderHint(QPainter::Antialiasing);
  const std::vector<EntityId>& selection = document().selection();
  for (const EntityId id : selection) {
    const std::optional<Entity> entity = mapScene().shown(id);
    const EntityItem* item = mapScene().item(id);
    const bool isSeen = item != nullptr && item->isVisible() &&
                        item->boundingRect().intersects(option->exposedRect);
    if (!entity || (!isSeen && selection.size() > kMaxHandles)) {
      continue;
    }
    const std::vector<Handle> handles = handlesFor(*entity);
    paintFrame(*painter, *entity, handles);
    if (selection.size() <= kMaxHandles) {
      for (const Handle& handle : handles) {
        paintHandle(*painter, *entity, handle);
      }
    }
  }
}

void ToolLayer::paintOutline(QPainter& painter) const {
  const ToolLine& outline = marks_.outline;
  const Role role = outline.isBad ? Role::Error : Role::Accent;
  const QPolygonF polygon = toScene(outline.points);
  setPenAndBrush(painter, screenPen(painter, theme().color(role), 2.0));
  if (outline.isClosed && polygon.size() > 2) {
    painter.setBrush(theme().color(role, 0.08));
    painter.drawPolygon(polygon);
  } else {
    painter.drawPolyline(polygon);
  }
  for (const QPointF& corner : outline.hasCorners ? polygon : QPolygonF()) {
    const PixelFrame frame(painter, corner);
    setPenAndBrush(painter, QPen(theme().color(role), 1.5), theme().color(Role::Panel));
    painter.drawRect(QRectF(-0.5 * kCornerPx, -0.5 * kCornerPx, kCornerPx, kCornerPx));
  }
}

void ToolLayer::paintLines(QPainter& painter) const {
  if (!marks_.stroke.empty()) {
    setPenAndBrush(painter, QPen(theme().color(Role::Accent, 0.4), marks_.strokeWidth,
                                 Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPainterPath path = roundedPath(marks_.stroke, 0.0);
    if (marks_.stroke.size() == 1) {  // A dot.
      path.lineTo(path.currentPosition() + QPointF(1e-3, 0.0));
    }
    painter.drawPath(path);
  }
  if (!marks_.outline.points.empty()) {
    paintOutline(painter);
  }
  for (const ToolDot& dot : marks_.dots) {
    const QPointF at = toScene(dot.at);
    setPenAndBrush(painter, screenPen(painter, dot.color, 1.2), withAlpha(dot.color, 0.45));
    painter.drawEllipse(at, dot.radius, dot.radius);
    if (dot.heading) {
      painter.drawLine(at, toScene(Pose2{dot.at, *dot.heading}.ahead(dot.radius)));
    }
  }
}

void ToolLayer::paintArrows(QPainter& painter) const {
  const QPen pen = screenPen(painter, theme().color(Role::Accent), 2.0);
  if (marks_.line.size() > 1) {
    QPen dashes = pen;
    dashes.setDashPattern({4.0, 3.0});
    setPenAndBrush(painter, dashes);
    const QPainterPath path = roundedPath(marks_.line, 0.0);
    painter.drawPath(path);
    paintArrowHeads(painter, path, 1.5, 9.0, theme());
  }
  if (marks_.arrow) {
    painter.setPen(pen);
    const QLineF line(toScene(marks_.arrow->first), toScene(marks_.arrow->second));
    painter.drawLine(line);
    const PixelFrame frame(painter, line.p2());
    painter.setPen(QPen(theme().color(Role::Accent), 2.0));
    FigurePainter(theme()).arrowHead(painter, {}, line.angle(), 10.0);
  }
}

void ToolLayer::paintGuides(QPainter& painter) const {
  setPenAndBrush(painter, screenPen(painter, theme().color(Role::Guide), 1.0));
  for (const auto& [from, to] : marks_.guides.lines) {
    painter.drawLine(toScene(from), toScene(to));
  }
  for (const AlignmentGap& gap : marks_.guides.gaps) {
    paintGap(painter, gap);
  }
}

/// A dimension line with its length in a small box at its centre.
void ToolLayer::paintGap(QPainter& painter, const AlignmentGap& gap) const {
  const QPointF centre = toScene(0.5 * (gap.from + gap.to));
  const double pixels = (gap.to - gap.from).norm() * pixelsPerMetreOf(painter);
  const bool isFlat = std::abs(gap.to.y() - gap.from.y()) < std::abs(gap.to.x() - gap.from.x());
  const PixelFrame frame(painter, centre);
  painter.setPen(QPen(theme().color(Role::Guide), 1.0));
  const QPointF half = isFlat ? QPointF(0.5 * pixels, 0.0) : QPointF(0.0, 0.5 * pixels);
  const QPointF tick = isFlat ? QPointF(0.0, kGapTickPx) : QPointF(kGapTickPx, 0.0);
  painter.drawLine(-half, half);
  for (const QPointF& end : {-half, half}) {
    painter.drawLine(end - tick, end + tick);
  }
  const QString words = QStringLiteral("%1 m").arg((gap.to - gap.from).norm(), 0, 'f', 2);
  const QFont font = theme().figureFont(8.0);
  const double width = QFontMetricsF(font).horizontalAdvance(words) + 8.0;
  if (pixels < (isFlat ? width : kTextPx) + 2.0 * kTextRoomPx) {
    return;  // The text would cover the neighbours.
  }
  const QRectF box(-0.5 * width, -0.5 * kTextPx, width, kTextPx);
  setPenAndBrush(painter, Qt::NoPen, theme().color(Role::Guide));
  painter.drawRoundedRect(box, 3.0, 3.0);
  painter.setFont(font);
  painter.setPen(theme().color(Role::Panel));
  painter.drawText(box, Qt::AlignCenter, words);
}

void ToolLayer::paintTag(QPainter& painter) const {
  const auto& [at, words] = *marks_.tag;
  const PixelFrame frame(painter, toScene(at));
  const QFont font = theme().figureFont(9.0);
  const double width = QFontMetricsF(font).horizontalAdvance(words) + 14.0;
  QRectF box(16.0, 8.0, width, 22.0);
  const QPointF free = painter.window().bottomRight() - painter.worldTransform().map(QPointF());
  if (box.right() > free.x()) {
    box.moveRight(-box.left());
  }
  if (box.bottom() > free.y()) {
    box.moveBottom(-box.top());
  }
  setPenAndBrush(painter, Qt::NoPen, theme().color(Role::Text, 0.92));
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setFont(font);
  painter.setPen(theme().color(Role::Panel));
  painter.drawText(box, Qt::AlignCenter, words);
}

void ToolLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (marks_.band) {
    setPenAndBrush(*painter, screenPen(*painter, theme().color(Role::Accent), 1.0),
                   theme().color(Role::Accent, 0.10));
    painter->drawRect(
        QRectF(toScene(marks_.band->first), toScene(marks_.band->second)).normalized());
  }
  paintLines(*painter);
  paintArrows(*painter);
  paintGuides(*painter);
  if (marks_.snapMark) {
    const PixelFrame frame(*painter, toScene(*marks_.snapMark));
    paintRing(*painter, QPen(theme().color(Role::Accent), 1.5), kSnapMarkPx);
  }
  if (marks_.tag) {
    paintTag(*painter);
  }
}

}  // namespace editor
