#pragma once

#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Emits the event `goal` of a goal of the robot's list.
void emitGoal(const ResolvedRobot& robot, std::size_t goal, WorldState& state);

/// The robot's planner has ended the navigation to its current goal, or to several from that one
/// on. Emits `navigation_succeeded` or `navigation_failed`, `goal` of goals that are reached, and
/// `arrived` if all of the robot's goals are. `now`: the robot's part of `state`.
void endGoals(const ResolvedRobot& robot, const NavigationEnd& end, RobotState& now,
              WorldState& state);

}  // namespace sim2d
