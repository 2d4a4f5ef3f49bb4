#include "bt/engine/TreeState.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "bt/engine/Ticker.h"

namespace bt {
namespace {

/// The port type of a number or bool; empty for text.
std::optional<PortType> typeOf(const Value& value) {
  switch (value.type) {
    case ValueType::Int:
      return PortType::Int;
    case ValueType::Unsigned:
      return PortType::Unsigned;
    case ValueType::Long:
    case ValueType::Double:
      return PortType::Double;
    case ValueType::Bool:
      return PortType::Bool;
    case ValueType::Unset:
    case ValueType::String:
    case ValueType::List:
      break;
  }
  return std::nullopt;
}

/// Two events per stateful leaf and one more; a tick seldom has more.
std::size_t eventCapacity(const Program& program) {
  const auto count = std::count_if(
      program.nodes().begin(), program.nodes().end(),
      [](const Program::Node& node) { return node.children == 0 && node.halt != nullptr; });
  return 2 * static_cast<std::size_t>(count) + 1;
}

}  // namespace

TreeState::TreeState(std::shared_ptr<const Program> program) : program_(std::move(program)) {
  assert(program_);
  const std::size_t statusWords =
      (2 * nodeCount() + sizeof(std::uint64_t) - 1) / sizeof(std::uint64_t);
  memory_.reset(new std::uint64_t[memoryWords() + statusWords]);
  slots_ = std::make_unique<Slot[]>(program_->initialSlots().size());
  events_.reserve(eventCapacity(*program_));
  reset();
}

void TreeState::reset() {
  std::fill_n(memory_.get(), memoryWords(), 0U);
  std::fill_n(stored(), 2 * nodeCount(), base::NodeStatus::Idle);
  std::copy(program_->initialSlots().begin(), program_->initialSlots().end(), slots_.get());
  events_.clear();
  fault_.reset();
}

base::NodeStatus TreeState::tickOnce(const TickInput& input) {
  using base::NodeStatus;
  clearReturned();
  events_.clear();
  NodeStatus status = NodeStatus::Idle;
  if (!fault_) {
    Ticker ticker(*program_, *this, input);
    status = ticker.tickNode(0);
    if (fault_) {
      for (int node = 0; node < program_->nodeCount(); ++node) {
        ticker.resetChild(node);  // a parent may not have been marked RUNNING yet
      }
      clearReturned();
      status = NodeStatus::Idle;
    } else if (status == NodeStatus::Success || status == NodeStatus::Failure) {
      *stored() = NodeStatus::Idle;
    }
  }
  return status;
}

void TreeState::halt(const TickInput& input) {
  Ticker(*program_, *this, input).resetChild(0);
}

std::optional<bool> TreeState::evaluateCondition(const Script& condition) const {
  assert(condition.written.empty());
  ScriptRunner runner(condition, slots_.get());
  return runner.run() ? runner.truth() : std::nullopt;
}

bool TreeState::setFromText(const std::string& key, const std::string& text) {
  const int slot = program_->findSlot(key);
  if (slot < 0) {
    return false;
  }
  const Value value = Value::of(std::string_view(text));
  Slot& entry = slots_[static_cast<std::size_t>(slot)];
  const std::optional<PortType> now =
      entry.type == PortType::Any ? typeOf(entry.value) : std::optional(entry.type);
  const std::optional<Value> fitting = now ? convertTo(value, *now, entry.element) : value;
  if (!fitting) {
    return false;
  }
  const bool staysLong = entry.value.type == ValueType::Long && copyInto(entry.value, *fitting);
  if (!staysLong) {
    copyValue(entry.value, *fitting);
  }
  entry.exists = true;
  ++entry.version;
  return true;
}

std::vector<std::pair<std::string, std::string>> TreeState::entries() const {
  std::vector<std::pair<std::string, std::string>> all;
  for (const Program::Entry& entry : program_->entries()) {
    const Value& value = get(entry.slot);
    if (value.type != ValueType::Unset) {
      all.emplace_back(entry.key, value.toText());
    }
  }
  return all;
}

}  // namespace bt
