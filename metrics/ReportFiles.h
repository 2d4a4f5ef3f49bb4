#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/Report.h"

/// Text formats of an evaluation. Equal evaluations give identical bytes.
namespace metrics {

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
/// robots have one named column each.
std::string tableText(const Evaluation& evaluation);

enum class Layout { Hunav2, Hunav1 };  // .csv with commas; .txt with tabs and without run id
/// Writes the files of HuNavSim's evaluator, with its keys and other listed keys: `<base>` (a row
/// is appended), `<base>_steps_<tag>_<run>` and those of each behaviour type. If a file has
/// different columns, `<base>_2` is used instead. Returns the written files.
base::Result<std::vector<std::string>> writeEvaluatorFiles(const Evaluation& evaluation,
                                                           const std::string& base, Layout layout);

}  // namespace metrics
