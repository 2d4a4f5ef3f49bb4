#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

/// The shipped scenarios with their cards and certificates, for `list scenarios`.
namespace app {

struct ListedScenario {
  std::string name;
  std::vector<std::string> columns;  // title, difficulty, certificate, path
  nlohmann::ordered_json details;    // path, card, certificate (null: none)
};

/// Sorted by name.
std::vector<ListedScenario> listedScenarios();

/// A Markdown page: a table of all scenarios by family, then each card.
std::string scenariosPage();

}  // namespace app
