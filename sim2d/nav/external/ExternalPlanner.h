#pragma once

#include <memory>
#include <string>

#include "sim2d/base/Stop.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/CodePermission.h"

/// Planners in a program of their own (PROTOCOL.md). Errors name the robot.
namespace sim2d {

struct ExternalCommand {
  std::string command;         // see `commandWords`; "unix:PATH" meets somebody at a socket
  double timeout = 5.0;        // [s], for each answer
  double firstTimeout = 30.0;  // [s], until it is ready
};

/// The program is started at once, greeted with the first observation, told at the end of the
/// planner that it is over, and then ended. The world waits for each answer; `stop` ends such a
/// wait by `base::Stopped`. Errors: those of `ExternalProcess::start`, external.not-allowed,
/// external.bad-timeout; of `command()`: those of `ExternalProcess::ask`, `readReady` and
/// `readAnswer`; after one, the program has ended, and the same comes again.
base::Result<std::shared_ptr<Planner>> makeExternalPlanner(
    const PlannerSetup& setup, const ExternalCommand& command, CodePermission permission,
    const base::StopFlagPtr& stop = std::make_shared<const base::StopFlag>());

/// What can be told without starting it: no command, an open quote, no such program, a bad time.
base::Diagnostics checkExternalCommand(const PlannerSetup& setup, const ExternalCommand& command);

}  // namespace sim2d
