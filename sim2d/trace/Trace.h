#pragma once

#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim2d/base/Files.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Result.h"
#include "sim2d/map/OccupancyGrid.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/trace/Frame.h"

namespace sim2d {

/// Each part of trace.json lists its members with their JSON names in `eachMember`; comparison,
/// reader, writer and manifest use these lists. Calls visit(name, member).
template <class T, class Visit>
void forEachMember(T& of, Visit visit) {
  std::decay_t<T>::eachMember([&](const char* name, auto member) { visit(name, of.*member); });
}
/// Compares all these members.
template <class T>
auto operator==(const T& a, const T& b) -> decltype(T::eachMember(0), bool()) {
  bool isSame = true;
  T::eachMember([&](const char*, auto member) { isSame = isSame && a.*member == b.*member; });
  return isSame;
}

struct TraceGoal {
  int id = 0;  // of the global goal; 0: a plain point
  Vec2 position = Vec2::Zero();
  double radius = 0.3;  // [m]

  friend bool operator==(const TraceGoal& a, const TraceGoal& b) {
    return a.id == b.id && a.position == b.position && a.radius == b.radius;
  }
};

struct TraceHuman {
  int id = 0;
  std::string name, kind, model;
  double radius = 0.35, mass = 80.0, desiredSpeed = 1.0;  // [m], [kg], [m/s]
  int group = -1;
  int behavior = 1;       // 1..6
  int configuration = 0;  // 0..3
  bool cyclicGoals = true;
  std::vector<TraceGoal> goals;
  std::vector<std::pair<std::string, double>> parameters;  // all resolved numeric parameters
  bool customTree = false;  // the behaviour tree is not generated from behaviour and goals

  template <class Visit>
  static void eachMember(Visit visit) {
    using T = TraceHuman;
    visit("id", &T::id);
    visit("name", &T::name);
    visit("kind", &T::kind);
    visit("model", &T::model);
    visit("radius", &T::radius);
    visit("mass", &T::mass);
    visit("desired_speed", &T::desiredSpeed);
    visit("group", &T::group);
    visit("behavior", &T::behavior);
    visit("configuration", &T::configuration);
    visit("cyclic_goals", &T::cyclicGoals);
    visit("goals", &T::goals);
    visit("parameters", &T::parameters);
    visit("custom_tree", &T::customTree);  // optional in the file; absent: false
  }
};

struct TraceRobot {
  int id = -1;
  std::string name, type, planner;
  double radius = 0.35, mass = 50.0;  // [m], [kg]
  // [m/s], [m/s²], [rad/s], [rad/s²]
  double maxVel = 1.0, maxAcc = 1.0, maxOmega = 1.5, maxAlpha = 3.0;
  double startTime = 0.0;  // [s]
  std::vector<TraceGoal> goals;
  std::vector<Vec2> footprint;              // robot frame; empty: disc
  std::string kinematics = "differential";  // or "omnidirectional", "ackermann"; optional

  template <class Visit>
  static void eachMember(Visit visit) {
    using T = TraceRobot;
    visit("id", &T::id);
    visit("name", &T::name);
    visit("type", &T::type);
    visit("planner", &T::planner);
    visit("radius", &T::radius);
    visit("mass", &T::mass);
    visit("max_vel", &T::maxVel);
    visit("max_acc", &T::maxAcc);
    visit("max_omega", &T::maxOmega);
    visit("max_alpha", &T::maxAlpha);
    visit("start_time", &T::startTime);
    visit("goals", &T::goals);
    visit("footprint", &T::footprint);
    visit("kinematics", &T::kinematics);
  }
};

struct TraceObstacle {
  std::string name;  // "map", or name of the obstacle or door
  bool isDoor = false;
  bool open = false;              // door open at the start
  std::vector<double> toggles;    // [s]
  std::vector<Outline> outlines;  // solid on the left

  template <class Visit>
  static void eachMember(Visit visit) {
    using T = TraceObstacle;
    visit("name", &T::name);
    visit("door", &T::isDoor);
    visit("open", &T::open);
    visit("toggles", &T::toggles);
    visit("outlines", &T::outlines);
  }
};

/// Metric settings of the scenario.
struct TraceMetrics {
  std::string from = "begin", until = "end";  // window
  double frequency = 0.0;                     // [Hz], 0: every sample
  std::string tag = "exp_1";
  int runId = 0;
  std::string selection;  // content of a metrics.yaml; empty: all metrics
  std::vector<std::pair<std::string, double>> parameters;

