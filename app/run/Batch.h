#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "app/run/ResultRow.h"

namespace app {

/// The runs of a batch and how to execute them.
struct BatchJob {
  std::vector<std::size_t> runs;                               // indices, in starting order
  int jobs = 1;                                                // maximum number of worker processes
  double timeLimit = std::numeric_limits<double>::infinity();  // of one run [s], wall-clock time
  std::size_t runsPerWorker = 1000;  // a worker is then replaced, which bounds its memory
  std::size_t maxGrowth = std::size_t{512}
                          << 20U;  // likewise, for memory growth after its first run [B]
  /// Executes a run in a worker. Error: its files cannot be written, which ends the batch.
  /// `reportInputs` receives the input files as soon as they are known, for the row of a run that
  /// crashes or exceeds its time limit.
  using ReportInputs = std::function<void(const std::vector<InputHash>& files)>;
  std::function<base::Result<ResultRow>(std::size_t run, const ReportInputs& reportInputs)> execute;
  /// Receives each row in this process as soon as it exists. An error ends the batch.
  std::function<base::Diagnostics(std::size_t run, const ResultRow& row)> storeRow;
  std::function<bool()> wantsStop;  // called often
};

/// Executes the runs in worker processes, each of which executes many (Box2D has process-wide
/// statics, so parallel worlds need processes). A worker that crashes or is killed is replaced and
/// its run repeated once; a run whose worker ends twice has failed (ResultRow::failedBy). Returns
/// when all runs have ended or `wantsStop` returns true; unfinished runs leave no result. One
/// thread.
base::Diagnostics runBatch(const BatchJob& job);

}  // namespace app
