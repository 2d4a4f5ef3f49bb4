#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that take poses from paths, goals and the robot, and put goals together
/// (nav2_behavior_tree/plugins/action).
namespace bt {
namespace {

using base::NodeStatus;
using base::Pose2;
using sim2d::nav2::Path;

struct OutputMemory {
  PathId last;  // that the node wrote
};

/// An output that does not change keeps its number: who follows it has nothing new.
NodeStatus put(LeafContext& leaf, int port, Path path) {
  PathId& last = leaf.memory<OutputMemory>().last;
  last = robotOf(leaf).paths().addUnlessEqual(std::move(path), last);
  leaf.set<int>(port, static_cast<int>(last));
  return NodeStatus::Success;
}

/// Ports 0: path, 1: index, from the end below 0, 2: pose (out).
NodeStatus poseFromPath(LeafContext& leaf) {
  const Path& path = robotOf(leaf).paths().get(pathOf(leaf, 0));
  const auto count = static_cast<std::int64_t>(path.size());
  std::int64_t index = leaf.require<int>(1);
  index += index < 0 ? count : 0;
  if (index < 0 || index >= count) {
    return NodeStatus::Failure;
  }
  return put(leaf, 2, {path[static_cast<std::size_t>(index)]});
}

/// Port 2: pose (out).
NodeStatus currentPose(LeafContext& leaf) {
  return put(leaf, 2, {robotOf(leaf).pose()});
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
  return put(leaf, 2, joined(first, second));
}

/// Ports 0: goals, 1: goal, 2: goals with it at their end (out).
NodeStatus appendGoal(LeafContext& leaf) {
  const PathStore& paths = robotOf(leaf).paths();
  const Path& goal = paths.get(pathOf(leaf, 1));
  if (goal.empty()) {
    return NodeStatus::Failure;
  }
  return put(leaf, 2, joined(paths.get(pathOf(leaf, 0)), {goal.front()}));
}

/// Ports 0: goals, 1: how many of them, 2: the first ones (out).
NodeStatus nextFewGoals(LeafContext& leaf) {
  const Path& goals = robotOf(leaf).paths().get(pathOf(leaf, 0));
  const int wanted = leaf.require<int>(1);
  if (goals.empty() || wanted < 0) {
    return NodeStatus::Failure;
  }
  const auto count = std::min<std::ptrdiff_t>(wanted, static_cast<std::ptrdiff_t>(goals.size()));
  return put(leaf, 2, Path(goals.begin(), goals.begin() + count));
}

// Occupancy. Nav2 asks the service get_cost, whose name tells the costmap.

bool asksLocal(const LeafContext& leaf, int port) {
  return leaf.text(port).value_or("").find("local") != std::string::npos;
}

struct Occupancy {
  double threshold = 254.0;
  bool usesFootprint = true, unknownBlocks = false;
  bool isFree(std::uint8_t cost) const {
    const bool isUnknown = cost == sim2d::nav2::kNoInformation;
    return (isUnknown && !unknownBlocks) || cost < threshold;
  }
};

/// Ports `first` on: threshold, use of the footprint, whether unknown counts as an obstacle.
Occupancy occupancyOf(LeafContext& leaf, int first) {
  Occupancy occupancy;
  occupancy.threshold = leaf.getOr<double>(first, 254.0);
  occupancy.usesFootprint = leaf.getOr<bool>(first + 1, true);
  occupancy.unknownBlocks = leaf.getOr<bool>(first + 2, false);
  return occupancy;
}

/// Ports 0: pose, 1: service, 2 to 4: as above. SUCCESS: nothing is there.
NodeStatus checkPose(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const Path& pose = robot.paths().get(pathOf(leaf, 0));
  const Occupancy occupancy = occupancyOf(leaf, 2);
  if (pose.empty()) {
    return NodeStatus::Failure;
  }
  const auto cost = robot.costAt(asksLocal(leaf, 1), pose.front(), occupancy.usesFootprint);
  return cost && occupancy.isFree(*cost) ? NodeStatus::Success : NodeStatus::Failure;
}

bool isSamePose(const Pose2& a, const Pose2& b) {
  return a.position == b.position && a.heading == b.heading;
}

/// The first one that is pending at that pose gets the status.
void mark(Waypoints& waypoints, const Pose2& pose, Waypoint::Status status) {
  const auto found = std::find_if(waypoints.begin(), waypoints.end(), [&](const Waypoint& each) {
    return each.status == Waypoint::Status::Pending && isSamePose(each.pose, pose);
  });
  if (found != waypoints.end()) {
    found->status = status;
  }
}

void putStatuses(LeafContext& leaf, int port, Waypoints waypoints) {
  if (!waypoints.empty()) {
    leaf.set<int>(port, static_cast<int>(robotOf(leaf).waypoints().add(std::move(waypoints))));
  }
}

/// Ports 0: goals, 1: service, 2 to 4: as above, 5: goals that are free (out), 6: statuses of the
/// waypoints, 7: the same (out). A pose off the map is a failure, and all goals stay.
NodeStatus removeColliding(LeafContext& leaf) {
  const NavigatorHost& robot = robotOf(leaf);
  const PathId from = pathOf(leaf, 0);
  const Path& goals = robot.paths().get(from);
  const Occupancy occupancy = occupancyOf(leaf, 2);
  const bool isLocal = asksLocal(leaf, 1);
  Waypoints waypoints = robot.waypoints().get(pathOf(leaf, 6));
  Path free;
  free.reserve(goals.size());
  for (const Pose2& goal : goals) {
    const auto cost = robot.costAt(isLocal, goal, occupancy.usesFootprint);
    if (!cost) {
      leaf.set<int>(5, static_cast<int>(from));
      return NodeStatus::Failure;
    }
    if (occupancy.isFree(*cost)) {
      free.push_back(goal);
    } else {
      mark(waypoints, goal, Waypoint::Status::Skipped);
    }
  }
  if (free.size() == goals.size()) {
    leaf.set<int>(5, static_cast<int>(from));
    return NodeStatus::Success;
  }
  putStatuses(leaf, 7, std::move(waypoints));
  return put(leaf, 5, std::move(free));
}

/// Ports 0: goals, 1: radius [m], 2: result, 5: statuses of the waypoints, 6: the same (out). The
/// last goal always stays.
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
    leaf.set<int>(2, static_cast<int>(from));
    return NodeStatus::Success;
  }
  putStatuses(leaf, 6, std::move(waypoints));
  return put(leaf, 2, Path(goals.begin() + static_cast<std::ptrdiff_t>(passed), goals.end()));
}

