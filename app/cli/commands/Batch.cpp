#include "app/run/Batch.h"

#include <filesystem>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/BatchRuns.h"
#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/BatchFolder.h"
#include "app/run/DataPaths.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct BatchOptions {
  std::string experiment;
  std::string output;
  int jobs = processorCount();
  bool allowCode = false, resume = false, retryFailed = false, force = false;
  bool rows = false;       // print rows to standard output
  std::string shard;       // "K/N"; empty = all runs
  double timeLimit = 0.0;  // [s]; 0 = none
  std::string script;      // "slurm", "parallel"; empty: execute the runs
  std::size_t chunks = 20;
};

namespace fs = std::filesystem;

/// nullopt: invalid text.
std::optional<Shard> shardOf(const std::string& text) {
  constexpr long long kMaxShards = 1'000'000;
  const std::vector<std::string> parts = base::split(text, '/');
  const auto number = base::parseInt(parts.front()), count = base::parseInt(parts.back());
  const bool isShard = parts.size() == 2 && number && count && *number >= 1 && *number <= *count &&
                       *count <= kMaxShards;
  return isShard ? std::optional(
                       Shard{static_cast<std::size_t>(*number), static_cast<std::size_t>(*count)})
                 : std::nullopt;
}

std::string shardProblem(const std::string& text) {
  return shardOf(text) ? std::string() : "expected K/N with 1 <= K <= N, not '" + text + "'";
}

int printScript(const BatchOptions& options, const Invocation& given) {
  const ClusterJob job{programPath(),
                       absolutePath(options.experiment),
                       absolutePath(options.output),
                       options.chunks,
                       options.allowCode,
                       options.retryFailed,
                       options.timeLimit};
  const std::string script = options.script == "slurm" ? slurmScript(job) : parallelScript(job);
  print(given.json
            ? base::jsonText(nlohmann::ordered_json{{"script", options.script}, {"text", script}}) +
                  "\n"
            : script);
  return ExitFine;
}

int batchCommand(const BatchOptions& options, const Invocation& given) {
  base::Result<Experiment> experiment = readExperiment(options.experiment);
  requireFine(experiment.diagnostics());
  experiment->allowCode = options.allowCode;
  if (experiment->until && (!options.shard.empty() || !options.script.empty())) {
    requireFine({base::error("batch.until-shards", {}, experiment->path)});
  }
  ExperimentRunner runner(*experiment, (fs::path(options.output) / "runs").string(), loadMapImage);
  requireFine(runner.check());
  if (!options.script.empty()) {
    return printScript(options, given);
  }
  base::Result<Study> study =
      studyOf(*experiment, runner.inputs(), shardOf(options.shard).value_or(Shard()));
  requireFine(study.diagnostics());
  study->timeLimit = options.timeLimit;
  const ExistingBatch earlier = options.retryFailed ? ExistingBatch::Retry
                                : options.resume    ? ExistingBatch::Resume
                                : options.force     ? ExistingBatch::Replace
                                                    : ExistingBatch::Refuse;
  base::Result<std::unique_ptr<BatchFolder>> folder =
      BatchFolder::open(options.output, *study, earlier);
  requireFine(folder.diagnostics());
  catchInterrupts();
  base::Diagnostics problems =
      executeRuns(*experiment, runner, **folder, {options.jobs, options.rows, given.quiet});
  base::append(problems, (*folder)->finish());
  const ResultStore& store = (*folder)->store();
  if (problems.empty() && experiment->until && store.isComplete() &&
      store.study().enoughSeeds == 0) {
    problems.push_back(base::warning("batch.until-open", {}, experiment->path));
    printDiagnostics(problems);
  }
  Invocation shown = given;
  shown.quiet = given.quiet || options.rows;
  shown.json = given.json && !options.rows;
  return reportBatch(**folder, problems, shown);
}

}  // namespace

void addBatch(CommandRegistry& commands) {
  const auto [command, options] = commands.add(
      "batch", "Run an experiment: scenarios x parameter values x seeds", batchCommand);
  command.add_option("experiment", options.experiment, "Experiment file")->required();
  addOutputFolder(command, options.output, "Output folder").required();
  addJobs(command, options.jobs);
  addAllowCode(command, options.allowCode);
  CLI::Option* const resume = command.add_flag(
      "--resume", options.resume, "Continue an interrupted batch, or start it if there is none");
  CLI::Option* const retry = command.add_flag(
      "--retry-failed", options.retryFailed,
      "Like --resume, and repeat all failed runs (--resume alone repeats runs that were killed or "
      "ran out of memory)");
  CLI::Option* const force =
      command
          .add_flag("--force", options.force,
                    "Restart an interrupted batch from the beginning; overwrite files that "
                    "hunavsim did not create")
          ->excludes(resume, retry);
  CLI::Option* const rows =
      command.add_flag("--rows", options.rows,
                       "Print the number of runs, then each finished run, as one JSON object per "
                       "line");
  CLI::Option* const shard =
      command
          .add_option("--shard", options.shard,
                      "K/N: execute part K of N of the runs; join the parts with merge")
          ->check(shardProblem);
  command
      .add_option("--time-limit", options.timeLimit,
                  "Wall time after which a run counts as failed [s] (default with --resume: "
                  "unchanged)")
      ->check(CLI::PositiveNumber);
  command
      .add_option("--script", options.script,
                  "Print a script that distributes the runs with slurm or parallel; execute "
                  "nothing")
      ->check(oneOf({"slurm", "parallel"}))
      ->excludes(resume, force, rows, shard);  // the script sets them itself
  command.add_option("--chunks", options.chunks, "Number of shards in the script (default: 20)")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100000}));
  commands.addExamples(command, {{"hunavsim batch study.yaml -o results -j 4",
                                  "Run a study in four processes", "your experiment"},
                                 {"hunavsim batch study.yaml -o results --resume",
                                  "Continue it after an interruption", "your experiment"},
                                 {"hunavsim batch study.yaml -o part2 --shard 2/8",
                                  "Run one of eight parts on another machine", "your experiment"}});
}

}  // namespace app
