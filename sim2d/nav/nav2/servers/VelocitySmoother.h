#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Nav2Key.h"
#include "sim2d/nav/nav2/servers/OdometrySmoother.h"

namespace sim2d::nav2 {

/// Keys of velocity_smoother; lists are of v_x, v_y, omega.
struct VelocitySmootherParameters {
  double smoothingFrequency = 20.0;  // [Hz]
  bool scaleVelocities = false;
  std::string feedback = "OPEN_LOOP";                      // or CLOSED_LOOP
  std::vector<double> maxVelocity = {0.50, 0.0, 2.5};      // [m/s], [m/s], [rad/s]
  std::vector<double> minVelocity = {-0.50, 0.0, -2.5};    // idem
  std::vector<double> maxAccel = {2.5, 0.0, 3.2};          // [m/s²], [m/s²], [rad/s²]
  std::vector<double> maxDecel = {-2.5, 0.0, -3.2};        // idem
  double odomDuration = 0.1;                               // [s]
  std::vector<double> deadbandVelocity = {0.0, 0.0, 0.0};  // as maxVelocity
  double velocityTimeout = 1.0;                            // [s]
};
const std::vector<Nav2Key<VelocitySmootherParameters>>& velocitySmootherKeys();
const std::vector<IdleKey>& idleVelocitySmootherKeys();
/// Errors: lists that are not of three, signs, minima above maxima, an unknown feedback.
base::Diagnostics problemsOf(const VelocitySmootherParameters& parameters);

/// Limits of one axis.
struct AxisLimits {
  double accel = 0.0, decel = 0.0;  // decel <= 0
  double frequency = 20.0;          // [Hz]
};
/// Factor by which a change of velocity is too large; -1: it is not.
double axisScale(double current, double command, const AxisLimits& limits);
/// `current` plus `scale` times the change, held to the limits.
double limitedAxis(double current, double command, const AxisLimits& limits, double scale);

/// Limits speeds and accelerations of commands (nav2_velocity_smoother). Thread: one at a time.
class VelocitySmoother {
 public:
  explicit VelocitySmoother(const VelocitySmootherParameters& parameters);  // without errors

  /// A command has come, at a time [s].
  void command(const BodyTwist& twist, double time);
  /// Each step: what is sent on, at the first step not before n / smoothing_frequency; nothing in
  /// between, before the first command, and once the robot stands after `velocity_timeout`.
  std::optional<BodyTwist> update(double time, const BodyTwist& measured);

 private:
  using Axes = std::array<double, 3>;  // v_x, v_y, omega
  Axes smoothed(const Axes& current) const;

  VelocitySmootherParameters parameters_;
  OdometrySmoother odometry_;
  std::optional<Axes> command_;
  Axes last_ = {0.0, 0.0, 0.0};  // sent last, before the deadband
  double commandTime_ = 0.0;     // [s]
  std::int64_t lastTick_ = -1;
  bool isStopped_ = false;
};

}  // namespace sim2d::nav2
