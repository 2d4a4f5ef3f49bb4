#include <algorithm>
#include <cmath>

#include "app/studies/Tuner.h"

namespace app {

namespace {

constexpr double kFirstSigma = 0.25;                // of the range of a parameter
constexpr std::size_t kBestScores = 2, kMeans = 3;  // candidates of the final comparison
constexpr int kMeanDistance = 2;                    // generations between these means

std::size_t ceilDivided(std::size_t count, std::size_t by) {
  return (count + by - 1) / by;
}

/// A step of successive halving: candidates that are left, and runs of each so far.
struct Rung {
  std::size_t candidates = 0, runs = 0;
};

std::vector<Rung> rungsOf(std::size_t population, std::size_t runs) {
  const std::size_t first = std::min(runs, std::max<std::size_t>(2, ceilDivided(runs, 4)));
  const std::size_t middle = std::max(first, ceilDivided(runs, 2));
  const std::size_t third = ceilDivided(population, 3);
  return {{population, first}, {third, middle}, {ceilDivided(third, 2), runs}};
}

std::size_t costOf(const std::vector<Rung>& rungs) {
  std::size_t cost = 0, before = 0;
  for (const Rung& rung : rungs) {
    cost += rung.candidates * (rung.runs - before);
    before = rung.runs;
  }
  return cost;
}

}  // namespace

std::size_t Tuner::reserve(std::size_t runs) const {
  return (kBestScores + kMeans + 1 + subject_.parameters().size() + 2) * runs;
}

TunedValues Tuner::valuesAt(const Point& point) const {
  TunedValues values;
  for (std::size_t k = 0; k < point.size(); ++k) {
    values.push_back(subject_.parameters()[k].textAt(point[k]));
  }
  return values;
}

base::Diagnostics Tuner::search() {
  show("search");
  RestartedCmaEs::Options of;
  for (const TunedParameter& parameter : subject_.parameters()) {
    of.start.push_back(parameter.shareOf(parameter.presentNumber));
  }
  of.sigma = kFirstSigma;
  of.population = options_.population;
  of.seed = options_.searchSeed;
  RestartedCmaEs cma(of);
  const std::size_t most = options_.runs - std::min(options_.runs, reserve(finalCount()));
  std::size_t cost = 0;
  do {
    base::Diagnostics problems = searchGeneration(cma);
    if (!problems.empty()) {
      return problems;
    }
    means_.push_back(valuesAt(cma.mean()));
    cost = searchRuns() + costOf(rungsOf(cma.ask().size(), searchRuns()));
  } while (result_.searchRuns + cost <= most);
  return {};
}

base::Diagnostics Tuner::searchGeneration(RestartedCmaEs& cma) {
  std::vector<TunedValues> values;
  for (const Point& point : cma.ask()) {
    values.push_back(valuesAt(point));
    tried_.emplace_back(values.back(), result_.generations);
  }
  const std::vector<Rung> rungs = rungsOf(values.size(), searchRuns());
  std::vector<std::size_t> order(values.size());  // of candidates, the best first
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (const Rung& rung : rungs) {
    const TuneRuns runs = runsOf(result_.generations, rung.runs);
    std::vector<TunedValues> left = {present_};
    for (std::size_t k = 0; k < rung.candidates; ++k) {
      left.push_back(values[order[k]]);
    }
    base::Diagnostics problems = measure(left, runs);
    if (!problems.empty()) {
      return problems;
    }
    std::stable_sort(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(rung.candidates),
                     [&](std::size_t a, std::size_t b) {
                       return scoreOf(values[a], runs).total < scoreOf(values[b], runs).total;
                     });
  }
  std::vector<double> ranks(values.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    ranks[order[k]] = static_cast<double>(k);
  }
  cma.tell(ranks);
  ++result_.generations;
  return {};
}

std::vector<TunedValues> Tuner::finalists() const {
  std::vector<TunedValues> found;
  const auto add = [&](const TunedValues& values) {
    if (values != present_ && std::find(found.begin(), found.end(), values) == found.end()) {
      found.push_back(values);
    }
  };
  const auto last = static_cast<int>(means_.size()) - 1;
  for (int k = 0; k < static_cast<int>(kMeans) && last >= k * kMeanDistance; ++k) {
    add(means_[static_cast<std::size_t>(last - k * kMeanDistance)]);
  }
  std::vector<std::pair<double, const TunedValues*>> complete;
  for (const auto& [values, generation] : tried_) {
    if (values != present_ && isComplete(values)) {
      complete.emplace_back(scoreOf(values, knownRuns(values)).total, &values);
    }
  }
  std::stable_sort(complete.begin(), complete.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < std::min(kBestScores, complete.size()); ++k) {
    add(*complete[k].second);
  }
  return found;
}

base::Diagnostics Tuner::chooseBest() {
  const std::vector<TunedValues> candidates = finalists();
  show("best candidates");
  const TuneRuns runs = finalRuns();
  std::vector<TunedValues> compared = candidates;
  compared.push_back(present_);
  base::Diagnostics problems = measure(compared, runs);
  if (!problems.empty()) {
    return problems;
  }
  double best = 1.0 - kLeastImprovement;
  for (const TunedValues& values : candidates) {
    tried_.emplace_back(values, result_.generations);
    const TuneScore score = scoreOf(values, runs);
    if (score.isAcceptable(options_.maxLoss) && score.total < best) {
      best = score.total;
      choose(values);
    }
  }
  return {};
}

void Tuner::choose(const TunedValues& values) {
  const TuneRuns runs = finalRuns();
  result_.chosen = values;
  result_.chosenScore = scoreOf(values, runs);
  result_.chosenRuns = runs.size();
}

}  // namespace app
