#include <filesystem>
#include <optional>

#include <CLI/CLI.hpp>

#include "app/cli/BatchRuns.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/ReportFiles.h"
#include "app/report/SensitivityPage.h"
#include "app/run/Batch.h"
#include "app/run/BatchFolder.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/ResultRow.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct SensitivityOptions {
  report::StudyOptions studyOptions;  // its folder is the output folder
  std::string experiment, method, metrics;
  std::optional<std::size_t> points;
  int jobs = processorCount();
  double timeLimit = 0.0;  // [s]; 0 = none
  bool allowCode = false, resume = false, force = false, noPdf = false;
};

SensitivityRequest requestOf(const SensitivityOptions& options) {
  SensitivityRequest request;
  request.points = options.points;
  if (!options.method.empty()) {
    request.method = options.method == "sobol" ? Design::Method::Saltelli : Design::Method::Morris;
  }
  return request;
}

/// The command line of the analysis, without what does not change its result.
std::vector<std::string> commandOf(const SensitivityOptions& options, const Design& design) {
  std::vector<std::string> words = {"hunavsim",
                                    "sensitivity",
                                    options.experiment,
                                    "-o",
                                    options.studyOptions.folder,
                                    "--method",
                                    design.method == Design::Method::Morris ? "morris" : "sobol",
                                    "--points",
                                    std::to_string(design.points)};
  if (!options.metrics.empty()) {
    words.insert(words.end(), {"--metrics", options.metrics});
  }
  if (options.allowCode) {
    words.emplace_back("--allow-code");
  }
  const report::StudyOptions usual;
  if (options.studyOptions.level != usual.level) {
    words.insert(words.end(), {"--level", base::formatDouble(options.studyOptions.level)});
  }
  if (options.studyOptions.resamples != usual.resamples) {
    words.insert(words.end(), {"--resamples", std::to_string(options.studyOptions.resamples)});
  }
  return words;
}

/// The metric keys of the command line. Ends the command if no run can have one of them.
std::vector<std::string> analysedMetrics(const SensitivityOptions& options) {
  std::vector<std::string> keys;
  base::Diagnostics problems;
  for (const std::string& word : base::split(options.metrics, ',')) {
    const std::string key = base::trimmed(word);
    if (key.empty()) {
      continue;
    }
    if (!columnInfo(key)) {
      problems.push_back(base::error("metrics.unknown-metric",
                                     {key, base::nearestName(key, knownColumns())}, "--metrics"));
    }
    keys.push_back(key);
  }
  requireFine(problems, ExitWrongCommandLine);
  return keys;
}

/// Executes the missing runs; the folder is complete afterwards.
void executeDesign(const Experiment& experiment, const SensitivityOptions& options,
                   const Invocation& given) {
  const std::string& output = options.studyOptions.folder;
  ExperimentRunner runner(experiment, (std::filesystem::path(output) / "runs").string(),
                          loadMapImage);
  requireFine(runner.check());
  base::Result<Study> study = studyOf(experiment, runner.inputs(), Shard());
  requireFine(study.diagnostics());
  study->timeLimit = options.timeLimit;
  const ExistingBatch earlier = options.resume  ? ExistingBatch::Resume
                                : options.force ? ExistingBatch::Replace
                                                : ExistingBatch::Refuse;
  base::Result<std::unique_ptr<BatchFolder>> folder = BatchFolder::open(output, *study, earlier);
  requireFine(folder.diagnostics());
  catchInterrupts();
  base::Diagnostics problems =
      executeRuns(experiment, runner, **folder, {options.jobs, false, given.quiet || given.json});
  base::append(problems, (*folder)->finish());
  const ResultStore& store = (*folder)->store();
  if (!store.isComplete() || base::hasErrors(problems)) {
    printError("after " + std::to_string(store.finished()) + " of " +
               std::to_string(store.study().runs) +
               " runs: finished runs are kept; continue with --resume");
    requireFine(problems);
    throw CommandEnd{ExitRunFailed};
  }
}

