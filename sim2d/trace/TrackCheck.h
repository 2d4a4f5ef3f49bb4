#pragma once

#include "sim2d/trace/Tracks.h"

namespace sim2d {

/// Adds what is wrong with times, ids and the choice of the robot. Returns the robot; null = none.
const Track* checkTracks(const TrackFile& file, const TrackOptions& options,
                         base::Diagnostics& problems);

/// Of each kind of problem the first ten, and how many more there are: a file that is read as what
/// it is not has one in each line.
base::Diagnostics shortened(const base::Diagnostics& problems);

}  // namespace sim2d
