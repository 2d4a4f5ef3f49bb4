#include "metrics/PlanningTime.h"

#include <cmath>

namespace metrics {

namespace {

MetricInfo infoOf(const char* key, const char* name, const char* formula) {
  MetricInfo info;
  info.key = key;
  info.name = name;
  info.unit = "s";
  info.better = Better::Lower;
  info.formula = formula;
  info.source = "MRPB; SRPB";
  info.range = "[0, inf)";
  return info;
}

}  // namespace

void PlanningTime::add(double seconds) {
  ++steps_;
  const double change = seconds - mean_;
  mean_ += change / static_cast<double>(steps_);
  squares_ += change * (seconds - mean_);
}

std::vector<MetricInfo> planningInfos() {
  return {infoOf("planning_time_mean", "Mean time of deciding",
                 "mean over steps of the wall time in which all robots decide what to do"),
          infoOf("planning_time_std", "Deviation of the time of deciding",
                 "sample standard deviation of the same")};
}

std::vector<MetricResult> PlanningTime::results() const {
  std::vector<MetricResult> results;
  for (MetricInfo& info : planningInfos()) {
    results.push_back({std::move(info), undefinedValue("no robot decided anything")});
  }
  if (steps_ > 0) {
    results[0].value = numberValue(mean_);
    results[1].value = steps_ > 1
                           ? numberValue(std::sqrt(squares_ / static_cast<double>(steps_ - 1)))
                           : undefinedValue("needs two steps");
  }
  return results;
}

}  // namespace metrics
