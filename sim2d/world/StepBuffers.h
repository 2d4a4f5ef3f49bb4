#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sim2d {

/// Like std::stable_sort, but does not allocate for few items, the common case.
template <class Item, class Less>
void sortStably(std::vector<Item>& items, Less less) {
  constexpr std::size_t kFew = 32;
  if (items.size() > kFew) {
    std::stable_sort(items.begin(), items.end(), less);
    return;
  }
  for (auto next = items.begin(); next != items.end(); ++next) {
    std::rotate(std::upper_bound(items.begin(), next, *next, less), next, next + 1);
  }
}

/// Like `assign`, but with capacity for twice as many, so that gradual growth seldom allocates.
template <class Item>
void assignWithSpare(std::vector<Item>& items, std::size_t count, const Item& value) {
  if (items.capacity() < count) {
    items.reserve(2 * count);
  }
  items.assign(count, value);
}

/// Sorts items by cell, in index order within each cell: the items of cell c are `order[start[c]]`
/// up to before `order[start[c + 1]]`. Cell -1: skipped. `next` is work memory.
inline void sortByCell(const std::vector<int>& cellOf, std::size_t cells, std::vector<int>& start,
                       std::vector<int>& next, std::vector<int>& order) {
  assignWithSpare(start, cells + 1, 0);
  for (const int cell : cellOf) {
    if (cell >= 0) {
      ++start[static_cast<std::size_t>(cell) + 1];
    }
  }
  for (std::size_t cell = 0; cell < cells; ++cell) {
    start[cell + 1] += start[cell];
  }
  assignWithSpare(next, start.size(), 0);
  std::copy(start.begin(), start.end(), next.begin());
  order.resize(static_cast<std::size_t>(start.back()));
  for (std::size_t i = 0; i < cellOf.size(); ++i) {
    if (cellOf[i] >= 0) {
      const auto cell = static_cast<std::size_t>(cellOf[i]);
      order[static_cast<std::size_t>(next[cell]++)] = static_cast<int>(i);
    }
  }
}

/// Assignment that does not write equal values, so that unchanged memory stays in the caches of all
/// processors.
template <class Item>
void assignIfChanged(Item& place, const Item& value) {
  if (!(place == value)) {
    place = value;
  }
}

/// Releases the memory that one unusual step (such as the first) needed, if following steps have
/// `usual` items.
template <class Item>
void shrinkExcess(std::vector<Item>& empty, std::size_t usual) {
  constexpr std::size_t kWorthIt = 4096;
  constexpr std::size_t kMuchMore = 16;
  if (empty.capacity() > kWorthIt && empty.capacity() > kMuchMore * usual) {
    std::vector<Item> smaller;
    smaller.reserve(2 * usual);
    empty.swap(smaller);
  }
}

}  // namespace sim2d
