#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace sim2d::nav2 {

/// std::push_heap and std::pop_heap with the entry moves of libstdc++, independent of the standard
/// library. The moves determine which of several equal entries is popped first, and Nav2's planners
/// depend on libstdc++ for this. `isDearer(a, b)`: whether a is popped after b; the result may
/// change between calls, in which case the heap is not re-sorted.
template <class Entry, class IsDearer>
void siftUp(std::vector<Entry>& heap, std::size_t hole, const Entry& entry,
            const IsDearer& isDearer) {
  while (hole > 0 && isDearer(heap[(hole - 1) / 2], entry)) {
    heap[hole] = heap[(hole - 1) / 2];
    hole = (hole - 1) / 2;
  }
  heap[hole] = entry;
}

template <class Entry, class IsDearer>
void pushOnHeap(std::vector<Entry>& heap, const Entry& entry, const IsDearer& isDearer) {
  heap.push_back(entry);
  siftUp(heap, heap.size() - 1, entry, isDearer);
}

/// Precondition: the heap is not empty. The cheaper child (the right one of two equal children)
/// moves into the root, and so on down to a leaf; the last entry takes the place of that leaf and
/// sifts up.
template <class Entry, class IsDearer>
Entry popFromHeap(std::vector<Entry>& heap, const IsDearer& isDearer) {
  const Entry top = heap.front(), last = heap.back();
  heap.pop_back();
  if (heap.empty()) {
    return top;
  }
  std::size_t hole = 0;
  while (2 * hole + 1 < heap.size()) {
    std::size_t child = 2 * hole + 2;
    if (child == heap.size() || isDearer(heap[child], heap[child - 1])) {
      --child;
    }
    heap[hole] = heap[child];
    hole = child;
  }
  siftUp(heap, hole, last, isDearer);
  return top;
}

/// The open list of A*: pops the least cost first, and equal costs in the order of
/// std::priority_queue in libstdc++, which Nav2 uses.
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

/// A binary heap of nodes whose keys are stored elsewhere and may decrease while they are queued;
/// the heap is not re-sorted then. Nav2's Theta* uses std::priority_queue of pointers in this way,
/// so the order of its expansions depends on how the heap moves its entries.
class StaleHeap {
 public:
  bool isEmpty() const { return heap_.empty(); }
  void clear() { heap_.clear(); }

  /// `keyOf(node)` is the current key; the minimum is popped first.
  template <class KeyOf>
  void push(std::size_t node, const KeyOf& keyOf) {
    pushOnHeap(heap_, node, [&](std::size_t a, std::size_t b) { return keyOf(a) > keyOf(b); });
  }

  /// Precondition: the heap is not empty.
  template <class KeyOf>
  std::size_t pop(const KeyOf& keyOf) {
    return popFromHeap(heap_, [&](std::size_t a, std::size_t b) { return keyOf(a) > keyOf(b); });
  }

 private:
  std::vector<std::size_t> heap_;
};

}  // namespace sim2d::nav2
