#include "sim2d/nav/nav2/mppi/TrajectoryBuffer.h"

#include <cstddef>
#include <vector>

namespace sim2d::nav2 {

TrajectoryBuffer::TrajectoryBuffer(int count, int steps)
    : count_(count),
      samples_((count + kMppiColumns - 1) / kMppiColumns * kMppiColumns),
      steps_(steps) {
  const std::size_t size = static_cast<std::size_t>(samples_) * static_cast<std::size_t>(steps);
  for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
    noise[axis].assign(size, 0.0F);
    controls[axis].assign(size, 0.0F);
    speeds[axis].assign(size, 0.0F);
  }
  for (std::vector<float>* column : {&x, &y, &yaw}) {
    column->assign(size, 0.0F);
  }
  length.assign(static_cast<std::size_t>(samples_), 0.0F);
  controlCost.assign(static_cast<std::size_t>(samples_), 0.0F);
}

std::size_t TrajectoryBuffer::elementIndex(int step, int sample) const {
  const auto block = static_cast<std::size_t>(sample / kMppiColumns);
  const std::size_t row = block * static_cast<std::size_t>(steps_) + static_cast<std::size_t>(step);
  return row * kMppiColumns + static_cast<std::size_t>(sample % kMppiColumns);
}

TrajectoryBatch TrajectoryBuffer::view() {
  TrajectoryBatch batch;
  batch.samples = samples_;
  batch.steps = steps_;
  for (std::size_t axis = 0; axis < kTrajectoryAxes; ++axis) {
    batch.noise[axis] = noise[axis].data();
    batch.controls[axis] = controls[axis].data();
    batch.speeds[axis] = speeds[axis].data();
  }
  batch.x = x.data();
  batch.y = y.data();
  batch.yaw = yaw.data();
  batch.length = length.data();
  batch.controlCost = controlCost.data();
  return batch;
}

}  // namespace sim2d::nav2
