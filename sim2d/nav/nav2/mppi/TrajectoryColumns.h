#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

namespace sim2d::nav2 {

/// Owns a batch. `count` samples count; those that fill the last block up are computed too and
/// asked by nobody.
class TrajectoryColumns {
 public:
  TrajectoryColumns(int count, int steps);

  int count() const { return count_; }
  int steps() const { return steps_; }
  TrajectoryBatch view();
  std::size_t placeOf(int step, int sample) const;

  std::array<std::vector<float>, kTrajectoryAxes> noise, controls, speeds;
  std::vector<float> x, y, yaw;     // by `placeOf`
  std::vector<float> length, pull;  // by sample

 private:
  int count_, samples_, steps_;
};

}  // namespace sim2d::nav2
