#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "app/run/ResultRow.h"

namespace app {

/// What a batch does with its runs, and how.
struct BatchJob {
  std::vector<std::size_t> runs;  // their numbers, in the order in which they begin
  int jobs = 1;                   // worker processes at a time
  double timeLimit = std::numeric_limits<double>::infinity();  // of one run [s], by the wall clock
  std::size_t runsPerWorker = 1000;  // then another takes its place: memory stays bounded
  std::size_t mostGrowth = std::size_t{512}
                           << 20U;  // idem, memory beyond that of its first run [B]
  /// Executes a run in a worker. Errors: its files cannot be written, which ends the batch. `met`
  /// receives the files that the run uses as soon as they are known: the row of a run that crashes
  /// or takes too long lists them.
  using Met = std::function<void(const std::vector<InputHash>& files)>;
  std::function<base::Result<ResultRow>(std::size_t run, const Met& met)> make;
  /// Here: takes its row, as soon as it is there. Errors end the batch.
  std::function<base::Diagnostics(std::size_t run, const ResultRow& row)> take;
  std::function<bool()> wantsStop;  // asked often
};

/// Makes the runs in processes that are started once and make many (Box2D keeps process-wide
/// statics, so worlds in parallel are processes). A process that crashes or is killed is replaced
/// and its run started again, once. A run whose process ends twice has failed, by the machine if it
/// was then killed from outside (ResultRow::failedBy). Returns when all have ended, or `wantsStop`
/// says so; what was not finished then was never begun. One thread.
base::Diagnostics runBatch(const BatchJob& job);

}  // namespace app
