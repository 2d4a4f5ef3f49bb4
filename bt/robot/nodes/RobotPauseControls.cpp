#include "bt/robot/RobotNodes.h"

/// Control nodes of Nav2 since Lyrical that resume where they stopped
/// (nav2_behavior_tree/plugins/control).
namespace bt {
namespace {

using base::NodeStatus;

/// Port 0: index of the next child, kept in the blackboard (in, out). Runs the children in order
/// from that one; a failure or a halt leaves the index unchanged.
NodeStatus persistentSequence(ParentContext& node) {
  const int count = node.childCount();
  int child = node.getOr<int>(0, 0);
  if (child < 0 || child > count) {
    return node.fault("current_child_idx is not the number of a child");
  }
  bool isSkipped = true;
  while (child < count) {
    const NodeStatus status = node.tickChild(child);
    if (status != NodeStatus::Success && status != NodeStatus::Skipped) {
      return status;
    }
    isSkipped = isSkipped && status == NodeStatus::Skipped;
    node.set<int>(0, ++child);
  }
  node.set<int>(0, 0);
  return isSkipped ? NodeStatus::Skipped : NodeStatus::Success;
}

// PauseResumeController. Children 0: while resumed; optional 1: while paused, 2: once on pause, 3:
// once on resume.

enum class PauseState : int { Resumed, Paused, OnPause, OnResume };
struct PauseMemory {
  PauseState state;
  int pauses, resumes;  // processed service calls
};

/// Number of calls of a port's service so far.
int callsOf(const ParentContext& node, int port) {
  return robotOf(node).lastMessage(node.text(port).value_or("")).number;
}

/// A call that requests the current state has no effect, as in Nav2.
void processServiceCalls(ParentContext& node, PauseMemory& memory) {
  const int pauses = callsOf(node, 0), resumes = callsOf(node, 1);
  const bool isPaused = pauses > memory.pauses, isResumed = resumes > memory.resumes;
  memory.pauses = pauses;
  memory.resumes = resumes;
  if (isPaused && memory.state == PauseState::Resumed) {
    memory.state = PauseState::OnPause;
  } else if (isResumed && memory.state == PauseState::Paused) {
    memory.state = PauseState::OnResume;
  } else {
    return;
  }
  for (int child = 0; child < node.childCount(); ++child) {
    node.resetChild(child);
  }
}

/// The next state after the child of a state has succeeded.
PauseState after(PauseState state) {
  if (state == PauseState::OnPause) {
    return PauseState::Paused;
  }
  return state == PauseState::OnResume ? PauseState::Resumed : state;
}

NodeStatus pauseResume(ParentContext& node) {
  auto& memory = node.memory<PauseMemory>();
  processServiceCalls(node, memory);
  const int child = static_cast<int>(memory.state);
  const bool isThere = child < node.childCount();
  const NodeStatus status = isThere ? node.tickChild(child) : NodeStatus::Success;
  const bool isOver = status != NodeStatus::Running && status != NodeStatus::Idle;
  if (isOver && (memory.state == PauseState::Resumed || status == NodeStatus::Failure)) {
    memory.state = PauseState::Resumed;
    return status;
  }
  if (!isOver) {
    return status;
  }
  if (isThere) {
    node.resetChild(child);
  }
  memory.state = after(memory.state);
  return NodeStatus::Running;
}

void resetPauseState(ParentContext& node) {
  node.memory<PauseMemory>().state = PauseState::Resumed;
}

constexpr const char* kNodes = R"(
Control PersistentSequence|Navigation|Runs its children one after the other and, after a failure or a halt, resumes at the same child (since Lyrical).
current_child_idx int inout default 0 suggest {current_child_idx}|Index of the next child, from 0.
Control PauseResumeController children 1 4|Navigation|Runs its first child, while paused by a service the second one. The third child runs when it is paused, the fourth one when it resumes (since Lyrical).
pause_service_name text needed suggest /pause|Service that pauses it (nav2_topics of the robot).
resume_service_name text needed suggest /resume|Service that resumes it (nav2_topics of the robot).
)";

}  // namespace

void addRobotPauseControls(NodeLibrary& to) {
  to.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
         {{"PersistentSequence", control({persistentSequence})},
          {"PauseResumeController", control<PauseMemory>({pauseResume, resetPauseState})}});
}

}  // namespace bt
