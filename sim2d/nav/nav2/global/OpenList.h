#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "sim2d/nav/nav2/global/HeapMoves.h"

namespace sim2d::nav2 {

/// The open list of an A*: the least cost first, equal costs in the order that Nav2's
/// std::priority_queue has with libstdc++.
template <class Cost>
class OpenList {
 public:
  struct Entry {
    Cost cost;
    std::uint32_t node;
  };

  bool isEmpty() const { return heap_.empty(); }
  std::size_t size() const { return heap_.size(); }
  void clear() { heap_.clear(); }
  void push(Cost cost, std::size_t node) {
    pushOnHeap(heap_, Entry{cost, static_cast<std::uint32_t>(node)}, isDearer);
  }
  Entry pop() { return popFromHeap(heap_, isDearer); }

 private:
  static bool isDearer(const Entry& a, const Entry& b) { return a.cost > b.cost; }

  std::vector<Entry> heap_;
};

}  // namespace sim2d::nav2
