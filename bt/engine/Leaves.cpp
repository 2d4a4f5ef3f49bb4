#include "bt/engine/Ticker.h"

/// Leaves of BehaviorTree.CPP, and calls of library functions.
namespace bt {

base::NodeStatus Ticker::librarySynchronous(int node) {
  const Program::Node& here = nodes_[node];
  return synchronous(here, node, program_.functions(here.detail).tick);
}

base::NodeStatus Ticker::script(int node) {
  const int script = nodes_[node].detail;
  if (script == kEmptyScript) {
    return Status::Success;
  }
  if (script == kMissing) {
    return fault(node, "input 'code' is missing");
  }
  return runScript(node, script) ? Status::Success : kFault;
}

base::NodeStatus Ticker::scriptCondition(int node) {
  const int script = nodes_[node].detail;
  if (script == kMissing) {
    return fault(node, "input 'code' is missing");
  }
  bool truth = false;
  return !evaluateCondition(node, script, truth) ? kFault
                                                 : (truth ? Status::Success : Status::Failure);
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

/// The capacity is reserved in TreeState. A node restarted within a tick may exceed it.
void Ticker::note(int node, LeafEvent::Kind kind) {
  state_.events_.push_back({node, kind});
}

base::NodeStatus Ticker::sleep(int node) {
  auto& own = memory<TimerMemory>(node);
  const Status before = stored(node);
  if (before != Status::Idle && before != Status::Running) {
    return before;
  }
  const std::optional<std::int64_t> limit = readRequired<std::int64_t>(node, 0);
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

/// The slot of the entry that a node operates on; nullptr if no node uses it. A missing entry name
/// is a fault.
std::optional<Slot*> Ticker::target(int node, const char* port, bool isOwn) {
  int slot = nodes_[node].detail;
  if (slot <= kFirstIndirectKey) {
    const Program::IndirectKey& key = program_.indirectKey(slot);
    const std::string name = portText(state_.get(key.slot));
    slot = name.empty() ? kMissing : program_.slotOf(key.scope, name, isOwn).value_or(kUnusedEntry);
  }
  if (slot == kMissing) {
    fault(node, std::string("input '") + port + "' is missing");
    return std::nullopt;
  }
  return slot == kUnusedEntry ? nullptr : slots() + slot;
}

base::NodeStatus Ticker::setBlackboard(int node) {
  const std::optional<Slot*> to = target(node, "output_key", false);
  if (!to) {
    return kFault;
  }
  const PortBinding& binding = nodes_[node].ports[0];
  if (binding.kind == PortBinding::Kind::Missing) {
    return fault(node, "input 'value' is missing");
  }
  const bool copies = binding.kind == PortBinding::Kind::Entry;
  const Slot& from = boundSlot(copies ? slots() : program_.constants().data(), binding);
  if (copies && !from.exists) {
    return fault(node, "the entry to copy does not exist");
  }
  if (copies && *to != nullptr && !(*to)->exists) {
    (*to)->type = from.type;
    (*to)->element = from.element;
    (*to)->isObject = from.isObject;
    (*to)->exists = true;
  }
  if (copies && from.value.type == ValueType::Unset) {
    return Status::Failure;
  }
  if (*to == nullptr) {
    return Status::Success;  // no node reads it
  }
  return setBlackboardEntry(node, **to, from.value) ? Status::Success : kFault;
}

/// Text is converted to the declared type; any other value must have the type of the entry.
bool Ticker::setBlackboardEntry(int node, Slot& to, const Value& value) {
  const bool isText = value.type == ValueType::String;
  if (!isText || !to.exists || to.type == PortType::String || to.type == PortType::Any) {
    if (storeAny(to, value)) {
      return true;
    }
    fault(node, "'" + value.toText() + "' has a different type than the entry");
    return false;
  }
  const std::optional<Value> converted =
      to.type == PortType::Status ? std::nullopt : convertTo(value, to.type, to.element);
  if (converted && storeAny(to, *converted)) {
    return true;
  }
  fault(node, "'" + value.toText() + "' does not fit the type of the entry");
  return false;
}

/// Entries of other blackboards are not removed.
base::NodeStatus Ticker::unsetBlackboard(int node) {
  const std::optional<Slot*> slot = target(node, "key", true);
  if (!slot) {
    return kFault;
  }
  if (*slot != nullptr) {
    remove(**slot);  // the next entry with this name is a new one
  }
  return Status::Success;
}

bool Ticker::wasUpdated(int node, UpdateMemory& own) {
  const int slot = program_.node(node).detail;
  if (slot == kMissing) {
    fault(node, "input 'entry' is missing");
    return false;
  }
  const Slot& entry = state_.slots_[static_cast<std::size_t>(slot)];
  if (!entry.exists) {
    return false;
  }
  const std::uint32_t seen = entry.version + 1;  // 0: never read
  const bool updated = seen != own.seen;
  own.seen = seen;
  return updated;
}

}  // namespace bt
