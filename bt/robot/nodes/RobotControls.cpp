#include "bt/robot/RobotNodes.h"

/// Control nodes of Nav2 (nav2_behavior_tree/plugins/control).
namespace bt {
namespace {

using base::NodeStatus;
using sim2d::nav2::Distro;

struct PipelineMemory {
  int farthest;  // last running child
};

/// Ticks all children from the first one in every tick; children before the running one run again.
NodeStatus pipeline(ParentContext& node) {
  int& farthest = node.memory<PipelineMemory>().farthest;
  int skipped = 0;
  for (int child = 0; child < node.childCount(); ++child) {
    const NodeStatus status = node.tickChild(child);
    if (status == NodeStatus::Failure) {
      farthest = 0;
      return status;
    }
    if (status == NodeStatus::Running && child >= farthest) {
      farthest = child;
      return status;
    }
    if (status == NodeStatus::Idle) {
      return status;
    }
    skipped += status == NodeStatus::Skipped ? 1 : 0;
  }
  farthest = 0;
  return skipped == node.childCount() ? NodeStatus::Skipped : NodeStatus::Success;
}

struct RecoveryMemory {
  int retries;
  bool recovers;  // the second child is running
};

/// Ends the node and resets its counts.
NodeStatus endRecovery(RecoveryMemory& memory, NodeStatus status) {
  memory = {};
  return status;
}

/// Ticks one child: returns the node's status, or IDLE if it continues with the other child.
NodeStatus recoveryStep(ParentContext& node, RecoveryMemory& memory, int most) {
  const NodeStatus status = node.tickChild(memory.recovers ? 1 : 0);
  if (status == NodeStatus::Running) {
    return status;
  }
  if (memory.recovers) {
    if (status != NodeStatus::Success) {
      return endRecovery(memory, NodeStatus::Failure);
    }
    node.resetChild(1);
    ++memory.retries;
    memory.recovers = false;
    return NodeStatus::Idle;
  }
  if (status != NodeStatus::Failure || memory.retries >= most) {
    return endRecovery(memory, status);
  }
  node.resetChild(0);
  memory.recovers = true;
  return NodeStatus::Idle;
}

/// Runs the first child; on failure the second, then the first again, all within one tick.
NodeStatus recovery(ParentContext& node) {
  auto& memory = node.memory<RecoveryMemory>();
  const int most = node.getOr<int>(0, 1);
  NodeStatus status = NodeStatus::Idle;
  while (status == NodeStatus::Idle && memory.retries <= most) {
    status = recoveryStep(node, memory, most);
  }
  return status == NodeStatus::Idle ? endRecovery(memory, NodeStatus::Failure) : status;
}

struct RoundMemory {
  int current;
  int failed;  // in a row
};

/// Ticks the next child each time. Since Lyrical it restarts after the last child only if
/// configured.
NodeStatus roundRobin(ParentContext& node) {
  auto& memory = node.memory<RoundMemory>();
  const int children = node.childCount();
  const bool wraps = robotOf(node).distro() < Distro::Lyrical || node.getOr<bool>(0, false);
  int skipped = 0;
  while (memory.failed + skipped < children) {
    const NodeStatus status = node.tickChild(memory.current);
    if (status == NodeStatus::Running || status == NodeStatus::Idle) {
      return status;
    }
    ++memory.current;
    if (memory.current == children && !wraps) {
      break;
    }
    memory.current %= children;
    if (status == NodeStatus::Success) {
      memory.failed = 0;
      return status;
    }
    ++(status == NodeStatus::Failure ? memory.failed : skipped);
  }
  memory = {};
  return skipped == children ? NodeStatus::Skipped : NodeStatus::Failure;
}

/// Ticks all children in every tick, regardless of preceding statuses.
NodeStatus nonblocking(ParentContext& node) {
  int succeeded = 0, skipped = 0;
  for (int child = 0; child < node.childCount(); ++child) {
    const NodeStatus status = node.tickChild(child);
    if (status == NodeStatus::Failure || status == NodeStatus::Idle) {
      return status;
    }
    succeeded += status == NodeStatus::Success ? 1 : 0;
    skipped += status == NodeStatus::Skipped ? 1 : 0;
  }
  if (skipped == node.childCount()) {
    return NodeStatus::Skipped;
  }
  return succeeded + skipped == node.childCount() ? NodeStatus::Success : NodeStatus::Running;
}

/// ReactiveSequence (`stop` = FAILURE) and ReactiveFallback (SUCCESS). BehaviorTree.CPP 4 resets
/// every other child while one is running. Here children before it keep their status, as in version
/// 3; otherwise Nav2's conditions and PathLongerOnApproach would restart in each tick and never
/// detect a change.
template <NodeStatus stop>
NodeStatus reactive(ParentContext& node) {
  int skipped = 0;
  for (int child = 0; child < node.childCount(); ++child) {
    const NodeStatus status = node.tickChild(child);
    if (status == NodeStatus::Running) {
      for (int later = child + 1; later < node.childCount(); ++later) {
        node.resetChild(later);
      }
      return status;
    }
    if (status == stop || status == NodeStatus::Idle) {
      return status;
    }
    skipped += status == NodeStatus::Skipped ? 1 : 0;
  }
  constexpr NodeStatus kPasses =
      stop == NodeStatus::Failure ? NodeStatus::Success : NodeStatus::Failure;
  return skipped == node.childCount() ? NodeStatus::Skipped : kPasses;
}

template <class Memory>
void resetMemory(ParentContext& node) {
  node.memory<Memory>() = {};
}

constexpr const char* kNodes = R"(
Control PipelineSequence|Navigation|Ticks all children from the first one to the running one; the children before it are executed again.
Control RecoveryNode children 2 2|Navigation|Runs the first child; if it fails, runs the second child and then the first one again.
number_of_retries int default 1|Maximum number of retries.
Control RoundRobin|Navigation|Runs the next child each time; fails if all have failed in sequence.
wrap_around bool default false|Restarts at the first child after the last one (Main; earlier branches always do).
Control NonblockingSequence|Navigation|Ticks all children in every time step until one fails or all have succeeded.
)";

}  // namespace

void addRobotControls(NodeLibrary& to);
void addRobotControls(NodeLibrary& to) {
  const NodeCatalogue nodes = parseNodeCatalogue(kNodes, NodeOrigin::Ours);
  to.addControl<PipelineMemory>(*nodes.find("PipelineSequence"),
                                {pipeline, resetMemory<PipelineMemory>});
  to.addControl<RecoveryMemory>(*nodes.find("RecoveryNode"),
                                {recovery, resetMemory<RecoveryMemory>});
  to.addControl<RoundMemory>(*nodes.find("RoundRobin"), {roundRobin, resetMemory<RoundMemory>});
  to.addControl(*nodes.find("NonblockingSequence"), {nonblocking, nullptr});
  to.addControl(*to.catalogue().find("ReactiveSequence"), {reactive<NodeStatus::Failure>, nullptr});
  to.addControl(*to.catalogue().find("ReactiveFallback"), {reactive<NodeStatus::Success>, nullptr});
}

}  // namespace bt
