#pragma once

#include <cstddef>
#include <vector>

namespace sim2d::nav2 {

/// A binary heap of nodes whose keys are kept elsewhere and may fall while the nodes are queued;
/// the heap is not re-sorted then. Nav2's Theta* uses std::priority_queue of pointers in this way,
/// so that the order of its expansions depends on how the heap moves its entries: push() and pop()
/// move them as libstdc++ does, with any standard library.
class StaleHeap {
 public:
  bool isEmpty() const { return heap_.empty(); }
  void clear() { heap_.clear(); }

  /// `keyOf(node)` is what the node costs now; the least is popped first.
  template <class KeyOf>
  void push(std::size_t node, const KeyOf& keyOf) {
    heap_.push_back(node);
    siftUp(heap_.size() - 1, node, keyOf);
  }

  /// The heap must not be empty.
  template <class KeyOf>
  std::size_t pop(const KeyOf& keyOf) {
    const std::size_t top = heap_.front(), last = heap_.back();
    heap_.pop_back();
    if (!heap_.empty()) {
      siftUp(emptiedLeaf(keyOf), last, keyOf);
    }
    return top;
  }

 private:
  /// Moves a node towards the root while its parent costs more.
  template <class KeyOf>
  void siftUp(std::size_t hole, std::size_t node, const KeyOf& keyOf) {
    while (hole > 0 && keyOf(heap_[(hole - 1) / 2]) > keyOf(node)) {
      heap_[hole] = heap_[(hole - 1) / 2];
      hole = (hole - 1) / 2;
    }
    heap_[hole] = node;
  }

  /// Fills the root with the cheaper child, that one's place likewise, and so on down to a leaf,
  /// which it returns. Of equal children the right one moves.
  template <class KeyOf>
  std::size_t emptiedLeaf(const KeyOf& keyOf) {
    std::size_t hole = 0;
    while (2 * hole + 1 < heap_.size()) {
      std::size_t child = 2 * hole + 2;
      if (child == heap_.size() || keyOf(heap_[child]) > keyOf(heap_[child - 1])) {
        --child;
      }
      heap_[hole] = heap_[child];
      hole = child;
    }
    return hole;
  }

  std::vector<std::size_t> heap_;
};

}  // namespace sim2d::nav2
