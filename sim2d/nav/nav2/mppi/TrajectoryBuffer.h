#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

namespace sim2d::nav2 {

/// Owns the memory of a batch. `count` samples are used; padding samples fill the last block and
/// are computed but ignored.
class TrajectoryBuffer {
 public:
  TrajectoryBuffer(int count, int steps);

  int count() const { return count_; }
  int steps() const { return steps_; }
  TrajectoryBatch view();
  std::size_t elementIndex(int step, int sample) const;

  std::array<std::vector<float>, kTrajectoryAxes> noise, controls, speeds;
  std::vector<float> x, y, yaw;            // index: `elementIndex`
  std::vector<float> length, controlCost;  // index: sample

 private:
  int count_, samples_, steps_;
};

}  // namespace sim2d::nav2
