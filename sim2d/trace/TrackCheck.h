#pragma once

#include "sim2d/trace/Tracks.h"

namespace sim2d {

/// Reports problems with times, positions, ids and the choice of the robot. Returns the robot;
/// null: none.
const Track* checkTracks(const TrackFile& file, const TrackOptions& options,
                         base::Diagnostics& problems);

/// Limits diagnostics to ten per kind and adds the number of omitted ones: a file read in the wrong
/// format has one per line.
base::Diagnostics limitedPerKind(const base::Diagnostics& problems);

}  // namespace sim2d
