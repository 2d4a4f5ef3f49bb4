#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/NodeLibrary.h"
#include "bt/engine/Program.h"
#include "sim2d/base/TreeResults.h"

/// The running tree of one agent: a few bytes per node and the blackboard. A tick does not
/// allocate. Follows BehaviorTree.CPP 4.10 (tickExactlyOnce) with simulated time. Not synchronised;
/// different agents may be ticked by different threads.
namespace bt {

/// The reason why a tree stopped permanently: missing input, invalid script …
struct TreeFault {
  int node = 0;
  std::string path;
  std::string message;
};

/// A stateful leaf started or ended in this tick.
struct LeafEvent {
  enum class Kind : std::uint8_t { Started, Succeeded, Failed, Halted };
  int node = 0;
  Kind kind = Kind::Started;
};

/// The statuses of all nodes of a program, in its order.
class StatusList {
 public:
  StatusList(const base::NodeStatus* first, std::size_t count) : first_(first), count_(count) {}

  const base::NodeStatus* begin() const { return first_; }
  const base::NodeStatus* end() const { return first_ + count_; }
  std::size_t size() const { return count_; }
  base::NodeStatus operator[](std::size_t node) const { return first_[node]; }
  friend bool operator==(const StatusList& a, const StatusList& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

 private:
  const base::NodeStatus* first_;
  std::size_t count_;
};

class TreeState {
 public:
  explicit TreeState(std::shared_ptr<const Program> program);

  /// One tick of the tree. After SUCCESS and FAILURE of the root the tree can start again. A faulty
  /// tree returns IDLE and does nothing.
  base::NodeStatus tickOnce(const TickInput& input);
  /// Halts all RUNNING nodes.
  void halt(const TickInput& input);
  /// Restores the initial state (RunOnce nodes, entries); no halt function is called.
  void reset();

  /// From now on, each status that a node returns is added to `results[node]`; null: no longer. The
  /// memory must outlive the ticks; trees of the same program can share it.
  void recordResults(base::StatusSet* results) { results_ = results; }

  const Program& program() const { return *program_; }

  /// Result of each node in the last tick; IDLE: not ticked. Valid until the next tick.
  StatusList statuses() const { return {returned(), nodeCount()}; }
  /// Events of the last tick (and of a halt() after it) in chronological order.
  const std::vector<LeafEvent>& events() const { return events_; }
  const TreeFault* fault() const { return fault_.get(); }  // null: none

  /// Access to entries by slot (Program::findSlot, hostSlot). False: the value does not fit the
  /// type.
  template <class T>
  bool set(int slot, const T& value) {  // int, double or Value
    return store(slots_[static_cast<std::size_t>(slot)], value);
  }
  /// Sets the entry with that key, named as in entries(), from text. The text is converted to the
  /// type of the entry or, without a declared type, to the type of its value if possible. Returns
  /// false if there is no such entry or if the text does not fit.
  bool setFromText(const std::string& key, const std::string& text);
  const Value& get(int slot) const { return slots_[static_cast<std::size_t>(slot)].value; }
  /// Evaluates a condition that assigns nothing; empty: an entry has no value, or the result is not
  /// a truth value. Its slots are those of the program.
  std::optional<bool> evaluateCondition(const Script& condition) const;
  /// Keys and values of all entries that are set, in the order of the program.
  std::vector<std::pair<std::string, std::string>> entries() const;

 private:
  friend class Ticker;
  static_assert(sizeof(base::NodeStatus) == 1);
  std::size_t nodeCount() const { return static_cast<std::size_t>(program_->nodeCount()); }
  std::size_t memoryWords() const {
    return static_cast<std::size_t>(program_->memoryBytes()) / sizeof(std::uint64_t);
  }
  base::NodeStatus* stored() const {
    return reinterpret_cast<base::NodeStatus*>(memory_.get() + memoryWords());
  }
  base::NodeStatus* returned() const { return stored() + nodeCount(); }
  void clearReturned() { std::fill_n(returned(), nodeCount(), base::NodeStatus::Idle); }

  std::shared_ptr<const Program> program_;
  std::unique_ptr<std::uint64_t[]> memory_;  // node memory, then stored and returned statuses
  std::unique_ptr<Slot[]> slots_;
  std::vector<LeafEvent> events_;
  std::unique_ptr<TreeFault> fault_;
  base::StatusSet* results_ = nullptr;  // per node, see recordResults()
};

}  // namespace bt
