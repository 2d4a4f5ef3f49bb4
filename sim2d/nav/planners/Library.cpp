#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/LibraryPlanner.h"
#include "sim2d/nav/external/StandIn.h"

namespace sim2d {
namespace {

constexpr const char* kLibraryFile = "file";

std::vector<base::ParameterSpec> librarySpecs() {
  base::ParameterSpec file;
  file.key = kLibraryFile;
  file.type = base::ParameterType::Text;
  file.fallback = std::string();
  file.help =
      "Shared library that plans (hunavsim_planner.h), relative to the scenario; needs permission "
      "to run code.";
  return {file};
}

/// What can be told without loading it.
base::Result<std::shared_ptr<Planner>> makeStandIn(const PlannerSetup& setup,
                                                   const std::string& file) {
  std::error_code ignored;
  if (file.empty() || !std::filesystem::exists(file, ignored)) {
    return base::within(
        "robot '" + setup.robot + "'",
        file.empty() ? base::error("library.no-file") : base::error("library.not-there", {file}));
  }
  return std::shared_ptr<Planner>(std::make_shared<StandIn>());
}

base::Result<std::shared_ptr<Planner>> makeLibrary(const PlannerSetup& setup) {
  const std::string file = fileOf(setup, kLibraryFile);
  if (setup.code == CodeUse::LeftOut) {
    return makeStandIn(setup, file);
  }
  const bool isPlain = !file.empty() && file.find('/') == std::string::npos;  // not the system's
  return makeLibraryPlanner(setup, isPlain ? "./" + file : file, {setup.code == CodeUse::Allowed});
}

}  // namespace

void addLibrary(PlannerRegistry& to);
void addLibrary(PlannerRegistry& to) {
  to.add(kLibraryPlanner, librarySpecs(), makeLibrary,
         "A planner of your own, in a shared library.");
}

}  // namespace sim2d
