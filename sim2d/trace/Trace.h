#pragma once

#include <string>
#include <tuple>
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
  friend bool operator==(const TraceGoal& a, const TraceGoal& b) {
    return std::tie(a.id, a.position, a.radius) == std::tie(b.id, b.position, b.radius);
  }
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
  friend bool operator==(const TraceHuman& a, const TraceHuman& b) {
    return std::tie(a.id, a.name, a.kind, a.model, a.radius, a.mass, a.desiredSpeed, a.group,
                    a.behavior, a.configuration, a.cyclicGoals, a.goals, a.parameters) ==
           std::tie(b.id, b.name, b.kind, b.model, b.radius, b.mass, b.desiredSpeed, b.group,
                    b.behavior, b.configuration, b.cyclicGoals, b.goals, b.parameters);
  }
};

struct TraceRobot {
  int id = -1;
  std::string name, type, planner;
  double radius = 0.35, mass = 50.0;
  double maxVel = 1.0, maxAcc = 1.0, maxOmega = 1.5, maxAlpha = 3.0;
  double startTime = 0.0;
  std::vector<TraceGoal> goals;
  std::vector<Vec2> footprint;  // robot frame; empty = disc
  friend bool operator==(const TraceRobot& a, const TraceRobot& b) {
    return std::tie(a.id, a.name, a.type, a.planner, a.radius, a.mass, a.maxVel, a.maxAcc,
                    a.maxOmega, a.maxAlpha, a.startTime, a.goals, a.footprint) ==
           std::tie(b.id, b.name, b.type, b.planner, b.radius, b.mass, b.maxVel, b.maxAcc,
                    b.maxOmega, b.maxAlpha, b.startTime, b.goals, b.footprint);
  }
};

struct TraceObstacle {
  std::string name;  // "map", or of the obstacle or door
  bool isDoor = false;
  bool open = false;              // door at the start
  std::vector<double> toggles;    // [s]
  std::vector<Outline> outlines;  // solid on the left
  friend bool operator==(const TraceObstacle& a, const TraceObstacle& b) {
    return std::tie(a.name, a.isDoor, a.open, a.toggles, a.outlines) ==
           std::tie(b.name, b.isDoor, b.open, b.toggles, b.outlines);
  }
};

/// What the scenario says about its metrics.
struct TraceMetrics {
  std::string from = "begin", until = "end";  // window
  double frequency = 0.0;                     // [Hz], 0 = every sample
  std::string tag = "exp_1";
  int runId = 0;
  std::string selection;  // text of a metrics.yaml; empty = all metrics
  std::vector<std::pair<std::string, double>> parameters;
  friend bool operator==(const TraceMetrics& a, const TraceMetrics& b) {
    return std::tie(a.from, a.until, a.frequency, a.tag, a.runId, a.selection, a.parameters) ==
           std::tie(b.from, b.until, b.frequency, b.tag, b.runId, b.selection, b.parameters);
  }
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
  TraceMetrics metrics;
  friend bool operator==(const TraceHeader& a, const TraceHeader& b) {
    return std::tie(a.format, a.scenario, a.dt, a.recordEvery, a.seed, a.humans, a.robots,
                    a.obstacles, a.obstaclePoints, a.map, a.metrics) ==
           std::tie(b.format, b.scenario, b.dt, b.recordEvery, b.seed, b.humans, b.robots,
                    b.obstacles, b.obstaclePoints, b.map, b.metrics);
  }
};

/// A recorded run.
struct Trace {
  TraceHeader header;
  std::vector<Frame> frames;                           // every recordEvery-th step from step 0
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
