#include "app/report/Study.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/ManifestFiles.h"
#include "app/run/ResultRow.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Csv.h"

namespace report {

namespace {

constexpr std::size_t kMaxProblems = 10;
constexpr double kUndefinedValue = std::numeric_limits<double>::quiet_NaN();

class ResultsReader {
 public:
  ResultsReader(const std::string& text, std::string file)
      : reader_(text), file_(std::move(file)) {}

  base::Result<Results> read() {
    if (!readColumns()) {
      return problems_;
    }
    sim2d::CsvRow row;
    sim2d::CsvField last;  // the reader returns no row at the end
    while (problems_.size() < kMaxProblems && nextRow(row)) {
      readRow(row);
      last = row.back();
    }
    if (problems_.empty() && reader_.isTruncated()) {
      addProblem(last, "trace.cut-line");
    }
    if (problems_.empty() && results_.runs.empty()) {
      problems_.push_back(base::error("report.no-runs", {}, file_));
    }
    if (!problems_.empty()) {
      return problems_;
    }
    return std::move(results_);
  }

 private:
  void addProblem(const sim2d::CsvField& field, std::string_view code,
                  base::ProblemValues values = {}) {
    problems_.push_back(base::error(code, std::move(values), file_, field.line, field.column));
  }

  /// Columns: run,scenario,seed,<value paths>,status,reason,simulated,<metric keys>
  bool nextRow(sim2d::CsvRow& row) {
    const bool hasRow = reader_.next(row);
    for (sim2d::CsvField& field : row) {
      sim2d::removeFormulaMark(field.text);
    }
    return hasRow;
  }

  bool readColumns() {
    sim2d::CsvRow row;
    const bool hasRow = nextRow(row);
    const auto is = [&row](std::size_t at, const char* name) {
      return at < row.size() && row[at].text == name;
    };
    const auto status = std::find_if(row.begin(), row.end(), [](const sim2d::CsvField& field) {
      return field.text == "status";
    });
    status_ = static_cast<std::size_t>(status - row.begin());
    if (!hasRow || !is(0, "run") || !is(1, "scenario") || !is(2, "seed") || status_ < kFixed ||
        !is(status_ + 1, "reason") || !is(status_ + 2, "simulated")) {
      problems_.push_back(base::error("report.columns", {}, file_, 1, 1));
      return false;
    }
    std::set<std::string> known;
    for (std::size_t at = kFixed; at < row.size(); ++at) {
      if (!known.insert(row[at].text).second || row[at].text.empty()) {
        addProblem(row[at], "report.column-twice", {row[at].text});
      }
      if (at < status_) {
        results_.paths.push_back(row[at].text);
      } else if (at > status_ + 2) {
        results_.keys.push_back(row[at].text);
      }
    }
    columns_ = row.size();
    results_.metrics.resize(results_.keys.size());
    results_.isBoolean.assign(results_.keys.size(), false);
    return problems_.empty();
  }

  void readRow(const sim2d::CsvRow& row) {
    if (row.size() != columns_) {
      addProblem(row.front(), "trace.field-count", {row.size(), columns_});
      return;
    }
    Results::Run run;
    run.number = wholeOf(row[0], "run");
    run.scenario = row[1].text;
    run.seed = wholeOf(row[2], "seed");
    for (std::size_t at = kFixed; at < status_; ++at) {
      run.values.push_back(row[at].text);
    }
    run.ok = row[status_].text == "ok";
    run.reason = row[status_ + 1].text;
    if (!run.ok && row[status_].text != "failed") {
      addProblem(row[status_], "report.status", {row[status_].text});
    }
    if (!numbers_.insert(run.number).second) {
      addProblem(row[0], "report.run-twice", {run.number});
    }
    for (std::size_t k = 0; k < results_.keys.size(); ++k) {
      readMetric(row[status_ + 3 + k], k);
    }
    results_.runs.push_back(std::move(run));
  }

