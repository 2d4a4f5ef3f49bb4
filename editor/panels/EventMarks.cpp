#include "editor/panels/EventMarks.h"

#include <QPainterPath>

namespace editor {

namespace {

void fillShape(QPainter& painter, const QPainterPath& path, const QColor& color) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(color);
  painter.drawPath(path);
}

QPainterPath pinPath() {
  QPainterPath path(QPointF(0.0, 6.0));
  path.cubicTo(-1.5, 3.0, -4.0, 1.5, -4.0, -1.0);
  path.arcTo(QRectF(-4.0, -5.0, 8.0, 8.0), 180.0, -180.0);
  path.cubicTo(4.0, 1.5, 1.5, 3.0, 0.0, 6.0);
  return path;
}

QPainterPath bubblePath() {
  QPainterPath path;
  path.addRoundedRect(QRectF(-5.0, -4.5, 10.0, 7.5), 2.0, 2.0);
  QPainterPath tail(QPointF(-2.5, 2.0));
  tail.lineTo(-2.5, 5.5);
  tail.lineTo(1.0, 2.0);
  return path.united(tail);
}

}  // namespace

void paintEventMark(QPainter& painter, EventMark mark, const QPointF& centre, const Theme& theme) {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(centre);
  QPainterPath path;
  switch (mark) {
    case EventMark::Pin:
      fillShape(painter, pinPath(), theme.color(Role::Ok));
      break;
    case EventMark::Bubble:
      fillShape(painter, bubblePath(), theme.color(Role::TextSecondary));
      break;
    case EventMark::Diamond:
      path.addPolygon(QPolygonF({{0.0, -5.0}, {5.0, 0.0}, {0.0, 5.0}, {-5.0, 0.0}}));
      fillShape(painter, path, theme.line(Look::Curious));
      break;
    case EventMark::Triangle:
      path.addPolygon(QPolygonF({{0.0, -5.0}, {5.0, 4.0}, {-5.0, 4.0}}));
      fillShape(painter, path, theme.color(Role::WarningMark));
      break;
    case EventMark::Cross:
      painter.setPen(QPen(theme.color(Role::Error), 2.4, Qt::SolidLine, Qt::RoundCap));
      painter.drawLine(QPointF(-3.5, -3.5), QPointF(3.5, 3.5));
      painter.drawLine(QPointF(-3.5, 3.5), QPointF(3.5, -3.5));
      break;
    case EventMark::Ring:
      painter.setPen(QPen(theme.color(Role::TextSecondary), 1.6));
      painter.setBrush(Qt::NoBrush);
      painter.drawEllipse(QPointF(), 3.5, 3.5);
      break;
    case EventMark::None:
      painter.setPen(Qt::NoPen);
      painter.setBrush(theme.color(Role::TextSecondary));
      painter.drawEllipse(QPointF(), 1.8, 1.8);
      break;
  }
  painter.restore();
}

QIcon eventIcon(EventMark mark, const Theme& theme) {
  constexpr int kSize = 16;
  QIcon icon;
  for (const int ratio : {1, 2, 3}) {
    QPixmap pixmap(kSize * ratio, kSize * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paintEventMark(painter, mark, QPointF(kSize / 2.0, kSize / 2.0), theme);
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace editor
