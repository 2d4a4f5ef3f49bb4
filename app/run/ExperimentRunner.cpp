#include "app/run/ExperimentRunner.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <utility>

#include "app/run/DataPaths.h"
#include "app/run/MetricsSetup.h"
#include "app/run/OptionCheck.h"
#include "app/run/RunFolder.h"
#include "app/run/Session.h"
#include "app/run/TreeCoverage.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

using Record = Experiment::Record;

/// The settings of all runs; the options of an experiment do not affect them.
RunSettings settingsOf(const Experiment& experiment) {
  RunSettings settings;
  settings.code = experiment.allowCode ? sim2d::ExternalCodePolicy::Allowed
                                       : sim2d::ExternalCodePolicy::Refused;
  return settings;
}

}  // namespace

base::Diagnostics ExperimentRunner::errorsOfFirstRun(std::size_t scenario) {
  const std::size_t runs = experiment_.runCount() / experiment_.scenarios.size();
  BundleReader::FileIndices used;
  const Bundle bundle = reader_.read(experiment_.specOf(scenario * runs), RunSettings(), used);
  const Verdict verdict = app::check(bundle);
  base::Diagnostics problems;
  for (base::Diagnostic problem : errorsOf(verdict.wrongOptions)) {  // the reader reports warnings
    problem.file = problem.file.empty() ? experiment_.path : problem.file;
    problems.push_back(std::move(problem));
  }
  base::append(problems, errorsOf(verdict.problems));
  return problems;
}

base::Diagnostics ExperimentRunner::check(base::Severity codeSeverity, Checked checked) {
  base::Diagnostics problems;
  OptionCheck options(experiment_);
  for (std::size_t k = 0; k < experiment_.scenarios.size(); ++k) {
    const base::Diagnostics errors = errorsOfFirstRun(k);
    base::append(problems, errors);
    if (!experiment_.allowCode) {
      base::append(problems, externalCodeProblems(externalCodeOf(experiment_, k), codeSeverity,
                                                  experiment_.scenarioPaths[k]));
    }
    if (checked == Checked::AllOptions) {
      base::append(problems, options.errorsIn(k, errors, reader_));
    }
  }
  return problems;
}

base::Diagnostics ExperimentRunner::warnings() {
  base::Diagnostics found;
  const std::size_t runs = experiment_.runCount() / experiment_.scenarios.size();
  for (std::size_t k = 0; k < experiment_.scenarios.size(); ++k) {
    const Verdict verdict = app::check(reader_.readToCheck(experiment_.specOf(k * runs)));
    for (const auto* const list :
         {&verdict.wrongOptions, &verdict.problems, &verdict.worldRemarks}) {
      for (const base::Diagnostic& problem : newDiagnostics(found, *list)) {
        if (problem.severity == base::Severity::Warning) {
          found.push_back(problem);
        }
      }
    }
  }
  return found;
}

std::string ExperimentRunner::folderOf(std::size_t run) const {
  return (std::filesystem::path(runsFolder_) / std::to_string(run)).string();
}

base::Result<ResultRow> ExperimentRunner::run(
    std::size_t index, const std::function<void(const std::vector<InputHash>&)>& reportInputs) {
  const base::Diagnostics removalProblems = removeRunFolder(folderOf(index));  // of earlier batches
  if (!removalProblems.empty()) {
    return removalProblems;
  }
  BundleReader::FileIndices used;
  const Bundle bundle = reader_.read(experiment_.specOf(index), settingsOf(experiment_), used);
  if (reportInputs) {
    reportInputs(reader_.withChanges(used));
  }
  base::Result<ResultRow> row =
      experiment_.record == Record::Metrics
          ? base::Result<ResultRow>(measureRun(bundle, experiment_.treeCoverage))
          : runWithFiles(index, bundle);
  if (row) {
    row->inputs = reader_.withChanges(used);
  }
  return row;
}

