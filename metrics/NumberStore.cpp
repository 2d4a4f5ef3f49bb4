#include "metrics/NumberStore.h"

#include <limits>

namespace metrics {

namespace {

constexpr std::size_t kBlock = 512;  // numbers

}  // namespace

NumberStore::NumberStore() : file_(std::tmpfile()) {}

std::optional<NumberStore::Place> NumberStore::put(const double* numbers, std::size_t count) {
  if (!file_ || std::fseek(file_.get(), end_, SEEK_SET) != 0 ||
      std::fwrite(numbers, sizeof(double), count, file_.get()) != count ||
      std::fflush(file_.get()) != 0) {
    return std::nullopt;
  }
  const Place place = end_;
  end_ += static_cast<Place>(count * sizeof(double));
  return place;
}

bool NumberStore::get(Place place, double* numbers, std::size_t count) {
  const bool isRead = file_ && std::fseek(file_.get(), place, SEEK_SET) == 0 &&
                      std::fread(numbers, sizeof(double), count, file_.get()) == count;
  failed_ = failed_ || !isRead;
  return isRead;
}

void StoredNumbers::add(double number, NumberStore* store) {
  newest_.push_back(number);
  if (store != nullptr && newest_.size() % kBlock == 0) {
    putAside(*store);
  }
}

void StoredNumbers::putAside(NumberStore& store) {
  const std::optional<NumberStore::Place> place = store.put(newest_.data(), newest_.size());
  if (place) {
    store_ = &store;
    blocks_.push_back({*place, newest_.size()});
    stored_ += newest_.size();
    newest_.clear();
  }
}

std::vector<double> StoredNumbers::all() const {
  std::vector<double> numbers(stored_, std::numeric_limits<double>::quiet_NaN());
  std::size_t at = 0;
  for (const Block& block : blocks_) {
    store_->get(block.place, numbers.data() + at, block.count);
    at += block.count;
  }
  numbers.insert(numbers.end(), newest_.begin(), newest_.end());
  return numbers;
}

double StoredNumbersReader::next() {
  if (at_ == block_.size()) {
    at_ = 0;
    if (nextBlock_ < numbers_.blocks_.size()) {
      const StoredNumbers::Block& block = numbers_.blocks_[nextBlock_];
      block_.assign(block.count, std::numeric_limits<double>::quiet_NaN());
      numbers_.store_->get(block.place, block_.data(), block.count);
    } else {
      block_ = numbers_.newest_;
    }
    ++nextBlock_;
  }
  return block_[at_++];
}

}  // namespace metrics
