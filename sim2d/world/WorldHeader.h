#pragma once

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// What a record says about the run beside the trajectories: everybody so far with all resolved
/// numbers, outlines, map.
TraceHeader makeHeader(const WorldModel& model, const Surroundings& surroundings);

/// Names of the parts of the surroundings: "map", then listed obstacles, then listed doors.
std::vector<std::string> partNames(const Environment& scenario);

}  // namespace sim2d
