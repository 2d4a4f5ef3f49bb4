#include <string>

#include "bt/robot/RobotNodes.h"

/// Nodes for docking, following and assisted teleoperation (opennav_docking_bt,
/// opennav_following_bt, nav2_behavior_tree), and battery conditions.
namespace bt {
namespace {

using base::NodeStatus;
using State = RobotOutcome::State;

/// Ports from `first`: error code, message.
NodeStatus statusWithError(LeafContext& leaf, const RobotOutcome& outcome, int first) {
  if (outcome.state != State::Running) {
    leaf.set<int>(first, outcome.errorCode);
    leaf.set<std::string_view>(first + 1, outcome.errorText);
  }
  return statusOf(outcome);
}

// DockRobot. Ports 0: use_dock_id, 1: dock_id, 2: dock_pose, 3: dock_type, 4: max_staging_time,
// 5: navigate_to_staging_pose; out 6: error code, 7: message, 8: success, 9: retries.

NodeStatus beginDocking(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  RobotRequest request;
  request.dock.usesDockId = leaf.getOr<bool>(0, true);
  request.dock.dockId = textOf(leaf, 1);
  request.path = pathOf(leaf, 2);
  request.dock.type = textOf(leaf, 3);
  request.dock.maxStagingTime = leaf.getOr<double>(4, 1000.0);
  request.dock.navigatesToStaging = leaf.getOr<bool>(5, true);
  if (!request.dock.usesDockId && robot.paths().get(request.path).empty()) {
    leaf.set<bool>(8, false);
    return NodeStatus::Failure;  // no pose given
  }
  robot.begin(RobotAction::DockRobot, request);
  return NodeStatus::Running;
}

NodeStatus awaitDocking(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(RobotAction::DockRobot);
  if (outcome.state != State::Running) {
    leaf.set<bool>(8, outcome.state == State::Succeeded);
    leaf.set<int>(9, outcome.retries);
  }
  return statusWithError(leaf, outcome, 6);
}

// UndockRobot. Ports 0: dock_type, 1: max_undocking_time; out 2: error code, 3: message,
// 4: success.

NodeStatus beginUndocking(LeafContext& leaf) {
  RobotRequest request;
  request.dock.type = textOf(leaf, 0);
  request.timeAllowance = leaf.getOr<double>(1, 30.0);
  robotOf(leaf).begin(RobotAction::UndockRobot, request);
  return NodeStatus::Running;
}

NodeStatus awaitUndocking(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(RobotAction::UndockRobot);
  if (outcome.state != State::Running) {
    leaf.set<bool>(4, outcome.state == State::Succeeded);
  }
  return statusWithError(leaf, outcome, 2);
}

// FollowObject. Ports 0: pose_topic, 1: tracked_frame, 2: max_duration; out 3: error code,
// 4: message, 5: total_elapsed_time.

NodeStatus beginFollowing(LeafContext& leaf) {
  RobotRequest request;
  request.object.topic = textOf(leaf, 0);
  request.object.frame = textOf(leaf, 1);
  request.timeAllowance = leaf.getOr<double>(2, 0.0);
  robotOf(leaf).begin(RobotAction::FollowObject, request);
  return NodeStatus::Running;
}

NodeStatus awaitFollowing(LeafContext& leaf) {
  const RobotOutcome outcome = robotOf(leaf).outcome(RobotAction::FollowObject);
  if (outcome.state != State::Running) {
    leaf.set<double>(5, outcome.duration);
  }
  return statusWithError(leaf, outcome, 3);
}

// AssistedTeleop. Ports 0: time_allowance, 1: is_recovery; out 2: error code, 3: message.

NodeStatus beginTeleop(LeafContext& leaf) {
  NavigatorHost& robot = robotOf(leaf);
  RobotRequest request;
  request.timeAllowance = leaf.getOr<double>(0, 10.0);
  if (leaf.getOr<bool>(1, true)) {
    robot.countRecovery();
  }
  robot.begin(RobotAction::AssistedTeleop, request);
  return NodeStatus::Running;
}

NodeStatus awaitTeleop(LeafContext& leaf) {
  return statusWithError(leaf, robotOf(leaf).outcome(RobotAction::AssistedTeleop), 2);
}

// Battery conditions. A robot without a battery publishes nothing: both are false.

/// Ports 0: min_battery, 1: is_voltage.
NodeStatus isBatteryLow(LeafContext& leaf) {
  const auto battery = robotOf(leaf).battery();
  const double least = leaf.getOr<double>(0, 0.0);
  const bool isLow =
      battery && (leaf.getOr<bool>(1, false) ? battery->voltage : battery->level) <= least;
  return isLow ? NodeStatus::Success : NodeStatus::Failure;
}

NodeStatus isBatteryCharging(LeafContext& leaf) {
  const auto battery = robotOf(leaf).battery();
  return battery && battery->isCharging ? NodeStatus::Success : NodeStatus::Failure;
}

constexpr const char* kNodes = R"(
server_name text|No effect: there is a single server of each kind.
server_timeout int default 20|No effect: servers respond immediately.
error_code_id int output suggest {error_code}|Error code; 0: no error.
error_msg text output|Error message.
success bool output|Whether the action succeeded.
Action DockRobot|Navigation|Drives into a dock.
use_dock_id bool default true|Whether dock_id is used, else dock_pose and dock_type.
dock_id text suggest dock1|Name of a dock of the docking server or of the scenario.
dock_pose any|Pose of the docked robot.
dock_type text|Class of the dock; not needed if there is only one.
max_staging_time number default 1000.0 unit s|Maximum duration of the drive to the staging pose.
navigate_to_staging_pose bool default true|Drives to the staging pose first.
error_code_id error_msg success
num_retries int output|Number of repetitions of the approach.
server_name server_timeout
Action UndockRobot|Navigation|Drives out of a dock to its staging pose.
dock_type text|Class of the dock; empty: that of the last docking.
max_undocking_time number default 30.0 unit s|Maximum duration.
error_code_id error_msg success server_name server_timeout
Action FollowObject|Navigation|Follows a moving person or robot at a distance.
pose_topic text default dynamic_pose|Name of a person or robot; for any other text the nearest person.
tracked_frame text|A person or robot by name or id, instead of pose_topic.
max_duration number default 0.0 unit s|Maximum duration; 0: until it is cancelled.
error_code_id error_msg
total_elapsed_time number output unit s|Duration.
server_name server_timeout
Action CancelFollowObject|Navigation|Cancels FollowObject.
server_name server_timeout
Action AssistedTeleop|Navigation|Manual drive that slows down in front of obstacles.
time_allowance number default 10.0 unit s|Maximum duration.
is_recovery bool default true|Is counted as a recovery.
error_code_id error_msg server_name server_timeout
Action CancelAssistedTeleop|Navigation|Cancels AssistedTeleop.
server_name server_timeout
Condition IsBatteryLow|Navigation|The battery of the robot is low.
min_battery number default 0.0|State of charge from 0 to 1, or voltage, at which the battery is low.
is_voltage bool default false|min_battery is a voltage.
battery_topic text default /battery_status|No effect: the battery of the robot in the scenario is used.
Condition IsBatteryCharging|Navigation|The battery of the robot is being charged.
battery_topic
)";

}  // namespace

void addRobotDocking(NodeLibrary& to);
void addRobotDocking(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addStateful(manifest("DockRobot"),
                 {beginDocking, awaitDocking, cancelAction<RobotAction::DockRobot>});
  to.addStateful(manifest("UndockRobot"),
                 {beginUndocking, awaitUndocking, cancelAction<RobotAction::UndockRobot>});
  to.addStateful(manifest("FollowObject"),
                 {beginFollowing, awaitFollowing, cancelAction<RobotAction::FollowObject>});
  to.addStateful(manifest("AssistedTeleop"),
                 {beginTeleop, awaitTeleop, cancelAction<RobotAction::AssistedTeleop>});
  to.addAction(manifest("CancelFollowObject"), cancelNow<RobotAction::FollowObject>);
  to.addAction(manifest("CancelAssistedTeleop"), cancelNow<RobotAction::AssistedTeleop>);
  to.addCondition(manifest("IsBatteryLow"), isBatteryLow);
  to.addCondition(manifest("IsBatteryCharging"), isBatteryCharging);
}

}  // namespace bt
