#pragma once

#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/MetricRegistry.h"
#include "sim2d/base/Result.h"

namespace sim2d {
class RecordedPoints;
}

namespace metrics {

/// Selection of metrics and of a part of a record, with labels for the results.
struct Selection {
  /// Empty: all metrics. Otherwise the deselected keys of HuNavSim and the selected other keys.
  struct Keys {
    std::set<std::string> off;  // of HuNavSim
    std::set<std::string> on;   // others
  };
  std::optional<Keys> keys;
  std::vector<MetricEntry> own;  // user-defined formulas
  Window window;
  std::string tag = "exp_1";
  int runId = 0;
  int robotId = -1;
  bool everyRobot = false;  // also evaluate the other robots: Evaluation::others
  TimedPath reference;      // RunContext::reference of this robot; empty: shortest path

  bool series = true;          // results contain series
  bool seriesOnDisk = false;   // series are kept in a temporary file until then
  bool behaviors = true;       // also results per behaviour type
  bool behaviorSeries = true;  // which contain series

  bool selects(const MetricInfo& info) const;
  /// The selected metrics: those of the registry in order, then the user's.
  std::vector<MetricEntry> entries(const MetricRegistry& registry) const;
};

/// Selects exactly these keys. An unknown key is an error that suggests the nearest known one.
base::Result<Selection> selectionOfKeys(const std::vector<std::string>& keys,
                                        const MetricRegistry& registry = standardRegistry());

/// HuNavSim's metrics.yaml (28 or 33 keys, both layouts) with additional keys in the same map.
/// HuNavSim keys are selected unless set to false, other keys only if listed. A second node
/// `hunavsim_metrics` contains user-defined formulas (README.md); a file with only that node
/// selects all metrics. `result_file` and `use_sim_time` are preserved.
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

/// Metrics computed with the people of one behaviour type.
struct BehaviorEvaluation {
  int behavior = 1;            // 1..6
  std::vector<double> active;  // 0/1 per sample, if series are selected
  std::vector<MetricResult> results;
};

/// Corner points of the shortest paths used by metrics; empty if no such metric is selected.
struct EvaluatedPaths {
  std::vector<Vec2> toGoal, toEnd;  // from the start of the robot's path
};

struct Evaluation {
  MetricParameters parameters;
  std::string tag = "exp_1";
  int runId = 0;
  int robotId = -1;           // evaluated robot
  std::string robot;          // its name, valid in file names; empty: none
  bool isSelection = false;   // the user listed the keys
  std::vector<double> times;  // [s] from the first sample, if series are selected
  std::vector<MetricResult> results;
  EvaluatedPaths evaluatedPaths;
  std::vector<BehaviorEvaluation> behaviors;  // of the types present
  /// Evaluations of the other robots in order, if Selection::everyRobot is set; their own `others`
  /// are empty.
  std::vector<Evaluation> others;

  const MetricResult* find(std::string_view key) const;
};

/// Returns an error if the record or the window contains no sample.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const Selection& selection,
                                  const MetricParameters& parameters);
/// The same for a record whose source contains obstacle points. If any person has points, the
/// recorded points of people replace those computed from the outlines; likewise for the robot. The
/// clearance of the robot is the smaller of those to outlines and to points.
base::Result<Evaluation> evaluate(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                  const Selection& selection, const MetricParameters& parameters);

/// Text formats of an evaluation. Equal evaluations give identical bytes.

/// Content of metrics.json. Values of other robots are in `robots` by name.
std::string toJson(const Evaluation& evaluation);

/// File name for another robot, next to `metrics.csv` or `steps.csv`.
std::string robotFile(const std::string& stem, const std::string& robot);
/// A header and one row: experiment_tag, run_id and one column per metric, for the robot of the
/// evaluation. Undefined and infinite values are empty, also below.
std::string metricsCsv(const Evaluation& evaluation);
/// time_stamps and one column per series; one row per sample.
std::string stepsCsv(const Evaluation& evaluation);

/// A column of steps.csv; its values are read sequentially, once.
struct StepColumn {
  std::string key;
  Kind kind = Kind::Number;
  std::function<double()> next;
};
/// The same in pieces, for writing to a file; consumes the columns.
using TextSink = std::function<void(std::string_view piece)>;
void writeSteps(const std::vector<double>& times, const std::vector<StepColumn>& columns,
                const TextSink& to);

/// A number in the format of HuNavSim's evaluator: "4.0", "0.30000000000000004", "1e-07"; counts as
/// integers, booleans True and False, infinity "inf", undefined "".
std::string evaluatorNumber(double value, Kind kind);

/// A table of name, value and unit of each metric, with the reason for undefined values. Several
/// robots have one named column each. Without a robot, more than five metrics that need one are
/// only counted.
std::string tableText(const Evaluation& evaluation);

enum class Layout { Hunav2, Hunav1 };  // .csv with commas; .txt with tabs and without run id
/// Writes the files of HuNavSim's evaluator, with its keys and other listed keys: `<base>` (a row
/// is appended), `<base>_steps_<tag>_<run>` and those of each behaviour type. If a file has
/// different columns, `<base>_2` is used instead. Returns the written files.
base::Result<std::vector<std::string>> writeEvaluatorFiles(const Evaluation& evaluation,
                                                           const std::string& base, Layout layout);

}  // namespace metrics
