#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "bt/engine/Program.h"
#include "bt/engine/TreeState.h"

/// Per-agent memory of the engine's nodes, and the table of nodes that the engine runs itself.
namespace bt {

/// A node type and the functions that run it.
struct BuiltinNode {
  std::string_view id;  // in XML; empty for library nodes
  std::size_t memory;   // [bytes] of its struct below
  NodeRunner run;
  NodeHalter halt = nullptr;
  NodeRunner instant = nullptr;      // replaces `run` if all children are instant
  const char* scriptPort = nullptr;  // port whose text is the script in `detail`
  const char* keyPort = nullptr;     // port whose text names the slot in `detail`
  bool hasChildBits = false;         // one bit per child follows its memory
};

inline int roundUpToWord(std::size_t bytes) {
  return static_cast<int>((bytes + 7) / 8 * 8);
}

/// Node memory; all zero in a new tree. IfThenElse and Switch store the node of the chosen child
/// (0: none yet), Repeat and Retry a count, RunOnce the result (IDLE: has not run), Precondition
/// whether the child is running.
struct SequenceMemory {
  std::int32_t next = 0;  // node to resume at; 0: the first child
  std::int32_t skipped = 0;
};
struct TryCatchMemory {
  std::int32_t next = 0;
  std::int32_t skipped = 0;
  bool catching = false;
};
/// Followed by one bit per child: completed in this run.
struct ParallelMemory {
  std::int32_t successes = 0;
  std::int32_t failures = 0;
};
/// Size of a Parallel's memory with its bits.
inline int parallelBytes(int children) {
  return roundUpToWord(sizeof(ParallelMemory)) +
         roundUpToWord((static_cast<std::size_t>(children) + 7) / 8);
}
struct TimerMemory {
  std::int64_t startStep = 0;
  bool started = false;
};
struct LoopMemory {
  std::int32_t taken = 0;  // elements taken from a constant queue since the start
  bool running = false;
};
struct UpdateMemory {
  std::uint32_t seen = 0;  // version of the entry plus 1; 0: never read
  bool running = false;
};

/// Executes one tick or halt of one tree. Private to the engine; leaves access it through
/// LeafContext.
class Ticker {
 public:
  Ticker(const Program& program, TreeState& state, const TickInput& input)
      : program_(program),
        state_(state),
        input_(input),
        nodes_(program.nodes().data()),
        stored_(state.stored()),
        returned_(state.returned()),
        results_(state.results_),
        isFaulty_(state.fault_ != nullptr),
        leaf_(*this, input, 0) {}

  /// nullptr for library nodes.
  static const BuiltinNode* builtin(std::string_view id);
  static BuiltinNode libraryNode(const NodeFunctions& functions);
  /// A complete tick of a node: conditions, its code, status updates.
  base::NodeStatus tickNode(int node);
  /// Halts the node if it is RUNNING, then sets it to IDLE.
  void resetChild(int node);

  [[gnu::cold]] base::NodeStatus fault(int node, std::string message);
  bool isFaulty() const { return isFaulty_; }
  /// Returned by ticks of a faulty tree; passed up to the root.
  static constexpr auto kFault = static_cast<base::NodeStatus>(5);
  /// Limit per tick of the root: five times the size of the largest tree.
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
  [[gnu::always_inline]] void setReturned(int node, Status status) {
    returned_[node] = status;
    if (results_ != nullptr) {
      results_[node] = base::with(results_[node], status);
    }
  }
  const Program::Conditions& conditionsOf(const Program::Node& node) const {
    return program_.conditions()[static_cast<std::size_t>(node.conditions)];
  }
  /// Functions of a library node.
  const NodeFunctions& functionsOf(int node) const {
    return program_.functions(nodes_[node].detail);
  }
  int endOf(int node) const { return nodes_[node].end; }
  void resetChildren(int node);
  void resetFrom(int first, int node);  // the children of `node`, starting at `first`
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
  static void clearRunningFlag(Ticker& ticker, int node);
  static void noteHalt(Ticker& ticker, int node);
  static void haltStateful(Ticker& ticker, int node);
  static void haltParent(Ticker& ticker, int node);
  static void haltParallel(Ticker& ticker, int node);
  static void haltTryCatch(Ticker& ticker, int node);
  /// Handles a status that a parent cannot process: IDLE of a child is a fault.
  [[gnu::cold]] Status unexpected(int child, Status status);
  /// Ticks the child of a decorator. `marks`: the decorator is RUNNING during the tick.
  Status tickOnlyChild(int node, bool marks = true) {
    if (marks) {
      stored(node) = Status::Running;
    }
    const Status status = tickNode(node + 1);
    return status == Status::Idle ? unexpected(node + 1, status) : status;
  }

  template <Status stop>  // status of a child for which its parent continues
  static constexpr Status kContinueStatus =
      stop == Status::Failure ? Status::Success : Status::Failure;
  template <Status stop, bool yields = false, bool remembers = false>
  Status sequence(int node);
  template <Status stop>
  Status reactive(int node);
  Status parallel(int node);
  Status parallelAll(int node);
  /// Limits of a Parallel, read at the start of a tick. countsSkipped: skipped children count as
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
  Status tickRepetition(int child, std::int32_t& count);
  template <Status again>
  Status repeat(int node);
  Status keepRunning(int node);
  /// Status of a decorator that runs until its child fails or the tree is faulty.
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
    leaf_.switchToNode(here);
    const Status status = function(leaf_);
    return isDone(status) && !isFaulty() ? status : unexpected(node, status);
  }
  /// Inlined tickNode, for the children of a control.
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
    setReturned(node, status);
    if (here.hasOneChild && isDone(stored_[node + 1])) {
      stored_[node + 1] = Status::Idle;
    }
    return status;
  }
  /// The same for instant nodes.
  [[gnu::always_inline]] Status tickInstant(const Program::Node& here, int node) {
    const Status status = here.tick ? synchronous(here, node, here.tick) : here.run(*this, node);
    if (status != kFault) {
      setReturned(node, status);
    }
    return status;
  }
  template <Status stop>
  static Status instantSequence(Ticker& ticker, int node);
  static Status instantInverter(Ticker& ticker, int node);
  template <Status result>
  static Status instantForce(Ticker& ticker, int node);
  Status librarySynchronous(int node);
  Status stateful(int node);
  Status script(int node);
  Status scriptCondition(int node);
  Status wasEntryUpdated(int node);
  Status sleep(int node);
  std::optional<Slot*> target(int node, const char* port, bool isOwn);
  Status setBlackboard(int node);
  Status unsetBlackboard(int node);
  bool setBlackboardEntry(int node, Slot& to, const Value& value);
  bool wasUpdated(int node, UpdateMemory& memory);
  void note(int node, LeafEvent::Kind kind);

  /// Returns false, with a fault, on an error. `truth` receives the result as a condition.
  bool runScript(int node, int script, bool* truth = nullptr);
  bool evaluateCondition(int node, int script, bool& truth) {
    return runScript(node, script, &truth);
  }

  /// Reads a port of a node that the engine runs; empty: a fault was raised.
  template <class T>
  [[gnu::always_inline]] std::optional<T> readRequired(int node, int port) {
    leaf_.switchToNode(nodes_[node]);
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
  const Program::Node* nodes_;  // cached, together with two status arrays, for speed
  Status* stored_;
  Status* returned_;
  base::StatusSet* results_;  // null: not recorded
  bool isFaulty_;
  int rounds_ = 0;    // child ticks by decorators and library nodes
  LeafContext leaf_;  // of the current synchronous leaf or the node whose ports are read
};

}  // namespace bt
