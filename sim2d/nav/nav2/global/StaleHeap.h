#pragma once

#include <cstddef>
#include <vector>

#include "sim2d/nav/nav2/global/HeapMoves.h"

namespace sim2d::nav2 {

/// A binary heap of nodes whose keys are kept elsewhere and may fall while the nodes are queued;
/// the heap is not re-sorted then. Nav2's Theta* uses std::priority_queue of pointers in this way,
/// so that the order of its expansions depends on how the heap moves its entries.
class StaleHeap {
 public:
  bool isEmpty() const { return heap_.empty(); }
  void clear() { heap_.clear(); }

  /// `keyOf(node)` is what the node costs now; the least is popped first.
  template <class KeyOf>
  void push(std::size_t node, const KeyOf& keyOf) {
    pushOnHeap(heap_, node, [&](std::size_t a, std::size_t b) { return keyOf(a) > keyOf(b); });
  }

  /// The heap must not be empty.
  template <class KeyOf>
  std::size_t pop(const KeyOf& keyOf) {
    return popFromHeap(heap_, [&](std::size_t a, std::size_t b) { return keyOf(a) > keyOf(b); });
  }

 private:
  std::vector<std::size_t> heap_;
};

}  // namespace sim2d::nav2
