#include "sim2d/nav/Planner.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace sim2d {

base::ParameterSpec fileSpec(std::string help) {
  base::ParameterSpec file;
  file.key = kFileParameter;
  file.type = base::ParameterType::Text;
  file.fallback = std::string();
  file.help = std::move(help);
  return file;
}

std::string fileParameter(const PlannerSetup& setup, const std::string& key) {
  const auto given = std::find_if(setup.texts.begin(), setup.texts.end(),
                                  [&](const auto& text) { return text.first == key; });
  return given == setup.texts.end() || given->second.empty()
             ? std::string()
             : (std::filesystem::path(setup.folder) / given->second).lexically_normal().string();
}

base::Diagnostics withRobotName(const std::string& robot, base::Diagnostics problems) {
  for (base::Diagnostic& problem : problems) {
    problem = base::withContext("robot '" + robot + "'", std::move(problem));
  }
  return problems;
}

}  // namespace sim2d
