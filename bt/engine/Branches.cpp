#include <cmath>

#include "bt/engine/Ticker.h"
#include "sim2d/base/Text.h"

/// Controls that choose one of their children.
namespace bt {

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
      resetChildren(node);  // the original keeps a stale FAILURE of a stateful condition
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

/// Compares as text, else as numbers.
bool sameCase(std::string_view a, std::string_view b) {
  if (a == b) {
    return true;
  }
  const std::optional<double> x = base::parseDouble(a);
  const std::optional<double> y = base::parseDouble(b);
  return x && y && std::fabs(*x - *y) <= kScriptTolerance;
}

}  // namespace

/// Node of the child that the variable selects.
int Ticker::selectedCase(int node) {
  const std::optional<std::string_view> variable = textOf(node, 0);
  const int last = program_.node(node).children;  // cases and the default
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
  if (status == Status::Success || status == Status::Failure) {
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
