#include "editor/canvas/OverlayPainter.h"

#include <array>
#include <cmath>

namespace editor {

using base::Vec2;

namespace {

constexpr double kArrowHeadPx = 6.0;   // Size of an arrow head.
constexpr double kFreshContact = 2.0;  // [s]
constexpr double kMinShare = 0.03;     // Minimum painted share of the density scale.
constexpr std::size_t kShades = 64;

struct Shade {
  double share;
  const char* color;
  double alpha;
};
/// Lightness decreases on the light background and increases on the dark one. Both scales pass
/// yellow and red and stay distinguishable with red-green colour blindness.
constexpr Shade kLightShades[] = {{0.0, "#F0E442", 0.0},
                                  {0.25, "#F0C541", 0.45},
                                  {0.5, "#E69F00", 0.62},
                                  {0.75, "#C65600", 0.72},
                                  {1.0, "#7A1F10", 0.80}};
constexpr Shade kDarkShades[] = {{0.0, "#6B2A12", 0.0},
                                 {0.25, "#8C3A12", 0.50},
                                 {0.5, "#C65600", 0.62},
                                 {0.75, "#E69F00", 0.70},
                                 {1.0, "#F7E87A", 0.80}};

QColor shadeColor(const Shade& shade) {
  return withAlpha(QColor(shade.color), shade.alpha);
}

}  // namespace

QPolygonF PictureTransform::at(const std::vector<Vec2>& world) const {
  QPolygonF points;
  points.reserve(static_cast<int>(world.size()));
  for (const Vec2& point : world) {
    points << at(point);
  }
  return points;
}

std::vector<ForceArrow> forcesOn(const sim2d::Frame& frame, int humanId) {
  const auto found = std::find(frame.humans.id.begin(), frame.humans.id.end(), humanId);
  const auto i = static_cast<std::size_t>(found - frame.humans.id.begin());
  const sim2d::ForceColumns& forces = frame.forces;
  const bool isComplete = i < forces.goal.size() && i < forces.social.size() &&
                          i < forces.obstacle.size() && i < forces.group.size();
  if (found == frame.humans.id.end() || !isComplete) {
    return {};
  }
  const Vec2 total = forces.goal[i] + forces.social[i] + forces.obstacle[i] + forces.group[i];
  return {
      {QCoreApplication::translate("Force", "Goal"), Role::ForceGoal, forces.goal[i]},
      {QCoreApplication::translate("Force", "People"), Role::ForceSocial, forces.social[i]},
      {QCoreApplication::translate("Force", "Obstacles"), Role::ForceObstacle, forces.obstacle[i]},
      {QCoreApplication::translate("Force", "Group"), Role::ForceGroup, forces.group[i]},
      {QCoreApplication::translate("Force", "Total"), Role::ForceTotal, total}};
}

QColor densityColor(const Theme& theme, double share) {
  const Shade* const shades = theme.isDark() ? kDarkShades : kLightShades;
  const Shade* const end = shades + std::size(kLightShades);
  const double place = std::clamp(share, 0.0, 1.0);
  const Shade* const next =
      std::find_if(shades + 1, end - 1, [place](const Shade& each) { return place <= each.share; });
  const Shade& last = *(next - 1);
  return mixed(shadeColor(last), shadeColor(*next),
               (place - last.share) / (next->share - last.share));
}

double densityScale(double peak, double before) {
  double scale = std::max(0.5, before);
  while (scale < peak) {
    scale *= 2.0;
  }
  return scale;
}

QImage densityImage(const metrics::DensityField& field, const Theme& theme, double most) {
  std::array<QRgb, kShades + 1> shades{};
  for (std::size_t k = 0; k <= kShades; ++k) {
    const double share = static_cast<double>(k) / kShades;
    shades.at(k) = share < kMinShare ? 0 : qPremultiply(densityColor(theme, share).rgba());
  }
  QImage image = blankImage({field.columns, field.rows}, QImage::Format_ARGB32_Premultiplied);
  for (int row = 0; row < field.rows; ++row) {
    auto* line = reinterpret_cast<QRgb*>(image.scanLine(field.rows - 1 - row));
    for (int column = 0; column < field.columns; ++column) {
      const double share = std::min(1.0, static_cast<double>(field.at(column, row)) / most);
      line[column] = shades.at(static_cast<std::size_t>(std::lround(share * kShades)));
    }
  }
  return image;
}

QColor contactColor(const Theme& theme, ContactCause cause) {
  return cause == ContactCause::Robot    ? theme.color(Role::Error)
         : cause == ContactCause::Person ? theme.line(Look::Regular)
                                         : theme.color(Role::WarningMark);
}

QString contactCauseText(ContactCause cause) {
  return cause == ContactCause::Robot    ? QObject::tr("Caused by robot")
         : cause == ContactCause::Person ? QObject::tr("Caused by person")
                                         : QObject::tr("Caused by both");
}

void OverlayPainter::density(const metrics::DensityField& field, const QImage& image) const {
  const Vec2 high = field.low + field.cell * Vec2(field.columns, field.rows);
  const QRectF place = QRectF(frame_.at(field.low), frame_.at(high)).normalized();
  painter_.save();
  painter_.setRenderHint(QPainter::SmoothPixmapTransform);
  painter_.drawImage(place, image);
  painter_.restore();
}

void OverlayPainter::hallZones(const Vec2& at, const QColor& color, bool withSocial) const {
  for (const auto& [reach, alpha] : kHallZones) {
    if (reach > 2.0 && !withSocial) {
      continue;
    }
    setPenAndBrush(painter_, QPen(withAlpha(color, 2.6 * alpha), 0.8 * line_),
                   withAlpha(color, alpha));
    QPainterPath zone;
    zone.addEllipse(frame_.at(at), reach * frame_.scale, reach * frame_.scale);
    shape(zone);
  }
}

void OverlayPainter::gaussian(const base::Pose2& person, double speed, const QColor& color) const {
  const metrics::GaussianPersonalSpace space = metrics::personalSpaceOf(speed);
  setPenAndBrush(painter_, QPen(withAlpha(color, 0.55), line_), withAlpha(color, 0.10));
  for (const double level : kGaussianLevels) {
    QPainterPath contour;
    contour.addPolygon(frame_.at(metrics::personalSpaceContour(space, person, level, 36)));
    contour.closeSubpath();
    shape(contour);
  }
}

void OverlayPainter::sight(const std::vector<Vec2>& polygon, const QColor& color) const {
  setPenAndBrush(painter_,
                 QPen(withAlpha(color, 0.6), line_, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin),
                 withAlpha(color, theme_.isDark() ? 0.20 : 0.16));
  painter_.drawPolygon(frame_.at(polygon));
}

void OverlayPainter::shape(const QPainterPath& path) const {
  if (box_.isNull() || box_.contains(path.boundingRect())) {
    painter_.drawPath(path);
  } else {
    QPainterPath box;
    box.addRect(box_);
    painter_.drawPath(path.intersected(box));
  }
}

void OverlayPainter::arrow(const QPointF& from, const QPointF& to, const QPen& pen) const {
  const QPointF way = to - from;
  const double length = std::hypot(way.x(), way.y());
  if (length < 2.0) {
    return;
  }
  const QPointF along = way / length;
  const QPointF across(-along.y(), along.x());
  const double head = std::min(kArrowHeadPx * line_, 0.7 * length);
  painter_.setPen(pen);
  painter_.drawLine(from, to - 0.7 * head * along);
  setPenAndBrush(painter_, Qt::NoPen, pen.color());
  painter_.drawPolygon(QPolygonF(
      {to, to - head * along + 0.5 * head * across, to - head * along - 0.5 * head * across}));
}

void OverlayPainter::velocities(const std::vector<MovingBody>& bodies) const {
  for (const MovingBody& body : bodies) {
    const double speed = body.velocity.norm();
    if (speed < 0.05) {
      continue;
    }
    const QPointF along(body.velocity.x() / speed, -body.velocity.y() / speed);
    const QPointF from = frame_.at(body.position) + body.radiusPx * along;
    const QPointF to = from + speed * kMetresPerVelocity * frame_.scale * along;
    arrow(from, to, QPen(body.color, 1.6 * line_, Qt::SolidLine, Qt::FlatCap));
  }
}

void OverlayPainter::forces(const Vec2& at, double radiusPx,
                            const std::vector<ForceArrow>& forces) const {
  for (const ForceArrow& term : forces) {
    const double strength = term.force.norm();
    const double length = strength * kMetresPerForce * frame_.scale;
    if (length < 2.0) {
      continue;
    }
    const QPointF along(term.force.x() / strength, -term.force.y() / strength);
    const QPointF from = frame_.at(at) + radiusPx * along;
    arrow(from, from + length * along,
          QPen(theme_.color(term.color), 2.2 * line_, Qt::SolidLine, Qt::RoundCap));
  }
}

void OverlayPainter::plan(const Vec2& from, const std::vector<Vec2>& points, const QColor& color,
                          bool isOfCrowd) const {
  if (points.empty()) {
    return;
  }
  QPolygonF line = frame_.at(points);
  line.prepend(frame_.at(from));
  QPen pen(color, (isOfCrowd ? 0.8 : 1.4) * line_, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin);
  if (!isOfCrowd) {
    pen.setDashPattern({4.0, 2.5});
  }
  setPenAndBrush(painter_, pen);
  painter_.drawPolyline(line);
  if (isOfCrowd) {
    return;
  }
  setPenAndBrush(painter_, Qt::NoPen, color);
  painter_.drawEllipse(line.back(), 2.6 * line_, 2.6 * line_);
}

void OverlayPainter::contactSign(const QPointF& centre, ContactCause cause) const {
  const double r = 6.0 * line_;
  setPenAndBrush(painter_, QPen(theme_.color(Role::MapFree), 1.2 * line_),
                 contactColor(theme_, cause));
  if (cause == ContactCause::Robot) {  // Distinguished by shape as well as colour.
    painter_.drawRect(
        QRectF(centre - QPointF(r, r), centre + QPointF(r, r)).adjusted(1, 1, -1, -1));
  } else if (cause == ContactCause::Person) {
    painter_.drawEllipse(centre, r, r);
  } else {
    painter_.drawPolygon(
        QPolygonF({centre + QPointF(0.0, -1.25 * r), centre + QPointF(1.25 * r, 0.0),
                   centre + QPointF(0.0, 1.25 * r), centre + QPointF(-1.25 * r, 0.0)}));
  }
  const double x = 0.42 * r;
  setPenAndBrush(painter_,
                 QPen(theme_.color(Role::MapFree), 1.7 * line_, Qt::SolidLine, Qt::RoundCap));
  painter_.drawLine(centre + QPointF(-x, -x), centre + QPointF(x, x));
  painter_.drawLine(centre + QPointF(-x, x), centre + QPointF(x, -x));
}

void OverlayPainter::contact(const sim2d::ContactMark& mark, double age) const {
  const QPointF at = frame_.at(mark.position);
  if (age < kFreshContact) {
    const double share = age / kFreshContact;
    const QColor ring = withAlpha(contactColor(theme_, mark.cause), 0.7 * (1.0 - share));
    paintRing(painter_, QPen(ring, 2.0 * line_), (10.0 + 8.0 * age / kFreshContact) * line_, at);
  }
  contactSign(at, mark.cause);
}

}  // namespace editor
