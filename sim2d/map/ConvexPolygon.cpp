#include "sim2d/map/ConvexPolygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sim2d {
namespace {

constexpr double kTouching = 1e-6;  // [m]; a line that is inside for less only touches

bool isLeftTurn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return base::cross(b - a, c - b) > 0.0;
}

/// One half of the hull, of points in the order of their x.
template <class Iterator>
void appendHalf(Iterator begin, Iterator end, std::vector<Vec2>& hull) {
  const std::size_t first = hull.size();
  for (Iterator point = begin; point != end; ++point) {
    while (hull.size() >= first + 2 && !isLeftTurn(hull[hull.size() - 2], hull.back(), *point)) {
      hull.pop_back();
    }
    hull.push_back(*point);
  }
  hull.pop_back();  // the other half begins with it
}

/// Along the polygon from one of its corners to another, counter-clockwise.
std::vector<Vec2> alongFrom(const std::vector<Vec2>& polygon, std::size_t from, std::size_t to) {
  std::vector<Vec2> way = {polygon[from]};
  while (from != to) {
    from = from + 1 < polygon.size() ? from + 1 : 0;
    way.push_back(polygon[from]);
  }
  return way;
}

}  // namespace

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

std::optional<Entry> entryInto(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to) {
  if (polygon.empty()) {
    return std::nullopt;
  }
  const Vec2 along = to - from;
  const double length = along.norm();
  Entry entry;
  double leaves = 1.0;
  double nearest = -1e300;  // to the edges, of a line that begins inside
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

WaysRound waysRound(const std::vector<Vec2>& polygon, const Vec2& from, const Vec2& to) {
  WaysRound ways;
  const std::optional<Entry> entry = entryInto(polygon, from, to);
  if (!entry || entry->share <= 0.0) {
    return ways;
  }
  std::vector<Vec2> points = polygon;
  points.push_back(from);
  points.push_back(to);
  const std::vector<Vec2> hull = convexHull(std::move(points));
  const auto begin = std::find(hull.begin(), hull.end(), from);
  const auto end = std::find(hull.begin(), hull.end(), to);
  if (begin == hull.end() || end == hull.end()) {
    return ways;
  }
  const auto first = static_cast<std::size_t>(begin - hull.begin());
  const auto last = static_cast<std::size_t>(end - hull.begin());
  ways.right = alongFrom(hull, first, last);
  ways.left = alongFrom(hull, last, first);
  std::reverse(ways.left.begin(), ways.left.end());
  return ways;
}

}  // namespace sim2d
