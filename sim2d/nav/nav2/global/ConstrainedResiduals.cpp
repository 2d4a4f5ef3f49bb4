#include "sim2d/nav/nav2/global/ConstrainedResiduals.h"

#include <algorithm>

namespace sim2d::nav2 {
namespace {

constexpr double kMinDeterminant = 1e-4;  // [m²], twice the area of three nearly collinear points
constexpr double kMinExcess = 1e-4;       // curvature [1/m]

SmoothNumber dotOfPoints(const SmoothPoint& a, const SmoothPoint& b) {
  return a.x * b.x + a.y * b.y;
}

/// The centre of the circle through three points; nullopt if they are collinear.
std::optional<SmoothPoint> arcCentre(const SmoothPoint& before, const SmoothPoint& at,
                                     SmoothPoint after, bool isCusp) {
  const SmoothPoint first = at - before;
  SmoothPoint second = after - at;
  if (isCusp) {
    second = {-second.x, -second.y};
    after = at + second;
  }
  const SmoothNumber det = first.x * second.y - first.y * second.x;
  if (std::abs(det.value) < kMinDeterminant) {
    return std::nullopt;
  }
  const SmoothPoint middle1 = SmoothNumber(0.5) * (before + at);
  const SmoothPoint middle2 = SmoothNumber(0.5) * (at + after);
  const SmoothPoint normal1 = {-first.y, first.x}, normal2 = {-second.y, second.x};
  const SmoothNumber det1 =
      (middle1.x + normal1.x) * middle1.y - (middle1.y + normal1.y) * middle1.x;
  const SmoothNumber det2 =
      (middle2.x + normal2.x) * middle2.y - (middle2.y + normal2.y) * middle2.x;
  return SmoothPoint{(det1 * normal2.x - det2 * normal1.x) / det,
                     (det1 * normal2.y - det2 * normal1.y) / det};
}

SmoothPoint tangentAt(const SmoothPoint& before, const SmoothPoint& at, SmoothPoint after,
                      bool isCusp) {
  if (const auto centre = arcCentre(before, at, after, isCusp)) {
    return {centre->y - at.y, at.x - centre->x};
  }
  SmoothPoint way = after - at;
  if (isCusp) {
    way = {-way.x, -way.y};
    after = at + way;
  }
  const SmoothPoint whole = after - before;
  const bool isNothing = whole.x.value == 0.0 && whole.y.value == 0.0;
  return isNothing ? SmoothPoint{way.y, -way.x} : whole;
}

/// Catmull-Rom spline through four values at -1, 0, 1, 2.
struct SplineValue {
  double value, derivative;
};
SplineValue splineAt(const std::array<double, 4>& p, double x) {
  const double a = 0.5 * (-p[0] + 3.0 * p[1] - 3.0 * p[2] + p[3]);
  const double b = 0.5 * (2.0 * p[0] - 5.0 * p[1] + 4.0 * p[2] - p[3]);
  const double c = 0.5 * (-p[0] + p[2]);
  return {p[1] + x * (c + x * (b + x * a)), c + x * (2.0 * b + 3.0 * a * x)};
}

/// The cost of a position by bicubic interpolation; border cells extend beyond the map.
SmoothNumber splineCost(const Costmap& costmap, const SmoothPoint& place) {
  const double column = (place.x.value - costmap.origin().x()) / costmap.resolution() - 0.5;
  const double row = (place.y.value - costmap.origin().y()) / costmap.resolution() - 0.5;
  const double left = std::floor(column), bottom = std::floor(row);
  std::array<double, 4> values = {}, derivatives = {};
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto clamped = [](double cell, int size) {
      return static_cast<int>(std::clamp(cell, 0.0, size - 1.0));
    };
    const int line = clamped(bottom - 1.0 + static_cast<double>(i), costmap.height());
    std::array<double, 4> costs = {};
    for (std::size_t k = 0; k < costs.size(); ++k) {
      costs[k] = costmap.at({clamped(left - 1.0 + static_cast<double>(k), costmap.width()), line});
    }
    const SplineValue along = splineAt(costs, column - left);
    values[i] = along.value;
    derivatives[i] = along.derivative;
  }
  const SplineValue up = splineAt(values, row - bottom);
  const double across = splineAt(derivatives, row - bottom).value;
  return place.x.applyChainRule(up.value, across / costmap.resolution()) +
         place.y.applyChainRule(0.0, up.derivative / costmap.resolution());
}

SmoothNumber curvatureOf(const SmoothTerm& term, const ConstrainedSmootherParameters& parameters,
                         const SmoothPoint& before, const SmoothPoint& at,
                         const SmoothPoint& after) {
  const auto centre = arcCentre(before, at, after, term.ratio < 0.0);
  if (!centre || parameters.minimumTurningRadius <= 0.0) {
    return {};
  }
  const SmoothPoint spoke = at - *centre;
  const SmoothNumber excess = SmoothNumber(1.0) / sqrt(dotOfPoints(spoke, spoke)) -
                              SmoothNumber(1.0 / parameters.minimumTurningRadius);
  return excess.value <= kMinExcess ? SmoothNumber()
                                    : SmoothNumber(parameters.wCurve) * excess * excess;
}

/// Weighted costs at the check points of the robot.
SmoothNumber costOfPoints(const SmoothTerm& term, const ConstrainedSmootherParameters& parameters,
                          const Costmap& costmap, const SmoothPoint& before, const SmoothPoint& at,
                          const SmoothPoint& after) {
  SmoothPoint ahead = tangentAt(before, at, after, term.ratio < 0.0);
  ahead = (SmoothNumber(1.0) / sqrt(dotOfPoints(ahead, ahead))) * ahead;
  if ((dotOfPoints(after - at, ahead).value < 0.0) != term.isReversing) {
    ahead = {-ahead.x, -ahead.y};
  }
  const std::vector<double>& points = parameters.costCheckPoints;
  double sum = 0.0;
  for (std::size_t i = 2; i < points.size(); i += 3) {
    sum += points[i];
  }
  SmoothNumber cost;
  for (std::size_t i = 0; i + 2 < points.size(); i += 3) {
    const SmoothNumber x(points[i]), y(points[i + 1]);
    const SmoothPoint place =
        at + SmoothPoint{x * ahead.x - y * ahead.y, x * ahead.y + y * ahead.x};
    const SmoothNumber value = splineCost(costmap, place);
    cost = cost + SmoothNumber(term.costWeight * points[i + 2] / sum) * value * value;
  }
  return cost;
}

SmoothPoint variablePoint(const Vec2& place, std::size_t index) {
  return {SmoothNumber::variable(place.x(), index), SmoothNumber::variable(place.y(), index + 1)};
}

}  // namespace

