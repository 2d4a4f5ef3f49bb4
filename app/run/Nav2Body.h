#pragma once

#include <memory>
#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/scenario/Scenario.h"

/// The body of a robot as its Nav2 parameter files have it.
namespace app {

/// The robot with the shape of local_costmap in its parameter files, without padding: `footprint`
/// as its footprint, else `robot_radius` as its radius (see Robot; m, robot frame). What the
/// scenario gave for its shape is replaced. Error: the files cannot be read, or give neither.
base::Result<sim2d::Robot> withNav2Body(sim2d::Robot robot, const std::string& scenarioPath);

/// The scenario as a run takes it: robots that planner nav2 drives and whose `nav2_body` is true
/// have that body. One whose files give none keeps its own, with a warning in `problems`; files
/// that cannot be read are not reported here.
std::shared_ptr<const sim2d::Scenario> withNav2Bodies(
    const std::shared_ptr<const sim2d::Scenario>& scenario, const std::string& scenarioPath,
    base::Diagnostics& problems);

}  // namespace app
