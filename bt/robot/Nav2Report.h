#pragma once

#include <string>

#include "bt/robot/Nav2Files.h"
#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/Planner.h"

namespace bt {

/// The manifest entry of a robot driven by Nav2, as a JSON object: emulated distribution and its
/// commit, plugins, every key of the file and how it was used, applied defaults, actual frequencies
/// and latencies, replaced layers, event counts.
std::string nav2Report(const Nav2Loaded& loaded, const Nav2Statistics& counts,
                       const Nav2Latencies& latencies, const sim2d::PlannerSetup& setup);

/// Values that are valid individually but inconsistent with each other. `setup`: the robot, null:
/// unknown.
base::Diagnostics nav2Inconsistencies(const sim2d::nav2::Nav2Parameters& parameters,
                                      const sim2d::PlannerSetup* setup);

/// Hints of a check: the distribution of the file and keys without effect, with positions.
base::Diagnostics nav2Hints(const sim2d::nav2::Nav2Parameters& parameters);

}  // namespace bt
