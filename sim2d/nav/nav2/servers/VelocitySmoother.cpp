#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "sim2d/nav/SensedWorld.h"

namespace sim2d::nav2 {
namespace {

constexpr double kTimeoutClock = 1e-9;  // [s], rounding of times

/// Greatest change of velocity in a tick, either way.
double mostChange(double current, double command, const AxisLimits& limits) {
  const bool isFaster = std::fabs(command) >= std::fabs(current) && current * command >= 0.0;
  return (isFaster ? limits.accel : -limits.decel) / limits.frequency;
}

std::array<double, 3> axesOf(const BodyTwist& twist) {
  return {twist.linear, twist.lateral, twist.angular};
}

}  // namespace

const std::vector<Nav2Key<VelocitySmootherParameters>>& velocitySmootherKeys() {
  using P = VelocitySmootherParameters;
  static const std::vector<Nav2Key<P>> kKeys = {
      {"smoothing_frequency", &P::smoothingFrequency, "Hz", "Commands sent per second."},
      {"scale_velocities", &P::scaleVelocities, "",
       "Whether all axes are slowed by the same factor, which keeps the arc."},
      {"feedback", &P::feedback, "",
       "OPEN_LOOP: from the last command on; CLOSED_LOOP: from the measured velocity on."},
      {"max_velocity", &P::maxVelocity, "m/s, rad/s", "Greatest v_x, v_y, omega."},
      {"min_velocity", &P::minVelocity, "m/s, rad/s", "Least v_x, v_y, omega."},
      {"max_accel", &P::maxAccel, "m/s², rad/s²", "Greatest acceleration by axis, from 0 on."},
      {"max_decel", &P::maxDecel, "m/s², rad/s²", "Greatest deceleration by axis, up to 0."},
      {"odom_duration", &P::odomDuration, "s", "Time over which measured velocities are meant."},
      {"deadband_velocity", &P::deadbandVelocity, "m/s, rad/s", "Slower commands are 0."},
      {"velocity_timeout", &P::velocityTimeout, "s",
       "The robot brakes when no command has come for longer."},
  };
  return kKeys;
}

const std::vector<IdleKey>& idleVelocitySmootherKeys() {
  static const std::vector<IdleKey> kKeys = {
      {"odom_topic", "the odometry is the robot's"},  {"use_sim_time", "time is simulated here"},
      {"use_realtime_priority", "no threads here"},   {"enable_stamped_cmd_vel", "no topics here"},
      {"bond_heartbeat_period", "no lifecycle here"},
  };
  return kKeys;
}

base::Diagnostics problemsOf(const VelocitySmootherParameters& parameters) {
  base::Diagnostics problems;
  const auto require = [&problems](bool isRight, const char* key, const char* wanted) {
    if (!isRight) {
      problems.push_back(base::error("nav2.bad-parameter", {key, wanted}));
    }
  };
  constexpr double kMostFrequency = 1000.0;  // [Hz]
  require(parameters.smoothingFrequency > 0.0 && parameters.smoothingFrequency <= kMostFrequency,
          "smoothing_frequency", "above 0, up to 1000 Hz");
  require(parameters.feedback == "OPEN_LOOP" || parameters.feedback == "CLOSED_LOOP", "feedback",
          "OPEN_LOOP or CLOSED_LOOP");
  const std::pair<const char*, const std::vector<double>*> lists[] = {
      {"max_velocity", &parameters.maxVelocity},
      {"min_velocity", &parameters.minVelocity},
      {"max_accel", &parameters.maxAccel},
      {"max_decel", &parameters.maxDecel},
      {"deadband_velocity", &parameters.deadbandVelocity}};
  for (const auto& [key, values] : lists) {
    require(values->size() == 3, key, "three numbers");
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    require(parameters.maxAccel[axis] >= 0.0, "max_accel", "0 or more on each axis");
    require(parameters.maxDecel[axis] <= 0.0, "max_decel", "0 or less on each axis");
    require(parameters.minVelocity[axis] <= 0.0, "min_velocity", "0 or less on each axis");
    require(parameters.maxVelocity[axis] >= 0.0, "max_velocity", "0 or more on each axis");
  }
  return problems;
}

double axisScale(double current, double command, const AxisLimits& limits) {
  const double change = command - current;
  const double most = mostChange(current, command, limits);
  if (change > most) {
    return most / change;
  }
  return change < -most ? -most / change : -1.0;
}

double limitedAxis(double current, double command, const AxisLimits& limits, double scale) {
  const double most = mostChange(current, command, limits);
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
  const std::int64_t tick = eventAt(time, parameters_.smoothingFrequency);
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
