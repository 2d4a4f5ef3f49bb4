#include <string>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that choose a server by what is published on a topic
/// (nav2_behavior_tree/plugins/action/*_selector_node.cpp).
namespace bt {
namespace {

using base::NodeStatus;

/// Ports 0: topic, 1: default, 2: the choice (out). The last message, once there is one; until then
/// the default.
NodeStatus choose(LeafContext& leaf) {
  const TopicMessage message = robotOf(leaf).lastMessage(leaf.text(0).value_or(""));
  const std::string chosen =
      message.number > 0 && !message.text.empty() ? message.text : leaf.text(1).value_or("");
  if (chosen.empty()) {
    return NodeStatus::Failure;
  }
  leaf.set<std::string_view>(2, chosen);
  return NodeStatus::Success;
}

constexpr const char* kNodes = R"(
Action PlannerSelector|Navigation|Chooses the planner by a topic.
topic_name text default planner_selector|Topic with the name of the planner (nav2_topics of the robot).
default_planner text needed suggest GridBased|What is chosen until something is published.
selected_planner text output suggest {selected_planner}|The choice.
Action ControllerSelector|Navigation|Chooses the controller by a topic.
topic_name text default controller_selector|Topic with the name of the controller (nav2_topics of the robot).
default_controller text needed suggest FollowPath|What is chosen until something is published.
selected_controller text output suggest {selected_controller}|The choice.
Action GoalCheckerSelector|Navigation|Chooses the goal checker by a topic.
topic_name text default goal_checker_selector|Topic with the name of the goal checker (nav2_topics of the robot).
default_goal_checker text needed suggest goal_checker|What is chosen until something is published.
selected_goal_checker text output suggest {selected_goal_checker}|The choice.
Action SmootherSelector|Navigation|Chooses the smoother by a topic.
topic_name text default smoother_selector|Topic with the name of the smoother (nav2_topics of the robot).
default_smoother text needed suggest simple_smoother|What is chosen until something is published.
selected_smoother text output suggest {selected_smoother}|The choice.
Action ProgressCheckerSelector|Navigation|Chooses the progress checker by a topic.
topic_name text default progress_checker_selector|Topic with the name of the progress checker (nav2_topics of the robot).
default_progress_checker text needed suggest progress_checker|What is chosen until something is published.
selected_progress_checker text output suggest {selected_progress_checker}|The choice.
Action PathHandlerSelector|Navigation|Chooses the path handler by a topic (since Lyrical).
topic_name text default path_handler_selector|Topic with the name of the path handler (nav2_topics of the robot).
default_path_handler text needed suggest PathHandler|What is chosen until something is published.
selected_path_handler text output suggest {selected_path_handler}|The choice.
)";

}  // namespace

void addRobotSelectors(NodeLibrary& to);
void addRobotSelectors(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  for (const NodeManifest& node : nodes.all()) {
    to.addAction(node, choose);
  }
}

}  // namespace bt
