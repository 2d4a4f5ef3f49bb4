#include "metrics/MapFields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace metrics {

using base::Vec2;

GaussianPersonalSpace personalSpaceOf(double speed) {
  const double front = std::max(2.0 * speed, 0.5);
  return {front, front / 2.0, front * 2.0 / 3.0};
}

std::vector<Vec2> personalSpaceContour(const GaussianPersonalSpace& space,
                                       const base::Pose2& person, double level, int corners) {
  const double reach = -2.0 * std::log(level);  // squared distance for a variance of 1 m²
  const double side = std::sqrt(space.side * reach);
  const Vec2 ahead = base::directionOf(person.heading);
  const Vec2 left(-ahead.y(), ahead.x());
  std::vector<Vec2> contour;
  contour.reserve(static_cast<std::size_t>(corners));
  for (int k = 0; k < corners; ++k) {
    const double angle = 2.0 * base::kPi * k / corners;
    const double along = std::cos(angle);
    const double half = std::sqrt((along > 0.0 ? space.ahead : space.behind) * reach);
    contour.push_back(person.position + half * along * ahead + side * std::sin(angle) * left);
  }
  return contour;
}

namespace {

constexpr double kKernel = 1.0 / (base::kPi * kDensityRadius * kDensityRadius);  // at its centre
constexpr double kReach = 3.0 * kDensityRadius;
constexpr double kMostAlong = 4096.0;  // cells along a side, for long narrow boxes

/// The cells of one axis within a person's reach, and the person's share in each.
struct AxisShares {
  int first = 0, end = 0;
  std::vector<float> shares;

  void take(double at, double low, double cell, int count) {
    const auto cellAt = [&](double place) {
      return static_cast<int>(std::clamp(std::floor((place - low) / cell), 0.0, count * 1.0));
    };
    first = cellAt(at - kReach);
    end = std::min(count, cellAt(at + kReach) + 1);
    shares.clear();
    for (int k = first; k < end; ++k) {
      const double off = (low + (k + 0.5) * cell - at) / kDensityRadius;
      shares.push_back(static_cast<float>(std::exp(-off * off)));
    }
  }
};

}  // namespace

