#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/studies/RunPool.h"
#include "app/studies/TuneScore.h"
#include "app/studies/TuneSubject.h"

/// Tuning: searches values of parameters that are better than the current ones, and measures the
/// improvement on runs that the search has not seen.
namespace app {

/// The first seeds of the search and of the evaluation.
constexpr long long kSearchSeed = 10001, kHeldOutSeed = 1001;

struct TuneOptions {
  std::vector<std::string> scenarios;  // of the search; paths
  std::vector<std::string> heldOut;    // of the evaluation; paths
  std::vector<TuneObjective> objectives;
  int seeds = 3;            // per scenario and generation of the search, from 10001 on
  int heldOutSeeds = 20;    // per scenario, in the evaluation, from 1001 on
  std::size_t runs = 3000;  // limit of all runs before the evaluation
  int maxChanges = 8;       // limit of changed parameters
  double maxLoss = 0.05;    // accepted loss of an objective, as a share
  int population = 0;       // of the CMA-ES; 0: 4 + 3 ln n
  std::uint64_t searchSeed = 1;
};

/// Values that the search has tried.
struct TuneCandidate {
  TunedValues values;
  int generation = -1;   // of the CMA-ES; -1: from another stage
  std::size_t runs = 0;  // that it was scored with
  TuneScore score;
  bool isComplete = false;  // scored with all runs of the search
  bool isOnFront = false;   // complete, and no other complete one is at least as good everywhere
};

/// A change of a single parameter, compared with the values that it was changed from.
struct TuneProbe {
  std::size_t parameter = 0;
  std::string from, to;
  std::size_t runs = 0;
  TuneScore score;
};

/// What a changed parameter contributes: the chosen values compared with the same values without
/// this change.
struct TuneEffect {
  std::size_t parameter = 0;
  std::string value;                        // of the change
  double total = 0.0;                       // of the score that is lost without the change
  double error = 0.0;                       // its standard error
  std::vector<TuneDifference> differences;  // per objective: with the change - without it
  bool isKept = true;
};

/// The chosen values compared with those before on runs that the search has not seen.
struct TuneEvaluation {
  TuneDifference success;
  std::vector<TuneDifference> objectives;
  /// Per scenario: the same.
  std::vector<std::pair<TuneDifference, std::vector<TuneDifference>>> scenarios;
  std::vector<std::string> withoutSeedEffect;  // scenarios whose runs are equal for all seeds
};

enum class TuneVerdict {
  NoCandidate,   // no tried values were better in the search
  NotConfirmed,  // the evaluation does not show an improvement
  Improved
};

struct TuneResult {
  TuneVerdict verdict = TuneVerdict::NoCandidate;
  std::vector<TuneCandidate> candidates;  // the values before first, then in order of the trials
  std::vector<TuneProbe> probes;          // in the order of the trials
  std::vector<std::size_t> varied;        // parameters that the CMA-ES has varied
  std::optional<TunedValues> chosen;      // by the search
  TuneScore chosenScore;
  std::size_t chosenRuns = 0;
  std::vector<TuneEffect> effects;
  std::optional<TuneEvaluation> evaluation;
  std::size_t searchRuns = 0, evaluationRuns = 0;
  int generations = 0;
};

/// A stage of tuning: "search", and the number of runs that are planned in all.
using TuneProgress = std::function<void(const std::string& stage, std::size_t planned)>;

/// Searches in stages; in each one all candidates are run on the same new seeds, the better third
/// of them on half of the seeds and the better sixth on all (successive halving; Jamieson &
/// Talwalkar 2016, AISTATS):
/// 1. each parameter at its documented default, and all of them: finds single bad values;
/// 2. each parameter at distant values of its range: shows which parameters matter;
/// 3. the best changes of different parameters together;
/// 4. CMA-ES on the parameters that matter, starting at the best values so far;
/// 5. the last means of the distribution and the best candidates on more seeds;
/// 6. each change reverted alone; those that do not matter are dropped (backward elimination).
/// Stages that would leave too few runs for the last two are left out. Errors: those of the pool.
base::Result<TuneResult> tune(const TuneOptions& options, const TuneSubject& subject, RunPool& pool,
                              const TuneProgress& showStage = {});

/// Whether the evaluation shows an improvement: successes or an objective are better with 95 %
/// confidence, no objective is worse by more than `maxLoss`, and successes are not fewer with 95 %
/// confidence.
bool isImprovement(const TuneEvaluation& evaluation, const std::vector<TuneObjective>& objectives,
                   double maxLoss);

}  // namespace app
