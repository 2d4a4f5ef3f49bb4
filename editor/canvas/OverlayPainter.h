#pragma once

#include "editor/look/FigurePainter.h"
#include "metrics/MapFields.h"
#include "sim2d/trace/ContactMarks.h"

namespace editor {

using ContactCause = sim2d::ContactMark::Cause;

/// The mapping from world to picture: pixels, y down.
struct PictureTransform {
  QPointF origin;       // Position of the world origin [px].
  double scale = 50.0;  // [px/m]

  QPointF at(const base::Vec2& world) const {
    return {origin.x() + world.x() * scale, origin.y() - world.y() * scale};
  }
  QPolygonF at(const std::vector<base::Vec2>& world) const;
};

/// A moving body, for velocity arrows.
struct MovingBody {
  base::Vec2 position = base::Vec2::Zero(), velocity = base::Vec2::Zero();  // [m], [m/s]
  double radiusPx = 10.0;                                                   // Radius as drawn.
  QColor color;
};

/// A force term on a person, as an arrow.
struct ForceArrow {
  QString name;
  Role color = Role::ForceTotal;
  base::Vec2 force = base::Vec2::Zero();  // [m/s²]
};
/// The force terms on a person in legend order; the last one is the sum. Empty if the frame has no
/// forces or does not contain the person.
std::vector<ForceArrow> forcesOn(const sim2d::Frame& frame, int humanId);
constexpr double kMetresPerForce = 0.6;     // Length of 1 m/s² on the map.
constexpr double kMetresPerVelocity = 0.8;  // Length of 1 m/s on the map.

/// Draws the optional overlays over map and people, identically on the canvas and in figures. The
/// painter's unit is one pixel.
class OverlayPainter {
 public:
  /// `line`: scale of line widths, 1 on the screen.
  OverlayPainter(QPainter& painter, const Theme& theme, const PictureTransform& frame,
                 double line = 1.0)
      : painter_(painter), theme_(theme), frame_(frame), line_(line) {}

  /// Omits everything outside the box, for painters that cannot clip.
  void limitTo(const QRectF& box) { box_ = box; }

  void density(const metrics::DensityField& field, const QImage& image) const;
  /// Hall's zones: intimate 0.45 m, personal 1.2 m, social 3.6 m.
  void hallZones(const base::Vec2& at, const QColor& color, bool withSocial = true) const;
  /// Contours of the Gaussian personal space at the heights `kGaussianLevels`.
  void gaussian(const base::Pose2& person, double speed, const QColor& color) const;
  void sight(const std::vector<base::Vec2>& polygon, const QColor& color) const;
  /// The arrows begin at the edges of the bodies.
  void velocities(const std::vector<MovingBody>& bodies) const;
  void forces(const base::Vec2& at, double radiusPx, const std::vector<ForceArrow>& forces) const;
  /// A planned path. `isOfCrowd`: without dashes, which are slow to draw.
  void plan(const base::Vec2& from, const std::vector<base::Vec2>& points, const QColor& color,
            bool isOfCrowd = false) const;
  /// `age` [s]: contacts of the last two seconds are highlighted.
  void contact(const sim2d::ContactMark& mark, double age) const;
  /// The same sign for a legend, about 12 px wide.
  void contactSign(const QPointF& centre, ContactCause cause) const;

 private:
  void shape(const QPainterPath& path) const;
  void arrow(const QPointF& from, const QPointF& to, const QPen& pen) const;

  QPainter& painter_;
  const Theme& theme_;
  PictureTransform frame_;
  double line_;
  QRectF box_;  // Null: everywhere.
};

/// Radius [m] and opacity of Hall's zones.
constexpr std::pair<double, double> kHallZones[] = {{3.6, 0.05}, {1.2, 0.10}, {0.45, 0.18}};
constexpr double kGaussianLevels[] = {0.2, 0.6};

/// The colour for a share of the scale, 0 … 1. Denser values contrast more with the background,
/// also by lightness alone; transparent at 0.
QColor densityColor(const Theme& theme, double share);
/// End of the scale: the smallest of 0.5, 1, 2, 4 … people per m² that is at least the peak and at
/// least `before`.
double densityScale(double peak, double before = 0.0);
/// One pixel per cell, the highest y first.
QImage densityImage(const metrics::DensityField& field, const Theme& theme, double most);
QColor contactColor(const Theme& theme, ContactCause cause);
QString contactCauseText(ContactCause cause);

}  // namespace editor
