#include "bt/engine/Ticker.h"

/// Control nodes, after BehaviorTree.CPP 4.10.
namespace bt {

base::NodeStatus Ticker::runControl(int node) {
  switch (program_.node(node).code) {
    case NodeCode::Sequence:
      return sequence(node, Status::Failure, false);
    case NodeCode::Fallback:
      return sequence(node, Status::Success, false);
    case NodeCode::AsyncSequence:
      return sequence(node, Status::Failure, true);
    case NodeCode::AsyncFallback:
      return sequence(node, Status::Success, true);
    case NodeCode::SequenceWithMemory:
      return sequenceWithMemory(node);
    case NodeCode::ReactiveSequence:
      return reactive(node, Status::Failure);
    case NodeCode::ReactiveFallback:
      return reactive(node, Status::Success);
    case NodeCode::Parallel:
      return parallel(node);
    case NodeCode::ParallelAll:
      return parallelAll(node);
    case NodeCode::IfThenElse:
      return ifThenElse(node);
    case NodeCode::WhileDoElse:
      return whileDoElse(node);
    case NodeCode::Switch:
      return switchCase(node);
    case NodeCode::TryCatch:
      return tryCatch(node);
    default:
      return customControl(node);
  }
}

/// Sequence (`stop` = FAILURE) and Fallback (SUCCESS). `yields`: at most one child that completes
/// at once per tick.
base::NodeStatus Ticker::sequence(int node, Status stop, bool yields) {
  auto& own = memory<SequenceMemory>(node);
  if (stored(node) == Status::Idle) {
    own.skipped = 0;
  }
  stored(node) = Status::Running;
  const int end = endOf(node);
  int child = own.next != 0 ? own.next : node + 1;
  while (child < end) {
    const Status before = stored(child);
    const Status status = tickChild(child);
    if (status == Status::Running) {
      own.next = child;
      return status;
    }
    if (status == stop) {
      resetChildren(node);
      own.next = 0;
      return status;
    }
    if (status != Status::Success && status != Status::Failure && status != Status::Skipped) {
      return unexpected(child, status);
    }
    child = endOf(child);
    if (status == Status::Skipped) {
      ++own.skipped;
    } else if (yields && before == Status::Idle && child < end) {
      own.next = child;
      return Status::Running;
    }
  }
  return finishSequence(node, own, stop);
}

base::NodeStatus Ticker::finishSequence(int node, SequenceMemory& own, Status stop) {
  const bool allSkipped = own.skipped == program_.node(node).children;
  resetChildren(node);
  own = SequenceMemory();
  if (allSkipped) {
    return Status::Skipped;
  }
  return stop == Status::Failure ? Status::Success : Status::Failure;
}

base::NodeStatus Ticker::sequenceWithMemory(int node) {
  auto& own = memory<SequenceMemory>(node);
  if (stored(node) == Status::Idle) {
    own.skipped = 0;
  }
  stored(node) = Status::Running;
  const int end = endOf(node);
  int child = own.next != 0 ? own.next : node + 1;
  while (child < end) {
    own.next = child;
    const Status before = stored(child);
    const Status status = tickChild(child);
    if (status == Status::Running) {
      return status;
    }
    if (status == Status::Failure) {
      for (int rest = child; rest < end; rest = endOf(rest)) {
        resetChild(rest);
      }
      return status;
    }
    if (status != Status::Success && status != Status::Skipped) {
      return unexpected(child, status);
    }
    child = endOf(child);
    if (status == Status::Skipped) {
      ++own.skipped;
    } else if (before == Status::Idle && child < end) {
      own.next = child;
      return Status::Running;
    }
  }
  return finishSequence(node, own, Status::Failure);
}

/// Starts at the first child in every tick.
base::NodeStatus Ticker::reactive(int node, Status stop) {
  stored(node) = Status::Running;
  const Status passes = stop == Status::Failure ? Status::Success : Status::Failure;
  const int end = endOf(node);
  bool allSkipped = true;
  for (int child = node + 1; child < end; child = endOf(child)) {
    const Status status = tickChild(child);
    if (status == passes) {
      allSkipped = false;
      continue;
    }
    if (status == Status::Running) {
      resetOthers(node, child);
      return status;
    }
    if (status == stop) {
      resetChildren(node);
      return status;
    }
    if (status != Status::Skipped) {
      return unexpected(child, status);
    }
    resetChild(child);
  }
  resetChildren(node);
  return allSkipped ? Status::Skipped : passes;
}

void Ticker::resetOthers(int node, int kept) {
  for (int other = node + 1; other < endOf(node); other = endOf(other)) {
    if (other != kept) {
      resetChild(other);
    }
  }
}

base::NodeStatus Ticker::customControl(int node) {
  stored(node) = Status::Running;
  ControlContext context(*this, input_, node);
  const Status status = program_.functions(program_.node(node).detail).control.tick(context);
  if (isFaulty()) {
    return kFault;
  }
  if (status == Status::Idle) {
    return fault(node, "it returned IDLE");
  }
  if (status != Status::Running) {
    resetChildren(node);
  }
  return status;
}

}  // namespace bt
