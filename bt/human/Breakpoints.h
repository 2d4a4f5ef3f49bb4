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

/// What is wrong with the condition of a breakpoint: it cannot be read, or it would change entries.
base::Diagnostics checkBreakpoint(const sim2d::TreeBreakpoint& point);

/// Looks at trees after their ticks for what a run is to stop at. One thread. A condition on
/// entries that a tree does not have, or that have no value yet, does not hold.
class Breakpoints {
 public:
  /// Those with problems (checkBreakpoint) are never met.
  void set(std::vector<sim2d::TreeBreakpoint> points);
  bool isEmpty() const { return watches_.empty(); }
  /// After a tick of this person's tree.
  void look(int person, const TreeState& tree);
  /// A new mind: nothing was met yet.
  void forget(int person);
  /// The first that was met since the last call.
  std::optional<sim2d::TreeBreak> take() { return std::exchange(met_, std::nullopt); }

 private:
  /// Of one program.
  struct Place {
    std::shared_ptr<const std::vector<std::string>> paths;  // keeps the key of the map alive
    int node = -1;                                          // -1: it has no such node
    std::optional<Script> condition;                        // none: an entry of it is missing
  };
  struct Watch {
    sim2d::TreeBreakpoint point;
    std::map<const Program*, Place> places;
    std::set<int> people;  // for whom it holds now
  };
  static const Place& placeIn(Watch& watch, const Program& program);
  static bool holds(const Watch& watch, const Place& place, const TreeState& tree);

  std::vector<Watch> watches_;
  std::optional<sim2d::TreeBreak> met_;
};

}  // namespace bt
