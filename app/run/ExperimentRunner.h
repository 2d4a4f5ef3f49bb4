#pragma once

#include <string>
#include <vector>

#include "app/run/Experiment.h"
#include "app/run/KnownFiles.h"
#include "app/run/PlannerFiles.h"
#include "app/run/ResultRow.h"

namespace app {

/// Code of others that runs in a scenario would start: with the first values, which it has, and
/// with each other value beside them.
std::vector<ForeignCode> foreignCodeOf(const Experiment& experiment, const sim2d::Scenario& first);

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
  /// Files that the runs read beside the experiment, each once; known after check().
  const std::vector<std::string>& inputs() const { return inputs_; }

  /// Errors: files of the run could not be written. A run that fails is a row.
  base::Result<ResultRow> run(std::size_t index);

 private:
  base::Diagnostics checkScenario(std::size_t scenario);
  std::string folderOf(std::size_t run) const;
  bool isKept(const ResultRow& row) const;
  base::Diagnostics keep(std::size_t index, FinishedRun& run, RunWriter& writer,
                         const Bundle& bundle, OutputFolder& output);

  const Experiment& experiment_;
  const std::string runsFolder_;
  KnownFiles files_;
  std::vector<std::string> inputs_;
};

}  // namespace app
