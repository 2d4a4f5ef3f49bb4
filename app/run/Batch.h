#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/Experiment.h"
#include "app/run/ResultColumns.h"
#include "sim2d/map/MapReader.h"

namespace app {

/// What is known of one run of a batch after its process has ended.
struct BatchRow {
  bool ok = false;
  std::string reason;     // why it ended, or failed
  std::string simulated;  // [s], as text; empty when not known
  ResultValues values;
};
/// By run; nothing = not run, the batch was interrupted before.
using BatchRows = std::vector<std::optional<BatchRow>>;

/// Scenarios that no run of the experiment could use, and values that no scenario takes.
base::Diagnostics checkExperiment(const Experiment& experiment, const sim2d::ImageLoader& loader);

struct BatchJob {
  std::string runsFolder;  // each run writes into <runsFolder>/<run>; which of them stay is up to
                           // the experiment
  int jobs = 1;            // processes at a time
  std::function<bool()> wantsStop;  // this and the next are always called
  std::function<void(std::size_t finished)> onProgress;
};

/// What lies where the runs will write and is not of an earlier batch.
base::Diagnostics checkRunFolders(const Experiment& experiment, const std::string& runsFolder);

/// Runs the runs of an experiment as child processes of this program (Box2D keeps process-wide
/// statics, so worlds in parallel are processes). Returns when all have ended, or `wantsStop` says
/// so: running children are ended then. Rows are in the order of the runs, whatever the order they
/// end in.
BatchRows runBatch(const Experiment& experiment, const BatchJob& job);

struct BatchCount {
  std::size_t finished = 0, failed = 0;
};
BatchCount countOf(const BatchRows& rows);

/// results.csv; nothing of it depends on the number of jobs or the clock.
std::string resultsCsv(const Experiment& experiment, const BatchRows& rows);

}  // namespace app
