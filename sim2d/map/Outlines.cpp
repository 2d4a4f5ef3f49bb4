#include "sim2d/map/Outlines.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "sim2d/base/Math.h"

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

Segment edgeOf(const std::vector<Vec2>& polygon, std::size_t index) {
  return {polygon[index], polygon[(index + 1) % polygon.size()]};
}

Outline boxAlong(const Vec2& from, const Vec2& to, double thickness, const Vec2& fallback) {
  const double length = (to - from).norm();
  const Vec2 along = length > 0.0 ? Vec2((to - from) / length) : fallback;
  const Vec2 side = 0.5 * thickness * Vec2(-along.y(), along.x());
  return {{from - side, to - side, to + side, from + side}};
}

/// Mitre offset to the left of a joint, at half the thickness; none if the mitre would be longer
/// than twice that.
std::optional<Vec2> mitre(const Vec2& before, const Vec2& at, const Vec2& after, double half) {
  const Vec2 in = (at - before).normalized();
  const Vec2 out = (after - at).normalized();
  const Vec2 sum(-in.y() - out.y(), in.x() + out.x());  // sum of the left normals
  const double square = sum.squaredNorm();
  if (square < 1.0) {  // |sum| = 2 cos(turn / 2); mitre length = half / cos(turn / 2)
    return std::nullopt;
  }
  return Vec2(2.0 * half / square * sum);
}

/// Offset of each point to its left; none if a turn is too sharp.
std::optional<std::vector<Vec2>> leftOffsets(const std::vector<Vec2>& line, bool closed,
                                             double half) {
  const std::size_t count = line.size();
  std::vector<Vec2> offsets;
  for (std::size_t i = 0; i < count; ++i) {
    if (!closed && (i == 0 || i + 1 == count)) {
      const std::size_t first = i == 0 ? 0 : i - 1;
      const Vec2 along = (line[first + 1] - line[first]).normalized();
      offsets.emplace_back(-half * along.y(), half * along.x());
      continue;
    }
    const std::optional<Vec2> offset =
        mitre(line[(i + count - 1) % count], line[i], line[(i + 1) % count], half);
    if (!offset) {
      return std::nullopt;
    }
    offsets.push_back(*offset);
  }
  return offsets;
}

/// Whether one border runs counter-clockwise around the other, which runs clockwise.
bool isRing(const std::vector<Vec2>& right, const std::vector<Vec2>& left) {
  if (!isSimple(left) || !isSimple(right) || signedArea(left) * signedArea(right) >= 0.0) {
    return false;
  }
  const bool leftInside = isInside(right, left.front());
  return leftInside != isInside(left, right.front()) && signedArea(leftInside ? right : left) > 0.0;
}

/// The strip as one polygon (open line), or as outer and inner border (closed line); empty if it
/// would overlap itself.
std::vector<Outline> mitredStrip(const std::vector<Vec2>& line, bool closed, double thickness) {
  const std::optional<std::vector<Vec2>> offsets = leftOffsets(line, closed, 0.5 * thickness);
  if (!offsets) {
    return {};
  }
  std::vector<Vec2> left;
  std::vector<Vec2> right;
  for (std::size_t i = 0; i < line.size(); ++i) {
    left.push_back(line[i] + (*offsets)[i]);
    right.push_back(line[i] - (*offsets)[i]);
  }
  std::reverse(left.begin(), left.end());
  if (closed) {
    return isRing(right, left) ? std::vector<Outline>{{right}, {left}} : std::vector<Outline>{};
  }
  right.insert(right.end(), left.begin(), left.end());
  return isSimple(right) ? std::vector<Outline>{{right}} : std::vector<Outline>{};
}

constexpr double kTouching = 1e-6;  // [m]; a line that is inside for less only touches

bool isLeftTurn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return base::cross(b - a, c - b) > 0.0;
}

/// One half of the hull; `begin` to `end` are sorted by x.
template <class Iterator>
void appendHalf(Iterator begin, Iterator end, std::vector<Vec2>& hull) {
  const std::size_t first = hull.size();
  for (Iterator point = begin; point != end; ++point) {
    while (hull.size() >= first + 2 && !isLeftTurn(hull[hull.size() - 2], hull.back(), *point)) {
      hull.pop_back();
    }
    hull.push_back(*point);
  }
  hull.pop_back();  // first point of the other half
}

/// The corners from index `from` to `to`, counter-clockwise.
std::vector<Vec2> alongFrom(const std::vector<Vec2>& polygon, std::size_t from, std::size_t to) {
  std::vector<Vec2> path = {polygon[from]};
  while (from != to) {
    from = from + 1 < polygon.size() ? from + 1 : 0;
    path.push_back(polygon[from]);
  }
  return path;
}

}  // namespace

std::vector<Vec2> withoutRepeats(const std::vector<Vec2>& line) {
  std::vector<Vec2> points;
  for (const Vec2& point : line) {
    if (points.empty() || (point - points.back()).norm() > 1e-9) {
      points.push_back(point);
    }
  }
  return points;
}

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

double distanceBetween(const Segment& first, const Segment& second) {
  if (segmentsTouch(first, second)) {
    return 0.0;
  }
  return std::min({distanceToSegment(second, first.a), distanceToSegment(second, first.b),
                   distanceToSegment(first, second.a), distanceToSegment(first, second.b)});
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

Outline boxOutline(const Pose2& centre, double length, double width) {
  const double x = 0.5 * length;
  const double y = 0.5 * width;
  return {{centre.toWorld({-x, -y}), centre.toWorld({x, -y}), centre.toWorld({x, y}),
           centre.toWorld({-x, y})}};
}

Outline circleOutline(const Vec2& centre, double radius, int corners) {
  assert(corners >= 3);
  Outline outline;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * base::kPi * i / corners;
    outline.points.push_back(centre + radius * Vec2(base::cos(angle), base::sin(angle)));
  }
  return outline;
}

