#include "sim2d/map/ObstaclePass.h"

#include <algorithm>

namespace sim2d {

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

ObstaclePass::ObstaclePass(const OccupancyGrid& grid, const Obstacles& obstacles)
    : grid_(grid),
      obstacles_(obstacles),
      size_(static_cast<float>(grid.resolution())),
      limit_(kExactRange + 2.0 * grid.resolution()),
      edge_(reachBeyond(grid, obstacles) ? static_cast<int>(limit_ / grid.resolution()) : 0) {}

float ObstaclePass::lowered(Cell cell, float distance, float toCovered) const {
  const float rough = size_ * toCovered;  // covered cells reach up to a cell too far
  const bool isNearEdge = std::min({cell.column, grid_.width() - 1 - cell.column, cell.row,
                                    grid_.height() - 1 - cell.row}) < edge_;
  if (rough >= distance && !isNearEdge) {
    return distance;
  }
  if (toCovered == 0.0F) {
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

AskedDistances::AskedDistances(const OccupancyGrid& grid, const Obstacles& obstacles,
                               const std::vector<char>& covered, const base::StopFlag& stop)
    : grid_(grid),
      walls_(
          grid.width(), grid.height(), [&grid](Cell cell) { return grid.isWall(cell); }, stop),
      covered_(
          grid.width(), grid.height(), [&](Cell cell) { return covered[grid.indexOf(cell)] != 0; },
          stop),
      unknown_(
          grid.width(), grid.height(),
          [&](Cell cell) { return grid.isUnknown(cell) && !covered_.isMarked(cell); }, stop),
      pass_(grid_, obstacles),
      isLowered_(covered_.isAny() || reachBeyond(grid, obstacles)) {}

float AskedDistances::at(std::size_t index) const {
  const auto columns = static_cast<std::size_t>(grid_.width());
  const Cell cell{static_cast<int>(index % columns), static_cast<int>(index / columns)};
  const float distance = static_cast<float>(grid_.resolution()) * walls_.distance(cell);
  return isLowered_ ? pass_.lowered(cell, distance, covered_.distance(cell)) : distance;
}

}  // namespace sim2d
