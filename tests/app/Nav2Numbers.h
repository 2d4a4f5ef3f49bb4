#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"
#include "tests/nav/Nav2KeyPlaces.h"

namespace outside {

/// A number of Nav2's parameters, in a branch that declares it.
struct Nav2Number {
  std::string name;  // "smac_2d.tolerance"
  nav2keys::Place place;
  std::string key;
  const char* distro;
  bool isInteger;
};

/// In the branch jazzy, else main or humble; each where the navigator tree of the yard finds it.
inline std::vector<Nav2Number> nav2Numbers() {
  constexpr std::pair<std::size_t, const char*> kBranches[] = {
      {1, "jazzy"}, {4, "main"}, {0, "humble"}};  // columns of the table
  std::vector<Nav2Number> numbers;
  for (const auto& [component, keys] : nav2keys::declaredKeys()) {
    nav2keys::Place place = nav2keys::placesOfComponents().at(component);
    const std::string unnamed = "planner_plugins: [It]\n    It:";
    if (const std::size_t at = place.head.find(unnamed); at != std::string::npos) {
      place.head.replace(at, unnamed.size(), "planner_plugins: [GridBased]\n    GridBased:");
    }
    for (const nav2keys::DeclaredKey& key : keys) {
      const auto* const branch =
          std::find_if(std::begin(kBranches), std::end(kBranches), [&](const auto& each) {
            return base::parseDouble(key.defaults.at(each.first)).has_value();
          });
      if (branch != std::end(kBranches) && !nav2keys::isList(key.name)) {
        numbers.push_back({component + "." + key.name, place, key.name, branch->second,
                           base::parseInt(key.defaults[branch->first]).has_value()});
      }
    }
  }
  return numbers;
}

}  // namespace outside
