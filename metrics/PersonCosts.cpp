#include "metrics/PersonCosts.h"

namespace metrics {

void PersonCosts::add(const Recording& recording, std::size_t sample) {
  const Sample& now = recording.samples[sample];
  if (sample == 0) {
    personTotals_.assign(now.people.size(), 0.0);
  }
  beginSample();
  double sum = 0.0;
  for (std::size_t k = 0; k < now.people.size(); ++k) {
    const std::optional<double> cost = costOf(recording, now, now.people[k]);
    failed_ = failed_ || !cost || k >= personTotals_.size();
    sum += cost.value_or(0.0);
    if (k < personTotals_.size()) {
      personTotals_[k] += cost.value_or(0.0);
    }
  }
  series_.push_back(sum);
  sum_ += sum;
}

MetricValue PersonCosts::value(const Recording& /*recording*/) const {
  if (!isOriginal()) {
    return withSeries(numberValue(sum_), series_);
  }
  if (failed_) {
    return undefinedValue("IndexError: more people than at first, or a place outside the map");
  }
  return withSeries(numberValue(sumOf(personTotals_)), personTotals_);
}

}  // namespace metrics
