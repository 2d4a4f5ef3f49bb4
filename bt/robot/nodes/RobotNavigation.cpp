#include <string>

#include "bt/robot/RobotNodes.h"

/// Nodes for docking, following and assisted teleoperation (opennav_docking_bt,
/// opennav_following_bt), battery conditions, nodes that query the localiser or TF, and actions
/// that start a navigator: another tree on the same servers (nav2_behavior_tree/plugins).
namespace bt {
namespace {

using base::NodeStatus;
using Action = RobotAction;
using State = RobotOutcome::State;

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
  robot.begin(Action::DockRobot, request);
  return NodeStatus::Running;
}

void setDocked(LeafContext& leaf, const RobotOutcome& outcome) {
  leaf.set<bool>(8, outcome.state == State::Succeeded);
  leaf.set<int>(9, outcome.retries);
  setError<6, 7>(leaf, outcome);
}

// UndockRobot. Ports 0: dock_type, 1: max_undocking_time; out 2: error code, 3: message,
// 4: success.

RobotRequest undockRequest(LeafContext& leaf) {
  RobotRequest request;
  request.dock.type = textOf(leaf, 0);
  request.timeAllowance = leaf.getOr<double>(1, 30.0);
  return request;
}

void setUndocked(LeafContext& leaf, const RobotOutcome& outcome) {
  leaf.set<bool>(4, outcome.state == State::Succeeded);
  setError<2, 3>(leaf, outcome);
}

// FollowObject. Ports 0: pose_topic, 1: tracked_frame, 2: max_duration; out 3: error code,
// 4: message, 5: total_elapsed_time.

RobotRequest followRequest(LeafContext& leaf) {
  RobotRequest request;
  request.object.topic = textOf(leaf, 0);
  request.object.frame = textOf(leaf, 1);
  request.timeAllowance = leaf.getOr<double>(2, 0.0);
  return request;
}

void setFollowed(LeafContext& leaf, const RobotOutcome& outcome) {
  leaf.set<double>(5, outcome.duration);
  setError<3, 4>(leaf, outcome);
}

/// AssistedTeleop. Ports 0: time_allowance, 1: is_recovery; out 2: error code, 3: message.
RobotRequest teleopRequest(LeafContext& leaf) {
  RobotRequest request;
  request.timeAllowance = leaf.getOr<double>(0, 10.0);
  if (leaf.getOr<bool>(1, true)) {
    robotOf(leaf).countRecovery();
  }
  return request;
}

// Battery conditions. A robot without a battery publishes nothing: both are false.

/// Ports 0: min_battery, 1: is_voltage.
NodeStatus isBatteryLow(LeafContext& leaf) {
  const auto battery = robotOf(leaf).battery();
  const double least = leaf.getOr<double>(0, 0.0);
  return successIf(battery &&
                   (leaf.getOr<bool>(1, false) ? battery->voltage : battery->level) <= least);
}

NodeStatus isBatteryCharging(LeafContext& leaf) {
  const auto battery = robotOf(leaf).battery();
  return successIf(battery && battery->isCharging);
}

/// Port 0: whether it was received. Nav2 keeps this in the blackboard; here without a value the
/// localization is asked.
NodeStatus initialPoseReceived(LeafContext& leaf) {
  return successIf(leaf.getOr<bool>(0, robotOf(leaf).isLocalized()));
}

struct FoundMemory {
  bool wasFound;
};

/// Ports 0: parent, 1: child. A transform that was found once is not queried again.
NodeStatus transformAvailable(LeafContext& leaf) {
  auto& memory = leaf.memory<FoundMemory>();
  if (!memory.wasFound) {
    const std::string parent = textOf(leaf, 0), child = textOf(leaf, 1);
    memory.wasFound = robotOf(leaf).canTransform(parent, child);
  }
  return successIf(memory.wasFound);
}

NodeStatus reinitializeGlobalLocalization(LeafContext& leaf) {
  return successIf(robotOf(leaf).relocalize());
}

/// NavigateToPose and NavigateThroughPoses. Ports 0: goal or goals, 1: tree; out 2: error code, 3:
/// error text.
RobotRequest navigateRequest(LeafContext& leaf) {
  RobotRequest request;
  request.path = pathOf(leaf, 0);
  request.tree = textOf(leaf, 1);
  return request;
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
Action AssistedTeleop|Navigation|Manual drive that slows down in front of obstacles.
time_allowance number default 10.0 unit s|Maximum duration.
is_recovery bool default true|Is counted as a recovery.
error_code_id error_msg server_name server_timeout
Action CancelFollowObject|Navigation|Cancels FollowObject.
server_name server_timeout
Action CancelAssistedTeleop|Navigation|Cancels AssistedTeleop.
server_name server_timeout
Condition IsBatteryLow|Navigation|The battery of the robot is low.
min_battery number default 0.0|State of charge from 0 to 1, or voltage, at which the battery is low.
is_voltage bool default false|min_battery is a voltage.
battery_topic text default /battery_status|No effect: the battery of the robot in the scenario is used.
Condition IsBatteryCharging|Navigation|The battery of the robot is being charged.
battery_topic
Condition InitialPoseReceived|Navigation|The robot has a pose in the map: the localization has made its first correction.
initial_pose_received bool|Replaces the state of the localization.
Condition TransformAvailable|Navigation|A transform between two frames of the parameter file exists.
parent text needed suggest odom|Parent frame.
child text needed suggest base_link|Child frame.
Action ReinitializeGlobalLocalization|Navigation|Starts a global localization; fails for a robot without `localization`.
service_name text|No effect: this program has no services with names.
server_timeout int default 20|No effect: servers respond immediately.
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

}  // namespace

void addRobotNavigation(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"DockRobot", stateful({beginDocking, awaitAction<Action::DockRobot, setDocked>,
                                  cancelAction<Action::DockRobot>})},
          {"UndockRobot", actionNode<Action::UndockRobot, undockRequest, setUndocked>()},
          {"FollowObject", actionNode<Action::FollowObject, followRequest, setFollowed>()},
          {"AssistedTeleop", actionNode<Action::AssistedTeleop, teleopRequest, setError<2, 3>>()},
          {"CancelFollowObject", cancelNode<Action::FollowObject>()},
          {"CancelAssistedTeleop", cancelNode<Action::AssistedTeleop>()},
          {"IsBatteryLow", synchronous(isBatteryLow)},
          {"IsBatteryCharging", synchronous(isBatteryCharging)},
          {"InitialPoseReceived", synchronous(initialPoseReceived)},
          {"TransformAvailable", synchronousWithStatus<FoundMemory>(transformAvailable)},
          {"ReinitializeGlobalLocalization", synchronous(reinitializeGlobalLocalization)},
          {"NavigateToPose", actionNode<Action::NavigateToPose, navigateRequest, setError<2, 3>>()},
          {"NavigateThroughPoses",
           actionNode<Action::NavigateThroughPoses, navigateRequest, setError<2, 3>>()}});
}

}  // namespace bt
