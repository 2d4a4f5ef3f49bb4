#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "metrics/Recording.h"

/// Neighbours and cells of points, for the crowd measures.
namespace metrics {

/// Of each point the others within the distance; squares of that size keep it linear.
inline std::vector<std::vector<Vec2>> neighbours(const std::vector<Vec2>& points, double reach) {
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

/// The part of a convex polygon nearer to `centre` than to `other`.
inline std::vector<Vec2> nearerPart(const std::vector<Vec2>& polygon, const Vec2& centre,
                                    const Vec2& other) {
  const Vec2 normal = other - centre;
  const double limit = normal.dot(0.5 * (centre + other));
  std::vector<Vec2> part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2& a = polygon[k];
    const Vec2& b = polygon[(k + 1) % polygon.size()];
    const double sideA = normal.dot(a) - limit;
    const double sideB = normal.dot(b) - limit;
    if (sideA <= 0.0) {
      part.push_back(a);
    }
    if ((sideA < 0.0 && sideB > 0.0) || (sideA > 0.0 && sideB < 0.0)) {
      part.push_back(a + sideA / (sideA - sideB) * (b - a));
    }
  }
  return part;
}

/// Area of the Voronoi cell of the point, cut by a 64-gon with the area of the circle.
inline double cellArea(const Vec2& point, const std::vector<Vec2>& others, double radius) {
  constexpr int kCorners = 64;
  const double turn = 2.0 * base::kPi / kCorners;
  const double corner = radius * std::sqrt(turn / std::sin(turn));
  const auto nearest =
      std::min_element(others.begin(), others.end(), [&point](const Vec2& a, const Vec2& b) {
        return (a - point).squaredNorm() < (b - point).squaredNorm();
      });
  // The first corner towards the nearest one: the cell turns along with the people.
  const double first = nearest == others.end() ? 0.0 : base::headingOf(*nearest - point);
  std::vector<Vec2> cell;
  for (int k = 0; k < kCorners; ++k) {
    const double angle = first + k * turn;
    cell.push_back(point + corner * Vec2(std::cos(angle), std::sin(angle)));
  }
  for (const Vec2& other : others) {
    if (other != point) {  // two in one place share it
      cell = nearerPart(cell, point, other);
    }
  }
  double area = 0.0;
  for (std::size_t k = 0; k < cell.size(); ++k) {
    area += 0.5 * base::cross(cell[k] - point, cell[(k + 1) % cell.size()] - point);
  }
  return area;
}

}  // namespace metrics