constexpr const char* kNodes = R"(
global_frame text default map|Accepted; poses are those of the map.
robot_base_frame text default base_link|Accepted; the pose is that of the robot's centre.
server_timeout int default 20|Accepted; the answer is immediate here.
Action GetPoseFromPath|Navigation|Takes one pose of a path (since Jazzy).
path any needed suggest {path}|The path.
index int default 0|Number of the pose from 0; below 0 from the end, -1 is the last one.
pose any output suggest {pose}|The pose.
Action GetCurrentPose|Navigation|Takes the robot's pose (since Jazzy).
global_frame robot_base_frame
current_pose any output suggest {current_pose}|The pose.
Action ConcatenatePaths|Navigation|Puts one path behind another (since Jazzy).
input_path1 any needed suggest {path1}|The first path.
input_path2 any needed suggest {path2}|The path behind it.
output_path any output suggest {path}|Both.
Action AppendGoalPoseToGoals|Navigation|Puts a goal behind others (since Kilted).
input_goals any needed suggest {goals}|The goals.
goal_pose any needed suggest {goal}|The goal.
output_goals any output suggest {goals}|All of them.
Action GetNextFewGoals|Navigation|Takes the first few goals (since Kilted).
input_goals
num_goals int needed suggest 1|How many; all of them when there are fewer.
output_goals
Action CheckPoseOccupancy|Navigation|SUCCESS when a pose is free in the global costmap (since Lyrical).
pose any needed suggest {goal}|The pose.
service_name text default global_costmap/get_cost_global_costmap|Which costmap.
cost_threshold number default 254.0|Cost from which the pose is occupied.
use_footprint bool default true|The whole outline of the robot counts, else the cell at the pose.
consider_unknown_as_obstacle bool default false|Unknown cells are occupied.
server_timeout
Action RemoveInCollisionGoals|Navigation|Takes away goals that are occupied in the global costmap (since Kilted).
input_goals
service_name cost_threshold use_footprint consider_unknown_as_obstacle
output_goals
input_waypoint_statuses any suggest {waypoint_statuses}|What has become of each pose so far.
output_waypoint_statuses any output suggest {waypoint_statuses}|The same, with the goals that were taken away.
server_timeout
Action RemovePassedGoals|Navigation|Takes goals away that the robot has passed.
input_goals
radius number default 0.5 unit m|Passed within this.
output_goals
global_frame robot_base_frame input_waypoint_statuses output_waypoint_statuses
)";

}  // namespace

void addRobotPoses(NodeLibrary& to);
void addRobotPoses(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  const auto add = [&](const char* id, LeafFunction tick) {
    to.addAction<OutputMemory>(*nodes.find(id), tick);
  };
  add("GetPoseFromPath", poseFromPath);
  add("GetCurrentPose", currentPose);
  add("ConcatenatePaths", concatenatePaths);
  add("AppendGoalPoseToGoals", appendGoal);
  add("GetNextFewGoals", nextFewGoals);
  add("CheckPoseOccupancy", checkPose);
  add("RemoveInCollisionGoals", removeColliding);
  add("RemovePassedGoals", removePassedGoals);
}

}  // namespace bt
