#include <algorithm>

#include "bt/engine/Ticker.h"

/// Decorators that depend on the blackboard.
namespace bt {

base::NodeStatus Ticker::precondition(int node) {
  auto& own = memory<RunningMemory>(node);
  if (!own.running) {
    const int script = program_.node(node).detail;
    if (script < 0) {
      return fault(node, "input 'if' is missing");
    }
    bool truth = false;
    if (!truthOf(node, script, truth)) {
      return kFault;
    }
    if (!truth) {
      const std::optional<Status> otherwise = need<Status>(node, 1);
      return otherwise ? *otherwise : kFault;
    }
  }
  stored(node) = Status::Running;
  const Status status = tickNode(node + 1);
  if (status == Status::Idle) {
    return unexpected(node + 1, status);
  }
  own.running = status == Status::Running;
  return status;
}

/// Writes one element to the port `value`; false = a fault was noted.
bool Ticker::storeElement(int node, std::string_view element) {
  const PortBinding& binding = nodes_[node].ports[2];
  if (binding.kind != PortBinding::Kind::Entry) {
    return true;  // nobody wants it
  }
  const std::optional<Value> value = convertTo(Value::of(element), binding.type);
  if (!value || !store(boundSlot(slots(), binding), *value)) {
    fault(node, "element '" + std::string(element) + "' of 'queue' does not fit 'value'");
    return false;
  }
  return true;
}

/// Takes the next element of the list: of a constant by counting, of an entry by cutting it off.
bool Ticker::takeElement(int node, bool& taken) {
  taken = false;
  const PortBinding& binding = nodes_[node].ports[0];
  const Value* const list = portValue(node, 0);
  if (!list || list->text.empty()) {
    return true;
  }
  auto& own = memory<LoopMemory>(node);
  std::string_view rest = list->text;
  const bool constant = binding.kind == PortBinding::Kind::Constant;
  for (int i = 0; constant && i < own.taken; ++i) {
    const std::size_t separator = rest.find(';');
    if (separator == std::string_view::npos) {
      return true;
    }
    rest.remove_prefix(separator + 1);
  }
  const std::size_t length = std::min(rest.find(';'), rest.size());
  if (!storeElement(node, rest.substr(0, length))) {
    return false;
  }
  taken = true;
  if (constant) {
    ++own.taken;
  } else {
    Slot& slot = boundSlot(slots(), binding);
    slot.value.text.erase(0, length + 1);
    ++slot.version;
  }
  return true;
}

base::NodeStatus Ticker::loop(int node) {
  auto& own = memory<LoopMemory>(node);
  if (stored(node) == Status::Idle) {
    own.running = false;
  }
  if (!own.running) {
    bool taken = false;
    if (!takeElement(node, taken)) {
      return kFault;
    }
    if (!taken) {
      const std::optional<Status> atEnd = need<Status>(node, 1);
      return atEnd ? *atEnd : kFault;
    }
  }
  stored(node) = Status::Running;
  const Status status = tickNode(node + 1);
  if (status == Status::Idle || status == kFault) {
    return unexpected(node + 1, status);
  }
  own.running = status == Status::Running;
  return status == Status::Failure ? status : Status::Running;
}

base::NodeStatus Ticker::ifUpdated(int node, Status otherwise) {
  auto& own = memory<UpdateMemory>(node);
  if (!own.running && !wasUpdated(node, own)) {
    return isFaulty() ? kFault : otherwise;
  }
  const Status status = tickNode(node + 1);
  if (status == Status::Idle) {
    return unexpected(node + 1, status);
  }
  own.running = status == Status::Running;
  return status;
}

}  // namespace bt
