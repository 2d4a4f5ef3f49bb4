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
  int child = own.next != 0 ? own.next : node + 1;
  while (child < end) {
    const Status before = stored(child);
    const Status status = tickChild(child);
    if (status == Status::Running) {
      own.next = child;
      return status;
    }
    if (status == stop) {
      own.next = remembers ? child : 0;
      if (remembers) {
        resetFrom(child, node);
      } else {
        resetChildren(node);
      }
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
  if (allSkipped) {
    return Status::Skipped;
  }
  return stop == Status::Failure ? Status::Success : Status::Failure;
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

/// A number of children; negative ones count from all. False = a fault was noted.
bool Ticker::threshold(int node, int port, int& value) {
  const std::optional<int> given = need<int>(node, port);
  if (!given) {
    return false;
  }
  const int children = program_.node(node).children;
  value = *given < 0 ? std::max(children + *given + 1, 0) : *given;
  if (value > children) {
    fault(node, "port '" + program_.manifest(node).ports[static_cast<std::size_t>(port)].name +
                    "' is larger than the number of children");
    return false;
  }
  return true;
}

namespace {

/// The bits behind a ParallelMemory: which children are done in this run.
class DoneBits {
 public:
  explicit DoneBits(void* memory)
      : bits_(static_cast<unsigned char*>(memory) + sizeof(ParallelMemory)) {}
  bool has(int child) const { return ((bits_[child / 8] >> (child % 8)) & 1) != 0; }
  void set(int child) {
    bits_[child / 8] = static_cast<unsigned char>(bits_[child / 8] | (1 << (child % 8)));
  }

 private:
  unsigned char* bits_;
};

}  // namespace

/// False = a fault. `decided` is IDLE as long as nothing is decided.
bool Ticker::decideParallel(int node, int skipped, Status& decided) {
  const auto& own = memory<ParallelMemory>(node);
  const int children = program_.node(node).children;
  int needed = 0;
  int allowed = 0;
  if (!threshold(node, 0, needed) || !threshold(node, 1, allowed)) {
    return false;
  }
  const bool countsSkipped = *need<int>(node, 0) < 0;
  if (own.successes >= needed || (countsSkipped && own.successes + skipped >= needed)) {
    decided = Status::Success;
  } else if (children - own.failures < needed || own.failures == allowed) {
    decided = Status::Failure;
  }
  return true;
}

bool Ticker::tickParallelChildren(int node, int& skipped, bool untilDecided, Status& decided) {
  auto& own = memory<ParallelMemory>(node);
  DoneBits done(memoryOf(node));
  int number = 0;
  for (int child = node + 1; child < endOf(node); child = endOf(child), ++number) {
    if (!done.has(number)) {
      const Status status = tickChild(child);
      if (status == Status::Success || status == Status::Failure) {
        done.set(number);
        ++(status == Status::Success ? own.successes : own.failures);
      } else if (status == Status::Skipped) {
        ++skipped;
      } else if (status != Status::Running) {
        unexpected(child, status);
        return false;
      }
    }
    if (untilDecided && !decideParallel(node, skipped, decided)) {
      return false;
    }
    if (decided != Status::Idle) {
      return true;
    }
  }
  return true;
}

void Ticker::finishParallel(int node) {
  unsigned char* const bytes = static_cast<unsigned char*>(memoryOf(node));
  std::fill_n(bytes, parallelBytes(program_.node(node).children), static_cast<unsigned char>(0));
}

base::NodeStatus Ticker::parallel(int node) {
  stored(node) = Status::Running;
  int skipped = 0;
  Status decided = Status::Idle;
  if (!tickParallelChildren(node, skipped, true, decided)) {
    return kFault;
  }
  if (decided != Status::Idle) {
    finishParallel(node);
    resetChildren(node);
    return decided;
  }
  return skipped == program_.node(node).children ? Status::Skipped : Status::Running;
}

base::NodeStatus Ticker::parallelAll(int node) {
  int allowed = 0;
  if (!threshold(node, 0, allowed)) {
    return kFault;
  }
  stored(node) = Status::Running;
  int skipped = 0;
  Status undecided = Status::Idle;
  if (!tickParallelChildren(node, skipped, false, undecided)) {
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
  finishParallel(node);
  resetChildren(node);
  return own.failures >= allowed ? Status::Failure : Status::Success;
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