  long long wholeOf(const sim2d::CsvField& field, const char* name) {
    const std::optional<long long> number = base::parseInt(field.text);
    if (!number || *number < 0) {
      addProblem(field, "trace.not-whole", {name, field.text});
    }
    return number.value_or(0);
  }

  void readMetric(const sim2d::CsvField& field, std::size_t key) {
    double value = kUndefinedValue;
    if (field.text == "True" || field.text == "False") {
      value = field.text == "True" ? 1.0 : 0.0;
      results_.isBoolean[key] = true;
    } else if (!field.text.empty()) {
      const std::optional<double> number = base::parseDouble(field.text);
      if (!number) {
        addProblem(field, "trace.not-finite", {results_.keys[key], field.text});
      }
      value = number.value_or(kUndefinedValue);
      value = std::abs(value) <= std::numeric_limits<double>::max() ? value : kUndefinedValue;
    }
    results_.metrics[key].push_back(value);
  }

  static constexpr std::size_t kFixed = 3;  // run, scenario, seed

  sim2d::CsvReader reader_;
  std::string file_;
  base::Diagnostics problems_;
  Results results_;
  std::set<long long> numbers_;
  std::size_t status_ = 0;
  std::size_t columns_ = 0;
};

}  // namespace

std::size_t Results::keyAt(const std::string& key) const {
  return static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
}

base::Result<Results> parseResults(const std::string& text, const std::string& file) {
  return ResultsReader(text, file).read();
}

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Null if there is none.
Json memberOf(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() ? *found : Json();
}

std::string textIn(const Json& object, const char* key) {
  const Json found = memberOf(object, key);
  return found.is_string() ? found.get<std::string>() : std::string();
}

/// Collects the warnings of `check` for the experiment and its scenarios, without those of files
/// that were changed after the runs.
void findInputWarnings(const base::Result<app::Experiment>& experiment,
                       const sim2d::ImageLoader& loader, Study& study) {
  base::Diagnostics found = experiment.diagnostics();
  base::append(found, app::ExperimentRunner(*experiment, {}, loader).warnings());
  for (base::Diagnostic& problem : found) {
    const auto& changed = study.changedInputs;
    if (std::find(changed.begin(), changed.end(), problem.file) == changed.end()) {
      study.inputWarnings.push_back(std::move(problem));
    }
  }
}

/// Reads the `run` options and the warnings of the experiment, if the file is unchanged. Returns
/// the errors if it exists but cannot be read.
base::Diagnostics readExperimentOf(const sim2d::ImageLoader& loader, Study& study) {
  std::error_code gone;
  if (study.inputs.empty() || !fs::exists(study.inputs.front().path, gone)) {
    return {};
  }
  const auto& [path, hash] = study.inputs.front();
  const base::Result<std::string> text = base::readTextFile(path);
  if (text && app::sha256Of(*text) != hash) {
    return {};
  }
  const base::Result<app::Experiment> experiment =
      !text               ? base::Result<app::Experiment>(text.diagnostics())
      : study.sensitivity ? app::readSensitivityExperiment(path, {study.sensitivity->design.method,
                                                                  study.sensitivity->design.points})
                          : app::readExperiment(path);
  if (!experiment) {
    return experiment.diagnostics();
  }
  study.hasRunOptions = true;
  const std::vector<std::string> words = app::commandLineOf(experiment->common);
  study.runOptions.assign(words.begin() + 1, words.end());  // without `run`
  if (loader) {
    findInputWarnings(experiment, loader, study);
  }
  return {};
}

/// Reads "drawn": scenario -> seed -> path -> value.
void readDrawn(const Json& manifest, Study& study) {
  std::set<std::string> paths;
  const auto drawn = manifest.find("drawn");
  for (const Json& seeds : drawn != manifest.end() ? *drawn : Json()) {
    for (const Json& values : seeds) {
      for (auto value = values.begin(); values.is_object() && value != values.end(); ++value) {
        paths.insert(value.key());
      }
    }
  }
  study.drawn.assign(paths.begin(), paths.end());
}

/// Reads "design". False: it is not the design of a sensitivity analysis.
bool readSensitivity(const Json& design, Study::Sensitivity& sensitivity) {
  const auto& names = app::Design::kMethodNames;
  const auto* const method =
      std::find(std::begin(names), std::end(names), textIn(design, "method"));
  const auto isCount = [&](const char* key) {
    const auto found = design.find(key);
    return found != design.end() && found->is_number_unsigned();
  };
  if (method == std::end(names) || !isCount("points") || !isCount("seed")) {
    return false;
  }
  sensitivity.design = {static_cast<app::Design::Method>(method - std::begin(names)),
                        design["points"].get<std::size_t>(), design["seed"].get<std::uint64_t>()};
  const auto factors = design.find("factors");
  for (const Json& factor : factors != design.end() ? *factors : Json::array()) {
    const auto from = factor.find("from"), to = factor.find("to");
    const bool isRange = from != factor.end() && to != factor.end() && from->is_number() &&
                         to->is_number() && from->get<double>() < to->get<double>();
    if (!isRange) {
      return false;
    }
    sensitivity.factors.push_back({textIn(factor, "path"), from->get<double>(), to->get<double>()});
  }
  return sensitivity.design.isForSensitivity() && !sensitivity.factors.empty();
}

base::Diagnostics readManifest(const fs::path& path, Study& study) {
  std::error_code ignored;  // inaccessible counts as missing
  if (!fs::exists(path, ignored)) {
    return {base::warning("report.no-manifest", {}, path.string())};
  }
  const base::Result<std::string> text = base::readTextFile(path.string(), base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  const Json manifest = Json::parse(base::shallowJson(*text), nullptr, false);
  const bool isManifest = manifest.is_object() && manifest.contains("program") &&
                          manifest.contains("inputs") && manifest["inputs"].is_array() &&
                          manifest.contains("runs");
  if (!isManifest) {
    return {base::error("report.bad-manifest", {}, path.string())};
  }
  study.version = textIn(manifest["program"], "version");
  study.commit = textIn(manifest["program"], "commit");
  study.status = textIn(manifest, "status");
  for (const Json& input : manifest["inputs"]) {
    study.inputs.push_back({textIn(input, "path"), textIn(input, "sha256")});
  }
  study.shard = textIn(manifest, "shard");
  const auto code = manifest.find("code");
  study.allowsCode = code != manifest.end() && memberOf(*code, "allowed") == Json(true);
  const auto limit = manifest.find("time_limit");
  if (limit != manifest.end() && limit->is_number()) {
    study.timeLimit = limit->get<double>();
  }
  if (const auto until = manifest.find("until"); until != manifest.end() && until->is_object()) {
    const Json seeds = memberOf(*until, "seeds");
    study.enoughSeeds = seeds.is_number_integer() ? seeds.get<long long>() : 0;
    study.until = study.enoughSeeds > 0 ? textIn(*until, "condition") : std::string();
  }
  readDrawn(manifest, study);
  const auto design = manifest.find("design");
  Study::Sensitivity sensitivity;
  if (design != manifest.end() && !(design->is_object() && readSensitivity(*design, sensitivity))) {
    return {base::error("report.bad-manifest", {}, path.string())};
  }
  if (design != manifest.end()) {
    study.sensitivity = std::move(sensitivity);
  }
  return {};
}

}  // namespace

std::string shellText(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  std::transform(words.begin(), words.end(), std::back_inserter(quoted), base::shellWord);
  return base::join(quoted, " ");
}

std::string Study::scenarioName(std::size_t run) const {
  return results.runs[run].scenario.substr(commonPrefixLength);
}

std::optional<std::string> Study::runFolder(std::size_t run) const {
  const fs::path place = fs::path(folder) / "runs" / std::to_string(results.runs[run].number);
  std::error_code ignored;  // inaccessible counts as missing
  return fs::exists(place / "trace.json", ignored) ? std::optional(place.string()) : std::nullopt;
}

std::string Study::outcomeText(std::size_t run) const {
  return app::outcomeText(
      results.runs[run].ok, results.runs[run].reason, [this, run](const char* key) {
        const std::size_t metric = results.keyAt(key);
        return metric < results.keys.size() ? valuesOf(metric)[run] : kUndefinedValue;
      });
}

std::vector<std::string> Study::batchCommand() const {
  std::vector<std::string> words = {"hunavsim", "batch", inputs.front().path, "-o", folder};
  if (allowsCode) {
    words.emplace_back("--allow-code");
  }
  if (timeLimit) {
    words.insert(words.end(), {"--time-limit", base::formatDouble(*timeLimit)});
  }
  if (!shard.empty()) {
    words.insert(words.end(), {"--shard", shard});
  }
  return words;
}

std::string Study::replayCommand(std::size_t run) const {
  if (const std::optional<std::string> kept = runFolder(run)) {
    return shellText({"hunavsim", *kept});
  }
  const Results::Run& row = results.runs[run];
  std::string scenario = row.scenario;
  for (const app::InputHash& input : inputs) {  // the path on disk, if known
    const fs::path path(input.path);
    if (input.path == row.scenario || base::endsWith(input.path, "/" + row.scenario) ||
        path.stem().string() == row.scenario) {
      scenario = input.path;
    }
  }
  std::vector<std::string> words = {"hunavsim", scenario, "--seed", std::to_string(row.seed)};
  words.insert(words.end(), runOptions.begin(), runOptions.end());
  for (std::size_t k = 0; k < results.paths.size(); ++k) {
    words.insert(words.end(), {"--set", results.paths[k] + "=" + row.values[k]});
  }
  return shellText(words);
}

base::Result<Study> readStudy(const StudyOptions& studyOptions) {
  std::error_code ignored;  // inaccessible counts as missing
  if (fs::is_regular_file(studyOptions.folder, ignored)) {
    return base::error("report.file-for-batch", {}, studyOptions.folder);
  }
  const std::string file = (fs::path(studyOptions.folder) / "results.csv").string();
  const base::Result<std::string> text = base::readTextFile(file, base::kMaxRecord);
  Study manifest;
  base::Diagnostics problems = text.diagnostics();
  base::append(problems, readManifest(fs::path(studyOptions.folder) / "manifest.json", manifest));
  const std::string coverage = (fs::path(studyOptions.folder) / app::kTreeCoverageFile).string();
  const bool hasCoverage = fs::exists(coverage, ignored);
  base::append(problems, app::checkManifestFiles(studyOptions.folder, {"results.csv"}));
  if (hasCoverage) {
    base::Result<std::vector<app::CoveredTree>> trees = app::readTreeCoverage(coverage);
    base::append(problems, trees.diagnostics());
    manifest.trees = trees ? *std::move(trees) : std::vector<app::CoveredTree>();
  }
  if (!text) {
    return problems;
  }
  base::Result<Results> results = parseResults(*text, file);
  base::append(problems, results.diagnostics());
  if (!results) {
    return problems;
  }
  Study study = std::move(manifest);
  study.folder = studyOptions.folder;
  study.results = *std::move(results);
  study.level = studyOptions.level;
  study.resamples = studyOptions.resamples;
  base::append(problems, selectCompared(studyOptions, study));
  if (base::hasErrors(problems)) {
    return problems;
  }
  study.resultsHash = app::sha256Of(*text);
  study.changedInputs = app::changedInputs(study.inputs);
  for (const std::string& input : study.changedInputs) {
    problems.push_back(base::warning("report.input-changed", {}, input));
  }
  for (base::Diagnostic& problem : readExperimentOf(studyOptions.loader, study)) {
    problem.severity = base::Severity::Warning;
    problems.push_back(std::move(problem));
    study.isExperimentUnreadable = true;
  }
  return base::Result<Study>(std::move(study), std::move(problems));
}

}  // namespace report
