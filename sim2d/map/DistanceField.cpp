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

bool reachBeyond(const OccupancyGrid& grid, const Obstacles& obstacles) {
  const auto isOutside = [&](const Vec2& point) {
    constexpr double kEdge = 0.6;  // [cells] the outlines of the map itself may lie on its edge
    const Vec2 corner = grid.worldToCorner(point);
    return corner.minCoeff() < -kEdge || corner.x() > grid.width() + kEdge ||
           corner.y() > grid.height() + kEdge;
  };
  for (int part = 0; part < obstacles.partCount(); ++part) {
    for (const Outline& outline : obstacles.outlines(part)) {
      if (obstacles.isEnabled(part) &&
          std::any_of(outline.points.begin(), outline.points.end(), isOutside)) {
        return true;
      }
    }
  }
  return false;
}

/// Lowers the distances [m] of a map to those of the obstacles. `cells` are what these cover.
class ObstaclePass {
 public:
  ObstaclePass(const OccupancyGrid& grid, const Obstacles& obstacles,
               const std::vector<char>& cells)
      : grid_(grid),
        obstacles_(obstacles),
        cells_(cells),
        toCovered_(distancesToMarked(grid.width(), grid.height(), cells)),
        size_(static_cast<float>(grid.resolution())),
        limit_(kExactRange + 2.0 * grid.resolution()),
        // What stands beyond the grid acts on the cells near its edge.
        edge_(reachBeyond(grid, obstacles) ? static_cast<int>(limit_ / grid.resolution()) : 0) {}

  float lowered(Cell cell, float distance) const {
    const std::size_t i = grid_.indexOf(cell);
    const float rough = size_ * toCovered_[i];  // covered cells reach up to a cell too far
    const bool isNearEdge = std::min({cell.column, grid_.width() - 1 - cell.column, cell.row,
                                      grid_.height() - 1 - cell.row}) < edge_;
    if (rough >= distance && !isNearEdge) {
      return distance;
    }
    if (cells_[i] != 0) {
      return 0.0F;
    }
    const bool isFar = rough > static_cast<float>(kExactRange);
    const float far = std::min(distance, rough + 0.5F * size_);
    if (isFar && !isNearEdge) {
      return far;
    }
    const double exact = obstacles_.clearance(grid_.cellToWorld(cell), limit_);
    return exact < limit_ ? std::min(distance, static_cast<float>(std::max(0.0, exact))) : far;
  }

 private:
  const OccupancyGrid& grid_;
  const Obstacles& obstacles_;
  const std::vector<char>& cells_;
  std::vector<float> toCovered_;  // [cells]
  float size_;
  double limit_;
  int edge_;  // [cells]
};

/// Distances [m] to map walls and obstacles together. `cells` are those of the obstacles.
std::vector<float> combinedDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                                     const std::vector<char>& cells) {
  std::vector<float> distance = distancesToMarked(grid.width(), grid.height(), cellsOfWalls(grid));
  for (float& value : distance) {
    value *= static_cast<float>(grid.resolution());
  }
  const bool isCovered = std::find(cells.begin(), cells.end(), char{1}) != cells.end();
  if (!isCovered && !reachBeyond(grid, obstacles)) {
    return distance;
  }
  const ObstaclePass pass(grid, obstacles, cells);
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      float& value = distance[grid.indexOf({column, row})];
      value = pass.lowered({column, row}, value);
    }
  }
  // All or none are infinite, so that values can be mixed: where only what stands beyond the grid
  // is felt, the cells far from its edge take the range within which it was looked for.
  const auto isFinite = [](float value) { return std::isfinite(value); };
  if (std::any_of(distance.begin(), distance.end(), isFinite)) {
    std::replace(distance.begin(), distance.end(), std::numeric_limits<float>::infinity(),
                 static_cast<float>(kExactRange));
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
  if (std::isinf(distance_.front())) {
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
  const double step = grid_.resolution();
  const auto slope = [&](const Vec2& offset) {
    return distanceAt(Vec2(point + offset)) - distanceAt(Vec2(point - offset));
  };
  const Vec2 gradient(slope({step, 0.0}), slope({0.0, step}));
  const double length = gradient.norm();
  // Infinite or not a number where there is no wall to be felt.
  return length > 1e-6 * step && std::isfinite(length) ? Vec2(gradient / length) : Vec2::Zero();
}

}  // namespace sim2d
