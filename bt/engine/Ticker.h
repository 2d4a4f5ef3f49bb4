#pragma once

#include <string>

#include "bt/engine/NodeCodes.h"
#include "bt/engine/TreeState.h"

namespace bt {

/// Runs one tick or halt of one tree. Private to the engine; leaves reach it through LeafContext.
class Ticker {
 public:
  Ticker(const Program& program, TreeState& state, const TickInput& input)
      : program_(program),
        state_(state),
        input_(input),
        nodes_(program.nodes().data()),
        stored_(state.stored_.data()),
        returned_(state.returned_.data()),
        bindings_(program.bindings().data()),
        leaf_(*this, input, 0) {}

  /// The whole tick of a node: conditions, its code, book-keeping.
  base::NodeStatus tickNode(int node);
  /// Halted if it is RUNNING, then IDLE.
  void resetChild(int node);

  [[gnu::cold]] base::NodeStatus fault(int node, std::string message);
  bool isFaulty() const { return state_.fault_.has_value(); }
  /// What a tick returns once the tree is faulty; passed up to the root.
  static constexpr auto kFault = static_cast<base::NodeStatus>(5);

  void* memoryOf(int node) {
    return reinterpret_cast<unsigned char*>(state_.memory_.data()) + program_.node(node).memory;
  }
  Slot* slots() { return state_.slots_.data(); }
  const Program& program() const { return program_; }
  const TickInput& input() const { return input_; }

 private:
  using Status = base::NodeStatus;
  template <class T>
  T& memory(int node) {
    return *static_cast<T*>(memoryOf(node));
  }
  Status& stored(int node) { return stored_[node]; }
  int endOf(int node) const { return nodes_[node].end; }
  void resetChildren(int node);
  void resetOthers(int node, int kept);

  Status run(int node);
  Status runControl(int node);
  Status runDecorator(int node);
  Status runLeaf(int node);
  Status tickWithConditions(int node);
  Status preCondition(const Program::Conditions& conditions, int node);
  void postConditions(const Program::Conditions& conditions, int node, Status status);
  void halt(int node);
  void haltOwn(int node);
  void tellHalted(int node);
  /// For what a parent cannot go on with: IDLE of a child is a fault.
  [[gnu::cold]] Status unexpected(int child, Status status);

  Status sequence(int node, Status stop, bool yields);
  Status finishSequence(int node, SequenceMemory& memory, Status stop);
  Status sequenceWithMemory(int node);
  Status reactive(int node, Status stop);
  Status parallel(int node);
  Status parallelAll(int node);
  bool tickParallelChildren(int node, int& skipped, bool untilDecided, Status& decided);
  bool decideParallel(int node, int skipped, Status& decided);
  bool threshold(int node, int port, int& value);
  void finishParallel(int node);
  Status ifThenElse(int node);
  Status whileDoElse(int node);
  Status switchCase(int node);
  int selectedCase(int node);
  Status customControl(int node);
  Status tryCatch(int node);
  Status tryChildren(int node, int last);
  Status catchChild(int node, int last);
  void haltTryCatch(int node);

  Status inverter(int node);
  Status force(int node, Status result);
  Status repeat(int node);
  Status retry(int node);
  Status keepRunning(int node);
  Status delay(int node);
  Status timeout(int node);
  Status runOnce(int node);
  Status precondition(int node);
  Status loop(int node);
  bool takeElement(int node, bool& taken);
  bool storeElement(int node, std::string_view element);
  Status ifUpdated(int node, Status otherwise);
  Status subTree(int node);
  Status customDecorator(int node);

  Status synchronous(int node, LeafFunction function) {
    leaf_.moveTo(node, bindings_ + nodes_[node].firstPort);
    const Status status = function(leaf_);
    const bool isDone = status == Status::Success || status == Status::Failure;
    return isDone && !isFaulty() ? status : unexpected(node, status);
  }
  /// tickNode for the children of a control; leaves that are one call, most of what a tick does,
  /// take the short way.
  Status tickChild(int node) {
    const LeafFunction function = nodes_[node].tick;
    if (!function) {
      return tickNode(node);
    }
    const Status status = synchronous(node, function);
    if (status != kFault) {
      returned_[node] = status;  // nothing asks for a stored one: it is never RUNNING
    }
    return status;
  }
  Status stateful(int node);
  Status sleep(int node);
  Status setBlackboard(int node);
  Status unsetBlackboard(int node);
  bool wasUpdated(int node, UpdateMemory& memory);
  void note(int node, LeafEvent::Kind kind);

  /// The result of a script as a condition; false with a fault when it fails.
  bool truthOf(int node, int script, bool& truth);
  bool runScript(int node, int script);

  /// Ports of nodes that the engine runs; nothing = a fault was noted.
  template <class T>
  std::optional<T> need(int node, int port);
  const Value* portValue(int node, int port) const;
  bool hasElapsed(const TimerMemory& timer, std::int64_t milliseconds) const;

  const Program& program_;
  TreeState& state_;
  const TickInput& input_;
  const Program::Node* nodes_;  // and two columns of the state, for speed
  Status* stored_;
  Status* returned_;
  const PortBinding* bindings_;
  LeafContext leaf_;  // of the synchronous leaf that is ticked
};

template <class T>
std::optional<T> Ticker::need(int node, int port) {
  LeafContext context(*this, input_, node);
  const T value = context.require<T>(port);
  return isFaulty() ? std::nullopt : std::optional<T>(value);
}

}  // namespace bt
