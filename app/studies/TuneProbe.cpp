#include <algorithm>
#include <cmath>
#include <set>

#include "app/studies/Tuner.h"

namespace app {

namespace {

constexpr int kMostRounds = 3;      // of the same kind; another one follows a new base
constexpr double kLargeGain = 0.1;  // of the score: other values may matter now
constexpr double kCertain = 3.0;    // standard errors: the best of many candidates is often luck
constexpr double kDistantShares[] = {0.15, 0.85, 0.5};  // of the range of a parameter
constexpr double kLeastDistance = 0.2;                  // from the current value and the default
constexpr std::size_t kDistantValues = 2;
constexpr std::size_t kCombined[] = {2, 3, 4, 6, 8};  // numbers of changes
constexpr std::size_t kAlone = 3;                     // single changes in the same race
constexpr std::size_t kMostVaried = 8;
constexpr double kMostEffect = 0.5;  // larger ones count the same

/// How much a change does beyond one standard error. Losses count half: the parameter matters, but
/// its current value is good.
double strengthOf(const TuneScore& score) {
  const double change = score.total - 1.0;
  const double size = std::min(std::fabs(change), kMostEffect) - score.error;
  return std::max(0.0, change < 0.0 ? size : size / 2.0);
}

/// The parameter of which alone two lists of values differ; their size: there is no such.
std::size_t onlyDifference(const TunedValues& a, const TunedValues& b) {
  std::size_t found = a.size();
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] != b[k] && found < a.size()) {
      return a.size();
    }
    found = a[k] != b[k] ? k : found;
  }
  return found;
}

}  // namespace

TunedValues Tuner::with(TunedValues values, std::size_t parameter, const std::string& text) const {
  values[parameter] = text;
  return values;
}

std::vector<TunedValues> Tuner::defaultCandidates() const {
  std::vector<TunedValues> candidates;
  TunedValues all = base_;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const TunedParameter& parameter = subject_.parameters()[k];
    const double now = baseNumber(k);
    if (parameter.fallback && *parameter.fallback != now &&
        *parameter.fallback >= parameter.range.low && *parameter.fallback <= parameter.range.high) {
      all[k] = parameter.textOf(*parameter.fallback);
      candidates.push_back(with(base_, k, all[k]));
    }
  }
  if (candidates.size() > 1) {
    candidates.push_back(std::move(all));
  }
  return candidates;
}

std::vector<TunedValues> Tuner::rangeCandidates() const {
  std::vector<TunedValues> candidates;
  for (std::size_t k = 0; k < base_.size(); ++k) {
    const TunedParameter& parameter = subject_.parameters()[k];
    std::vector<double> shares = {parameter.shareOf(baseNumber(k))};
    if (parameter.fallback) {
      shares.push_back(parameter.shareOf(*parameter.fallback));
    }
    std::size_t count = 0;
    for (const double share : kDistantShares) {
      const bool isNew = std::all_of(shares.begin(), shares.end(), [&](double other) {
        return std::fabs(other - share) >= kLeastDistance;
      });
      const std::string text = parameter.textAt(share);
      if (isNew && text != base_[k] && count < kDistantValues) {
        candidates.push_back(with(base_, k, text));
        ++count;
      }
    }
  }
  return candidates;
}

base::Diagnostics Tuner::probe() {
  show("single parameters");
  for (const auto candidates : {&Tuner::defaultCandidates, &Tuner::rangeCandidates}) {
    bool hasNewBase = true;
    for (int round = 0; round < kMostRounds && hasNewBase; ++round) {
      const TunedValues before = base_;
      base::Diagnostics problems = probeAll((this->*candidates)());
      if (!problems.empty()) {
        return problems;
      }
      hasNewBase = base_ != before;
    }
  }
  base::Diagnostics problems = combine();
  varied_ = screened();
  return problems;
}

