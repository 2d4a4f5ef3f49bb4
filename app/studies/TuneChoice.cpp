#include <algorithm>
#include <set>

#include "app/studies/Tuner.h"

namespace app {

namespace {

constexpr int kMeanDistance = 2;     // generations between the means of the final comparison
constexpr double kNoEffect = 0.005;  // of the score

/// Whether a loss is too small to matter, or not distinguishable from chance.
bool isNegligible(const TuneScore& score) {
  return score.total - 1.0 <= std::max(kNoEffect, score.error / 2.0);
}

}  // namespace

std::vector<TunedValues> Tuner::finalists() const {
  std::vector<TunedValues> found;
  const auto add = [&](const TunedValues& values) {
    if (values != present_ && std::find(found.begin(), found.end(), values) == found.end()) {
      found.push_back(values);
    }
  };
  add(base_);
  const auto last = static_cast<int>(means_.size()) - 1;
  for (int k = 0; k < static_cast<int>(kFinalMeans) && last >= k * kMeanDistance; ++k) {
    add(means_[static_cast<std::size_t>(last - k * kMeanDistance)]);
  }
  std::vector<std::pair<double, const TunedValues*>> complete;
  for (const auto& [values, generation] : tried_) {
    const TuneRuns runs = commonRuns(values, base_);
    if (values != base_ && runs.size() >= searchRuns()) {
      const TuneScore score = searchScore(values, runs);
      complete.emplace_back(score.total + score.error, &values);
    }
  }
  std::stable_sort(complete.begin(), complete.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < std::min(kFinalScores, complete.size()); ++k) {
    add(*complete[k].second);
  }
  return found;
}

std::size_t Tuner::changesOf(const TunedValues& values) const {
  std::size_t count = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    count += values[k] != present_[k] ? 1 : 0;
  }
  return count;
}

base::Diagnostics Tuner::chooseBest() {
  const std::vector<TunedValues> candidates = finalists();
  if (candidates.empty()) {
    return {};
  }
  show("best candidates");
  std::size_t changes = 0;
  for (const TunedValues& values : candidates) {
    changes = std::max(changes, changesOf(values));
  }
  finalRuns_ = newRuns(affordableCount(changes));
  const base::Result<std::vector<std::size_t>> order =
      race(candidates, finalRungs(candidates.size(), finalRuns_.size()), finalRuns_);
  if (!order) {
    return order.diagnostics();
  }
  base::Diagnostics problems = measure({present_}, finalRuns_);
  if (!problems.empty()) {
    return problems;
  }
  for (const std::size_t k : *order) {
    tried_.emplace_back(candidates[k], -1);
    if (result_.chosen || commonRuns(candidates[k], present_).size() < finalRuns_.size()) {
      continue;
    }
    const TuneScore score = scoreOf(candidates[k], finalRuns_);
    if (score.isAcceptable(options_.maxLoss) && score.total < 1.0 - kLeastImprovement) {
      choose(candidates[k]);
    }
  }
  return {};
}

void Tuner::choose(const TunedValues& values) {
  result_.chosen = values;
  result_.chosenScore = scoreOf(values, finalRuns_);
  result_.chosenRuns = finalRuns_.size();
}

base::Diagnostics Tuner::measureEffects() {
  show("effects");
  const TunedValues full = *result_.chosen;
  std::vector<TunedValues> reverted;
  for (std::size_t k = 0; k < full.size(); ++k) {
    if (full[k] != present_[k]) {
      reverted.push_back(with(full, k, present_[k]));
      result_.effects.push_back({k, full[k], 0.0, 0.0, {}, true});
    }
  }
  base::Diagnostics problems = measure(reverted, finalRuns_);
  if (!problems.empty()) {
    return problems;
  }
  const TuneOutcomes outcomes = outcomesOf(full, finalRuns_);
  const TuneScoring scoring(options_.objectives, options_.maxLoss, outcomes);
  for (std::size_t k = 0; k < reverted.size(); ++k) {
    TuneEffect& effect = result_.effects[k];
    const TuneOutcomes others = outcomesOf(reverted[k], finalRuns_);
    const TuneScore score = scoring.score(others, outcomes);
    effect.total = score.total - 1.0;
    effect.error = score.error;
    effect.isKept = !isNegligible(score);
    for (std::size_t of = 0; of < options_.objectives.size(); ++of) {
      effect.differences.push_back(differenceOf(outcomes, others, of, options_.scenarios.size()));
    }
  }
  std::stable_sort(result_.effects.begin(), result_.effects.end(),
                   [](const auto& a, const auto& b) { return a.total > b.total; });
  return simplify(full, scoring);
}

TunedValues Tuner::withEffects(const TunedValues& full, std::size_t count) const {
  TunedValues values = full;
  for (std::size_t k = count; k < result_.effects.size(); ++k) {
    values = with(values, result_.effects[k].parameter, present_[result_.effects[k].parameter]);
  }
  return values;
}

base::Diagnostics Tuner::simplify(const TunedValues& full, const TuneScoring& scoring) {
  const std::size_t limit = std::min(result_.effects.size(), mostChanges());
  const auto useful = static_cast<std::size_t>(
      std::count_if(result_.effects.begin(), result_.effects.end(),
                    [](const TuneEffect& effect) { return effect.isKept; }));
  const std::size_t few = std::min(limit, std::max<std::size_t>(useful, 1));
  for (const std::size_t count : std::set<std::size_t>{few, (few + limit + 1) / 2, limit}) {
    const TunedValues values = withEffects(full, count);
    base::Diagnostics problems = measure({values}, finalRuns_);
    if (!problems.empty()) {
      return problems;
    }
    const bool isAsGood =
        scoreOf(values, finalRuns_).isAcceptable(options_.maxLoss) &&
        isNegligible(scoring.score(outcomesOf(values, finalRuns_), outcomesOf(full, finalRuns_)));
    if (isAsGood || count == limit) {
      choose(values);
      for (std::size_t k = 0; k < result_.effects.size(); ++k) {
        result_.effects[k].isKept = k < count;
      }
      return {};
    }
  }
  return {};
}

}  // namespace app
