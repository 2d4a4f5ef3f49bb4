#pragma once

#include <optional>
#include <string>

#include "sim2d/base/Types.h"

namespace sim2d {

/// Stops a run after the step in which a node of a behaviour tree starts to match. The match must
/// end before it stops the run again.
struct TreeBreakpoint {
  std::optional<int> person;               // id; none: any person
  std::string path;                        // of the node, as in trees.csv
  std::optional<base::NodeStatus> status;  // returned status; none: any tick
  std::string condition;  // optional script on the person's blackboard that must also hold

  friend bool operator==(const TreeBreakpoint& a, const TreeBreakpoint& b) {
    return a.person == b.person && a.path == b.path && a.status == b.status &&
           a.condition == b.condition;
  }
};

/// A breakpoint that was hit.
struct TreeBreakpointHit {
  TreeBreakpoint at;
  int person = 0;  // id
  base::NodeStatus status = base::NodeStatus::Idle;
};

}  // namespace sim2d
