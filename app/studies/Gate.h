#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/GateMetric.h"
#include "app/studies/GateSide.h"
#include "app/studies/RunPool.h"
#include "metrics/statistics/ConfidenceSequences.h"

/// Gates: is a candidate not worse than a base by more than a margin? A sequential non-inferiority
/// test on pairs of runs with the same scenario and seed.
namespace app {

enum class GateVerdict { Pass, Worse, Undecided };
const char* gateVerdictName(GateVerdict verdict);  // "pass", "worse", "undecided"

/// A pair of runs of one scenario and seed.
struct GatePair {
  std::size_t scenario = 0;
  long long seed = 1;
  ResultRow base, candidate;
};

/// One metric of a gate, decided after each round.
struct GateMetricResult {
  GateMetric metric;
  GateVerdict verdict = GateVerdict::Undecided;
  int pairs = 0;    // when it was decided; otherwise all
  int defined = 0;  // pairs in which at least one run has a value
  double meanGain = statistics::kUndefined;
  statistics::Interval gain;                 // of all pairs so far, see GateTest
  double baseMean = statistics::kUndefined;  // of the runs with a value
  double candidateMean = statistics::kUndefined;
};

/// The test of a gate. Each round adds one pair per scenario with seeds that no other pair has.
/// After each round, for each metric that is still open:
/// - pass, if its mean gain is above minus the margin;
/// - otherwise worse, if its mean gain is below 0.
/// Both by the bounds of a confidence sequence (statistics::MeanSequence), so the error
/// probabilities hold for all rounds together. The candidate is worse if one metric is (each has
/// the share `level` / metrics: the probability of a false alarm for a candidate that is not worse
/// is at most `level`, by Bonferroni); it passes if all metrics do (an intersection-union test: the
/// probability of passing a candidate that is worse by the margin or more in some metric is at most
/// `level` without correction; Berger 1982, Technometrics 24, 295-300).
class GateTest {
 public:
  GateTest(const std::vector<GateMetric>& metrics, double level);

  void addRound(const std::vector<GatePair>& pairs);
  GateVerdict verdict() const;
  const std::vector<GateMetricResult>& metrics() const { return results_; }

 private:
  void decide(std::size_t metric);

  std::vector<GateMetricResult> results_;
  std::vector<statistics::MeanSequence> sequences_;  // per metric
  struct Sums {
    double base = 0.0, candidate = 0.0;
    int bases = 0, candidates = 0;
  };
  std::vector<Sums> sums_;
};

struct GateOptions {
  GateSide base, candidate;
  std::vector<GateScenario> scenarios;
  std::vector<GateMetric> metrics;
  RunSpec common;       // options of all runs
  double level = 0.05;  // of errors
  int maxSeeds = 200;   // per scenario
  long long firstSeed = 1;
};

struct GateResult {
  GateVerdict verdict = GateVerdict::Undecided;
  std::vector<GateMetricResult> metrics;
  std::vector<GatePair> pairs;  // by round and scenario
  /// Scenarios in which several seeds gave identical results of the base: their pairs are not
  /// independent.
  std::vector<std::size_t> constantScenarios;
  std::size_t failedBase = 0, failedCandidate = 0;  // runs that ended with an error
};

/// The requests of one side for a scenario and seed.
RunRequest gateRequest(const GateOptions& options, std::size_t scenario, long long seed,
                       bool candidate);

/// Runs blocks of rounds until the verdict is known or the limit of seeds is reached. Deterministic
/// for any number of jobs: blocks have at least kGateBlock pairs. The test is evaluated after each
/// round; rounds of the block after the decisive one are executed and listed, but change no
/// verdict. Errors: those of RunPool; `gate.base-fails`: no run of the base ended regularly in the
/// first block; `gate.no-values`: no run has a value of a requested metric.
base::Result<GateResult> runGate(const GateOptions& options, RunPool& pool,
                                 const std::function<void(const GateTest&)>& showProgress = {});
constexpr std::size_t kGateBlock = 8;

}  // namespace app
