#pragma once

#include <vector>

#include "sim2d/world/PersonMotion.h"

namespace sim2d {

/// The state as a frame, without the paths of robots and the changes of trees. `wanted`: of the
/// step that led to it; events are put in order.
Frame makeFrame(const WorldModel& model, const WorldState& state,
                const std::vector<WantedMotion>& wanted);

}  // namespace sim2d
