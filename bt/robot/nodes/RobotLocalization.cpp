#include <string>

#include "bt/robot/RobotNodes.h"

/// Nodes of Nav2 that ask for the localiser or for TF (nav2_behavior_tree/plugins).
namespace bt {
namespace {

using base::NodeStatus;

NodeStatus initialPoseReceived(LeafContext& leaf) {
  return robotOf(leaf).isLocalized() ? NodeStatus::Success : NodeStatus::Failure;
}

struct FoundMemory {
  bool wasFound;
};

/// Ports 0: parent, 1: child. A transform that was there once is not asked for again.
NodeStatus transformAvailable(LeafContext& leaf) {
  auto& memory = leaf.memory<FoundMemory>();
  if (!memory.wasFound) {
    const std::string parent = leaf.text(0).value_or(""), child = leaf.text(1).value_or("");
    memory.wasFound = robotOf(leaf).canTransform(parent, child);
  }
  return memory.wasFound ? NodeStatus::Success : NodeStatus::Failure;
}

NodeStatus reinitializeGlobalLocalization(LeafContext& leaf) {
  return robotOf(leaf).relocalize() ? NodeStatus::Success : NodeStatus::Failure;
}

constexpr const char* kNodes = R"(
Condition InitialPoseReceived|Navigation|The robot has a pose in the map: its localiser has corrected once.
initial_pose_received any|Not looked at.
Condition TransformAvailable|Navigation|A transform between two frames of the parameter file exists.
parent text needed suggest odom|One frame.
child text needed suggest base_link|The other one.
Action ReinitializeGlobalLocalization|Navigation|The localiser begins a global localisation; fails without one (`localization` of the robot).
service_name text|No services by name here.
server_timeout int default 20|No servers to wait for here.
)";

}  // namespace

void addRobotLocalization(NodeLibrary& to);
void addRobotLocalization(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addCondition(manifest("InitialPoseReceived"), initialPoseReceived);
  to.addRemembering<FoundMemory>(manifest("TransformAvailable"), transformAvailable);
  to.addAction(manifest("ReinitializeGlobalLocalization"), reinitializeGlobalLocalization);
}

}  // namespace bt
