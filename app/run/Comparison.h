#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/run/MetricsSetup.h"
#include "sim2d/base/Stop.h"
#include "sim2d/trace/Recording.h"

namespace app {

/// A metric over a run: its own value per sample where it has one, else its value so far.
struct MeasuredCurve {
  std::vector<double> times;   // [s]
  std::vector<double> values;  // NaN: undefined
};

/// What is measured of a whole recording.
struct RunMeasures {
  std::vector<metrics::MetricResult> results;
  std::map<std::string, MeasuredCurve> curves;  // by key
  bool isCut = false;  // its oldest states are not kept: there are no values
};

/// Of every recorded state, of the first robot. Throws `base::Stopped`.
RunMeasures measureRun(const sim2d::Recording& recording, const MetricsSetup& setup,
                       const base::StopFlagPtr& stop);

/// One metric of several runs.
struct ComparedMetric {
  metrics::MetricInfo info;
  std::vector<std::optional<double>> values;  // one per run; none: undefined, or not measured

  /// Of that run against the first; none unless both are finite numbers.
  std::optional<double> difference(std::size_t run) const;
};
/// Those of the first run in its order, then those that only later ones have.
std::vector<ComparedMetric> compareMeasures(const std::vector<RunMeasures>& runs);

/// The first time at which somebody stands farther than `apart` [m] from where the other run has
/// them, or is in one run alone [s]; none: not as long as both go on. Of states that both record.
std::optional<double> partingTime(const sim2d::Recording& first, const sim2d::Recording& second,
                                  double apart = 1e-3);

}  // namespace app
