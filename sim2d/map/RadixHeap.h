#pragma once

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace sim2d {

/// Priority queue for keys that never fall below the last one taken (Ahuja et al. 1990), as in
/// Dijkstra's search. Entries of one key come out in an order that depends on the history only.
class RadixHeap {
 public:
  using Entry = std::pair<std::uint32_t, std::int32_t>;  // key, value

  bool isEmpty() const { return size_ == 0; }

  void push(std::uint32_t key, std::int32_t value) {
    assert(key >= last_);
    buckets_[bucketOf(key)].emplace_back(key, value);
    ++size_;
  }

  Entry pop() {
    assert(!isEmpty());
    if (buckets_[0].empty()) {
      refill();
    }
    const Entry entry = buckets_[0].back();
    buckets_[0].pop_back();
    --size_;
    return entry;
  }

 private:
  /// Number of the highest bit in which the key differs from the last one, counted from 1.
  std::size_t bucketOf(std::uint32_t key) const {
    const std::uint32_t difference = key ^ last_;
    return difference == 0 ? 0U : 32U - static_cast<std::size_t>(__builtin_clz(difference));
  }

  void refill() {
    std::size_t first = 1;
    while (buckets_[first].empty()) {
      ++first;
    }
    spare_.swap(buckets_[first]);
    last_ = std::min_element(spare_.begin(), spare_.end())->first;
    for (const Entry& entry : spare_) {
      buckets_[bucketOf(entry.first)].push_back(entry);
    }
    spare_.clear();
  }

  std::array<std::vector<Entry>, 33> buckets_;
  std::vector<Entry> spare_;
  std::uint32_t last_ = 0;
  std::size_t size_ = 0;
};

}  // namespace sim2d
