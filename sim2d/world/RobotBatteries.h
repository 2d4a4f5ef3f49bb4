#pragma once

#include <vector>

#include "sim2d/world/WorldState.h"

/// Batteries of robots and the docks that charge them.
namespace sim2d {

/// A robot is at a dock when its centre is this near to the dock's pose and its heading, or the
/// opposite one of a robot that backs in, differs by less than the angle.
constexpr double kDockReach = 0.1;   // [m]
constexpr double kDockAngle = 0.35;  // [rad]
constexpr double kDockSight = 3.0;   // [m], range of dock detectors

/// The dock that a robot at this pose is in; null: none.
const Dock* dockAt(const std::vector<const Dock*>& docks, const Pose2& pose);

/// Docks within kDockSight of the robot, as a detector on it sees them: relative to its true pose,
/// in the frame in which the robot takes itself to be at `believed`.
std::vector<DockPlace> docksSeen(const std::vector<const Dock*>& docks, const Pose2& truth,
                                 const Pose2& believed);

/// What the monitor of the robot's battery measures; none: it has no battery.
std::optional<BatteryState> batteryOf(const ResolvedRobot& robot, const RobotState& state);

/// After the step of bodies: batteries give what the motion took, or are charged at docks. Emits
/// `battery` with "charging", "full" or "empty" when that begins.
void updateBatteries(const WorldModel& model, WorldState& state);

}  // namespace sim2d
