#include "bt/engine/Ticker.h"

/// Control nodes, after BehaviorTree.CPP 4.10.
namespace bt {

NodeRunner Ticker::controlRunner(NodeCode code) {
  switch (code) {
    case NodeCode::Sequence:
      return [](Ticker& t, int node) { return t.sequence(node, Status::Failure, false); };
    case NodeCode::Fallback:
      return [](Ticker& t, int node) { return t.sequence(node, Status::Success, false); };
    case NodeCode::AsyncSequence:
      return [](Ticker& t, int node) { return t.sequence(node, Status::Failure, true); };
    case NodeCode::AsyncFallback:
      return [](Ticker& t, int node) { return t.sequence(node, Status::Success, true); };
    case NodeCode::SequenceWithMemory:
      return &call<&Ticker::sequenceWithMemory>;
    case NodeCode::ReactiveSequence:
      return &call<&Ticker::reactive<Status::Failure>>;
    case NodeCode::ReactiveFallback:
      return &call<&Ticker::reactive<Status::Success>>;
    case NodeCode::Parallel:
      return &call<&Ticker::parallel>;
    case NodeCode::ParallelAll:
      return &call<&Ticker::parallelAll>;
    case NodeCode::IfThenElse:
      return &call<&Ticker::ifThenElse>;
    case NodeCode::WhileDoElse:
      return &call<&Ticker::whileDoElse>;
    case NodeCode::Switch:
      return &call<&Ticker::switchCase>;
    case NodeCode::TryCatch:
      return &call<&Ticker::tryCatch>;
    default:
      return &call<&Ticker::customControl>;
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
template <base::NodeStatus stop>
base::NodeStatus Ticker::reactive(int node) {
  constexpr Status kPasses = stop == Status::Failure ? Status::Success : Status::Failure;
  stored(node) = Status::Running;
  const int end = endOf(node);
  bool allSkipped = true;
  for (int child = node + 1; child < end; child = endOf(child)) {
    const Status status = tickChild(child);
    if (status == kPasses) {
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
  return allSkipped ? Status::Skipped : kPasses;
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
