#pragma once

#include <map>
#include <string>
#include <vector>

#include "sim2d/trace/Tracks.h"

/// Trajectories that other programs and data sets hold ("Formats of others" in the README).
namespace sim2d {

class TrackFormats;

/// Those of this program, one file each in formats/.
const TrackFormats& standardTrackFormats();
std::vector<std::string> trackFormatNames();  // "csv", "eth" …

struct ForeignOptions {
  std::string format;                          // empty: by name and first line of the file
  std::map<std::string, std::string> columns;  // ours -> name in the file
  double framesPerSecond = 0.0;                // 0: see the README
  double lengthUnit = 0.0;                     // [m] of positions; 0: that of the format
  double timeUnit = 0.0;                       // [s] of times; 0: that of the format
  bool degrees = false;                        // headings and turning speeds
  double radius = 0.0;                         // [m] of everybody; 0: what the file says
};

/// The file is an SQLite database with the trajectories of JuPedSim (not a bag of rosbag2).
bool isTrajectoryDatabase(const std::string& path);

/// "time=t,id=ped"; unknown names of ours and pairs without '=' are errors.
base::Result<std::map<std::string, std::string>> parseColumns(const std::string& text);

/// Reads the file and what lies beside it (`H.txt`, `groups.txt`). All problems, with their places.
base::Result<TrackFile> readForeign(const std::string& path, const ForeignOptions& options,
                                    const TrackFormats& formats = standardTrackFormats());

}  // namespace sim2d
