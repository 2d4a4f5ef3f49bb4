#include "app/studies/Gate.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace app {

const char* gateVerdictName(GateVerdict verdict) {
  constexpr const char* kNames[] = {"pass", "worse", "undecided"};
  return kNames[static_cast<std::size_t>(verdict)];
}

GateTest::GateTest(const std::vector<GateMetric>& metrics, double level) {
  const double worse = level / static_cast<double>(std::max<std::size_t>(1, metrics.size()));
  for (const GateMetric& metric : metrics) {
    GateMetricResult result;
    result.metric = metric;
    results_.push_back(std::move(result));
    sequences_.emplace_back(gainRange(metric), statistics::MeanSequence::Errors{level, worse},
                            statistics::MeanSequence::Stakes::MostlyFull);
  }
  sums_.resize(metrics.size());
}

void GateTest::addRound(const std::vector<GatePair>& pairs) {
  for (std::size_t k = 0; k < results_.size(); ++k) {
    GateMetricResult& result = results_[k];
    statistics::Numbers gains;
    for (const GatePair& pair : pairs) {
      const GateGain gain = gainOf(result.metric, pair.base, pair.candidate);
      gains.push_back(gain.gain);
      result.defined += gain.base || gain.candidate ? 1 : 0;
      sums_[k].base += gain.base.value_or(0.0);
      sums_[k].candidate += gain.candidate.value_or(0.0);
      sums_[k].bases += gain.base ? 1 : 0;
      sums_[k].candidates += gain.candidate ? 1 : 0;
    }
    sequences_[k].addRound(gains);
    decide(k);
  }
}

/// Updates the result of a metric; a decision is final.
void GateTest::decide(std::size_t metric) {
  GateMetricResult& result = results_[metric];
  const statistics::MeanSequence& sequence = sequences_[metric];
  const Sums& sums = sums_[metric];
  result.meanGain = sequence.mean();
  result.gain = sequence.interval();
  result.baseMean = sums.bases > 0 ? sums.base / sums.bases : statistics::kUndefined;
  result.candidateMean =
      sums.candidates > 0 ? sums.candidate / sums.candidates : statistics::kUndefined;
  if (result.verdict != GateVerdict::Undecided) {
    return;
  }
  result.pairs = sequence.count();
  if (result.defined == 0) {
    return;
  }
  if (result.gain.low > -marginAsGain(result.metric)) {
    result.verdict = GateVerdict::Pass;
  } else if (result.gain.high < 0.0) {
    result.verdict = GateVerdict::Worse;
  }
}

/// Metrics without any value are ignored, unless they were requested.
GateVerdict GateTest::verdict() const {
  bool isOpen = false;
  bool hasPass = false;
  for (const GateMetricResult& result : results_) {
    if (result.verdict == GateVerdict::Worse) {
      return GateVerdict::Worse;
    }
    hasPass = hasPass || result.verdict == GateVerdict::Pass;
    isOpen = isOpen || (result.verdict == GateVerdict::Undecided &&
                        (result.defined > 0 || result.metric.isRequested));
  }
  return hasPass && !isOpen ? GateVerdict::Pass : GateVerdict::Undecided;
}

RunRequest gateRequest(const GateOptions& options, std::size_t scenario, long long seed,
                       bool candidate) {
  const GateScenario& in = options.scenarios[scenario];
  RunRequest request;
  request.scenario = candidate ? in.candidate : in.base;
  request.seed = seed;
  request.spec =
      specOfSide(candidate ? options.candidate : options.base, options.common, request.scenario);
  return request;
}

namespace {

/// Scenarios with at least two pairs whose base runs all have the same fields.
std::vector<std::size_t> constantScenarios(const GateOptions& options,
                                           const std::vector<GatePair>& pairs) {
  std::vector<std::size_t> found;
  for (std::size_t scenario = 0; scenario < options.scenarios.size(); ++scenario) {
    const GatePair* first = nullptr;
    std::size_t count = 0;
    bool isConstant = true;
    for (const GatePair& pair : pairs) {
      if (pair.scenario == scenario) {
        first = first == nullptr ? &pair : first;
        isConstant = isConstant && pair.base.fields == first->base.fields;
        ++count;
      }
    }
    if (count > 1 && isConstant && !first->base.fields.empty()) {
      found.push_back(scenario);
    }
  }
  return found;
}

/// Runs a gate block by block.
class GateRunner {
 public:
  GateRunner(const GateOptions& options, RunPool& pool)
      : options_(options), pool_(pool), test_(options.metrics, options.level) {}

