#pragma once

#include <memory>
#include <vector>

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/World.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/planners/RobotController.h"

namespace sim2d {

/// What a world is made of, checked.
struct WorldParts {
  WorldModel model;
  Surroundings surroundings;
  std::unique_ptr<NavigationMap> navigation;
  std::vector<std::shared_ptr<RobotController>> controllers;  // one per robot
};

/// Resolves the scenario, moves starts and goals to where bodies fit, and leaves out goals that
/// nobody can reach. Gathers every problem.
base::Result<std::unique_ptr<WorldParts>> buildWorld(const WorldSetup& setup);

}  // namespace sim2d