Outline polygonOutline(std::vector<Vec2> points) {
  if (signedArea(points) < 0.0) {
    std::reverse(points.begin(), points.end());
  }
  return {std::move(points)};
}

std::vector<Outline> wallOutlines(const std::vector<Vec2>& line, double thickness) {
  std::vector<Vec2> points = withoutRepeats(line);
  if (points.empty()) {
    return {};
  }
  if (points.size() == 1) {
    const Vec2 half(0.5 * thickness, 0.0);
    return {boxAlong(points[0] - half, points[0] + half, thickness, Vec2::UnitX())};
  }
  const bool closed = points.size() > 3 && (points.front() - points.back()).norm() <= 1e-9;
  if (closed) {
    points.pop_back();
  }
  std::vector<Outline> outlines = mitredStrip(points, closed, thickness);
  if (!outlines.empty()) {
    return outlines;
  }
  const std::size_t legs = closed ? points.size() : points.size() - 1;
  for (std::size_t i = 0; i < legs; ++i) {
    const Segment leg = edgeOf(points, i);
    const Vec2 reach = 0.5 * thickness * (leg.b - leg.a).normalized();
    const bool first = !closed && i == 0;
    const bool last = !closed && i + 1 == legs;
    outlines.push_back(boxAlong(first ? leg.a : Vec2(leg.a - reach),
                                last ? leg.b : Vec2(leg.b + reach), thickness, Vec2::UnitX()));
  }
  return outlines;
}

double signedArea(const std::vector<Vec2>& polygon) {
  double twice = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment edge = edgeOf(polygon, i);
    twice += base::cross(edge.a - polygon[0], edge.b - polygon[0]);
  }
  return 0.5 * twice;
}

bool isInside(const std::vector<Vec2>& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Segment edge = edgeOf(polygon, i);
    if ((edge.a.y() > point.y()) != (edge.b.y() > point.y())) {
      const double side = base::cross(edge.b - edge.a, point - edge.a);
      if ((side > 0.0) == (edge.b.y() > edge.a.y())) {
        inside = !inside;
      }
    }
  }
  return inside;
}

bool isSimple(const std::vector<Vec2>& polygon) {
  const std::size_t count = polygon.size();
  if (count < 3) {
    return false;
  }
  const auto lowX = [&](std::size_t i) {
    return std::min(polygon[i].x(), polygon[(i + 1) % count].x());
  };
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return lowX(i) < lowX(j); });
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t i = order[n];
    const Segment first = edgeOf(polygon, i);
    if (isSpike(first, edgeOf(polygon, (i + 1) % count))) {
      return false;
    }
    const double highX = std::max(first.a.x(), first.b.x());
    for (std::size_t m = n + 1; m < count && lowX(order[m]) <= highX; ++m) {
      const std::size_t j = order[m];
      const bool neighbours = (i + 1) % count == j || (j + 1) % count == i;
      if (!neighbours && segmentsTouch(first, edgeOf(polygon, j))) {
        return false;
      }
    }
  }
  return true;
}

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
  std::sort(points.begin(), points.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) {
    return points;
  }
  std::vector<Vec2> hull;
  hull.reserve(points.size() + 1);
  appendHalf(points.begin(), points.end(), hull);
  appendHalf(points.rbegin(), points.rend(), hull);
  return hull;
}

std::optional<PolygonEntry> entryPoint(const std::vector<Vec2>& polygon, const Vec2& from,
                                       const Vec2& to) {
  if (polygon.empty()) {
    return std::nullopt;
  }
  const Vec2 along = to - from;
  const double length = along.norm();
  PolygonEntry entry;
  double leaves = 1.0;
  double nearest = -1e300;  // signed distance to the nearest edge, for a line that begins inside
  bool isInside = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 edge = polygon[i + 1 < polygon.size() ? i + 1 : 0] - polygon[i];
    const Vec2 outwards = Vec2(edge.y(), -edge.x()) / std::max(edge.norm(), 1e-12);
    const double outside = (from - polygon[i]).dot(outwards);
    const double rate = along.dot(outwards);
    if (outside >= 0.0) {
      isInside = false;
      if (rate >= 0.0) {
        return std::nullopt;
      }
      if (outside / -rate >= entry.share) {
        entry = {outside / -rate, i};
      }
    } else if (rate > 0.0) {
      leaves = std::min(leaves, -outside / rate);
    }
    if (isInside && outside > nearest) {
      nearest = outside;
      entry.edge = i;
    }
  }
  if (!isInside && (leaves - entry.share) * length <= kTouching) {
    return std::nullopt;
  }
  return entry;
}

PathsAround pathsAround(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to) {
  PathsAround paths;
  const std::optional<PolygonEntry> entry = entryPoint(polygon, from, to);
  if (!entry || entry->share <= 0.0) {
    return paths;
  }
  std::vector<Vec2> points = polygon;
  points.push_back(from);
  points.push_back(to);
  const std::vector<Vec2> hull = convexHull(std::move(points));
  const auto begin = std::find(hull.begin(), hull.end(), from);
  const auto end = std::find(hull.begin(), hull.end(), to);
  if (begin == hull.end() || end == hull.end()) {
    return paths;
  }
  const auto first = static_cast<std::size_t>(begin - hull.begin());
  const auto last = static_cast<std::size_t>(end - hull.begin());
  paths.right = alongFrom(hull, first, last);
  paths.left = alongFrom(hull, last, first);
  std::reverse(paths.left.begin(), paths.left.end());
  return paths;
}

}  // namespace sim2d
