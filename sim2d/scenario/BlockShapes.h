#pragma once

#include "sim2d/scenario/MapView.h"
#include "sim2d/scenario/Scenario.h"

/// Drawn things of our block: reading and writing of their keys. Private to this folder.
namespace sim2d {

Obstacle readObstacle(MapView view);
Door readDoor(MapView view);
Area readArea(MapView view);

YamlNode obstacleTree(const Obstacle& obstacle);
YamlNode doorTree(const Door& door);
YamlNode areaTree(const Area& area);

}  // namespace sim2d
