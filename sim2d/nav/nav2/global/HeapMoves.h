#pragma once

#include <cstddef>
#include <vector>

namespace sim2d::nav2 {

/// std::push_heap and std::pop_heap, which move entries as libstdc++ does with any standard
/// library. Of equal entries it depends on these moves which one is popped first, and Nav2's
/// planners leave that to libstdc++. `isDearer(a, b)`: whether a is popped after b; it may change
/// between calls, in which case the heap is not re-sorted.
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

/// The heap must not be empty. The cheaper child moves into the root, one of its children into its
/// place and so on down to a leaf, the right one of two equal children; the last entry takes the
/// place of that leaf and moves up from there.
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

}  // namespace sim2d::nav2
