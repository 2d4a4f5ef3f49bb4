#include <string>
#include <string_view>

#include "bt/robot/RobotNodes.h"

/// Actions of Nav2 that start a navigator: another tree on the same servers
/// (nav2_behavior_tree/plugins/action/navigate_*_action.cpp).
namespace bt {
namespace {

using base::NodeStatus;
using State = RobotOutcome::State;

/// Ports 0: goal or goals, 1: tree; out 2: error code, 3: error text.
template <RobotAction action>
NodeStatus begin(LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  request.tree = textOf(leaf, 1);
  robotOf(leaf).begin(action, request);
  return NodeStatus::Running;
}

template <RobotAction action>
NodeStatus await(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(action);
  if (outcome.state != State::Running) {
    leaf.set<int>(2, outcome.errorCode);
    leaf.set<std::string_view>(3, outcome.errorText);
  }
  return statusOf(outcome);
}

constexpr const char* kNodes = R"(
Action NavigateToPose|Navigation|Drives to a pose with another tree.
goal any needed suggest {goal}|Goal pose.
behavior_tree text default|File of the tree; empty: default_nav_to_pose_bt_xml, or Nav2's own.
error_code_id int output suggest {error_code}|Error code; 0: no error (since Jazzy).
error_msg text output suggest {error_msg}|Error message (since Kilted).
server_name text|No effect: there is a single server.
server_timeout int default 20|No effect: servers respond immediately.
Action NavigateThroughPoses|Navigation|Drives through several poses with another tree.
goals any needed suggest {goals}|Goal poses, in order.
behavior_tree text default|File of the tree; empty: default_nav_through_poses_bt_xml, or Nav2's own.
error_code_id error_msg server_name server_timeout
)";

template <RobotAction action>
void add(NodeLibrary& to, const NodeManifest& manifest) {
  to.addStateful(manifest, {begin<action>, await<action>, cancelAction<action>});
}

}  // namespace

void addRobotNavigators(NodeLibrary& to);
void addRobotNavigators(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  add<RobotAction::NavigateToPose>(to, *nodes.find("NavigateToPose"));
  add<RobotAction::NavigateThroughPoses>(to, *nodes.find("NavigateThroughPoses"));
}

}  // namespace bt
