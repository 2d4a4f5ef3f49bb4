#pragma once

#include <string>

#include "bt/robot/Nav2Files.h"
#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/Planner.h"

namespace bt {

/// What a manifest tells of a robot that Nav2 drives, as a JSON object: branch imitated and its
/// commit, plugins, every key of the file with what became of it, defaults that were taken,
/// frequencies and latencies as they come out, layers treated as others, counts of what happened.
std::string nav2Report(const Nav2Loaded& loaded, const Nav2Counts& counts,
                       const Nav2Latencies& latencies, const sim2d::PlannerSetup& setup);

/// Values that fit each for itself and not together. `setup`: the robot, null: not known.
base::Diagnostics nav2Contradictions(const sim2d::nav2::Nav2Parameters& parameters,
                                     const sim2d::PlannerSetup* setup);

/// What a check adds for people: for which branch the file counts, keys without effect. Hints, at
/// their places.
base::Diagnostics nav2Remarks(const sim2d::nav2::Nav2Parameters& parameters);

}  // namespace bt
