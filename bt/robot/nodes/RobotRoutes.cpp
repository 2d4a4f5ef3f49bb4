#include <cstdint>
#include <string_view>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that ask the route server, since Jazzy (nav2_behavior_tree/plugins/action).
namespace bt {
namespace {

using base::NodeStatus;
using State = RobotOutcome::State;

// ComputeRoute and ComputeAndTrackRoute. Ports 0: goal, 1: start, 2: goal's node, 3: start's node,
// 4: poses count, 5: the start counts; out 6: path, 7: route, 8: time [s], 9: error code, 10: error
// text. ComputeAndTrackRoute, out too: 11, 12: last and next node, 13: edge, 14: found anew, 15:
// time [s] as Kilted names it.

/// What was asked for, and which feedback has been written.
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
  if (outcome.state == State::Running) {
    return NodeStatus::Running;
  }
  setOutputs(leaf, outcome);
  return outcome.state == State::Failed ? NodeStatus::Failure : NodeStatus::Success;
}

NodeStatus beginTrack(LeafContext& leaf) {
  const RobotRequest request = requestOf(leaf);
  leaf.memory<RouteMemory>() = memoryOf(request);
  robotOf(leaf).begin(RobotAction::ComputeAndTrackRoute, request);
  return NodeStatus::Running;
}

/// While it runs, another goal or start is a new request.
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
    return outcome.state == State::Failed ? NodeStatus::Failure : NodeStatus::Success;
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

template <RobotAction action>
void cancelRoute(LeafContext& leaf) {
  robotOf(leaf).cancel(action);
}

NodeStatus cancelTracking(LeafContext& leaf) {
  robotOf(leaf).cancel(RobotAction::ComputeAndTrackRoute);
  return NodeStatus::Success;
}

/// Ports 0: route, 1: goals (out).
NodeStatus extractNodes(LeafContext& leaf) {
  const PathId route = pathOf(leaf, 0);
  if (robotOf(leaf).paths().get(route).empty()) {
    return NodeStatus::Failure;
  }
  leaf.set<int>(1, static_cast<int>(route));  // a route is held as the poses of its nodes
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
server_name text|Accepted; there is one such server.
server_timeout int default 20|Accepted; servers answer immediately here.
Action ComputeRoute|Navigation|Finds a route through the graph of the route server (since Jazzy).
goal any suggest {goal}|Where to; the nearest node that can be reached counts.
start any|Where from, when use_start is true; else from where the robot is.
goal_id int|Node where to, when use_poses is false.
start_id int|Node where from, when use_poses is false.
use_poses bool|Poses count, not nodes; absent: unless goal_id is given.
use_start bool default false|Whether start counts.
path any output suggest {path}|The route as a path; empty when it failed.
route any output suggest {route}|The nodes of the route.
planning_time number output|0: the answer is immediate here.
error_code_id int output suggest {error_code}|Why it failed, 0: it did not.
error_msg text output suggest {error_msg}|Why it failed, in words (since Kilted).
server_name server_timeout
Action ComputeAndTrackRoute|Navigation|Finds a route and runs until the robot has come to its end; a route that is blocked is found anew (since Jazzy).
goal start goal_id start_id use_poses use_start path route
execution_duration number output unit s|How long it has run.
error_code_id error_msg
last_node_id int output suggest {last_node_id}|Node that was reached last.
next_node_id int output suggest {next_node_id}|Node that is next.
current_edge_id int output suggest {current_edge_id}|Edge that is followed.
rerouted bool output suggest {rerouted}|The route has just been found anew.
execution_time number output unit s|How long it has run (Kilted).
server_name server_timeout
Action CancelComputeAndTrackRoute|Navigation|Ends ComputeAndTrackRoute (since Jazzy).
server_name server_timeout
Action ExtractRouteNodesAsGoals|Navigation|Takes the nodes of a route as goals (since Kilted).
route any needed suggest {route}|The route.
goals any output suggest {goals}|Its nodes, each looking to the next one.
)";

}  // namespace

void addRobotRoutes(NodeLibrary& to);
void addRobotRoutes(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addStateful(manifest("ComputeRoute"),
                 {beginRoute, awaitRoute, cancelRoute<RobotAction::ComputeRoute>});
  to.addStateful<RouteMemory>(
      manifest("ComputeAndTrackRoute"),
      {beginTrack, awaitTrack, cancelRoute<RobotAction::ComputeAndTrackRoute>});
  to.addAction(manifest("CancelComputeAndTrackRoute"), cancelTracking);
  to.addAction(manifest("ExtractRouteNodesAsGoals"), extractNodes);
}

}  // namespace bt
