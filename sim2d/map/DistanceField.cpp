#include "sim2d/map/DistanceField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim2d/map/DistanceTransform.h"
#include "sim2d/map/WallCells.h"

namespace sim2d {

namespace {

constexpr double kExactRange = 1.2;  // [m]

/// Distances [m] to map walls and obstacles together. `cells` are those of the obstacles.
std::vector<float> combinedDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                                     const std::vector<char>& cells) {
  const auto size = static_cast<float>(grid.resolution());
  const std::vector<char> walls = cellsOfWalls(grid);
  std::vector<float> distance = distancesToMarked(grid.width(), grid.height(), walls);
  for (float& value : distance) {
    value *= size;
  }
  if (std::find(cells.begin(), cells.end(), char{1}) == cells.end()) {
    return distance;
  }
  const std::vector<float> toObstacle = distancesToMarked(grid.width(), grid.height(), cells);
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      const std::size_t i = grid.indexOf({column, row});
      const float rough = size * toObstacle[i];  // marked cells reach up to a cell too far
      if (rough >= distance[i]) {
        continue;
      }
      float exact = 0.0F;
      if (cells[i] == 0 && rough > static_cast<float>(kExactRange)) {
        exact = rough + 0.5F * size;
      } else if (cells[i] == 0) {
        const double limit = kExactRange + 2.0 * grid.resolution();
        exact = static_cast<float>(
            std::max(0.0, obstacles.clearance(grid.cellToWorld({column, row}), limit)));
      }
      distance[i] = std::min(distance[i], exact);
    }
  }
  return distance;
}

}  // namespace

DistanceField::DistanceField(const OccupancyGrid& grid, const Obstacles& obstacles,
                             const std::vector<Vec2>& bounds)
    : grid_(grid.isEmpty() ? gridOver(obstacles, bounds) : grid), isOpenPlane_(grid.isEmpty()) {
  const std::vector<char> cells = cellsOfObstacles(grid_, obstacles);
  distance_ = combinedDistances(grid_, obstacles, cells);
  std::vector<std::int8_t> values = grid_.cells();
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = cells[i] != 0 ? std::int8_t{100} : values[i];
  }
  grid_ = OccupancyGrid(grid_.width(), grid_.height(), grid_.resolution(), grid_.origin(),
                        std::move(values));
  for (int row = 0; row < grid_.height(); ++row) {
    for (int column = 0; column < grid_.width(); ++column) {
      const bool isBorder = !grid_.isWall({column - 1, row}) || !grid_.isWall({column + 1, row}) ||
                            !grid_.isWall({column, row - 1}) || !grid_.isWall({column, row + 1});
      if (isBorder && grid_.isWall({column, row})) {
        border_.push_back({column, row});
      }
    }
  }
}

double DistanceField::outsideDistance(const Vec2& corner) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Cell cell : border_) {
    const double x = std::max(0.0, std::fabs(corner.x() - cell.column - 0.5) - 0.5);
    const double y = std::max(0.0, std::fabs(corner.y() - cell.row - 0.5) - 0.5);
    best = std::min(best, x * x + y * y);
  }
  return std::sqrt(best) * grid_.resolution();
}

double DistanceField::distanceAt(Cell cell) const {
  return grid_.contains(cell) ? static_cast<double>(distance_[grid_.indexOf(cell)])
                              : outsideDistance(Vec2(cell.column + 0.5, cell.row + 0.5));
}

double DistanceField::distanceAt(const Vec2& point) const {
  if (border_.empty()) {
    return std::numeric_limits<double>::infinity();
  }
  const Vec2 corner = grid_.worldToCorner(point);
  const bool isOutside = !(corner.x() >= 0.0 && corner.y() >= 0.0 && corner.x() <= grid_.width() &&
                           corner.y() <= grid_.height());
  if (isOutside) {
    return outsideDistance(corner);
  }
  const double x = std::clamp(corner.x() - 0.5, 0.0, grid_.width() - 1.0);
  const double y = std::clamp(corner.y() - 0.5, 0.0, grid_.height() - 1.0);
  const Cell low{static_cast<int>(x), static_cast<int>(y)};
  const std::size_t first = grid_.indexOf(low);
  const std::size_t right = low.column + 1 < grid_.width() ? 1 : 0;
  const std::size_t up = low.row + 1 < grid_.height() ? static_cast<std::size_t>(grid_.width()) : 0;
  const double tx = x - low.column;
  const double ty = y - low.row;
  const auto value = [&](std::size_t offset) {
    return static_cast<double>(distance_[first + offset]);
  };
  return (1.0 - ty) * ((1.0 - tx) * value(0) + tx * value(right)) +
         ty * ((1.0 - tx) * value(up) + tx * value(up + right));
}

Vec2 DistanceField::gradientAt(const Vec2& point) const {
  if (border_.empty()) {
    return Vec2::Zero();
  }
  const double step = grid_.resolution();
  const auto slope = [&](const Vec2& offset) {
    return distanceAt(Vec2(point + offset)) - distanceAt(Vec2(point - offset));
  };
  const Vec2 gradient(slope({step, 0.0}), slope({0.0, step}));
  const double length = gradient.norm();
  return length > 1e-6 * step ? Vec2(gradient / length) : Vec2::Zero();
}

}  // namespace sim2d
