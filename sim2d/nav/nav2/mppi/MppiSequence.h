#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"
#include "sim2d/nav/nav2/mppi/TrajectoryKernel.h"

/// The control sequence that Nav2's MPPI keeps between calls, and operations on it.
namespace sim2d::nav2 {

/// Indexed by axis: vx [m/s], wz [rad/s], vy [m/s].
using MppiControl = std::array<float, 3>;
using MppiSequence = std::array<std::vector<float>, 3>;

/// Kinematic limits by axis.
struct MppiLimits {
  MppiControl low{}, high{};    // velocities
  MppiControl least{}, most{};  // accelerations, <= 0 and >= 0 [m/s²], [rad/s²]
  float turningRadius = 0.2F;   // of Ackermann [m]
};
MppiLimits mppiLimitsOf(const MppiSettings& settings);
/// Limits the maximum forward speed to `limit` [m/s] or percent, and scales the other velocities in
/// proportion. 0: unchanged. Accelerations are kept.
MppiLimits withSpeedLimit(const MppiLimits& limits, double limit, bool isPercentage);

/// The velocity nearest to `wanted` reachable from `now` in `dt` [s]. A robot driving forward may
/// gain `most` and lose `least`; for a reversing or standing one they are swapped, as in Nav2.
float reachable(float wanted, float now, float least, float most, float dt);

/// Ackermann: |wz| <= |vx| / radius.
void limitTurningRadius(MppiSequence& sequence, float radius);
/// Until Jazzy: limits velocities, and since Jazzy changes between elements; the first element is
/// not limited by the current velocity. Call before limitTurningRadius.
void limitChanges(MppiSequence& sequence, const MppiLimits& limits, float dt,
                  bool limitsAccelerations);
/// Main: limits velocities and changes from the current velocity. `firstDt`: the controller period,
/// or 0 if the first element is the current velocity.
void limitChangesFromSpeed(MppiSequence& sequence, const MppiLimits& limits,
                           const MppiControl& speed, float firstDt, float dt);
/// Main, before noise is added: limits the first element to the current velocity, or to what is
/// reachable from it within the controller period.
void limitFirstToSpeed(MppiSequence& sequence, const MppiLimits& limits, const MppiControl& speed,
                       float firstDt);

/// Shifts by one step; repeats the last element.
void shiftByOne(MppiSequence& sequence);

/// Savitzky-Golay filter over nine elements (order 2), or their mean (order 1). `sent`: the four
/// commands before the first element, latest last. Keeps the last element. Returns false without
/// changes for sequences of fewer than 21 elements.
bool filterSequence(MppiSequence& sequence, const std::array<MppiControl, 4>& sent, int order);

/// The poses that result from a sequence; each step uses the heading at its start.
Path integratePath(const Pose2& start, const MppiSequence& sequence, double dt);

/// Counts the failures of a cycle up to the retry limit.
class MppiRetries {
 public:
  enum class Next { Done, Retry, GiveUp };
  explicit MppiRetries(int limit) : limit_(limit) {}
  Next after(bool hasFailed);

 private:
  int limit_;
  int count_ = 0;
};

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
