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

  /// Output port. False = the port is no "{key}" or the entry has another type; nothing written.
  bool set(int port, int value);
  bool set(int port, double value);
  bool set(int port, bool value);
  bool set(int port, std::string_view value);

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

/// What a decorator sees in addition: its child.
class DecoratorContext : public LeafContext {
 public:
  using LeafContext::LeafContext;
  base::NodeStatus tickChild();  // by all rules of a tick, conditions included
  void resetChild();             // halted if RUNNING, then IDLE
};

/// What a control sees in addition: its children, numbered from 0.
class ControlContext : public LeafContext {
 public:
  using LeafContext::LeafContext;
  int childCount() const;
  base::NodeStatus tickChild(int child);  // by all rules of a tick, conditions included
  void resetChild(int child);             // halted if RUNNING, then IDLE

 private:
  int nodeOf(int child) const;
};

namespace detail {
inline std::optional<int> convert(const Value& value, const int*) {
  return toInt(value);
}
inline std::optional<std::int64_t> convert(const Value& value, const std::int64_t*) {
  return toUnsigned(value);
}
inline std::optional<double> convert(const Value& value, const double*) {
  return toDouble(value);
}
inline std::optional<bool> convert(const Value& value, const bool*) {
  return toBool(value);
}
inline std::optional<std::string_view> convert(const Value& value, const std::string_view*) {
  return toStringView(value);
}
inline std::optional<base::NodeStatus> convert(const Value& value, const base::NodeStatus*) {
  return toStatus(value);
}

/// The usual case, an entry that holds just this type; what is true of it costs next to nothing.
template <class T>
bool readPlain(const Value&, T&) {
  return false;
}
template <>
inline bool readPlain(const Value& value, int& result) {
  result = static_cast<int>(value.integer);
  return value.type == ValueType::Int;
}
template <>
inline bool readPlain(const Value& value, double& result) {
  result = value.real;
  return value.type == ValueType::Double;
}

/// Converts into `result`; false = it does not fit. The plain cases go without an optional: copying
/// those from call to call costs more than all the rest of reading a port.
template <class T>
bool read(const Value& value, T& result) {
  const std::optional<T> converted = convert(value, static_cast<const T*>(nullptr));
  if (converted) {
    result = *converted;
  }
  return converted.has_value();
}
template <>
inline bool read(const Value& value, int& result) {
  if (readPlain(value, result)) {
    return true;
  }
  const std::optional<int> converted = convertedToInt(value);
  result = converted.value_or(0);
  return converted.has_value();
}
template <>
inline bool read(const Value& value, double& result) {
  if (readPlain(value, result)) {
    return true;
  }
  const std::optional<double> converted = convertedToDouble(value);
  result = converted.value_or(0.0);
  return converted.has_value();
}
}  // namespace detail

template <class T>
std::optional<T> LeafContext::get(int port) const {
  const Value* value = valueOf(port);
  return value ? detail::convert(*value, static_cast<const T*>(nullptr)) : std::nullopt;
}

template <class T>
T LeafContext::require(int port) {
  T result{};
  return detail::readPlain(boundValue(port), result) ? result : requireSlowly<T>(port);
}
template <class T>
T LeafContext::requireSlowly(int port) {
  const Value* value = valueOf(port);
  T result{};
  if (!value || !detail::read(*value, result)) {
    faultOfPort(port);
    return T{};
  }
  return result;
}

template <class T>
T LeafContext::getOr(int port, T fallback) {
  const Value* value = valueOf(port);
  if (!value) {
    return fallback;
  }
  T result{};
  if (!detail::read(*value, result)) {
    faultOfPort(port);
    return fallback;
  }
  return result;
}

}  // namespace bt
