#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim2d/nav/Observation.h"

namespace sim2d::nav2 {
namespace {

constexpr double kTimeoutClock = 1e-9;  // [s], rounding of times

/// Maximum change of velocity in a tick, in either direction.
double maxChange(double current, double command, const AxisLimits& limits) {
  const bool isFaster = std::fabs(command) >= std::fabs(current) && current * command >= 0.0;
  return (isFaster ? limits.accel : -limits.decel) / limits.frequency;
}

std::array<double, 3> axesOf(const BodyTwist& twist) {
  return {twist.linear, twist.lateral, twist.angular};
}

}  // namespace

Nav2Keys<VelocitySmootherParameters> velocitySmootherKeys() {
  using P = VelocitySmootherParameters;
  return {
      {"smoothing_frequency", &P::smoothingFrequency, "Hz", "Commands sent per second."},
      {"scale_velocities", &P::scaleVelocities, "",
       "Whether all axes are scaled by the same factor, which keeps the curvature."},
      {"feedback", &P::feedback, "",
       "OPEN_LOOP: starts from the last command; CLOSED_LOOP: starts from the measured velocity."},
      {"max_velocity", &P::maxVelocity, "m/s, rad/s", "Maximum v_x, v_y, omega."},
      {"min_velocity", &P::minVelocity, "m/s, rad/s", "Minimum v_x, v_y, omega."},
      {"max_accel", &P::maxAccel, "m/s², rad/s²", "Maximum acceleration of each axis, at least 0."},
      {"max_decel", &P::maxDecel, "m/s², rad/s²", "Maximum deceleration of each axis, at most 0."},
      {"odom_duration", &P::odomDuration, "s", "Time over which measured velocities are averaged."},
      {"deadband_velocity", &P::deadbandVelocity, "m/s, rad/s", "Lower velocities are set to 0."},
      {"velocity_timeout", &P::velocityTimeout, "s",
       "Time without a command after which the robot brakes."},
  };
}

IgnoredKeys ignoredVelocitySmootherKeys() {
  return {
      {"odom_topic", "the odometry is that of the robot"},
  };
}

base::Diagnostics problemsOf(const VelocitySmootherParameters& parameters) {
  base::Diagnostics problems;
  ParameterChecks checks(problems);
  constexpr double kMaxFrequency = 1000.0;  // [Hz]
  checks.require(
      parameters.smoothingFrequency > 0.0 && parameters.smoothingFrequency <= kMaxFrequency,
      "smoothing_frequency", "above 0, up to 1000 Hz");
  checks.require(parameters.feedback == "OPEN_LOOP" || parameters.feedback == "CLOSED_LOOP",
                 "feedback", "OPEN_LOOP or CLOSED_LOOP");
  const std::pair<const char*, const std::vector<double>*> lists[] = {
      {"max_velocity", &parameters.maxVelocity},
      {"min_velocity", &parameters.minVelocity},
      {"max_accel", &parameters.maxAccel},
      {"max_decel", &parameters.maxDecel},
      {"deadband_velocity", &parameters.deadbandVelocity}};
  for (const auto& [key, values] : lists) {
    checks.require(values->size() == 3, key, "three numbers");
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    checks.require(parameters.maxAccel[axis] >= 0.0, "max_accel", "0 or more on each axis");
    checks.require(parameters.maxDecel[axis] <= 0.0, "max_decel", "0 or less on each axis");
    checks.require(parameters.minVelocity[axis] <= 0.0, "min_velocity", "0 or less on each axis");
    checks.require(parameters.maxVelocity[axis] >= 0.0, "max_velocity", "0 or more on each axis");
  }
  return problems;
}

double axisScale(double current, double command, const AxisLimits& limits) {
  const double change = command - current;
  const double most = maxChange(current, command, limits);
  if (change > most) {
    return most / change;
  }
  return change < -most ? -most / change : -1.0;
}

double limitedAxis(double current, double command, const AxisLimits& limits, double scale) {
  const double most = maxChange(current, command, limits);
  return current + std::clamp(scale * (command - current), -most, most);
}

VelocitySmoother::VelocitySmoother(const VelocitySmootherParameters& parameters)
    : parameters_(parameters), odometry_(parameters.odomDuration) {}

void VelocitySmoother::command(const BodyTwist& twist, double time) {
  command_ = axesOf(twist);
  commandTime_ = time;
}

std::optional<BodyTwist> VelocitySmoother::update(double time, const BodyTwist& measured) {
  odometry_.add(time, measured);
  const std::int64_t tick = eventIndexAt(time, parameters_.smoothingFrequency);
  if (tick <= lastTick_) {
    return std::nullopt;
  }
  lastTick_ = tick;
  if (!command_) {
    return std::nullopt;
  }
  if (time - commandTime_ > parameters_.velocityTimeout + kTimeoutClock) {
    isStopped_ = isStopped_ || last_ == Axes{0.0, 0.0, 0.0};
    if (isStopped_) {
      return std::nullopt;
    }
    command_ = Axes{0.0, 0.0, 0.0};
  }
  isStopped_ = false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    (*command_)[axis] =
        std::clamp((*command_)[axis], parameters_.minVelocity[axis], parameters_.maxVelocity[axis]);
  }
  last_ = smoothed(parameters_.feedback == "CLOSED_LOOP" ? axesOf(odometry_.mean()) : last_);
  Axes sent = last_;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sent[axis] = std::fabs(sent[axis]) < parameters_.deadbandVelocity[axis] ? 0.0 : sent[axis];
  }
  return BodyTwist{sent[0], sent[2], sent[1]};
}

VelocitySmoother::Axes VelocitySmoother::smoothed(const Axes& current) const {
  const auto limitsOf = [this](std::size_t axis) {
    return AxisLimits{parameters_.maxAccel[axis], parameters_.maxDecel[axis],
                      parameters_.smoothingFrequency};
  };
  double scale = 1.0;
  for (std::size_t axis = 0; axis < 3 && parameters_.scaleVelocities; ++axis) {
    const double own = axisScale(current[axis], (*command_)[axis], limitsOf(axis));
    if (own > 0.0 && std::fabs(1.0 - own) > std::fabs(1.0 - scale)) {
      scale = own;
    }
  }
  Axes velocity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    velocity[axis] = limitedAxis(current[axis], (*command_)[axis], limitsOf(axis), scale);
  }
  return velocity;
}

}  // namespace sim2d::nav2
