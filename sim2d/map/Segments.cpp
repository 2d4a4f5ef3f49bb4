#include "sim2d/map/Segments.h"

#include <algorithm>
#include <cmath>

namespace sim2d {

namespace {

int sideOf(const Segment& segment, const Vec2& point) {
  const double side = base::cross(segment.b - segment.a, point - segment.a);
  return side > 0.0 ? 1 : (side < 0.0 ? -1 : 0);
}

bool isInBox(const Segment& segment, const Vec2& point) {
  return point.x() >= std::min(segment.a.x(), segment.b.x()) &&
         point.x() <= std::max(segment.a.x(), segment.b.x()) &&
         point.y() >= std::min(segment.a.y(), segment.b.y()) &&
         point.y() <= std::max(segment.a.y(), segment.b.y());
}

}  // namespace

Vec2 closestOnSegment(const Segment& segment, const Vec2& point) {
  const Vec2 along = segment.b - segment.a;
  const double square = along.squaredNorm();
  if (square == 0.0) {
    return segment.a;
  }
  return segment.a + std::clamp((point - segment.a).dot(along) / square, 0.0, 1.0) * along;
}

double distanceToSegment(const Segment& segment, const Vec2& point) {
  return (point - closestOnSegment(segment, point)).norm();
}

bool segmentsTouch(const Segment& first, const Segment& second) {
  const int a = sideOf(first, second.a);
  const int b = sideOf(first, second.b);
  const int c = sideOf(second, first.a);
  const int d = sideOf(second, first.b);
  if (a * b < 0 && c * d < 0) {
    return true;
  }
  return (a == 0 && isInBox(first, second.a)) || (b == 0 && isInBox(first, second.b)) ||
         (c == 0 && isInBox(second, first.a)) || (d == 0 && isInBox(second, first.b));
}

bool isSpike(const Segment& first, const Segment& second) {
  const Vec2 in = first.b - first.a;
  const Vec2 out = second.b - second.a;
  return base::cross(in, out) == 0.0 && in.dot(out) <= 0.0;
}

std::optional<double> raySegmentHit(const Vec2& from, const Vec2& direction,
                                    const Segment& segment) {
  constexpr double kTolerance = 1e-9;  // [m]
  const Vec2 along = segment.b - segment.a;
  const double slope = base::cross(direction, along);
  const double length = along.norm();
  if (std::fabs(slope) <= 1e-12 * length) {
    return std::nullopt;
  }
  const Vec2 offset = segment.a - from;
  const double onSegment = base::cross(offset, direction) / slope * length;
  const double onRay = base::cross(offset, along) / slope;
  if (onSegment < -kTolerance || onSegment > length + kTolerance || onRay < 0.0) {
    return std::nullopt;
  }
  return onRay;
}

}  // namespace sim2d