double DensityField::peak() const {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

DensityField densityField(const std::vector<Vec2>& people, const Vec2& low, const Vec2& high,
                          double cell, std::size_t mostCells) {
  DensityField field;
  const Vec2 size = (high - low).cwiseMax(0.0);
  const double least = std::sqrt(size.x() * size.y() / static_cast<double>(mostCells));
  field.low = low;
  const double mostAlong = std::min(kMostAlong, static_cast<double>(mostCells));
  field.cell = std::max({cell, least, size.maxCoeff() / mostAlong});
  field.columns = std::max(1, static_cast<int>(std::ceil(size.x() / field.cell)));
  field.rows = std::max(1, static_cast<int>(std::ceil(size.y() / field.cell)));
  const auto columns = static_cast<std::size_t>(field.columns);
  field.values.assign(columns * static_cast<std::size_t>(field.rows), 0.0F);
  AxisShares across;
  AxisShares up;
  for (const Vec2& person : people) {
    across.take(person.x(), low.x(), field.cell, field.columns);
    up.take(person.y(), low.y(), field.cell, field.rows);
    for (int row = up.first; row < up.end; ++row) {
      const float share = static_cast<float>(kKernel) * up.shares[std::size_t(row - up.first)];
      float* const line = field.values.data() + static_cast<std::size_t>(row) * columns;
      for (int column = across.first; column < across.end; ++column) {
        line[column] += share * across.shares[std::size_t(column - across.first)];
      }
    }
  }
  return field;
}

namespace {

constexpr double kArcStep = 3.0 * base::kPi / 180.0;  // [rad]

/// Directions at which the polygon may have a corner: ends of visible walls, intersections of walls
/// with the range, and steps of the arc; [rad] from the first side of the view.
class CornerDirections {
 public:
  CornerDirections(double from, double width) : from_(from), width_(width) {
    const int steps = std::max(1, static_cast<int>(std::ceil(width / kArcStep - 1e-9)));
    for (int k = 0; k <= steps; ++k) {
      turns_.push_back(width * k / steps);
    }
  }
  void add(double angle) {
    double turn = std::fmod(angle - from_, 2.0 * base::kPi);
    turn += turn < 0.0 ? 2.0 * base::kPi : 0.0;
    if (turn < width_) {
      turns_.push_back(turn);
    }
  }
  void addCrossings(const sim2d::Segment& wall, double range) {
    const Vec2 way = wall.b - wall.a;
    const double a = way.squaredNorm();
    const double b = wall.a.dot(way);
    const double root = b * b - a * (wall.a.squaredNorm() - range * range);
    if (a == 0.0 || root < 0.0) {
      return;
    }
    for (const double sign : {-1.0, 1.0}) {
      const double share = (-b + sign * std::sqrt(root)) / a;
      if (share > 0.0 && share < 1.0) {
        add(base::headingOf(wall.a + share * way));
      }
    }
  }
  std::vector<double> sorted() {
    std::sort(turns_.begin(), turns_.end());
    return std::move(turns_);
  }

 private:
  double from_, width_;
  std::vector<double> turns_;
};

/// The visible wall in a direction; null: none.
const sim2d::Segment* wallTowards(const VisibilityProfile& panorama, const Vec2& direction) {
  const double rank = pseudoAngle(direction);
  const std::vector<VisibilityProfile::View>& views = panorama.views();
  const auto found = std::partition_point(views.begin(), views.end(),
                                          [&](const auto& view) { return view.to.rank < rank; });
  return found != views.end() && found->from.rank <= rank ? &panorama.wall(*found) : nullptr;
}

}  // namespace

std::vector<Vec2> visibilityPolygon(const base::Pose2& eye, double halfAngle, double range,
                                    const std::vector<sim2d::Segment>& walls) {
  std::vector<sim2d::Segment> seen;
  seen.reserve(walls.size());
  for (const sim2d::Segment& wall : walls) {
    seen.push_back({wall.a - eye.position, wall.b - eye.position});
  }
  VisibilityProfile panorama;
  panorama.look(seen);
  const bool isAllAround = halfAngle >= base::kPi;
  const double from = isAllAround ? -base::kPi : eye.heading - halfAngle;
  const double width = isAllAround ? 2.0 * base::kPi : 2.0 * halfAngle;
  CornerDirections directions(from, width);
  for (const VisibilityProfile::View& view : panorama.views()) {
    directions.add(base::headingOf(view.from.towards));
    directions.add(base::headingOf(view.to.towards));
    directions.addCrossings(panorama.wall(view), range);
  }
  const std::vector<double> turns = directions.sorted();
  std::vector<Vec2> polygon;
  if (!isAllAround) {
    polygon.push_back(eye.position);
  }
  for (std::size_t k = 0; k + 1 < turns.size(); ++k) {
    const Vec2 middle = base::directionOf(from + 0.5 * (turns[k] + turns[k + 1]));
    const sim2d::Segment* const wall = wallTowards(panorama, middle);
    for (const double turn : {turns[k], turns[k + 1]}) {
      const Vec2 direction = base::directionOf(from + turn);
      const double reach = wall != nullptr ? along(direction, *wall) : range;
      const Vec2 corner = eye.position + (reach > 0.0 ? std::min(reach, range) : range) * direction;
      if (polygon.empty() || (polygon.back() - corner).norm() > 1e-9) {
        polygon.push_back(corner);
      }
    }
  }
  if (polygon.size() > 1 && (polygon.back() - polygon.front()).norm() <= 1e-9) {
    polygon.pop_back();
  }
  return polygon;
}

std::vector<sim2d::Segment> wallsAround(const sim2d::TraceHeader& header,
                                        const std::vector<char>& doorOpen, const Vec2& place,
                                        double range) {
  std::vector<sim2d::Segment> walls;
  std::size_t door = 0;
  for (const sim2d::TraceObstacle& obstacle : header.obstacles) {
    if (obstacle.isDoor) {
      const bool isOpen = door < doorOpen.size() ? doorOpen[door] != 0 : obstacle.open;
      ++door;
      if (isOpen) {
        continue;
      }
    }
    for (const sim2d::Outline& outline : obstacle.outlines) {
      const std::vector<Vec2>& points = outline.points;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const sim2d::Segment edge{points[k], points[(k + 1) % points.size()]};
        const Vec2 low = edge.a.cwiseMin(edge.b);
        const Vec2 high = edge.a.cwiseMax(edge.b);
        const bool isNear =
            ((low - place).array() <= range).all() && ((place - high).array() <= range).all();
        if (isNear && sim2d::distanceToSegment(edge, place) <= range) {
          walls.push_back(edge);
        }
      }
    }
  }
  return walls;
}

