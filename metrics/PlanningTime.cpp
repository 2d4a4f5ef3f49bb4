#include "metrics/PlanningTime.h"

#include <cmath>

namespace metrics {

void PlanningTime::add(double seconds) {
  ++steps_;
  const double change = seconds - mean_;
  mean_ += change / static_cast<double>(steps_);
  squares_ += change * (seconds - mean_);
}

std::vector<MetricInfo> planningInfos() {
  const char source[] = "MRPB; SRPB";
  return {
      {"planning_time_mean", "Mean time of deciding", "s", Category::Navigation, Better::Lower,
       Needs{}, "mean over steps of the wall time in which all robots decide what to do", source},
      {"planning_time_std", "Deviation of the time of deciding", "s", Category::Navigation,
       Better::Lower, Needs{}, "sample standard deviation of the same", source}};
}

std::vector<MetricResult> PlanningTime::results() const {
  std::vector<MetricResult> results;
  for (MetricInfo& info : planningInfos()) {
    results.push_back({std::move(info), undefinedValue("no robot decided anything")});
  }
  if (steps_ > 0) {
    results[0].value = mean_;
    results[1].value = steps_ > 1 ? std::sqrt(squares_ / static_cast<double>(steps_ - 1))
                                  : undefinedValue("needs two steps");
  }
  return results;
}

}  // namespace metrics
