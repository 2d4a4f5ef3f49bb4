#pragma once

#include <string>
#include <vector>

#include "sim2d/base/ParameterSpec.h"
#include "sim2d/base/Registry.h"

/// Planners and models as a Markdown page: a section each, with a table of parameters.
namespace app {

struct PageSection {
  std::string name;
  std::string help;  // a sentence or two
  std::vector<base::ParameterSpec> parameters;
};

/// Markdown. `key`: the map of a scenario that contains the parameters.
std::string parameterPage(const std::string& title, const std::string& key,
                          const std::vector<PageSection>& sections);

template <class Maker>
std::vector<PageSection> pageSections(const base::Registry<Maker>& registry) {
  std::vector<PageSection> sections;
  sections.reserve(registry.entries().size());
  for (const auto& entry : registry.entries()) {
    sections.push_back({entry.name, entry.help, entry.parameters});
  }
  return sections;
}

}  // namespace app
