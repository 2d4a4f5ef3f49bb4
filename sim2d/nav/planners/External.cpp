#include <memory>
#include <utility>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/ExternalPlanner.h"

namespace sim2d {
namespace {

base::ParameterTable<ExternalCommand> externalTable() {
  base::ParameterTable<ExternalCommand> table;
  table.add(&ExternalCommand::timeout, "timeout", "s", {0.0, 3600.0, true},
            "Maximum response time of the program in the robot's `command`.");
  return table;
}

base::Result<std::shared_ptr<Planner>> makeExternal(const PlannerSetup& setup) {
  ExternalCommand command;
  externalTable().set(command, setup.parameters);
  command.command = setup.command;
  if (setup.code != ExternalCodePolicy::Skipped) {
    return makeExternalPlanner(setup, command, {setup.code == ExternalCodePolicy::Allowed},
                               setup.stop);
  }
  const base::Diagnostics problems = checkExternalCommand(setup, command);
  if (!problems.empty()) {
    return problems;
  }
  return std::shared_ptr<Planner>(std::make_shared<IdlePlanner>());
}

}  // namespace

void addExternal(PlannerRegistry& to);
void addExternal(PlannerRegistry& to) {
  to.add(kExternalPlanner, externalTable().specs(), makeExternal,
         "An external planner: a program that is called in every time step.");
}

}  // namespace sim2d
