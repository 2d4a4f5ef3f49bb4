#include <algorithm>
#include <cmath>
#include <limits>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

MetricValue slowest(const Recording& recording, const MetricParameters& /*parameters*/) {
  double value = std::numeric_limits<double>::infinity();
  for (const Sample& sample : recording.samples) {
    value = std::min(value, lengthOf(sample.robot.velocity));
  }
  return numberValue(value);
}

MetricValue fastest(const Recording& recording, const MetricParameters& /*parameters*/) {
  double value = 0.0;
  for (const Sample& sample : recording.samples) {
    value = std::max(value, lengthOf(sample.robot.velocity));
  }
  return numberValue(value);
}

MetricValue largestAcceleration(const Recording& recording,
                                const MetricParameters& /*parameters*/) {
  std::optional<double> largest;
  const std::vector<double> values = accelerations(recording);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (recording.interval(i) > 0.0) {
      largest = std::max(largest.value_or(0.0), std::fabs(values[i]));
    }
  }
  return largest ? numberValue(*largest) : undefinedValue("needs two samples at different times");
}

MetricValue largestJerk(const Recording& recording, const MetricParameters& /*parameters*/) {
  std::optional<double> largest;
  for (const std::optional<double>& jerk : jerks(recording)) {
    if (jerk) {
      largest = std::max(largest.value_or(0.0), std::fabs(*jerk));
    }
  }
  return largest ? numberValue(*largest) : undefinedValue("needs three samples at different times");
}

MetricValue headingSmoothness(const Recording& recording, const MetricParameters& /*parameters*/) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    const double dt = recording.interval(i);
    if (dt > 0.0) {
      sum +=
          std::fabs(recording.samples[i + 1].robot.omega - recording.samples[i].robot.omega) / dt;
      count += 1.0;
    }
  }
  return count > 0.0 ? numberValue(sum / count)
                     : undefinedValue("needs two samples at different times");
}

MetricValue motionEnergy(const Recording& recording, const MetricParameters& /*parameters*/) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    const double dt = recording.interval(i);
    if (dt > 0.0) {
      const double speed =
          distance(recording.samples[i + 1].robot, recording.samples[i].robot) / dt;
      sum += speed * speed;
    }
  }
  return numberValue(sum);
}

}  // namespace

void addSpeedExtremes(MetricRegistry& to) {
  const char francis[] = "Francis et al. 2025; SocNavGym";
  const Category motion = Category::Motion;
  to.add({"min_robot_linear_speed", "Smallest speed of the robot", "m/s", motion, Better::Neutral,
          Needs{}, "min of |v_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         slowest);
  to.add({"max_robot_linear_speed", "Largest speed of the robot", "m/s", motion, Better::Neutral,
          Needs{}, "max of |v_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         fastest);
  to.add({"max_acceleration", "Largest acceleration of the robot", "m/s²", motion, Better::Lower,
          Needs{}, "max of |a_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         largestAcceleration);
  to.add({"max_jerk", "Largest jerk of the robot", "m/s³", motion, Better::Lower, Needs{},
          "max of |jerk_i|", francis, "[0, inf)", Kind::Number, 0, ""},
         largestJerk);
  to.add({"heading_change_smoothness", "Mean turning acceleration", "rad/s²", motion, Better::Lower,
          Needs{}, "mean of |w_(i+1) - w_i|/dt_i", "SRPB", "[0, inf)", Kind::Number, 0, ""},
         headingSmoothness);
  to.add({"motion_energy", "Motion energy", "m²/s²", motion, Better::Lower, Needs{},
          "sum of (|p_(i+1) - p_i|/dt_i)^2", "SocNavBench", "[0, inf)", Kind::Number, 0, ""},
         motionEnergy);
  to.setRateBound("motion_energy", 0.51);  // a sum over samples
}

}  // namespace metrics