namespace {

using Turn = VisibilityProfile::Turn;
using View = VisibilityProfile::View;

constexpr double kHalfTurn = 2.0;  // rank

Turn turnTo(const Vec2& place) {
  return {pseudoAngle(place), place.normalized()};
}

/// The intersection of two segments, if any.
std::optional<Vec2> crossing(const sim2d::Segment& first, const sim2d::Segment& second) {
  const Vec2 a = first.b - first.a;
  const Vec2 b = second.b - second.a;
  const double across = base::cross(a, b);
  if (across == 0.0) {
    return std::nullopt;
  }
  const double s = base::cross(second.a - first.a, b) / across;
  const double t = base::cross(second.a - first.a, a) / across;
  return s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0 ? std::optional<Vec2>(first.a + s * a)
                                                  : std::nullopt;
}

const Turn& later(const Turn& one, const Turn& other) {
  return one.rank < other.rank ? other : one;
}
const Turn& sooner(const Turn& one, const Turn& other) {
  return other.rank < one.rank ? other : one;
}

/// Iterates over views in order.
class ViewCursor {
 public:
  ViewCursor(const View* next, const View* end) : next_(next), end_(end) {}

  bool isOver() const { return next_ == end_; }
  const View& view() const { return *next_; }
  /// Start of the view, at least `at`; infinite if there is none.
  Turn from(const Turn& at) const {
    return isOver() ? Turn{HUGE_VAL, Vec2::UnitX()} : later(view().from, at);
  }
  void pass(const Turn& at) { next_ += !isOver() && view().to.rank <= at.rank ? 1 : 0; }

 private:
  const View* next_;
  const View* end_;
};

/// Extends the previous view if it is of the same wall.
void append(const Turn& from, const Turn& to, std::size_t wall, std::vector<View>& views) {
  if (!(from.rank < to.rank)) {
    return;
  }
  if (!views.empty() && views.back().wall == wall && views.back().to.rank == from.rank) {
    views.back().to = to;
  } else {
    views.push_back({from, to, wall});
  }
}

}  // namespace

double pseudoAngle(const Vec2& direction) {
  const double sum = std::abs(direction.x()) + std::abs(direction.y());
  const double share = sum > 0.0 ? direction.y() / sum : 0.0;
  if (direction.x() >= 0.0) {
    return share;
  }
  return share < 0.0 ? -kHalfTurn - share : kHalfTurn - share;
}

double along(const Vec2& direction, const sim2d::Segment& segment) {
  const double across = base::cross(direction, segment.b - segment.a);
  return across != 0.0 ? base::cross(segment.a, segment.b - segment.a) / across
                       : std::numeric_limits<double>::infinity();
}

void VisibilityProfile::look(const std::vector<sim2d::Segment>& walls) {
  walls_ = walls;
  views_.clear();
  addViewsOf(0, walls_.size());
}

