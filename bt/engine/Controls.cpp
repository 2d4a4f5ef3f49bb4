#include <algorithm>
#include <cmath>

#include "bt/engine/Ticker.h"
#include "sim2d/base/Text.h"

/// Control nodes, after BehaviorTree.CPP 4.10.
namespace bt {

/// Sequence (`stop` = FAILURE) and Fallback (SUCCESS). `yields`: at most one child per tick that
/// completes immediately. `remembers`: the next round resumes at the child that stopped it.
template <base::NodeStatus stop, bool yields, bool remembers>
base::NodeStatus Ticker::sequence(int node) {
  auto& own = memory<SequenceMemory>(node);
  if (stored(node) == Status::Idle) {
    own.skipped = 0;
  }
  stored(node) = Status::Running;
  const int end = endOf(node);
  int child = std::max(own.next, node + 1);  // 0: start at the first
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
  return allSkipped ? Status::Skipped : kContinueStatus<stop>;
}

/// Starts at the first child in every tick.
template <base::NodeStatus stop>
base::NodeStatus Ticker::reactive(int node) {
  stored(node) = Status::Running;
  const int end = endOf(node);
  bool allSkipped = true;
  for (int child = node + 1; child < end; child = endOf(child)) {
    const Status status = tickChild(child);
    if (status == kContinueStatus<stop>) {
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
  return allSkipped ? Status::Skipped : kContinueStatus<stop>;
}

void Ticker::resetOthers(int node, int kept) {
  for (int other = node + 1; other < endOf(node); other = endOf(other)) {
    if (other != kept) {
      resetChild(other);
    }
  }
}

/// A number of children; negative values count from the total. Negative result: a fault was raised.
int Ticker::threshold(int node, int port) {
  const std::optional<int> given = readRequired<int>(node, port);
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

/// IDLE: undecided.
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

/// Ticks the children that have not finished in this run; with limits, until the result is decided.
/// IDLE: undecided.
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
  limits.countsSkipped = readRequired<int>(node, 0).value_or(0) < 0;
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
    return fault(node, "the node returned IDLE");
  }
  if (status != Status::Running) {
    resetChildren(node);
  }
  return status;
}

/// Control nodes that select one of their children.

base::NodeStatus Ticker::ifThenElse(int node) {
  stored(node) = Status::Running;
  auto& branch = memory<std::int32_t>(node);
  const int condition = node + 1;
  const int first = endOf(condition);
  if (branch == 0) {
    const Status status = tickChild(condition);
    if (status == Status::Running) {
      return status;
    }
    if (status == Status::Success) {
      branch = first;
    } else if (status == Status::Failure && endOf(first) == endOf(node)) {
      resetChildren(node);  // BehaviorTree.CPP keeps a stale FAILURE of a stateful condition
      return status;
    } else if (status == Status::Failure) {
      branch = endOf(first);
    } else {
      return unexpected(condition, status);
    }
  }
  const Status status = tickChild(branch);
  if (status == Status::Running || status == kFault) {
    return status;
  }
  resetChildren(node);
  branch = 0;
  return status;
}

base::NodeStatus Ticker::whileDoElse(int node) {
  stored(node) = Status::Running;
  const int condition = node + 1;
  const int first = endOf(condition);
  const int second = endOf(first);
  const bool hasElse = second < endOf(node);
  const Status asked = tickChild(condition);
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
      resetChildren(node);  // as above
      return asked;
    }
  }
  const int chosen = asked == Status::Success ? first : second;
  const Status status = tickChild(chosen);
  if (status == Status::Running || status == kFault) {
    return status;
  }
  resetChildren(node);
  return status;
}

namespace {

/// Compares as text, otherwise as numbers.
bool sameCase(std::string_view a, std::string_view b) {
  if (a == b) {
    return true;
  }
  const std::optional<double> x = base::parseDouble(a);
  const std::optional<double> y = base::parseDouble(b);
  return x && y && std::fabs(*x - *y) <= kScriptTolerance;
}

}  // namespace

/// The child node that the variable selects.
int Ticker::selectedCase(int node) {
  const std::optional<std::string_view> variable = textOf(node, 0);
  const int last = program_.node(node).children;  // cases and default
  int child = node + 1;
  for (int i = 1; i < last; ++i, child = endOf(child)) {
    const std::optional<std::string_view> value = textOf(node, i);
    if (variable && value && sameCase(*variable, *value)) {
      return child;
    }
  }
  return child;
}

base::NodeStatus Ticker::switchCase(int node) {
  auto& branch = memory<std::int32_t>(node);
  const int child = selectedCase(node);
  if (branch != 0 && branch != child) {
    resetChild(branch);
  }
  const Status status = tickChild(child);
  if (status == Status::Idle || status == kFault) {
    return unexpected(child, status);
  }
  branch = status == Status::Running ? child : 0;
  if (isDone(status)) {
    resetChildren(node);
  }
  return status;
}

int Ticker::lastChild(int node) const {
  int last = node + 1;
  while (endOf(last) < endOf(node)) {
    last = endOf(last);
  }
  return last;
}

base::NodeStatus Ticker::tryCatch(int node) {
  stored(node) = Status::Running;
  const int last = lastChild(node);
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
    const Status status = tickChild(child);
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
  const Status status = tickChild(last);
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

void Ticker::haltTryCatch(Ticker& ticker, int node) {
  const bool trying = !ticker.memory<TryCatchMemory>(node).catching;
  forget<TryCatchMemory>(ticker, node);
  const Value* const port = ticker.portValue(node, 0);
  const bool catches = port && valueAs<bool>(*port).value_or(false);
  if (!trying || !catches || ticker.isFaulty()) {
    return;
  }
  const int last = ticker.lastChild(node);
  ticker.tickChild(last);
  ticker.resetChild(last);
}

}  // namespace bt
