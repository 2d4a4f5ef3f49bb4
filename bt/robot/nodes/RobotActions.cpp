#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "bt/robot/RobotNodes.h"

/// Long-running actions of Nav2 that use a server (nav2_behavior_tree/plugins/action), and the
/// services that clear costmaps.
namespace bt {
namespace {

using base::NodeStatus;
using sim2d::nav2::Distro;
using State = RobotOutcome::State;

// ComputePathToPose and ComputePathThroughPoses. Ports 0: goal or goals, 1: start, 2: planner, 3:
// use_start or, for several goals, index of the last one reached (out), 4: path (out), 5: error
// code (out), 8: error text (out), 9: intermediate poses for one goal.

template <RobotAction action>
RobotRequest planRequest(LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  const PathId start = pathOf(leaf, 1);
  bool usesStart = start != 0;
  if constexpr (action == RobotAction::ComputePath) {
    usesStart = leaf.getOr<bool>(3, usesStart) && usesStart;
    request.viaPoints = pathOf(leaf, 9);
  }
  if (usesStart) {
    request.start = start;
  }
  request.server = textOf(leaf, 2);
  return request;
}

/// A failed plan writes an empty path, so that later nodes do not continue with the previous one.
template <RobotAction action>
void setPlan(LeafContext& leaf, const RobotOutcome& outcome) {
  setNumber(leaf, 4, outcome.state == State::Succeeded ? outcome.path : 0);
  setError<5, 8>(leaf, outcome);
  if constexpr (action == RobotAction::ComputePathThroughPoses) {
    leaf.set<int>(3, outcome.lastReached);
  }
}

// FollowPath. Ports 0: path, 1: controller, 2: goal checker, 3: progress checker, 4: path handler,
// 5: error code (out), 8: error text (out), 9: tracking feedback (out).

/// The last request, for detecting changes.
struct FollowMemory {
  PathId path;
  std::uint64_t names;  // hash of the chosen servers' names
};

std::uint64_t hashOf(const RobotRequest& request) {
  std::uint64_t hash = 1469598103934665603U;  // FNV-1a
  for (const std::string* text :
       {&request.server, &request.goalChecker, &request.progressChecker, &request.pathHandler}) {
    for (const char c : *text + '\n') {
      hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    }
  }
  return hash;
}

RobotRequest followRequest(const LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  request.server = textOf(leaf, 1);
  request.goalChecker = textOf(leaf, 2);
  request.progressChecker = textOf(leaf, 3);
  request.pathHandler = textOf(leaf, 4);
  return request;
}

NodeStatus beginFollow(LeafContext& leaf) {
  const RobotRequest request = followRequest(leaf);
  leaf.memory<FollowMemory>() = {request.path, hashOf(request)};
  robotOf(leaf).begin(RobotAction::FollowPath, request);
  return NodeStatus::Running;
}

/// A different, non-empty path or another controller while running is a new request.
NodeStatus awaitFollow(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  const RobotOutcome outcome = robot.outcome(RobotAction::FollowPath);
  if (const int number = robot.tracking().number; number > 0) {
    leaf.set<int>(9, number);
  }
  if (outcome.state != State::Running) {
    setError<5, 8>(leaf, outcome);
    return statusOf(outcome);
  }
  auto& memory = leaf.memory<FollowMemory>();
  RobotRequest request = followRequest(leaf);
  const bool hasNewPath = request.path != memory.path && !robot.paths().get(request.path).empty();
  const std::uint64_t names = hashOf(request);
  if (hasNewPath || names != memory.names) {
    request.path = hasNewPath ? request.path : memory.path;
    memory = {request.path, names};
    robot.begin(RobotAction::FollowPath, request);
  }
  return NodeStatus::Running;
}

// SmoothPath. Ports 0: path, 1: smoother, 2: time limit [s], 3: checks collisions; out 4: path, 5:
// time [s], 6: completed, 7: error code, 10: error text.

RobotRequest smoothRequest(LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  request.server = textOf(leaf, 1);
  request.timeAllowance = leaf.getOr<double>(2, 3.0);
  request.checksCollisions = leaf.getOr<bool>(3, false);
  return request;
}

void setSmoothed(LeafContext& leaf, const RobotOutcome& outcome) {
  if (outcome.state == State::Succeeded) {
    setNumber(leaf, 4, outcome.path);
    leaf.set<double>(5, outcome.duration);
    leaf.set<bool>(6, outcome.wasCompleted);
  }
  setError<7, 10>(leaf, outcome);
}

// Behaviours. Ports 0: amount, then specific ports; out: error code and, three ports later, its
// text. The last port (since Kilted) disables collision checks.

constexpr int kUncheckedPort = 7;

template <RobotAction action>
RobotRequest behaviorRequest(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  RobotRequest request;
  request.amount = leaf.require<double>(0);
  if constexpr (action == RobotAction::Spin) {
    request.timeAllowance = leaf.require<double>(1);
    if (leaf.getOr<bool>(2, true)) {
      robot.countRecovery();
    }
  } else if constexpr (action == RobotAction::BackUp) {  // both accept either sign
    request.amount = std::fabs(request.amount);
    request.speed = std::fabs(leaf.require<double>(1));
    request.timeAllowance = leaf.require<double>(2);
    robot.countRecovery();
  } else if constexpr (action == RobotAction::DriveOnHeading) {
    request.speed = leaf.require<double>(1);
    request.timeAllowance = leaf.require<double>(2);
  } else {
    if (robot.distro() == Distro::Humble) {  // Humble uses whole seconds
      request.amount = std::trunc(request.amount);
    }
    robot.countRecovery();
  }
  if constexpr (action != RobotAction::Wait) {
    request.ignoresCollisions =
        robot.distro() >= Distro::Kilted && leaf.getOr<bool>(kUncheckedPort, false);
  }
  return request;
}

template <RobotAction action, int errorPort>
NodeFunctions behaviorNode() {
  return actionNode<action, behaviorRequest<action>, setError<errorPort, errorPort + 3>>();
}

// Clearing costmaps

/// Ports 0: service, 1: plugins, then distance [m], pose. The service name selects the costmap.
template <ClearRequest::Extent extent>
NodeStatus clearCostmap(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  ClearRequest request;
  request.extent = extent;
  request.isLocal = namesLocalCostmap(textOf(leaf, 0));
  request.plugins = textOf(leaf, 1);
  if (extent != ClearRequest::Extent::Entire) {
    request.distance = leaf.require<double>(2);
  }
  if (extent == ClearRequest::Extent::AroundPose) {
    const sim2d::nav2::Path& pose = robot.paths().get(pathOf(leaf, 3));
    if (pose.empty()) {
      return NodeStatus::Failure;
    }
    request.pose = pose.front();
  }
  robot.countRecovery();
  return successIf(robot.clear(request));
}

constexpr const char* kNodes = R"(
server_name text|No effect: this program has no servers with names.
server_timeout int default 20|No effect: servers respond immediately.
error_code_id int output suggest {error_code}|Error code; 0: no error.
error_msg text output suggest {error_msg}|Error message (since Kilted).
Action ComputePathToPose|Navigation|Plans a path to the goal.
goal any needed suggest {goal}|Goal pose.
start any|Start pose; absent: the robot's pose.
planner_id text default|Name of the planner; not needed if there is only one.
use_start bool|Whether start is used.
path any output suggest {path}|Path; empty after a failure.
error_code_id server_name server_timeout error_msg
viapoints any|Poses through which the path leads to the goal (since Lyrical).
Action ComputePathThroughPoses|Navigation|Plans a path through several goals.
goals any needed suggest {goals}|Goal poses, in order.
start planner_id
last_reached_index int output|Index of the last goal that the path reaches, from 0 (since Lyrical).
path error_code_id server_name server_timeout error_msg
Action FollowPath|Navigation|Drives along the path to its end.
path any needed suggest {path}|Path; can be replaced by a new one while the robot drives.
controller_id text default|Name of the controller; not needed if there is only one.
goal_checker_id text default|Name of the goal checker.
progress_checker_id text default|Name of the progress checker.
path_handler_id text default|Name of the path handler (since Lyrical).
error_code_id server_name server_timeout error_msg
tracking_feedback any output suggest {tracking_feedback}|Deviation of the robot from the path, for IsWithinPathTrackingBounds (since Lyrical).
Action SmoothPath|Navigation|Smooths a path.
unsmoothed_path any needed suggest {path}|Path.
smoother_id text default|Name of the smoother; not needed if there is only one.
max_smoothing_duration number default 3.0 unit s|Maximum duration.
check_for_collisions bool default false|Fails if the result collides with an obstacle.
smoothed_path any output suggest {path}|Smoothed path.
smoothing_duration number output|Always 0: smoothing takes no simulated time.
was_completed bool output|Whether the whole path was smoothed.
error_code_id server_name server_timeout error_msg
Action Spin|Navigation|Rotates in place.
spin_dist number default 1.57 unit rad|Angle, to the left.
time_allowance number default 10.0 unit s|Maximum duration.
is_recovery bool default true|Is counted as a recovery.
error_code_id server_name server_timeout error_msg
disable_collision_checks bool default false|Disables collision checks (since Kilted).
Action BackUp|Navigation|Drives backwards.
backup_dist number default 0.15 unit m|Distance.
backup_speed number default 0.025 unit m/s|Speed.
time_allowance error_code_id server_name server_timeout error_msg disable_collision_checks
Action DriveOnHeading|Navigation|Drives straight.
dist_to_travel number default 0.15 unit m|Distance.
speed number default 0.025 unit m/s|Speed.
time_allowance error_code_id server_name server_timeout error_msg disable_collision_checks
Action Wait|Navigation|Stands still.
wait_duration number default 1.0 unit s|Duration; whole seconds in Humble.
error_code_id server_name server_timeout error_msg
Action ClearEntireCostmap|Navigation|Clears a costmap.
service_name text needed suggest local_costmap/clear_entirely_local_costmap|Service that determines the costmap.
plugins text default|Layers; empty: all (since Lyrical).
server_timeout
Action ClearCostmapAroundRobot|Navigation|Clears a costmap within a square around the robot.
service_name plugins
reset_distance number default 1.0 unit m|Side length of the square.
server_timeout
Action ClearCostmapExceptRegion|Navigation|Clears a costmap outside a square around the robot.
service_name plugins reset_distance server_timeout
Action ClearCostmapAroundPose|Navigation|Clears a costmap within a square around a pose.
service_name plugins reset_distance
pose any needed suggest {goal}|Pose.
server_timeout
Action CancelControl|Navigation|Cancels FollowPath.
server_name server_timeout
Action CancelSpin|Navigation|Cancels Spin.
server_name server_timeout
Action CancelBackUp|Navigation|Cancels BackUp.
server_name server_timeout
Action CancelDriveOnHeading|Navigation|Cancels DriveOnHeading.
server_name server_timeout
Action CancelWait|Navigation|Cancels Wait.
server_name server_timeout
)";

}  // namespace

