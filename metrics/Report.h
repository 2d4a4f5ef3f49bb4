#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Result.h"

namespace metrics {

/// Which metrics of which part of a record, and under which name.
struct Selection {
  /// Nothing: all metrics. Else the keys of HuNavSim that are off and ours that are on.
  struct Keys {
    std::set<std::string> off;  // of HuNavSim's
    std::set<std::string> on;   // of ours
  };
  std::optional<Keys> keys;
  std::vector<MetricEntry> own;  // formulas of the user's
  Window window;
  std::string tag = "exp_1";
  int runId = 0;
  int robotId = -1;
  bool everyRobot = false;  // those of the others too, beside them: Evaluation::others
  TimedWay reference;       // RunContext::reference of this robot; empty = shortest way

  bool series = true;          // results have their series
  bool seriesOnDisk = false;   // meanwhile in a temporary file
  bool behaviors = true;       // results per behaviour type as well
  bool behaviorSeries = true;  // and those have their series

  bool selects(const MetricInfo& info) const;
  /// The selected metrics in order: of the registry, then the user's.
  std::vector<MetricEntry> entries(const MetricRegistry& registry) const;
};

/// Exactly these keys; an unknown one is an error with the nearest known.
base::Result<Selection> selectionOfKeys(const std::vector<std::string>& keys,
                                        const MetricRegistry& registry = standardRegistry());

/// metrics.yaml of HuNavSim (28 or 33 keys, both layouts) with our keys in the same map. A key of
/// HuNavSim that is missing is on, one of ours is on only when listed. A second node
/// `hunavsim_metrics` holds formulas of the user's (README.md); a file with them alone selects all.
/// `result_file` and `use_sim_time` are carried along.
struct MetricsFile {
  Selection selection;
  std::string resultFile = "metrics";
  bool useSimTime = true;
};
base::Result<MetricsFile> parseMetricsFile(const std::string& text, const std::string& name,
                                           const MetricRegistry& registry = standardRegistry());
base::Result<MetricsFile> readMetricsFile(const std::string& path,
                                          const MetricRegistry& registry = standardRegistry());
std::string writeMetricsFile(const MetricsFile& file,
                             const MetricRegistry& registry = standardRegistry());

struct MetricResult {
  MetricInfo info;
  MetricValue value;
};

const MetricResult* findResult(const std::vector<MetricResult>& results, std::string_view key);

/// The metrics among people of one behaviour type.
struct BehaviorEvaluation {
  int behavior = 1;            // 1..6
  std::vector<double> active;  // 0/1 per sample, with series
  std::vector<MetricResult> results;
};

/// Corner points of the shortest paths that metrics are computed with; empty where no such metric
/// is selected.
struct ShortestWays {
  std::vector<Vec2> toGoal, toEnd;  // from the start of the robot's path
};

struct Evaluation {
  MetricParameters parameters;
  std::string tag = "exp_1";
  int runId = 0;
  int robotId = -1;           // whose metrics they are
  std::string robot;          // its name, by which files can be called; empty: there is none
  bool isSelection = false;   // of keys that the user listed
  std::vector<double> times;  // [s] from the first sample, with series
  std::vector<MetricResult> results;
  ShortestWays shortestWays;
  std::vector<BehaviorEvaluation> behaviors;  // of the types present
  /// The same of the other robots in their order, where Selection::everyRobot asks for it; they
  /// have none themselves.
  std::vector<Evaluation> others;

  const MetricResult* find(std::string_view key) const;
};

/// Error when the record or the window holds no sample.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const Selection& selection,
                                  const MetricParameters& parameters);

}  // namespace metrics
