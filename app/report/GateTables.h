#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/Figure.h"
#include "app/report/Markup.h"
#include "app/studies/Gate.h"

/// Parts of the report of a gate.
namespace report {

/// The difference candidate - base of a metric in the unit that its margin is given in: points of a
/// rate, the unit of the metric, or percent.
struct GateDifference {
  double mean = statistics::kUndefined;
  statistics::Interval interval;
  double margin = 0.0;  // > 0
  std::string unit;     // "points", "m", "%"; empty: none
};
GateDifference gateDifference(const app::GateMetricResult& result);
std::string marginText(const app::GateMetric& metric);  // "5 points", "5 %", "0.1 m"

/// What the columns of gateTable contain: they are different means.
constexpr char kGateColumnsText[] =
    "Base and candidate: means of the runs with a value. Difference of pairs: mean over the pairs "
    "of "
    "the same scenario and seed, in which one pair counts at most 10 margins and a goal that is "
    "not "
    "reached counts as the worst value; in %: of the geometric mean of ratios. It may differ from "
    "the difference of the two means.";

/// One row per metric.
Table gateTable(const app::GateResult& result);
/// Mean differences with their intervals, in units of the margins.
Figure gateFigure(const app::GateResult& result);

/// A pair in which the candidate is worse.
struct GateFinding {
  const app::GatePair* pair = nullptr;
  std::string what;                     // "collided with a person", "Path length [m]: 8.1 to 9.3"
  std::string playCandidate, playBase;  // commands
};
/// Pairs in which only the candidate has no success, then the largest losses by each metric that is
/// not passed.
std::vector<GateFinding> gateFindings(const app::GateOptions& options,
                                      const app::GateResult& result);
/// The first `most` findings.
Table findingsTable(const app::GateOptions& options, const std::vector<GateFinding>& findings,
                    std::size_t most);

}  // namespace report
