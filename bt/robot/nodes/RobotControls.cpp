#include "bt/robot/RobotNodes.h"

/// Control nodes of Nav2 (nav2_behavior_tree/plugins/control).
namespace bt {
namespace {

using base::NodeStatus;
using sim2d::nav2::Distro;

struct PipelineMemory {
  int farthest;  // child that was RUNNING last
};

/// Ticks all children from the first on each time: those before the running one do their work
/// again.
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
  bool recovers;  // the second child is at work
};

/// What ends the node: its counts begin anew.
NodeStatus endRecovery(RecoveryMemory& memory, NodeStatus status) {
  memory = {};
  return status;
}

/// One child once: the status that the node returns, or IDLE when it goes on with the other child.
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

/// The first child; when it fails the second, then the first again, all in one tick.
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

/// The next child each time. Main begins anew after the last one only when it is told to.
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

/// All children in every tick, whether those before them are done or not.
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

/// ReactiveSequence (`stop` = FAILURE) and ReactiveFallback (SUCCESS). Unlike BehaviorTree.CPP 4,
/// which resets every other child when one runs, those before it keep their status, as in version
/// 3: Nav2's conditions and PathLongerOnApproach would else look for the first time in each tick
/// and never see a change.
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
void forgetMemory(ParentContext& node) {
  node.memory<Memory>() = {};
}

constexpr const char* kNodes = R"(
Control PipelineSequence|Navigation|Ticks all children from the first on until the farthest one that runs: those before it do their work again.
Control RecoveryNode children 2 2|Navigation|Runs the first child; when it fails the second, and then the first again.
number_of_retries int default 1|How often.
Control RoundRobin|Navigation|Each time the next child; fails when all have failed in a row.
wrap_around bool default false|Begins anew after the last child (Main; before, always).
Control NonblockingSequence|Navigation|Ticks all children in every step until one fails or all have succeeded.
)";

}  // namespace

void addRobotControls(NodeLibrary& to);
void addRobotControls(NodeLibrary& to) {
  const NodeCatalogue nodes = nodesOf(kNodes, NodeOrigin::Ours);
  to.addControl<PipelineMemory>(*nodes.find("PipelineSequence"),
                                {pipeline, forgetMemory<PipelineMemory>});
  to.addControl<RecoveryMemory>(*nodes.find("RecoveryNode"),
                                {recovery, forgetMemory<RecoveryMemory>});
  to.addControl<RoundMemory>(*nodes.find("RoundRobin"), {roundRobin, forgetMemory<RoundMemory>});
  to.addControl(*nodes.find("NonblockingSequence"), {nonblocking, nullptr});
  to.addControl(*to.catalogue().find("ReactiveSequence"), {reactive<NodeStatus::Failure>, nullptr});
  to.addControl(*to.catalogue().find("ReactiveFallback"), {reactive<NodeStatus::Success>, nullptr});
}

}  // namespace bt
