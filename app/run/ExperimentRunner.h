#pragma once

#include <functional>
#include <map>
#include <memory>
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
      : experiment_(experiment),
        runsFolder_(std::move(runsFolder)),
        loader_(std::move(loader)),
        files_(std::make_unique<KnownFiles>(loader_)) {}

  /// Reports scenarios that no run could use, values that no scenario accepts and, where code is
  /// not allowed, programs that would have to be started.
  base::Diagnostics check(base::Severity ofForeignCode = base::Severity::Error);
  /// Files that the first runs of the scenarios use, each once; known after check().
  const std::vector<InputHash>& inputs() const { return seen_.all(); }

  /// Errors: files of the run could not be written. A run that fails is a row. Its inputs are the
  /// files as this process has met them first, and once more those that are others by the end.
  /// `met` takes them before the run begins.
  base::Result<ResultRow> run(std::size_t index,
                              const std::function<void(const std::vector<InputHash>&)>& met = {});

 private:
  /// Numbers of files that were seen.
  using Used = std::vector<std::size_t>;

  base::Diagnostics checkScenario(std::size_t scenario, base::Severity ofForeignCode);
  Bundle read(std::size_t index, const RunSettings& settings, Used& used);
  const Used& filesOf(const Bundle& bundle);
  base::Result<ResultRow> make(std::size_t index, const Bundle& bundle);
  std::string folderOf(std::size_t run) const;
  bool isKept(const ResultRow& row) const;
  base::Diagnostics keep(std::size_t index, FinishedRun& run, RunWriter& writer,
                         const Bundle& bundle, OutputFolder& output);

  const Experiment& experiment_;
  const std::string runsFolder_;
  const sim2d::ImageLoader loader_;
  std::unique_ptr<KnownFiles> files_;
  SeenFiles seen_;
  std::map<std::vector<std::string>, Used> usedBy_;  // what bundles name: all that they read
};

}  // namespace app
