#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/LeafContext.h"
#include "bt/engine/Program.h"

/// One agent's running tree: a few bytes per node and the blackboard. A tick allocates nothing.
/// Rules of BehaviorTree.CPP 4.10 (tickExactlyOnce), with simulated time. One thread at a time;
/// different agents may be ticked by different threads.
namespace bt {

/// Why a tree stopped for good: missing input, bad script …
struct TreeFault {
  int node = 0;
  std::string path;
  std::string message;
};

/// A stateful leaf began or ended in this tick.
struct LeafEvent {
  enum class Kind : std::uint8_t { Started, Succeeded, Failed, Halted };
  int node = 0;
  Kind kind = Kind::Started;
};

/// Of all nodes of a program, in its order.
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

  /// One step of the tree. SUCCESS and FAILURE of the root leave the tree ready to start again.
  /// A faulty tree returns IDLE and does nothing.
  base::NodeStatus tickOnce(const TickInput& input);
  /// Halts what is RUNNING.
  void halt(const TickInput& input);
  /// As newly made (RunOnce forgets, entries have their first values); nobody is halted.
  void reset();

  const Program& program() const { return *program_; }

  /// What each node returned in the last tick; IDLE = it was not ticked. Good until the next.
  StatusList statuses() const { return {returned(), nodeCount()}; }
  /// Of the last tick (and of a halt() after it), in the order in which they happened.
  const std::vector<LeafEvent>& events() const { return events_; }
  const TreeFault* fault() const { return fault_.get(); }  // null: none

  /// Entries by slot (Program::findSlot, hostSlot). False = the value does not fit its type.
  template <class T>
  bool set(int slot, const T& value) {  // int, double or Value
    return store(slots_[static_cast<std::size_t>(slot)], value);
  }
  /// The entry of that key, as entries() names it, from a text: of its type; where none is fixed,
  /// of the type of its value if the text fits that. False: there is no such entry, or it does not
  /// fit.
  bool setFromText(const std::string& key, const std::string& text);
  const Value& get(int slot) const { return slots_[static_cast<std::size_t>(slot)].value; }
  /// What a script that changes nothing says of the entries; nothing: one has no value, or it is no
  /// truth. Its slots are those of the program.
  std::optional<bool> truthOf(const Script& condition) const;
  /// Keys and texts of what is set, in the order of the program.
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
  std::unique_ptr<std::uint64_t[]> memory_;  // of the nodes; then what they keep, and returned
  std::unique_ptr<Slot[]> slots_;
  std::vector<LeafEvent> events_;
  std::unique_ptr<TreeFault> fault_;
};

}  // namespace bt
