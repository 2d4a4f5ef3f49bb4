#include "sim2d/nav/nav2/costmap/FootprintCost.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace sim2d::nav2 {

std::uint8_t placeCost(const Costmap& costmap, const Vec2& place) {
  const std::optional<Cell> cell = costmap.worldToCell(place);
  return cell ? costmap.at(*cell) : kLethal;
}

std::uint8_t lineCost(const Costmap& costmap, Cell from, Cell to) {
  std::uint8_t most = kFreeSpace;
  visitLine(from, to, [&costmap, &most](Cell cell) {
    const std::uint8_t cost = costmap.at(cell);
    most = cost == kLethal ? kLethal : std::max(most, cost);
    return cost != kLethal;
  });
  return most;
}

std::uint8_t polygonCost(const Costmap& costmap, const Polygon& polygon) {
  if (polygon.empty()) {
    return kFreeSpace;
  }
  std::optional<Cell> first = costmap.worldToCell(polygon.front());
  if (!first) {
    return kLethal;
  }
  Cell from = *first;
  std::uint8_t most = kFreeSpace;
  for (std::size_t i = 1; i < polygon.size() && most != kLethal; ++i) {
    const std::optional<Cell> to = costmap.worldToCell(polygon[i]);
    if (!to) {
      return kLethal;
    }
    most = std::max(most, lineCost(costmap, from, *to));
    from = *to;
  }
  return most == kLethal ? kLethal : std::max(most, lineCost(costmap, *first, from));
}

std::uint8_t footprintCost(const Costmap& costmap, const Polygon& corners, const Pose2& pose) {
  return polygonCost(costmap, placed(corners, pose));
}

bool isInCollision(const Costmap& costmap, const CostmapFootprint& footprint, const Pose2& pose,
                   bool isUnknownFree) {
  return footprint.isRadius
             ? isCentreCollision(placeCost(costmap, pose.position), isUnknownFree)
             : isEdgeCollision(footprintCost(costmap, footprint.corners, pose), isUnknownFree);
}

}  // namespace sim2d::nav2
