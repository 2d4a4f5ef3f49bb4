#include "metrics/VoronoiCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

namespace metrics {

namespace {

constexpr double kOffWalls = 1e-3;  // [m] from walls at which front faces hide all back faces

/// A point with its grid cell, ordered by row.
struct Placed {
  long long row = 0, column = 0;
  std::size_t point = 0;
  friend bool operator<(const Placed& a, const Placed& b) {
    return std::tie(a.row, a.column, a.point) < std::tie(b.row, b.column, b.point);
  }
};

/// The part of a wall between the ends of the corridor; all of it without a seam.
std::optional<sim2d::Segment> within(const Seam& seam, const sim2d::Segment& wall) {
  const double low = seam.low;
  const double high = seam.low + seam.length;
  if (!seam.isThere()) {
    return wall;
  }
  if (std::max(wall.a.x(), wall.b.x()) < low || std::min(wall.a.x(), wall.b.x()) > high) {
    return std::nullopt;
  }
  const auto cut = [&](const Vec2& end) -> Vec2 {
    const double x = std::clamp(end.x(), low, high);
    const Vec2 whole = wall.b - wall.a;
    return x == end.x() ? end : Vec2(wall.a + (x - wall.a.x()) / whole.x() * whole);
  };
  return sim2d::Segment{cut(wall.a), cut(wall.b)};
}

/// Signed area of the sector from a to b within the circle.
double sectorArea(const Vec2& a, const Vec2& b, double radius) {
  return 0.5 * radius * radius * std::atan2(base::cross(a, b), a.dot(b));
}

/// Signed area of the triangle between the origin and an edge, within the circle.
double areaAt(const Vec2& a, const Vec2& b, double radius) {
  const Vec2 edge = b - a;
  const double squared = edge.squaredNorm();
  if (squared == 0.0) {
    return 0.0;
  }
  // a + t edge lies on the circle where t^2 squared + 2 t half + rest = 0.
  const double half = a.dot(edge);
  const double rest = a.squaredNorm() - radius * radius;
  const double root = half * half - squared * rest;
  if (root <= 0.0) {
    return sectorArea(a, b, radius);
  }
  const double from = std::clamp((-half - std::sqrt(root)) / squared, 0.0, 1.0);
  const double to = std::clamp((-half + std::sqrt(root)) / squared, 0.0, 1.0);
  const Vec2 in = a + from * edge;
  const Vec2 out = a + to * edge;
  const double before = from > 0.0 ? sectorArea(a, in, radius) : 0.0;
  return before + 0.5 * base::cross(in, out) + (out != b ? sectorArea(out, b, radius) : 0.0);
}

}  // namespace

std::vector<std::vector<std::size_t>> neighboursWithin(const std::vector<Vec2>& points,
                                                       double reach) {
  std::vector<Placed> placed;
  placed.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    placed.push_back({std::llround(std::floor(points[k].y() / reach)),
                      std::llround(std::floor(points[k].x() / reach)), k});
  }
  std::sort(placed.begin(), placed.end());
  std::vector<std::vector<std::size_t>> result(points.size());
  std::array<std::size_t, 3> first{};  // search start in the rows below, of and above a point
  for (const Placed& centre : placed) {
    const Vec2& point = points[centre.point];
    for (std::size_t k = 0; k < first.size(); ++k) {
      const long long row = centre.row + static_cast<long long>(k) - 1;
      std::size_t& at = first[k];
      while (at < placed.size() && placed[at] < Placed{row, centre.column - 1, 0}) {
        ++at;
      }
      for (std::size_t i = at;
           i < placed.size() && placed[i].row == row && placed[i].column <= centre.column + 1;
           ++i) {
        const Vec2& other = points[placed[i].point];
        if (placed[i].point != centre.point && (other - point).squaredNorm() <= reach * reach) {
          result[centre.point].push_back(placed[i].point);
        }
      }
    }
  }
  return result;
}

double areaInCircle(const std::vector<Vec2>& polygon, double radius) {
  double area = 0.0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    area += areaAt(polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0], radius);
  }
  return area;
}

