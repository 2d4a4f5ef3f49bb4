#include <algorithm>
#include <cmath>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

double meanOf(const std::vector<double>& values) {
  return sumOf(values) / static_cast<double>(values.size());
}

std::vector<double> absolutes(std::vector<double> values) {
  for (double& value : values) {
    value = std::fabs(value);
  }
  return values;
}

MetricValue timeNotMoving(const Recording& recording, const MetricParameters& parameters) {
  const bool original = parameters.profile == Profile::Hunav2;
  std::vector<double> series;
  for (const Sample& sample : recording.samples) {
    const double turning = original ? sample.robot.omega : std::fabs(sample.robot.omega);
    const bool stands = std::fabs(sample.robot.speed) < parameters.stopLinearSpeed &&
                        turning < parameters.stopAngularSpeed;
    series.push_back(stands ? 1.0 : 0.0);
  }
  const double time =
      original ? recording.duration() / static_cast<double>(recording.size()) * sumOf(series)
               : timeWhere(recording, [&](std::size_t i) { return series[i] > 0.0; });
  return withSeries(numberValue(time), std::move(series), Kind::Count);
}

MetricValue averageLinearSpeed(const Recording& recording, const MetricParameters& /*parameters*/) {
  std::vector<double> series;
  for (const Sample& sample : recording.samples) {
    series.push_back(sample.robot.speed);
  }
  const double mean = meanOf(series);
  return withSeries(numberValue(mean), std::move(series));
}

MetricValue averageAngularSpeed(const Recording& recording,
                                const MetricParameters& /*parameters*/) {
  std::vector<double> series;
  for (const Sample& sample : recording.samples) {
    series.push_back(sample.robot.omega);
  }
  const double mean = meanOf(absolutes(series));
  return withSeries(numberValue(mean), std::move(series));
}

std::size_t properIntervals(const Recording& recording) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < recording.size(); ++i) {
    count += recording.interval(i) > 0.0 ? 1 : 0;
  }
  return count;
}

MetricValue averageAcceleration(const Recording& recording, const MetricParameters& parameters) {
  std::vector<double> series = accelerations(recording);
  series.insert(series.begin(), 0.0);
  const std::size_t divisor =
      parameters.profile == Profile::Hunav2 ? recording.size() : properIntervals(recording);
  MetricValue value = divisor == 0
                          ? undefinedValue("needs two samples at different times")
                          : numberValue(sumOf(absolutes(series)) / static_cast<double>(divisor));
  return withSeries(std::move(value), std::move(series));
}

MetricValue originalOveracceleration(const Recording& recording) {
  std::vector<double> series = {0.0};
  const std::vector<double> acceleration = accelerations(recording);
  for (std::size_t i = 0; i < acceleration.size(); ++i) {
    const double dt = recording.interval(i);
    series.push_back(dt > 0.0 ? acceleration[i] / dt : 0.0);
  }
  const double mean = meanOf(absolutes(series));
  return withSeries(numberValue(mean), std::move(series));
}

MetricValue averageOveracceleration(const Recording& recording,
                                    const MetricParameters& parameters) {
  if (parameters.profile == Profile::Hunav2) {
    return originalOveracceleration(recording);
  }
  std::vector<double> series(std::min<std::size_t>(recording.size(), 2), 0.0);
  double sum = 0.0;
  std::size_t count = 0;
  for (const std::optional<double>& jerk : jerks(recording)) {
    series.push_back(jerk.value_or(0.0));
    sum += std::fabs(jerk.value_or(0.0));
    count += jerk ? 1 : 0;
  }
  MetricValue value = count == 0 ? undefinedValue("needs three samples at different times")
                                 : numberValue(sum / static_cast<double>(count));
  return withSeries(std::move(value), std::move(series));
}

}  // namespace

void addRobotMotion(MetricRegistry& to) {
  const char source[] = "Biswas et al., SocNavBench, THRI 2022";
  to.add({"time_not_moving", "Time standing still", "s", Category::Navigation, Better::Lower,
          Needs{}, "sum of dt_i with |s_i| < stop_linear_speed and |w_i| < stop_angular_speed",
          "Tsoi et al., SEAN 2.0, RA-L 2022", "[0, T]", Kind::Number, 18, ""},
         timeNotMoving);
  to.add({"avg_robot_linear_speed", "Mean speed of the robot", "m/s", Category::Motion,
          Better::Neutral, Needs{}, "mean of s_i", source, "[0, inf)", Kind::Number, 19, ""},
         averageLinearSpeed);
  to.add({"avg_robot_angular_speed", "Mean turning speed of the robot", "rad/s", Category::Motion,
          Better::Neutral, Needs{}, "mean of |w_i|", source, "[0, inf)", Kind::Number, 20, ""},
         averageAngularSpeed);
  to.add({"avg_acceleration", "Mean acceleration of the robot", "m/s²", Category::Motion,
          Better::Lower, Needs{}, "mean of |a_i|, a_i = (s_(i+1) - s_i)/dt_i", source, "[0, inf)",
          Kind::Number, 21, ""},
         averageAcceleration);
  to.add({"avg_overacceleration", "Mean jerk of the robot", "m/s³", Category::Motion, Better::Lower,
          Needs{}, "mean of |jerk_i|, jerk_i = (a_i - a_(i-1))/((t_(i+1) - t_(i-1))/2)", source,
          "[0, inf)", Kind::Number, 22, ""},
         averageOveracceleration);
}

}  // namespace metrics
