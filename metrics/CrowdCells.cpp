#include "metrics/CrowdCells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <tuple>

namespace metrics {

namespace {

/// Points by squares of a grid, row by row.
struct Placed {
  long long row = 0, column = 0;
  std::size_t point = 0;
  friend bool operator<(const Placed& a, const Placed& b) {
    return std::tie(a.row, a.column, a.point) < std::tie(b.row, b.column, b.point);
  }
};

/// Where the ray from the origin meets the line through the segment, as a multiple of the
/// direction; infinite when it runs beside it.
double along(const Vec2& direction, const sim2d::Segment& segment) {
  const double across = base::cross(direction, segment.b - segment.a);
  return across != 0.0 ? base::cross(segment.a, segment.b - segment.a) / across
                       : std::numeric_limits<double>::infinity();
}

/// The part of a wall between the ends of the corridor; all of it where they are not joined.
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

/// Where two segments cross each other, if they do.
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

/// Of the sector from a to b within the circle, with the sign of the turn.
double sectorArea(const Vec2& a, const Vec2& b, double radius) {
  return 0.5 * radius * radius * std::atan2(base::cross(a, b), a.dot(b));
}

/// Of the triangle between the origin and an edge, within the circle, with the sign of the turn.
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
  return sectorArea(a, in, radius) + 0.5 * base::cross(in, out) + sectorArea(out, b, radius);
}

}  // namespace

std::vector<std::vector<std::size_t>> neighbours(const std::vector<Vec2>& points, double reach) {
  std::vector<Placed> placed;
  placed.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    placed.push_back({std::llround(std::floor(points[k].y() / reach)),
                      std::llround(std::floor(points[k].x() / reach)), k});
  }
  std::sort(placed.begin(), placed.end());
  std::vector<std::vector<std::size_t>> result(points.size());
  std::array<std::size_t, 3> first{};  // in the rows below, of and above a point: where to look
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

/// Around the circle.
void CellAreas::takeSquare() {
  const double r = radius_;
  cell_ = {Vec2(r, r), Vec2(-r, r), Vec2(-r, -r), Vec2(r, -r)};
}

/// What of the square no wall hides from the point. Between two turns one border comes first.
void CellAreas::takeVisible() {
  takeSquare();
  borders_.clear();
  std::copy_if(walls_.begin(), walls_.end(), std::back_inserter(borders_),
               [this](const sim2d::Segment& wall) {
                 return sim2d::distanceToSegment(wall, Vec2::Zero()) < std::sqrt(2.0) * radius_;
               });
  if (borders_.empty()) {
    return;
  }
  for (std::size_t k = 0; k < 4; ++k) {
    borders_.push_back({cell_[k], cell_[(k + 1) % 4]});
  }
  turns_.clear();
  const auto turnTo = [this](const Vec2& place) {
    if (place != Vec2::Zero()) {
      turns_.push_back(std::atan2(place.y(), place.x()));
    }
  };
  for (std::size_t k = 0; k < borders_.size(); ++k) {
    turnTo(borders_[k].a);
    turnTo(borders_[k].b);
    for (std::size_t other = 0; other < k; ++other) {
      if (const std::optional<Vec2> place = crossing(borders_[k], borders_[other])) {
        turnTo(*place);
      }
    }
  }
  std::sort(turns_.begin(), turns_.end());
  cell_.clear();
  for (std::size_t k = 0; k < turns_.size(); ++k) {
    const bool isLast = k + 1 == turns_.size();
    addCorners(turns_[k], isLast ? turns_.front() + 2.0 * base::kPi : turns_[k + 1]);
  }
}

/// Both ends of what is seen between two directions.
void CellAreas::addCorners(double from, double to) {
  constexpr double kLeastTurn = 1e-12;  // [rad]
  if (to - from < kLeastTurn) {
    return;
  }
  const Vec2 middle = base::directionOf(0.5 * (from + to));
  const sim2d::Segment* first = nullptr;
  double nearest = std::numeric_limits<double>::infinity();
  for (const sim2d::Segment& border : borders_) {
    const double sideA = base::cross(middle, border.a);
    const double sideB = base::cross(middle, border.b);
    const double distance = along(middle, border);
    if ((sideA > 0.0) != (sideB > 0.0) && distance > 0.0 && distance < nearest) {
      nearest = distance;
      first = &border;
    }
  }
  if (first != nullptr) {
    for (const double turn : {from, to}) {
      const Vec2 direction = base::directionOf(turn);
      cell_.push_back(along(direction, *first) * direction);
    }
  }
}

/// Leaves the part that is nearer to the origin.
void CellAreas::cut(const Vec2& other) {
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

void CellAreas::findWalls(const Vec2& point, const RunContext& context) {
  walls_.clear();
  if (context.walls == nullptr) {
    return;
  }
  const double reach = 2.0 * radius_;  // of the others who take a share
  const double turn = context.seam.length;
  for (const double shift : {0.0, turn, -turn}) {
    const Vec2 centre = point - Vec2(shift, 0.0);
    std::vector<sim2d::Segment> found;
    context.walls->segmentsNear(centre, reach, found);
    for (const sim2d::Segment& segment : found) {
      const std::optional<sim2d::Segment> wall = within(context.seam, segment);
      if (wall && sim2d::distanceToSegment(*wall, centre) < reach) {
        walls_.push_back({wall->a - centre, wall->b - centre});
      }
    }
    if (!context.seam.isThere()) {
      return;
    }
  }
}

/// No wall, nor the image of one, between the point and the place.
bool CellAreas::isSeen(const Vec2& place) const {
  return std::none_of(walls_.begin(), walls_.end(), [&](const sim2d::Segment& wall) {
    const double sideA = base::cross(place, wall.a);
    const double sideB = base::cross(place, wall.b);
    const double share = along(place, wall);
    return (sideA > 0.0) != (sideB > 0.0) && share > 0.0 && share < 1.0;
  });
}

double CellAreas::areaOf(const Vec2& point, const std::vector<Vec2>& others,
                         const RunContext& context) {
  findWalls(point, context);
  takeVisible();
  for (const Vec2& other : others) {
    if (other != point && isSeen(other - point)) {  // two in one place share it
      cut(other - point);
    }
  }
  return areaInCircle(cell_, radius_);
}

}  // namespace metrics
