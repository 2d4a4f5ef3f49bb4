#pragma once

#include <vector>

#include <QImage>
#include <QPainter>
#include <QPainterPath>

#include "editor/look/FigurePainter.h"
#include "metrics/DensityField.h"
#include "sim2d/trace/ContactMarks.h"

namespace editor {

using ContactCause = sim2d::ContactMark::Cause;

/// Where a picture shows the world: pixels, y down.
struct PictureFrame {
  QPointF origin;       // of the world [px]
  double scale = 50.0;  // [px/m]

  QPointF at(const base::Vec2& world) const {
    return {origin.x() + world.x() * scale, origin.y() - world.y() * scale};
  }
  QPolygonF at(const std::vector<base::Vec2>& world) const;
};

/// Somebody who moves, for arrows of velocity.
struct MovingBody {
  base::Vec2 position = base::Vec2::Zero(), velocity = base::Vec2::Zero();  // [m], [m/s]
  double radiusPx = 10.0;                                                   // as drawn
  QColor color;
};

/// A term of the force on somebody, as an arrow.
struct ForceArrow {
  QString name;
  Role color = Role::ForceTotal;
  base::Vec2 force = base::Vec2::Zero();  // [m/s²]
};
constexpr double kMetresPerForce = 0.6;     // length of 1 m/s² on the map
constexpr double kMetresPerVelocity = 0.8;  // length of 1 m/s

/// What lies over map and people when it is asked for, the same on the canvas and in figures: the
/// painter's unit is one pixel.
class OverlayPainter {
 public:
  /// `line`: how strong lines are, 1 on the screen.
  OverlayPainter(QPainter& painter, const Theme& theme, const PictureFrame& frame,
                 double line = 1.0)
      : painter_(painter), theme_(theme), frame_(frame), line_(line) {}

  /// What lies outside is left out; for painters that cannot clip.
  void keepWithin(const QRectF& box) { box_ = box; }

  void density(const metrics::DensityField& field, const QImage& image) const;
  /// Hall's zones: intimate 0.45 m, personal 1.2 m, social 3.6 m.
  void hallZones(const base::Vec2& at, QColor color, bool withSocial = true) const;
  /// The Gaussian space at the heights of `kGaussianLevels`.
  void gaussian(const base::Pose2& person, double speed, const QColor& color) const;
  void sight(const std::vector<base::Vec2>& polygon, const QColor& color) const;
  /// From the bodies' edges on.
  void velocities(const std::vector<MovingBody>& bodies) const;
  void forces(const base::Vec2& at, double radiusPx, const std::vector<ForceArrow>& forces) const;
  /// A way still to be walked. Of a crowd: without dashes, which take their time.
  void plan(const base::Vec2& from, const std::vector<base::Vec2>& points, const QColor& color,
            bool isOfCrowd = false) const;
  /// `age` [s]: those of the last two seconds catch the eye.
  void contact(const sim2d::ContactMark& mark, double age) const;
  /// The same sign at a place of a legend, some 12 px wide.
  void contactSign(const QPointF& centre, ContactCause cause) const;

 private:
  void shape(const QPainterPath& path) const;
  void arrow(const QPointF& from, const QPointF& to, const QPen& pen) const;

  QPainter& painter_;
  const Theme& theme_;
  PictureFrame frame_;
  double line_;
  QRectF box_;  // null: everywhere
};

constexpr double kGaussianLevels[] = {0.2, 0.6};

/// Of a share of the scale, 0 … 1: the denser the farther from the colour of the ground, by
/// lightness alone already; nothing at 0.
QColor densityColor(const Theme& theme, double share);
/// 0.5, 1, 2, 4 … people per m², the least that is not below the peak nor `before`.
double densityScale(double peak, double before = 0.0);
/// One pixel per cell, the highest y first.
QImage densityImage(const metrics::DensityField& field, const Theme& theme, double most);
QColor contactColor(const Theme& theme, ContactCause cause);
QString contactWords(ContactCause cause);

}  // namespace editor
