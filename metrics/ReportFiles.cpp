#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <nlohmann/json.hpp>

#include "metrics/Report.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace metrics {

namespace {

using Json = nlohmann::ordered_json;

Json valueJson(const MetricResult& result) {
  const MetricValue& value = result.value;
  Json json;
  if (!value.value || std::isinf(*value.value)) {
    json["value"] = nullptr;
  } else if (result.info.kind == Kind::Boolean) {
    json["value"] = *value.value > 0.0;
  } else if (result.info.kind == Kind::Count) {
    json["value"] = std::llround(*value.value);
  } else {
    json["value"] = *value.value;
  }
  json["unit"] = result.info.unit;
  if (!value.why.empty()) {
    json["why"] = value.why;
  }
  return json;
}

Json resultsJson(const std::vector<MetricResult>& results) {
  Json json = Json::object();
  for (const MetricResult& result : results) {
    json[result.info.key] = valueJson(result);
  }
  return json;
}

Json behaviorsJson(const Evaluation& evaluation) {
  Json json = Json::object();
  for (const BehaviorEvaluation& behavior : evaluation.behaviors) {
    json[std::to_string(behavior.behavior)] = resultsJson(behavior.results);
  }
  return json;
}

Json parametersJson(const MetricParameters& parameters) {
  Json json = Json::object();
  for (const ParameterInfo& info : parameterInfos()) {
    json[info.spec.key] = parameters.*info.member;
  }
  return json;
}

void appendRow(std::string& to, const std::vector<std::string>& cells) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    to += k == 0 ? "" : ",";
    sim2d::appendCsvField(to, cells[k]);
  }
  to += '\n';
}

/// Shortest representation, always with a decimal point, with an exponent below 1e-4 and from 1e16.
std::string floatText(double value) {
  const double size = std::fabs(value);
  const bool hasExponent = size >= 1e16 || (size > 0.0 && size < 1e-4);
  const auto layout = hasExponent ? std::chars_format::scientific : std::chars_format::fixed;
  std::array<char, 32> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value, layout).ptr;
  const std::string text(digits.data(), end);
  return hasExponent || text.find('.') != std::string::npos ? text : text + ".0";
}

/// The series with one value per sample.
std::vector<StepColumn> columnsOf(const std::vector<MetricResult>& results, std::size_t samples) {
  std::vector<StepColumn> columns;
  for (const MetricResult& result : results) {
    const std::optional<Series>& series = result.value.series;
    if (series && series->values.size() == samples) {
      columns.push_back({result.info.key, series->kind,
                         [next = series->values.begin()]() mutable { return *next++; }});
    }
  }
  return columns;
}

std::string stepsText(const std::vector<double>& times, const std::vector<StepColumn>& columns) {
  std::string text;
  writeSteps(times, columns, [&text](std::string_view piece) { text += piece; });
  return text;
}

std::string finiteNumber(double value, Kind kind) {
  return std::isfinite(value) ? evaluatorNumber(value, kind) : "";
}

std::string valueCell(const MetricResult& result) {
  return finiteNumber(result.value.value.value_or(kNaN), result.info.kind);
}

/// As in HuNavSim's evaluator for its own keys: with "inf".
std::string evaluatorCell(const MetricResult& result) {
  return result.info.hunav > 0
             ? evaluatorNumber(result.value.value.value_or(kNaN), result.info.kind)
             : valueCell(result);
}

std::vector<std::string> headerCells(const std::vector<MetricResult>& results) {
  std::vector<std::string> cells = {"experiment_tag", "run_id"};
  for (const MetricResult& result : results) {
    cells.push_back(result.info.key);
  }
  return cells;
}

std::vector<std::string> valueCells(const Evaluation& evaluation,
                                    const std::vector<MetricResult>& results,
                                    std::string (*cellOf)(const MetricResult&)) {
  std::vector<std::string> cells = {evaluation.tag, std::to_string(evaluation.runId)};
  for (const MetricResult& result : results) {
    cells.push_back(cellOf(result));
  }
  return cells;
}

/// The evaluator's keys, and other keys that were listed explicitly.
std::vector<MetricResult> evaluatorResults(const std::vector<MetricResult>& results,
                                           bool isSelection) {
  std::vector<MetricResult> kept;
  for (const MetricResult& result : results) {
    const MetricInfo& info = result.info;
    const bool isListed = isSelection || standardRegistry().find(info.key) == nullptr;
    if (info.hunav > 0 || (isListed && info.partOf.empty())) {
      kept.push_back(result);
    }
  }
  return kept;
}

/// Writes the files of one evaluation.
class EvaluatorFileWriter {
 public:
  EvaluatorFileWriter(const Evaluation& evaluation, std::string base, Layout layout)
      : evaluation_(evaluation), base_(std::move(base)), layout_(layout) {
    const std::string end = extension();
    if (base_.size() > end.size() && base::endsWith(base_, end)) {
      base_.erase(base_.size() - end.size());
    }
  }

