#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/Costmap.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"

/// The sequence of controls that Nav2's MPPI carries from call to call, and what is done to it.
namespace sim2d::nav2 {

/// By axis: vx [m/s], wz [rad/s], vy [m/s].
using MppiControl = std::array<float, 3>;
using MppiSequence = std::array<std::vector<float>, 3>;

/// What the drive can do, by axis.
struct MppiLimits {
  MppiControl low{}, high{};    // speeds
  MppiControl least{}, most{};  // accelerations, <= 0 and >= 0 [m/s²], [rad/s²]
  float turningRadius = 0.2F;   // of Ackermann [m]
};
MppiLimits mppiLimitsOf(const MppiSettings& settings);
/// Speeds limited to `limit` [m/s], or to so many percent, of the greatest ahead; the others in
/// proportion. 0: as they were. Accelerations stay.
MppiLimits limitedTo(const MppiLimits& limits, double limit, bool isPercentage);

/// What can be reached from `now` in `dt` [s]: a robot that goes ahead may gain `most` and lose
/// `least`, one that goes back or stands the other way round, as Nav2 has it.
float reachable(float wanted, float now, float least, float most, float dt);

/// Ackermann: |wz| <= |vx| / radius.
void limitTurns(MppiSequence& sequence, float radius);
/// Until Jazzy: speeds, and since Jazzy changes from element to element; the first is not tied to
/// the present speed. `isAckermann` last.
void limitEachOther(MppiSequence& sequence, const MppiLimits& limits, float dt,
                    bool limitsAccelerations);
/// Main: speeds and changes from the present speed on. `firstDt`: the controller's period, 0 when
/// the first element is the present speed.
void limitFromSpeed(MppiSequence& sequence, const MppiLimits& limits, const MppiControl& speed,
                    float firstDt, float dt);
/// Main, before noise is added: the first element is the present speed, or what can be reached of
/// it within the controller's period.
void tieToSpeed(MppiSequence& sequence, const MppiLimits& limits, const MppiControl& speed,
                float firstDt);

/// One step on; the last element is held.
void shiftByOne(MppiSequence& sequence);

/// Filter of Savitzky and Golay over nine elements, order 2, or their mean, order 1. `sent`: the
/// last four before the first, latest last. The last element stays; sequences of fewer than 21 stay
/// whole: false.
bool filterSequence(MppiSequence& sequence, const std::array<MppiControl, 4>& sent, int order);

/// Where the robot gets by a sequence, as each step drives along the heading at its begin.
Path integrated(const Pose2& start, const MppiSequence& sequence, double dt);

/// Failures of a cycle: so many are tried again.
class MppiRetries {
 public:
  enum class Next { Done, Retry, GiveUp };
  explicit MppiRetries(int limit) : limit_(limit) {}
  Next after(bool hasFailed);

 private:
  int limit_;
  int count_ = 0;
};

}  // namespace sim2d::nav2
