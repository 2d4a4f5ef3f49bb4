#include "metrics/statistics/ParetoFront.h"

#include <algorithm>

namespace statistics {

namespace {

/// Normalises the direction: smaller is better.
double costOf(double value, Sense sense) {
  return sense == Sense::Lower ? value : -value;
}

/// Positions between the worst (0) and the best (1) value.
Numbers normalisedScores(const Criterion& criterion) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (const double value : criterion.values) {
    if (!std::isnan(value)) {
      least = std::min(least, costOf(value, criterion.sense));
      most = std::max(most, costOf(value, criterion.sense));
    }
  }
  Numbers places;
  places.reserve(criterion.values.size());
  for (const double value : criterion.values) {
    const double cost = costOf(value, criterion.sense);
    places.push_back(most > least ? (most - cost) / (most - least)
                                  : (std::isnan(value) ? kUndefined : 1.0));
  }
  return places;
}

}  // namespace

std::vector<bool> paretoFront(const Numbers& x, Sense xSense, const Numbers& y, Sense ySense) {
  const auto isDefined = [&](std::size_t k) { return !std::isnan(x[k]) && !std::isnan(y[k]); };
  const auto beats = [&](std::size_t a, std::size_t b) {
    const double dx = costOf(x[a], xSense) - costOf(x[b], xSense);
    const double dy = costOf(y[a], ySense) - costOf(y[b], ySense);
    return dx <= 0.0 && dy <= 0.0 && (dx < 0.0 || dy < 0.0);
  };
  std::vector<bool> onFront(x.size(), false);
  for (std::size_t k = 0; k < x.size(); ++k) {
    onFront[k] = isDefined(k);
    for (std::size_t other = 0; onFront[k] && other < x.size(); ++other) {
      onFront[k] = !isDefined(other) || !beats(other, k);
    }
  }
  return onFront;
}

Numbers composite(const std::vector<Criterion>& criteria) {
  const std::size_t options = criteria.empty() ? 0 : criteria.front().values.size();
  Numbers sums(options, 0.0);
  double weights = 0.0;
  for (const Criterion& criterion : criteria) {
    if (criterion.weight == 0.0) {
      continue;
    }
    const Numbers places = normalisedScores(criterion);
    weights += criterion.weight;
    for (std::size_t option = 0; option < options; ++option) {
      sums[option] += criterion.weight * places[option];
    }
  }
  for (double& sum : sums) {
    sum = weights > 0.0 ? sum / weights : kUndefined;
  }
  return sums;
}

}  // namespace statistics
