#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace sim2d {

/// A list that only grows. One thread appends, any number of others read what is there by then,
/// without locks: entries are never moved or changed.
template <class T>
class SharedLog {
 public:
  void append(T entry) {
    const std::size_t index = size_.load(std::memory_order_relaxed);
    const auto [block, place] = placeOf(index);
    if (!blocks_[block]) {
      blocks_[block] = std::make_unique<T[]>(kFirstBlock << block);
    }
    blocks_[block][place] = std::move(entry);
    size_.store(index + 1, std::memory_order_release);
  }
  std::size_t size() const { return size_.load(std::memory_order_acquire); }
  /// `index` below what size() has told this thread.
  const T& operator[](std::size_t index) const {
    const auto [block, place] = placeOf(index);
    return blocks_[block][place];
  }
  /// How many entries at the front hold `isBefore`, which no later one does.
  template <class IsBefore>
  std::size_t count(IsBefore isBefore) const {
    std::size_t from = 0, to = size();
    while (from < to) {
      const std::size_t middle = from + (to - from) / 2;
      (isBefore((*this)[middle]) ? from : to) = isBefore((*this)[middle]) ? middle + 1 : middle;
    }
    return from;
  }

 private:
  static constexpr std::size_t kFirstBlock = 64, kBlocks = 48;  // each twice the one before
  static std::pair<std::size_t, std::size_t> placeOf(std::size_t index) {
    std::size_t block = 0;
    for (; index >= kFirstBlock << block; ++block) {
      index -= kFirstBlock << block;
    }
    return {block, index};
  }

  std::array<std::unique_ptr<T[]>, kBlocks> blocks_;
  std::atomic<std::size_t> size_{0};
};

}  // namespace sim2d
