#include <QFontMetricsF>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RouteLayer.h"

namespace editor {

namespace {

constexpr double kCornerPx = 6.0;
constexpr double kSnapMarkPx = 7.0;

}  // namespace

void ToolLayer::setRubberBand(const Vec2& corner, const Vec2& opposite) {
  const QRectF band(MapScene::sceneFromWorld(corner), MapScene::sceneFromWorld(opposite));
  show(marks_.band, band.normalized());
}

void ToolLayer::paintOutline(QPainter& painter) const {
  if (marks_.outline.points.empty()) {
    return;
  }
  const Role role = marks_.outline.isBad ? Role::Error : Role::Accent;
  QPolygonF polygon;
  for (const Vec2& point : marks_.outline.points) {
    polygon << MapScene::sceneFromWorld(point);
  }
  painter.setPen(screenPen(painter, theme().color(role), 2.0));
  if (marks_.outline.isClosed && polygon.size() > 2) {
    painter.setBrush(theme().color(role, 0.08));
    painter.drawPolygon(polygon);
  } else {
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(polygon);
  }
  if (!marks_.outline.hasCorners) {
    return;
  }
  for (const QPointF& corner : polygon) {
    const PixelFrame frame(painter, corner);
    painter.setPen(QPen(theme().color(role), 1.5));
    painter.setBrush(theme().color(Role::Panel));
    painter.drawRect(QRectF(-0.5 * kCornerPx, -0.5 * kCornerPx, kCornerPx, kCornerPx));
  }
}

void ToolLayer::paintStroke(QPainter& painter) const {
  if (marks_.stroke.empty()) {
    return;
  }
  painter.setPen(QPen(theme().color(Role::Accent, 0.4), marks_.strokeWidth, Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPainterPath path = softPath(marks_.stroke, 0.0);
  if (marks_.stroke.size() == 1) {  // a dot
    path.lineTo(path.currentPosition() + QPointF(1e-3, 0.0));
  }
  painter.drawPath(path);
}

void ToolLayer::paintDots(QPainter& painter) const {
  for (const ToolDot& dot : marks_.dots) {
    const QPointF at = MapScene::sceneFromWorld(dot.at);
    QColor fill = dot.color;
    fill.setAlphaF(0.45);
    painter.setPen(screenPen(painter, dot.color, 1.2));
    painter.setBrush(fill);
    painter.drawEllipse(at, dot.radius, dot.radius);
    if (dot.heading) {
      painter.drawLine(at, MapScene::sceneFromWorld(Pose2{dot.at, *dot.heading}.ahead(dot.radius)));
    }
  }
}

void ToolLayer::paintLine(QPainter& painter) const {
  if (marks_.line.size() < 2) {
    return;
  }
  QPen pen = screenPen(painter, theme().color(Role::Accent), 2.0);
  pen.setDashPattern({4.0, 3.0});
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  const QPainterPath path = softPath(marks_.line, 0.0);
  painter.drawPath(path);
  paintArrowHeads(painter, path, 1.5, 9.0, theme());
}

void ToolLayer::paintArrow(QPainter& painter) const {
  if (!marks_.arrow) {
    return;
  }
  painter.setPen(screenPen(painter, theme().color(Role::Accent), 2.0));
  const QLineF line(MapScene::sceneFromWorld(marks_.arrow->first),
                    MapScene::sceneFromWorld(marks_.arrow->second));
  painter.drawLine(line);
  const PixelFrame frame(painter, line.p2());
  painter.setPen(QPen(theme().color(Role::Accent), 2.0));
  FigurePainter(theme()).arrowHead(painter, {}, line.angle(), 10.0);
}

void ToolLayer::paintSnapMark(QPainter& painter) const {
  if (!marks_.snapMark) {
    return;
  }
  const PixelFrame frame(painter, MapScene::sceneFromWorld(*marks_.snapMark));
  paintRing(painter, QPen(theme().color(Role::Accent), 1.5), kSnapMarkPx);
}

void ToolLayer::paintTag(QPainter& painter) const {
  if (!marks_.tag) {
    return;
  }
  const PixelFrame frame(painter, MapScene::sceneFromWorld(marks_.tag->first));
  const QFont font = theme().figureFont(9.0);
  const double width = QFontMetricsF(font).horizontalAdvance(marks_.tag->second) + 14.0;
  QRectF box(16.0, 8.0, width, 22.0);
  const QPointF free = painter.window().bottomRight() - painter.worldTransform().map(QPointF());
  if (box.right() > free.x()) {
    box.moveRight(-box.left());
  }
  if (box.bottom() > free.y()) {
    box.moveBottom(-box.top());
  }
  painter.setPen(Qt::NoPen);
  painter.setBrush(theme().color(Role::Text, 0.92));
  painter.drawRoundedRect(box, 4.0, 4.0);
  painter.setFont(font);
  painter.setPen(theme().color(Role::Panel));
  painter.drawText(box, Qt::AlignCenter, marks_.tag->second);
}

void ToolLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (marks_.band) {
    painter->setPen(screenPen(*painter, theme().color(Role::Accent), 1.0));
    painter->setBrush(theme().color(Role::Accent, 0.10));
    painter->drawRect(*marks_.band);
  }
  paintStroke(*painter);
  paintOutline(*painter);
  paintDots(*painter);
  paintLine(*painter);
  paintArrow(*painter);
  paintSnapMark(*painter);
  paintTag(*painter);
}

}  // namespace editor
