#include <memory>
#include <utility>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/ExternalPlanner.h"
#include "sim2d/nav/external/StandIn.h"

namespace sim2d {
namespace {

base::ParameterTable<ExternalCommand> externalTable() {
  base::ParameterTable<ExternalCommand> table;
  table.add(&ExternalCommand::timeout, "timeout", "s", {0.0, 3600.0, true},
            "Longest time that the program of the robot's `command` may take for an answer.");
  return table;
}

base::Result<std::shared_ptr<Planner>> makeExternal(const PlannerSetup& setup) {
  ExternalCommand command;
  externalTable().set(command, setup.parameters);
  command.command = setup.command;
  if (setup.code != CodeUse::LeftOut) {
    return makeExternalPlanner(setup, command, {setup.code == CodeUse::Allowed}, setup.stop);
  }
  const base::Diagnostics problems = checkExternalCommand(setup, command);
  if (!problems.empty()) {
    return problems;
  }
  return std::shared_ptr<Planner>(std::make_shared<StandIn>());
}

}  // namespace

void addExternal(PlannerRegistry& to);
void addExternal(PlannerRegistry& to) {
  to.add(kExternalPlanner, externalTable().specs(), makeExternal,
         "A planner of your own: a program that is asked in every step.");
}

}  // namespace sim2d
