#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/run/BundleReader.h"
#include "app/run/Experiment.h"
#include "app/run/ManifestFiles.h"
#include "app/run/PlannerFiles.h"
#include "app/run/ResultRow.h"

namespace app {

/// Executes the runs of an experiment sequentially in this process. Shared data is read and
/// computed once and not changed by runs. One thread.
class ExperimentRunner {
 public:
  /// `runsFolder`: kept run folders are <runsFolder>/<run>. `loader` reads map images other than
  /// PGM. The experiment must outlive this.
  ExperimentRunner(const Experiment& experiment, std::string runsFolder, sim2d::ImageLoader loader)
      : experiment_(experiment), runsFolder_(std::move(runsFolder)), reader_(std::move(loader)) {}

  /// The files that check() reads: those of the first run of each scenario only, or also those of
  /// the other options of robots.
  enum class Checked { FirstRuns, AllOptions };
  /// Reports scenarios that no run could use, values that no scenario accepts, options of robots
  /// that no run could use (at their places in the experiment) and, if external code is not
  /// allowed, programs that would have to be started.
  base::Diagnostics check(base::Severity codeSeverity = base::Severity::Error,
                          Checked checked = Checked::AllOptions);
  /// The warnings of `check` for the files of the first run of each scenario, each once. Problems
  /// that are errors are those of check().
  base::Diagnostics warnings();
  /// Files that the first runs of the scenarios use, each once; known after check().
  const std::vector<InputHash>& inputs() const { return reader_.inputs(); }

  /// Error: the files of the run could not be written. A failed run is a row. Its inputs are the
  /// files as first read by this process, and a second entry for those that have changed by the
  /// end. `reportInputs` receives them before the run starts.
  base::Result<ResultRow> run(
      std::size_t index,
      const std::function<void(const std::vector<InputHash>&)>& reportInputs = {});

 private:
  base::Diagnostics errorsOfFirstRun(std::size_t scenario);
  base::Result<ResultRow> runWithFiles(std::size_t index, const Bundle& bundle);
  std::string folderOf(std::size_t run) const;
  bool isKept(const ResultRow& row) const;
  base::Diagnostics writeFiles(std::size_t index, FinishedRun& run, RunWriter& writer,
                               const Bundle& bundle, OutputFolder& output);

  const Experiment& experiment_;
  const std::string runsFolder_;
  BundleReader reader_;
};

/// External code that runs in the scenario with this number would start, for all values of the
/// experiment. Reads the file and starts nothing; errors are those of ExperimentRunner::check.
std::vector<ExternalCode> externalCodeOf(const Experiment& experiment, std::size_t scenario);

/// Files that a run reads, and external code that it starts.
std::vector<std::string> inputFilesOf(const Bundle& bundle);

}  // namespace app
