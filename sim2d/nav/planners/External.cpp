#include <string>
#include <utility>
#include <vector>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/ExternalPlanner.h"

namespace sim2d {
namespace {

std::vector<base::ParameterSpec> externalSpecs() {
  base::ParameterSpec command;
  command.key = "command";
  command.type = base::ParameterType::Text;
  command.fallback = std::string();
  command.help =
      "Program that plans, with its arguments, or unix:PATH for a local socket; needs permission "
      "to run code.";
  base::ParameterSpec timeout;
  timeout.key = "timeout";
  timeout.unit = "s";
  timeout.range = {0.0, 3600.0, true};
  timeout.fallback = ExternalCommand().timeout;
  timeout.help = "Longest time that the program may take for an answer.";
  return {command, timeout};
}

base::Result<std::shared_ptr<Planner>> makeExternal(const PlannerSetup& setup) {
  ExternalCommand command;
  for (const auto& [name, value] : setup.parameters) {
    command.timeout = name == "timeout" ? value : command.timeout;
  }
  for (const auto& [name, text] : setup.texts) {
    command.command = name == "command" ? text : command.command;
  }
  return makeExternalPlanner(setup, command, {setup.allowCode});
}

}  // namespace

void addExternal(PlannerRegistry& to);
void addExternal(PlannerRegistry& to) {
  to.add("external", externalSpecs(), makeExternal);
}

}  // namespace sim2d
