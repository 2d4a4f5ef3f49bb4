#pragma once

#include <string>

#include "bt/robot/NavigatorHost.h"

/// Names of the error codes of Nav2's actions (nav2_msgs/action of Jazzy and later). Humble has no
/// codes; the names are then given without numbers.
namespace bt {

/// A failed action.
struct ActionFailure {
  RobotAction action = RobotAction::ComputePath;
  int errorCode = 0;  // 0: the server does not have the requested item
};

/// Offset between the planner error codes of ComputePathThroughPoses (300 …) and ComputePathToPose
/// (200 …).
constexpr int kThroughPosesOffset = 100;
constexpr int throughPosesCode(int planCode) {
  return planCode == 0 ? 0 : planCode + kThroughPosesOffset;
}

/// "planner NO_VALID_PATH (208)", in Humble "planner NO_VALID_PATH"; "spin COLLISION_AHEAD (703)".
std::string failureReason(const ActionFailure& failure, sim2d::nav2::Distro distro);
/// The same as a sentence without a full stop: "there is no path to the goal".
std::string failureMessage(const ActionFailure& failure);
/// Whether the failure is one of a planner.
bool isPlannerFailure(const ActionFailure& failure);

}  // namespace bt
