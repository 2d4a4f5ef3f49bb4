#include "editor/look/FigurePainter.h"

#include <algorithm>
#include <cmath>

#include <QRawFont>

#include "sim2d/base/Types.h"

namespace editor {

namespace {

// Dimensions of a person as fractions of the body radius; x forward, y to the right of the figure
// (screen, y down).
constexpr double kDepth = 0.6;
constexpr double kHead = 0.36;
constexpr double kNoseTip = 0.88;
constexpr double kNoseWidth = 0.24;
constexpr double kOutlinePx = 1.3;

QPen outlinePen(const QColor& color, double radiusPx) {
  QPen pen(color, std::clamp(radiusPx * 0.075, 0.8, 2.0));
  pen.setJoinStyle(Qt::RoundJoin);
  return pen;
}

QPainterPath nosePath(double r) {
  QPainterPath path;
  path.moveTo(kNoseTip * r, 0.0);
  path.lineTo(0.5 * r, kNoseWidth * r);
  path.lineTo(0.5 * r, -kNoseWidth * r);
  path.closeSubpath();
  return path;
}

QPainterPath bodyOf(const RobotFigure& figure) {
  QPainterPath path;
  if (figure.footprintPx.size() < 3) {
    path.addEllipse(QPointF(), figure.radiusPx, figure.radiusPx);
    return path;
  }
  QPolygonF polygon;
  for (const QPointF& point : figure.footprintPx) {
    polygon << QPointF(point.x(), -point.y());
  }
  path.addPolygon(polygon);
  path.closeSubpath();
  return path;
}

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

/// The outline of a behaviour's mark, centred at the origin. All marks have equal optical weight.
/// For a ring it is the outer circle.
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

constexpr double kGlyphUnits = 16.0;  // Width of the drawing.

void addLine(QPainterPath& path, const QVector<QPointF>& points) {
  path.addPolygon(QPolygonF(points));
}

/// Adds an arrow to the right between two x coordinates on the middle line.
void addArrow(QPainterPath& path, double from, double to) {
  addLine(path, {{from, 0.0}, {to, 0.0}});
  addLine(path, {{to - 3.0, -3.0}, {to, 0.0}, {to - 3.0, 3.0}});
}

QPainterPath runner() {
  QPainterPath path;
  path.addEllipse(QPointF(2.2, -5.6), 1.5, 1.5);
  addLine(path, {{1.0, -2.8}, {-0.8, 1.2}});                                          // Back.
  addLine(path, {{-0.8, 1.2}, {2.2, 3.0}, {1.4, 6.6}});                               // Front leg.
  addLine(path, {{-0.8, 1.2}, {-2.4, 4.2}, {-6.0, 4.4}});                             // Rear leg.
  addLine(path, {{5.8, -1.6}, {3.4, -0.6}, {1.0, -2.8}, {-2.4, -2.6}, {-4.2, 0.0}});  // Arms.
  return path;
}

constexpr int kHeadings = 64;
constexpr int kSteps = 3;
constexpr std::size_t kSprites = std::size_t{kHeadings} * kSteps;
constexpr int kColumns = 16;
constexpr double kLargestPx = 40.0;  // Radius.
constexpr double kReach = 1.5;       // Extent of luggage and feet in radii.

int headingIndex(double headingDeg) {
  const int index = static_cast<int>(std::lround(headingDeg * kHeadings / 360.0)) % kHeadings;
  return index < 0 ? index + kHeadings : index;
}

int stepIndex(double stride) {
  return stride > 0.33 ? 2 : stride < -0.33 ? 0 : 1;
}

}  // namespace

QIcon drawnIcon(int sizePx, const std::function<void(QPainter&)>& draw,
                const std::vector<int>& ratios) {
  QIcon icon;
  for (const int ratio : ratios) {
    QPixmap pixmap(sizePx * ratio, sizePx * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(0.5 * sizePx, 0.5 * sizePx);
    draw(painter);
    painter.end();
    icon.addPixmap(pixmap);
  }
  return icon;
}

QPainterPath textOutline(const QPointF& baseline, const QFont& font, const QString& text) {
  // Qt keeps the sub-pixel shift of the last drawn glyph in the font and applies it to outlines.
  // Requesting a bounding box at an unused size resets the shift to zero.
  QRawFont unused = QRawFont::fromFont(font);
  unused.setPixelSize(unused.pixelSize() + 1.0);
  unused.boundingRect(0);
  QPainterPath path;
  path.addText(baseline, font, text);
  return path;
}

void paintHaloText(QPainter& painter, const QPointF& baseline, const QFont& font,
                   const QString& text, const QColor& halo, const QColor& color) {
  setPenAndBrush(painter, QPen(halo, kHaloPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(textOutline(baseline, font, text));
  painter.setFont(font);
  painter.setPen(color);
  painter.drawText(baseline, text);
}

void FigurePainter::person(QPainter& painter, const PersonFigure& figure) const {
  const double r = figure.radiusPx;
  const QPen outline = outlinePen(theme_.outline(figure.look), r);
  painter.save();
  painter.rotate(-figure.headingDeg);
  if (figure.kind != sim2d::PersonKind::Wheelchair && std::abs(figure.stride) >= 0.05) {
    setPenAndBrush(painter, Qt::NoPen, theme_.feet(figure.look));
    for (const double side : {-1.0, 1.0}) {
      const QPointF foot(side * figure.stride * 0.42 * r, side * 0.4 * r);
      painter.drawEllipse(foot, 0.3 * r, 0.17 * r);
    }
  }
  painter.setPen(outline);
  accessories(painter, figure);
  setPenAndBrush(painter, outline, theme_.outline(figure.look));
  painter.drawPath(nosePath(r));
  painter.setBrush(theme_.fill(figure.look));
  const double half = 0.5 * outline.widthF();  // Keeps the outline inside the body.
  painter.drawEllipse(QPointF(), kDepth * r - half, r - half);
  painter.setBrush(theme_.head(figure.look));
  const double head = figure.kind == sim2d::PersonKind::Child ? 1.2 * kHead : kHead;
  painter.drawEllipse(QPointF(), head * r, head * r);
  painter.restore();
}

/// Draws a wheelchair, suitcase or stick.
void FigurePainter::accessories(QPainter& painter, const PersonFigure& figure) const {
  const double r = figure.radiusPx;
  if (figure.kind == sim2d::PersonKind::Wheelchair) {
    painter.setBrush(theme_.color(Role::ObstacleFill));
    painter.drawRoundedRect(QRectF(-0.78 * r, -0.7 * r, 1.5 * r, 1.4 * r), 0.2 * r, 0.2 * r);
    painter.setBrush(theme_.outline(figure.look));
    for (const double side : {-1.0, 1.0}) {
      painter.drawRoundedRect(QRectF(-0.7 * r, side * 0.92 * r - 0.08 * r, 1.1 * r, 0.16 * r),
                              0.08 * r, 0.08 * r);
    }
  } else if (figure.kind == sim2d::PersonKind::Luggage) {
    painter.drawLine(QPointF(-0.2 * r, 0.7 * r), QPointF(-0.75 * r, 0.7 * r));
    painter.setBrush(theme_.color(Role::ObstacleFill));
    painter.drawRoundedRect(QRectF(-1.35 * r, 0.36 * r, 0.62 * r, 0.68 * r), 0.1 * r, 0.1 * r);
  } else if (figure.kind == sim2d::PersonKind::Elderly) {
    painter.setPen(
        QPen(theme_.outline(figure.look), std::max(1.2, 0.1 * r), Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(QPointF(0.3 * r, 0.72 * r), QPointF(0.95 * r, 0.86 * r));
  }
}

/// Differential drive: two wheels on the axle through the robot's origin. Ackermann: four corner
/// wheels, the front ones steered. Omnidirectional: four diagonal wheels.
void FigurePainter::wheels(QPainter& painter, const RobotFigure& figure, const QRectF& box) const {
  const double thickness = 0.16 * box.height();
  const auto pair = [&](double x, double half, double turnedDeg, double outerDeg) {
    const bool isDisc = figure.footprintPx.size() < 3;
    const double r = figure.radiusPx;
    const double reach = isDisc ? std::sqrt(std::max(0.0, r * r - x * x)) : 0.0;
    for (const double side : {isDisc ? -reach : box.top(), isDisc ? reach : box.bottom()}) {
      painter.save();
      painter.translate(x, side);
      painter.rotate(turnedDeg + (side < box.center().y() ? outerDeg : -outerDeg));
      painter.drawRoundedRect(QRectF(-half, -0.5 * thickness, 2.0 * half, thickness),
                              0.4 * thickness, 0.4 * thickness);
      painter.restore();
    }
  };
  setPenAndBrush(painter, Qt::NoPen, theme_.color(Role::RobotLine));
  const double width = box.width();
  if (figure.kinematics == sim2d::Kinematics::Omnidirectional) {
    pair(box.center().x() + 0.3 * width, 0.13 * width, 0.0, 45.0);
    pair(box.center().x() - 0.3 * width, 0.13 * width, 0.0, -45.0);
  } else if (figure.kinematics == sim2d::Kinematics::Ackermann) {
    pair(0.0, 0.11 * width, 0.0, 0.0);
    pair(0.68 * box.right(), 0.11 * width, -20.0, 0.0);
  } else {
    const double room = std::min(box.right(), -box.left());
    pair(0.0, std::clamp(room, 0.08 * width, 0.22 * width), 0.0, 0.0);
  }
}

void FigurePainter::robot(QPainter& painter, const RobotFigure& figure) const {
  const QPainterPath body = bodyOf(figure);
  const QRectF box = body.boundingRect();
  painter.save();
  painter.rotate(-figure.headingDeg);
  wheels(painter, figure, box);
  setPenAndBrush(painter, outlinePen(theme_.color(Role::MapFree), 0.5 * box.height()),
                 theme_.color(Role::RobotBody));
  painter.drawPath(body);
  QPainterPath front;
  front.addRect(QRectF(box.left() + 0.72 * box.width(), box.top(), box.width(), box.height()));
  QTransform inset;
  inset.translate(box.center().x(), box.center().y());
  inset.scale(0.86, 0.86);
  inset.translate(-box.center().x(), -box.center().y());
  setPenAndBrush(painter, Qt::NoPen, theme_.color(Role::RobotFront));
  painter.drawPath(front.intersected(inset.map(body)));
  painter.setBrush(theme_.color(Role::TextSecondary));
  painter.drawEllipse(QPointF(), 0.1 * box.height(), 0.1 * box.height());
  painter.restore();
}

void FigurePainter::mark(QPainter& painter, Look look, const QPointF& centre, double sizePx) const {
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  painter.translate(centre);
  setPenAndBrush(painter, Qt::NoPen, theme_.line(look));
  if (markOf(look) == Mark::Ring) {
    setPenAndBrush(painter, QPen(theme_.line(look), 0.26 * sizePx), theme_.head(look));
    painter.drawEllipse(QPointF(), 0.36 * sizePx, 0.36 * sizePx);
  } else {
    painter.drawPath(markPath(markOf(look), sizePx));
  }
  painter.restore();
}

void FigurePainter::pin(QPainter& painter, const QString& text, bool selected, double scale) const {
  painter.save();
  painter.scale(scale, scale);
  QPainterPath path;
  path.moveTo(0.0, 0.0);
  path.cubicTo(-2.2, -6.0, -8.4, -9.6, -8.4, -17.0);
  path.arcTo(QRectF(-8.4, -25.4, 16.8, 16.8), 180.0, -180.0);
  path.cubicTo(8.4, -9.6, 2.2, -6.0, 0.0, 0.0);
  const QColor edge = theme_.color(selected ? Role::Accent : Role::Text);
  setPenAndBrush(
      painter, QPen(edge, selected ? 2.2 : kOutlinePx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin),
      theme_.color(Role::GoalPin));
  painter.drawPath(path);
  QFont font = theme_.figureFont();
  font.setPixelSize(text.size() > 2 ? 8 : 11);
  font.setWeight(QFont::DemiBold);
  painter.setFont(font);
  painter.setPen(theme_.color(Role::Text));
  painter.drawText(QRectF(-9.0, -25.4, 18.0, 16.8), Qt::AlignCenter, text);
  painter.restore();
}

void FigurePainter::arrowHead(QPainter& painter, const QPointF& tip, double headingDeg,
                              double sizePx) const {
  painter.save();
  painter.translate(tip);
  painter.rotate(-headingDeg);
  const QPointF points[] = {{-sizePx, -0.62 * sizePx}, {0.0, 0.0}, {-sizePx, 0.62 * sizePx}};
  painter.setBrush(Qt::NoBrush);
  painter.drawPolyline(points, 3);
  painter.restore();
}

QIcon FigurePainter::markIcon(Look look, int sizePx) const {
  return drawnIcon(sizePx, [&](QPainter& painter) { mark(painter, look, {}, 0.62 * sizePx); });
}

QIcon FigurePainter::personIcon(Look look, int sizePx) const {
  PersonFigure figure;
  figure.look = look;
  figure.radiusPx = 0.46 * sizePx;
  figure.headingDeg = 90.0;
  return drawnIcon(sizePx, [&](QPainter& painter) { person(painter, figure); });
}

QIcon FigurePainter::goalIcon(const QString& text, int sizePx) const {
  return drawnIcon(sizePx, [&](QPainter& painter) {
    painter.translate(0.0, 0.47 * sizePx);
    pin(painter, text, false, sizePx / 28.0);
  });
}

QIcon FigurePainter::robotIcon(int sizePx) const {
  RobotFigure figure;
  figure.radiusPx = 0.42 * sizePx;
  figure.headingDeg = 90.0;
  return drawnIcon(sizePx, [&](QPainter& painter) { robot(painter, figure); });
}

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
    case sim2d::AreaKind::Speed:  // Two chevrons, as on a ramp.
      addLine(path, {{-6.0, -5.0}, {-0.5, 0.0}, {-6.0, 5.0}});
      addLine(path, {{0.5, -5.0}, {6.0, 0.0}, {0.5, 5.0}});
      break;
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
  const double scale = sizePx / kGlyphUnits;
  const QPainterPath path = QTransform::fromTranslate(0.5 * sizePx, 0.5 * sizePx)
                                .scale(0.95 * scale, 0.95 * scale)
                                .map(areaGlyph(kind));
  const QPen pen(theme.color(Role::TextSecondary), 1.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  const auto draw = [&](QPainter& painter) {
    painter.resetTransform();
    painter.strokePath(path, pen);
  };
  return drawnIcon(sizePx, draw, {1, 2});
}

SpriteAtlas::Sheet& SpriteAtlas::sheetFor(const PersonFigure& figure, double ratio) {
  const int quarters = static_cast<int>(std::lround(4.0 * figure.radiusPx));
  Sheet& sheet = sheets_[{figure.look, figure.kind, quarters}];
  if (sheet.cell == 0) {
    sheet.cell = 2 * static_cast<int>(std::ceil(kReach * figure.radiusPx * ratio + 1.0));
    const int rows = kHeadings * kSteps / kColumns;
    sheet.pixmap = QPixmap(kColumns * sheet.cell, rows * sheet.cell);
    sheet.pixmap.fill(Qt::transparent);
    sheet.painted.assign(kSprites, false);
  }
  return sheet;
}

void SpriteAtlas::add(Sheet& sheet, const Theme& theme, const QPointF& at,
                      const PersonFigure& figure, double ratio) {
  const int heading = headingIndex(figure.headingDeg);
  const int step = stepIndex(figure.stride);
  const int number = step * kHeadings + heading;
  const int column = number % kColumns;
  const int row = number / kColumns;
  const QRectF source(column * sheet.cell, row * sheet.cell, sheet.cell, sheet.cell);
  if (!sheet.painted[static_cast<std::size_t>(number)]) {
    sheet.painted[static_cast<std::size_t>(number)] = true;
    PersonFigure sprite = figure;
    sprite.headingDeg = heading * 360.0 / kHeadings;
    sprite.stride = step - 1.0;
    QPainter painter(&sheet.pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(source.center());
    painter.scale(ratio, ratio);
    FigurePainter(theme).person(painter, sprite);
  }
  sheet.fragments.push_back(QPainter::PixmapFragment::create(at, source, 1.0 / ratio, 1.0 / ratio));
}

void SpriteAtlas::draw(QPainter& painter, const Theme& theme,
                       const std::vector<std::pair<QPointF, PersonFigure>>& figures) {
  const double ratio = painter.device()->devicePixelRatioF();
  for (const auto& [at, figure] : figures) {
    if (figure.radiusPx > kLargestPx) {
      painter.save();
      painter.translate(at);
      FigurePainter(theme).person(painter, figure);
      painter.restore();
    } else {
      add(sheetFor(figure, ratio), theme, at, figure, ratio);
    }
  }
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  for (auto& [key, sheet] : sheets_) {
    if (!sheet.fragments.empty()) {
      painter.drawPixmapFragments(sheet.fragments.data(), static_cast<int>(sheet.fragments.size()),
                                  sheet.pixmap);
      sheet.fragments.clear();
    }
  }
}

}  // namespace editor
