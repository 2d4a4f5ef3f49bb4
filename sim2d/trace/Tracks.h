#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// One observation of a person or robot. World frame; missing quantities are estimated.
struct TrackPoint {
  double time = 0.0;  // [s]
  Vec2 position = Vec2::Zero();
  std::optional<Vec2> velocity;        // [m/s]
  std::optional<double> heading;       // [rad]
  std::optional<double> angularSpeed;  // [rad/s]
  std::optional<int> group;            // of a person; none: group of the track
  std::uint8_t state = 0;              // 1 during a reaction or social action
  int line = 0, column = 0;            // place in the source
};

/// Observations of one body, in time order.
struct Track {
  int id = 0;
  std::string name;  // name in the source, if it is not a number
  bool isRobot = false;
  std::optional<double> radius;  // [m], default 0.35
  int group = -1;
  std::vector<TrackPoint> points;
};

/// Third-party trajectories.
struct TrackFile {
  std::string file;  // as given by the user
  std::vector<Track> tracks;
  double step = 0.0;  // [s] of the time grid; 0: median time between two observations
  double lengthUnit = 1.0, timeUnit = 1.0;  // units of the source [m], [s]; points are in m and s
  bool hasFrameTimes = false;               // times are frame numbers, without a unit
  bool isSparse = false;  // points are corners of paths: long intervals are not absences
  std::vector<TraceObstacle> obstacles;  // [m]
  OccupancyGrid map;
  std::optional<TraceGoal> robotGoal;
};

struct TrackOptions {
  std::optional<int> robotId;     // track to use as the robot
  std::string robotName;          // the same by Track::name; robotId is used if none matches
  std::optional<Vec2> robotGoal;  // replaces the file's goal
  double step = 0.0;              // [s], 0: step of the file
};

constexpr double kFarthestPosition = 1e9;  // [m] from the origin; map coordinates are below 1e7
constexpr char kRecordedMap[] = "map";     // name of the map's outlines, replaced by setMap()

/// Links between a recording and its source observations.
struct TrackLinks {
  /// The source of a body's state.
  struct Link {
    std::int64_t step = 0;
    int id = 0;
    bool isRobot = false;
    std::size_t track = 0, point = 0;  // indices of the observation nearest in time
  };
  double begin = 0.0;  // source time of the first instant [s]
  std::vector<Link> links;
};

/// Lower median of the time between two observations of a body; 0: fewer than two.
double medianInterval(const std::vector<Track>& tracks);

/// Converts tracks to a recording on a uniform time grid from 0. The grid begins at most one step
/// before the first observation and is aligned with as many observations as possible (with a robot:
/// of the robot). Between observations positions, velocities and headings are interpolated
/// linearly. A body is absent after a gap longer than 5.5 steps, or than 5.5 of its own intervals
/// if it is observed less often than others (TrackSegments.h; reported as a warning). Missing
/// velocities: central differences; missing headings: direction of motion, kept while standing;
/// missing angular speeds: central differences of headings. With a robot the recording covers its
/// presence. Errors: no observations, times that do not increase, too many instants, unknown robot,
/// duplicate ids of people. Warnings: observations between the instants, and gaps in the robot's
/// track, which are interpolated as well. `links`: filled if not null.
base::Result<Trace> traceOfTracks(const TrackFile& file, const TrackOptions& options,
                                  TrackLinks* links = nullptr);

/// Adds the robot's arrival at the goal: the start of its final stay within the goal radius. No
/// event if the recording ends outside.
void addArrivalEvent(Trace& trace, const TraceGoal& goal);

/// Replaces the map: cells and outlines.
void setMap(Trace& trace, OccupancyGrid map);

}  // namespace sim2d
