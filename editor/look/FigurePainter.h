#pragma once

#include <functional>
#include <vector>

#include <QIcon>
#include <QPainter>
#include <QPainterPath>

#include "editor/look/Theme.h"
#include "sim2d/nav/Body.h"
#include "sim2d/scenario/Scenario.h"

namespace editor {

/// How a person is drawn from above.
struct PersonFigure {
  Look look = Look::Regular;
  sim2d::PersonKind kind = sim2d::PersonKind::Adult;
  double radiusPx = 18.0;   // of the body
  double headingDeg = 0.0;  // counter-clockwise from right
  double stride = 0.0;      // -1 … 1 while walking: feet; 0 = standing
};

struct RobotFigure {
  double radiusPx = 18.0;
  double headingDeg = 0.0;
  std::vector<QPointF> footprintPx;  // robot frame, y up; empty = disc
  sim2d::Kinematics kinematics = sim2d::Kinematics::Differential;  // tells where its wheels are
};

/// An icon drawn around the origin with one unit per pixel, at these pixel ratios.
QIcon drawnIcon(int sizePx, const std::function<void(QPainter&)>& draw,
                const std::vector<int>& ratios = {1, 2, 3});

/// The outline of a text that begins at `baseline`; the same for the same arguments, whatever was
/// drawn before.
QPainterPath textOutline(const QPointF& baseline, const QFont& font, const QString& text);

/// Draws figures the same way wherever they appear: canvas, lists, thumbnails, reports. Centred at
/// the painter's origin; one unit = one pixel, y down.
class FigurePainter {
 public:
  explicit FigurePainter(const Theme& theme) : theme_(theme) {}

  void person(QPainter& painter, const PersonFigure& figure) const;
  void robot(QPainter& painter, const RobotFigure& figure) const;
  void mark(QPainter& painter, Look look, const QPointF& centre, double sizePx) const;
  /// Pin whose tip is at the origin, 18 x 26 px at scale 1.
  void pin(QPainter& painter, const QString& text, bool selected, double scale = 1.0) const;
  /// Small chevron on a route, pointing along `headingDeg`.
  void arrowHead(QPainter& painter, const QPointF& tip, double headingDeg, double sizePx) const;

  /// For lists and legends, sharp on every screen.
  QIcon markIcon(Look look, int sizePx = 16) const;
  QIcon personIcon(Look look, int sizePx = 24) const;
  QIcon goalIcon(const QString& text, int sizePx = 24) const;
  QIcon robotIcon(int sizePx = 24) const;

 private:
  void belongings(QPainter& painter, const PersonFigure& figure) const;
  void wheels(QPainter& painter, const RobotFigure& figure, const QRectF& box) const;
  const Theme& theme_;
};

/// The sign that tells what an area does, without colour: an arrow out of a gate (source) or into
/// one (sink), a clock (waiting), a running figure (exit). Strokes around the origin, 16 units
/// wide.
QPainterPath areaGlyph(sim2d::AreaKind kind);
/// The sign in pixels, with a rim in the colour of the ground.
void paintAreaGlyph(QPainter& painter, sim2d::AreaKind kind, const QPointF& centre, double sizePx,
                    const Theme& theme);
/// For lists.
QIcon areaIcon(sim2d::AreaKind kind, const Theme& theme, int sizePx = 16);

}  // namespace editor
