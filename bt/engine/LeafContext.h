#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "bt/engine/Value.h"
#include "sim2d/base/Types.h"

namespace bt {

class Program;
class TreeState;
class Ticker;

/// What the host tells a tree for one tick. Simulated time: a node started in step a has run
/// (k - a) * dt in step k.
struct TickInput {
  std::int64_t step = 0;  // from 1
  double dt = 0.0;        // [s] > 0
  void* host = nullptr;   // handed to the leaves; they know its type
};

/// A limit of `limit` seconds is reached this much earlier, so that sums of dt meet it.
constexpr double kTimeTolerance = 1e-9;  // [s]

/// What a call needs to know of its node.
struct NodeHead {
  const PortBinding* ports = nullptr;  // in the order of the manifest
  std::int32_t index = 0;              // number in the program
};

enum class PortState { Given, Default, Missing, WrongType };

/// What a leaf sees while it is called: its ports, memory, time and the host. Ports are addressed
/// by their number in the manifest; nothing is looked up by name and reading allocates nothing.
class LeafContext {
 public:
  LeafContext(Ticker& ticker, const TickInput& input, int node);
  /// Goes on to another leaf of the same tree; for the engine.
  void moveTo(const NodeHead& head) {
    head_ = &head;
    ports_ = head.ports;
  }

  /// The value of an input port: int, double, bool, std::int64_t (of Unsigned),
  /// std::string_view (of text entries; valid until the entry is written) or base::NodeStatus.
  /// Empty = missing or not convertible, state() tells which.
  template <class T>
  std::optional<T> get(int port) const;
  /// The same; without a value the tree is marked faulty, T{} is returned and whatever the leaf
  /// returns is dropped.
  template <class T>
  T require(int port);
  /// `fallback` when the port is missing; a wrong type is a fault.
  template <class T>
  T getOr(int port, T fallback);
  PortState state(int port) const;
  /// Any value as text ("2,3", or a number); for ports of type Any. May allocate.
  std::optional<std::string> text(int port) const;

  /// Output port. False = the port is not a "{key}", or the value does not fit the type of the
  /// entry, which marks the tree faulty; nothing is written in these cases.
  template <class T>
  bool set(int port, T value) {
    Slot* const slot = slotOf(port);
    if (!slot) {
      return false;
    }
    bool isWritten = false;
    if constexpr (std::is_same_v<T, int> || std::is_same_v<T, double>) {
      isWritten = store(*slot, value);
    } else {
      isWritten = store(*slot, Value::of(value));
    }
    if (!isWritten) {
      faultOfOutput(port, Value::of(value));
    }
    return isWritten;
  }

  /// The leaf's own bytes, asked for when it was registered: zero when the tree is made or reset,
  /// kept over halts and restarts.
  template <class T>
  T& memory() {
    static_assert(std::is_trivially_copyable_v<T> && alignof(T) <= 8);
    return *static_cast<T*>(memoryBytes());
  }

  std::int64_t step() const { return input_->step; }
  double dt() const { return input_->dt; }
  double time() const { return static_cast<double>(input_->step) * input_->dt; }
  double elapsedSince(std::int64_t startStep) const {
    return static_cast<double>(input_->step - startStep) * input_->dt;
  }
  bool hasElapsed(std::int64_t startStep, double limit) const {
    return elapsedSince(startStep) >= limit - kTimeTolerance;
  }

  /// What the last call of this node left: IDLE when it begins, as in BehaviorTree.CPP while a node
  /// is ticked. Of decorators, and of leaves that last or remember.
  base::NodeStatus before() const;

  int node() const { return head_->index; }  // number in the program
  const std::string& path() const;           // "MainFallback/SetGoals/RunOnce[2]/SetGoal"
  const std::string& label() const;          // the name, else the ID
  template <class T>
  T& host() const {
    return *static_cast<T*>(host_);
  }

  /// Marks the tree faulty with this message; return its result.
  base::NodeStatus fault(std::string message);

 protected:
  Ticker& ticker() const { return *ticker_; }

 private:
  const Value* valueOf(int port) const {  // nullptr = missing
    const Value& value = boundValue(port);
    return value.type == ValueType::Unset ? nullptr : &value;
  }
  const Value& boundValue(int port) const {
    const PortBinding& binding = ports_[port];
    return boundSlot(columns_[static_cast<std::size_t>(binding.kind)], binding).value;
  }
  Slot* slotOf(int port) {
    const PortBinding& binding = ports_[port];
    return binding.kind == PortBinding::Kind::Entry ? &boundSlot(slots_, binding) : nullptr;
  }
  void* memoryBytes();
  void faultOfPort(int port);
  [[gnu::cold]] void faultOfOutput(int port, const Value& value);

  template <class T>
  [[gnu::noinline, gnu::cold]] T requireSlowly(int port);

  Ticker* ticker_;
  const TickInput* input_;
  const PortBinding* ports_;  // those of the head; apart from it, or both are stored as one vector,
  void* host_;                // from which a half is slow to read
  std::array<const Slot*, 3> columns_;  // by PortBinding::Kind: constants, constants, entries
  Slot* slots_;
  const NodeHead* head_;
};

/// What a decorator or control sees in addition: its children, numbered from 0.
class ParentContext : public LeafContext {
 public:
  using LeafContext::LeafContext;
  int childCount() const;
  base::NodeStatus tickChild(int child = 0);  // by all rules of a tick, conditions included
  void resetChild(int child = 0);             // halted if RUNNING, then IDLE

 private:
  int nodeOf(int child) const;
};

template <class T>
std::optional<T> LeafContext::get(int port) const {
  const Value* value = valueOf(port);
  return value ? valueAs<T>(*value) : std::nullopt;
}

/// The usual case, an entry that holds just this type, costs next to nothing.
template <class T>
T LeafContext::require(int port) {
  const Value& value = boundValue(port);
  if constexpr (std::is_same_v<T, int>) {
    return value.type == ValueType::Int ? static_cast<int>(value.integer) : requireSlowly<T>(port);
  } else if constexpr (std::is_same_v<T, double>) {
    return value.type == ValueType::Double ? value.real : requireSlowly<T>(port);
  } else if constexpr (std::is_same_v<T, bool>) {
    return value.type == ValueType::Bool ? value.integer != 0 : requireSlowly<T>(port);
  } else {
    return requireSlowly<T>(port);
  }
}
template <class T>
T LeafContext::requireSlowly(int port) {
  const std::optional<T> value = get<T>(port);
  if (!value) {
    faultOfPort(port);
  }
  return value.value_or(T{});
}

template <class T>
T LeafContext::getOr(int port, T fallback) {
  const std::optional<T> value = get<T>(port);
  if (!value && valueOf(port)) {
    faultOfPort(port);
  }
  return value.value_or(fallback);
}

}  // namespace bt
