#pragma once

#include <vector>

#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Doors that open and close at their times.
class Doors {
 public:
  explicit Doors(const WorldModel& model) : next_(model.doors.size(), 0) {}

  /// Switches the doors whose times have come (by state.time), emits `door`; returns the numbers of
  /// those switched.
  std::vector<int> advance(const WorldModel& model, WorldState& state);

 private:
  std::vector<std::size_t> next_;  // index of the next time, per door
};

}  // namespace sim2d
