#include "bt/engine/Ticker.h"

/// Leaves of BehaviorTree.CPP, and calls of the library's functions.
namespace bt {

base::NodeStatus Ticker::librarySynchronous(int node) {
  const Program::Node& here = nodes_[node];
  return synchronous(here, node, program_.functions(here.detail).tick);
}

base::NodeStatus Ticker::script(int node) {
  const int script = nodes_[node].detail;
  if (script < 0) {
    return fault(node, "input 'code' is missing");
  }
  return runScript(node, script) ? Status::Success : kFault;
}

base::NodeStatus Ticker::scriptCondition(int node) {
  const int script = nodes_[node].detail;
  if (script < 0) {
    return fault(node, "input 'code' is missing");
  }
  bool truth = false;
  return !truthOf(node, script, truth) ? kFault : (truth ? Status::Success : Status::Failure);
}

base::NodeStatus Ticker::wasEntryUpdated(int node) {
  const bool updated = wasUpdated(node, memory<UpdateMemory>(node));
  return isFaulty() ? kFault : (updated ? Status::Success : Status::Failure);
}

base::NodeStatus Ticker::stateful(int node) {
  const Status before = stored(node);
  const NodeFunctions& functions = program_.functions(program_.node(node).detail);
  const bool isDone = before != Status::Idle && before != Status::Running;
  if (isDone && !functions.isCalledWhenDone) {
    return before;
  }
  LeafContext context(*this, input_, node);
  const bool starts = before != Status::Running;
  const Status status =
      starts ? functions.stateful.onStart(context) : functions.stateful.onRunning(context);
  if (isFaulty()) {
    return kFault;
  }
  if (starts) {
    note(node, LeafEvent::Kind::Started);
  }
  if (status == Status::Success || status == Status::Failure) {
    note(node, status == Status::Success ? LeafEvent::Kind::Succeeded : LeafEvent::Kind::Failed);
    return status;
  }
  return status == Status::Running ? status : unexpected(node, status);
}

/// There is room: see TreeState. A node that is restarted within one tick may still fill it.
void Ticker::note(int node, LeafEvent::Kind kind) {
  state_.events_.push_back({node, kind});
}

base::NodeStatus Ticker::sleep(int node) {
  auto& own = memory<TimerMemory>(node);
  const Status before = stored(node);
  if (before != Status::Idle && before != Status::Running) {
    return before;
  }
  const std::optional<std::int64_t> limit = need<std::int64_t>(node, 0);
  if (!limit) {
    return kFault;
  }
  if (before == Status::Idle) {
    own = {input_.step, true};
    note(node, LeafEvent::Kind::Started);
  }
  if (!hasElapsed(own, *limit)) {
    return Status::Running;
  }
  note(node, LeafEvent::Kind::Succeeded);
  return Status::Success;
}

base::NodeStatus Ticker::setBlackboard(int node) {
  const int target = program_.node(node).detail;
  if (target < 0) {
    return fault(node, "input 'output_key' is missing");
  }
  const PortBinding& binding = nodes_[node].ports[0];
  if (binding.kind == PortBinding::Kind::Missing) {
    return fault(node, "input 'value' is missing");
  }
  Slot& to = state_.slots_[static_cast<std::size_t>(target)];
  const bool copies = binding.kind == PortBinding::Kind::Entry;
  if (copies) {
    const Slot& from = boundSlot(slots(), binding);
    if (!from.exists) {
      return fault(node, "the entry to copy does not exist");
    }
    if (from.value.type == ValueType::Unset) {
      return Status::Failure;
    }
    if (!to.exists && to.type == PortType::Any) {
      to.type = from.type;
    }
  }
  const Value& value = boundSlot(copies ? slots() : program_.constants().data(), binding).value;
  if (!store(to, value)) {
    return fault(node, "'" + value.toText() + "' does not fit the type of the entry");
  }
  return Status::Success;
}

base::NodeStatus Ticker::unsetBlackboard(int node) {
  const int target = program_.node(node).detail;
  if (target < 0) {
    return fault(node, "input 'key' is missing");
  }
  Slot& slot = state_.slots_[static_cast<std::size_t>(target)];
  slot.value.type = ValueType::Unset;
  slot.exists = false;
  return Status::Success;
}

bool Ticker::wasUpdated(int node, UpdateMemory& own) {
  const int slot = program_.node(node).detail;
  if (slot < 0) {
    fault(node, "input 'entry' is missing");
    return false;
  }
  const std::uint32_t version = state_.slots_[static_cast<std::size_t>(slot)].version;
  const bool updated = version != own.version;
  own.version = version;
  return updated;
}

}  // namespace bt
