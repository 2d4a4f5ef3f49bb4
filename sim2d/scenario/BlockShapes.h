#pragma once

#include "sim2d/scenario/AgentReader.h"
#include "sim2d/scenario/Scenario.h"

/// Drawn things of our block: reading and writing of their keys. Private to this folder.
namespace sim2d {

Obstacle readObstacle(YamlMap view);
Door readDoor(YamlMap view);
Area readArea(YamlMap view);

YamlNode obstacleTree(const Obstacle& obstacle);
YamlNode doorTree(const Door& door);
YamlNode areaTree(const Area& area);

}  // namespace sim2d
