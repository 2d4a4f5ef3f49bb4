#include "app/run/Batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/BatchReport.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/cli/MapImages.h"
#include "app/run/BatchFolder.h"
#include "app/run/ClusterScript.h"
#include "app/run/DataPaths.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/ResultFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct BatchOptions {
  std::string experiment;
  std::string output;
  int jobs = 0;  // 0 = number of cores
  bool allowCode = false, resume = false, retryFailed = false, force = false;
  bool rows = false;       // on standard output
  std::string shard;       // "K/N"; empty = all runs
  double timeLimit = 0.0;  // [s]; 0 = none
  std::string script;      // "slurm", "parallel"; empty: the runs are made
  std::size_t chunks = 20;
};

namespace fs = std::filesystem;

/// Nothing: it is none.
std::optional<Shard> shardOf(const std::string& text) {
  constexpr long long kMost = 1'000'000;
  const std::vector<std::string> parts = base::split(text, '/');
  const auto number = base::parseInt(parts.front()), count = base::parseInt(parts.back());
  const bool isShard =
      parts.size() == 2 && number && count && *number >= 1 && *number <= *count && *count <= kMost;
  return isShard ? std::optional(
                       Shard{static_cast<std::size_t>(*number), static_cast<std::size_t>(*count)})
                 : std::nullopt;
}

std::string shardProblem(const std::string& text) {
  return shardOf(text) ? std::string() : "K/N is wanted with 1 <= K <= N, not '" + text + "'";
}

std::string progressText(std::size_t finished, std::size_t total, double rate) {
  std::string text = std::to_string(finished) + " / " + std::to_string(total) + " runs";
  if (rate > 0.0) {
    text += ", " + base::formatDecimals(std::round(rate * 10.0) / 10.0, 1) + " runs/s, " +
            durationText(static_cast<double>(total - finished) / rate) + " left";
  }
  return text;
}

std::string absolute(const std::string& path) {
  std::error_code ignored;
  return fs::absolute(path, ignored).lexically_normal().string();
}

int printScript(const BatchOptions& options, const Invocation& given) {
  const ClusterJob job{
      programPath(),     absolute(options.experiment), absolute(options.output), options.chunks,
      options.allowCode, options.retryFailed,          options.timeLimit};
  const std::string script = options.script == "slurm" ? slurmScript(job) : parallelScript(job);
  print(given.json
            ? base::jsonText(nlohmann::ordered_json{{"script", options.script}, {"text", script}}) +
                  "\n"
            : script);
  return ExitFine;
}

/// The runs that are missing in the folder; returns what ended them before their time.
base::Diagnostics makeRuns(const Experiment& experiment, ExperimentRunner& runner,
                           BatchFolder& folder, const BatchOptions& options, bool quiet) {
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const ResultStore& store = folder.store();
  const std::size_t total = store.study().shard.runsOf(store.study().runs);
  const std::size_t before = store.finished();
  const auto start = std::chrono::steady_clock::now();
  Progress progress(quiet);
  const auto printRow = [&](const StoredRun& run) { print(rowJson(store.study(), run) + "\n"); };
  if (options.rows) {
    print(beginJson(store) + "\n");
    base::Diagnostics unreadable = store.forEach(printRow);
    if (!unreadable.empty()) {
      return unreadable;
    }
  }
  const auto show = [&] {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    const auto made = static_cast<double>(store.finished() - before);
    progress.show(progressText(store.finished(), total, made / elapsed.count()));
  };
  show();
  BatchJob job;
  job.runs = folder.missing();
  job.jobs = options.jobs > 0 ? options.jobs : cores;
  const double limit = store.study().timeLimit;
  job.timeLimit = limit > 0.0 ? limit : job.timeLimit;
  job.make = [&](std::size_t run, const BatchJob::Met& met) { return runner.run(run, met); };
  job.take = [&](std::size_t run, const ResultRow& row) {
    const Experiment::Run values = experiment.run(run);
    const StoredRun stored{run, experiment.scenarios[values.scenario], values.seed, values.values,
                           row};
    base::Diagnostics problems = folder.add(stored);
    if (options.rows && problems.empty()) {
      printRow(stored);
    }
    show();
    return problems;
  };
  job.wantsStop = wasInterrupted;
  return runBatch(job);
}

int batchCommand(const BatchOptions& options, const Invocation& given) {
  base::Result<Experiment> experiment = readExperiment(options.experiment);
  requireFine(experiment.diagnostics());
  experiment->allowCode = options.allowCode;
  ExperimentRunner runner(*experiment, (fs::path(options.output) / "runs").string(), loadMapImage);
  requireFine(runner.check());
  if (!options.script.empty()) {
    return printScript(options, given);
  }
  base::Result<Study> study =
      studyOf(*experiment, runner.inputs(), shardOf(options.shard).value_or(Shard()));
  requireFine(study.diagnostics());
  study->timeLimit = options.timeLimit;
  const Earlier earlier = options.retryFailed ? Earlier::Retry
                          : options.resume    ? Earlier::Resume
                          : options.force     ? Earlier::Replace
                                              : Earlier::Refuse;
  base::Result<std::unique_ptr<BatchFolder>> folder =
      BatchFolder::open(options.output, *study, earlier);
  requireFine(folder.diagnostics());
  catchInterrupts();
  base::Diagnostics troubles = makeRuns(*experiment, runner, **folder, options, given.quiet);
  base::append(troubles, (*folder)->finish());
  Invocation said = given;
  said.quiet = given.quiet || options.rows;
  said.json = given.json && !options.rows;
  return reportBatch(**folder, troubles, said);
}

}  // namespace

void addBatch(CommandRegistry& commands) {
  const auto [command, options] =
      commands.add("batch", "Many runs: scenarios x values x seeds", batchCommand);
  command.add_option("experiment", options.experiment, "Experiment file")->required();
  addOutputFolder(command, options.output, "Folder for the results").required();
  command.add_option("--jobs", options.jobs, "Processes at a time (number of cores)")
      ->check(CLI::Range(1, 1024));
  addAllowCode(command, options.allowCode);
  CLI::Option* const resume =
      command.add_flag("--resume", options.resume,
                       "Go on with a batch that was interrupted; begin it if there is none");
  CLI::Option* const retry = command.add_flag(
      "--retry-failed", options.retryFailed,
      "As --resume, and repeat all failed runs (--resume alone repeats those that were killed or "
      "ran out of memory)");
  CLI::Option* const force =
      command
          .add_flag("--force", options.force,
                    "Begin anew where a batch was interrupted; replace files of others")
          ->excludes(resume, retry);
  CLI::Option* const rows =
      command.add_flag("--rows", options.rows,
                       "Print how many runs there are, then each finished one, as lines of JSON");
  CLI::Option* const shard =
      command.add_option("--shard", options.shard, "K/N: part K of N of the runs; see merge")
          ->check(shardProblem);
  command
      .add_option("--time-limit", options.timeLimit,
                  "Seconds of wall time after which a run has failed (--resume: as before)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--script", options.script,
                  "Run nothing: print a script that splits the study by slurm or parallel")
      ->check(oneOf({"slurm", "parallel"}))
      ->excludes(resume, force, rows, shard);  // the script has its own
  command.add_option("--chunks", options.chunks, "Shards that the script makes (20)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}));
}

}  // namespace app
