#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/trace/Trace.h"

namespace sim2d {

/// One observation of a person or a robot. World frame; what the source does not tell is estimated.
struct TrackPoint {
  double time = 0.0;  // [s]
  Vec2 position = Vec2::Zero();
  std::optional<Vec2> velocity;        // [m/s]
  std::optional<double> heading;       // [rad]
  std::optional<double> angularSpeed;  // [rad/s]
  std::optional<int> group;            // of a person; none: that of the track
  std::uint8_t state = 0;              // 1 while a reaction or social action runs
  int line = 0, column = 0;            // where it stands in the source
};

/// The way of one body, in time order.
struct Track {
  int id = 0;
  std::string name;  // the word that the source has for it, if that is no number
  bool isRobot = false;
  std::optional<double> radius;  // [m], 0.35 where it is not told
  int group = -1;
  std::vector<TrackPoint> points;
};

/// Ways of people as another program recorded them.
struct TrackFile {
  std::string file;  // as the user named it
  std::vector<Track> tracks;
  double step = 0.0;  // [s] of our time grid; 0 = the median time between two observations
  double lengthUnit = 1.0, timeUnit = 1.0;  // of the source [m], [s]; the points are in m and s
  bool isByFrames = false;                  // the source counts frames: no unit of time
  bool isSparse = false;  // points are corners of ways: a long time between two is no absence
  std::vector<TraceObstacle> obstacles;  // [m]
  OccupancyGrid map;
  std::optional<TraceGoal> robotGoal;
};

struct TrackOptions {
  std::optional<int> robotId;     // this person becomes the robot
  std::string robotName;          // the same by its Track::name; without a match robotId counts
  std::optional<Vec2> robotGoal;  // instead of the file's
  double step = 0.0;              // [s], 0 = the file's
};

constexpr char kRecordedMap[] = "map";  // name of the outlines that setMap() replaces

/// The observations from which a record was made.
struct TrackLinks {
  /// The source of a body at an instant.
  struct Link {
    std::int64_t step = 0;
    int id = 0;
    bool isRobot = false;
    std::size_t track = 0, point = 0;  // places of the observation that is nearest in time
  };
  double begin = 0.0;  // time of the first instant in the source [s]
  std::vector<Link> links;
};

/// Median time between two observations of a body, the lower of two; 0 when there are no two.
double medianInterval(const std::vector<Track>& tracks);

/// A record on an even time grid from 0, which begins at most a step before the first observation
/// and so that it meets the most of them (with a robot: of the robot's). Between two
/// observations of a body: straight line, velocities and headings interpolated. A body is away
/// while nothing was seen of it for longer than 5.5 steps, or 5.5 of its own intervals where it is
/// observed more seldom than others (TrackRates.h, which is told). Velocities that are not told:
/// central differences of the observations; headings: the direction of walking, kept while
/// standing; turning speeds: central differences of the headings. With a robot the record spans its
/// presence. Problems: no observation, time that does not advance, a step that makes too many
/// instants, an unknown robot, two people of one id; told are observations between the instants and
/// gaps in the robot's way, which are straight lines too.
/// `links`: filled in where it is not null.
base::Result<Trace> traceOfTracks(const TrackFile& file, const TrackOptions& options,
                                  TrackLinks* links = nullptr);

/// Adds the arrival of the robot at the goal: the first instant of a stay inside it, by the rule of
/// the world, that lasts to the end. Nothing when the record ends outside.
void noteArrival(Trace& trace, const TraceGoal& goal);

/// Replaces the map of a record: cells and outlines.
void setMap(Trace& trace, OccupancyGrid map);

}  // namespace sim2d
