#include "app/studies/Tuner.h"

namespace app {

namespace {

constexpr double kFirstSigma = 0.2;  // of the range of a parameter

}  // namespace

TunedValues Tuner::valuesAt(const Point& point) const {
  TunedValues values = base_;
  for (std::size_t k = 0; k < point.size(); ++k) {
    values[varied_[k]] = subject_.parameters()[varied_[k]].textAt(point[k]);
  }
  return values;
}

base::Diagnostics Tuner::search() {
  show("search");
  result_.varied = varied_;
  RestartedCmaEs::Options of;
  for (const std::size_t k : varied_) {
    of.start.push_back(subject_.parameters()[k].shareOf(baseNumber(k)));
  }
  of.sigma = kFirstSigma;
  of.population = options_.population;
  of.seed = options_.searchSeed;
  RestartedCmaEs cma(of);
  while (canAfford(raceCost(searchRungs(cma.ask().size())))) {
    base::Diagnostics problems = searchGeneration(cma);
    if (!problems.empty()) {
      return problems;
    }
    means_.push_back(valuesAt(cma.mean()));
  }
  return {};
}

base::Diagnostics Tuner::searchGeneration(RestartedCmaEs& cma) {
  std::vector<TunedValues> values;
  for (const Point& point : cma.ask()) {
    values.push_back(valuesAt(point));
    tried_.emplace_back(values.back(), result_.generations);
  }
  const base::Result<std::vector<std::size_t>> order =
      race(values, searchRungs(values.size()), newRuns(searchRuns()));
  if (!order) {
    return order.diagnostics();
  }
  std::vector<double> ranks(values.size());
  for (std::size_t k = 0; k < order->size(); ++k) {
    ranks[(*order)[k]] = static_cast<double>(k);
  }
  cma.tell(ranks);
  ++result_.generations;
  return {};
}

}  // namespace app
