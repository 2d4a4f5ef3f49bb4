#pragma once

#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/WorldState.h"

/// What leaves the world: its frames, and what a record says beside them.
namespace sim2d {

/// The state as a frame, but for the paths of robots, inputs and the changes of trees. It already
/// has the forces of all people in the step that led to it. The events are taken from the state and
/// put in order. The memory of the frame is used again.
void fillFrame(const WorldModel& model, WorldState& state, Frame& frame);

/// Everybody so far with all resolved numbers, outlines, map.
TraceHeader makeHeader(const WorldModel& model, const Surroundings& surroundings);

/// Names of the parts of the surroundings: "map", then listed obstacles, then listed doors.
std::vector<std::string> partNames(const Environment& scenario);

}  // namespace sim2d