  base::Result<GateResult> run(const std::function<void(const GateTest&)>& showProgress) {
    const std::size_t scenarios = options_.scenarios.size();
    const std::size_t rounds = (kGateBlock + scenarios - 1) / scenarios;
    const auto most = static_cast<std::size_t>(options_.maxSeeds);
    for (std::size_t first = 0; first < most && test_.verdict() == GateVerdict::Undecided;
         first += rounds) {
      base::Diagnostics problems = runBlock(first, std::min(most, first + rounds));
      if (problems.empty() && first == 0) {
        problems = problemsOfStart();
      }
      if (!problems.empty()) {
        return problems;
      }
      if (showProgress) {
        showProgress(test_);
      }
    }
    return finish();
  }

 private:
  /// Executes the rounds [first, end).
  base::Diagnostics runBlock(std::size_t first, std::size_t end) {
    std::vector<RunRequest> requests;
    std::vector<GatePair> pairs;
    const std::size_t scenarios = options_.scenarios.size();
    for (std::size_t round = first; round < end; ++round) {
      for (std::size_t scenario = 0; scenario < scenarios; ++scenario) {
        const long long seed =
            options_.firstSeed + static_cast<long long>(round * scenarios + scenario);
        requests.push_back(gateRequest(options_, scenario, seed, false));
        requests.push_back(gateRequest(options_, scenario, seed, true));
        pairs.push_back({scenario, seed, {}, {}});
      }
    }
    base::Result<std::vector<ResultRow>> rows = pool_.run(requests);
    if (!rows) {
      return rows.diagnostics();
    }
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      pairs[k].base = std::move((*rows)[2 * k]);
      pairs[k].candidate = std::move((*rows)[2 * k + 1]);
    }
    for (std::size_t k = 0; k < pairs.size(); k += scenarios) {
      const auto begin = pairs.begin() + static_cast<std::ptrdiff_t>(k);
      if (test_.verdict() == GateVerdict::Undecided) {
        test_.addRound({begin, begin + static_cast<std::ptrdiff_t>(scenarios)});
      }
    }
    result_.pairs.insert(result_.pairs.end(), std::make_move_iterator(pairs.begin()),
                         std::make_move_iterator(pairs.end()));
    return {};
  }

  base::Diagnostics problemsOfStart() const {
    const auto isOk = [](const GatePair& pair) { return pair.base.ok; };
    if (std::none_of(result_.pairs.begin(), result_.pairs.end(), isOk)) {
      return {base::error("gate.base-fails", {result_.pairs.front().base.reason})};
    }
    base::Diagnostics problems;
    for (const GateMetricResult& each : test_.metrics()) {
      if (each.metric.isRequested && each.defined == 0) {
        problems.push_back(base::error("gate.no-values", {each.metric.key}));
      }
    }
    return problems;
  }

  GateResult finish() {
    result_.verdict = test_.verdict();
    result_.metrics = test_.metrics();
    result_.constantScenarios = constantScenarios(options_, result_.pairs);
    for (const GatePair& pair : result_.pairs) {
      result_.failedBase += pair.base.ok ? 0 : 1;
      result_.failedCandidate += pair.candidate.ok ? 0 : 1;
    }
    return std::move(result_);
  }

  const GateOptions& options_;
  RunPool& pool_;
  GateTest test_;
  GateResult result_;
};

}  // namespace

base::Result<GateResult> runGate(const GateOptions& options, RunPool& pool,
                                 const std::function<void(const GateTest&)>& showProgress) {
  return GateRunner(options, pool).run(showProgress);
}

}  // namespace app
