#include <algorithm>

#include "bt/engine/Ticker.h"

/// Control nodes, after BehaviorTree.CPP 4.10.
namespace bt {

/// Sequence (`stop` = FAILURE) and Fallback (SUCCESS). `yields`: at most one child that completes
/// at once per tick. `remembers`: the next round goes on at the child that stopped it.
template <base::NodeStatus stop, bool yields, bool remembers>
base::NodeStatus Ticker::sequence(int node) {
  auto& own = memory<SequenceMemory>(node);
  if (stored(node) == Status::Idle) {
    own.skipped = 0;
  }
  stored(node) = Status::Running;
  const int end = endOf(node);
  int child = std::max(own.next, node + 1);  // 0: at the first
  while (child < end) {
    const Status before = stored(child);
    const Status status = tickChild(child);
    if (status == Status::Running) {
      own.next = child;
      return status;
    }
    if (status == stop) {
      own.next = remembers ? child : 0;
      resetFrom(remembers ? child : node + 1, node);
      return status;
    }
    if (!isDone(status) && status != Status::Skipped) {
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
  const bool allSkipped = own.skipped == program_.node(node).children;
  resetChildren(node);
  own = SequenceMemory();
  return allSkipped ? Status::Skipped : kPasses<stop>;
}

/// Starts at the first child in every tick.
template <base::NodeStatus stop>
base::NodeStatus Ticker::reactive(int node) {
  stored(node) = Status::Running;
  const int end = endOf(node);
  bool allSkipped = true;
  for (int child = node + 1; child < end; child = endOf(child)) {
    const Status status = tickChild(child);
    if (status == kPasses<stop>) {
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
  return allSkipped ? Status::Skipped : kPasses<stop>;
}

void Ticker::resetOthers(int node, int kept) {
  for (int other = node + 1; other < endOf(node); other = endOf(other)) {
    if (other != kept) {
      resetChild(other);
    }
  }
}

/// A number of children; negative ones count from all. Below 0 = a fault was noted.
int Ticker::threshold(int node, int port) {
  const std::optional<int> given = need<int>(node, port);
  if (!given) {
    return -1;
  }
  const int children = program_.node(node).children;
  const int value = *given < 0 ? std::max(children + *given + 1, 0) : *given;
  if (value > children) {
    fault(node, "port '" + program_.manifest(node).ports[static_cast<std::size_t>(port)].key +
                    "' is larger than the number of children");
    return -1;
  }
  return value;
}

/// IDLE as long as nothing is decided.
base::NodeStatus Ticker::decideParallel(int node, int skipped, const Thresholds& limits) {
  const auto& own = memory<ParallelMemory>(node);
  const int counted = own.successes + (limits.countsSkipped ? skipped : 0);
  if (counted >= limits.successes) {
    return Status::Success;
  }
  const int children = program_.node(node).children;
  const bool hasFailed =
      children - own.failures < limits.successes || own.failures == limits.failures;
  return hasFailed ? Status::Failure : Status::Idle;
}

/// Ticks the children that have not finished in this run, with limits until the result is decided.
/// IDLE = it is not decided.
base::NodeStatus Ticker::tickParallelChildren(int node, int& skipped, const Thresholds* limits) {
  auto& own = memory<ParallelMemory>(node);
  auto* const bits = static_cast<unsigned char*>(memoryOf(node)) + sizeof(ParallelMemory);
  int number = 0;
  for (int child = node + 1; child < endOf(node); child = endOf(child), ++number) {
    unsigned char& byte = bits[number / 8];
    const unsigned bit = 1U << (number % 8);
    const Status status = (byte & bit) == 0 ? tickChild(child) : Status::Running;
    if (isDone(status)) {
      byte = static_cast<unsigned char>(byte | bit);
      ++(status == Status::Success ? own.successes : own.failures);
    } else if (status == Status::Skipped) {
      ++skipped;
    } else if (status != Status::Running) {
      return unexpected(child, status);
    }
    const Status decided = limits ? decideParallel(node, skipped, *limits) : Status::Idle;
    if (decided != Status::Idle) {
      return decided;
    }
  }
  return Status::Idle;
}

void Ticker::haltParallel(Ticker& ticker, int node) {
  unsigned char* const bytes = static_cast<unsigned char*>(ticker.memoryOf(node));
  std::fill_n(bytes, parallelBytes(ticker.nodes_[node].children), static_cast<unsigned char>(0));
  ticker.resetChildren(node);
}

base::NodeStatus Ticker::parallel(int node) {
  Thresholds limits;
  limits.successes = threshold(node, 0);
  limits.failures = limits.successes < 0 ? -1 : threshold(node, 1);
  if (limits.failures < 0) {
    return kFault;
  }
  limits.countsSkipped = need<int>(node, 0).value_or(0) < 0;
  stored(node) = Status::Running;
  int skipped = 0;
  const Status decided = tickParallelChildren(node, skipped, &limits);
  if (isDone(decided)) {
    haltParallel(*this, node);
  }
  if (decided != Status::Idle) {
    return decided;
  }
  return skipped == program_.node(node).children ? Status::Skipped : Status::Running;
}

base::NodeStatus Ticker::parallelAll(int node) {
  const int allowed = threshold(node, 0);
  if (allowed < 0) {
    return kFault;
  }
  stored(node) = Status::Running;
  int skipped = 0;
  if (tickParallelChildren(node, skipped, nullptr) == kFault) {
    return kFault;
  }
  const ParallelMemory own = memory<ParallelMemory>(node);
  const int children = program_.node(node).children;
  if (skipped == children) {
    return Status::Skipped;
  }
  if (own.successes + own.failures + skipped < children) {
    return Status::Running;
  }
  haltParallel(*this, node);
  return own.failures >= allowed ? Status::Failure : Status::Success;
}

base::NodeStatus Ticker::customControl(int node) {
  stored(node) = Status::Running;
  ParentContext context(*this, input_, node);
  const Status status = functionsOf(node).parent.tick(context);
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
