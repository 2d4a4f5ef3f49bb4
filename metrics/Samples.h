#pragma once

#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "metrics/MetricParameters.h"
#include "sim2d/map/Obstacles.h"
#include "sim2d/trace/Trace.h"

namespace metrics {

using base::Vec2;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kTimeSlack = 1e-9;  // [s] tolerance of time comparisons

/// A robot or person at one instant. World frame, SI units, radians.
struct Body {
  int id = 0;
  Vec2 position = Vec2::Zero();
  double heading = 0.0;
  Vec2 velocity = Vec2::Zero();
  double speed = 0.0;  // |velocity|
  double omega = 0.0;
  double radius = 0.35;
  std::vector<sim2d::Obstacles::Point> obstacles;  // points that act on it
};

enum class Sight { Free, Blocked, OutsideMap };  // OutsideMap: hunav2 only

/// Quantities of the robot and one person at one instant. Computed once (computePairs) and shared
/// by all metrics, including those per behaviour type.
struct RobotPersonPair {
  bool isKnown = false;
  double distance = 0.0;              // of the centres [m]
  double bearing = 0.0;               // of the person as seen from the robot
  double viewAngle = 0.0;             // between the person's heading and the robot, [0, pi]
  double timeToCollision = HUGE_VAL;  // [s]
  Vec2 ahead{1.0, 0.0};               // direction of the person's heading
  Vec2 forceOnRobot = Vec2::Zero();   // social force [m/s^2]
  double forceOnPerson = 0.0;         // magnitude
  Sight sight = Sight::Blocked;       // computed if a metric needs the map
};

struct Pedestrian : Body {
  int group = -1;
  int behavior = 1;                    // 1..6
  int state = 0;                       // != 0: reacting
  std::optional<double> socialFactor;  // own factor; otherwise that of the parameters
  bool wantsToArrive = false;          // has goals that are not cyclic
  bool isNew = false;                  // entered since the previous sample
  bool screened = false;  // an obstacle or closed door hides the robot (map walls: separate)
  RobotPersonPair pair;
};

struct Robot : Body {
  std::optional<double> obstacleDistance;  // of its centre [m], < 0 inside; empty: none in range
};

/// All bodies at one time.
struct Sample {
  double time = 0.0;  // [s]
  Robot robot;        // valid if RunContext::hasRobot
  std::vector<Pedestrian> people;
};

/// Computes missing pairs of a sample with a robot; the sight only if `map` is given.
void computePairs(Sample& sample, const sim2d::OccupancyGrid* map,
                  const MetricParameters& parameters);

using TimedPath = std::vector<std::pair<double, Vec2>>;  // time [s], position

class ShortestPaths;
class ShortestPathCache;
struct PrecomputedScene;

/// A corridor with joined ends (wrap_x): bodies that leave at one end enter at the other.
struct Seam {
  double low = 0.0;     // [m]
  double length = 0.0;  // [m]; 0: no seam
  bool isThere() const { return length > 0.0; }
  /// The image of `place` that is nearest to `seenFrom`.
  Vec2 nearest(const Vec2& place, const Vec2& seenFrom) const;
};

/// Constant data of a run with at most one robot.
struct RunContext {
  bool hasRobot = false;
  int robotId = -1;
  double robotStartTime = 0.0;                    // start time of the robot [s]
  double robotMaxSpeed = 1.0;                     // v_max [m/s]
  bool eventsReportArrivals = false;              // simulated robot: without event no arrival
  std::vector<sim2d::TraceGoal> goals;            // of the robot
  sim2d::OccupancyGrid map;                       // empty: none
  std::shared_ptr<ShortestPaths> routes;          // shortest paths; null: straight lines
  std::shared_ptr<const sim2d::Obstacles> walls;  // map and obstacles with open doors; null: none
  Seam seam;
  bool hasObstacles = false;  // or a map
  /// A reference run, used instead of the shortest path; times from its start.
  TimedPath reference;
};

Seam seamOf(const sim2d::TraceHeader& header);
/// Whether a person entered or crossed the seam since the previous sample.
bool hasJumped(const Vec2& before, const Pedestrian& now, const Seam& seam);

/// Converts frames to samples: radii and behaviours from the header, obstacle points from its
/// outlines with the function that the world uses.
class SampleBuilder {
 public:
  /// Uses the robot with this id, by default the first. Without such a robot: people only.
  explicit SampleBuilder(const sim2d::TraceHeader& header, int robotId = -1);
  SampleBuilder(const sim2d::TraceHeader& header, int robotId, const PrecomputedScene& known);
  /// Adds people who appear after the header was created.
  void addHumans(const std::vector<sim2d::TraceHuman>& humans);
  RunContext context() const;
  Sample sampleOf(const sim2d::Frame& frame) { return sampleOf(frame, peopleOf(frame)); }
  /// The same in two steps, since people are equal for all robots.
  std::vector<Pedestrian> peopleOf(const sim2d::Frame& frame);
  Sample sampleOf(const sim2d::Frame& frame, std::vector<Pedestrian> people);

