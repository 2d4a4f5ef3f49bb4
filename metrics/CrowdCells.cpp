#include "metrics/CrowdCells.h"

#include <algorithm>
#include <array>
#include <cmath>
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

}  // namespace

std::vector<std::vector<Vec2>> neighbours(const std::vector<Vec2>& points, double reach) {
  std::vector<Placed> placed;
  placed.reserve(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    placed.push_back({std::llround(std::floor(points[k].y() / reach)),
                      std::llround(std::floor(points[k].x() / reach)), k});
  }
  std::sort(placed.begin(), placed.end());
  std::vector<std::vector<Vec2>> result(points.size());
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
          result[centre.point].push_back(other);
        }
      }
    }
  }
  return result;
}

CellAreas::CellAreas(double radius) {
  constexpr int kCorners = 64;
  const double turn = 2.0 * base::kPi / kCorners;
  const double corner = radius * std::sqrt(turn / std::sin(turn));
  for (int k = 0; k < kCorners; ++k) {
    circle_.emplace_back(corner * std::cos(k * turn), corner * std::sin(k * turn));
  }
  square_ = {Vec2(corner, corner), Vec2(-corner, corner), Vec2(-corner, -corner),
             Vec2(corner, -corner)};
  inside2_ = (circle_[0] + circle_[1]).squaredNorm() / 4.0;
}

/// Leaves the part that is nearer to the origin.
void CellAreas::cut(const Vec2& other) {
  const double limit = 0.5 * other.squaredNorm();
  part_.resize(cell_.size() + 1);  // a convex part has one corner more at most
  reach2_ = 0.0;
  std::size_t count = 0;
  const auto keep = [this, &count](const Vec2& corner) {
    if (count == part_.size()) {  // rounding has made it not quite convex
      part_.emplace_back();
    }
    part_[count++] = corner;
    reach2_ = std::max(reach2_, corner.squaredNorm());
  };
  double sideA = cell_.empty() ? 0.0 : other.dot(cell_.front()) - limit;
  for (std::size_t k = 0; k < cell_.size(); ++k) {
    const Vec2& a = cell_[k];
    const Vec2& b = cell_[k + 1 < cell_.size() ? k + 1 : 0];
    const double sideB = other.dot(b) - limit;
    if (sideA <= 0.0) {
      keep(a);
    }
    if ((sideA < 0.0 && sideB > 0.0) || (sideA > 0.0 && sideB < 0.0)) {
      keep(a + sideA / (sideA - sideB) * (b - a));
    }
    sideA = sideB;
  }
  part_.resize(count);
  cell_.swap(part_);
}

/// The cell of the origin among the others, cut out of an outline whose first corner lies along the
/// axis.
void CellAreas::cutOut(const std::vector<Vec2>& outline, const Vec2& axis) {
  cell_.clear();
  reach2_ = 0.0;
  for (const Vec2& corner : outline) {
    cell_.emplace_back(axis.x() * corner.x() - axis.y() * corner.y(),
                       axis.y() * corner.x() + axis.x() * corner.y());
    reach2_ = std::max(reach2_, corner.squaredNorm());
  }
  for (const auto& [distance2, from] : from_) {
    if (distance2 > 4.0 * reach2_ * (1.0 + 1e-12)) {
      break;  // too far to cut anything, like all that follow
    }
    if (distance2 > 0.0) {  // two in one place share it
      cut(from);
    }
  }
}

double CellAreas::areaOf(const Vec2& point, const std::vector<Vec2>& others) {
  from_.clear();
  for (const Vec2& other : others) {
    const Vec2 from = other - point;
    from_.emplace_back(from.squaredNorm(), from);
  }
  std::sort(from_.begin(), from_.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  // The first corner towards the nearest one: the cell turns along with the people.
  const Vec2 towards = from_.empty() ? Vec2(0.0, 0.0) : from_.front().second;
  const double length = lengthOf(towards);
  const Vec2 axis = length > 0.0 ? Vec2(towards / length) : Vec2(1.0, 0.0);
  cutOut(square_, axis);
  if (reach2_ > inside2_) {  // the circle cuts as well
    cutOut(circle_, axis);
  }
  double area = 0.0;
  for (std::size_t k = 0; k < cell_.size(); ++k) {
    area += 0.5 * base::cross(cell_[k], cell_[k + 1 < cell_.size() ? k + 1 : 0]);
  }
  return area;
}

}  // namespace metrics
