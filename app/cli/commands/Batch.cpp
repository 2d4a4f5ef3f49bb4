#include "app/run/Batch.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <thread>

#include <CLI/CLI.hpp>

#include "app/cli/CommandRegistry.h"
#include "app/cli/Console.h"
#include "app/run/RunFolder.h"
#include "editor/document/QtImageLoader.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

struct BatchOptions {
  std::string experiment;
  std::string output;
  int jobs = 0;  // 0 = number of cores
  bool allowCode = false;
};

namespace fs = std::filesystem;

std::string progressText(std::size_t finished, std::size_t total, double seconds) {
  std::string text = std::to_string(finished) + " / " + std::to_string(total) + " runs";
  if (finished > 0 && seconds > 0.0) {
    const double rate = static_cast<double>(finished) / seconds;
    text += ", " + base::formatDecimals(std::round(rate * 10.0) / 10.0, 1) + " runs/s, " +
            durationText(static_cast<double>(total - finished) / rate) + " left";
  }
  return text;
}

int report(const Experiment& experiment, const BatchRows& rows, const BatchOptions& options,
           const Invocation& given) {
  const BatchCount count = countOf(rows);
  const bool complete = count.finished == rows.size();
  const std::string manifest = batchManifest(experiment, rows);
  const fs::path folder = options.output;
  const std::string results = (folder / "results.csv").string();
  base::Diagnostics problems = base::writeFileAtomically(results, resultsCsv(experiment, rows));
  base::append(problems, base::writeFileAtomically((folder / "manifest.json").string(), manifest));
  requireFine(problems);
  if (given.json) {
    print(manifest);
  } else if (!given.quiet) {
    printLine(std::to_string(count.finished) + " of " + std::to_string(rows.size()) +
              " runs finished, " + std::to_string(count.failed) + " failed: " + results);
  }
  if (!complete) {
    printError("interrupted: the finished runs are kept");
  }
  return complete && count.failed == 0 ? ExitFine : ExitRunFailed;
}

int batchCommand(const BatchOptions& options, const Invocation& given) {
  base::Result<Experiment> experiment = readExperiment(options.experiment);
  requireFine(experiment.diagnostics());
  experiment->allowCode = options.allowCode;
  base::Diagnostics problems = checkExperiment(*experiment, editor::loadMapImage);
  if (!base::hasErrors(problems)) {  // else nothing will be written
    base::append(problems, checkWritableFolder(options.output));
  }
  const std::string runs = (fs::path(options.output) / "runs").string();
  base::append(problems, checkRunFolders(*experiment, runs));
  requireFine(problems);
  // From here on the folder is that of a batch, also when this one is cut short.
  requireFine(
      base::writeFileAtomically((fs::path(options.output) / "manifest.json").string(),
                                batchManifest(*experiment, BatchRows(experiment->runCount()))));
  catchInterrupts();
  const int cores = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const auto start = std::chrono::steady_clock::now();
  BatchRows rows;
  {
    Progress progress(given.quiet);
    const std::size_t total = experiment->runCount();
    progress.show(progressText(0, total, 0.0));
    BatchJob job;
    job.runsFolder = runs;
    job.jobs = options.jobs > 0 ? options.jobs : cores;
    job.wantsStop = wasInterrupted;
    job.onProgress = [&](std::size_t finished) {
      const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
      progress.show(progressText(finished, total, elapsed.count()));
    };
    rows = runBatch(*experiment, job);
  }
  std::error_code ignored;  // the folder stays when runs are kept in it
  fs::remove(runs, ignored);
  return report(*experiment, rows, options, given);
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
}

}  // namespace app
