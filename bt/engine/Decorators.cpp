#include "bt/engine/Ticker.h"

/// Decorators, after BehaviorTree.CPP 4.10 but with simulated time. A child that is done is reset
/// by tickNode().
namespace bt {

NodeRunner Ticker::decoratorRunner(NodeCode code) {
  switch (code) {
    case NodeCode::Inverter:
      return &call<&Ticker::inverter>;
    case NodeCode::ForceSuccess:
      return [](Ticker& t, int node) { return t.force(node, Status::Success); };
    case NodeCode::ForceFailure:
      return [](Ticker& t, int node) { return t.force(node, Status::Failure); };
    case NodeCode::Repeat:
      return &call<&Ticker::repeat>;
    case NodeCode::RetryUntilSuccessful:
      return &call<&Ticker::retry>;
    case NodeCode::KeepRunningUntilFailure:
      return &call<&Ticker::keepRunning>;
    case NodeCode::Delay:
      return &call<&Ticker::delay>;
    case NodeCode::Timeout:
      return &call<&Ticker::timeout>;
    case NodeCode::RunOnce:
      return &call<&Ticker::runOnce>;
    case NodeCode::Precondition:
      return &call<&Ticker::precondition>;
    case NodeCode::Loop:
      return &call<&Ticker::loop>;
    case NodeCode::SkipUnlessUpdated:
      return [](Ticker& t, int node) { return t.ifUpdated(node, Status::Skipped); };
    case NodeCode::WaitValueUpdate:
      return [](Ticker& t, int node) { return t.ifUpdated(node, Status::Running); };
    case NodeCode::SubTree:
      return &call<&Ticker::subTree>;
    default:
      return &call<&Ticker::customDecorator>;
  }
}

base::NodeStatus Ticker::inverter(int node) {
  stored(node) = Status::Running;
  const Status status = tickNode(node + 1);
  if (status == Status::Success) {
    return Status::Failure;
  }
  if (status == Status::Failure) {
    return Status::Success;
  }
  return status == Status::Idle ? unexpected(node + 1, status) : status;
}

base::NodeStatus Ticker::force(int node, Status result) {
  stored(node) = Status::Running;
  const Status status = tickNode(node + 1);
  if (status == Status::Success || status == Status::Failure) {
    return result;
  }
  return status == Status::Idle ? unexpected(node + 1, status) : status;
}

base::NodeStatus Ticker::repeat(int node) {
  const std::optional<int> cycles = need<int>(node, 0);
  if (!cycles) {
    return kFault;
  }
  auto& own = memory<CountMemory>(node);
  const int child = node + 1;
  stored(node) = Status::Running;
  while (own.count < *cycles || *cycles == -1) {
    const Status before = stored(child);
    const Status status = tickNode(child);
    if (status == Status::Running) {
      return status;
    }
    if (status == Status::Failure) {
      own.count = 0;
      return status;
    }
    if (status == Status::Skipped) {
      resetChild(child);
      return status;
    }
    if (status != Status::Success) {
      return unexpected(child, status);
    }
    resetChild(child);
    own.count = *cycles == -1 ? 0 : own.count + 1;
    if (before == Status::Idle && (own.count < *cycles || *cycles == -1)) {
      return Status::Running;
    }
  }
  own.count = 0;
  return Status::Success;
}

base::NodeStatus Ticker::retry(int node) {
  std::optional<int> attempts = need<int>(node, 0);
  auto& own = memory<CountMemory>(node);
  const int child = node + 1;
  stored(node) = Status::Running;
  while (attempts && (own.count < *attempts || *attempts == -1)) {
    const Status before = stored(child);
    const Status status = tickNode(child);
    if (status == Status::Running) {
      return status;
    }
    if (status == Status::Success) {
      own.count = 0;
      return status;
    }
    if (status == Status::Skipped) {
      resetChild(child);
      return status;
    }
    if (status != Status::Failure) {
      return unexpected(child, status);
    }
    resetChild(child);
    attempts = need<int>(node, 0);  // the child may have changed it
    if (!attempts) {
      return kFault;
    }
    own.count = *attempts == -1 ? 0 : own.count + 1;
    if (before == Status::Idle && (own.count < *attempts || *attempts == -1)) {
      return Status::Running;
    }
  }
  own.count = 0;
  return attempts ? Status::Failure : kFault;
}

base::NodeStatus Ticker::keepRunning(int node) {
  stored(node) = Status::Running;
  const Status status = tickNode(node + 1);
  if (status == Status::Idle || status == kFault) {
    return unexpected(node + 1, status);
  }
  return status == Status::Failure ? status : Status::Running;
}

base::NodeStatus Ticker::delay(int node) {
  auto& own = memory<TimerMemory>(node);
  const std::optional<std::int64_t> limit = need<std::int64_t>(node, 0);
  if (!limit) {
    return kFault;
  }
  if (!own.started) {
    own = {input_.step, true};
  }
  stored(node) = Status::Running;
  if (!hasElapsed(own, *limit)) {
    return Status::Running;
  }
  const Status status = tickNode(node + 1);
  if (status == Status::Idle) {
    return unexpected(node + 1, status);
  }
  own.started = status == Status::Running || status == Status::Skipped;
  return status;
}

base::NodeStatus Ticker::timeout(int node) {
  auto& own = memory<TimerMemory>(node);
  const std::optional<std::int64_t> limit = need<std::int64_t>(node, 0);
  if (!limit) {
    return kFault;
  }
  if (!own.started) {
    own = {input_.step, true};
  }
  stored(node) = Status::Running;
  const int child = node + 1;
  if (*limit > 0 && stored(child) == Status::Running && hasElapsed(own, *limit)) {
    resetChild(child);
    own.started = false;
    return Status::Failure;
  }
  const Status status = tickNode(child);
  if (status == Status::Idle) {
    return unexpected(child, status);
  }
  own.started = status == Status::Running || status == Status::Skipped;
  return status;
}

base::NodeStatus Ticker::runOnce(int node) {
  auto& own = memory<RunOnceMemory>(node);
  if (own.result != Status::Idle) {
    const std::optional<bool> skips = need<bool>(node, 0);
    return !skips ? kFault : (*skips ? Status::Skipped : own.result);
  }
  stored(node) = Status::Running;
  const Status status = tickNode(node + 1);
  if (status == Status::Success || status == Status::Failure) {
    own.result = status;
  }
  return status == Status::Idle ? unexpected(node + 1, status) : status;
}

base::NodeStatus Ticker::subTree(int node) {
  if (stored(node) == Status::Idle) {
    stored(node) = Status::Running;
  }
  const Status status = tickNode(node + 1);
  return status == Status::Idle ? unexpected(node + 1, status) : status;
}

base::NodeStatus Ticker::customDecorator(int node) {
  DecoratorContext context(*this, input_, node);
  const Status status = program_.functions(program_.node(node).detail).decorator.tick(context);
  if (isFaulty()) {
    return kFault;
  }
  return status == Status::Idle ? fault(node, "it returned IDLE") : status;
}

}  // namespace bt
