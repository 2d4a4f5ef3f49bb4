#include "app/studies/SearchEmitters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/run/Design.h"

namespace app {

namespace {

constexpr double kMutationRate = 0.3;      // share of candidates with another category
constexpr double kImproverSigma = 0.2;     // first standard deviation around an elite
constexpr double kLeastSigma = 1e-4;       // below it the improver restarts
constexpr std::size_t kCombinations = 16;  // in a batch without continuous values
constexpr int kAttempts = 200;             // to find a new combination at random

const Candidate& bestOf(const std::vector<RatedCandidate>& rated) {
  return std::max_element(
             rated.begin(), rated.end(),
             [](const RatedCandidate& a, const RatedCandidate& b) { return a.fitness < b.fitness; })
      ->candidate;
}

}  // namespace

SearchEmitters::SearchEmitters(const SearchSpace& space, std::uint64_t seed)
    : space_(space), seed_(seed), random_(seed) {}

std::vector<Candidate> SearchEmitters::first(std::size_t count, bool isBalanced) {
  std::vector<std::vector<double>> points(count);
  if (space_.dimensions() > 0) {
    points = designPoints({Design::Method::Sobol, count, seed_}, space_.dimensions());
  }
  std::vector<std::vector<std::size_t>> balanced(count);
  if (isBalanced) {
    balanced = space_.balancedChoices(count, random_);
  }
  std::vector<Candidate> candidates;
  for (std::size_t k = 0; k < count; ++k) {
    candidates.push_back({std::move(points[k]),
                          isBalanced ? std::move(balanced[k]) : space_.randomChoices(random_)});
    if (space_.dimensions() == 0 && !proposed_.insert(candidates.back().choices).second) {
      candidates.pop_back();
    }
  }
  return candidates;
}

std::vector<Candidate> SearchEmitters::candidatesAt(const std::vector<Point>& points,
                                                    const std::vector<std::size_t>& choices) {
  std::vector<Candidate> candidates;
  for (const Point& point : points) {
    candidates.push_back({nearestInBox(point), choices});
    if (random_.chance(kMutationRate)) {
      space_.mutate(candidates.back().choices, random_);
    }
  }
  return candidates;
}

void SearchEmitters::restartImprovement(const Candidate& elite) {
  CmaEs::Options options;
  options.start = elite.point;
  options.sigma = kImproverSigma;
  options.seed = seed_ + 1;
  options.run = improverRestarts_++;
  improver_ = std::make_unique<CmaEs>(options);
  improverChoices_ = elite.choices;
}

std::vector<Candidate> SearchEmitters::next(const std::vector<std::size_t>& elites,
                                            const std::vector<RatedCandidate>& rated) {
  if (space_.dimensions() == 0) {
    return combinations(elites, rated);
  }
  const Candidate best = rated.empty() ? Candidate{std::vector<double>(space_.dimensions(), 0.5),
                                                   space_.randomChoices(random_)}
                                       : bestOf(rated);
  if (!optimiser_) {
    RestartedCmaEs::Options options;
    options.start = best.point;
    options.dimensions = space_.dimensions();
    options.seed = seed_;
    optimiser_ = std::make_unique<RestartedCmaEs>(options);
  }
  if (!improver_) {
    restartImprovement(elites.empty() ? best
                                      : rated[elites[random_.below(elites.size())]].candidate);
  }
  std::vector<Candidate> candidates = candidatesAt(optimiser_->ask(), best.choices);
  optimiserCount_ = candidates.size();
  std::vector<Candidate> more = candidatesAt(improver_->ask(), improverChoices_);
  std::move(more.begin(), more.end(), std::back_inserter(candidates));
  return candidates;
}

void SearchEmitters::tell(const std::vector<double>& fitness,
                          const std::vector<std::optional<EliteArchive::Change>>& changes) {
  if (space_.dimensions() == 0) {
    return;
  }
  const auto end = static_cast<std::ptrdiff_t>(optimiserCount_);
  std::vector<double> costs;
  std::transform(fitness.begin(), fitness.begin() + end, std::back_inserter(costs),
                 [](double value) { return -value; });
  optimiser_->tell(costs);
  const std::vector<std::optional<EliteArchive::Change>> own(changes.begin() + end, changes.end());
  const std::vector<std::size_t> ranks =
      improvementRanks(own, std::vector<double>(fitness.begin() + end, fitness.end()));
  improver_->tell(std::vector<double>(ranks.begin(), ranks.end()));
  const bool isIdle =
      std::none_of(own.begin(), own.end(), [](const auto& change) { return change.has_value(); });
  if (isIdle || improver_->sigma() < kLeastSigma) {
    improver_.reset();  // the next batch starts at another elite
  }
}

std::vector<Candidate> SearchEmitters::combinations(const std::vector<std::size_t>& elites,
                                                    const std::vector<RatedCandidate>& rated) {
  std::vector<Candidate> candidates;
  while (candidates.size() < kCombinations) {
    std::optional<std::vector<std::size_t>> choices = newCombination(elites, rated);
    if (!choices) {
      break;
    }
    proposed_.insert(*choices);
    candidates.push_back({{}, *std::move(choices)});
  }
  return candidates;
}

/// Half of them near an elite. When random ones are all known, the first unknown one in order.
std::optional<std::vector<std::size_t>> SearchEmitters::newCombination(
    const std::vector<std::size_t>& elites, const std::vector<RatedCandidate>& rated) {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    std::vector<std::size_t> choices = space_.randomChoices(random_);
    if (!elites.empty() && random_.chance(0.5)) {
      choices = rated[elites[random_.below(elites.size())]].candidate.choices;
      space_.mutate(choices, random_);
    }
    if (proposed_.count(choices) == 0) {
      return choices;
    }
  }
  const std::vector<std::size_t>& counts = space_.optionCounts();
  std::vector<std::size_t> choices(counts.size(), 0);
  for (std::size_t at = 0; at < counts.size();) {
    if (proposed_.count(choices) == 0) {
      return choices;
    }
    for (at = 0; at < counts.size() && ++choices[at] == counts[at]; ++at) {
      choices[at] = 0;
    }
  }
  return std::nullopt;
}

}  // namespace app
