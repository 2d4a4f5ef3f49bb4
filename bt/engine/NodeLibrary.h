#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "bt/engine/Value.h"
#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Types.h"

namespace bt {

class Program;
class TreeState;
class Ticker;

/// Input of one tick. Simulated time: a node started in step a has run for (k - a) * dt in step k.
struct TickInput {
  std::int64_t step = 0;  // from 1
  double dt = 0.0;        // [s] > 0
  void* host = nullptr;   // passed to the leaves, which cast it to its type
};

/// Time limits are reached this much earlier, which compensates rounding errors in sums of dt.
constexpr double kTimeTolerance = 1e-9;  // [s]

inline base::NodeStatus successIf(bool condition) {
  return condition ? base::NodeStatus::Success : base::NodeStatus::Failure;
}
/// SUCCESS or FAILURE.
inline bool isDone(base::NodeStatus status) {
  return status == base::NodeStatus::Success || status == base::NodeStatus::Failure;
}

/// What a call needs from its node.
struct NodeHead {
  const PortBinding* ports = nullptr;  // in the order of the manifest
  std::int32_t index = 0;              // index in the program
};

enum class PortState { Given, Default, Missing, WrongType };

/// Access of a leaf to its ports, memory, time and host during a call. Ports are addressed by their
/// index in the manifest; there is no look-up by name, and reading does not allocate.
class LeafContext {
 public:
  LeafContext(Ticker& ticker, const TickInput& input, int node);
  /// Switches to another leaf of the same tree; for the engine.
  void switchToNode(const NodeHead& head) {
    head_ = &head;
    ports_ = head.ports;
  }

  /// The value of an input port: int, double, bool, std::int64_t (for Unsigned), std::string_view
  /// (for text entries; valid until the entry is written) or base::NodeStatus. Empty: missing or
  /// not convertible; state() distinguishes the two.
  template <class T>
  std::optional<T> get(int port) const;
  /// Like get(), but without a value the tree becomes faulty, T{} is returned and the result of the
  /// leaf is ignored.
  template <class T>
  T require(int port);
  /// Like get(), with `fallback` for a missing port. A wrong type is a fault.
  template <class T>
  T getOr(int port, T fallback);
  PortState state(int port) const;
  /// Any value as text ("2,3", or a number), for ports of type Any. May allocate.
  std::optional<std::string> text(int port) const;

  /// Writes an output port. Returns false, without writing, if the port is not a "{key}" or if the
  /// value does not fit the type of the entry; the latter is a fault.
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
      reportOutputFault(port, Value::of(value));
    }
    return isWritten;
  }

  /// The leaf's own memory, of the size given at registration. Zero when the tree is created or
  /// reset, preserved by halts and restarts.
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

  /// The status before this tick: IDLE at the start, as in BehaviorTree.CPP. For decorators and for
  /// leaves that are stateful or keep their status.
  base::NodeStatus before() const;

  int node() const { return head_->index; }  // index in the program
  const std::string& path() const;           // "MainFallback/SetGoals/RunOnce[2]/SetGoal"
  const std::string& label() const;          // the name if set, otherwise the ID
  template <class T>
  T& host() const {
    return *static_cast<T*>(host_);
  }

  /// Marks the tree as faulty with this message. Return the result of this function.
  base::NodeStatus fault(std::string message);

 protected:
  Ticker& ticker() const { return *ticker_; }

 private:
  const Value* valueOf(int port) const {  // nullptr: missing
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
  void reportInputFault(int port);
  [[gnu::cold]] void reportOutputFault(int port, const Value& value);

  template <class T>
  [[gnu::noinline, gnu::cold]] T requireSlowly(int port);

  Ticker* ticker_;
  const TickInput* input_;
  const PortBinding* ports_;  // head_->ports; a separate member, because a combined vector store
  void* host_;                // of both members is slow to read in halves
  std::array<const Slot*, 3> columns_;  // by PortBinding::Kind: constants, constants, entries
  Slot* slots_;
  const NodeHead* head_;
};

/// Context of a decorator or control: adds its children, numbered from 0.
class ParentContext : public LeafContext {
 public:
  using LeafContext::LeafContext;
  int childCount() const;
  base::NodeStatus tickChild(int child = 0);  // a full tick, including conditions
  void resetChild(int child = 0);             // halts a RUNNING child, sets IDLE

 private:
  int nodeOf(int child) const;
};

template <class T>
std::optional<T> LeafContext::get(int port) const {
  const Value* value = valueOf(port);
  return value ? valueAs<T>(*value) : std::nullopt;
}

/// Fast path for an entry that has exactly this type.
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
    reportInputFault(port);
  }
  return value.value_or(T{});
}

template <class T>
T LeafContext::getOr(int port, T fallback) {
  const std::optional<T> value = get<T>(port);
  if (!value && valueOf(port)) {
    reportInputFault(port);
  }
  return value.value_or(fallback);
}

