#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that ask a server and last (nav2_behavior_tree/plugins/action), and the services
/// that clear costmaps.
namespace bt {
namespace {

using base::NodeStatus;
using sim2d::nav2::Distro;
using State = RobotOutcome::State;

std::string textOf(const LeafContext& leaf, int port) {
  return leaf.text(port).value_or("");
}

void setPath(LeafContext& leaf, int port, PathId path) {
  leaf.set<int>(port, static_cast<int>(path));
}

/// What was asked for last, as far as FollowPath must know when it changes.
struct ActionMemory {
  PathId path;
  std::uint64_t names;  // of the servers that were chosen, as a hash
};

/// A server is asked when the node begins; the node is done when it is. Cancelled is a success.
NodeStatus statusOf(const RobotOutcome& outcome) {
  if (outcome.state == State::Running) {
    return NodeStatus::Running;
  }
  return outcome.state == State::Failed ? NodeStatus::Failure : NodeStatus::Success;
}

template <RobotAction action>
void cancelAction(LeafContext& leaf) {
  robotOf(leaf).cancel(action);
}

// ComputePathToPose and ComputePathThroughPoses. Ports 0: goal or goals, 1: start, 2: planner,
// 3: use_start, or of several goals the last one that was reached (out), 4: path (out), 5: error
// code (out), 8: error text (out), 9: poses on the way to one goal.

template <RobotAction action>
NodeStatus beginPlan(LeafContext& leaf) {
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
  robotOf(leaf).begin(action, request);
  return NodeStatus::Running;
}

/// What of a result every node writes: its code and the reason in words.
void setError(LeafContext& leaf, const RobotOutcome& outcome, int codePort, int textPort) {
  leaf.set<int>(codePort, outcome.errorCode);
  leaf.set<std::string_view>(textPort, outcome.errorText);
}

/// A path that failed is an empty one: what follows it must not go on with the last.
template <RobotAction action>
NodeStatus awaitPlan(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(action);
  if (outcome.state == State::Running) {
    return NodeStatus::Running;
  }
  setPath(leaf, 4, outcome.state == State::Succeeded ? outcome.path : 0);
  setError(leaf, outcome, 5, 8);
  if constexpr (action == RobotAction::ComputePathThroughPoses) {
    leaf.set<int>(3, outcome.lastReached);
  }
  return statusOf(outcome);
}

// FollowPath. Ports 0: path, 1: controller, 2: goal checker, 3: progress checker, 4: path handler,
// 5: error code (out), 8: error text (out), 9: tracking feedback (out).

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
  leaf.memory<ActionMemory>() = {request.path, hashOf(request)};
  robotOf(leaf).begin(RobotAction::FollowPath, request);
  return NodeStatus::Running;
}

/// While it runs another path, which is not empty, or another controller is a new request.
NodeStatus awaitFollow(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  const RobotOutcome outcome = robot.outcome(RobotAction::FollowPath);
  if (const int number = robot.tracking().number; number > 0) {
    leaf.set<int>(9, number);
  }
  if (outcome.state != State::Running) {
    setError(leaf, outcome, 5, 8);
    return statusOf(outcome);
  }
  auto& memory = leaf.memory<ActionMemory>();
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

// SmoothPath. Ports 0: path, 1: smoother, 2: longest time [s], 3: checks collisions; out 4: path,
// 5: time [s], 6: completed, 7: error code, 10: error text.

NodeStatus beginSmooth(LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  request.server = textOf(leaf, 1);
  request.timeAllowance = leaf.getOr<double>(2, 3.0);
  request.checksCollisions = leaf.getOr<bool>(3, false);
  robotOf(leaf).begin(RobotAction::SmoothPath, request);
  return NodeStatus::Running;
}

NodeStatus awaitSmooth(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(RobotAction::SmoothPath);
  if (outcome.state == State::Running) {
    return NodeStatus::Running;
  }
  if (outcome.state == State::Succeeded) {
    setPath(leaf, 4, outcome.path);
    leaf.set<double>(5, outcome.duration);
    leaf.set<bool>(6, outcome.wasCompleted);
  }
  setError(leaf, outcome, 7, 10);
  return statusOf(outcome);
}

// Behaviours. Ports 0: amount, then what each has; out: error code and, three further, its text.
// The last one, since Kilted: no look at the costmap.

constexpr int kUncheckedPort = 7;

template <RobotAction action>
NodeStatus beginBehavior(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  RobotRequest request;
  request.amount = leaf.require<double>(0);
  if constexpr (action == RobotAction::Spin) {
    request.timeAllowance = leaf.require<double>(1);
    if (leaf.getOr<bool>(2, true)) {
      robot.countRecovery();
    }
  } else if constexpr (action == RobotAction::BackUp) {  // both may have either sign
    request.amount = std::fabs(request.amount);
    request.speed = std::fabs(leaf.require<double>(1));
    request.timeAllowance = leaf.require<double>(2);
    robot.countRecovery();
  } else if constexpr (action == RobotAction::DriveOnHeading) {
    request.speed = leaf.require<double>(1);
    request.timeAllowance = leaf.require<double>(2);
  } else {
    if (robot.distro() == Distro::Humble) {  // whole seconds there
      request.amount = std::trunc(request.amount);
    }
    robot.countRecovery();
  }
  if constexpr (action != RobotAction::Wait) {
    request.ignoresCollisions =
        robot.distro() >= Distro::Kilted && leaf.getOr<bool>(kUncheckedPort, false);
  }
  robot.begin(action, request);
  return NodeStatus::Running;
}

constexpr int errorPort(RobotAction action) {
  return action == RobotAction::Wait ? 1 : 3;
}

template <RobotAction action>
NodeStatus awaitBehavior(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(action);
  if (outcome.state != State::Running) {
    setError(leaf, outcome, errorPort(action), errorPort(action) + 3);
  }
  return statusOf(outcome);
}

// Cancelling, and clearing of costmaps.

template <RobotAction action>
NodeStatus cancelNow(LeafContext& leaf) {
  robotOf(leaf).cancel(action);
  return NodeStatus::Success;
}

/// Ports 0: service, 1: plugins, then distance [m], pose. The name of the service says which map.
template <ClearRequest::Extent extent>
NodeStatus clearCostmap(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  const std::string service = textOf(leaf, 0);
  ClearRequest request;
  request.extent = extent;
  request.isLocal = service.find("local") != std::string::npos;
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
  return robot.clear(request) ? NodeStatus::Success : NodeStatus::Failure;
}

constexpr const char* kNodes = R"(
server_name text|No servers by name here.
server_timeout int default 20|No servers to wait for here.
error_code_id int output suggest {error_code}|Why it failed, 0: it did not.
error_msg text output suggest {error_msg}|Why it failed, in words (since Kilted).
Action ComputePathToPose|Navigation|Plans a path to the goal.
goal any needed suggest {goal}|Where to.
start any|Where from; the robot's place when it is absent.
planner_id text default|Which planner; one alone needs no name.
use_start bool|Whether start counts.
path any output suggest {path}|The path; empty when it failed.
error_code_id server_name server_timeout error_msg
viapoints any|Poses that the path leads through on its way to the goal (since Lyrical).
Action ComputePathThroughPoses|Navigation|Plans a path through several goals.
goals any needed suggest {goals}|Where to, in order.
start planner_id
last_reached_index int output|Number of the last goal that the path leads to, from 0 (since Lyrical).
path error_code_id server_name server_timeout error_msg
Action FollowPath|Navigation|Drives along the path to its end.
path any needed suggest {path}|The path; another one takes its place while it drives.
controller_id text default|Which controller; one alone needs no name.
goal_checker_id text default|Which goal checker.
progress_checker_id text default|Which progress checker.
path_handler_id text default|Which path handler (since Lyrical).
error_code_id server_name server_timeout error_msg
tracking_feedback any output suggest {tracking_feedback}|How far the robot is off the path, for IsWithinPathTrackingBounds (since Lyrical).
Action SmoothPath|Navigation|Smooths a path.
unsmoothed_path any needed suggest {path}|The path.
smoother_id text default|Which smoother; one alone needs no name.
max_smoothing_duration number default 3.0 unit s|Longest time.
check_for_collisions bool default false|Fails when the result hits something.
smoothed_path any output suggest {path}|The result.
smoothing_duration number output|How long it took.
was_completed bool output|All of it was smoothed.
error_code_id server_name server_timeout error_msg
Action Spin|Navigation|Turns on the spot.
spin_dist number default 1.57 unit rad|How far, to the left.
time_allowance number default 10.0 unit s|Longest time.
is_recovery bool default true|Counts as a recovery.
error_code_id server_name server_timeout error_msg
disable_collision_checks bool default false|Does not look for collisions (since Kilted).
Action BackUp|Navigation|Drives back.
backup_dist number default 0.15 unit m|How far.
backup_speed number default 0.025 unit m/s|How fast.
time_allowance error_code_id server_name server_timeout error_msg disable_collision_checks
Action DriveOnHeading|Navigation|Drives straight.
dist_to_travel number default 0.15 unit m|How far.
speed number default 0.025 unit m/s|How fast.
time_allowance error_code_id server_name server_timeout error_msg disable_collision_checks
Action Wait|Navigation|Stands still.
wait_duration number default 1.0 unit s|How long; whole seconds in Humble.
error_code_id server_name server_timeout error_msg
Action ClearEntireCostmap|Navigation|Forgets a costmap at once.
service_name text needed suggest local_costmap/clear_entirely_local_costmap|Says which one.
plugins text default|Layers, all when it is empty (since Lyrical).
server_timeout
Action ClearCostmapAroundRobot|Navigation|Forgets what lies within a square round the robot.
service_name plugins
reset_distance number default 1.0 unit m|Side of the square.
server_timeout
Action ClearCostmapExceptRegion|Navigation|Forgets what lies outside of a square round the robot.
service_name plugins reset_distance server_timeout
Action ClearCostmapAroundPose|Navigation|Forgets what lies within a square round a pose.
service_name plugins reset_distance
pose any needed suggest {goal}|The pose.
server_timeout
Action CancelControl|Navigation|Ends FollowPath.
server_name server_timeout
Action CancelSpin|Navigation|Ends Spin.
server_name server_timeout
Action CancelBackUp|Navigation|Ends BackUp.
server_name server_timeout
Action CancelDriveOnHeading|Navigation|Ends DriveOnHeading.
server_name server_timeout
Action CancelWait|Navigation|Ends Wait.
server_name server_timeout
)";

template <RobotAction action, class Node>
void addBehavior(NodeLibrary& to, const Node& manifest) {
  to.addStateful(manifest, {beginBehavior<action>, awaitBehavior<action>, cancelAction<action>});
}

void addLasting(NodeLibrary& to, const NodeCatalogue& nodes) {
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  constexpr RobotAction kPlan = RobotAction::ComputePath;
  constexpr RobotAction kThrough = RobotAction::ComputePathThroughPoses;
  to.addStateful(manifest("ComputePathToPose"),
                 {beginPlan<kPlan>, awaitPlan<kPlan>, cancelAction<kPlan>});
  to.addStateful(manifest("ComputePathThroughPoses"),
                 {beginPlan<kThrough>, awaitPlan<kThrough>, cancelAction<kThrough>});
  to.addStateful<ActionMemory>(manifest("FollowPath"),
                               {beginFollow, awaitFollow, cancelAction<RobotAction::FollowPath>});
  to.addStateful(manifest("SmoothPath"),
                 {beginSmooth, awaitSmooth, cancelAction<RobotAction::SmoothPath>});
  addBehavior<RobotAction::Spin>(to, manifest("Spin"));
  addBehavior<RobotAction::BackUp>(to, manifest("BackUp"));
  addBehavior<RobotAction::DriveOnHeading>(to, manifest("DriveOnHeading"));
  addBehavior<RobotAction::Wait>(to, manifest("Wait"));
}

}  // namespace

void addRobotActions(NodeLibrary& to);
void addRobotActions(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  using Extent = ClearRequest::Extent;
  addLasting(to, nodes);
  to.addAction(manifest("ClearEntireCostmap"), clearCostmap<Extent::Entire>);
  to.addAction(manifest("ClearCostmapAroundRobot"), clearCostmap<Extent::Around>);
  to.addAction(manifest("ClearCostmapExceptRegion"), clearCostmap<Extent::Except>);
  to.addAction(manifest("ClearCostmapAroundPose"), clearCostmap<Extent::AroundPose>);
  to.addAction(manifest("CancelControl"), cancelNow<RobotAction::FollowPath>);
  to.addAction(manifest("CancelSpin"), cancelNow<RobotAction::Spin>);
  to.addAction(manifest("CancelBackUp"), cancelNow<RobotAction::BackUp>);
  to.addAction(manifest("CancelDriveOnHeading"), cancelNow<RobotAction::DriveOnHeading>);
  to.addAction(manifest("CancelWait"), cancelNow<RobotAction::Wait>);
}

}  // namespace bt