  base::Result<std::vector<std::string>> write() {
    const std::string run =
        evaluation_.tag +
        (layout_ == Layout::Hunav2 ? "_" + std::to_string(evaluation_.runId) : "");
    writePair("", run, evaluation_.results, nullptr);
    for (const BehaviorEvaluation& behavior : evaluation_.behaviors) {
      writePair("_beh_" + std::to_string(behavior.behavior), run, behavior.results,
                &behavior.active);
    }
    if (base::hasErrors(problems_)) {
      return problems_;
    }
    return written_;
  }

 private:
  const char* extension() const { return layout_ == Layout::Hunav2 ? ".csv" : ".txt"; }

  void writePair(const std::string& part, const std::string& run,
                 const std::vector<MetricResult>& all, const std::vector<double>* active) {
    const std::vector<MetricResult> results = evaluatorResults(all, evaluation_.isSelection);
    std::vector<std::string> header = headerCells(results);
    std::vector<std::string> values = valueCells(evaluation_, results, evaluatorCell);
    if (layout_ == Layout::Hunav1) {  // has no run id
      header.erase(header.begin() + 1);
      values.erase(values.begin() + 1);
    }
    appendResult(base_ + part, row(header), row(values));
    std::vector<StepColumn> columns = columnsOf(results, evaluation_.times.size());
    if (active != nullptr) {
      columns.push_back(
          {"behavior_active", Kind::Count, [next = active->begin()]() mutable { return *next++; }});
    }
    put(base_ + part + "_steps_" + safeName(run) + extension(),
        separated(stepsText(evaluation_.times, columns)));
  }

  /// Appends the row to the first file of this name that has these columns or does not exist.
  void appendResult(const std::string& name, const std::string& header, const std::string& values) {
    for (int number = 1;; ++number) {
      const std::string path =
          name + (number == 1 ? "" : "_" + std::to_string(number)) + extension();
      const base::Result<std::string> before = base::readTextFile(path);
      if (!before) {
        put(path, header + values);
        return;
      }
      if (base::startsWith(*before, header)) {
        put(path, *before + values);
        return;
      }
    }
  }

  std::string row(const std::vector<std::string>& cells) const {
    std::string text;
    appendRow(text, cells);
    return separated(text);
  }

  /// Tabs instead of commas; names and numbers contain no comma, a tag may.
  std::string separated(std::string text) const {
    if (layout_ == Layout::Hunav1) {
      std::replace(text.begin(), text.end(), ',', '\t');
    }
    return text;
  }

  /// Replaces characters of a tag that are invalid in file names.
  static std::string safeName(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '/' || c == '\0' || c == '\n'; }, '_');
    return text;
  }

  void put(const std::string& path, const std::string& text) {
    const base::Diagnostics problems = base::writeFileAtomically(path, text);
    base::append(problems_, problems);
    if (problems.empty()) {
      written_.push_back(path);
    }
  }

  const Evaluation& evaluation_;
  std::string base_;
  Layout layout_;
  base::Diagnostics problems_;
  std::vector<std::string> written_;
};

}  // namespace

std::string evaluatorNumber(double value, Kind kind) {
  if (std::isnan(value)) {
    return "";
  }
  if (std::isinf(value)) {
    return value > 0.0 ? "inf" : "-inf";
  }
  if (kind == Kind::Boolean) {
    return value > 0.0 ? "True" : "False";
  }
  return kind == Kind::Count ? std::to_string(std::llround(value)) : floatText(value);
}

namespace {

Json pointsJson(const std::vector<Vec2>& points) {
  Json json = Json::array();
  for (const Vec2& point : points) {
    json.push_back({point.x(), point.y()});
  }
  return json;
}

void addWays(const EvaluatedPaths& ways, Json& to) {
  if (!ways.toGoal.empty()) {
    to["shortest_ways"]["to_goal"] = pointsJson(ways.toGoal);
  }
  if (!ways.toEnd.empty()) {
    to["shortest_ways"]["to_end"] = pointsJson(ways.toEnd);
  }
}

}  // namespace

std::string toJson(const Evaluation& evaluation) {
  Json root;
  root["profile"] = profileName(evaluation.parameters.profile);
  root["metrics"] = resultsJson(evaluation.results);
  root["behaviors"] = behaviorsJson(evaluation);
  addWays(evaluation.evaluatedPaths, root);
  for (const Evaluation& other : evaluation.others) {
    root["robots"][other.robot] = {{"metrics", resultsJson(other.results)},
                                   {"behaviors", behaviorsJson(other)}};
    addWays(other.evaluatedPaths, root["robots"][other.robot]);
  }
  root["parameters"] = parametersJson(evaluation.parameters);
  root["experiment_tag"] = evaluation.tag;
  root["run_id"] = evaluation.runId;
  if (evaluation.robotId != -1) {  // otherwise the first, as in every run
    root["robot"] = evaluation.robotId;
  }
  return base::jsonText(root) + "\n";
}

