#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/LibraryPlanner.h"

namespace sim2d {
namespace {

constexpr const char* kLibraryFile = "file";

std::vector<base::ParameterSpec> librarySpecs() {
  base::ParameterSpec file;
  file.key = kLibraryFile;
  file.type = base::ParameterType::Text;
  file.fallback = std::string();
  file.help =
      "Shared library of the planner (hunavsim_planner.h), relative to the scenario; needs "
      "permission to run code.";
  return {file};
}

/// Checks that do not require loading the library.
base::Result<std::shared_ptr<Planner>> makeIdlePlanner(const PlannerSetup& setup,
                                                       const std::string& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) {
    return base::withContext(
        "robot '" + setup.robot + "'",
        file.empty() ? base::error("library.no-file") : base::error("library.not-there", {file}));
  }
  return std::shared_ptr<Planner>(std::make_shared<IdlePlanner>());
}

base::Result<std::shared_ptr<Planner>> makeLibrary(const PlannerSetup& setup) {
  const std::string file = fileParameter(setup, kLibraryFile);
  if (setup.code == ExternalCodePolicy::Skipped) {
    return makeIdlePlanner(setup, file);
  }
  const bool isPlain = !file.empty() && file.find('/') == std::string::npos;  // not a system path
  return makeLibraryPlanner(setup, isPlain ? "./" + file : file,
                            {setup.code == ExternalCodePolicy::Allowed});
}

}  // namespace

void addLibrary(PlannerRegistry& to);
void addLibrary(PlannerRegistry& to) {
  to.add(kLibraryPlanner, librarySpecs(), makeLibrary, "An external planner in a shared library.");
}

}  // namespace sim2d
