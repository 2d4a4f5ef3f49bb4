#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim2d/trace/Tracks.h"

/// Import and export of third-party trajectories ("Third-party formats" in the README).
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

// Export of recorded runs. Errors mean that nothing can be written; other diagnostics inform the
// user.

/// JSON lines for TrajNet++: scenes, then tracks. `rate`: samples per second; 0: 2.5 as in its data
/// sets. Positions are interpolated linearly. A scene has 21 samples in which its pedestrian is
/// present throughout; robots are pedestrians with ids after those of the people.
base::Result<std::string> trajnetText(const Trace& trace, double rate = 0.0);

/// SocNav3 (SocNavData): the first robot with its goal, people, walls and the map's grid. `rate`:
/// samples per second; 0: all states. The robot's speeds are longitudinal, lateral and angular.
/// Other robots are people with ids after those of the people.
base::Result<std::string> socnav3Text(const Trace& trace, double rate = 0.0);

}  // namespace sim2d
