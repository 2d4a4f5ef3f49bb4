#include <cstdint>
#include <string>
#include <string_view>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that use the route server, since Jazzy, and those that choose a server by a
/// message on a topic (nav2_behavior_tree/plugins/action).
namespace bt {
namespace {

using State = RobotOutcome::State;
using base::NodeStatus;

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
  setNumber(leaf, 6, outcome.path);
  setNumber(leaf, 7, outcome.progress.route);
  leaf.set<double>(8, outcome.duration);
  setError<9, 10>(leaf, outcome);
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
    setNumber(leaf, 11, outcome.progress.lastNode);
    setNumber(leaf, 12, outcome.progress.nextNode);
    setNumber(leaf, 13, outcome.progress.currentEdge);
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
  setNumber(leaf, 1, route);  // a route is stored as the poses of its nodes
  return NodeStatus::Success;
}

/// Ports 0: topic, 1: default, 2: choice (out). The last message, or the default before the first
/// one.
NodeStatus choose(LeafContext& leaf) {
  const TopicMessage message = robotOf(leaf).lastMessage(textOf(leaf, 0));
  const std::string chosen =
      message.number > 0 && !message.text.empty() ? message.text : textOf(leaf, 1);
  if (chosen.empty()) {
    return NodeStatus::Failure;
  }
  leaf.set<std::string_view>(2, chosen);
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

constexpr const char* kSelectors = R"(
Action PlannerSelector|Navigation|Selects the planner by a topic.
topic_name text default planner_selector|Topic with the name of the planner (nav2_topics of the robot).
default_planner text needed suggest GridBased|Selection until a message is published.
selected_planner text output suggest {selected_planner}|Selection.
Action ControllerSelector|Navigation|Selects the controller by a topic.
topic_name text default controller_selector|Topic with the name of the controller (nav2_topics of the robot).
default_controller text needed suggest FollowPath|Selection until a message is published.
selected_controller text output suggest {selected_controller}|Selection.
Action GoalCheckerSelector|Navigation|Selects the goal checker by a topic.
topic_name text default goal_checker_selector|Topic with the name of the goal checker (nav2_topics of the robot).
default_goal_checker text needed suggest goal_checker|Selection until a message is published.
selected_goal_checker text output suggest {selected_goal_checker}|Selection.
Action SmootherSelector|Navigation|Selects the smoother by a topic.
topic_name text default smoother_selector|Topic with the name of the smoother (nav2_topics of the robot).
default_smoother text needed suggest simple_smoother|Selection until a message is published.
selected_smoother text output suggest {selected_smoother}|Selection.
Action ProgressCheckerSelector|Navigation|Selects the progress checker by a topic.
topic_name text default progress_checker_selector|Topic with the name of the progress checker (nav2_topics of the robot).
default_progress_checker text needed suggest progress_checker|Selection until a message is published.
selected_progress_checker text output suggest {selected_progress_checker}|Selection.
Action PathHandlerSelector|Navigation|Selects the path handler by a topic (since Lyrical).
topic_name text default path_handler_selector|Topic with the name of the path handler (nav2_topics of the robot).
default_path_handler text needed suggest PathHandler|Selection until a message is published.
selected_path_handler text output suggest {selected_path_handler}|Selection.
)";

}  // namespace

void addRobotRoutes(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"ComputeRoute", actionNode<RobotAction::ComputeRoute, requestOf, setOutputs>()},
          {"ComputeAndTrackRoute",
           stateful<RouteMemory>(
               {beginTrack, awaitTrack, cancelAction<RobotAction::ComputeAndTrackRoute>})},
          {"CancelComputeAndTrackRoute", cancelNode<RobotAction::ComputeAndTrackRoute>()},
          {"ExtractRouteNodesAsGoals", synchronous(extractNodes)}});
  const NodeCatalogue selectors = parseNodeCatalogue(kSelectors, NodeOrigin::Ours);
  for (const NodeManifest& node : selectors.all()) {
    to.add(node, synchronous(choose));
  }
}

}  // namespace bt
