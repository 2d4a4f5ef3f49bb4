#pragma once

#include <string>

#include "sim2d/trace/Trace.h"

/// Recorded runs as files of other programs. Errors: nothing can be written. Other diagnostics are
/// for the user.
namespace sim2d {

/// Lines of JSON for TrajNet++: scenes, then tracks. `rate`: samples per second, 0: 2.5 as in its
/// data sets; positions between two states are interpolated linearly. A scene is 21 samples in
/// which its pedestrian is present throughout; robots are pedestrians whose ids follow those of the
/// people.
base::Result<std::string> trajnetText(const Trace& trace, double rate = 0.0);

/// SocNav3 (SocNavData): the first robot with its goal, the people, walls, the grid of the map.
/// `rate`: samples per second, 0: all states. The robot's speeds are along its heading, across and
/// turning. Other robots are people whose ids follow those of the people.
base::Result<std::string> socnav3Text(const Trace& trace, double rate = 0.0);

}  // namespace sim2d
