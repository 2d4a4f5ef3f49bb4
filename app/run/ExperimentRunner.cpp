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

base::Diagnostics ExperimentRunner::checkScenario(std::size_t scenario) {
  const Bundle bundle =
      readBundle(experiment_.optionsOf(scenario * runsPerScenario()), RunSettings(), files_);
  std::vector<std::size_t>& inputs = inputsOfScenario_.emplace_back();
  for (const std::string& path : filesOf(experiment_, scenario, bundle, files_)) {
    inputs.push_back(inputs_.look(path));
  }
  const Verdict verdict = app::check(bundle);
  base::Diagnostics problems;
  for (base::Diagnostic problem : errorsOf(verdict.wrongWords)) {  // warnings: by who read it
    problem.file = problem.file.empty() ? experiment_.path : problem.file;
    problems.push_back(std::move(problem));
  }
  base::append(problems, errorsOf(verdict.problems));
  if (!experiment_.allowCode) {
    base::append(problems, tellForeignCode(foreignCodeOf(experiment_, *bundle.scenario),
                                           base::Severity::Error, bundle.path));
  }
  return problems;
}

base::Diagnostics ExperimentRunner::check() {
  inputs_ = {};
  inputsOfScenario_.clear();
  base::Diagnostics problems;
  for (std::size_t k = 0; k < experiment_.scenarios.size(); ++k) {
    base::append(problems, checkScenario(k));
  }
  return problems;
}

base::Diagnostics ExperimentRunner::changedInputs(std::size_t index) {
  base::Diagnostics problems;
  for (const std::string& path : inputs_.changed(inputsOfScenario_[index / runsPerScenario()])) {
    problems.push_back(base::error("batch.input-changed", {}, path));
  }
  return problems;
}

std::string ExperimentRunner::folderOf(std::size_t run) const {
  return (std::filesystem::path(runsFolder_) / std::to_string(run)).string();
}

base::Result<ResultRow> ExperimentRunner::run(std::size_t index) {
  const bool hasFiles = experiment_.record != Record::Metrics;
  const base::Diagnostics stays = removeRun(folderOf(index));  // of an earlier batch, or cut short
  if (!stays.empty()) {
    return stays;
  }
  const Bundle bundle = readBundle(experiment_.optionsOf(index), settingsOf(experiment_), files_);
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
