#pragma once

#include "sim2d/map/NavigationMap.h"
#include "sim2d/world/WorldState.h"

namespace sim2d {

/// Moves starts of people as the scenario's `variation` draws them, after `fitPlaces`. A drawn
/// place is taken when the straight way to it keeps a body's room to walls, and when nobody is
/// nearer to other people or robots for it than bodies need or the scenario has them; else it is
/// drawn again, and after some trials the person stays where the scenario says. Robots that are
/// switched off keep people away too, so that a run without its robot has the same people; so do
/// all robots of usual size alike. By ascending id.
void varyStarts(const Scenario& scenario, const NavigationMap& navigation, WorldModel& model);

}  // namespace sim2d
