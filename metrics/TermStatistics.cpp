#include "metrics/TermStatistics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace metrics {

void TermStatistics::take(const Instant& at, double term) {
  if (!std::isnan(before_)) {
    integral_ += before_ * at.step();
    time_ += at.step();
  }
  before_ = term;
  if (std::isnan(term)) {
    return;
  }
  sum_ += term;
  count_ += 1.0;
  least_ = term >= least_ ? least_ : term;
  largest_ = term <= largest_ ? largest_ : term;
}

double smallestGapTerm(const Instant& at) {
  double closest = kNaN;
  for (const Pedestrian& person : at.now.people) {
    const double space = std::max(gap(at.now.robot, person), 0.0);
    closest = space >= closest ? closest : space;
  }
  return closest;
}

double timeToCollisionTerm(const Instant& at) {
  double soonest = kNaN;
  for (const Pedestrian& person : at.now.people) {
    const double time = person.pair.timeToCollision;
    if (!std::isinf(time) && !(time >= soonest)) {
      soonest = time;
    }
  }
  return soonest;
}

/// Totals of HuNavSim's evaluator.
void PersonCosts::addToPlace(Totals& totals, std::size_t place, double cost) {
  if (place < totals.places.size()) {
    totals.places[place] += cost;
  } else {
    failed_ = true;
  }
}

void PersonCosts::add(const Instant& at) {
  const std::vector<Pedestrian>& people = at.now.people;
  for (Totals& totals : columns_) {
    if (at.before == nullptr && at.usesHunavProfile()) {
      totals.places.assign(people.size(), 0.0);
    }
  }
  sums_.assign(columns_.size(), 0.0);
  beginSample();
  for (std::size_t k = 0; k < people.size(); ++k) {
    costs_.assign(columns_.size(), 0.0);
    failed_ = !addCosts(at, people[k], costs_) || failed_;
    for (std::size_t cost = 0; cost < costs_.size(); ++cost) {
      sums_[cost] += costs_[cost];
      if (at.usesHunavProfile()) {
        addToPlace(columns_[cost], k, costs_[cost]);
      }
    }
  }
  for (std::size_t cost = 0; cost < columns_.size(); ++cost) {
    columns_[cost].samples.add(at, sums_[cost]);
  }
}

MetricValue PersonCosts::value(std::size_t cost, const Instant& last) const {
  const Totals& totals = columns_[cost];
  if (!last.usesHunavProfile()) {
    return withTerms(totals.samples);
  }
  if (failed_) {
    return undefinedValue(
        "IndexError: more people than at the start, or a position outside the map");
  }
  double sum = 0.0;
  for (const double place : totals.places) {
    sum += place;
  }
  return withSeries(sum, totals.places);
}

/// Storage of series.
namespace {

constexpr std::size_t kBlock = 512;  // numbers

}  // namespace

std::optional<SeriesStorage::Place> SeriesStorage::put(const std::vector<double>& numbers) {
  const auto* const bytes = reinterpret_cast<const char*>(numbers.data());
  return file_.append({bytes, numbers.size() * sizeof(double)});
}

bool SeriesStorage::get(const Place& place, double* numbers) {
  const bool isRead = file_.read(place, reinterpret_cast<char*>(numbers));
  failed_ = failed_ || !isRead;
  return isRead;
}

void StoredSeries::add(double number, SeriesStorage* store) {
  newest_.push_back(number);
  if (store == nullptr || newest_.size() % kBlock != 0) {
    return;
  }
  if (const std::optional<SeriesStorage::Place> place = store->put(newest_)) {
    store_ = store;
    blocks_.push_back(*place);
    stored_ += newest_.size();
    newest_.clear();
  }
}

std::vector<double> StoredSeries::all() const {
  std::vector<double> numbers(size());
  StoredSeriesReader reader(*this);
  std::generate(numbers.begin(), numbers.end(), [&reader] { return reader.next(); });
  return numbers;
}

double StoredSeriesReader::next() {
  if (at_ == block_.size()) {
    at_ = 0;
    if (nextBlock_ < numbers_.blocks_.size()) {
      const SeriesStorage::Place& block = numbers_.blocks_[nextBlock_];
      block_.assign(block.size / sizeof(double), std::numeric_limits<double>::quiet_NaN());
      numbers_.store_->get(block, block_.data());
    } else {
      block_ = numbers_.newest_;
    }
    ++nextBlock_;
  }
  return block_[at_++];
}

}  // namespace metrics
