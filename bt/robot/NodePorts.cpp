#include "bt/robot/NodePorts.h"

#include <algorithm>
#include <array>

#include "bt/robot/RobotNodes.h"

namespace bt {
namespace {

using namespace sim2d::nav2;  // NOLINT: names of branches

struct PortFact {
  std::string_view node;  // empty: every one
  std::string_view port;
  unsigned distros;
};
/// Of those that are not in all branches of their node. The first row that fits counts.
constexpr std::array<PortFact, 39> kLaterPorts = {
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
      std::find_if(kLaterPorts.begin(), kLaterPorts.end(), [&](const PortFact& each) {
        return each.port == port && (each.node.empty() || each.node == node);
      });
  const unsigned ofNode = distrosOfNode(node);
  return fact == kLaterPorts.end() ? ofNode : fact->distros & ofNode;
}

}  // namespace bt
