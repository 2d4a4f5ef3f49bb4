#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studies/CmaEs.h"
#include "app/studies/Tune.h"

namespace app {

constexpr double kLeastImprovement = 0.01;  // of the score, to choose a candidate

/// Numbers of runs of a candidate: run k has scenario k mod scenarios.
using TuneRuns = std::vector<std::size_t>;

/// The state of tune(). Private to this folder: use tune().
class Tuner {
 public:
  Tuner(const TuneOptions& options, const TuneSubject& subject, RunPool& pool,
        const TuneProgress& showStage)
      : options_(options),
        subject_(subject),
        pool_(pool),
        showStage_(showStage),
        present_(subject.present()) {}

  base::Result<TuneResult> run();

 private:
  // Tune.cpp: common to all stages.
  /// Runs per candidate in a generation. Run k has scenario k mod scenarios; each generation has
  /// other runs, so that the search does not adapt to the seeds.
  std::size_t searchRuns() const {
    return options_.scenarios.size() * static_cast<std::size_t>(options_.seeds);
  }
  /// Runs of the final comparisons at most, with this many runs per candidate.
  std::size_t reserve(std::size_t runs) const;
  /// Runs per candidate in the final comparisons.
  std::size_t finalCount() const;
  /// The runs of a generation, or of the final comparisons after the last one.
  TuneRuns runsOf(int generation, std::size_t count) const;
  TuneRuns finalRuns() const { return runsOf(result_.generations, finalCount()); }
  std::size_t heldOutRuns() const {
    return options_.heldOut.size() * static_cast<std::size_t>(options_.heldOutSeeds);
  }
  void show(const std::string& stage) const;
  /// Executes these runs of these values, those that are not yet known.
  base::Diagnostics measure(const std::vector<TunedValues>& which, const TuneRuns& runs);
  TuneOutcomes outcomesOf(const TunedValues& values, const TuneRuns& runs) const;
  TuneScore scoreOf(const TunedValues& values, const TuneRuns& runs) const;
  TuneRuns knownRuns(const TunedValues& values) const;
  base::Diagnostics start();
  /// All tried values with their scores, each once, and the front of the complete ones.
  void listCandidates();

  // TuneSearch.cpp: candidates.
  TunedValues valuesAt(const Point& point) const;
  base::Diagnostics search();
  /// Successive halving of the candidates of a generation.
  base::Diagnostics searchGeneration(RestartedCmaEs& cma);
  bool isComplete(const TunedValues& values) const {
    return outcomes_.at(values).size() >= searchRuns();
  }
  /// The last means of the distribution, which average over many noisy scores, and the complete
  /// candidates with the best scores.
  std::vector<TunedValues> finalists() const;
  base::Diagnostics chooseBest();
  void choose(const TunedValues& values);

  // TuneEvaluation.cpp: effects of the changes, and runs that the search has not seen.
  TunedValues without(TunedValues values, std::size_t parameter) const;
  /// Each change alone taken back; then those without effect together.
  base::Diagnostics measureEffects();
  /// The values with the changes of the first `count` effects.
  TunedValues withEffects(const TunedValues& full, std::size_t count) const;
  /// Takes back changes without effect if that loses nothing, and those beyond the limit.
  base::Diagnostics simplify(const TunedValues& full);
  base::Diagnostics evaluate();
  void compareHeldOut(const TuneOutcomes& before, const TuneOutcomes& tuned);
  std::vector<TuneDifference> differencesOf(const TuneOutcomes& tuned, const TuneOutcomes& before,
                                            std::size_t scenarios) const;
  TuneOutcomes ofScenario(const TuneOutcomes& all, std::size_t scenario) const;
  static bool areEqual(const TuneOutcomes& outcomes);

  const TuneOptions& options_;
  const TuneSubject& subject_;
  RunPool& pool_;
  const TuneProgress& showStage_;
  const TunedValues present_;
  std::optional<TuneScoring> scoring_;
  std::map<TunedValues, std::map<std::size_t, TuneOutcome>> outcomes_;  // by run
  std::vector<std::pair<TunedValues, int>> tried_;                      // with their generation
  std::vector<TunedValues> means_;  // of the distribution, by generation
  TuneResult result_;
};

}  // namespace app
