#include "metrics/CrowdCells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace metrics {

std::vector<std::vector<Vec2>> neighbours(const std::vector<Vec2>& points, double reach) {
  using Square = std::pair<long long, long long>;
  const auto squareOf = [reach](const Vec2& point) {
    return Square(std::llround(std::floor(point.x() / reach)),
                  std::llround(std::floor(point.y() / reach)));
  };
  std::map<Square, std::vector<std::size_t>> squares;
  for (std::size_t k = 0; k < points.size(); ++k) {
    squares[squareOf(points[k])].push_back(k);
  }
  std::vector<std::vector<Vec2>> result(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Square centre = squareOf(points[k]);
    for (int place = 0; place < 9; ++place) {
      const auto found =
          squares.find({centre.first + place % 3 - 1, centre.second + place / 3 - 1});
      if (found == squares.end()) {
        continue;
      }
      for (const std::size_t other : found->second) {
        if (other != k && (points[other] - points[k]).squaredNorm() <= reach * reach) {
          result[k].push_back(points[other]);
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
}

/// Leaves the part that is nearer to the origin.
void CellAreas::cut(const Vec2& other) {
  const double limit = 0.5 * other.squaredNorm();
  part_.clear();
  reach2_ = 0.0;
  const auto keep = [this](const Vec2& corner) {
    part_.push_back(corner);
    reach2_ = std::max(reach2_, corner.squaredNorm());
  };
  for (std::size_t k = 0; k < cell_.size(); ++k) {
    const Vec2& a = cell_[k];
    const Vec2& b = cell_[k + 1 < cell_.size() ? k + 1 : 0];
    const double sideA = other.dot(a) - limit;
    const double sideB = other.dot(b) - limit;
    if (sideA <= 0.0) {
      keep(a);
    }
    if ((sideA < 0.0 && sideB > 0.0) || (sideA > 0.0 && sideB < 0.0)) {
      keep(a + sideA / (sideA - sideB) * (b - a));
    }
  }
  cell_.swap(part_);
}

double CellAreas::areaOf(const Vec2& point, std::vector<Vec2>& others) {
  std::sort(others.begin(), others.end(), [&point](const Vec2& a, const Vec2& b) {
    return (a - point).squaredNorm() < (b - point).squaredNorm();
  });
  // The first corner towards the nearest one: the cell turns along with the people.
  const Vec2 towards = others.empty() ? Vec2(0.0, 0.0) : Vec2(others.front() - point);
  const double length = lengthOf(towards);
  const Vec2 axis = length > 0.0 ? Vec2(towards / length) : Vec2(1.0, 0.0);
  cell_.clear();
  for (const Vec2& corner : circle_) {
    cell_.emplace_back(axis.x() * corner.x() - axis.y() * corner.y(),
                       axis.y() * corner.x() + axis.x() * corner.y());
  }
  reach2_ = circle_.front().squaredNorm();
  for (const Vec2& other : others) {
    const Vec2 from = other - point;
    if (from.squaredNorm() > 4.0 * reach2_ * (1.0 + 1e-12)) {
      break;  // too far to cut anything, like all that follow
    }
    if (other != point) {  // two in one place share it
      cut(from);
    }
  }
  double area = 0.0;
  for (std::size_t k = 0; k < cell_.size(); ++k) {
    area += 0.5 * base::cross(cell_[k], cell_[k + 1 < cell_.size() ? k + 1 : 0]);
  }
  return area;
}

}  // namespace metrics