std::string robotFile(const std::string& stem, const std::string& robot) {
  return stem + "_" + robot + ".csv";
}

std::string metricsCsv(const Evaluation& evaluation) {
  std::string text;
  appendRow(text, headerCells(evaluation.results));
  appendRow(text, valueCells(evaluation, evaluation.results, valueCell));
  return text;
}

std::string stepsCsv(const Evaluation& evaluation) {
  return stepsText(evaluation.times, columnsOf(evaluation.results, evaluation.times.size()));
}

void writeSteps(const std::vector<double>& times, const std::vector<StepColumn>& columns,
                const TextSink& to) {
  std::string text;
  std::vector<std::string> cells = {"time_stamps"};
  for (const StepColumn& column : columns) {
    cells.push_back(column.key);
  }
  appendRow(text, cells);
  for (const double time : times) {
    cells = {evaluatorNumber(time, Kind::Number)};
    for (const StepColumn& column : columns) {
      cells.push_back(finiteNumber(column.next(), column.kind));
    }
    to(text);
    text.clear();
    appendRow(text, cells);
  }
  to(text);
}

namespace {

/// For display: six digits; "-" if undefined.
std::string displayText(const MetricResult& result) {
  const std::optional<double>& value = result.value.value;
  if (!value) {
    return "-";
  }
  if (result.info.kind != Kind::Number || !std::isfinite(*value)) {
    return evaluatorNumber(*value, result.info.kind);
  }
  std::array<char, 32> text{};
  const std::to_chars_result end =
      std::to_chars(text.begin(), text.end(), *value, std::chars_format::general, 6);
  return {text.begin(), end.ptr};
}

/// Aligns the first column to the left and the numbers to the right; the last column is not
/// aligned.
std::string alignedText(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size(), 5);
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      widths[k] = std::max(widths[k], row[k].size());
    }
  }
  std::string text;
  for (const std::vector<std::string>& row : rows) {
    text += row.front() + std::string(widths.front() - row.front().size(), ' ');
    for (std::size_t k = 1; k + 1 < row.size(); ++k) {
      text += std::string(2 + widths[k] - row[k].size(), ' ') + row[k];
    }
    text += (row.back().empty() ? "" : "  " + row.back()) + "\n";
  }
  return text;
}

/// One metric of all robots, its unit and the reasons for undefined values.
std::vector<std::string> tableRow(const MetricInfo& info,
                                  const std::vector<const Evaluation*>& robots) {
  std::vector<std::string> row = {info.key};
  std::string rest = info.unit;
  for (const Evaluation* robot : robots) {
    const MetricResult* its = robot->find(info.key);
    row.push_back(its != nullptr ? displayText(*its) : "");
    if (its != nullptr && !its->value.why.empty()) {
      const std::string whose = robots.size() > 1 ? robot->robot + ": " : "";
      rest += (rest.empty() ? "(" : " (") + whose + its->value.why + ")";
    }
  }
  row.push_back(std::move(rest));
  return row;
}

bool lacksRobot(const MetricResult& result) {
  return result.value.why == kNoRobot;
}

}  // namespace

std::string tableText(const Evaluation& evaluation) {
  std::vector<const Evaluation*> robots = {&evaluation};
  for (const Evaluation& other : evaluation.others) {
    robots.push_back(&other);
  }
  std::vector<std::vector<std::string>> rows = {{"metric"}};
  for (const Evaluation* robot : robots) {
    rows.front().push_back(robots.size() == 1 ? "value" : robot->robot);
  }
  rows.front().emplace_back("unit");
  constexpr std::ptrdiff_t kMostListed = 5;  // with the same reason
  const std::ptrdiff_t lacking =
      std::count_if(evaluation.results.begin(), evaluation.results.end(), lacksRobot);
  for (const MetricResult& result : evaluation.results) {
    if (lacking <= kMostListed || !lacksRobot(result)) {
      rows.push_back(tableRow(result.info, robots));
    }
  }
  return alignedText(rows) +
         (lacking > kMostListed
              ? std::to_string(lacking) + " metrics of the robot are left out: " + kNoRobot + "\n"
              : std::string());
}

base::Result<std::vector<std::string>> writeEvaluatorFiles(const Evaluation& evaluation,
                                                           const std::string& base, Layout layout) {
  return EvaluatorFileWriter(evaluation, base, layout).write();
}

}  // namespace metrics
