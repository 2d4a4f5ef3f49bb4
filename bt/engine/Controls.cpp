#include <algorithm>
#include <cmath>

#include "bt/engine/ScriptRunner.h"
#include "bt/engine/Ticker.h"
#include "sim2d/base/Text.h"

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
    default:
      return tryCatch(node);
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
    const Status status = tickNode(child);
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
    const Status status = tickNode(child);
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
  bool allSkipped = true;
  for (int child = node + 1; child < endOf(node); child = endOf(child)) {
    const Status status = tickNode(child);
    if (status == Status::Running) {
      for (int other = node + 1; other < endOf(node); other = endOf(other)) {
        if (other != child) {
          resetChild(other);
        }
      }
      return status;
    }
    if (status == stop) {
      resetChildren(node);
      return status;
    }
    if (status == Status::Skipped) {
      resetChild(child);
      continue;
    }
    if (status != Status::Success && status != Status::Failure) {
      return unexpected(child, status);
    }
    allSkipped = false;
  }
  resetChildren(node);
  if (allSkipped) {
    return Status::Skipped;
  }
  return stop == Status::Failure ? Status::Success : Status::Failure;
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
      const Status status = tickNode(child);
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
  const int count = memoryBytesOf(NodeCode::Parallel, program_.node(node).children);
  std::fill(bytes, bytes + count, static_cast<unsigned char>(0));
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

base::NodeStatus Ticker::ifThenElse(int node) {
  stored(node) = Status::Running;
  auto& own = memory<BranchMemory>(node);
  const int condition = node + 1;
  const int first = endOf(condition);
  if (own.branch == 0) {
    const Status status = tickNode(condition);
    if (status == Status::Running) {
      return status;
    }
    if (status == Status::Success) {
      own.branch = first;
    } else if (status == Status::Failure && endOf(first) == endOf(node)) {
      resetChildren(node);  // the original keeps a stale FAILURE of a stateful condition
      return status;
    } else if (status == Status::Failure) {
      own.branch = endOf(first);
    } else {
      return unexpected(condition, status);
    }
  }
  const Status status = tickNode(own.branch);
  if (status == Status::Running || status == kFault) {
    return status;
  }
  resetChildren(node);
  own.branch = 0;
  return status;
}

base::NodeStatus Ticker::whileDoElse(int node) {
  stored(node) = Status::Running;
  const int condition = node + 1;
  const int first = endOf(condition);
  const int second = endOf(first);
  const bool hasElse = second < endOf(node);
  const Status asked = tickNode(condition);
  if (asked == Status::Running) {
    return asked;
  }
  if (asked != Status::Success && asked != Status::Failure) {
    return unexpected(condition, asked);
  }
  if (asked == Status::Success && hasElse) {
    resetChild(second);
  } else if (asked == Status::Failure) {
    resetChild(first);
    if (!hasElse) {
      return asked;
    }
  }
  const int chosen = asked == Status::Success ? first : second;
  const Status status = tickNode(chosen);
  if (status == Status::Running || status == kFault) {
    return status;
  }
  resetChildren(node);
  return status;
}

namespace {

/// As text, else as whole numbers, else as reals.
bool sameCase(const Value& a, const Value& b) {
  if (a.type == ValueType::String && b.type == ValueType::String && a.text == b.text) {
    return true;
  }
  const auto number = [](const Value& value) {
    return value.type == ValueType::String ? base::parseDouble(value.text)
                                           : std::optional<double>(value.number());
  };
  const std::optional<double> x = number(a);
  const std::optional<double> y = number(b);
  if (!x || !y) {
    return false;
  }
  return std::fabs(*x - *y) <= kScriptTolerance;
}

}  // namespace

/// Node of the child that the variable selects.
int Ticker::selectedCase(int node) {
  const Value* const variable = portValue(node, 0);
  const int last = program_.node(node).children;  // cases and the default
  int child = node + 1;
  for (int i = 1; i < last; ++i, child = endOf(child)) {
    const Value* const value = portValue(node, i);
    if (variable && value && sameCase(*variable, *value)) {
      return child;
    }
  }
  return child;
}

base::NodeStatus Ticker::switchCase(int node) {
  auto& own = memory<BranchMemory>(node);
  const int child = selectedCase(node);
  if (own.branch != 0 && own.branch != child) {
    resetChild(own.branch);
  }
  const Status status = tickNode(child);
  if (status == Status::Idle || status == kFault) {
    return unexpected(child, status);
  }
  own.branch = status == Status::Running ? child : 0;
  if (status == Status::Success || status == Status::Failure) {
    resetChildren(node);
  }
  return status;
}

base::NodeStatus Ticker::tryCatch(int node) {
  stored(node) = Status::Running;
  int last = node + 1;
  while (endOf(last) < endOf(node)) {
    last = endOf(last);
  }
  if (memory<TryCatchMemory>(node).catching) {
    return catchChild(node, last);
  }
  return tryChildren(node, last);
}

base::NodeStatus Ticker::tryChildren(int node, int last) {
  auto& own = memory<TryCatchMemory>(node);
  int child = own.next != 0 ? own.next : node + 1;
  while (child < last) {
    own.next = child;
    const Status status = tickNode(child);
    if (status == Status::Running) {
      return status;
    }
    if (status == Status::Failure) {
      for (int tried = node + 1; tried < last; tried = endOf(tried)) {
        resetChild(tried);
      }
      own.catching = true;
      return catchChild(node, last);
    }
    if (status != Status::Success && status != Status::Skipped) {
      return unexpected(child, status);
    }
    own.skipped += status == Status::Skipped ? 1 : 0;
    child = endOf(child);
  }
  const bool allSkipped = own.skipped == program_.node(node).children - 1;
  resetChildren(node);
  own = TryCatchMemory();
  return allSkipped ? Status::Skipped : Status::Success;
}

base::NodeStatus Ticker::catchChild(int node, int last) {
  const Status status = tickNode(last);
  if (status == Status::Running) {
    return status;
  }
  if (status == Status::Idle || status == kFault) {
    return unexpected(last, status);
  }
  resetChildren(node);
  memory<TryCatchMemory>(node) = TryCatchMemory();
  return Status::Failure;
}

void Ticker::haltTryCatch(int node) {
  auto& own = memory<TryCatchMemory>(node);
  const bool trying = !own.catching;
  resetChildren(node);
  own = TryCatchMemory();
  const Value* const port = portValue(node, 0);
  const bool catches = port && toBool(*port).value_or(false);
  if (!trying || !catches || isFaulty()) {
    return;
  }
  int last = node + 1;
  while (endOf(last) < endOf(node)) {
    last = endOf(last);
  }
  tickNode(last);
  resetChild(last);
}

}  // namespace bt
