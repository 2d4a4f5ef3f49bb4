#pragma once

#include <optional>
#include <string>

#include "sim2d/base/Types.h"

namespace sim2d {

/// Where a run is to stop: after the step in which a node of a behaviour tree begins to be like
/// this. It has to be otherwise before it stops the run again.
struct TreeBreakpoint {
  std::optional<int> person;               // id; none: anybody
  std::string path;                        // of the node, as in trees.csv
  std::optional<base::NodeStatus> status;  // that it returns; none: it is ticked at all
  std::string condition;  // script on the blackboard of the person that must hold too; may be empty

  friend bool operator==(const TreeBreakpoint& a, const TreeBreakpoint& b) {
    return a.person == b.person && a.path == b.path && a.status == b.status &&
           a.condition == b.condition;
  }
};

/// A breakpoint that was met.
struct TreeBreak {
  TreeBreakpoint at;
  int person = 0;  // id
  base::NodeStatus status = base::NodeStatus::Idle;
};

}  // namespace sim2d
