#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace sim2d::nav2 {

/// The open list of an A*: the least cost first, among equal ones the one put in first, so that the
/// order does not hang on the standard library.
template <class Cost>
class OpenList {
 public:
  struct Entry {
    Cost cost;
    std::uint32_t order;
    std::uint32_t node;
  };

  bool isEmpty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  void clear() {
    heap_.clear();
    order_ = 0;
  }
  void push(Cost cost, std::size_t node) {
    heap_.push_back({cost, order_++, static_cast<std::uint32_t>(node)});
    std::push_heap(heap_.begin(), heap_.end(), isLater);
  }
  Entry pop() {
    std::pop_heap(heap_.begin(), heap_.end(), isLater);
    const Entry entry = heap_.back();
    heap_.pop_back();
    return entry;
  }

 private:
  static bool isLater(const Entry& a, const Entry& b) {
    return a.cost != b.cost ? a.cost > b.cost : a.order > b.order;
  }

  std::vector<Entry> heap_;
  std::uint32_t order_ = 0;
};

}  // namespace sim2d::nav2
