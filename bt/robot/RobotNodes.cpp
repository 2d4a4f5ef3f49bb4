#include "bt/robot/RobotNodes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace bt {
namespace {

using sim2d::nav2::kEveryDistro;
using sim2d::nav2::kJazzy;
using sim2d::nav2::kKilted;
using sim2d::nav2::kSinceJazzy;
using sim2d::nav2::kSinceKilted;
using sim2d::nav2::kSinceLyrical;
using sim2d::nav2::kUntilKilted;

struct NodeFact {
  std::string_view id;
  unsigned distros;
};
/// Of those that are not in all branches.
constexpr std::array<NodeFact, 33> kLater = {{{"NonblockingSequence", kSinceLyrical},
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
  const auto* const fact = std::find_if(kLater.begin(), kLater.end(),
                                        [id](const NodeFact& each) { return each.id == id; });
  return fact == kLater.end() ? kEveryDistro : fact->distros;
}

}  // namespace bt
