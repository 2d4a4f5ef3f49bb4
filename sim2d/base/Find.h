#pragma once

#include <algorithm>
#include <functional>
#include <iterator>

/// Searches in lists whose items are found by a name or an id.
namespace base {

/// The first item that satisfies the condition; null: there is none.
template <class Items, class Condition>
auto findIf(Items& items, Condition condition) -> decltype(&*std::begin(items)) {
  const auto found = std::find_if(std::begin(items), std::end(items), condition);
  return found == std::end(items) ? nullptr : &*found;
}

/// The first item whose member equals `value`; null: there is none. `member`: a pointer to a data
/// member or const method.
template <class Items, class Member, class Value>
auto findBy(Items& items, Member member, const Value& value) -> decltype(&*std::begin(items)) {
  return findIf(items, [&](const auto& each) { return std::invoke(member, each) == value; });
}

}  // namespace base
