#include <cmath>
#include <string>
#include <utility>

#include "bt/robot/RobotNodes.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// Nodes of Nav2 that check paths against the costmap, the robot's motion and its tracking error
/// (nav2_behavior_tree/plugins/action and /condition).
namespace bt {
namespace {

using base::NodeStatus;

NodeStatus whether(bool holds) {
  return holds ? NodeStatus::Success : NodeStatus::Failure;
}

// IsPathValid until Kilted, ValidatePath since Lyrical. Ports 0: path, 1: maximum cost, 2: unknown
// counts as an obstacle; for ValidatePath 4: length ahead, 5: layer, 6: footprint, 7: stops at the
// first collision, 8: collisions (out).

PathCheck checkOf(LeafContext& leaf) {
  PathCheck check;
  check.path = pathOf(leaf, 0);
  check.maxCost = leaf.getOr<int>(1, check.maxCost);
  check.unknownBlocks = leaf.getOr<bool>(2, false);
  return check;
}

NodeStatus isPathValid(LeafContext& leaf) {
  return whether(robotOf(leaf).checkPath(checkOf(leaf)).isValid);
}

NodeStatus validatePath(LeafContext& leaf) {
  PathCheck check = checkOf(leaf);
  check.lookahead = leaf.getOr<double>(4, -1.0);
  check.layer = textOf(leaf, 5);
  check.footprint = textOf(leaf, 6);
  check.stopsAtFirst = leaf.getOr<bool>(7, true);
  NavigatorHost& robot = robotOf(leaf);
  PathCheckResult result = robot.checkPath(check);
  leaf.set<int>(8, result.collisions.empty()
                       ? 0
                       : static_cast<int>(robot.paths().add(std::move(result.collisions))));
  return whether(result.isValid);
}

// IsStopped (Kilted) and CheckStopStatus (since Lyrical). Ports 0: speed, 1: time [ms].

struct StopMemory {
  std::int64_t since;  // step in which it stopped; 0: it moves
};

bool isSlow(const sim2d::BodyTwist& motion, double threshold) {
  return std::fabs(motion.linear) < threshold && std::fabs(motion.lateral) < threshold &&
         std::fabs(motion.angular) < threshold;
}

NodeStatus checkStop(LeafContext& leaf) {
  constexpr double kMilliseconds = 1e-3;  // [s]
  std::int64_t& since = leaf.memory<StopMemory>().since;
  if (!isSlow(robotOf(leaf).motion(), leaf.require<double>(0))) {
    since = 0;
    return NodeStatus::Failure;
  }
  since = since == 0 ? leaf.step() : since;
  if (!leaf.hasElapsed(since, kMilliseconds * leaf.getOr<int>(1, 1000))) {
    return NodeStatus::Running;
  }
  since = 0;
  return NodeStatus::Success;
}

/// Ports 0: tracking feedback, 1, 2: maximum distance to the left and right [m], 3: maximum heading
/// difference [rad]. Fails without feedback, as in Nav2.
NodeStatus isWithinBounds(LeafContext& leaf) {
  const sim2d::nav2::TrackingFeedback tracking = robotOf(leaf).tracking();
  if (leaf.getOr<int>(0, 0) == 0 || tracking.number == 0) {
    return NodeStatus::Failure;
  }
  const double most =
      tracking.positionError > 0.0 ? leaf.require<double>(1) : leaf.require<double>(2);
  return whether(std::fabs(tracking.positionError) <= most &&
                 std::fabs(tracking.headingError) <= leaf.require<double>(3));
}

/// Ports 0: service, 1: on. The service sets the switch even if the file has no collision monitor.
NodeStatus toggleMonitor(LeafContext& leaf) {
  robotOf(leaf).enableCollisionMonitor(leaf.require<bool>(1));
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
Condition IsPathValid|Navigation|No obstacle of the global costmap is on the remaining path (until Kilted).
path any needed suggest {path}|Path.
max_cost int default 254|Cost from which a cell is an obstacle (since Kilted).
consider_unknown_as_obstacle bool default false|Unknown cells are obstacles (since Kilted).
server_timeout int default 20|No effect: the service responds immediately.
Action ValidatePath|Navigation|No obstacle of the global costmap is on the remaining path (since Lyrical).
path max_cost consider_unknown_as_obstacle server_timeout
max_lookahead_distance number default -1.0 unit m|Length of the path that is checked, from the robot; below 0: the whole path.
layer_name text default|Layer of the global costmap that is checked; empty: all layers combined.
footprint text default|Footprint of the robot, [[x, y], ...]; empty: that of the costmap.
stop_at_first_collision bool default true|Stops at the first collision.
collision_poses any output suggest {collision_poses}|Poses of the path in collision.
service_name text default is_path_valid|No effect: there is a single service.
Condition IsStopped|Navigation|The robot has stood still for this time; RUNNING until then (Kilted).
velocity_threshold number default 0.01 unit m/s|Speed below which the robot stands, also for the turn rate [rad/s].
duration_stopped int default 1000 unit ms|Duration.
Action CheckStopStatus|Navigation|The robot has stood still for this time; RUNNING until then (since Lyrical).
velocity_threshold duration_stopped
Condition IsWithinPathTrackingBounds|Navigation|The robot is near the path that it follows (since Lyrical).
tracking_feedback any needed suggest {tracking_feedback}|Deviation from the path, an output of FollowPath.
max_error_left length default 0.5|Maximum distance to the left of the path.
max_error_right length default 0.5|Maximum distance to the right of the path.
max_error_heading number default 3.1415927 unit rad|Maximum difference between the robot's heading and the path's direction.
Action ToggleCollisionMonitor|Navigation|Switches the collision monitor on or off (since Lyrical).
service_name text default collision_monitor/toggle|No effect: there is a single collision monitor.
enable bool default true|Whether the collision monitor is on.
server_timeout
)";

}  // namespace

void addRobotChecks(NodeLibrary& to);
void addRobotChecks(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addCondition(manifest("IsPathValid"), isPathValid);
  to.addAction(manifest("ValidatePath"), validatePath);
  to.addStateful<StopMemory>(manifest("IsStopped"), {checkStop, checkStop, nullptr});
  to.addStateful<StopMemory>(manifest("CheckStopStatus"), {checkStop, checkStop, nullptr});
  to.addCondition(manifest("IsWithinPathTrackingBounds"), isWithinBounds);
  to.addAction(manifest("ToggleCollisionMonitor"), toggleMonitor);
}

}  // namespace bt
