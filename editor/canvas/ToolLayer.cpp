#include <QFontMetricsF>

#include "editor/canvas/Layers.h"
#include "editor/canvas/PixelFrame.h"
#include "editor/canvas/RouteLayer.h"

namespace editor {

namespace {

constexpr double kCornerPx = 6.0;
constexpr double kSnapMarkPx = 7.0;

QPen toolPen(const QPainter& painter, const QColor& color, double widthPx) {
  QPen pen(color, widthPx, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin);
  makeCosmetic(pen, painter);
  return pen;
}

}  // namespace

void ToolLayer::setRubberBand(const Vec2& corner, const Vec2& opposite) {
  band_ = QRectF(MapScene::sceneFromWorld(corner), MapScene::sceneFromWorld(opposite)).normalized();
  update();
}

void ToolLayer::setLine(std::vector<Vec2> points) {
  line_ = std::move(points);
  update();
}

void ToolLayer::setOutline(ToolLine line) {
  outline_ = std::move(line);
  update();
}

void ToolLayer::setStroke(std::vector<Vec2> points, double width) {
  stroke_ = std::move(points);
  strokeWidth_ = width;
  update();
}

void ToolLayer::setDots(std::vector<ToolDot> dots) {
  dots_ = std::move(dots);
  update();
}

void ToolLayer::setArrow(const Vec2& from, const Vec2& to) {
  arrow_ = {from, to};
  update();
}

void ToolLayer::setTag(const Vec2& at, const QString& text) {
  tag_ = {at, text};
  update();
}

void ToolLayer::setSnapMark(std::optional<Vec2> at) {
  snapMark_ = std::move(at);
  update();
}

void ToolLayer::clear() {
  band_.reset();
  line_.clear();
  outline_ = {};
  stroke_.clear();
  dots_.clear();
  arrow_.reset();
  tag_.reset();
  snapMark_.reset();
  update();
}

void ToolLayer::paintOutline(QPainter& painter) const {
  if (outline_.points.empty()) {
    return;
  }
  const Role role = outline_.isBad ? Role::Error : Role::Accent;
  QPolygonF polygon;
  for (const Vec2& point : outline_.points) {
    polygon << MapScene::sceneFromWorld(point);
  }
  painter.setPen(toolPen(painter, theme().color(role), 2.0));
  if (outline_.isClosed && polygon.size() > 2) {
    painter.setBrush(theme().color(role, 0.08));
    painter.drawPolygon(polygon);
  } else {
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(polygon);
  }
  if (!outline_.hasCorners) {
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
  if (stroke_.empty()) {
    return;
  }
  painter.setPen(QPen(theme().color(Role::Accent, 0.4), strokeWidth_, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  QPainterPath path = softPath(stroke_, 0.0);
  if (stroke_.size() == 1) {  // a dot
    path.lineTo(path.currentPosition() + QPointF(1e-3, 0.0));
  }
  painter.drawPath(path);
}

void ToolLayer::paintDots(QPainter& painter) const {
  for (const ToolDot& dot : dots_) {
    const QPointF at = MapScene::sceneFromWorld(dot.at);
    QColor fill = dot.color;
    fill.setAlphaF(0.45);
    painter.setPen(toolPen(painter, dot.color, 1.2));
    painter.setBrush(fill);
    painter.drawEllipse(at, dot.radius, dot.radius);
    if (dot.heading) {
      painter.drawLine(at, MapScene::sceneFromWorld(Pose2{dot.at, *dot.heading}.ahead(dot.radius)));
    }
  }
}

void ToolLayer::paintLine(QPainter& painter) const {
  if (line_.size() < 2) {
    return;
  }
  QPen pen = toolPen(painter, theme().color(Role::Accent), 2.0);
  pen.setDashPattern({4.0, 3.0});
  painter.setPen(pen);
  painter.setBrush(Qt::NoBrush);
  const QPainterPath path = softPath(line_, 0.0);
  painter.drawPath(path);
  paintArrowHeads(painter, path, 1.5, 9.0, theme());
}

void ToolLayer::paintArrow(QPainter& painter) const {
  if (!arrow_) {
    return;
  }
  painter.setPen(toolPen(painter, theme().color(Role::Accent), 2.0));
  const QLineF line(MapScene::sceneFromWorld(arrow_->first),
                    MapScene::sceneFromWorld(arrow_->second));
  painter.drawLine(line);
  const PixelFrame frame(painter, line.p2());
  painter.setPen(QPen(theme().color(Role::Accent), 2.0));
  FigurePainter(theme()).arrowHead(painter, {}, line.angle(), 10.0);
}

void ToolLayer::paintSnapMark(QPainter& painter) const {
  if (!snapMark_) {
    return;
  }
  const PixelFrame frame(painter, MapScene::sceneFromWorld(*snapMark_));
  painter.setPen(QPen(theme().color(Role::Accent), 1.5));
  painter.setBrush(Qt::NoBrush);
  painter.drawEllipse(QPointF(), kSnapMarkPx, kSnapMarkPx);
}

void ToolLayer::paintTag(QPainter& painter) const {
  if (!tag_) {
    return;
  }
  const PixelFrame frame(painter, MapScene::sceneFromWorld(tag_->first));
  const QFont font = theme().figureFont(9.0);
  const double width = QFontMetricsF(font).horizontalAdvance(tag_->second) + 14.0;
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
  painter.drawText(box, Qt::AlignCenter, tag_->second);
}

void ToolLayer::paint(QPainter* painter, const QStyleOptionGraphicsItem*, QWidget*) {
  painter->setRenderHint(QPainter::Antialiasing);
  if (band_) {
    painter->setPen(toolPen(*painter, theme().color(Role::Accent), 1.0));
    painter->setBrush(theme().color(Role::Accent, 0.10));
    painter->drawRect(*band_);
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
