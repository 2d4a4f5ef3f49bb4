#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "bt/robot/RobotNodes.h"
#include "sim2d/base/Find.h"

/// Actions of Nav2 that extract poses from paths, goals and the robot, and that combine goals
/// (nav2_behavior_tree/plugins/action).
namespace bt {
namespace {

using base::NodeStatus;
using base::Pose2;
using sim2d::nav2::Path;

/// Ports 0: path, 1: index, negative from the end, 2: pose (out).
NodeStatus poseFromPath(LeafContext& leaf) {
  const Path& path = robotOf(leaf).paths().get(pathOf(leaf, 0));
  const auto count = static_cast<std::int64_t>(path.size());
  std::int64_t index = leaf.require<int>(1);
  index += index < 0 ? count : 0;
  if (index < 0 || index >= count) {
    return NodeStatus::Failure;
  }
  return setPathOutput(leaf, 2, {path[static_cast<std::size_t>(index)]});
}

/// Port 2: pose (out).
NodeStatus currentPose(LeafContext& leaf) {
  return setPathOutput(leaf, 2, {robotOf(leaf).pose()});
}

Path joined(Path first, const Path& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

/// Ports 0, 1: paths, 2: both (out).
NodeStatus concatenatePaths(LeafContext& leaf) {
  const PathStore& paths = robotOf(leaf).paths();
  const Path& first = paths.get(pathOf(leaf, 0));
  const Path& second = paths.get(pathOf(leaf, 1));
  if (first.empty() && second.empty()) {
    return NodeStatus::Failure;
  }
  return setPathOutput(leaf, 2, joined(first, second));
}

/// Ports 0: goals, 1: goal, 2: goals with the goal appended (out).
NodeStatus appendGoal(LeafContext& leaf) {
  const PathStore& paths = robotOf(leaf).paths();
  const Path& goal = paths.get(pathOf(leaf, 1));
  if (goal.empty()) {
    return NodeStatus::Failure;
  }
  return setPathOutput(leaf, 2, joined(paths.get(pathOf(leaf, 0)), {goal.front()}));
}

/// Ports 0: goals, 1: count, 2: the first goals (out).
NodeStatus nextFewGoals(LeafContext& leaf) {
  const Path& goals = robotOf(leaf).paths().get(pathOf(leaf, 0));
  const int wanted = leaf.require<int>(1);
  if (goals.empty() || wanted < 0) {
    return NodeStatus::Failure;
  }
  const auto count = std::min<std::ptrdiff_t>(wanted, static_cast<std::ptrdiff_t>(goals.size()));
  return setPathOutput(leaf, 2, Path(goals.begin(), goals.begin() + count));
}

// Occupancy. Nav2 calls the service get_cost, whose name selects the costmap.

struct Occupancy {
  double threshold = 254.0;
  bool usesFootprint = true, unknownBlocks = false;
  bool isFree(std::uint8_t cost) const {
    const bool isUnknown = cost == sim2d::nav2::kNoInformation;
    return (isUnknown && !unknownBlocks) || cost < threshold;
  }
};

/// Ports from `first`: threshold, use of the footprint, unknown counts as an obstacle.
Occupancy occupancyOf(LeafContext& leaf, int first) {
  Occupancy occupancy;
  occupancy.threshold = leaf.getOr<double>(first, 254.0);
  occupancy.usesFootprint = leaf.getOr<bool>(first + 1, true);
  occupancy.unknownBlocks = leaf.getOr<bool>(first + 2, false);
  return occupancy;
}

/// Ports 0: pose, 1: service, 2 to 4: as above. SUCCESS: the pose is free.
NodeStatus checkPose(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const Path& pose = robot.paths().get(pathOf(leaf, 0));
  const Occupancy occupancy = occupancyOf(leaf, 2);
  if (pose.empty()) {
    return NodeStatus::Failure;
  }
  const auto cost =
      robot.costAt(namesLocalCostmap(textOf(leaf, 1)), pose.front(), occupancy.usesFootprint);
  return successIf(cost && occupancy.isFree(*cost));
}

/// Sets the status of the first pending waypoint with that pose.
void mark(Waypoints& waypoints, const Pose2& pose, Waypoint::Status status) {
  const auto isIt = [&](const Waypoint& each) {
    return each.status == Waypoint::Status::Pending && each.pose == pose;
  };
  if (Waypoint* const found = base::findIf(waypoints, isIt)) {
    found->status = status;
  }
}

void putStatuses(LeafContext& leaf, int port, Waypoints waypoints) {
  if (!waypoints.empty()) {
    setNumber(leaf, port, robotOf(leaf).waypoints().add(std::move(waypoints)));
  }
}

/// Ports 0: goals, 1: service, 2 to 4: as above, 5: free goals (out), 6: waypoint statuses, 7: the
/// same (out). A pose off the map is a failure, and all goals are kept.
NodeStatus removeColliding(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const PathId from = pathOf(leaf, 0);
  const Path& goals = robot.paths().get(from);
  const Occupancy occupancy = occupancyOf(leaf, 2);
  const bool isLocal = namesLocalCostmap(textOf(leaf, 1));
  Waypoints waypoints = robot.waypoints().get(pathOf(leaf, 6));
  Path free;
  free.reserve(goals.size());
  for (const Pose2& goal : goals) {
    const auto cost = robot.costAt(isLocal, goal, occupancy.usesFootprint);
    if (!cost) {
      setNumber(leaf, 5, from);
      return NodeStatus::Failure;
    }
    if (occupancy.isFree(*cost)) {
      free.push_back(goal);
    } else {
      mark(waypoints, goal, Waypoint::Status::Skipped);
    }
  }
  if (free.size() == goals.size()) {
    setNumber(leaf, 5, from);
    return NodeStatus::Success;
  }
  putStatuses(leaf, 7, std::move(waypoints));
  return setPathOutput(leaf, 5, std::move(free));
}

/// Ports 0: goals, 1: radius [m], 2: result, 5: waypoint statuses, 6: the same (out). The last goal
/// is always kept.
NodeStatus removePassedGoals(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const PathId from = pathOf(leaf, 0);
  const Path& goals = robot.paths().get(from);
  const double radius = leaf.require<double>(1);
  const base::Vec2 place = robot.pose().position;
  Waypoints waypoints = robot.waypoints().get(pathOf(leaf, 5));
  std::size_t passed = 0;
  while (passed + 1 < goals.size() && (goals[passed].position - place).norm() <= radius) {
    mark(waypoints, goals[passed], Waypoint::Status::Completed);
    ++passed;
  }
  if (passed == 0) {
    setNumber(leaf, 2, from);
    return NodeStatus::Success;
  }
  putStatuses(leaf, 6, std::move(waypoints));
  return setPathOutput(leaf, 2,
                       Path(goals.begin() + static_cast<std::ptrdiff_t>(passed), goals.end()));
}

constexpr const char* kNodes = R"(
global_frame text default map|No effect: poses are stored in the map frame.
robot_base_frame text default base_link|No effect: the pose is that of the robot's centre.
server_timeout int default 20|No effect: the service responds immediately.
Action GetPoseFromPath|Navigation|Gets a pose of a path (since Jazzy).
path any needed suggest {path}|Path.
index int default 0|Index of the pose, from 0; below 0: counted from the end, -1: the last one.
pose any output suggest {pose}|Pose.
Action GetCurrentPose|Navigation|Gets the robot's pose (since Jazzy).
global_frame robot_base_frame
current_pose any output suggest {current_pose}|Pose.
Action ConcatenatePaths|Navigation|Concatenates two paths (since Jazzy).
input_path1 any needed suggest {path1}|First path.
input_path2 any needed suggest {path2}|Second path.
output_path any output suggest {path}|Concatenated path.
Action AppendGoalPoseToGoals|Navigation|Appends a goal to a list of goals (since Kilted).
input_goals any needed suggest {goals}|Goals.
goal_pose any needed suggest {goal}|Goal.
output_goals any output suggest {goals}|Goals including the new one.
Action GetNextFewGoals|Navigation|Gets the first goals (since Kilted).
input_goals
num_goals int needed suggest 1|Number of goals; all if there are fewer.
output_goals
Action CheckPoseOccupancy|Navigation|Succeeds if a pose is free in the global costmap (since Lyrical).
pose any needed suggest {goal}|Pose.
service_name text default global_costmap/get_cost_global_costmap|Service that determines the costmap.
cost_threshold number default 254.0|Minimum cost of an occupied pose.
use_footprint bool default true|Checks the footprint of the robot, else the cell at the pose.
consider_unknown_as_obstacle bool default false|Unknown cells are occupied.
server_timeout
Action RemoveInCollisionGoals|Navigation|Removes goals that are occupied in the global costmap (since Kilted).
input_goals
service_name cost_threshold use_footprint consider_unknown_as_obstacle
output_goals
input_waypoint_statuses any suggest {waypoint_statuses}|Status of each pose.
output_waypoint_statuses any output suggest {waypoint_statuses}|Status of each pose, including the removed goals.
server_timeout
Action RemovePassedGoals|Navigation|Removes goals that the robot has passed.
input_goals
radius number default 0.5 unit m|Distance within which a goal is passed.
output_goals
global_frame robot_base_frame input_waypoint_statuses output_waypoint_statuses
)";

}  // namespace

void addRobotPoses(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"GetPoseFromPath", synchronous<OutputMemory>(poseFromPath)},
          {"GetCurrentPose", synchronous<OutputMemory>(currentPose)},
          {"ConcatenatePaths", synchronous<OutputMemory>(concatenatePaths)},
          {"AppendGoalPoseToGoals", synchronous<OutputMemory>(appendGoal)},
          {"GetNextFewGoals", synchronous<OutputMemory>(nextFewGoals)},
          {"CheckPoseOccupancy", synchronous<OutputMemory>(checkPose)},
          {"RemoveInCollisionGoals", synchronous<OutputMemory>(removeColliding)},
          {"RemovePassedGoals", synchronous<OutputMemory>(removePassedGoals)}});
}

}  // namespace bt
