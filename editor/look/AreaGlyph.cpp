#include "editor/look/AreaGlyph.h"

namespace editor {

namespace {

constexpr double kGlyphUnits = 16.0;  // width of the drawing

void addLine(QPainterPath& path, const QVector<QPointF>& points) {
  path.addPolygon(QPolygonF(points));
}

/// An arrow to the right from `from` to `to`, both on the middle line.
void addArrow(QPainterPath& path, double from, double to) {
  addLine(path, {{from, 0.0}, {to, 0.0}});
  addLine(path, {{to - 3.0, -3.0}, {to, 0.0}, {to - 3.0, 3.0}});
}

QPainterPath runner() {
  QPainterPath path;
  path.addEllipse(QPointF(2.2, -5.6), 1.5, 1.5);
  addLine(path, {{1.0, -2.8}, {-0.8, 1.2}});                                          // back
  addLine(path, {{-0.8, 1.2}, {2.2, 3.0}, {1.4, 6.6}});                               // leg ahead
  addLine(path, {{-0.8, 1.2}, {-2.4, 4.2}, {-6.0, 4.4}});                             // leg behind
  addLine(path, {{5.8, -1.6}, {3.4, -0.6}, {1.0, -2.8}, {-2.4, -2.6}, {-4.2, 0.0}});  // arms
  return path;
}

}  // namespace

QPainterPath areaGlyph(sim2d::AreaKind kind) {
  QPainterPath path;
  switch (kind) {
    case sim2d::AreaKind::Source:
      addLine(path, {{-2.5, -6.0}, {-6.0, -6.0}, {-6.0, 6.0}, {-2.5, 6.0}});
      addArrow(path, -2.5, 6.5);
      break;
    case sim2d::AreaKind::Sink:
      addLine(path, {{2.5, -6.0}, {6.0, -6.0}, {6.0, 6.0}, {2.5, 6.0}});
      addArrow(path, -6.5, 2.5);
      break;
    case sim2d::AreaKind::Wait:
      path.addEllipse(QPointF(), 6.2, 6.2);
      addLine(path, {{0.0, -3.6}, {0.0, 0.0}, {2.6, 1.6}});
      break;
    case sim2d::AreaKind::Exit:
      return runner();
  }
  return path;
}

void paintAreaGlyph(QPainter& painter, sim2d::AreaKind kind, const QPointF& centre, double sizePx,
                    const Theme& theme) {
  const double scale = sizePx / kGlyphUnits;
  const QPainterPath path =
      QTransform::fromTranslate(centre.x(), centre.y()).scale(scale, scale).map(areaGlyph(kind));
  painter.setBrush(Qt::NoBrush);
  for (const auto& [role, width] : {std::pair(Role::MapFree, 4.5), {Role::TextSecondary, 1.6}}) {
    painter.setPen(QPen(theme.color(role), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
  }
}

QIcon areaIcon(sim2d::AreaKind kind, const Theme& theme, int sizePx) {
  QIcon icon;
  for (const int ratio : {1, 2}) {
    QPixmap pixmap(QSize(sizePx, sizePx) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(
        QPen(theme.color(Role::TextSecondary), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    const double scale = sizePx / kGlyphUnits;
    painter.drawPath(QTransform::fromTranslate(0.5 * sizePx, 0.5 * sizePx)
                         .scale(0.95 * scale, 0.95 * scale)
                         .map(areaGlyph(kind)));
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

}  // namespace editor
