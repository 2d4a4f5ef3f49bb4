#include "sim2d/map/Obstacles.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/map/ObstacleQueryCache.h"

namespace sim2d {

namespace {

constexpr double kBucketSize = 1.0;  // [m]
constexpr double kCellSide = 2.0;    // [m]

/// Whether the interval of an edge contains `at` (half open: a line through a corner crosses one of
/// its two edges).
bool straddles(double low, double high, double at) {
  return (low <= at) != (high <= at);
}

bool isLeftOf(const Segment& segment, const Vec2& point) {
  return base::cross(segment.b - segment.a, point - segment.a) > 0.0;
}

/// The point lies towards -x of a segment that is not horizontal.
bool isWestOf(const Segment& segment, const Vec2& point) {
  return isLeftOf(segment, point) == (segment.b.y() > segment.a.y());
}

/// Cheap test without divisions: true only if `raySegmentHit` finds no hit within `most`. Most
/// segments near a ray are rejected by it. `length`: of the segment [m].
bool certainlyMisses(const Vec2& from, const Vec2& direction, double most, const Segment& segment,
                     double length) {
  constexpr double kMore = 1e-8;  // fraction and [m]; exceeds its tolerance and rounding errors
  const Vec2 along = segment.b - segment.a;
  const Vec2 offset = segment.a - from;
  const double slope = base::cross(direction, along);
  const double side = slope < 0.0 ? -1.0 : 1.0;
  const double depth = side * slope;
  const double onRay = side * base::cross(offset, along);          // distance, times depth
  const double onSegment = side * base::cross(offset, direction);  // fraction, times depth
  const double slack = kMore * (1.0 + length) * depth;
  return onSegment * length < -slack || (onSegment - depth) * length > slack || onRay < -slack ||
         onRay > (most + kMore * (1.0 + most)) * depth;
}

std::uint64_t newVersion() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

}  // namespace

void Obstacles::setEnabled(int part, bool enabled) {
  char& now = enabled_.at(static_cast<std::size_t>(part));
  if ((now != 0) != enabled) {
    now = enabled ? 1 : 0;
    version_ = newVersion();
  }
}

int Obstacles::add(std::vector<Outline> outlines, bool enabled, bool isOfMap) {
  double area = 0.0;
  for (const Outline& outline : outlines) {
    area += signedArea(outline.points);
  }
  parts_.push_back(std::move(outlines));
  enabled_.push_back(enabled ? 1 : 0);
  ofMap_.push_back(isOfMap ? 1 : 0);
  background_.push_back(area < 0.0 ? 1 : 0);
  return partCount() - 1;
}

void Obstacles::build(const base::StopFlag& stop) {
  version_ = newVersion();
  segments_.clear();
  edges_.clear();
  for (int part = 0; part < partCount(); ++part) {
    for (const Outline& outline : outlines(part)) {
      stop.check();
      addOutline(outline, part);
    }
  }
  index_.build(segments_, kBucketSize);
  cells_.build(segments_, kCellSide);
  countWindings(stop);
  findUncovered(stop);
  rays_.clear();
  for (int degrees = 0; degrees < 360; degrees += 4) {
    const double angle = degrees * base::kPi / 180.0;
    rays_.emplace_back(base::cos(angle), base::sin(angle));
  }
}

void Obstacles::addOutline(const Outline& outline, int part) {
  std::vector<Vec2> points = withoutRepeats(outline.points);
  while (points.size() > 1 && (points.front() - points.back()).norm() <= 1e-9) {
    points.pop_back();
  }
  if (points.size() < 2) {
    return;
  }
  const int first = static_cast<int>(edges_.size());
  const int count = static_cast<int>(points.size());
  for (int i = 0; i < count; ++i) {
    const Vec2& from = points[static_cast<std::size_t>(i)];
    const Vec2& to = points[static_cast<std::size_t>((i + 1) % count)];
    const double length = (to - from).norm();
    segments_.push_back({from, to});
    edges_.push_back({part, first + (i + count - 1) % count, first + (i + 1) % count,
                      Vec2((to - from) / length), length});
  }
}

/// Winding numbers at the bucket centres; those of any point follow from the few edges in its
/// bucket.
void Obstacles::countWindings(const base::StopFlag& stop) {
  windings_.clear();
  windingStart_.assign(1, 0);
  for (int row = 0; row < index_.height(); ++row) {
    stop.check();
    countWindingsOfRow(row);
  }
}

/// The edges that cross the centre line of a row, each with the last column whose centre lies to
/// its left.
std::vector<Obstacles::Crossing> Obstacles::crossingsOfRow(int row) const {
  std::vector<int> edges;
  for (int column = 0; column < index_.width(); ++column) {
    const SegmentGrid::Items items = index_.items({column, row});
    edges.insert(edges.end(), items.begin(), items.end());
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  const double y = index_.centreOf({0, row}).y();
  std::vector<Crossing> crossings;
  for (const int edge : edges) {
    const Segment& segment = segments_[static_cast<std::size_t>(edge)];
    if (!straddles(segment.a.y(), segment.b.y(), y)) {
      continue;
    }
    const double t = (y - segment.a.y()) / (segment.b.y() - segment.a.y());
    const double x = segment.a.x() + t * (segment.b.x() - segment.a.x());
    int column = std::clamp(index_.bucketAt({x, y}).column + 1, 0, index_.width() - 1);
    while (column >= 0 && !isWestOf(segment, index_.centreOf({column, row}))) {
      --column;
    }
    const int sense = segment.b.y() > segment.a.y() ? 1 : -1;
    crossings.push_back({column, edges_[static_cast<std::size_t>(edge)].part, sense});
  }
  std::sort(crossings.begin(), crossings.end(),
            [](const Crossing& a, const Crossing& b) { return a.lastColumn < b.lastColumn; });
  return crossings;
}

/// From left to right: starts with the sum of all crossings and subtracts those passed.
void Obstacles::countWindingsOfRow(int row) {
  const std::vector<Crossing> crossings = crossingsOfRow(row);
  std::vector<int> counts = background_;
  for (const Crossing& crossing : crossings) {
    counts[static_cast<std::size_t>(crossing.part)] += crossing.sense;
  }
  std::vector<char> isNear(parts_.size(), 0);
  std::size_t passed = 0;
  for (int column = 0; column < index_.width(); ++column) {
    for (; passed < crossings.size() && crossings[passed].lastColumn < column; ++passed) {
      counts[static_cast<std::size_t>(crossings[passed].part)] -= crossings[passed].sense;
    }
    std::fill(isNear.begin(), isNear.end(), char{0});
    for (const int edge : index_.items({column, row})) {
      isNear[static_cast<std::size_t>(edges_[static_cast<std::size_t>(edge)].part)] = 1;
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (counts[part] != 0 || isNear[part] != 0) {
        windings_.push_back({static_cast<int>(part), counts[part]});
      }
    }
    windingStart_.push_back(static_cast<int>(windings_.size()));
  }
}

/// Moves from the bucket's centre along x, then along y, and counts the edges crossed.
int Obstacles::windingAt(const Vec2& point, SegmentGrid::Bucket bucket,
                         const Winding& atCentre) const {
  const Vec2 centre = index_.centreOf(bucket);
  const Vec2 corner(point.x(), centre.y());
  int count = atCentre.count;
  for (const int edge : index_.items(bucket)) {
    if (edges_[static_cast<std::size_t>(edge)].part != atCentre.part) {
      continue;
    }
    const Segment& segment = segments_[static_cast<std::size_t>(edge)];
    const auto isLeft = [&](const Vec2& place) { return isLeftOf(segment, place) ? 1 : 0; };
    if (straddles(segment.a.y(), segment.b.y(), centre.y())) {
      count += isLeft(corner) - isLeft(centre);
    }
    if (straddles(segment.a.x(), segment.b.x(), point.x())) {
      count += isLeft(point) - isLeft(corner);
    }
  }
  return count;
}

int Obstacles::solidPartAt(const Vec2& point, bool withDisabled) const {
  const SegmentGrid::Bucket bucket =
      index_.isEmpty() ? SegmentGrid::Bucket{} : index_.bucketAt(point);
  if (index_.isEmpty() || !index_.contains(bucket)) {
    for (int part = 0; part < partCount(); ++part) {
      if ((withDisabled || isEnabled(part)) && background_[static_cast<std::size_t>(part)] != 0) {
        return part;
      }
    }
    return -1;
  }
  const auto index = static_cast<std::size_t>(index_.indexOf(bucket));
  for (int i = windingStart_[index]; i < windingStart_[index + 1]; ++i) {
    const Winding& winding = windings_[static_cast<std::size_t>(i)];
    if ((withDisabled || isEnabled(winding.part)) && windingAt(point, bucket, winding) > 0) {
      return winding.part;
    }
  }
  return -1;
}

std::optional<Obstacles::Point> Obstacles::nearestPoint(const Vec2& position, double range) const {
  Point best;
  best.distance = range;
  index_.visitNear(position, best.distance, [&](int edge) {
    if (!isOn(edge)) {
      return;
    }
    const Vec2 place = closestOnSegment(segments_[static_cast<std::size_t>(edge)], position);
    const double distance = (place - position).norm();
    if (distance < best.distance || (best.part < 0 && distance <= range)) {
      best.position = place;
      best.distance = distance;
      best.part = edges_[static_cast<std::size_t>(edge)].part;
    }
  });
  if (best.part < 0) {
    return std::nullopt;
  }
  best.inside = isInside(position);
  return best;
}

void Obstacles::segmentsNear(const Vec2& position, double range,
                             std::vector<Segment>& segments) const {
  thread_local std::vector<int> edges;
  edges.clear();
  cells_.visitNear(position, range, [&](int edge) {
    if (isOn(edge)) {
      edges.push_back(edge);
    }
  });
  std::sort(edges.begin(), edges.end());
  for (const int edge : edges) {
    segments.push_back(segments_[static_cast<std::size_t>(edge)]);
  }
}

double Obstacles::clearance(const Vec2& position, double limit) const {
  const std::optional<Point> nearest = nearestPoint(position, limit);
  if (!nearest) {
    return isInside(position) ? -limit : limit;
  }
  return nearest->inside ? -nearest->distance : nearest->distance;
}

Obstacles::Hit Obstacles::firstHit(const Vec2& from, const Vec2& direction, double range) const {
  Hit best;
  best.distance = range;
  index_.visitRay(from, direction, range, [&](SegmentGrid::Items items, double end) {
    for (const int edge : items) {
      const Segment& segment = segments_[static_cast<std::size_t>(edge)];
      const double length = edges_[static_cast<std::size_t>(edge)].length;
      if (!isOn(edge) || certainlyMisses(from, direction, best.distance, segment, length)) {
        continue;
      }
      const std::optional<double> hit = raySegmentHit(from, direction, segment);
      if (hit && *hit <= best.distance && (best.edge < 0 || *hit < best.distance)) {
        best = {*hit, edge};
      }
    }
    return best.edge < 0 || best.distance > end;
  });
  return best;
}

/// Whether `firstHit` finds any edge.
bool Obstacles::isHit(const Vec2& from, const Vec2& direction, double range) const {
  bool isHit = false;
  index_.visitRay(from, direction, range, [&](SegmentGrid::Items items, double /*end*/) {
    isHit = std::any_of(items.begin(), items.end(), [&](int edge) {
      const Segment& segment = segments_[static_cast<std::size_t>(edge)];
      const double length = edges_[static_cast<std::size_t>(edge)].length;
      if (!isOn(edge) || certainlyMisses(from, direction, range, segment, length)) {
        return false;
      }
      const std::optional<double> hit = raySegmentHit(from, direction, segment);
      return hit && *hit <= range;
    });
    return !isHit;
  });
  return isHit;
}

/// Always evaluated in the same direction, so that visibility is symmetric. Recent results are
/// cached, as for `boundaryPoints`: people, sensors and metrics query the same pairs.
bool Obstacles::isVisible(const Vec2& from, const Vec2& to) const {
  const bool isForward = from.x() != to.x() ? from.x() < to.x() : from.y() <= to.y();
  const Vec2& first = isForward ? from : to;
  const Vec2& second = isForward ? to : from;
  const QueryKey<4> queryKey(version_, {first.x(), first.y(), second.x(), second.y()});
  CachedVisibility& slot = visibilityCache().slotOf(queryKey);
  if (version_ == 0 || !(slot.queryKey == queryKey)) {
    const Vec2 whole = second - first;
    const double range = whole.norm();
    slot.isSeen = !isInside(first) && (range == 0.0 || !isHit(first, whole / range, range)) &&
                  !isInside(second);
    slot.queryKey = queryKey;
  }
  return slot.isSeen;
}

double Obstacles::raycast(const Vec2& from, const Vec2& direction, double range) const {
  return isInside(from) ? 0.0 : firstHit(from, direction, range).distance;
}

}  // namespace sim2d
