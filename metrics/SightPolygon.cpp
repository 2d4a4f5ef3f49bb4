#include "metrics/SightPolygon.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "metrics/Panorama.h"

namespace metrics {

using base::Vec2;

namespace {

constexpr double kArcStep = 3.0 * base::kPi / 180.0;  // [rad]

/// Directions at which what is seen may have a corner: ends of walls in sight, where walls cross
/// the range, and steps of the arc. [rad] from the first side of the view on.
class SightTurns {
 public:
  SightTurns(double from, double width) : from_(from), width_(width) {
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

/// The wall that is seen in a direction; null: none.
const sim2d::Segment* wallTowards(const Panorama& panorama, const Vec2& direction) {
  const double rank = rankOf(direction);
  const std::vector<Panorama::View>& views = panorama.views();
  const auto found = std::partition_point(views.begin(), views.end(),
                                          [&](const auto& view) { return view.to.rank < rank; });
  return found != views.end() && found->from.rank <= rank ? &panorama.wall(*found) : nullptr;
}

}  // namespace

std::vector<Vec2> sightPolygon(const base::Pose2& eye, double halfAngle, double range,
                               const std::vector<sim2d::Segment>& walls) {
  std::vector<sim2d::Segment> seen;
  seen.reserve(walls.size());
  for (const sim2d::Segment& wall : walls) {
    seen.push_back({wall.a - eye.position, wall.b - eye.position});
  }
  Panorama panorama;
  panorama.look(seen);
  const bool isAllAround = halfAngle >= base::kPi;
  const double from = isAllAround ? -base::kPi : eye.heading - halfAngle;
  const double width = isAllAround ? 2.0 * base::kPi : 2.0 * halfAngle;
  SightTurns directions(from, width);
  for (const Panorama::View& view : panorama.views()) {
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

}  // namespace metrics
