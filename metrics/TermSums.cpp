#include "metrics/TermSums.h"

namespace metrics {

void Figures::take(const Instant& at, double term) {
  if (!std::isnan(before_)) {
    integral_ += before_ * at.step();
    time_ += at.step();
  }
  before_ = term;
  series_.add(at, term);
  if (std::isnan(term)) {
    return;
  }
  sum_ += term;
  count_ += 1.0;
  least_ = term >= least_ ? least_ : term;
  largest_ = term <= largest_ ? largest_ : term;
}

double closestGapTerm(const Sample& sample, const MetricParameters& /*parameters*/) {
  return closestGap(sample).value_or(std::numeric_limits<double>::quiet_NaN());
}

double collisionTerm(const Sample& sample, const MetricParameters& /*parameters*/) {
  double soonest = std::numeric_limits<double>::quiet_NaN();
  for (const Person& person : sample.people) {
    const double time = person.pair.timeToCollision;
    if (!std::isinf(time) && !(time >= soonest)) {
      soonest = time;
    }
  }
  return soonest;
}

}  // namespace metrics
