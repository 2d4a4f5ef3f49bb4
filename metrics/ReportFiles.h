#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "metrics/Report.h"

/// An evaluation as text. Equal evaluations give equal bytes.
namespace metrics {

/// metrics.json. Values of other robots stand below `robots` and their names.
std::string toJson(const Evaluation& evaluation);

/// Name of the file beside `metrics.csv` or `steps.csv` that is of another robot.
std::string robotFile(const std::string& stem, const std::string& robot);
/// experiment_tag, run_id and one column per metric; header line and one row. What is undefined or
/// infinite is empty, also below. Of the robot of the evaluation, not of others.
std::string metricsCsv(const Evaluation& evaluation);
/// time_stamps and one column per series; one row per sample.
std::string stepsCsv(const Evaluation& evaluation);

/// A column of that file; its values are asked for once each, in order.
struct StepColumn {
  std::string key;
  Kind kind = Kind::Number;
  std::function<double()> next;
};
/// The same in pieces, for a file that is written while they come; uses the columns up.
using TextSink = std::function<void(std::string_view piece)>;
void writeSteps(const std::vector<double>& times, const std::vector<StepColumn>& columns,
                const TextSink& to);

/// A number as the evaluator writes it: "4.0", "0.30000000000000004", "1e-07"; counts plain,
/// booleans True and False, infinity "inf", undefined "".
std::string evaluatorNumber(double value, Kind kind);

/// Name, value and unit of each metric in columns; undefined ones with the reason. Of several
/// robots each has a column with its name.
std::string tableText(const Evaluation& evaluation);

enum class Layout { Hunav2, Hunav1 };  // comma-separated .csv; tab-separated .txt without run id
/// The evaluator's own files, with its keys and those of ours that were listed, beside each other:
/// `<base>` (a row appended),
/// `<base>_steps_<tag>_<run>` and those of each behaviour type. A file with other columns is left
/// alone and `<base>_2` taken. Returns the files written.
base::Result<std::vector<std::string>> writeEvaluatorFiles(const Evaluation& evaluation,
                                                           const std::string& base, Layout layout);

}  // namespace metrics
