#include <array>
#include <cstddef>

#include "bt/robot/NavigatorHost.h"
#include "sim2d/base/Find.h"
#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/docking/DockingServer.h"
#include "sim2d/nav/nav2/docking/FollowingServer.h"
#include "sim2d/nav/nav2/global/GlobalPlanner.h"
#include "sim2d/nav/nav2/global/PathSmoother.h"
#include "sim2d/nav/nav2/route/RouteGraph.h"

namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: this file only concerns Nav2

struct CodeText {
  std::string name, message;
};

constexpr int kNoViaPoints = 309;
constexpr int kBehaviorCodes = 10;  // codes per behaviour

CodeText planText(int code) {
  const auto error = static_cast<PlanError>(code);
  return {planErrorName(error), planErrorMessage(error)};
}

CodeText throughText(int code) {
  return code == kNoViaPoints ? CodeText{"NO_VIAPOINTS_GIVEN", "there are no goals"}
                              : planText(code - kThroughPosesOffset);
}

CodeText smoothText(int code) {
  const auto error = static_cast<SmoothError>(code);
  return {smoothErrorName(error), smoothErrorMessage(error)};
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
  const auto error = static_cast<ControllerError>(code);
  const auto at = static_cast<std::size_t>(code - static_cast<int>(ControllerError::Unknown));
  return {controllerErrorName(error), at < kMessages.size() ? kMessages[at] : kMessages[0]};
}

/// BackUp orders two of its codes differently from the other behaviours.
CodeText behaviorText(RobotAction action, int code) {
  static constexpr std::array<std::array<const char*, 2>, 5> kTexts = {
      {{"UNKNOWN", "the behavior failed"},
       {"TIMEOUT", "the behavior exceeded its time_allowance"},
       {"TF_ERROR", "the frames are not connected"},
       {"COLLISION_AHEAD", "the robot would collide"},
       {"INVALID_INPUT", "distance and speed have different signs"}}};
  const int number = code % kBehaviorCodes;
  const bool isSwapped = action == RobotAction::BackUp && (number == 3 || number == 4);
  const auto at = static_cast<std::size_t>(isSwapped ? 7 - number : number);
  const auto& text = kTexts[at < kTexts.size() ? at : 0];
  return {text[0], text[1]};
}

constexpr int kNoTreeToPose =
    navigationCode(RobotAction::NavigateToPose, NavigationError::FailedToLoadTree);
constexpr int kNoTreeThroughPoses =
    navigationCode(RobotAction::NavigateThroughPoses, NavigationError::FailedToLoadTree);

struct CodeRow {
  int code;
  const char *name, *message;
};

constexpr std::array<CodeRow, 18> kOtherCodes = {
    {{static_cast<int>(RouteError::TfError), "TF_ERROR", "the frames are not connected"},
     {static_cast<int>(RouteError::NoValidGraph), "NO_VALID_GRAPH", "there is no graph"},
     {static_cast<int>(RouteError::IndeterminantNodes), "INDETERMINANT_NODES_ON_GRAPH",
      "start or goal is not on the graph"},
     {static_cast<int>(RouteError::Timeout), "TIMEOUT", "the search took too long"},
     {static_cast<int>(RouteError::NoValidRoute), "NO_VALID_ROUTE",
      "the graph has no route to the goal"},
     {static_cast<int>(RouteError::OperationFailed), "OPERATION_FAILED", "an operation failed"},
     {static_cast<int>(RouteError::InvalidEdgeScorerUse), "INVALID_EDGE_SCORER_USE",
      "an edge lacks metadata that a scorer needs"},
     {static_cast<int>(DockError::DockNotInDb), "DOCK_NOT_IN_DB", "there is no such dock"},
     {static_cast<int>(DockError::DockNotValid), "DOCK_NOT_VALID", "the type of dock is unknown"},
     {static_cast<int>(DockError::FailedToStage), "FAILED_TO_STAGE",
      "the robot did not reach the staging pose"},
     {static_cast<int>(DockError::FailedToDetectDock), "FAILED_TO_DETECT_DOCK",
      "the dock was not detected"},
     {static_cast<int>(DockError::FailedToControl), "FAILED_TO_CONTROL",
      "there is no valid command"},
     {static_cast<int>(DockError::FailedToCharge), "FAILED_TO_CHARGE", "charging did not start"},
     {static_cast<int>(DockError::Timeout), "TIMEOUT", "docking took too long"},
     {static_cast<int>(FollowError::FailedToDetectObject), "FAILED_TO_DETECT_OBJECT",
      "the object was not detected"},
     {static_cast<int>(FollowError::FailedToControl), "FAILED_TO_CONTROL",
      "there is no valid command"},
     {kNoTreeToPose, "FAILED_TO_LOAD_BEHAVIOR_TREE", "there is no such tree"},
     {kNoTreeThroughPoses, "FAILED_TO_LOAD_BEHAVIOR_TREE", "there is no such tree"}}};

CodeText otherText(int code) {
  const CodeRow* const row = base::findBy(kOtherCodes, &CodeRow::code, code);
  return row != nullptr ? CodeText{row->name, row->message} : CodeText{"UNKNOWN", "it failed"};
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
    case RobotAction::AssistedTeleop:
      return behaviorText(failure.action, failure.errorCode);
    default:
      return otherText(failure.errorCode);
  }
}

const char* serverOf(RobotAction action) {
  static constexpr const char* kNames[kRobotActions] = {"planner",
                                                        "planner",
                                                        "controller",
                                                        "smoother",
                                                        "spin",
                                                        "backup",
                                                        "drive_on_heading",
                                                        "wait",
                                                        "navigate_to_pose",
                                                        "navigate_through_poses",
                                                        "route",
                                                        "route",
                                                        "assisted_teleop",
                                                        "docking",
                                                        "undocking",
                                                        "following"};
  return kNames[static_cast<std::size_t>(action)];
}

}  // namespace

bool isPlannerFailure(const ActionFailure& failure) {
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
