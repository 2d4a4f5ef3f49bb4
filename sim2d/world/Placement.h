#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Starts and goals before a run.

/// Starts and goals, for the bounds of an open plane.
std::vector<Vec2> placesOf(const WorldModel& model);
/// Errors: coordinates that are not finite or beyond 1e6 m, goals that nobody defined.
void checkPlaces(const WorldModel& model, base::Diagnostics& problems);
/// Moves starts and goals to the nearest place within 1 m where the body fits, with a warning that
/// names both points; there is none: error. Goals of people who walk straight stay where they are.
/// Then parts starts that would stand in each other.
void fitPlaces(WorldModel& model, const NavigationMap& navigation, base::Diagnostics& problems);
/// Takes goals without a way to them off the lists, each with a warning.
void leaveOutUnreachable(WorldModel& model, const NavigationMap& navigation,
                         base::Diagnostics& problems);

// For their messages.
std::string shown(const Vec2& point);  // "(1.5, -2)", to the millimetre
base::Diagnostic about(base::Diagnostic diagnostic, EntityId entity, const std::string& where = {});
EntityId keyOfRobot(const WorldModel& model, const ResolvedRobot& robot);

}  // namespace sim2d
