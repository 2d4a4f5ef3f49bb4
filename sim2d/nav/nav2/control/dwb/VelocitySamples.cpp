#include "sim2d/nav/nav2/control/dwb/VelocitySamples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace sim2d::nav2 {
namespace {

constexpr double kSampleEpsilon = 1e-5;

bool mayBeDriven(const DwbParameters& p, const BodyTwist& twist) {
  const double squared = twist.linear * twist.linear + twist.lateral * twist.lateral;
  if (p.maxSpeedXy >= 0.0 && squared > p.maxSpeedXy * p.maxSpeedXy) {
    return false;
  }
  const bool isSlow = p.minSpeedXy >= 0.0 && squared < p.minSpeedXy * p.minSpeedXy;
  const bool turnsSlowly = p.minSpeedTheta >= 0.0 && std::abs(twist.angular) < p.minSpeedTheta;
  return !(isSlow && turnsSlowly) && !(squared == 0.0 && twist.angular == 0.0);
}

}  // namespace

double projectVelocity(double v, double acceleration, double deceleration, double dt,
                       double target) {
  return v < target ? std::min(target, v + acceleration * dt)
                    : std::max(target, v + deceleration * dt);
}

std::vector<double> axisSamples(const VelocityAxis& axis, double v, double time, int count) {
  // As std::clamp, but defined for bounds the wrong way round.
  const double now = v < axis.least ? axis.least : std::min(v, axis.most);
  const double hi = projectVelocity(now, axis.acceleration, axis.deceleration, time, axis.most);
  const double lo = projectVelocity(now, axis.acceleration, axis.deceleration, time, axis.least);
  double increment = 1.0;
  if (std::abs(hi - lo) >= kSampleEpsilon) {
    increment = (hi - lo) / (std::max(2, count) - 1);
  }
  // An increment below the rounding of large velocities would never lead to the end.
  const auto most = static_cast<std::size_t>(std::max(2, count)) + 2;
  std::vector<double> samples;
  for (double value = lo; !(value > hi + kSampleEpsilon) && samples.size() < most;
       value += increment) {
    samples.push_back(value);
    const double next = value + increment;
    if (value < 0.0 && next > 0.0 && next <= hi + kSampleEpsilon) {
      samples.push_back(0.0);
    }
    if (!(increment > 0.0)) {
      break;  // bounds the wrong way round
    }
  }
  return samples;
}

VelocityAxis axisX(const DwbParameters& p) {
  return {p.minVelX, p.maxVelX, p.accLimX, p.decelLimX};
}

VelocityAxis axisY(const DwbParameters& p) {
  return {p.minVelY, p.maxVelY, p.accLimY, p.decelLimY};
}

VelocityAxis axisTheta(const DwbParameters& p) {
  return {-p.maxVelTheta, p.maxVelTheta, p.accLimTheta, p.decelLimTheta};
}

void velocitySamples(const DwbParameters& p, const BodyTwist& now, double time,
                     std::vector<BodyTwist>& samples) {
  const std::vector<double> xs = axisSamples(axisX(p), now.linear, time, p.vxSamples);
  const std::vector<double> ys = axisSamples(axisY(p), now.lateral, time, p.vySamples);
  const std::vector<double> thetas = axisSamples(axisTheta(p), now.angular, time, p.vthetaSamples);
  samples.clear();
  samples.reserve(xs.size() * ys.size() * thetas.size());
  for (const double x : xs) {
    for (const double y : ys) {
      for (const double theta : thetas) {
        const BodyTwist twist{x, theta, y};
        if (mayBeDriven(p, twist)) {
          samples.push_back(twist);
        }
      }
    }
  }
}

}  // namespace sim2d::nav2
