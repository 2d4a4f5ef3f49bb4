#pragma once

#include "sim2d/world/PersonMotion.h"

namespace sim2d {

/// The state as a frame, but for the paths of robots and the changes of trees. It already has the
/// forces of all people in the step that led to it. The events are taken from the state and put in
/// order. The memory of the frame is used again.
void fillFrame(const WorldModel& model, WorldState& state, Frame& frame);

}  // namespace sim2d
