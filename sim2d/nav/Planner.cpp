#include "sim2d/nav/Planner.h"

#include <algorithm>
#include <filesystem>

namespace sim2d {

std::string fileParameter(const PlannerSetup& setup, const std::string& key) {
  const auto given = std::find_if(setup.texts.begin(), setup.texts.end(),
                                  [&](const auto& text) { return text.first == key; });
  return given == setup.texts.end() || given->second.empty()
             ? std::string()
             : (std::filesystem::path(setup.folder) / given->second).lexically_normal().string();
}

}  // namespace sim2d
