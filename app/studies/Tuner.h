#pragma once

#include <algorithm>
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
// The final comparison has the base, these numbers of means of the distribution and of candidates
// with the best scores.
constexpr std::size_t kFinalMeans = 3, kFinalScores = 2;

/// Numbers of runs of a candidate: run k has scenario k mod scenarios.
using TuneRuns = std::vector<std::size_t>;

/// A step of successive halving: candidates that are left, and runs of each so far.
struct Rung {
  std::size_t candidates = 0, runs = 0;
};
/// Runs of all candidates in these steps together.
std::size_t costOf(const std::vector<Rung>& rungs);

/// The state of tune(). Private to this folder: use tune().
class Tuner {
 public:
  Tuner(const TuneOptions& options, const TuneSubject& subject, RunPool& pool,
        const TuneProgress& showStage)
      : options_(options),
        subject_(subject),
        pool_(pool),
        showStage_(showStage),
        present_(subject.present()),
        base_(present_) {}

  base::Result<TuneResult> run();

 private:
  // Tune.cpp: used by several stages.
  /// Runs of a candidate that stays to the end of a race.
  std::size_t searchRuns() const {
    return options_.scenarios.size() * static_cast<std::size_t>(options_.seeds);
  }
  std::size_t heldOutRuns() const {
    return options_.heldOut.size() * static_cast<std::size_t>(options_.heldOutSeeds);
  }
  /// Parameters that may be changed.
  std::size_t mostChanges() const {
    return std::min(subject_.parameters().size(), static_cast<std::size_t>(options_.maxChanges));
  }
  /// The value of a parameter in the base.
  double baseNumber(std::size_t parameter) const;
  /// Runs that no candidate has had yet, so that the search does not adapt to single seeds.
  TuneRuns newRuns(std::size_t count);
  void show(const std::string& stage) const;
  /// Executes these runs of these values, those that are not yet known.
  base::Diagnostics measure(const std::vector<TunedValues>& which, const TuneRuns& runs);
  TuneOutcomes outcomesOf(const TunedValues& values, const TuneRuns& runs) const;
  /// The known runs of both.
  TuneRuns commonRuns(const TunedValues& a, const TunedValues& b) const;
  /// Relative to the values before tuning, and to the base of the search.
  TuneScore scoreOf(const TunedValues& values, const TuneRuns& runs) const;
  TuneScore searchScore(const TunedValues& values, const TuneRuns& runs) const;
  base::Diagnostics start();
  /// Makes these values the base: those that candidates are compared with and derived from.
  void setBase(const TunedValues& values);
  /// All tried values with their scores, each once, and the front of the complete ones.
  void listCandidates();

  // TuneRacing.cpp: comparisons of candidates.
  /// All candidates on at least one seed of each scenario, the better third on half of the seeds,
  /// the better sixth on all.
  std::vector<Rung> searchRungs(std::size_t candidates) const;
  /// The first rung has a quarter of the runs, the last one three candidates and all runs.
  std::vector<Rung> finalRungs(std::size_t candidates, std::size_t runs) const;
  /// Runs of a race of candidates, the base and the values before included.
  std::size_t raceCost(const std::vector<Rung>& rungs) const;
  /// Whether these runs leave enough for the final comparisons.
  bool canAfford(std::size_t runs) const;
  /// Runs of the final comparisons at most, with this many runs of the best finalists and at most
  /// this many changed parameters.
  std::size_t reserve(std::size_t runs, std::size_t changes) const;
  /// Runs of a finalist that are planned, and those that are left for it after the search.
  std::size_t finalCount() const;
  std::size_t affordableCount(std::size_t changes) const;
  /// Runs the candidates and the base on the first of these runs, the better ones on more of them
  /// (successive halving), and the values before on those of the first rung. Indices of the
  /// candidates, the best first.
  base::Result<std::vector<std::size_t>> race(const std::vector<TunedValues>& candidates,
                                              const std::vector<Rung>& rungs, const TuneRuns& runs);

  // TuneProbe.cpp: single parameters, and which of them matter.
  base::Diagnostics probe();
  TunedValues with(TunedValues values, std::size_t parameter, const std::string& text) const;
  /// The base with one parameter at its default, for each; and with all of them.
  std::vector<TunedValues> defaultCandidates() const;
  /// The base with one parameter at values that are far from the current one.
  std::vector<TunedValues> rangeCandidates() const;
  /// Races the candidates and stores the effects of changes of single parameters. The best one
  /// becomes the base if its gain is large and certain.
  base::Diagnostics probeAll(const std::vector<TunedValues>& candidates);
  void note(const std::vector<TunedValues>& candidates, const TuneRuns& runs);
  /// The best changes of different parameters, alone and together.
  std::vector<TunedValues> combinedCandidates() const;
  /// Races these; the best one becomes the base if it is better than that.
  base::Diagnostics combine();
  /// The parameters that the CMA-ES varies: those of the base that have changed, and those with
  /// the largest effects.
  std::vector<std::size_t> screened() const;

  // TuneSearch.cpp: the CMA-ES.
  TunedValues valuesAt(const Point& point) const;
  base::Diagnostics search();
  base::Diagnostics searchGeneration(RestartedCmaEs& cma);
  bool isComplete(const TunedValues& values) const {
    return outcomes_.at(values).size() >= searchRuns();
  }

  // TuneChoice.cpp: the choice, and which of its changes matter.
  /// The base, the last means of the distribution, which average over many noisy scores, and the
  /// complete candidates with the best scores.
  std::vector<TunedValues> finalists() const;
  std::size_t changesOf(const TunedValues& values) const;  // parameters that differ from before
  base::Diagnostics chooseBest();
  void choose(const TunedValues& values);
  /// Each change reverted alone.
  base::Diagnostics measureEffects();
  /// The values with the changes of the first `count` effects.
  TunedValues withEffects(const TunedValues& full, std::size_t count) const;
  /// Reverts changes without effect if that loses nothing, and those beyond the limit.
  base::Diagnostics simplify(const TunedValues& full, const TuneScoring& scoring);

  // TuneEvaluation.cpp: runs that the search has not seen.
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
  TunedValues base_;
  std::optional<TuneScoring> scoring_, baseScoring_;
  std::map<TunedValues, std::map<std::size_t, TuneOutcome>> outcomes_;  // by run
  std::size_t nextRun_ = 0;
  TuneRuns firstRuns_, finalRuns_;
  std::vector<std::pair<TunedValues, int>> tried_;  // with their generation
  std::vector<TuneProbe> probes_;                   // of the current base
  std::vector<std::size_t> varied_;                 // parameters of the CMA-ES
  std::vector<TunedValues> means_;                  // of the distribution, by generation
  TuneResult result_;
};

}  // namespace app
