#pragma once

#include <string>
#include <vector>

#include "bt/robot/Nav2Files.h"
#include "sim2d/scenario/Scenario.h"

/// What planner `nav2` needs beside the scenario: files, and values that only they know of.
namespace app {

/// Shipped parameter files and trees.
bt::Nav2Folders shippedNav2();

/// Of robots that take part and are driven by `nav2`: without a `goal_radius` they have that of
/// their file's goal checker. Returns what is wrong with values given instead of the file's
/// (`nav2.FollowPath.temperature`); problems of the files are told where the world is made.
base::Diagnostics fillNav2Robots(sim2d::Scenario& scenario, const std::string& scenarioPath);

/// The parameter files and trees that they read.
std::vector<std::string> nav2FilesOf(const sim2d::Scenario& scenario,
                                     const std::string& scenarioPath);

/// A `nav2_params.yaml` by itself: everything that is wrong with it, and what deserves a word.
base::Diagnostics checkNav2File(const std::string& path);
/// A navigator's tree by itself.
base::Diagnostics checkNavigatorTree(const std::string& path);

}  // namespace app