void VisibilityProfile::add(const std::vector<sim2d::Segment>& walls) {
  const std::size_t before = walls_.size();
  walls_.insert(walls_.end(), walls.begin(), walls.end());
  const std::size_t seen = views_.size();
  addViewsOf(before, walls_.size());
  mergeFrom(0, seen);
}

/// Appends the views of a range of walls.
void VisibilityProfile::addViewsOf(std::size_t first, std::size_t end) {
  if (end - first < 2) {
    if (first < end) {
      addViewsOfOne(first);
    }
    return;
  }
  const std::size_t start = views_.size();
  const std::size_t middle = first + (end - first) / 2;
  addViewsOf(first, middle);
  const std::size_t second = views_.size();
  addViewsOf(middle, end);
  mergeFrom(start, second);
}

/// Skips walls seen edge-on, for which rounding would decide about the order of the ends.
void VisibilityProfile::addViewsOfOne(std::size_t wall) {
  constexpr double kEdgeOn = 1e-12;  // [rad]
  const sim2d::Segment& its = walls_[wall];
  const double side = base::cross(its.a, its.b);
  const double squares = its.a.squaredNorm() * its.b.squaredNorm();
  if (side * side <= kEdgeOn * kEdgeOn * squares) {
    return;
  }
  const Turn from = turnTo(side > 0.0 ? its.a : its.b);
  const Turn to = turnTo(side > 0.0 ? its.b : its.a);
  if (from.rank < to.rank) {
    views_.push_back({from, to, wall});
    return;
  }
  const auto addPart = [&](const Turn& begin, const Turn& end) {
    if (begin.rank < end.rank) {
      views_.push_back({begin, end, wall});
    }
  };
  addPart({-kHalfTurn, -Vec2::UnitX()}, to);
  addPart(from, {kHalfTurn, -Vec2::UnitX()});
}

/// Replaces the views from `first` by the nearest of those before and after `middle`.
void VisibilityProfile::mergeFrom(std::size_t first, std::size_t middle) {
  merged_.clear();
  Turn at{-HUGE_VAL, Vec2::UnitX()};
  ViewCursor one(views_.data() + first, views_.data() + middle);
  ViewCursor other(views_.data() + middle, views_.data() + views_.size());
  while (!one.isOver() || !other.isOver()) {
    const Turn fromOne = one.from(at);
    const Turn fromOther = other.from(at);
    if (fromOne.rank == fromOther.rank) {
      at = sooner(other.view().to, one.view().to);
      appendNearer(one.view(), other.view(), fromOne, at);
    } else {
      const View& view = (fromOne.rank < fromOther.rank ? one : other).view();
      at = sooner(view.to, later(fromOne, fromOther));
      append(sooner(fromOne, fromOther), at, view.wall, merged_);
    }
    one.pass(at);
    other.pass(at);
  }
  views_.resize(first);
  views_.insert(views_.end(), merged_.begin(), merged_.end());
}

/// If two walls intersect, each is nearer on one side.
void VisibilityProfile::appendNearer(const View& a, const View& b, const Turn& from,
                                     const Turn& to) {
  Turn middle = to;
  if (const std::optional<Vec2> place = crossing(walls_[a.wall], walls_[b.wall])) {
    const Turn there = turnTo(*place);
    middle = there.rank > from.rank && there.rank < to.rank ? there : to;
  }
  append(from, middle, nearer(a.wall, b.wall, from, middle), merged_);
  if (middle.rank < to.rank) {
    append(middle, to, nearer(a.wall, b.wall, middle, to), merged_);
  }
}

/// Compares in the middle between two directions.
std::size_t VisibilityProfile::nearer(std::size_t a, std::size_t b, const Turn& from,
                                      const Turn& to) const {
  const Vec2 middle = from.towards + to.towards;
  return along(middle, walls_[b]) < along(middle, walls_[a]) ? b : a;
}

}  // namespace metrics
