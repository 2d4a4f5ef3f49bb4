#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/run/Design.h"
#include "app/run/ExperimentValues.h"
#include "app/run/RunSpec.h"
#include "app/run/StoppingRule.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// What `batch` runs: scenarios x values x seeds.
struct Experiment {
  /// The runs whose folders are kept; unsuccessful are failed runs and those whose robot failed.
  enum class Record { Metrics, Failed, Unsuccessful, All };
  static constexpr const char* kRecordNames[] = {"metrics", "failed", "unsuccessful", "all"};

  std::string path, text;                  // of its file
  std::vector<std::string> scenarios;      // as written: relative files or names of shipped ones
  std::vector<std::string> scenarioPaths;  // where they lie
  std::vector<long long> seeds;
  RunSpec common;                // options of all runs
  std::optional<Design> design;  // of the values with the form `between`; for sensitivity analysis
                                 // also of `uniform`, which then has the form `between`
  std::vector<ExperimentValue> values;
  Record record = Record::Metrics;
  std::optional<StoppingRule> until;  // fewer seeds may be enough
  bool treeCoverage = false;          // whether the coverage of behaviour trees is kept
  bool allowCode = false;             // given by the user who starts the batch, never in the file

  /// Run `index`: scenarios outermost, then dimensions among the values in their order, seeds
  /// innermost. All coordinates of the design are one dimension, at the place of the first one.
  struct Run {
    std::size_t scenario = 0;
    long long seed = 1;
    std::vector<std::string> values;  // one per path, drawn ones too
  };
  /// For each path of values, the number of its values that are combined with those of all other
  /// paths; 1 for draws and for coordinates of the design other than the first.
  std::vector<std::size_t> dimensions() const;
  std::size_t runCount() const;
  Run run(std::size_t index) const;

  RunSpec specOf(std::size_t index) const;
};

/// Every problem with file:line:column; unknown keys are errors.
base::Result<Experiment> readExperiment(const std::string& path);
/// The same of a text that need not be in the file yet; its scenarios are looked for beside it.
base::Result<Experiment> parseExperiment(std::string text, const std::string& path);
/// Reads an experiment for a sensitivity analysis: its design becomes that of the request. Error
/// also: no value has a range.
base::Result<Experiment> readSensitivityExperiment(const std::string& path,
                                                   const SensitivityRequest& request);

/// Scenarios of an experiment with their numbers in it.
using NumberedScenarios = std::vector<std::pair<std::size_t, sim2d::Scenario>>;

/// Checks the values of an experiment before anything runs; problems have their locations, without
/// the file. Errors: a value is set twice, not accepted by one of the scenarios, or an error of the
/// runs that have it; all texts of lists are tried, of a range and of draws some. If there are no
/// errors and `areAllKnown`: warnings of runs that are equal, because the seed has no effect in
/// what was tried, or because a text is listed twice. `scenarios`: those that could be read;
/// `root`: of the experiment file.
base::Diagnostics checkValues(const Experiment& experiment, NumberedScenarios scenarios,
                              const base::YamlNode& root, bool areAllKnown);

}  // namespace app