void printFindings(const report::Study& study, const report::SensitivityAnalysis& analysis) {
  for (const std::string& finding : report::sensitivityFindings(study, analysis)) {
    printLine(finding);
  }
  const std::vector<std::string> warnings = report::sensitivityWarnings(study, analysis);
  if (!warnings.empty()) {
    printLine("uncertain:");
  }
  for (const std::string& warning : warnings) {
    printLine("  " + warning);
  }
}

int sensitivityCommand(const SensitivityOptions& options, const Invocation& given) {
  report::StudyOptions studyOptions = options.studyOptions;
  studyOptions.metrics = analysedMetrics(options);
  const base::Result<Experiment> read =
      readSensitivityExperiment(options.experiment, requestOf(options));
  requireFine(read.diagnostics());
  Experiment experiment = *read;
  experiment.allowCode = options.allowCode;
  executeDesign(experiment, options, given);
  Progress progress(given.quiet || given.json);
  progress.show("calculating indices");
  const base::Result<report::Study> study = report::readStudy(studyOptions);
  requireFine(study.diagnostics());
  const base::Result<report::SensitivityAnalysis> analysis = report::analyseSensitivity(*study);
  progress.clear();
  requireFine(analysis.diagnostics());
  const report::Report report =
      report::makeSensitivityReport(*study, *analysis, commandOf(options, *experiment.design));
  const std::vector<base::FileContent> files = filesOf(report, !options.noPdf);
  requireFine(writeReport(studyOptions.folder, files, options.force));
  if (given.json) {
    print(report::sensitivityJson(*study, *analysis));
  } else if (!given.quiet) {
    printFindings(*study, *analysis);
    printLine((std::filesystem::path(studyOptions.folder) / "report.html").string());
  }
  std::size_t failed = 0;
  for (const report::Results::Run& run : study->results.runs) {
    failed += run.ok ? 0 : 1;
  }
  if (failed > 0) {
    printError(std::to_string(failed) + " of " + std::to_string(study->runCount()) +
               " runs failed; results.csv has the reasons");
  }
  return failed == 0 ? ExitFine : ExitRunFailed;
}

Drawing drawingOfSensitivity(const SensitivityOptions& /*options*/) {
  return Drawing::Pictures;
}

}  // namespace

void addSensitivity(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("sensitivity", "Rank the values of an experiment by their effect on metrics",
                   sensitivityCommand, drawingOfSensitivity);
  command.add_option("experiment", options.experiment, "Experiment file")->required();
  addOutputFolder(command, options.studyOptions.folder, "Output folder").required();
  command
      .add_option(
          "--points", options.points,
          "Number of trajectories (morris; default: 20) or base points (sobol; default: 64); "
          "the runs are this number times the number of values plus 1 (sobol: plus 2), "
          "times scenarios and seeds")
      ->check(CLI::Range(std::size_t{2}, Design::kMaxPoints));
  command
      .add_option("--method", options.method,
                  "morris: screening with few runs; sobol: shares of the variance (default: the "
                  "experiment's design, otherwise morris)")
      ->check(oneOf({"morris", "sobol"}));
  command.add_option("--metrics", options.metrics,
                     "Metrics to analyse, comma-separated keys (default: a selection)");
  command.add_option("--level", options.studyOptions.level, "Confidence level (default: 0.95)")
      ->check(CLI::Range(0.5, 0.999));
  command
      .add_option("--resamples", options.studyOptions.resamples,
                  "Bootstrap resamples (default: 2000)")
      ->check(CLI::Range(100, 100000));
  addJobs(command, options.jobs);
  addAllowCode(command, options.allowCode);
  CLI::Option* const resume = command.add_flag(
      "--resume", options.resume,
      "Continue an interrupted analysis; if it is finished, only rewrite the report");
  command
      .add_flag("--force", options.force,
                "Restart an interrupted analysis from the beginning; overwrite files that hunavsim "
                "did not create")
      ->excludes(resume);
  addTimeLimit(command, options.timeLimit);
  command.add_flag("--no-pdf", options.noPdf, "Write figures as SVG only");
  commands.addExamples(command,
                       {{"hunavsim sensitivity study.yaml -o screening --points 20",
                         "Rank the values with a range by Morris screening", "your experiment"},
                        {"hunavsim sensitivity study.yaml -o indices --method sobol --points 128",
                         "Estimate Sobol indices", "your experiment"}});
}

}  // namespace app
