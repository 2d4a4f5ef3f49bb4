#pragma once

#include <memory>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/StopFlag.h"
#include "sim2d/nav/Planner.h"

/// Planners in external programs (PROTOCOL.md). Errors contain the robot's name.
namespace sim2d {

struct ExternalCommand {
  std::string command;         // see `splitCommandLine`; "unix:PATH" connects to a socket
  double timeout = 5.0;        // [s], per answer
  double firstTimeout = 30.0;  // [s], until the program is ready
};

/// Starts the program immediately, sends the greeting with the first observation and the end line
/// when the planner is destroyed, and then ends the program. The simulation blocks on each answer;
/// `setup.stop` interrupts this with `base::Stopped`. Errors: those of `ExternalProcess::start`,
/// external.not-allowed, external.bad-timeout; of `command()`: those of `ExternalProcess::ask`,
/// `readReady` and `readAnswer`. After an error the program has ended and each call returns the
/// same error.
base::Result<std::shared_ptr<Planner>> makeExternalPlanner(const PlannerSetup& setup,
                                                           const ExternalCommand& command);

/// Checks that do not start the program: no command, an open quote, missing program, invalid
/// timeout.
base::Diagnostics checkExternalCommand(const PlannerSetup& setup, const ExternalCommand& command);

/// The lines of PROTOCOL.md: JSON, one object per line, without line ending. Numbers have the
/// shortest form that reads back equal. Thread-safe.

/// Walls of the enabled parts: closed outlines, the solid on the left of each edge [m].
std::vector<const Outline*> enabledOutlines(const Obstacles& obstacles);

/// First line: the robot, the time step, the seed and the walls.
std::string greetingLine(const PlannerSetup& setup, const Observation& observation);

struct ObservationParts {
  bool walls = false;  // a door has moved since they were sent
  bool scan = false;   // there is a new scan
};
std::string observationLine(const Observation& observation, const ObservationParts& parts);
std::string endLine(const std::string& reason);

/// Parses the answer to the greeting; returns the planner's name, or an empty string. Errors:
/// external.not-json, external.not-ready, external.complaint.
base::Result<std::string> readReady(const std::string& line);

struct ExternalAnswer {
  BodyTwist twist;
  std::vector<Vec2> path;  // [m], for display
};
/// Unknown keys are ignored. Errors: external.not-json, external.complaint, external.no-key,
/// external.no-number, external.bad-path.
base::Result<ExternalAnswer> readAnswer(const std::string& line);

}  // namespace sim2d
