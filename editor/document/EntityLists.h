#pragma once

#include <algorithm>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "editor/document/Entity.h"

namespace editor {

/// The list of a scenario that holds the entities of type T.
template <class T, class S>
auto& listOf(S& scenario) {
  using List = std::conditional_t<std::is_const_v<S>, const std::vector<T>, std::vector<T>>;
  return std::get<List&>(std::tie(scenario.humans, scenario.goals, scenario.robots,
                                  scenario.obstacles, scenario.doors, scenario.areas,
                                  scenario.docks));
}

/// Calls `visitor` with the list of that kind; `otherwise` is returned for kinds without a list.
template <class S, class Visitor,
          class R = std::invoke_result_t<Visitor, decltype((std::declval<S&>().humans))>>
R withList(S& scenario, EntityKind kind, Visitor&& visitor, R otherwise = R()) {
  forEachList(scenario, [&](EntityKind each, auto& list) {
    if (each == kind) {
      otherwise = visitor(list);
    }
  });
  return otherwise;
}

template <class List>
int positionIn(const List& list, EntityId id) {
  const auto found =
      std::find_if(list.begin(), list.end(), [id](const auto& value) { return value.key == id; });
  return found == list.end() ? -1 : static_cast<int>(found - list.begin());
}

/// Nobody and nothing stands in it, and it names no map: what is left of a file of which nothing
/// could be read.
inline bool isBlank(const sim2d::Scenario& scenario) {
  bool isEmpty = true;
  forEachList(scenario,
              [&](EntityKind /*kind*/, const auto& list) { isEmpty = isEmpty && list.empty(); });
  return isEmpty && !scenario.map && !scenario.desktop.mapFile;
}

}  // namespace editor
