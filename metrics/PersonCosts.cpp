#include "metrics/PersonCosts.h"

namespace metrics {

/// The original's totals.
void PersonCosts::addTo(Column& column, std::size_t place, double cost) {
  if (place < column.personTotals.size()) {
    column.personTotals[place] += cost;
  } else {
    failed_ = true;
  }
}

void PersonCosts::add(const Recording& recording, std::size_t sample) {
  const Sample& now = recording.samples[sample];
  for (Column& column : columns_) {
    column.series.push_back(0.0);
    if (sample == 0) {
      column.personTotals.assign(now.people.size(), 0.0);
    }
  }
  beginSample();
  for (std::size_t k = 0; k < now.people.size(); ++k) {
    costs_.assign(columns_.size(), 0.0);
    failed_ = !addCosts(recording, now, now.people[k], costs_) || failed_;
    for (std::size_t cost = 0; cost < costs_.size(); ++cost) {
      columns_[cost].series.back() += costs_[cost];
      if (isOriginal()) {
        addTo(columns_[cost], k, costs_[cost]);
      }
    }
  }
  for (Column& column : columns_) {
    column.sum += column.series.back();
  }
}

MetricValue PersonCosts::value(std::size_t cost) const {
  const Column& column = columns_[cost];
  if (!isOriginal()) {
    return withSeries(numberValue(column.sum), column.series);
  }
  if (failed_) {
    return undefinedValue("IndexError: more people than at first, or a place outside the map");
  }
  return withSeries(numberValue(sumOf(column.personTotals)), column.personTotals);
}

}  // namespace metrics
