#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
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
  const std::shared_ptr<const Program>& sharedProgram() const { return program_; }

  /// What each node returned in the last tick; IDLE = it was not ticked.
  const std::vector<base::NodeStatus>& statuses() const { return returned_[now_ ? 1 : 0]; }
  /// Nodes for which that differs from the tick before, ascending.
  const std::vector<int>& changes();
  /// Of the last tick (and of a halt() after it), in the order in which they happened.
  const std::vector<LeafEvent>& events() const { return events_; }
  const std::optional<TreeFault>& fault() const { return fault_; }

  /// Entries by slot (Program::findSlot, hostSlot). False = the value does not fit its type.
  bool set(int slot, int value) { return store(slotAt(slot), value); }
  bool set(int slot, double value) { return store(slotAt(slot), value); }
  bool set(int slot, const Value& value) { return store(slotAt(slot), value); }
  const Value& get(int slot) const { return slots_[static_cast<std::size_t>(slot)].value; }
  struct EntryText {
    std::string key;
    std::string text;
  };
  std::vector<EntryText> entries() const;  // what is set, in the order of the program

 private:
  friend class Ticker;
  void clearReturned();
  Slot& slotAt(int slot) { return slots_[static_cast<std::size_t>(slot)]; }

  std::shared_ptr<const Program> program_;
  std::vector<base::NodeStatus> stored_;
  std::array<std::vector<base::NodeStatus>, 2> returned_;  // of this tick and the one before
  bool now_ = false;                                       // which of them is of this one
  std::vector<std::uint64_t> memory_;
  std::vector<Slot> slots_;
  std::vector<int> changes_;
  bool changesKnown_ = true;  // they are looked for when somebody asks
  std::vector<LeafEvent> events_;
  std::vector<Value> stack_;  // of scripts
  std::optional<TreeFault> fault_;
};

}  // namespace bt