void addRobotActions(NodeLibrary& to) {
  using Action = RobotAction;
  using Extent = ClearRequest::Extent;
  constexpr Action kPlan = Action::ComputePath, kThrough = Action::ComputePathThroughPoses;
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"ComputePathToPose", actionNode<kPlan, planRequest<kPlan>, setPlan<kPlan>>()},
          {"ComputePathThroughPoses",
           actionNode<kThrough, planRequest<kThrough>, setPlan<kThrough>>()},
          {"FollowPath",
           stateful<FollowMemory>({beginFollow, awaitFollow, cancelAction<Action::FollowPath>})},
          {"SmoothPath", actionNode<Action::SmoothPath, smoothRequest, setSmoothed>()},
          {"Spin", behaviorNode<Action::Spin, 3>()},
          {"BackUp", behaviorNode<Action::BackUp, 3>()},
          {"DriveOnHeading", behaviorNode<Action::DriveOnHeading, 3>()},
          {"Wait", behaviorNode<Action::Wait, 1>()},
          {"ClearEntireCostmap", synchronous(clearCostmap<Extent::Entire>)},
          {"ClearCostmapAroundRobot", synchronous(clearCostmap<Extent::Around>)},
          {"ClearCostmapExceptRegion", synchronous(clearCostmap<Extent::Except>)},
          {"ClearCostmapAroundPose", synchronous(clearCostmap<Extent::AroundPose>)},
          {"CancelControl", cancelNode<Action::FollowPath>()},
          {"CancelSpin", cancelNode<Action::Spin>()},
          {"CancelBackUp", cancelNode<Action::BackUp>()},
          {"CancelDriveOnHeading", cancelNode<Action::DriveOnHeading>()},
          {"CancelWait", cancelNode<Action::Wait>()}});
}

}  // namespace bt
