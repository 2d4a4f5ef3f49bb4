#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim2d/trace/Tracks.h"

/// Import of third-party trajectories ("Third-party formats" in the README).
namespace sim2d {

class TrackFormats;

/// The built-in formats, one file each in formats/.
const TrackFormats& standardTrackFormats();
std::vector<std::string> trackFormatNames();  // "csv", "eth" …

struct TrackImportOptions {
  std::string format;                          // empty: detected by name and content
  std::map<std::string, std::string> columns;  // quantity -> column name in the file
  double framesPerSecond = 0.0;                // 0: see the README
  double lengthUnit = 0.0;                     // [m] per unit of length; 0: as in the format
  double timeUnit = 0.0;                       // [s] per unit of time; 0: as in the format
  bool degrees = false;                        // headings and angular speeds are in degrees
  double radius = 0.0;                         // [m] of all bodies; 0: as in the file
};

/// Whether the file is an SQLite database with JuPedSim trajectories (not a rosbag2 file).
bool isTrajectoryDatabase(const std::string& path);

/// Parses "time=t,id=ped"; unknown quantities and pairs without '=' are errors.
base::Result<std::map<std::string, std::string>> parseColumns(const std::string& text);

/// Reads the file and its companion files (`H.txt`, `groups.txt`); reports all problems with their
/// places.
base::Result<TrackFile> importTracks(const std::string& path, const TrackImportOptions& options,
                                     const TrackFormats& formats = standardTrackFormats());

}  // namespace sim2d
