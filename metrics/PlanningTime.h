#pragma once

#include <cstdint>
#include <vector>

#include "metrics/Report.h"

/// What the clock says about a run. It differs from run to run, so it is in no file that must not:
/// records, metrics and batches know nothing of it, the program that makes the run tells it.
namespace metrics {

/// Wall time that the robots took to decide, per step [s].
class PlanningTime {
 public:
  void add(double seconds);
  std::int64_t steps() const { return steps_; }
  /// As planningInfos(): mean and sample standard deviation; undefined where nothing was measured.
  std::vector<MetricResult> results() const;

 private:
  std::int64_t steps_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;  // sum of the squared deviations
};

/// planning_time_mean, planning_time_std.
std::vector<MetricInfo> planningInfos();

}  // namespace metrics