SmoothResiduals smoothResiduals(const SmoothTerm& term,
                                const ConstrainedSmootherParameters& parameters,
                                const Costmap& costmap, const Vec2& before, const Vec2& at,
                                const Vec2& after) {
  const SmoothPoint a = variablePoint(before, 0), p = variablePoint(at, 2),
                    b = variablePoint(after, 4);
  const SmoothPoint bend = SmoothNumber(term.ratio) * (b - p) - (p - a);
  const SmoothPoint moved = p - SmoothPoint{term.given.x(), term.given.y()};
  SmoothResiduals residuals;
  residuals[0] = SmoothNumber(parameters.wSmooth) * dotOfPoints(bend, bend);
  residuals[1] = curvatureOf(term, parameters, a, p, b);
  residuals[2] = SmoothNumber(parameters.wDist) * dotOfPoints(moved, moved);
  if (parameters.costCheckPoints.empty()) {
    const SmoothNumber cost = splineCost(costmap, p);
    residuals[3] = SmoothNumber(term.costWeight) * cost * cost;
  } else {
    residuals[3] = costOfPoints(term, parameters, costmap, a, p, b);
  }
  return residuals;
}

Vec2 arcDirection(const Vec2& before, const Vec2& at, const Vec2& after, bool isCusp) {
  const SmoothPoint tangent =
      tangentAt(variablePoint(before, 0), variablePoint(at, 2), variablePoint(after, 4), isCusp);
  return {tangent.x.value, tangent.y.value};
}

}  // namespace sim2d::nav2
