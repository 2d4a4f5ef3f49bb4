#include <algorithm>

#include "metrics/MetricRegistry.h"
#include "metrics/Motion.h"

namespace metrics {

namespace {

constexpr char kNoObstacle[] = "no obstacle in reach of the robot";

std::vector<double> clearances(const Recording& recording) {
  std::vector<double> values;
  for (const Sample& sample : recording.samples) {
    if (sample.robot.obstacleDistance) {
      values.push_back(*sample.robot.obstacleDistance - sample.robot.radius);
    }
  }
  return values;
}

MetricValue smallest(const Recording& recording, const MetricParameters& /*parameters*/) {
  const std::vector<double> values = clearances(recording);
  return values.empty() ? undefinedValue(kNoObstacle)
                        : numberValue(*std::min_element(values.begin(), values.end()));
}

MetricValue average(const Recording& recording, const MetricParameters& /*parameters*/) {
  const std::vector<double> values = clearances(recording);
  return values.empty() ? undefinedValue(kNoObstacle)
                        : numberValue(sumOf(values) / static_cast<double>(values.size()));
}

MetricValue obstacleSafety(const Recording& recording, const MetricParameters& parameters) {
  const double total = recording.duration();
  const double time = timeWhere(recording, [&](std::size_t i) {
    const Robot& robot = recording.samples[i].robot;
    return robot.obstacleDistance &&
           *robot.obstacleDistance - robot.radius < parameters.safetyDistance;
  });
  return numberValue(total > 0.0 ? 100.0 * time / total : 0.0);
}

}  // namespace

void addClearance(MetricRegistry& to) {
  const Needs needs{true, false, false, true};
  const char source[] = "Francis et al. 2025; SocNavGym; bench-mr";
  to.add({"clearing_distance_min", "Smallest clearance", "m", Category::Safety, Better::Higher,
          needs, "min over samples with an obstacle in reach of (its distance - r_r)", source,
          "(-inf, inf)", Kind::Number, 0, ""},
         smallest);
  to.add({"clearing_distance_avg", "Mean clearance", "m", Category::Safety, Better::Higher, needs,
          "mean over samples with an obstacle in reach of (its distance - r_r)", source,
          "(-inf, inf)", Kind::Number, 0, ""},
         average);
  to.add({"obstacle_safety", "Time too close to obstacles", "%", Category::Safety, Better::Lower,
          needs, "share of time with clearance < safety_distance", "MRPB; SRPB", "[0, 100]",
          Kind::Number, 0, ""},
         obstacleSafety);
}

}  // namespace metrics