/// The node types available to trees: those of BehaviorTree.CPP, which the engine runs itself, and
/// the leaves, decorators and controls that a host registers as plain functions.
///
///   constexpr const char* kNodes = R"(
///   Condition IsAlone|Perception|No other person is near.
///   agent_id int needed|Id of the person.
///   threshold length default 1.0|Nearer than this is near.
///   Action Pause|Timing|Stands still.
///   duration duration default 5.0|Duration.
///   )";
///   NodeStatus isAlone(LeafContext& leaf) {
///     const int agent = leaf.require<int>(0);
///     return successIf(leaf.host<Host>().distanceToNext(agent) > leaf.require<double>(1));
///   }
///   struct PauseMemory { std::int64_t startStep; };
///   NodeStatus start(LeafContext& leaf) {  // status was IDLE
///     leaf.memory<PauseMemory>().startStep = leaf.step();
///     return NodeStatus::Running;
///   }
///   NodeStatus run(LeafContext& leaf) {
///     return leaf.hasElapsed(leaf.memory<PauseMemory>().startStep, leaf.require<double>(0))
///                ? NodeStatus::Success : NodeStatus::Running;
///   }
///   void resume(LeafContext& leaf) { leaf.host<Host>().resume(); }
///
///   library.add(parseNodeCatalogue(kNodes, NodeOrigin::Ours),
///               {{"IsAlone", synchronous(isAlone)},
///                {"Pause", stateful<PauseMemory>({start, run, resume})}});
///
/// Leaves must be pure functions of context and host: no static variables, no clocks.

using LeafFunction = base::NodeStatus (*)(LeafContext&);
using HaltFunction = void (*)(LeafContext&);
using ParentFunction = base::NodeStatus (*)(ParentContext&);
using ParentHaltFunction = void (*)(ParentContext&);

struct StatefulFunctions {
  LeafFunction onStart = nullptr;
  LeafFunction onRunning = nullptr;
  HaltFunction onHalted = nullptr;  // called on a halt while RUNNING
};

/// Functions of a decorator or control. `tick` ticks the children through the context. The engine
/// resets the child of a decorator when it is done. A control is RUNNING during its tick; unless it
/// returns RUNNING, all children are halted and reset. On a halt while RUNNING the children are
/// halted first, then `onHalted` is called.
struct ParentFunctions {
  ParentFunction tick = nullptr;
  ParentHaltFunction onHalted = nullptr;
};

/// Functions of a registered node, made by the functions below.
struct NodeFunctions {
  enum class Kind : unsigned char { Synchronous, Stateful, Decorator, Control };
  Kind kind = Kind::Synchronous;
  LeafFunction tick = nullptr;  // Synchronous: must return SUCCESS or FAILURE
  StatefulFunctions stateful = {};
  ParentFunctions parent = {};
  bool isCalledWhenDone = false;  // Stateful: restarted even if its last result is stored
  int memoryBytes = 0;            // per node and agent
};

struct NoMemory {};

/// `Memory` is the node's memory per agent, see LeafContext::memory().
template <class Memory>
NodeFunctions withMemory(NodeFunctions functions) {
  static_assert(std::is_trivially_copyable_v<Memory> && alignof(Memory) <= 8);
  functions.memoryBytes = std::is_same_v<Memory, NoMemory> ? 0 : static_cast<int>(sizeof(Memory));
  return functions;
}
template <class Memory = NoMemory>
NodeFunctions synchronous(LeafFunction tick) {
  return withMemory<Memory>({NodeFunctions::Kind::Synchronous, tick});
}
template <class Memory = NoMemory>
NodeFunctions stateful(StatefulFunctions functions) {
  return withMemory<Memory>({NodeFunctions::Kind::Stateful, nullptr, functions});
}
/// A leaf that is never RUNNING and is called in every tick, like a synchronous one, but keeps its
/// status: LeafContext::before() is IDLE if it was halted or reset since its last call.
template <class Memory = NoMemory>
NodeFunctions synchronousWithStatus(LeafFunction tick) {
  return withMemory<Memory>({NodeFunctions::Kind::Stateful, nullptr, {tick, tick}, {}, true});
}
template <class Memory = NoMemory>
NodeFunctions decorator(ParentFunctions functions) {
  return withMemory<Memory>({NodeFunctions::Kind::Decorator, nullptr, {}, functions});
}
template <class Memory = NoMemory>
NodeFunctions control(ParentFunctions functions) {
  return withMemory<Memory>({NodeFunctions::Kind::Control, nullptr, {}, functions});
}

class NodeLibrary {
 public:
  NodeLibrary();  // contains the nodes of BehaviorTree.CPP

  /// Registers a node; a node with the same id is replaced. The manifest of a decorator or control
  /// gets that kind. A decorator has one child, a control at least one and no upper limit unless
  /// the manifest sets one.
  void add(NodeManifest manifest, const NodeFunctions& functions);
  /// Registers all nodes, each with the functions of its id; both have the same ids.
  void add(const NodeCatalogue& nodes, const std::map<std::string, NodeFunctions>& functions);

  const NodeCatalogue& catalogue() const { return catalogue_; }
  /// nullptr: unknown, or run by the engine itself.
  const NodeFunctions* functions(std::string_view id) const;

  /// A copy in which `leaf` runs every registered leaf (it may return any status except IDLE and
  /// SKIPPED), for driving a tree by scripted results. Leaves that were synchronous are still
  /// called in every tick.
  NodeLibrary withLeafFunctions(StatefulFunctions leaf) const;

 private:
  NodeCatalogue catalogue_;
  std::map<std::string, NodeFunctions, std::less<>> functions_;
};

}  // namespace bt
