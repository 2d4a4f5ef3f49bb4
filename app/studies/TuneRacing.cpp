#include <algorithm>
#include <numeric>

#include "app/studies/Tuner.h"

namespace app {

namespace {

constexpr std::size_t kFewestRuns = 3;           // of the first rung
constexpr std::size_t kMostSimplifications = 3;  // numbers of changes that simplify() tries
constexpr std::size_t kMostRepeats = 8;          // of the runs of a race of the search
constexpr double kFinalShare = 0.4;              // of the runs, for the final comparisons

std::size_t dividedUp(std::size_t count, std::size_t by) {
  return (count + by - 1) / by;
}

}  // namespace

std::size_t costOf(const std::vector<Rung>& rungs) {
  std::size_t cost = 0, before = 0;
  for (const Rung& rung : rungs) {
    cost += rung.candidates * (rung.runs - before);
    before = rung.runs;
  }
  return cost;
}

/// All rungs have the same number of runs of each scenario: with different numbers, scenarios that
/// are missing in the first rung would not count for the candidates that it drops.
std::vector<Rung> Tuner::searchRungs(std::size_t candidates) const {
  const std::size_t scenarios = options_.scenarios.size();
  const auto seeds = static_cast<std::size_t>(options_.seeds);
  const std::size_t first =
      std::min(seeds, std::max(dividedUp(seeds, 4), dividedUp(kFewestRuns, scenarios)));
  const std::size_t middle = std::max(first, dividedUp(seeds, 2));
  const std::size_t third = dividedUp(candidates, 3);
  return {{candidates, first * scenarios},
          {third, middle * scenarios},
          {dividedUp(third, 2), seeds * scenarios}};
}

std::vector<Rung> Tuner::finalRungs(std::size_t candidates, std::size_t runs) const {
  const std::size_t scenarios = options_.scenarios.size();
  const std::size_t seeds = runs / scenarios;
  return {{candidates, dividedUp(seeds, 4) * scenarios},
          {std::max(std::min<std::size_t>(candidates, 3), dividedUp(candidates, 2)),
           dividedUp(seeds, 2) * scenarios},
          {std::min<std::size_t>(candidates, 3), runs}};
}

std::size_t Tuner::raceCost(const std::vector<Rung>& rungs) const {
  return costOf(rungs) + rungs.back().runs + (base_ == present_ ? 0 : rungs.front().runs);
}

std::size_t Tuner::reserve(std::size_t runs, std::size_t changes) const {
  constexpr std::size_t kMostFinalists = 1 + kFinalMeans + kFinalScores;
  constexpr std::size_t kReferences = 2;  // the base and the values before
  return costOf(finalRungs(kMostFinalists, runs)) +
         (kReferences + changes + kMostSimplifications) * runs;
}

std::size_t Tuner::finalCount() const {
  for (const std::size_t factor : {std::size_t{4}, std::size_t{2}}) {
    const std::size_t count = factor * searchRuns();
    if (static_cast<double>(reserve(count, mostChanges())) <=
        kFinalShare * static_cast<double>(options_.runs)) {
      return count;
    }
  }
  return searchRuns();
}

std::size_t Tuner::affordableCount(std::size_t changes) const {
  const std::size_t scenarios = options_.scenarios.size();
  std::size_t count = finalCount();
  while (count < kMostRepeats * searchRuns() &&
         result_.searchRuns + reserve(count + scenarios, changes) <= options_.runs) {
    count += scenarios;
  }
  return count;
}

bool Tuner::canAfford(std::size_t runs) const {
  return result_.searchRuns + runs + reserve(finalCount(), mostChanges()) <= options_.runs;
}

base::Result<std::vector<std::size_t>> Tuner::race(const std::vector<TunedValues>& candidates,
                                                   const std::vector<Rung>& rungs,
                                                   const TuneRuns& runs) {
  std::vector<std::size_t> order(candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const Rung& rung : rungs) {
    const TuneRuns some(runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(rung.runs));
    std::vector<TunedValues> left = {base_};
    for (std::size_t k = 0; k < rung.candidates; ++k) {
      left.push_back(candidates[order[k]]);
    }
    if (&rung == &rungs.front()) {
      left.push_back(present_);
    }
    base::Diagnostics problems = measure(left, some);
    if (!problems.empty()) {
      return problems;
    }
    std::stable_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(rung.candidates),
                     [&](std::size_t a, std::size_t b) {
                       return searchScore(candidates[a], some).total <
                              searchScore(candidates[b], some).total;
                     });
  }
  return order;
}

}  // namespace app
