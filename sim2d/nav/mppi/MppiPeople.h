#pragma once

#include <vector>

#include "sim2d/nav/Observation.h"
#include "sim2d/nav/mppi/MppiGrids.h"

/// Where others will be during the robot's plan. World frame, SI.
namespace sim2d {

/// One of the others; entry k of the columns is the state at (k + 1) dt.
struct PredictedBody {
  TrackedBody now;
  std::vector<Vec2> positions, velocities;
};

/// The nearest ones within `range` of the robot, in the order of the observation.
std::vector<PredictedBody> bodiesNear(const Observation& observation, double range);

void predictConstant(std::vector<PredictedBody>& bodies, int steps, double dt);

/// By the social force model with its default parameters: each person wants to go on as it does
/// now, and feels the others, the nearest wall and the robot on its way `robot` (a state per step,
/// as theirs). Other robots go straight on.
void predictSocial(std::vector<PredictedBody>& bodies, const PredictedBody& robot, int steps,
                   double dt, const ClearanceGrid& clearance);

}  // namespace sim2d
