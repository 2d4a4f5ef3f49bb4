#include "sim2d/map/Outlines.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace sim2d {
namespace {

std::vector<Outline> outlinesOf(const Obstacle& obstacle) {
  switch (obstacle.kind) {
    case ObstacleKind::Box:
      return {boxOutline(obstacle.pose, obstacle.length, obstacle.width)};
    case ObstacleKind::Circle:
      return {circleOutline(obstacle.pose.position, obstacle.radius)};
    case ObstacleKind::Polygon:
      if (obstacle.points.size() < 3) {
        return {};  // the reader has told
      }
      return {polygonOutline(obstacle.points)};
    case ObstacleKind::Wall:
      break;
  }
  return obstacle.points.size() < 2
             ? std::vector<Outline>()
             : wallOutlines(obstacle.points, obstacle.thickness.value_or(0.1));
}

std::vector<Outline> outlinesOf(const Door& door) {
  if (door.from == door.to) {
    return {};
  }
  return wallOutlines({door.from, door.to}, door.thickness.value_or(0.05));
}

}  // namespace

Surroundings makeSurroundings(const Scenario& scenario, OccupancyGrid grid) {
  Surroundings result;
  result.obstacles.add(traceOutlines(grid));
  result.grid = std::move(grid);
  for (const Obstacle& obstacle : scenario.obstacles) {
    if (obstacle.listed) {
      result.obstacles.add(outlinesOf(obstacle));
    }
  }
  result.firstDoorPart = result.obstacles.partCount();
  for (const Door& door : scenario.doors) {
    if (door.listed) {
      result.obstacles.add(outlinesOf(door), !door.open.value_or(true));
    }
  }
  result.obstacles.build();
  return result;
}

}  // namespace sim2d
