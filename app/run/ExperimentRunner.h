#pragma once

#include <string>
#include <vector>

#include "app/run/Experiment.h"
#include "app/run/KnownFiles.h"
#include "app/run/ResultRow.h"
#include "app/run/SeenFiles.h"

namespace app {

/// Makes the runs of an experiment, one after the other, in this process. What they have in common
/// is read and worked out once; no run changes anything of it. One thread.
class ExperimentRunner {
 public:
  /// `runsFolder`: folders of runs that are kept lie in it, <runsFolder>/<run>. `loader` reads map
  /// images other than PGM. The experiment must outlive this.
  ExperimentRunner(const Experiment& experiment, std::string runsFolder, sim2d::ImageLoader loader)
      : experiment_(experiment), runsFolder_(std::move(runsFolder)), files_(std::move(loader)) {}

  /// Scenarios that no run could use, and values that no scenario takes.
  base::Diagnostics check();
  /// Files that the runs read or start beside the experiment, each once; known after check().
  const std::vector<InputHash>& inputs() const { return inputs_.hashes(); }
  /// Errors: files of a run that are others by now, so nobody knows which of them it has read.
  base::Diagnostics changedInputs(std::size_t index);

  /// Errors: files of the run could not be written. A run that fails is a row.
  base::Result<ResultRow> run(std::size_t index);

 private:
  std::size_t runsPerScenario() const {
    return experiment_.runCount() / experiment_.scenarios.size();
  }
  base::Diagnostics checkScenario(std::size_t scenario);
  std::string folderOf(std::size_t run) const;
  bool isKept(const ResultRow& row) const;
  base::Diagnostics keep(std::size_t index, FinishedRun& run, RunWriter& writer,
                         const Bundle& bundle, OutputFolder& output);

  const Experiment& experiment_;
  const std::string runsFolder_;
  KnownFiles files_;
  SeenFiles inputs_;
  std::vector<std::vector<std::size_t>> inputsOfScenario_;
};

}  // namespace app
