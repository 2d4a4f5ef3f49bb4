#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/run/MetricsSetup.h"
#include "metrics/IncrementalEvaluation.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// A metric over time: its value per sample if it has one, otherwise its value so far.
struct MetricTimeSeries {
  std::vector<double> times;   // [s]
  std::vector<double> values;  // NaN: undefined
  /// Unit of the values; empty: none. That of a value per sample may differ from that of the
  /// metric: a share of the time in % has a count of 0 or 1 per sample.
  std::string unit;
  bool isPerSample = false;
  metrics::Kind kind = metrics::Kind::Number;

  /// What the values are: "per step", "count per step", "so far".
  std::string meaning() const;
  /// For the title of an axis: the unit, or "count per step".
  std::string axisUnit() const;
};

/// Measures a recording state by state, complete or while it grows. Not synchronised.
class RecordingMeasurer {
 public:
  /// The selection without its window and behaviour types. `gap`: from a value so far at this time
  /// to the next one in a curve [s]; null: no curves. `person`: measures as if this person (by id)
  /// were the only one.
  RecordingMeasurer(const sim2d::TraceHeader& header, metrics::Selection selection,
                    const metrics::MetricParameters& parameters,
                    std::function<double(double time)> gap, std::optional<int> person = {});

  /// Measures the next state. False: it is no longer in memory.
  bool takeNext(const sim2d::Recording& recording);
  /// Number of states measured.
  std::size_t taken() const { return times_.size(); }
  std::vector<metrics::MetricResult> results() const { return evaluation_.values(); }
  /// The curves of these results, by key.
  std::map<std::string, MetricTimeSeries> curves(
      const std::vector<metrics::MetricResult>& results) const;

 private:
  void addValues(double time);
  bool isMeasured(const sim2d::Event& event) const;

  metrics::FrameEvaluation evaluation_;
  std::function<double(double)> gap_;
  std::optional<int> person_;  // null: all people
  sim2d::KnownPeople known_;   // to the metrics
  std::size_t events_ = 0;     // that were passed to the metrics
  std::vector<double> times_;  // of all states [s]
  std::map<std::string, MetricTimeSeries> soFar_;
  double next_ = 0.0;  // time of the next values so far [s]
};

/// The metrics of a complete recording.
struct RecordingMetrics {
  std::vector<metrics::MetricResult> results;
  std::map<std::string, MetricTimeSeries> curves;  // by key
  bool isCut = false;  // the oldest states are not in memory: there are no values
};

/// Measures the recorded states up to a time [s], for the first robot. Throws `base::Stopped`.
RecordingMetrics measureRun(const sim2d::Recording& recording, const MetricsSetup& setup,
                            const base::StopFlagPtr& stop,
                            double until = std::numeric_limits<double>::infinity());

/// The end of the shortest run [s]; nullopt: all runs are equally long, to within one step.
std::optional<double> commonEnd(const std::vector<const sim2d::Recording*>& runs);

/// One metric of several runs.
struct ComparedMetric {
  metrics::MetricInfo info;
  std::vector<std::optional<double>> values;  // one per run; nullopt: undefined or not measured
  bool isWholeRun = true;                     // otherwise up to the common end

  /// Value of that run minus that of the first; nullopt unless both are finite.
  std::optional<double> difference(std::size_t run) const;
};
/// The metrics of the first run in its order, then those that only later runs have.
std::vector<ComparedMetric> compareRecordingMetrics(const std::vector<RecordingMetrics>& runs);
/// The same for runs of different length: `upToCommonEnd`, except for metrics of the outcome of a
/// run (success, time to the goal, final distance …), which are those of the whole runs.
std::vector<ComparedMetric> compareRecordingMetrics(
    const std::vector<RecordingMetrics>& wholeRuns,
    const std::vector<RecordingMetrics>& upToCommonEnd);

/// The first time [s] at which a body is farther than `apart` [m] from its position in the other
/// run, or is in only one run; nullopt if that does not happen while both are active. Compares
/// states that both record.
std::optional<double> divergenceTime(const sim2d::Recording& first, const sim2d::Recording& second,
                                     double apart = 1e-3);

}  // namespace app
