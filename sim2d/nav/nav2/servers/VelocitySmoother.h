#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Body.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"

namespace sim2d::nav2 {

/// Mean of the velocities measured within a duration (nav2_util::OdomSmoother).
class OdometrySmoother {
 public:
  explicit OdometrySmoother(double duration) : duration_(duration) {}

  void add(double time, const BodyTwist& twist) {  // precondition: not before the last one [s]
    constexpr double kRounding = 1e-9;             // [s]
    while (!history_.empty() && time - history_.front().time > duration_ + kRounding) {
      history_.pop_front();
    }
    history_.push_back({time, twist});
  }
  BodyTwist mean() const {  // zero without measurements
    BodyTwist sum;
    for (const Entry& entry : history_) {
      sum.linear += entry.twist.linear / static_cast<double>(history_.size());
      sum.angular += entry.twist.angular / static_cast<double>(history_.size());
      sum.lateral += entry.twist.lateral / static_cast<double>(history_.size());
    }
    return sum;
  }

 private:
  struct Entry {
    double time = 0.0;  // [s]
    BodyTwist twist;
  };
  double duration_;  // [s]
  std::deque<Entry> history_;
};

/// Keys of velocity_smoother; lists contain v_x, v_y, omega.
struct VelocitySmootherParameters {
  double smoothingFrequency = 20.0;  // [Hz]
  bool scaleVelocities = false;
  std::string feedback = "OPEN_LOOP";                      // or CLOSED_LOOP
  std::vector<double> maxVelocity = {0.50, 0.0, 2.5};      // [m/s], [m/s], [rad/s]
  std::vector<double> minVelocity = {-0.50, 0.0, -2.5};    // as maxVelocity
  std::vector<double> maxAccel = {2.5, 0.0, 3.2};          // [m/s²], [m/s²], [rad/s²]
  std::vector<double> maxDecel = {-2.5, 0.0, -3.2};        // as maxAccel
  double odomDuration = 0.1;                               // [s]
  std::vector<double> deadbandVelocity = {0.0, 0.0, 0.0};  // as maxVelocity
  double velocityTimeout = 1.0;                            // [s]
};
Nav2Keys<VelocitySmootherParameters> velocitySmootherKeys();
IgnoredKeys ignoredVelocitySmootherKeys();
/// Errors: lists without three elements, wrong signs, minima above maxima, an unknown feedback.
base::Diagnostics problemsOf(const VelocitySmootherParameters& parameters);

/// Limits of one axis.
struct AxisLimits {
  double accel = 0.0, decel = 0.0;  // decel <= 0
  double frequency = 20.0;          // [Hz]
};
/// Factor that limits the change of velocity; -1: the change is within the limits.
double axisScale(double current, double command, const AxisLimits& limits);
/// `current` plus `scale` times the change, clamped to the limits.
double limitedAxis(double current, double command, const AxisLimits& limits, double scale);

/// Limits velocities and accelerations of commands (nav2_velocity_smoother). Not thread-safe.
class VelocitySmoother {
 public:
  explicit VelocitySmoother(const VelocitySmootherParameters& parameters);  // requires no errors

  /// Receives a command at a time [s].
  void command(const BodyTwist& twist, double time);
  /// Called each step: returns the command to send at the first step not before n /
  /// smoothing_frequency; nullopt in between, before the first command, and once the robot has
  /// stopped after `velocity_timeout`.
  std::optional<BodyTwist> update(double time, const BodyTwist& measured);

 private:
  using Axes = std::array<double, 3>;  // v_x, v_y, omega
  Axes smoothed(const Axes& current) const;

  VelocitySmootherParameters parameters_;
  OdometrySmoother odometry_;
  std::optional<Axes> command_;
  Axes last_ = {0.0, 0.0, 0.0};  // last sent, before the deadband
  double commandTime_ = 0.0;     // [s]
  std::int64_t lastTick_ = -1;
  bool isStopped_ = false;
};

}  // namespace sim2d::nav2
