#include "metrics/Instant.h"

#include <limits>

namespace metrics {

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
