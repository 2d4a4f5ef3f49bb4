#pragma once

#include "app/run/Batch.h"
#include "app/run/BatchFolder.h"
#include "app/run/ExperimentRunner.h"

namespace app {

struct BatchRunOptions {
  int jobs = processorCount();
  bool rows = false;   // print rows to standard output
  bool quiet = false;  // no progress
};

/// Executes the missing runs of the folder in worker processes, with progress on standard error;
/// Ctrl-C ends them. With a stopping rule (Experiment::until), the batch is complete as soon as it
/// is met. Returns errors that ended them early.
base::Diagnostics executeRuns(const Experiment& experiment, ExperimentRunner& runner,
                              BatchFolder& folder, const BatchRunOptions& options);

}  // namespace app
