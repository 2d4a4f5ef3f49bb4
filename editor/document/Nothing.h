#pragma once

#include "sim2d/scenario/Scenario.h"

namespace editor {

/// Nobody and nothing stands in it, and it names no map: what is left of a file of which nothing
/// could be read.
inline bool isNothing(const sim2d::Scenario& scenario) {
  return scenario.humans.empty() && scenario.goals.empty() && scenario.robots.empty() &&
         scenario.obstacles.empty() && scenario.doors.empty() && scenario.areas.empty() &&
         !scenario.map && !scenario.desktop.mapFile;
}

}  // namespace editor
