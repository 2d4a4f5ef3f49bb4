#include "sim2d/nav/nav2/mppi/MppiSequence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sim2d/base/Math.h"
#include "sim2d/nav/mppi/MppiUpdate.h"

namespace sim2d::nav2 {
namespace {

constexpr std::size_t kMinFiltered = 21;

float limited(float value, float low, float high) {
  return std::min(high, std::max(low, value));
}

}  // namespace

MppiLimits mppiLimitsOf(const MppiSettings& settings) {
  MppiLimits limits;
  limits.low = {toFloat(settings.vxMin), toFloat(-settings.wzMax), toFloat(-settings.vyMax)};
  limits.high = {toFloat(settings.vxMax), toFloat(settings.wzMax), toFloat(settings.vyMax)};
  limits.least = {toFloat(settings.axMin), toFloat(-settings.azMax), toFloat(settings.ayMin)};
  limits.most = {toFloat(settings.axMax), toFloat(settings.azMax), toFloat(settings.ayMax)};
  limits.turningRadius = toFloat(settings.minTurningRadius);
  return limits;
}

MppiLimits withSpeedLimit(const MppiLimits& limits, double limit, bool isPercentage) {
  if (limit == 0.0) {
    return limits;
  }
  const double share = isPercentage ? limit / 100.0 : limit / static_cast<double>(limits.high[0]);
  MppiLimits scaled = limits;
  for (std::size_t axis = 0; axis < scaled.low.size(); ++axis) {
    scaled.low[axis] *= static_cast<float>(share);
    scaled.high[axis] *= static_cast<float>(share);
  }
  return scaled;
}

float reachable(float wanted, float now, float least, float most, float dt) {
  const bool isAhead = now > 0.0F;
  return limited(wanted, now + dt * (isAhead ? least : -most),
                 now + dt * (isAhead ? most : -least));
}

void limitTurningRadius(MppiSequence& sequence, float radius) {
  for (std::size_t i = 0; i < sequence[0].size(); ++i) {
    const float most = std::abs(sequence[0][i]) / radius;
    sequence[1][i] = limited(sequence[1][i], -most, most);
  }
}

void limitChanges(MppiSequence& sequence, const MppiLimits& limits, float dt,
                  bool limitsAccelerations) {
  for (std::size_t axis = 0; axis < sequence.size(); ++axis) {
    std::vector<float>& controls = sequence[axis];
    for (std::size_t i = 0; i < controls.size(); ++i) {
      controls[i] = limited(controls[i], limits.low[axis], limits.high[axis]);
      if (limitsAccelerations && i > 0) {
        controls[i] =
            reachable(controls[i], controls[i - 1], limits.least[axis], limits.most[axis], dt);
      }
    }
  }
}

void limitChangesFromSpeed(MppiSequence& sequence, const MppiLimits& limits,
                           const MppiControl& speed, float firstDt, float dt) {
  for (std::size_t axis = 0; axis < sequence.size(); ++axis) {
    std::vector<float>& controls = sequence[axis];
    for (float& control : controls) {
      control = limited(control, limits.low[axis], limits.high[axis]);
    }
    controls[0] =
        reachable(controls[0], speed[axis], limits.least[axis], limits.most[axis], firstDt);
    for (std::size_t i = 1; i < controls.size(); ++i) {
      controls[i] =
          reachable(controls[i], controls[i - 1], limits.least[axis], limits.most[axis], dt);
    }
  }
}

void limitFirstToSpeed(MppiSequence& sequence, const MppiLimits& limits, const MppiControl& speed,
                       float firstDt) {
  for (std::size_t axis = 0; axis < sequence.size(); ++axis) {
    sequence[axis][0] =
        reachable(sequence[axis][0], speed[axis], limits.least[axis], limits.most[axis], firstDt);
  }
}

void shiftByOne(MppiSequence& sequence) {
  for (std::vector<float>& controls : sequence) {
    std::move(controls.begin() + 1, controls.end(), controls.begin());
  }
}

bool filterSequence(MppiSequence& sequence, const std::array<MppiControl, 4>& sent, int order) {
  if (sequence[0].size() < kMinFiltered) {
    return false;
  }
  for (std::size_t axis = 0; axis < sequence.size(); ++axis) {
    std::vector<float>& controls = sequence[axis];
    const std::array<float, 4> before = {sent[0][axis], sent[1][axis], sent[2][axis],
                                         sent[3][axis]};
    const float last = controls.back();
    controls = savitzkyGolay(controls, before, order);
    controls.back() = last;
  }
  return true;
}

Path integratePath(const Pose2& start, const MppiSequence& sequence, double dt) {
  Path path;
  path.reserve(sequence[0].size());
  Pose2 pose = start;
  for (std::size_t i = 0; i < sequence[0].size(); ++i) {
    const Vec2 way =
        dt * Vec2(static_cast<double>(sequence[0][i]), static_cast<double>(sequence[2][i]));
    pose.position = pose.toWorld(way);
    pose.heading = base::wrapToPi(pose.heading + dt * static_cast<double>(sequence[1][i]));
    path.push_back(pose);
  }
  return path;
}

MppiRetries::Next MppiRetries::after(bool hasFailed) {
  if (!hasFailed) {
    count_ = 0;
    return Next::Done;
  }
  if (++count_ > limit_) {
    count_ = 0;
    return Next::GiveUp;
  }
  return Next::Retry;
}

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
