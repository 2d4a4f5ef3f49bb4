#include "app/run/ExperimentRunner.h"

#include <filesystem>
#include <optional>

#include "app/run/DataPaths.h"
#include "app/run/ExperimentInputs.h"
#include "app/run/Simulation.h"

namespace app {

namespace {

using Record = Experiment::Record;

/// The settings of all runs: options of an experiment say nothing about them.
RunSettings settingsOf(const Experiment& experiment) {
  RunSettings settings;
  settings.code = experiment.allowCode ? sim2d::CodeUse::Allowed : sim2d::CodeUse::Refused;
  return settings;
}

}  // namespace

/// What was read before may be kept; what was written since it was looked at is read again.
Bundle ExperimentRunner::read(std::size_t index, const RunSettings& settings, Used& used) {
  constexpr int kMostReads = 5;
  for (int reads = 1;; ++reads) {
    const std::timespec before = SeenFiles::now();
    Bundle bundle = readBundle(experiment_.optionsOf(index), settings, *files_);
    used = filesOf(bundle);
    if (reads == kMostReads || !seen_.areWrittenSince(used, before)) {
      return bundle;
    }
    files_ = std::make_unique<KnownFiles>(loader_);
  }
}

const ExperimentRunner::Used& ExperimentRunner::filesOf(const Bundle& bundle) {
  constexpr std::size_t kMostKnown = 10000;
  std::vector<std::string> names = bundle.inputs;  // with trees, but not what those include
  for (const ForeignCode& code : foreignCodeOf(*bundle.scenario)) {
    names.push_back(code.words);
  }
  const auto found = usedBy_.find(names);
  if (found != usedBy_.end()) {
    return found->second;
  }
  if (usedBy_.size() >= kMostKnown) {
    usedBy_.clear();
  }
  Used& used = usedBy_[names];
  for (const std::string& path : inputFilesOf(bundle)) {
    used.push_back(seen_.look(path));
  }
  return used;
}

base::Diagnostics ExperimentRunner::checkScenario(std::size_t scenario,
                                                  base::Severity ofForeignCode) {
  const std::size_t runs = experiment_.runCount() / experiment_.scenarios.size();
  Used used;
  const Bundle bundle = read(scenario * runs, RunSettings(), used);
  const Verdict verdict = app::check(bundle);
  base::Diagnostics problems;
  for (base::Diagnostic problem : errorsOf(verdict.wrongWords)) {  // warnings: by who read it
    problem.file = problem.file.empty() ? experiment_.path : problem.file;
    problems.push_back(std::move(problem));
  }
  base::append(problems, errorsOf(verdict.problems));
  if (!experiment_.allowCode) {
    base::append(problems, tellForeignCode(foreignCodeOf(experiment_, *bundle.scenario),
                                           ofForeignCode, bundle.path));
  }
  return problems;
}

base::Diagnostics ExperimentRunner::check(base::Severity ofForeignCode) {
  base::Diagnostics problems;
  for (std::size_t k = 0; k < experiment_.scenarios.size(); ++k) {
    base::append(problems, checkScenario(k, ofForeignCode));
  }
  return problems;
}

std::string ExperimentRunner::folderOf(std::size_t run) const {
  return (std::filesystem::path(runsFolder_) / std::to_string(run)).string();
}

base::Result<ResultRow> ExperimentRunner::run(
    std::size_t index, const std::function<void(const std::vector<InputHash>&)>& met) {
  const base::Diagnostics stays = removeRun(folderOf(index));  // of an earlier batch, or cut short
  if (!stays.empty()) {
    return stays;
  }
  Used used;
  const Bundle bundle = read(index, settingsOf(experiment_), used);
  if (met) {
    met(seen_.thenAndNow(used));
  }
  base::Result<ResultRow> row = make(index, bundle);
  if (row) {
    row->inputs = seen_.thenAndNow(used);
  }
  return row;
}

base::Result<ResultRow> ExperimentRunner::make(std::size_t index, const Bundle& bundle) {
  const bool hasFiles = experiment_.record != Record::Metrics;
  Verdict verdict = app::check(bundle);
  if (!verdict.ok()) {
    base::Diagnostics all = verdict.wrongWords;
    base::append(all, verdict.problems);
    return rowOf(all);
  }
  sim2d::World& world = *verdict.world;
  wantNoMore(hasFiles, hasFiles, verdict.metrics.selection);
  base::Result<std::unique_ptr<OutputFolder>> output = std::unique_ptr<OutputFolder>();
  if (hasFiles) {
    output = OutputFolder::open(folderOf(index), true);  // the batch has looked
  }
  if (!output) {
    return output.diagnostics();
  }
  RunWriter writer(hasFiles ? (*output)->staging() : std::string(), world, world.header(),
                   verdict.metrics.selection, verdict.metrics.parameters, bundle.routes);
  Session session(sim2d::stopRuleOf(*bundle.scenario));
  FinishedRun run = simulate(
      session, world, verdict.scenarioMetrics, writer, [](const sim2d::Frame&) { return false; },
      hasFiles ? PlanningClock::On : PlanningClock::Off);
  const ResultRow row = rowOf(run);
  base::Diagnostics problems;
  if (hasFiles && (isKept(row) || writer.hasFailed())) {
    problems = keep(index, run, writer, bundle, **output);
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return row;
}

bool ExperimentRunner::isKept(const ResultRow& row) const {
  return experiment_.record == Record::All || (experiment_.record == Record::Failed && !row.ok) ||
         (experiment_.record == Record::Unsuccessful && isWithoutSuccess(row));
}

base::Diagnostics ExperimentRunner::keep(std::size_t index, FinishedRun& run, RunWriter& writer,
                                         const Bundle& bundle, OutputFolder& output) {
  std::vector<std::string> words = experiment_.wordsOf(index);
  words.insert(words.begin(), programPath());
  words.insert(words.end(), {"--quiet", "-o", folderOf(index)});
  base::Diagnostics problems = writeRunFolder(output, run, writer, bundle, words);
  for (base::Diagnostic& problem : problems) {  // nobody would see a warning
    problem.severity = base::Severity::Error;
  }
  return problems;
}

}  // namespace app
