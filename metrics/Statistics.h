#pragma once

#include <optional>
#include <string>
#include <vector>

#include "metrics/Report.h"

/// Many runs together.
namespace metrics {

struct Interval {
  double low = 0.0, high = 0.0;
};

/// Of the defined values. Mean with Student's interval; of booleans the rate with Wilson's.
struct Statistics {
  std::size_t runs = 0;                                             // all
  std::size_t defined = 0;                                          // with a finite value
  std::optional<double> mean, deviation, median, minimum, maximum;  // deviation: n - 1
  std::optional<Interval> confidence;                               // 95 %
};
Statistics statisticsOf(const std::vector<std::optional<double>>& values, Kind kind = Kind::Number);

/// 97.5 % quantile of Student's t, `degrees` >= 1.
double studentQuantile(int degrees);
Interval wilsonInterval(double successes, double trials);

struct AggregateRow {
  MetricInfo info;
  Statistics statistics;
};
/// Per metric of the first evaluation, over all that have it.
std::vector<AggregateRow> aggregate(const std::vector<Evaluation>& evaluations);

/// Differences second - first, run by run.
Statistics pairedDifference(const std::vector<std::optional<double>>& first,
                            const std::vector<std::optional<double>>& second);

/// One result file of the evaluator as read: name and text.
struct ResultFile {
  std::string name;
  std::string text;
};
/// comparison_table.csv: rows = metrics, one column per file and tag, "mean ± deviation".
base::Result<std::string> comparisonTable(const std::vector<ResultFile>& files);

/// Mean of series of several runs on a common grid; numbers interpolated, 0/1 and counts held.
struct TimedSeries {
  std::vector<double> times;  // [s], rising
  Series series;
};
TimedSeries meanSeries(const std::vector<TimedSeries>& runs, double step);

}  // namespace metrics
