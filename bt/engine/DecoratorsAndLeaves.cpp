#include <algorithm>

#include "bt/engine/Ticker.h"

/// Decorators and leaves of BehaviorTree.CPP 4.10 with simulated time. tickNode() resets a child
/// that is done.
namespace bt {

base::NodeStatus Ticker::inverter(int node) {
  const Status status = tickOnlyChild(node);
  if (status == Status::Success) {
    return Status::Failure;
  }
  return status == Status::Failure ? Status::Success : status;
}

template <base::NodeStatus result>
base::NodeStatus Ticker::force(int node) {
  const Status status = tickOnlyChild(node);
  return isDone(status) ? result : status;
}

/// Ticks the child again; the decorator may continue if it returns `again`.
template <base::NodeStatus again>
base::NodeStatus Ticker::tickRepetition(int child, std::int32_t& count) {
  const Status status = tickNode(child);
  if (status == Status::Running) {
    return status;
  }
  if (isDone(status) && status != again) {
    count = 0;
    return status;
  }
  if (!isDone(status) && status != Status::Skipped) {
    return unexpected(child, status);
  }
  resetChild(child);
  return status;
}

/// Repeat (`again` = SUCCESS) and RetryUntilSuccessful (FAILURE): repeats the child while it
/// returns `again`.
template <base::NodeStatus again>
base::NodeStatus Ticker::repeat(int node) {
  constexpr bool kIsRetry = again == Status::Failure;
  std::optional<int> limit = readRequired<int>(node, 0);
  if (!limit && !kIsRetry) {
    return kFault;
  }
  auto& count = memory<std::int32_t>(node);
  const int child = node + 1;
  stored(node) = Status::Running;
  while (limit && (count < *limit || *limit == -1)) {
    const Status before = stored(child);
    const Status status = tickRepetition<again>(child, count);
    if (status != again) {
      return status;
    }
    limit = kIsRetry ? readRequired<int>(node, 0) : limit;  // the child may have changed it
    if (!limit) {
      return kFault;
    }
    count = *limit == -1 ? 0 : count + 1;
    if (before == Status::Idle && (count < *limit || *limit == -1)) {
      return Status::Running;
    }
  }
  count = 0;
  return limit ? again : kFault;
}

base::NodeStatus Ticker::keepRunning(int node) {
  return untilFailure(tickOnlyChild(node));
}

/// Delay and, with `isTimeout`, Timeout, which fails if the child takes longer.
template <bool isTimeout>
base::NodeStatus Ticker::timer(int node) {
  auto& own = memory<TimerMemory>(node);
  const std::optional<std::int64_t> limit = readRequired<std::int64_t>(node, 0);
  if (!limit) {
    return kFault;
  }
  if (!own.started) {
    own = {input_.step, true};
  }
  stored(node) = Status::Running;
  const int child = node + 1;
  if (!isTimeout && !hasElapsed(own, *limit)) {
    return Status::Running;
  }
  if (isTimeout && *limit > 0 && stored(child) == Status::Running && hasElapsed(own, *limit)) {
    resetChild(child);
    own.started = false;
    return Status::Failure;
  }
  const Status status = tickOnlyChild(node);
  own.started = status == Status::Running || status == Status::Skipped;
  return status;
}

base::NodeStatus Ticker::runOnce(int node) {
  auto& result = memory<Status>(node);
  if (result != Status::Idle) {
    const Value* const skips = portValue(node, 0);
    return !skips || valueAs<bool>(*skips).value_or(true) ? Status::Skipped : result;
  }
  const Status status = tickOnlyChild(node);
  result = isDone(status) ? status : Status::Idle;
  return status;
}

base::NodeStatus Ticker::subTree(int node) {
  return tickOnlyChild(node, stored(node) == Status::Idle);
}

base::NodeStatus Ticker::customDecorator(int node) {
  ParentContext context(*this, input_, node);
  const Status status = functionsOf(node).parent.tick(context);
  if (isFaulty()) {
    return kFault;
  }
  return status == Status::Idle ? fault(node, "the node returned IDLE") : status;
}

base::NodeStatus Ticker::precondition(int node) {
  auto& isRunning = memory<bool>(node);
  const int script = program_.node(node).detail;
  if (script == kMissing) {
    return fault(node, "input 'if' is missing");
  }
  const std::optional<Status> otherwise = readRequired<Status>(node, 1);  // a fault in any case
  if (!otherwise) {
    return kFault;
  }
  if (!isRunning) {
    bool truth = false;
    if (!evaluateCondition(node, script, truth)) {
      return kFault;
    }
    if (!truth) {
      return *otherwise == Status::Idle ? unexpected(node, Status::Idle) : *otherwise;
    }
  }
  const Status status = tickOnlyChild(node, false);  // stays IDLE if the child is skipped
  isRunning = status == Status::Running;
  return status;
}

/// Writes one element to the port `value`. False: a fault was raised.
bool Ticker::storeElement(int node, std::string_view element) {
  const PortBinding& binding = nodes_[node].ports[2];
  if (binding.kind != PortBinding::Kind::Entry) {
    return true;  // no entry is named
  }
  const std::optional<Value> value = convertTo(Value::of(element), binding.type);
  if (!value || !store(boundSlot(slots(), binding), *value)) {
    fault(node, "element '" + std::string(element) + "' of 'queue' does not fit 'value'");
    return false;
  }
  return true;
}

/// Takes the next element. False: none left; empty: a fault was raised.
std::optional<bool> Ticker::takeElement(int node) {
  const PortBinding& binding = nodes_[node].ports[0];
  if (binding.kind == PortBinding::Kind::Entry) {
    return takeFromEntry(node);
  }
  const Value* const list = portValue(node, 0);
  if (!list) {
    fault(node, "input 'queue' is missing");
    return std::nullopt;
  }
  return takeWritten(node, *list);
}

/// A constant queue restarts at its first element with each start of the node.
std::optional<bool> Ticker::takeWritten(int node, const Value& list) {
  auto& own = memory<LoopMemory>(node);
  std::string_view rest = list.text;
  for (int i = 0; i < own.taken; ++i) {
    const std::size_t separator = rest.find(';');
    rest.remove_prefix(separator == std::string_view::npos ? rest.size() : separator + 1);
  }
  if (rest.empty()) {
    return false;
  }
  if (!storeElement(node, rest.substr(0, rest.find(';')))) {
    return std::nullopt;
  }
  ++own.taken;
  return true;
}

/// Removes the taken element from the entry.
std::optional<bool> Ticker::takeFromEntry(int node) {
  Slot& entry = boundSlot(slots(), nodes_[node].ports[0]);
  Value& list = entry.value;
  const PortType element = nodes_[node].ports[2].type;
  if (!entry.exists) {  // it was removed: the port creates it again
    entry.exists = true;
    entry.type = PortType::Queue;
    entry.element = element;
  }
  if (list.type != ValueType::List || list.element != element) {
    fault(node, list.type == ValueType::Unset ? "the entry of 'queue' has no value"
                                              : "the entry of 'queue' is not a queue of this type");
    return std::nullopt;
  }
  if (list.integer == 0) {
    return false;
  }
  const std::string first = list.text.substr(0, list.text.find(';'));
  list.text.erase(0, first.size() + 1);
  --list.integer;
  return storeElement(node, first) ? std::optional(true) : std::nullopt;
}

base::NodeStatus Ticker::loop(int node) {
  auto& own = memory<LoopMemory>(node);
  if (stored(node) == Status::Idle) {
    own = {};
  }
  if (!own.running) {
    const std::optional<bool> taken = takeElement(node);
    if (!taken || !*taken) {
      const Status atEnd = taken ? readRequired<Status>(node, 1).value_or(kFault) : kFault;
      return atEnd == Status::Idle ? unexpected(node, atEnd) : atEnd;
    }
  }
  const Status status = tickOnlyChild(node);
  own.running = status == Status::Running;
  return untilFailure(status);
}

template <base::NodeStatus otherwise>
base::NodeStatus Ticker::ifUpdated(int node) {
  auto& own = memory<UpdateMemory>(node);
  if (!own.running && !wasUpdated(node, own)) {
    return isFaulty() ? kFault : otherwise;
  }
  const Status status = tickOnlyChild(node, false);
  own.running = status == Status::Running;
  return status;
}

// Leaves, and calls of library functions

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
  if (before != Status::Idle && before != Status::Running && !functions.isCalledWhenDone) {
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
  if (isDone(status)) {
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