base::Result<ResultRow> ExperimentRunner::runWithFiles(std::size_t index, const Bundle& bundle) {
  Verdict verdict = app::check(bundle);
  if (!verdict.ok()) {
    base::Diagnostics all = verdict.wrongOptions;
    base::append(all, verdict.problems);
    return rowOf(all);
  }
  sim2d::World& world = *verdict.world;
  skipUnwrittenMetrics(true, true, verdict.metrics.selection);
  const base::Result<std::unique_ptr<OutputFolder>> output =
      OutputFolder::open(folderOf(index), true);  // BatchFolder::open has checked the folder
  if (!output) {
    return output.diagnostics();
  }
  RunWriter writer((*output)->staging(), world, world.header(), verdict.metrics.selection,
                   verdict.metrics.parameters, bundle.routes);
  Session session(sim2d::stopRuleOf(*bundle.scenario));
  FinishedRun run = simulate(session, world, verdict.scenarioMetrics, writer,
                             [](const sim2d::Frame&) { return false; });
  ResultRow row = rowOf(run);
  if (experiment_.treeCoverage) {
    row.trees = treeRowsOf(world.treeResults());
  }
  base::Diagnostics problems;
  if (isKept(row) || writer.hasFailed()) {
    problems = writeFiles(index, run, writer, bundle, **output);
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return row;
}

bool ExperimentRunner::isKept(const ResultRow& row) const {
  return experiment_.record == Record::All || (experiment_.record == Record::Failed && !row.ok) ||
         (experiment_.record == Record::Unsuccessful && isUnsuccessful(row));
}

base::Diagnostics ExperimentRunner::writeFiles(std::size_t index, FinishedRun& run,
                                               RunWriter& writer, const Bundle& bundle,
                                               OutputFolder& output) {
  std::vector<std::string> words = commandLineOf(experiment_.specOf(index));
  words.insert(words.begin(), programPath());
  words.insert(words.end(), {"--quiet", "-o", folderOf(index)});
  base::Diagnostics problems = writeRunFolder(output, run, writer, bundle, words);
  for (base::Diagnostic& problem : problems) {  // warnings would not be shown
    problem.severity = base::Severity::Error;
  }
  return problems;
}

namespace {

/// Whether a value can set what a robot starts: of a planner's key, or of the whole robot.
bool mayNameCode(const ExperimentValue& value) {
  constexpr const char* kKeys[] = {"planner", "command", "planner_parameters", "file"};
  const std::string& path = value.path;
  const std::string last = path.substr(path.rfind('.') + 1);  // the whole path if it has no dot
  return last == path || std::any_of(std::begin(kKeys), std::end(kKeys),
                                     [&](const char* key) { return last == key; });
}

/// Searches all combinations of the texts that may name code; if there are too many, each text
/// combined with the first ones of the other values.
class ExternalCodeSearch {
 public:
  explicit ExternalCodeSearch(const Experiment& experiment) {
    for (const ExperimentValue& value : experiment.values) {
      Texts texts = mayNameCode(value) ? textsOf(value) : Texts();
      if (!texts.empty()) {
        combinations_ = std::min(kMaxCombinations + 1, combinations_ * texts.size());
        values_.emplace_back(value.path, std::move(texts));
      }
    }
  }

  void search(const sim2d::Scenario& scenario) {
    if (combinations_ <= kMaxCombinations) {
      visit(scenario, 0);
      return;
    }
    for (std::size_t varied = 0; varied < values_.size(); ++varied) {
      for (const std::string& text : values_[varied].second) {
        sim2d::Scenario changed = scenario;
        for (std::size_t k = 0; k < values_.size(); ++k) {
          put(changed, k, k == varied ? text : values_[k].second.front());
        }
        collect(changed);
      }
    }
  }
  std::vector<ExternalCode> take() { return std::move(found_); }

 private:
  using Texts = std::vector<std::string>;

  /// Without numbers, which name no code.
  static Texts textsOf(const ExperimentValue& value) {
    Texts texts;
    for (const std::size_t k : value.representativeTexts()) {
      if (!base::parseDouble(value.texts[k])) {
        texts.push_back(value.texts[k]);
      }
    }
    return texts;
  }

  /// A value that cannot be set is reported by the check of the experiment.
  void put(sim2d::Scenario& scenario, std::size_t value, const std::string& text) const {
    sim2d::setValue(scenario, values_[value].first, text);
  }
  void visit(const sim2d::Scenario& scenario, std::size_t value) {
    if (value == values_.size()) {
      collect(scenario);
      return;
    }
    for (const std::string& text : values_[value].second) {
      sim2d::Scenario changed = scenario;
      put(changed, value, text);
      visit(changed, value + 1);
    }
  }
  void collect(const sim2d::Scenario& scenario) {
    for (const ExternalCode& code : externalCodeOf(scenario)) {
      if (std::find(found_.begin(), found_.end(), code) == found_.end()) {
        found_.push_back(code);
      }
    }
  }

  static constexpr std::size_t kMaxCombinations = 2000;
  std::vector<std::pair<std::string, Texts>> values_;  // path, texts
  std::size_t combinations_ = 1;                       // at most kMaxCombinations + 1
  std::vector<ExternalCode> found_;
};

}  // namespace

std::vector<ExternalCode> externalCodeOf(const Experiment& experiment, std::size_t scenario) {
  sim2d::Scenario withoutValues = sim2d::readScenario(experiment.scenarioPaths[scenario]).scenario;
  applyOptions(withoutValues, experiment.common, {});
  ExternalCodeSearch search(experiment);
  search.search(withoutValues);
  return search.take();
}

std::vector<std::string> inputFilesOf(const Bundle& bundle) {
  std::vector<std::string> paths = inputsOf(bundle);
  for (const ExternalCode& code : externalCodeOf(*bundle.scenario)) {
    const std::optional<std::string> file = codeFileOf(code, bundle.path);
    if (file && std::find(paths.begin(), paths.end(), *file) == paths.end()) {
      paths.push_back(*file);
    }
  }
  return paths;
}

}  // namespace app
