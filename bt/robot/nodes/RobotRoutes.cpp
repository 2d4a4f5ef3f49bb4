#include <cstdint>
#include <string_view>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that use the route server, since Jazzy (nav2_behavior_tree/plugins/action).
namespace bt {
namespace {

using base::NodeStatus;
using State = RobotOutcome::State;

// ComputeRoute and ComputeAndTrackRoute. Ports 0: goal, 1: start, 2: goal node, 3: start node, 4:
// use poses, 5: use start; out 6: path, 7: route, 8: time [s], 9: error code, 10: error text.
// Further outputs of ComputeAndTrackRoute: 11, 12: last and next node, 13: edge, 14: rerouted, 15:
// time [s] under its name in Kilted.

/// The last request and the number of the last written feedback.
struct RouteMemory {
  PathId goal, start;
  int goalId, startId;
  int number;
};

RobotRequest requestOf(LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  if (leaf.getOr<bool>(5, false)) {
    request.start = pathOf(leaf, 1);
  }
  const int goal = leaf.getOr<int>(2, -1), start = leaf.getOr<int>(3, -1);
  request.usesPoses = leaf.getOr<bool>(4, goal < 0);
  request.goalId = goal < 0 ? 0U : static_cast<std::uint32_t>(goal);
  request.startId = start < 0 ? 0U : static_cast<std::uint32_t>(start);
  return request;
}

RouteMemory memoryOf(const RobotRequest& request) {
  return {request.path, request.start.value_or(0), static_cast<int>(request.goalId),
          static_cast<int>(request.startId), 0};
}

void setOutputs(LeafContext& leaf, const RobotOutcome& outcome) {
  leaf.set<int>(6, static_cast<int>(outcome.path));
  leaf.set<int>(7, static_cast<int>(outcome.progress.route));
  leaf.set<double>(8, outcome.duration);
  leaf.set<int>(9, outcome.errorCode);
  leaf.set<std::string_view>(10, outcome.errorText);
}

NodeStatus beginRoute(LeafContext& leaf) {
  robotOf(leaf).begin(RobotAction::ComputeRoute, requestOf(leaf));
  return NodeStatus::Running;
}

NodeStatus awaitRoute(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(RobotAction::ComputeRoute);
  if (outcome.state != State::Running) {
    setOutputs(leaf, outcome);
  }
  return statusOf(outcome);
}

NodeStatus beginTrack(LeafContext& leaf) {
  const RobotRequest request = requestOf(leaf);
  leaf.memory<RouteMemory>() = memoryOf(request);
  robotOf(leaf).begin(RobotAction::ComputeAndTrackRoute, request);
  return NodeStatus::Running;
}

/// Another goal or start while running is a new request.
NodeStatus awaitTrack(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  auto& memory = leaf.memory<RouteMemory>();
  const RobotOutcome outcome = robot.outcome(RobotAction::ComputeAndTrackRoute);
  if (outcome.progress.number != memory.number || outcome.state != State::Running) {
    memory.number = outcome.progress.number;
    setOutputs(leaf, outcome);
    leaf.set<int>(11, static_cast<int>(outcome.progress.lastNode));
    leaf.set<int>(12, static_cast<int>(outcome.progress.nextNode));
    leaf.set<int>(13, static_cast<int>(outcome.progress.currentEdge));
    leaf.set<bool>(14, outcome.progress.isRerouted);
    leaf.set<double>(15, outcome.duration);
  }
  if (outcome.state != State::Running) {
    return statusOf(outcome);
  }
  const RobotRequest request = requestOf(leaf);
  const RouteMemory now = memoryOf(request);
  const bool isOther = now.goal != memory.goal || now.start != memory.start ||
                       now.goalId != memory.goalId || now.startId != memory.startId;
  if (isOther) {
    memory = now;
    robot.begin(RobotAction::ComputeAndTrackRoute, request);
  }
  return NodeStatus::Running;
}

/// Ports 0: route, 1: goals (out).
NodeStatus extractNodes(LeafContext& leaf) {
  const PathId route = pathOf(leaf, 0);
  if (robotOf(leaf).paths().get(route).empty()) {
    return NodeStatus::Failure;
  }
  leaf.set<int>(1, static_cast<int>(route));  // a route is stored as the poses of its nodes
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
server_name text|No effect: there is a single server.
server_timeout int default 20|No effect: servers respond immediately.
Action ComputeRoute|Navigation|Computes a route through the graph of the route server (since Jazzy).
goal any suggest {goal}|Goal pose; the nearest reachable node is used.
start any|Start pose if use_start is true; else the robot's pose.
goal_id int|Goal node if use_poses is false.
start_id int|Start node if use_poses is false.
use_poses bool|Whether poses are used instead of nodes; absent: unless goal_id is given.
use_start bool default false|Whether start is used.
path any output suggest {path}|Route as a path; empty after a failure.
route any output suggest {route}|Nodes of the route.
planning_time number output|Always 0: the server responds immediately.
error_code_id int output suggest {error_code}|Error code; 0: no error.
error_msg text output suggest {error_msg}|Error message (since Kilted).
server_name server_timeout
Action ComputeAndTrackRoute|Navigation|Computes a route and runs until the robot has reached its end; a blocked route is computed again (since Jazzy).
goal start goal_id start_id use_poses use_start path route
execution_duration number output unit s|Duration so far.
error_code_id error_msg
last_node_id int output suggest {last_node_id}|Last reached node.
next_node_id int output suggest {next_node_id}|Next node.
current_edge_id int output suggest {current_edge_id}|Current edge.
rerouted bool output suggest {rerouted}|The route was computed again in this tick.
execution_time number output unit s|Duration so far (Kilted).
server_name server_timeout
Action CancelComputeAndTrackRoute|Navigation|Cancels ComputeAndTrackRoute (since Jazzy).
server_name server_timeout
Action ExtractRouteNodesAsGoals|Navigation|Gets the nodes of a route as goals (since Kilted).
route any needed suggest {route}|Route.
goals any output suggest {goals}|Nodes of the route, each with the heading to the next one.
)";

}  // namespace

void addRobotRoutes(NodeLibrary& to);
void addRobotRoutes(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addStateful(manifest("ComputeRoute"),
                 {beginRoute, awaitRoute, cancelAction<RobotAction::ComputeRoute>});
  to.addStateful<RouteMemory>(
      manifest("ComputeAndTrackRoute"),
      {beginTrack, awaitTrack, cancelAction<RobotAction::ComputeAndTrackRoute>});
  to.addAction(manifest("CancelComputeAndTrackRoute"),
               cancelNow<RobotAction::ComputeAndTrackRoute>);
  to.addAction(manifest("ExtractRouteNodesAsGoals"), extractNodes);
}

}  // namespace bt
