#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "bt/engine/Script.h"
#include "bt/engine/TreeState.h"
#include "sim2d/base/Result.h"
#include "sim2d/world/TreeBreakpoint.h"

namespace bt {

/// Problems of a breakpoint's condition: a syntax error, or an assignment.
base::Diagnostics checkBreakpoint(const sim2d::TreeBreakpoint& point);

/// Checks trees after their ticks for breakpoints. Not synchronised. A condition on entries that a
/// tree does not have, or that have no value, is false.
class Breakpoints {
 public:
  /// Breakpoints with problems (checkBreakpoint) are ignored.
  void set(std::vector<sim2d::TreeBreakpoint> points);
  bool isEmpty() const { return watches_.empty(); }
  /// Call after each tick of this person's tree.
  void look(int person, const TreeState& tree);
  /// Resets the state of a person who has a new tree.
  void forget(int person);
  /// Returns and clears the first breakpoint hit since the last call.
  std::optional<sim2d::TreeBreakpointHit> take() { return std::exchange(hit_, std::nullopt); }

 private:
  /// A breakpoint resolved for one program.
  struct ResolvedBreakpoint {
    std::shared_ptr<const std::vector<std::string>> paths;  // keeps the map key unique
    int node = -1;                                          // -1: no such node
    std::optional<Script> condition;                        // empty: an entry of it is missing
  };
  struct Watch {
    sim2d::TreeBreakpoint point;
    std::map<const Program*, ResolvedBreakpoint> places;
    std::set<int> people;  // ids of people for whom it currently holds
  };
  static const ResolvedBreakpoint& placeIn(Watch& watch, const Program& program);
  static bool holds(const Watch& watch, const ResolvedBreakpoint& place, const TreeState& tree);

  std::vector<Watch> watches_;
  std::optional<sim2d::TreeBreakpointHit> hit_;
};

}  // namespace bt
