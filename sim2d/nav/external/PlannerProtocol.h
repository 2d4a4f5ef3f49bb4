#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/nav/Planner.h"

/// The lines of PROTOCOL.md: JSON, one object per line, without the line's end. Numbers are the
/// shortest that read back equal. Thread: any.
namespace sim2d {

/// The walls that stand: closed outlines, the solid on the left of each edge [m].
std::vector<const Outline*> standingOutlines(const Obstacles& obstacles);

/// What comes first: the robot, the step, the seed and the walls.
std::string greetingLine(const PlannerSetup& setup, const Observation& observation);

struct ObservationParts {
  bool walls = false;  // doors have moved since they were sent
  bool scan = false;   // there is a new one
};
std::string observationLine(const Observation& observation, const ObservationParts& parts);
std::string endLine(const std::string& reason);

/// The answer to the greeting; gives the planner's name, empty when it tells none. Errors:
/// external.not-json, external.not-ready, external.complaint.
base::Result<std::string> readReady(const std::string& line);

struct ExternalAnswer {
  BodyTwist twist;
  std::vector<Vec2> path;  // [m], for display
};
/// Keys that it does not know are ignored. Errors: external.not-json, external.complaint,
/// external.no-key, external.no-number, external.bad-path.
base::Result<ExternalAnswer> readAnswer(const std::string& line);

}  // namespace sim2d
