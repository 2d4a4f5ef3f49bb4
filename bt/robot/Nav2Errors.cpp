#include "bt/robot/Nav2Errors.h"

#include <array>
#include <cstddef>

#include "sim2d/nav/nav2/control/Controller.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"

namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

struct CodeText {
  std::string name, message;
};

constexpr int kNoViaPoints = 309;
constexpr int kBehaviorCodes = 10;  // per behaviour

CodeText planText(int code) {
  const auto error = static_cast<PlanError>(code);
  return {planErrorName(error), planErrorWords(error)};
}

CodeText throughText(int code) {
  return code == kNoViaPoints ? CodeText{"NO_VIAPOINTS_GIVEN", "there are no goals"}
                              : planText(code - kThroughPosesOffset);
}

CodeText smoothText(int code) {
  const auto error = static_cast<SmoothError>(code);
  return {smoothErrorName(error), smoothErrorWords(error)};
}

CodeText controlText(int code) {
  static constexpr std::array<const char*, 8> kMessages = {
      "control failed",
      "there is no such controller, goal checker or progress checker",
      "the frames are not connected",
      "the path is empty or cannot be followed",
      "there was no valid command for longer than failure_tolerance",
      "the robot made no progress",
      "there is no valid command",
      "the controller took too long"};
  const auto error = static_cast<ControlCode>(code);
  const auto at = static_cast<std::size_t>(code - static_cast<int>(ControlCode::Unknown));
  return {controlCodeName(error), at < kMessages.size() ? kMessages[at] : kMessages[0]};
}

/// Three numbers of BackUp are in another order than those of the other behaviours.
CodeText behaviorText(RobotAction action, int code) {
  const int number = code % kBehaviorCodes;
  const bool isBackUp = action == RobotAction::BackUp;
  if (number == 1) {
    return {"TIMEOUT", "it took longer than its time_allowance"};
  }
  if (number == 2) {
    return {"TF_ERROR", "the frames are not connected"};
  }
  if (number == (isBackUp ? 4 : 3)) {
    return {"COLLISION_AHEAD", "the robot would collide"};
  }
  if (number == (isBackUp ? 3 : 4)) {
    return {"INVALID_INPUT", "distance and speed have different signs"};
  }
  return {"UNKNOWN", "the behavior failed"};
}

CodeText textOf(const ActionFailure& failure) {
  if (failure.errorCode == 0) {
    return {"NOT_AVAILABLE", "it is not among the server's plugins"};
  }
  switch (failure.action) {
    case RobotAction::ComputePath:
      return planText(failure.errorCode);
    case RobotAction::ComputePathThroughPoses:
      return throughText(failure.errorCode);
    case RobotAction::FollowPath:
      return controlText(failure.errorCode);
    case RobotAction::SmoothPath:
      return smoothText(failure.errorCode);
    case RobotAction::Spin:
    case RobotAction::BackUp:
    case RobotAction::DriveOnHeading:
    case RobotAction::Wait:
      return behaviorText(failure.action, failure.errorCode);
  }
  return {"UNKNOWN", ""};
}

const char* serverOf(RobotAction action) {
  static constexpr std::array<const char*, kRobotActions> kNames = {
      "planner", "planner", "controller", "smoother", "spin", "backup", "drive_on_heading", "wait"};
  return kNames.at(static_cast<std::size_t>(action));
}

}  // namespace

bool isOfPlanner(const ActionFailure& failure) {
  return failure.action == RobotAction::ComputePath ||
         failure.action == RobotAction::ComputePathThroughPoses;
}

std::string failureReason(const ActionFailure& failure, Distro distro) {
  const std::string text = std::string(serverOf(failure.action)) + " " + textOf(failure).name;
  const bool hasCode = distro != Distro::Humble && failure.errorCode != 0;
  return hasCode ? text + " (" + std::to_string(failure.errorCode) + ")" : text;
}

std::string failureMessage(const ActionFailure& failure) {
  return textOf(failure).message;
}

}  // namespace bt
