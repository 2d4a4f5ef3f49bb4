#include "bt/robot/RobotNodes.h"

#include <map>
#include <set>
#include <string>
#include <string_view>

namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: distribution names

/// Names by the distributions that have them.
using Availability = std::map<unsigned, std::set<std::string, std::less<>>>;

/// Nodes that do not exist in all distributions.
const Availability kNodeDistros = {
    {kSinceLyrical,
     {"NonblockingSequence", "ValidatePath", "IsGoalNearby", "PathHandlerSelector",
      "CheckPoseOccupancy", "CheckStopStatus", "IsWithinPathTrackingBounds",
      "ToggleCollisionMonitor", "PauseResumeController", "PersistentSequence", "FollowObject",
      "CancelFollowObject"}},
    {kUntilKilted, {"IsPathValid"}},
    {kSinceJazzy,
     {"ComputeRoute", "ComputeAndTrackRoute", "AreErrorCodesPresent",
      "WouldAControllerRecoveryHelp", "WouldAPlannerRecoveryHelp", "WouldASmootherRecoveryHelp",
      "ArePosesNear", "DockRobot", "UndockRobot", "CancelComputeAndTrackRoute", "ConcatenatePaths",
      "GetCurrentPose", "GetPoseFromPath"}},
    {kJazzy | kSinceLyrical, {"ClearCostmapAroundPose"}},
    {kSinceKilted,
     {"AppendGoalPoseToGoals", "ExtractRouteNodesAsGoals", "GetNextFewGoals",
      "RemoveInCollisionGoals", "WouldARouteRecoveryHelp"}},
    {kKilted, {"IsStopped"}}};

/// Ports that do not exist in all distributions of their node: "Node.port", otherwise of any node.
const Availability kPortDistros = {
    {kSinceKilted,
     {"Wait.error_code_id", "error_msg", "disable_collision_checks", "GoalUpdater.input_goals",
      "GoalUpdater.output_goals", "RemovePassedGoals.input_waypoint_statuses",
      "RemovePassedGoals.output_waypoint_statuses"}},
    {kSinceLyrical,
     {"AssistedTeleop.error_msg", "ClearCostmapAroundPose.plugins",
      "ClearCostmapAroundRobot.plugins", "ClearCostmapExceptRegion.plugins",
      "ClearEntireCostmap.plugins", "ComputePathThroughPoses.last_reached_index",
      "ComputePathToPose.viapoints", "FollowPath.path_handler_id", "FollowPath.tracking_feedback",
      "RoundRobin.wrap_around", "TruncatePathLocal.robot_base_frame"}},
    {kSinceJazzy,
     {"error_code_id", "AreErrorCodesPresent.error_codes_to_check", "ComputePathToPose.use_start",
      "FollowPath.progress_checker_id", "GlobalUpdatedGoal.goal", "GlobalUpdatedGoal.goals",
      "GoalUpdated.goal", "GoalUpdated.goals", "GoalUpdatedController.goal",
      "GoalUpdatedController.goals", "InitialPoseReceived.initial_pose_received",
      "SpeedController.goal", "SpeedController.goals"}},
    {kJazzy | kSinceLyrical, {"error_codes_to_check", "ComputeAndTrackRoute.execution_duration"}},
    {kKilted,
     {"ComputeAndTrackRoute.execution_time", "IsPathValid.consider_unknown_as_obstacle",
      "IsPathValid.max_cost"}},
    {kUntilJazzy, {"GoalReached.global_frame", "RemovePassedGoals.global_frame"}},
    {kUntilKilted, {"TruncatePathLocal.robot_frame"}}};

/// kAllDistros for a name that the table does not have.
unsigned distrosOf(const Availability& table, std::string_view name) {
  for (const auto& [distros, names] : table) {
    if (names.find(name) != names.end()) {
      return distros;
    }
  }
  return kAllDistros;
}

}  // namespace

unsigned distrosOfNode(std::string_view id) {
  return distrosOf(kNodeDistros, id);
}

unsigned distrosOfPort(std::string_view node, std::string_view port) {
  const unsigned own = distrosOf(kPortDistros, std::string(node) + "." + std::string(port));
  return distrosOfNode(node) & (own != kAllDistros ? own : distrosOf(kPortDistros, port));
}

}  // namespace bt
