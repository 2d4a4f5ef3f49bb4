#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <utility>

namespace sim2d {

/// Append-only list for one writer and any number of readers, without locks: entries never move or
/// change.
template <class T>
class AppendOnlyLog {
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
  /// `index` must be below a size() that this thread has read.
  const T& operator[](std::size_t index) const {
    const auto [block, place] = placeOf(index);
    return blocks_[block][place];
  }
  /// Number of leading entries that satisfy `isBefore`; it must hold for a prefix of the list only.
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
  static constexpr std::size_t kFirstBlock = 64, kBlocks = 48;  // block sizes double
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
