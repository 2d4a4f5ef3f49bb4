#include "bt/tree/TreeUse.h"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace bt {
namespace {

// Frequent nodes suffice. bt/tree does not know the manifests of either kind; a test compares them.
constexpr std::string_view kPersonNodes[] = {
    "ApproachAgent", "AvoidRobot",     "BlockRobot",    "CuriousNav",     "FollowAgent",
    "GoTo",          "IsAgentVisible", "IsGoalReached", "IsRobotClose",   "IsRobotVisible",
    "LookAtRobot",   "RegularNav",     "SaySomething",  "ScaredNav",      "SetGoal",
    "SetGroupWalk",  "StopMovement",   "SurprisedNav",  "ThreateningNav", "TimeExpiredCondition",
    "UpdateGoal",    "WanderInArea"};
constexpr std::string_view kNavigatorNodes[] = {"BackUp",
                                                "ClearEntireCostmap",
                                                "ComputeAndTrackRoute",
                                                "ComputePathThroughPoses",
                                                "ComputePathToPose",
                                                "ComputeRoute",
                                                "DockRobot",
                                                "DriveOnHeading",
                                                "FollowObject",
                                                "FollowPath",
                                                "GoalUpdated",
                                                "NavigateThroughPoses",
                                                "NavigateToPose",
                                                "PipelineSequence",
                                                "RateController",
                                                "RecoveryNode",
                                                "RoundRobin",
                                                "SmoothPath",
                                                "Spin"};

template <std::size_t N>
bool isAmong(const std::string_view (&ids)[N], std::string_view id) {
  return std::find(std::begin(ids), std::end(ids), id) != std::end(ids);
}

/// Nodes for robots minus nodes for people.
int navigatorBalance(const NodeSpec& node) {
  int balance = static_cast<int>(isAmong(kNavigatorNodes, node.id)) -
                static_cast<int>(isAmong(kPersonNodes, node.id));
  for (const NodeSpec& child : node.children) {
    balance += navigatorBalance(child);
  }
  return balance;
}

}  // namespace

TreeUse treeUse(const TreeFile& file) {
  int balance = 0;
  for (const TreeSpec& tree : file.trees) {
    balance += navigatorBalance(tree.root);
  }
  if (balance == 0) {
    return TreeUse::Unknown;
  }
  return balance > 0 ? TreeUse::Navigator : TreeUse::Person;
}

std::optional<base::Diagnostic> wrongTreeUse(const TreeFile& file, TreeUse wanted) {
  const TreeUse use = treeUse(file);
  if (use == wanted || use == TreeUse::Unknown) {
    return std::nullopt;
  }
  return base::error(use == TreeUse::Navigator ? "tree.of-robot" : "tree.of-person", {}, file.path,
                     file.trees.front().line);
}

}  // namespace bt
