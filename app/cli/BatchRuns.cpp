#include "app/cli/BatchRuns.h"

#include <algorithm>

#include "app/cli/Console.h"
#include "app/cli/RunProgress.h"
#include "app/run/Batch.h"

namespace app {

namespace {

/// Executes the missing runs; with a stopping rule, those of more and more seeds until it is met.
base::Diagnostics executeUntilEnough(const Experiment& experiment, BatchFolder& folder,
                                     BatchJob& job, std::optional<StoppingCheck>& stopping) {
  const std::size_t seeds = experiment.seeds.size();
  for (const std::size_t look : stopping ? stopping->looks() : std::vector<std::size_t>{seeds}) {
    job.runs = folder.missing();
    job.runs.erase(std::remove_if(job.runs.begin(), job.runs.end(),
                                  [&](std::size_t run) { return run % seeds >= look; }),
                   job.runs.end());
    base::Diagnostics problems = runBatch(job);
    if (!problems.empty() || job.wantsStop()) {
      return problems;
    }
    if (stopping && stopping->isEnough(look)) {
      return folder.setEnoughSeeds(look);
    }
  }
  return {};
}

}  // namespace

base::Diagnostics executeRuns(const Experiment& experiment, ExperimentRunner& runner,
                              BatchFolder& folder, const BatchRunOptions& options) {
  const ResultStore& store = folder.store();
  const std::size_t total = store.study().shard.runCount(store.study().runs);
  const std::size_t before = store.finished();
  RunProgress progress(options.quiet, total, experiment.until.has_value());
  const auto printRow = [&](const StoredRun& run) { print(rowJson(store.study(), run) + "\n"); };
  std::optional<StoppingCheck> stopping;
  if (experiment.until) {
    stopping.emplace(experiment);
    base::Diagnostics unreadable =
        store.forEach([&](const StoredRun& run) { stopping->add(run.run, run.row); });
    if (!unreadable.empty()) {
      return unreadable;
    }
  }
  if (options.rows) {
    print(headerJson(store) + "\n");
    base::Diagnostics unreadable = store.forEach(printRow);
    if (!unreadable.empty()) {
      return unreadable;
    }
  }
  const auto show = [&] { progress.show(store.finished(), store.finished() - before); };
  show();
  BatchJob job;
  job.jobs = options.jobs;
  const double limit = store.study().timeLimit;
  job.timeLimit = limit > 0.0 ? limit : job.timeLimit;
  job.execute = [&](std::size_t run, const BatchJob::ReportInputs& reportInputs) {
    return runner.run(run, reportInputs);
  };
  job.storeRow = [&](std::size_t run, const ResultRow& row) {
    const Experiment::Run values = experiment.run(run);
    const StoredRun stored{run, experiment.scenarios[values.scenario], values.seed, values.values,
                           row};
    base::Diagnostics problems = folder.add(stored);
    if (stopping) {
      stopping->add(run, row);
    }
    if (options.rows && problems.empty()) {
      printRow(stored);
    }
    show();
    return problems;
  };
  job.wantsStop = wasInterrupted;
  return executeUntilEnough(experiment, folder, job, stopping);
}

}  // namespace app
