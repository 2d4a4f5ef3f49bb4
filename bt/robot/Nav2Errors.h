#pragma once

#include <string>

#include "bt/robot/NavigatorHost.h"

/// Error codes of Nav2's actions by name (nav2_msgs/action of Jazzy and later). Humble has none;
/// there the names are given without the numbers.
namespace bt {

/// An action that failed.
struct ActionFailure {
  RobotAction action = RobotAction::ComputePath;
  int errorCode = 0;  // 0: the server does not have what the request names
};

/// The code of a planner's error in the result of ComputePathThroughPoses, 300 …, where that of
/// ComputePathToPose is 200 ….
constexpr int kThroughPosesOffset = 100;
constexpr int throughPosesCode(int planCode) {
  return planCode == 0 ? 0 : planCode + kThroughPosesOffset;
}

/// "planner NO_VALID_PATH (208)", of Humble "planner NO_VALID_PATH"; "spin COLLISION_AHEAD (703)".
std::string failureReason(const ActionFailure& failure, sim2d::nav2::Distro distro);
/// The same as a sentence without a full stop: "there is no way to the goal".
std::string failureMessage(const ActionFailure& failure);
/// Those of a planner.
bool isOfPlanner(const ActionFailure& failure);

}  // namespace bt
