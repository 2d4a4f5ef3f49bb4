#include <cmath>
#include <string>
#include <utility>

#include "bt/robot/RobotNodes.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

/// Nodes of Nav2 that look at paths against the costmap, at the robot's motion, and at how far it
/// is off its path (nav2_behavior_tree/plugins/action and /condition).
namespace bt {
namespace {

using base::NodeStatus;

NodeStatus whether(bool holds) {
  return holds ? NodeStatus::Success : NodeStatus::Failure;
}

// IsPathValid until Kilted, ValidatePath since Lyrical. Ports 0: path, 1: highest cost, 2: unknown
// counts as an obstacle; of ValidatePath 4: length ahead, 5: layer, 6: footprint, 7: stops at the
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
  check.layer = leaf.text(5).value_or("");
  check.footprint = leaf.text(6).value_or("");
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
  std::int64_t since;  // step in which it has stopped; 0: it moves
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

/// Ports 0: tracking feedback, 1, 2: greatest distance to the left and right [m], 3: greatest
/// difference of headings [rad]. Without feedback it fails, as in Nav2.
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

/// Ports 0: service, 1: on. Whether the file has a collision monitor does not matter: the service
/// sets a switch.
NodeStatus toggleMonitor(LeafContext& leaf) {
  robotOf(leaf).monitorCollisions(leaf.require<bool>(1));
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
Condition IsPathValid|Navigation|No obstacle of the global costmap lies on the rest of the path (until Kilted).
path any needed suggest {path}|The path.
max_cost int default 254|Cost from which a cell is in the way (since Kilted).
consider_unknown_as_obstacle bool default false|Unknown cells are in the way (since Kilted).
server_timeout int default 20|Accepted; the answer is immediate here.
Action ValidatePath|Navigation|No obstacle of the global costmap lies on the rest of the path (since Lyrical).
path max_cost consider_unknown_as_obstacle server_timeout
max_lookahead_distance number default -1.0 unit m|Length of the path that is looked at from the robot on; below 0 all of it.
layer_name text default|Layer of the global costmap that is looked at; empty: all layers merged.
footprint text default|Outline of the robot, [[x, y], ...]; empty: that of the costmap.
stop_at_first_collision bool default true|Looks no further than the first collision.
collision_poses any output suggest {collision_poses}|Poses of the path that are blocked.
service_name text default is_path_valid|Accepted; there is one such service.
Condition IsStopped|Navigation|The robot has stood still for a time; RUNNING until then (Kilted).
velocity_threshold number default 0.01 unit m/s|Slower than this is standing; also of turning [rad/s].
duration_stopped int default 1000 unit ms|For how long.
Action CheckStopStatus|Navigation|The robot has stood still for a time; RUNNING until then (since Lyrical).
velocity_threshold duration_stopped
Condition IsWithinPathTrackingBounds|Navigation|The robot is near the path that it follows (since Lyrical).
tracking_feedback any needed suggest {tracking_feedback}|Of FollowPath.
max_error_left length default 0.5|Greatest distance to the left of the path.
max_error_right length default 0.5|Greatest distance to the right of the path.
max_error_heading number default 3.1415927 unit rad|Greatest difference between the robot's heading and the path's direction.
Action ToggleCollisionMonitor|Navigation|Switches the collision monitor on or off (since Lyrical).
service_name text default collision_monitor/toggle|Accepted; there is one collision monitor.
enable bool default true|On.
server_timeout
)";

}  // namespace

void addRobotChecks(NodeLibrary& to);
void addRobotChecks(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addCondition(manifest("IsPathValid"), isPathValid);
  to.addAction(manifest("ValidatePath"), validatePath);
  to.addStateful<StopMemory>(manifest("IsStopped"), {checkStop, checkStop, nullptr});
  to.addStateful<StopMemory>(manifest("CheckStopStatus"), {checkStop, checkStop, nullptr});
  to.addCondition(manifest("IsWithinPathTrackingBounds"), isWithinBounds);
  to.addAction(manifest("ToggleCollisionMonitor"), toggleMonitor);
}

}  // namespace bt