/// Whether a wall is in between. Tests all walls: there are too few points to make sorting
/// worthwhile.
bool VoronoiCellAreas::isHidden(const Vec2& other) const {
  return std::any_of(walls_.begin(), walls_.end(), [&](const sim2d::Segment& wall) {
    if ((base::cross(other, wall.a) > 0.0) == (base::cross(other, wall.b) > 0.0)) {
      return false;
    }
    const double share = along(other, wall);
    return share > 0.0 && share < 1.0;
  });
}

/// The part of a square around the circle that no wall hides from the point. Walls beyond the
/// circle have no effect on the area.
void VoronoiCellAreas::takeVisible() {
  const double r = radius_;
  near_.clear();
  std::copy_if(
      walls_.begin(), walls_.end(), std::back_inserter(near_),
      [r](const sim2d::Segment& wall) { return sim2d::distanceToSegment(wall, Vec2::Zero()) < r; });
  visibility_.look(near_);
  cell_ = {Vec2(r, r), Vec2(-r, r), Vec2(-r, -r), Vec2(r, -r)};
  if (visibility_.views().empty()) {
    return;
  }
  std::vector<sim2d::Segment> square;
  for (std::size_t k = 0; k < cell_.size(); ++k) {
    square.push_back({cell_[k], cell_[(k + 1) % cell_.size()]});
  }
  visibility_.add(square);
  cell_.clear();
  for (const VisibilityProfile::View& view : visibility_.views()) {
    for (const Vec2& direction : {view.from.towards, view.to.towards}) {
      cell_.push_back(along(direction, visibility_.wall(view)) * direction);
    }
  }
}

/// Keeps the part of the cell that is nearer to the origin.
void VoronoiCellAreas::cut(const Vec2& other) {
  const double limit = 0.5 * other.squaredNorm();
  part_.clear();
  double sideA = cell_.empty() ? 0.0 : other.dot(cell_.front()) - limit;
  for (std::size_t k = 0; k < cell_.size(); ++k) {
    const Vec2& a = cell_[k];
    const Vec2& b = cell_[k + 1 < cell_.size() ? k + 1 : 0];
    const double sideB = other.dot(b) - limit;
    if (sideA <= 0.0) {
      part_.push_back(a);
    }
    if ((sideA < 0.0 && sideB > 0.0) || (sideA > 0.0 && sideB < 0.0)) {
      part_.push_back(a + sideA / (sideA - sideB) * (b - a));
    }
    sideA = sideB;
  }
  cell_.swap(part_);
}

/// Collects walls and their images beyond the seam. A point in free space sees only front faces,
/// since outlines are closed.
void VoronoiCellAreas::collectWalls(const Vec2& point, double reach, const RunContext& context) {
  walls_.clear();
  if (context.walls == nullptr) {
    return;
  }
  const double turn = context.seam.length;
  const bool seesFrontsOnly =
      !context.seam.isThere() && context.walls->clearance(point, kOffWalls) >= kOffWalls;
  for (const double shift : {0.0, turn, -turn}) {
    const Vec2 centre = point - Vec2(shift, 0.0);
    context.walls->visitNear(centre, reach, [&](const sim2d::Segment& segment) {
      if (seesFrontsOnly && base::cross(segment.a - centre, segment.b - centre) >= 0.0) {
        return;  // solid on the left
      }
      const std::optional<sim2d::Segment> wall = within(context.seam, segment);
      if (wall && sim2d::distanceToSegment(*wall, centre) < reach) {
        walls_.push_back({wall->a - centre, wall->b - centre});
      }
    });
    if (!context.seam.isThere()) {
      break;
    }
  }
}

double VoronoiCellAreas::areaOf(const Vec2& point, const std::vector<Vec2>& others,
                                const RunContext& context) {
  // Other points within this distance can share the area.
  collectWalls(point, others.empty() ? radius_ : 2.0 * radius_, context);
  takeVisible();
  for (const Vec2& other : others) {
    if (other != point && !isHidden(other - point)) {  // points at the same position share the cell
      cut(other - point);
    }
  }
  return areaInCircle(cell_, radius_);
}

}  // namespace metrics
