#include <string>

#include "bt/robot/RobotNodes.h"

/// Nodes of Nav2 that query the localiser or TF (nav2_behavior_tree/plugins).
namespace bt {
namespace {

using base::NodeStatus;

NodeStatus initialPoseReceived(LeafContext& leaf) {
  return robotOf(leaf).isLocalized() ? NodeStatus::Success : NodeStatus::Failure;
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
  return memory.wasFound ? NodeStatus::Success : NodeStatus::Failure;
}

NodeStatus reinitializeGlobalLocalization(LeafContext& leaf) {
  return robotOf(leaf).relocalize() ? NodeStatus::Success : NodeStatus::Failure;
}

constexpr const char* kNodes = R"(
Condition InitialPoseReceived|Navigation|The robot has a pose in the map: the localization has made its first correction.
initial_pose_received any|No effect.
Condition TransformAvailable|Navigation|A transform between two frames of the parameter file exists.
parent text needed suggest odom|Parent frame.
child text needed suggest base_link|Child frame.
Action ReinitializeGlobalLocalization|Navigation|Starts a global localization; fails for a robot without `localization`.
service_name text|No effect: this program has no services with names.
server_timeout int default 20|No effect: servers respond immediately.
)";

}  // namespace

void addRobotLocalization(NodeLibrary& to);
void addRobotLocalization(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  const auto manifest = [&nodes](const char* id) { return *nodes.find(id); };
  to.addCondition(manifest("InitialPoseReceived"), initialPoseReceived);
  to.addSynchronousWithStatus<FoundMemory>(manifest("TransformAvailable"), transformAvailable);
  to.addAction(manifest("ReinitializeGlobalLocalization"), reinitializeGlobalLocalization);
}

}  // namespace bt
