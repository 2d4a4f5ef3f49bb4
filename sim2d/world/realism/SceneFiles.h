#pragma once

#include <string>

#include "sim2d/base/Result.h"
#include "sim2d/world/realism/RealismTest.h"

/// A scene of each realism test as a scenario to open and watch, with seed 1 and model `das`. The
/// build writes them beside the program.
namespace sim2d {

std::string sceneName(const RealismTest& test);  // "realism_fd_one_way_agents"
Scenario sceneOf(const RealismTest& test);

/// `<folder>/<sceneName>.yaml` of each test; files of tests that are no more are removed.
base::Diagnostics writeScenes(const std::string& folder);

}  // namespace sim2d
