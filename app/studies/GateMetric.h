#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/run/ResultRow.h"
#include "metrics/statistics/Summary.h"
#include "sim2d/base/Result.h"

namespace app {

/// A metric of a gate: how two runs are compared by it, and how much worse the candidate may be.
struct GateMetric {
  enum class Scale {
    Rate,        // share of runs: of True values, or of values above `threshold`
    Difference,  // in the unit of the metric
    Ratio        // candidate / base
  };
  std::string key;         // column of the results
  std::string name, unit;  // for display; empty unit: none
  Scale scale = Scale::Difference;
  int sense = -1;                   // 1: higher is better, -1: lower is better
  double margin = 0.0;              // Rate: share; Ratio: 0.05 = 5 %
  std::optional<double> threshold;  // Rate of a number
  bool isRequested = false;         // by the user, not by default

  std::string title() const;  // "Time to reach the goal [s]"
  std::string label() const;  // unique: "robot_on_person_collision>0"
};

/// "KEY:MARGIN" or "KEY>X:MARGIN". MARGIN: a number in the unit of the metric, or a percentage:
/// points of a rate, otherwise of the base's value. Errors: another form, an unknown key, a metric
/// without a better direction, a margin out of range.
base::Result<GateMetric> parseGateMetric(const std::string& text);
/// Success and contacts caused by the robot (5 points), time to the goal (5 %) and intimate space
/// (2 points).
std::vector<GateMetric> defaultGateMetrics();

/// A difference of one pair counts at most this many margins, except for rates, so that it is
/// bounded (statistics/ConfidenceSequences.h).
constexpr double kMarginsPerPair = 10.0;

/// The range of gains, and the margin as a gain: the candidate passes if its mean gain is above
/// -marginAsGain(). Gains are shares (Rate), in the unit (Difference) or logarithms (Ratio).
statistics::Interval gainRange(const GateMetric& metric);
double marginAsGain(const GateMetric& metric);

/// A pair of runs compared by a metric.
struct GateGain {
  double gain = 0.0;                      // of the candidate, in gainRange(); positive: better
  std::optional<double> base, candidate;  // values
};
/// The gain of the candidate in a pair. A value that is missing in a run without success counts as
/// the worst; if both runs are alike in this, or a successful run has no value, there is no
/// difference.
GateGain gainOf(const GateMetric& metric, const ResultRow& base, const ResultRow& candidate);

}  // namespace app
