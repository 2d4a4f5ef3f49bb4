#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace sim2d {

/// Like std::stable_sort, but a few items, as there are in most steps, need no memory.
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

/// Like `assign`, but with room for twice as many, so that growing step by step needs memory
/// seldom.
template <class Item>
void refill(std::vector<Item>& items, std::size_t count, const Item& value) {
  if (items.capacity() < count) {
    items.reserve(2 * count);
  }
  items.assign(count, value);
}

/// Like an assignment, but leaves memory alone that has the value: what nobody writes stays in the
/// caches of all processors.
template <class Item>
void writeNew(Item& place, const Item& value) {
  if (!(place == value)) {
    place = value;
  }
}

/// Gives back the memory that one unusual step, such as the first, has needed, once steps with
/// `usual` items follow it.
template <class Item>
void dropExcess(std::vector<Item>& empty, std::size_t usual) {
  constexpr std::size_t kWorthIt = 4096;
  constexpr std::size_t kMuchMore = 16;
  if (empty.capacity() > kWorthIt && empty.capacity() > kMuchMore * usual) {
    std::vector<Item> smaller;
    smaller.reserve(2 * usual);
    empty.swap(smaller);
  }
}

}  // namespace sim2d
