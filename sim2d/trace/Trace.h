#pragma once

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Frame.h"

namespace sim2d {

/// The parts of trace.json list their members once, with their names there, in order: comparison,
/// reader, writer and manifest are made from these lists.
/// visit(name, member) for each.
template <class T, class Visit>
void forEachMember(T& of, Visit visit) {
  std::apply([&](const auto&... each) { (visit(each.first, of.*each.second), ...); },
             std::decay_t<T>::members());
}

template <class T, class = decltype(T::members())>
bool operator==(const T& a, const T& b) {
  return std::apply(
      [&](const auto&... each) { return ((a.*each.second == b.*each.second) && ...); },
      T::members());
}

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

  static constexpr auto members() {
    using T = TraceHuman;
    return std::make_tuple(
        std::pair("id", &T::id), std::pair("name", &T::name), std::pair("kind", &T::kind),
        std::pair("model", &T::model), std::pair("radius", &T::radius), std::pair("mass", &T::mass),
        std::pair("desired_speed", &T::desiredSpeed), std::pair("group", &T::group),
        std::pair("behavior", &T::behavior), std::pair("configuration", &T::configuration),
        std::pair("cyclic_goals", &T::cyclicGoals), std::pair("goals", &T::goals),
        std::pair("parameters", &T::parameters));
  }
};

struct TraceRobot {
  int id = -1;
  std::string name, type, planner;
  double radius = 0.35, mass = 50.0;
  double maxVel = 1.0, maxAcc = 1.0, maxOmega = 1.5, maxAlpha = 3.0;
  double startTime = 0.0;
  std::vector<TraceGoal> goals;
  std::vector<Vec2> footprint;              // robot frame; empty = disc
  std::string kinematics = "differential";  // or "omnidirectional", "ackermann"; absent: as here

  static constexpr auto members() {
    using T = TraceRobot;
    return std::make_tuple(
        std::pair("id", &T::id), std::pair("name", &T::name), std::pair("type", &T::type),
        std::pair("planner", &T::planner), std::pair("radius", &T::radius),
        std::pair("mass", &T::mass), std::pair("max_vel", &T::maxVel),
        std::pair("max_acc", &T::maxAcc), std::pair("max_omega", &T::maxOmega),
        std::pair("max_alpha", &T::maxAlpha), std::pair("start_time", &T::startTime),
        std::pair("goals", &T::goals), std::pair("footprint", &T::footprint),
        std::pair("kinematics", &T::kinematics));
  }
};

struct TraceObstacle {
  std::string name;  // "map", or of the obstacle or door
  bool isDoor = false;
  bool open = false;              // door at the start
  std::vector<double> toggles;    // [s]
  std::vector<Outline> outlines;  // solid on the left

  static constexpr auto members() {
    using T = TraceObstacle;
    return std::make_tuple(std::pair("name", &T::name), std::pair("door", &T::isDoor),
                           std::pair("open", &T::open), std::pair("toggles", &T::toggles),
                           std::pair("outlines", &T::outlines));
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

  static constexpr auto members() {
    using T = TraceMetrics;
    return std::make_tuple(std::pair("from", &T::from), std::pair("until", &T::until),
                           std::pair("frequency", &T::frequency), std::pair("tag", &T::tag),
                           std::pair("run_id", &T::runId), std::pair("selection", &T::selection),
                           std::pair("parameters", &T::parameters));
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
  std::vector<double> wrapX;  // where the ends of a corridor are joined [m]; mostly none
  OccupancyGrid map;
  TraceMetrics metrics;  // this and wrapX absent in the file: as here

  /// Null: there is none of that number.
  const TraceHuman* human(int id) const {
    const auto found = std::find_if(humans.begin(), humans.end(),
                                    [id](const TraceHuman& each) { return each.id == id; });
    return found == humans.end() ? nullptr : &*found;
  }

  static constexpr auto members() {
    using T = TraceHeader;
    return std::make_tuple(std::pair("format", &T::format), std::pair("scenario", &T::scenario),
                           std::pair("dt", &T::dt), std::pair("record_every", &T::recordEvery),
                           std::pair("seed", &T::seed),
                           std::pair("obstacle_points", &T::obstaclePoints),
                           std::pair("wrap_x", &T::wrapX), std::pair("humans", &T::humans),
                           std::pair("robots", &T::robots), std::pair("obstacles", &T::obstacles),
                           std::pair("map", &T::map), std::pair("metrics", &T::metrics));
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
/// Reads the text of trace.json; `file` is named in the problems.
base::Result<TraceHeader> parseTraceJson(const std::string& text, const std::string& file);
/// Reads trajectory.csv, events.csv and trace.json of a run folder.
base::Result<Trace> readTrace(const std::string& directory);

// The same row by row, for records that are written while they are made.
/// First lines of the files.
constexpr char kTrajectoryColumns[] = "step,time,id,kind,x,y,heading,vx,vy,omega,group,state,goal";
constexpr char kEventColumns[] = "step,time,kind,id,other,text";
constexpr char kTreeColumns[] = "step,id,node,status";
std::string headLine(const char* columns);  // with its end

/// One row per body.
void appendTrajectoryRows(std::string& to, const Frame& frame);
void appendEventRow(std::string& to, std::int64_t step, double dt, const Event& event);
void appendTreeRows(std::string& to, std::int64_t step, const TreeChanges& changes);

}  // namespace sim2d
