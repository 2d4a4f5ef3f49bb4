#pragma once

#include <string>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Frame.h"

namespace sim2d {

struct TraceGoal {
  int id = 0;  // of the global goal, 0 = a plain point
  Vec2 position = Vec2::Zero();
  double radius = 0.3;  // [m]
};

struct TraceHuman {
  int id = 0;
  std::string name, kind, model;
  double radius = 0.35, mass = 80.0, desiredSpeed = 1.0;
  int group = -1;
  int behavior = 1;       // 1..6
  int configuration = 0;  // 0..3
  bool cyclicGoals = true;
  std::vector<TraceGoal> goals;
  std::vector<std::pair<std::string, double>> parameters;  // all resolved numbers, by their keys
};

struct TraceRobot {
  int id = -1;
  std::string name, type, planner;
  double radius = 0.35, mass = 50.0;
  double maxVel = 1.0, maxAcc = 1.0, maxOmega = 1.5, maxAlpha = 3.0;
  double startTime = 0.0;
  std::vector<TraceGoal> goals;
  std::vector<Vec2> footprint;  // robot frame; empty = disc
};

struct TraceObstacle {
  std::string name;  // "map", or of the obstacle or door
  bool isDoor = false;
  bool open = false;              // door at the start
  std::vector<double> toggles;    // [s]
  std::vector<Outline> outlines;  // solid on the left
};

/// What metrics need beside the trajectory.
struct TraceHeader {
  int format = 1;
  std::string scenario;  // name
  double dt = 0.05;      // [s]
  int recordEvery = 1;   // steps
  long long seed = 1;
  std::vector<TraceHuman> humans;
  std::vector<TraceRobot> robots;
  std::vector<TraceObstacle> obstacles;
  std::string obstaclePoints = "boundary";
  OccupancyGrid map;
};

/// A recorded run.
struct Trace {
  TraceHeader header;
  std::vector<Frame> frames;  // every recordEvery-th step from step 0
  std::vector<std::pair<std::int64_t, Event>> events;  // all, also of steps not recorded
};

/// The files of a run folder (columns: desktop formats in FORMAT.md). Text, equal bytes for equal
/// runs.
std::string trajectoryCsv(const Trace& trace);
std::string eventsCsv(const Trace& trace);
std::string traceJson(const TraceHeader& header);
/// Reads trajectory.csv, events.csv and trace.json of a run folder.
base::Result<Trace> readTrace(const std::string& directory);
/// FNV-1a over the bytes of trajectory.csv and events.csv.
std::uint64_t hashOf(const Trace& trace);

}  // namespace sim2d