  template <class Visit>
  static void eachMember(Visit visit) {
    using T = TraceMetrics;
    visit("from", &T::from);
    visit("until", &T::until);
    visit("frequency", &T::frequency);
    visit("tag", &T::tag);
    visit("run_id", &T::runId);
    visit("selection", &T::selection);
    visit("parameters", &T::parameters);
  }
};

/// Data of a run that metrics need in addition to the trajectory.
struct TraceHeader {
  int format = 1;
  std::string scenario;  // name of the scenario
  double dt = 0.05;      // [s]
  int recordEvery = 1;   // in steps
  long long seed = 1;
  std::vector<TraceHuman> humans;
  std::vector<TraceRobot> robots;
  std::vector<TraceObstacle> obstacles;
  std::string obstaclePoints = "boundary";
  std::vector<double> wrapX;  // [m], ends of a periodic corridor; usually empty
  OccupancyGrid map;
  TraceMetrics metrics;  // optional in the file, as is wrapX

  /// Null: no such id.
  const TraceHuman* human(int id) const { return base::findBy(humans, &TraceHuman::id, id); }
  const TraceRobot* robot(int id) const { return base::findBy(robots, &TraceRobot::id, id); }

  template <class Visit>
  static void eachMember(Visit visit) {
    using T = TraceHeader;
    visit("format", &T::format);
    visit("scenario", &T::scenario);
    visit("dt", &T::dt);
    visit("record_every", &T::recordEvery);
    visit("seed", &T::seed);
    visit("obstacle_points", &T::obstaclePoints);
    visit("wrap_x", &T::wrapX);
    visit("humans", &T::humans);
    visit("robots", &T::robots);
    visit("obstacles", &T::obstacles);
    visit("map", &T::map);
    visit("metrics", &T::metrics);
  }
};

/// Detects people whom a source spawns during a run: the header of the run has changed then.
class KnownPeople {
 public:
  explicit KnownPeople(const TraceHeader& header) {
    for (const TraceHuman& human : header.humans) {
      ids_.insert(human.id);
    }
  }

  /// Adds the people of a frame. Returns whether one of them is new.
  bool addNew(const Frame& frame) {
    const std::size_t before = ids_.size();
    ids_.insert(frame.humans.id.begin(), frame.humans.id.end());
    return ids_.size() > before;
  }

 private:
  std::set<int> ids_;
};

/// A recorded run.
struct Trace {
  TraceHeader header;
  std::vector<Frame> frames;                           // every recordEvery-th step
  std::vector<std::pair<std::int64_t, Event>> events;  // of all steps
};

/// Contents of the files of a run folder (columns: FORMAT.md). Equal runs give equal bytes.
std::string trajectoryCsv(const Trace& trace);
std::string eventsCsv(const Trace& trace);
std::string traceJson(const TraceHeader& header);
/// Parses trace.json; `file` is the file name in messages.
base::Result<TraceHeader> parseTraceJson(const std::string& text, const std::string& file);
/// Reads trajectory.csv, events.csv and trace.json from a run folder.
base::Result<Trace> readTrace(const std::string& directory);

/// Contents of the files of a recording; paths are used in messages.
struct TraceTexts {
  base::FileContent trajectory, events, header;
};

/// As readTrace, from memory.
base::Result<Trace> parseTrace(const TraceTexts& texts);

// Row-by-row writing, for recordings that are written during the run.
/// Header lines of the files.
constexpr char kTrajectoryColumns[] = "step,time,id,kind,x,y,heading,vx,vy,omega,group,state,goal";
constexpr char kEventColumns[] = "step,time,kind,id,other,text";
constexpr char kTreeColumns[] = "step,id,node,status";
std::string headerLine(const char* columns);  // with line end

/// One row per body.
void appendTrajectoryRows(std::string& to, const Frame& frame);
void appendEventRow(std::string& to, std::int64_t step, double dt, const Event& event);
void appendTreeRows(std::string& to, std::int64_t step, const TreeChanges& changes);

/// Rows of `scans.csv`, one per lidar scan (columns: FORMAT.md); reading returns equal values.
std::string scansHeader();
void appendScanRow(std::string& to, const RecordedScan& scan);
/// Reports all problems with their places; steps must not decrease.
base::Result<std::vector<RecordedScan>> parseScans(const std::string& text,
                                                   const std::string& file);

}  // namespace sim2d
