#include "editor/look/MarkPath.h"

#include <cmath>

#include "sim2d/base/Types.h"

namespace editor {

namespace {

QPainterPath polygonPath(int corners, double radius, double firstDeg) {
  QPolygonF polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = (firstDeg + 360.0 * i / corners) * base::kPi / 180.0;
    polygon << QPointF(radius * std::cos(angle), -radius * std::sin(angle));
  }
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  return path;
}

}  // namespace

QPainterPath markPath(Mark mark, double sizePx) {
  const double half = 0.5 * sizePx;
  QPainterPath path;
  switch (mark) {
    case Mark::Disc:
    case Mark::Ring:
      path.addEllipse(QPointF(), half, half);
      return path;
    case Mark::Square:
      path.addRect(QRectF(-0.88 * half, -0.88 * half, 1.76 * half, 1.76 * half));
      return path;
    case Mark::Diamond:
      return polygonPath(4, 1.16 * half, 90.0);
    case Mark::TriangleDown:
      return polygonPath(3, 1.18 * half, -90.0).translated(0.0, -0.18 * half);
    case Mark::TriangleUp:
      return polygonPath(3, 1.18 * half, 90.0).translated(0.0, 0.18 * half);
    case Mark::Hexagon:
      return polygonPath(6, 1.08 * half, 0.0);
  }
  return path;
}

}  // namespace editor
