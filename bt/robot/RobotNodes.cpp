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
constexpr std::array<NodeFact, 31> kLater = {{{"NonblockingSequence", kSinceLyrical},
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
                                              {"PersistentSequence", kSinceLyrical}}};

struct NodeReason {
  std::string_view id, why;
};
constexpr std::array<NodeReason, 3> kUnsupported = {
    {{"AssistedTeleop", "nobody steers here"},
     {"DockRobot", "there are no docks here"},
     {"UndockRobot", "there are no docks here"}}};
constexpr std::array<NodeReason, 2> kConstant = {
    {{"IsBatteryLow", "FAILURE: batteries are full here"},
     {"IsBatteryCharging", "FAILURE: batteries are full here"}}};

template <class Facts>
auto factOf(const Facts& facts, std::string_view id) {
  return std::find_if(facts.begin(), facts.end(), [id](const auto& fact) { return fact.id == id; });
}

}  // namespace

unsigned distrosOfNode(std::string_view id) {
  const auto* const fact = factOf(kLater, id);
  return fact == kLater.end() ? kEveryDistro : fact->distros;
}

std::string_view unsupportedNode(std::string_view id) {
  const auto* const reason = factOf(kUnsupported, id);
  return reason == kUnsupported.end() ? std::string_view() : reason->why;
}

std::string_view constantNode(std::string_view id) {
  const auto* const reason = factOf(kConstant, id);
  return reason == kConstant.end() ? std::string_view() : reason->why;
}

}  // namespace bt
