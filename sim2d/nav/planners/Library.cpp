#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/LibraryPlanner.h"

namespace sim2d {
namespace {

std::vector<base::ParameterSpec> librarySpecs() {
  base::ParameterSpec file;
  file.key = "file";
  file.type = base::ParameterType::Text;
  file.fallback = std::string();
  file.help = "Shared library that plans (hunavsim_planner.h); needs permission to run code.";
  return {file};
}

base::Result<std::shared_ptr<Planner>> makeLibrary(const PlannerSetup& setup) {
  std::string file;
  for (const auto& [name, text] : setup.texts) {
    file = name == "file" ? text : file;
  }
  return makeLibraryPlanner(setup, file, {setup.allowCode});
}

}  // namespace

void addLibrary(PlannerRegistry& to);
void addLibrary(PlannerRegistry& to) {
  to.add("library", librarySpecs(), makeLibrary);
}

}  // namespace sim2d
