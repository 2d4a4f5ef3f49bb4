#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "app/run/Experiment.h"
#include "app/studies/RunPool.h"
#include "sim2d/base/Rng.h"

namespace app {

/// A sequence of random numbers, a function of its seed only.
class SearchRandom {
 public:
  explicit SearchRandom(std::uint64_t seed) : seed_(seed) {}
  double uniform();                      // [0, 1)
  std::size_t below(std::size_t count);  // 0 … count - 1; count > 0
  bool chance(double probability) { return uniform() < probability; }

 private:
  std::uint64_t seed_;
  std::uint64_t drawn_ = 0;
};

/// One point of a search space.
struct Candidate {
  std::vector<double> point;         // of the continuous values, each in [0, 1]
  std::vector<std::size_t> choices;  // of the categories
};

/// What a search varies: an experiment's values, scenarios and seeds. `range`, `between`, `uniform`
/// and `normal` are continuous between their ends (`range` on its steps), lists and `choice` are
/// categories. The first two categories are the scenarios and the seeds.
class SearchSpace {
 public:
  /// What ends runs unless the experiment specifies it: contacts with anything and a robot without
  /// progress (see requestOf), or only what the scenario sets.
  enum class RunsEnd { AtFailures, AsInScenario };

  /// The experiment must outlive this.
  explicit SearchSpace(const Experiment& experiment, RunsEnd runsEnd = RunsEnd::AtFailures);

  std::size_t dimensions() const { return continuous_.size(); }
  const std::vector<std::size_t>& optionCounts() const { return optionCounts_; }  // of categories
  /// The number of combinations of categories, at most 1e9.
  std::size_t combinations() const;

  /// The text of each value of the experiment, in its order. Continuous values are rounded to a
  /// ten-thousandth of their range.
  std::vector<std::string> textsOf(const Candidate& candidate) const;
  /// The run of a candidate. With RunsEnd::AtFailures, runs stop at contacts with anything
  /// (`stop_on_collision: any`), and when a robot has made no progress for 20 s or the time that
  /// the scenario sets (`stuck_after`), unless the experiment says otherwise.
  RunRequest requestOf(const Candidate& candidate) const;
  long long seedOf(const Candidate& candidate) const;
  std::size_t scenarioOf(const Candidate& candidate) const { return candidate.choices[0]; }
  const std::string& scenarioName(const Candidate& candidate) const {  // as the experiment has it
    return experiment_.scenarios[scenarioOf(candidate)];
  }

  std::vector<std::size_t> randomChoices(SearchRandom& random) const;
  /// So many choices in which the options of each category are equally frequent: a sequence of
  /// random permutations per category.
  std::vector<std::vector<std::size_t>> balancedChoices(std::size_t count,
                                                        SearchRandom& random) const;
  /// Another option of one random category that has several; nothing if there is none.
  void mutate(std::vector<std::size_t>& choices, SearchRandom& random) const;

 private:
  std::string textOf(const ExperimentValue& value, double place) const;

  const Experiment& experiment_;
  RunsEnd runsEnd_;
  std::vector<std::size_t> continuous_;    // indices of values
  std::vector<std::size_t> categories_;    // indices of values
  std::vector<std::size_t> optionCounts_;  // scenarios, seeds, then those of categories_
  std::vector<bool> setsStuckAfter_;       // by scenario
};

}  // namespace app
