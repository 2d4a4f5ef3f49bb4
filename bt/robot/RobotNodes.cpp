#include "bt/robot/RobotNodes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace bt {
namespace {

using sim2d::nav2::kAllDistros;
using sim2d::nav2::kJazzy;
using sim2d::nav2::kKilted;
using sim2d::nav2::kSinceJazzy;
using sim2d::nav2::kSinceKilted;
using sim2d::nav2::kSinceLyrical;
using sim2d::nav2::kUntilKilted;

struct NodeAvailability {
  std::string_view id;
  unsigned distros;
};
/// Nodes that do not exist in all distributions.
constexpr std::array<NodeAvailability, 33> kNodeDistros = {
    {{"NonblockingSequence", kSinceLyrical},
     {"ValidatePath", kSinceLyrical},
     {"IsPathValid", kUntilKilted},
     {"IsGoalNearby", kSinceLyrical},
     {"PathHandlerSelector", kSinceLyrical},
     {"ComputeRoute", kSinceJazzy},
     {"ComputeAndTrackRoute", kSinceJazzy},
     {"AreErrorCodesPresent", kSinceJazzy},
     {"WouldAControllerRecoveryHelp", kSinceJazzy},
     {"WouldAPlannerRecoveryHelp", kSinceJazzy},
     {"WouldASmootherRecoveryHelp", kSinceJazzy},
     {"ArePosesNear", kSinceJazzy},
     {"ClearCostmapAroundPose", kJazzy | kSinceLyrical},
     {"DockRobot", kSinceJazzy},
     {"UndockRobot", kSinceJazzy},
     {"CancelComputeAndTrackRoute", kSinceJazzy},
     {"ConcatenatePaths", kSinceJazzy},
     {"GetCurrentPose", kSinceJazzy},
     {"GetPoseFromPath", kSinceJazzy},
     {"AppendGoalPoseToGoals", kSinceKilted},
     {"ExtractRouteNodesAsGoals", kSinceKilted},
     {"GetNextFewGoals", kSinceKilted},
     {"RemoveInCollisionGoals", kSinceKilted},
     {"WouldARouteRecoveryHelp", kSinceKilted},
     {"IsStopped", kKilted},
     {"CheckPoseOccupancy", kSinceLyrical},
     {"CheckStopStatus", kSinceLyrical},
     {"IsWithinPathTrackingBounds", kSinceLyrical},
     {"ToggleCollisionMonitor", kSinceLyrical},
     {"PauseResumeController", kSinceLyrical},
     {"PersistentSequence", kSinceLyrical},
     {"FollowObject", kSinceLyrical},
     {"CancelFollowObject", kSinceLyrical}}};

}  // namespace

unsigned distrosOfNode(std::string_view id) {
  const auto* const fact =
      std::find_if(kNodeDistros.begin(), kNodeDistros.end(),
                   [id](const NodeAvailability& each) { return each.id == id; });
  return fact == kNodeDistros.end() ? kAllDistros : fact->distros;
}

namespace {

using namespace sim2d::nav2;  // NOLINT: distribution names

struct PortAvailability {
  std::string_view node;  // empty: any
  std::string_view port;
  unsigned distros;
};
/// Ports that do not exist in all distributions of their node. The first matching row applies.
constexpr std::array<PortAvailability, 39> kPortDistros = {
    {{"Wait", "error_code_id", kSinceKilted},
     {"AssistedTeleop", "error_msg", kSinceLyrical},
     {"", "error_code_id", kSinceJazzy},
     {"", "error_msg", kSinceKilted},
     {"", "disable_collision_checks", kSinceKilted},
     {"AreErrorCodesPresent", "error_codes_to_check", kSinceJazzy},
     {"", "error_codes_to_check", kJazzy | kSinceLyrical},
     {"ClearCostmapAroundPose", "plugins", kSinceLyrical},
     {"ClearCostmapAroundRobot", "plugins", kSinceLyrical},
     {"ClearCostmapExceptRegion", "plugins", kSinceLyrical},
     {"ClearEntireCostmap", "plugins", kSinceLyrical},
     {"ComputeAndTrackRoute", "execution_duration", kJazzy | kSinceLyrical},
     {"ComputeAndTrackRoute", "execution_time", kKilted},
     {"ComputePathThroughPoses", "last_reached_index", kSinceLyrical},
     {"ComputePathToPose", "use_start", kSinceJazzy},
     {"ComputePathToPose", "viapoints", kSinceLyrical},
     {"FollowPath", "path_handler_id", kSinceLyrical},
     {"FollowPath", "progress_checker_id", kSinceJazzy},
     {"FollowPath", "tracking_feedback", kSinceLyrical},
     {"GlobalUpdatedGoal", "goal", kSinceJazzy},
     {"GlobalUpdatedGoal", "goals", kSinceJazzy},
     {"GoalReached", "global_frame", kUntilJazzy},
     {"GoalUpdated", "goal", kSinceJazzy},
     {"GoalUpdated", "goals", kSinceJazzy},
     {"GoalUpdatedController", "goal", kSinceJazzy},
     {"GoalUpdatedController", "goals", kSinceJazzy},
     {"GoalUpdater", "input_goals", kSinceKilted},
     {"GoalUpdater", "output_goals", kSinceKilted},
     {"InitialPoseReceived", "initial_pose_received", kSinceJazzy},
     {"IsPathValid", "consider_unknown_as_obstacle", kKilted},
     {"IsPathValid", "max_cost", kKilted},
     {"RemovePassedGoals", "global_frame", kUntilJazzy},
     {"RemovePassedGoals", "input_waypoint_statuses", kSinceKilted},
     {"RemovePassedGoals", "output_waypoint_statuses", kSinceKilted},
     {"RoundRobin", "wrap_around", kSinceLyrical},
     {"SpeedController", "goal", kSinceJazzy},
     {"SpeedController", "goals", kSinceJazzy},
     {"TruncatePathLocal", "robot_base_frame", kSinceLyrical},
     {"TruncatePathLocal", "robot_frame", kUntilKilted}}};

}  // namespace

unsigned distrosOfPort(std::string_view node, std::string_view port) {
  const auto* const fact =
      std::find_if(kPortDistros.begin(), kPortDistros.end(), [&](const PortAvailability& each) {
        return each.port == port && (each.node.empty() || each.node == node);
      });
  const unsigned ofNode = distrosOfNode(node);
  return fact == kPortDistros.end() ? ofNode : fact->distros & ofNode;
}

}  // namespace bt