 private:
  struct Door {
    int part = 0;  // index in all_ or drawn_
    int drawnPart = 0;
    bool openAtStart = false;
    std::vector<double> toggles;
  };
  struct Traits {         // of a person
    double radius = 0.0;  // [m]
    int behavior = 1;
    std::optional<double> socialFactor;
    bool wantsToArrive = false;
  };
  void setDoors(double time);
  void addObstaclePoints(Body& body);

  int robotId_;
  sim2d::TraceHeader header_;  // without people
  std::shared_ptr<ShortestPathCache> pathCache_;
  bool usesRays_;  // otherwise boundary points
  std::map<int, Traits> humans_;
  sim2d::Obstacles all_, drawn_;
  bool hasDrawn_ = false;
  std::vector<Door> doors_;
  std::vector<sim2d::Obstacles::Point> buffer_;
};

/// Corner points from start to end: a straight line if it is free, if the context has no routes or
/// if there is no path; otherwise the shortest path around the walls. Not thread-safe.
std::vector<Vec2> shortestPath(const RunContext& context, const Vec2& from, const Vec2& to);

/// The part of a record that is evaluated; events are kept.
struct Window {
  std::string from = "begin";  // begin | goal | motion | time T | event KIND
  std::string until = "end";   // end | arrival | time T | event KIND
  double frequency = 0.0;      // [Hz], 0: every sample
};
/// The first problem in the text of a window, if any.
std::optional<base::Diagnostic> windowError(const Window& window);
/// Decides for each sample whether a window includes it.
class WindowFilter {
 public:
  WindowFilter(Window window, const RunContext& context);
  /// Call for events in order, up to the time of the next sample.
  void note(double time, const sim2d::Event& event);
  bool takes(const Sample& sample);
  /// Whether no sample from this time on can be included.
  bool isOver(double time) const;

 private:
  void begin(double time);
  bool isPast(double time) const;
  bool ends(const sim2d::Event& event) const;

  Window window_;
  int robotId_;
  std::optional<double> begin_, end_;  // [s]
  std::optional<double> lastEnding_;   // newest possible end event [s]
  double newest_;                      // last included sample [s]
  double first_ = 0.0, next_;          // of the grid of `frequency` [s]
  long long taken_ = 0;
};

// Geometry shared by most metrics.
double lengthOf(const Vec2& vector);  // correctly rounded, unlike the root of a sum of squares
double distance(const Body& a, const Body& b);
double distance(const Robot& robot, const Pedestrian& person);  // of the same sample
double gap(const Robot& robot, const Pedestrian& person);       // between surfaces, < 0: overlap
const Pedestrian* findPerson(const Sample& sample, int id);
/// The entry with this id; fast if entries are requested in order. `next`: search start, initially
/// 0.
template <class Entry>
const Entry* findInOrder(const std::vector<Entry>& entries, std::size_t& next, int id) {
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const std::size_t at = next + k < entries.size() ? next + k : next + k - entries.size();
    if (entries[at].id == id) {
      next = at + 1 < entries.size() ? at + 1 : 0;
      return &entries[at];
    }
  }
  return nullptr;
}

}  // namespace metrics