base::Diagnostics Tuner::probeAll(const std::vector<TunedValues>& candidates) {
  const std::vector<Rung> rungs = searchRungs(candidates.size());
  if (candidates.empty() || !canAfford(raceCost(rungs))) {
    return {};
  }
  const TuneRuns runs =
      nextRun_ == firstRuns_.size() && probes_.empty() ? firstRuns_ : newRuns(searchRuns());
  const base::Result<std::vector<std::size_t>> order = race(candidates, rungs, runs);
  if (!order) {
    return order.diagnostics();
  }
  for (const TunedValues& values : candidates) {
    tried_.emplace_back(values, -1);
  }
  note(candidates, runs);
  const TunedValues& best = candidates[order->front()];
  const TuneScore score = searchScore(best, runs);
  const double improvement = 1.0 - score.total;
  if (improvement >= kLargeGain && improvement > kCertain * score.error) {
    probes_.clear();  // they belong to the base so far
    setBase(best);
  }
  return {};
}

void Tuner::note(const std::vector<TunedValues>& candidates, const TuneRuns& runs) {
  for (const TunedValues& values : candidates) {
    const std::size_t parameter = onlyDifference(values, base_);
    if (parameter < values.size()) {
      TuneRuns known = commonRuns(values, base_);
      known.erase(std::remove_if(known.begin(), known.end(),
                                 [&](std::size_t run) { return run < runs.front(); }),
                  known.end());
      probes_.push_back({parameter, base_[parameter], values[parameter], known.size(),
                         searchScore(values, known)});
      result_.probes.push_back(probes_.back());
    }
  }
}

std::vector<TunedValues> Tuner::combinedCandidates() const {
  std::vector<const TuneProbe*> gains;  // the best of each parameter, the best first
  for (const TuneProbe& probe : probes_) {
    if (probe.score.total < 1.0 - probe.score.error / 2.0) {
      gains.push_back(&probe);
    }
  }
  const auto valueOf = [](const TuneProbe* probe) {
    return probe->score.total + probe->score.error / 2.0;
  };
  std::stable_sort(gains.begin(), gains.end(),
                   [&](auto a, auto b) { return valueOf(a) < valueOf(b); });
  std::vector<TunedValues> candidates;
  std::set<std::size_t> changed;
  TunedValues together = base_;
  for (const TuneProbe* const probe : gains) {
    if (changed.size() == mostChanges() || !changed.insert(probe->parameter).second) {
      continue;
    }
    together[probe->parameter] = probe->to;
    if (changed.size() <= kAlone) {
      candidates.push_back(with(base_, probe->parameter, probe->to));
    }
    if (std::find(std::begin(kCombined), std::end(kCombined), changed.size()) !=
        std::end(kCombined)) {
      candidates.push_back(together);
    }
  }
  return candidates;
}

base::Diagnostics Tuner::combine() {
  const std::vector<TunedValues> candidates = combinedCandidates();
  const std::vector<Rung> rungs = finalRungs(candidates.size(), finalCount());
  if (candidates.empty() || !canAfford(raceCost(rungs))) {
    return {};
  }
  show("combined changes");
  const TuneRuns runs = newRuns(finalCount());
  const base::Result<std::vector<std::size_t>> order = race(candidates, rungs, runs);
  if (!order) {
    return order.diagnostics();
  }
  for (const TunedValues& values : candidates) {
    tried_.emplace_back(values, -1);
  }
  const TunedValues& best = candidates[order->front()];
  const TuneScore score = searchScore(best, runs);
  if (score.total < 1.0 - std::max(kLeastImprovement, score.error)) {
    setBase(best);
  }
  return {};
}

std::vector<std::size_t> Tuner::screened() const {
  std::vector<std::pair<double, std::size_t>> strengths;
  for (std::size_t k = 0; k < base_.size(); ++k) {
    double strength = base_[k] != present_[k] ? 2.0 * kMostEffect : 0.0;
    for (const TuneProbe& probe : probes_) {
      strength = probe.parameter == k ? std::max(strength, strengthOf(probe.score)) : strength;
    }
    strengths.emplace_back(-strength, k);
  }
  std::stable_sort(strengths.begin(), strengths.end());
  const std::size_t most = std::min(kMostVaried, mostChanges());
  std::vector<std::size_t> parameters;
  for (std::size_t k = 0; k < most; ++k) {
    if (k < 2 || strengths[k].first < 0.0) {
      parameters.push_back(strengths[k].second);
    }
  }
  std::sort(parameters.begin(), parameters.end());
  return parameters;
}

}  // namespace app
