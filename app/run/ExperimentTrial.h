#pragma once

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/run/Experiment.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace app {

/// What is said, wherever.
using ProblemKey = std::pair<std::string_view, decltype(base::Diagnostic::values)>;

/// The values of an experiment in one of its scenarios, before anything runs: each in the place of
/// the first one of its path, beside the options of all runs and the first values of the other
/// paths, as one of the runs has it. No map is read and no world made. The experiment must outlive
/// this and stay as it is.
class ExperimentTrial {
 public:
  /// `number`: of the scenario in the experiment; `written`: as its file has it.
  ExperimentTrial(const Experiment& experiment, std::size_t number, sim2d::Scenario written);

  /// What comes with a text, without places.
  struct Outcome {
    base::Diagnostics own;     // of putting it there
    base::Diagnostics beside;  // errors of the whole, which the run would have
  };
  /// `value`: its number in the experiment.
  Outcome outcomeOf(std::size_t value, const std::string& text);
  /// The text that the first run has there.
  const std::string& firstText(std::size_t value) const { return firstTexts_[value]; }

  /// Whether runs differ by their seeds with anything that has been tried.
  bool dependsOnSeed() const { return dependsOnSeed_; }
  std::size_t number() const { return number_; }
  const sim2d::Scenario& scenario() const { return written_; }

 private:
  base::Diagnostics put(sim2d::Scenario& scenario, std::size_t value,
                        const std::string& text) const;
  base::Diagnostics meaningErrors(const sim2d::Scenario& scenario) const;
  void putFirstTexts();
  void findWhatBrings(const std::set<ProblemKey>& errors);
  const sim2d::Scenario& stageBefore(std::size_t value);
  sim2d::Scenario othersWith(std::size_t value, const std::string& text, sim2d::Scenario stage,
                             base::Diagnostics& errors) const;

  const Experiment& experiment_;
  const std::size_t number_;
  const sim2d::KnownNames names_;
  std::vector<std::string> firstTexts_;
  sim2d::Scenario written_, first_;  // without and with the first texts of all paths
  sim2d::Scenario stage_;            // with those of the first `stageOf_` paths
  std::size_t stageOf_ = 0;
  std::vector<base::Diagnostics> own_;      // from setting the first text of each path
  std::vector<base::Diagnostics> brought_;  // errors of the first run, by the path that brings them
  std::set<ProblemKey> usual_;              // that are there whatever is tried
  bool dependsOnSeed_ = false;
};

}  // namespace app
