#include <string>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that choose a server by a message on a topic
/// (nav2_behavior_tree/plugins/action/*_selector_node.cpp).
namespace bt {
namespace {

using base::NodeStatus;

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

void addRobotSelectors(NodeLibrary& to);
void addRobotSelectors(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  for (const NodeManifest& node : nodes.all()) {
    to.addAction(node, choose);
  }
}

}  // namespace bt
