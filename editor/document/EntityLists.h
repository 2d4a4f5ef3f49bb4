#pragma once

#include <algorithm>
#include <type_traits>
#include <utility>
#include <vector>

#include "editor/document/Entity.h"

namespace editor {

/// Has a name and can be switched off; goals have numbers and always take part.
template <class T>
constexpr bool kIsNamed =
    !std::is_same_v<T, sim2d::GlobalGoal> && !std::is_same_v<T, ScenarioSettings>;

/// The list of a scenario that holds the entities of type T.
template <class T, class S>
auto& listOf(S& scenario) {
  if constexpr (std::is_same_v<T, sim2d::Human>) {
    return scenario.humans;
  } else if constexpr (std::is_same_v<T, sim2d::Robot>) {
    return scenario.robots;
  } else if constexpr (std::is_same_v<T, sim2d::GlobalGoal>) {
    return scenario.goals;
  } else if constexpr (std::is_same_v<T, sim2d::Obstacle>) {
    return scenario.obstacles;
  } else if constexpr (std::is_same_v<T, sim2d::Door>) {
    return scenario.doors;
  } else {
    static_assert(std::is_same_v<T, sim2d::Area>);
    return scenario.areas;
  }
}

/// Calls `visitor` with the list of that kind; `otherwise` is returned for kinds without a list.
template <class S, class Visitor, class R>
R withList(S& scenario, EntityKind kind, Visitor&& visitor, R otherwise) {
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
