#pragma once

#include <string>
#include <utility>

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
        stored_(state.stored()),
        returned_(state.returned()),
        isFaulty_(state.fault_ != nullptr),
        leaf_(*this, input, 0) {}

  /// Nullptr for nodes that a library runs.
  static const BuiltinNode* builtin(std::string_view id);
  static BuiltinNode libraryNode(const NodeFunctions& functions);
  /// The whole tick of a node: conditions, its code, book-keeping.
  base::NodeStatus tickNode(int node);
  /// Halted if it is RUNNING, then IDLE.
  void resetChild(int node);

  [[gnu::cold]] base::NodeStatus fault(int node, std::string message);
  bool isFaulty() const { return isFaulty_; }
  /// What a tick returns once the tree is faulty; passed up to the root.
  static constexpr auto kFault = static_cast<base::NodeStatus>(5);
  /// In one tick of the root: five times what the largest tree has nodes.
  static constexpr int kMostRounds = 1000000;

  void* memoryOf(int node) {
    return reinterpret_cast<unsigned char*>(state_.memory_.get()) + program_.node(node).memory;
  }
  base::NodeStatus storedOf(int node) const { return stored_[node]; }
  Slot* slots() { return state_.slots_.get(); }
  const Program& program() const { return program_; }
  const TickInput& input() const { return input_; }

 private:
  using Status = base::NodeStatus;
  static std::pair<const BuiltinNode*, const BuiltinNode*> builtins();  // begin and end
  template <class T>
  T& memory(int node) {
    return *static_cast<T*>(memoryOf(node));
  }
  Status& stored(int node) { return stored_[node]; }
  const Program::Conditions& conditionsOf(const Program::Node& node) const {
    return program_.conditions()[static_cast<std::size_t>(node.conditions)];
  }
  /// Of a node that a library runs.
  const NodeFunctions& functionsOf(int node) const {
    return program_.functions(nodes_[node].detail);
  }
  int endOf(int node) const { return nodes_[node].end; }
  void resetChildren(int node);
  void resetFrom(int first, int node);  // the children of `node` from `first` on
  void resetOthers(int node, int kept);

  template <Status (Ticker::*function)(int)>
  static Status call(Ticker& ticker, int node) {
    return (ticker.*function)(node);
  }
  template <Status result>
  static Status always(Ticker&, int) {
    return result;
  }
  Status tickWithConditions(int node);
  Status preCondition(const Program::Conditions& conditions, int node);
  void postConditions(const Program::Conditions& conditions, int node, Status status);
  void halt(int node);
  template <class T>
  static void forget(Ticker& ticker, int node);
  template <class T>
  static void stopChild(Ticker& ticker, int node);
  static void noteHalt(Ticker& ticker, int node);
  static void haltStateful(Ticker& ticker, int node);
  static void haltParent(Ticker& ticker, int node);
  static void haltParallel(Ticker& ticker, int node);
  static void haltTryCatch(Ticker& ticker, int node);
  /// For what a parent cannot go on with: IDLE of a child is a fault.
  [[gnu::cold]] Status unexpected(int child, Status status);
  /// Ticks the child of a decorator; `marks`: the decorator counts as RUNNING meanwhile.
  Status tickOnlyChild(int node, bool marks = true) {
    if (marks) {
      stored(node) = Status::Running;
    }
    const Status status = tickNode(node + 1);
    return status == Status::Idle ? unexpected(node + 1, status) : status;
  }

  template <Status stop>  // what a child returns so that its parent goes on
  static constexpr Status kPasses = stop == Status::Failure ? Status::Success : Status::Failure;
  template <Status stop, bool yields = false, bool remembers = false>
  Status sequence(int node);
  template <Status stop>
  Status reactive(int node);
  Status parallel(int node);
  Status parallelAll(int node);
  /// Counts of a Parallel, read when a tick begins. countsSkipped: skipped children count as
  /// successes.
  struct Thresholds {
    int successes = 0;
    int failures = 0;
    bool countsSkipped = false;
  };
  Status tickParallelChildren(int node, int& skipped, const Thresholds* limits);
  Status decideParallel(int node, int skipped, const Thresholds& limits);
  int threshold(int node, int port);
  Status ifThenElse(int node);
  Status whileDoElse(int node);
  Status switchCase(int node);
  int selectedCase(int node);
  Status customControl(int node);
  int lastChild(int node) const;
  Status tryCatch(int node);
  Status tryChildren(int node, int last);
  Status catchChild(int node, int last);

  Status inverter(int node);
  template <Status result>
  Status force(int node);
  template <Status again>
  Status tickRound(int child, std::int32_t& count);
  template <Status again>
  Status repeat(int node);
  Status keepRunning(int node);
  /// Goes on, however the child ended, unless it failed or the tree is faulty.
  static Status untilFailure(Status status) {
    return status == Status::Failure || status == kFault ? status : Status::Running;
  }
  template <bool isTimeout>
  Status timer(int node);
  Status runOnce(int node);
  Status precondition(int node);
  Status loop(int node);
  std::optional<bool> takeElement(int node);
  std::optional<bool> takeWritten(int node, const Value& list);
  std::optional<bool> takeFromEntry(int node);
  bool storeElement(int node, std::string_view element);
  template <Status otherwise>
  Status ifUpdated(int node);
  Status subTree(int node);
  Status customDecorator(int node);

  [[gnu::always_inline]] Status synchronous(const Program::Node& here, int node,
                                            LeafFunction function) {
    leaf_.moveTo(here);
    const Status status = function(leaf_);
    return isDone(status) && !isFaulty() ? status : unexpected(node, status);
  }
  /// tickNode put in place, for the children of a control.
  Status tickChild(int node) {
    const Program::Node& here = nodes_[node];
    if (here.isInstant) {
      return tickInstant(here, node);
    }
    const Status status = here.conditions < 0 ? here.run(*this, node) : tickWithConditions(node);
    if (status == kFault) {
      return status;
    }
    if (status != Status::Skipped) {
      stored_[node] = status;
    }
    returned_[node] = status;
    if (here.hasOneChild && isDone(stored_[node + 1])) {
      stored_[node + 1] = Status::Idle;
    }
    return status;
  }
  /// The same for what is always done within the tick.
  [[gnu::always_inline]] Status tickInstant(const Program::Node& here, int node) {
    const Status status = here.tick ? synchronous(here, node, here.tick) : here.run(*this, node);
    if (status != kFault) {
      returned_[node] = status;
    }
    return status;
  }
  template <Status stop>
  static Status instants(Ticker& ticker, int node);
  static Status instantInverter(Ticker& ticker, int node);
  template <Status result>
  static Status instantForce(Ticker& ticker, int node);
  static bool isDone(Status status) {
    return status == Status::Success || status == Status::Failure;
  }
  Status librarySynchronous(int node);
  Status stateful(int node);
  Status script(int node);
  Status scriptCondition(int node);
  Status wasEntryUpdated(int node);
  Status sleep(int node);
  std::optional<Slot*> target(int node, const char* port, bool isOwn);
  Status setBlackboard(int node);
  Status unsetBlackboard(int node);
  bool setEntry(int node, Slot& to, const Value& value);
  bool wasUpdated(int node, UpdateMemory& memory);
  void note(int node, LeafEvent::Kind kind);

  /// False with a fault when it fails. `truth` takes the result as a condition.
  bool runScript(int node, int script, bool* truth = nullptr);
  bool truthOf(int node, int script, bool& truth) { return runScript(node, script, &truth); }

  /// Ports of nodes that the engine runs; nothing = a fault was noted.
  template <class T>
  [[gnu::always_inline]] std::optional<T> need(int node, int port) {
    leaf_.moveTo(nodes_[node]);
    const T value = leaf_.require<T>(port);
    return isFaulty() ? std::nullopt : std::optional<T>(value);
  }
  const Value* portValue(int node, int port) const;
  std::optional<std::string_view> textOf(int node, int port) const {
    const Value* const value = portValue(node, port);
    return value ? valueAs<std::string_view>(*value) : std::nullopt;
  }
  bool hasElapsed(const TimerMemory& timer, std::int64_t milliseconds) const;

  const Program& program_;
  TreeState& state_;
  const TickInput& input_;
  const Program::Node* nodes_;  // and two columns of the state, for speed
  Status* stored_;
  Status* returned_;
  bool isFaulty_;
  int rounds_ = 0;    // of children that decorators and the library's nodes have ticked
  LeafContext leaf_;  // of the synchronous leaf that is ticked, or the node whose ports are read
};

}  // namespace bt
