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
constexpr double kTimeSlack = 1e-9;  // [s] times are reached this much early

/// A robot or a person at one instant. World frame, SI, radians.
struct Body {
  int id = 0;
  Vec2 position = Vec2::Zero();
  double heading = 0.0;
  Vec2 velocity = Vec2::Zero();
  double speed = 0.0;  // |velocity|
  double omega = 0.0;
  double radius = 0.35;
  std::vector<sim2d::Obstacles::Point> obstacles;  // where they act on it
};

enum class Sight { Free, Blocked, OutsideMap };  // OutsideMap: hunav2 only

/// What holds between the robot and a person at one instant. Worked out once (workOutPairs), for
/// all metrics that ask and again for those among the people of one type.
struct Pair {
  bool isKnown = false;
  double distance = 0.0;              // of the centres [m]
  double bearing = 0.0;               // of the person, from the robot
  double viewAngle = 0.0;             // between the person's heading and the robot, [0, pi]
  double timeToCollision = HUGE_VAL;  // [s]
  Vec2 ahead{1.0, 0.0};               // direction of the person's heading
  Vec2 forceOnRobot = Vec2::Zero();   // social force [m/s^2]
  double forceOnPerson = 0.0;         // its modulus
  Sight sight = Sight::Blocked;       // asked for when some metric needs the map
};

struct Person : Body {
  int group = -1;
  int behavior = 1;                    // 1..6
  int state = 0;                       // != 0: a reaction runs
  std::optional<double> socialFactor;  // own; else the parameters'
  bool wantsToArrive = false;          // has goals and does not go round them for ever
  bool isNew = false;                  // came since the sample before, did not walk from there
  bool screened = false;  // a drawn obstacle or closed door hides the robot (map walls: apart)
  Pair pair;
};

struct Robot : Body {
  std::optional<double> obstacleDistance;  // of its centre [m], negative inside; none in reach
};

/// All bodies at one time.
struct Sample {
  double time = 0.0;  // [s]
  Robot robot;        // meaningful when RunContext::hasRobot
  std::vector<Person> people;
};

/// Fills in the pairs of a sample with a robot that are not known yet; the sight when `map` is
/// given.
void workOutPairs(Sample& sample, const sim2d::OccupancyGrid* map,
                  const MetricParameters& parameters);

using TimedWay = std::vector<std::pair<double, Vec2>>;  // time [s], place

class Routes;
class KnownRoutes;
struct KnownScene;

/// A corridor whose ends are joined (wrap_x): who leaves at one end comes in at the other.
struct Seam {
  double low = 0.0;     // [m]
  double length = 0.0;  // [m]; 0: there is none
  bool isThere() const { return length > 0.0; }
  /// The image of a place that is nearest to where one looks from.
  Vec2 nearest(const Vec2& place, const Vec2& seenFrom) const;
};

/// What holds for a whole run, one robot at most.
struct RunContext {
  bool hasRobot = false;
  int robotId = -1;
  double robotStartTime = 0.0;                    // it sets off then [s]
  double robotMaxSpeed = 1.0;                     // v_max [m/s]
  bool eventsTellArrivals = false;                // a simulated robot: no event, no arrival
  std::vector<sim2d::TraceGoal> goals;            // of the robot
  sim2d::OccupancyGrid map;                       // empty = none
  std::shared_ptr<Routes> routes;                 // shortest ways; null = straight lines
  std::shared_ptr<const sim2d::Obstacles> walls;  // of map and obstacles, doors open; null: none
  Seam seam;
  bool hasObstacles = false;  // or a map
  /// A run to compare with, instead of the shortest way; times from its start.
  TimedWay reference;
};

Seam seamOf(const sim2d::TraceHeader& header);
/// Did not walk from where it was at the sample before: came anew or over the seam.
bool hasJumped(const Vec2& before, const Person& now, const Seam& seam);

/// Turns frames into samples: radii and behaviours from the header, obstacle points from its
/// outlines by the function that the world uses.
class SampleBuilder {
 public:
  /// The robot with this id, by default the first; no such robot: people only.
  explicit SampleBuilder(const sim2d::TraceHeader& header, int robotId = -1);
  SampleBuilder(const sim2d::TraceHeader& header, int robotId, const KnownScene& known);
  /// People that arrived after the header was made.
  void addHumans(const std::vector<sim2d::TraceHuman>& humans);
  RunContext context() const;
  Sample sampleOf(const sim2d::Frame& frame) { return sampleOf(frame, peopleOf(frame)); }
  /// The same in two parts: people are the same for each robot.
  std::vector<Person> peopleOf(const sim2d::Frame& frame);
  Sample sampleOf(const sim2d::Frame& frame, std::vector<Person> people);

 private:
  struct Door {
    int part = 0;  // in all_ or drawn_
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
  std::shared_ptr<KnownRoutes> knownRoutes_;
  bool raysAct_;  // else points of borders
  std::map<int, Traits> humans_;
  sim2d::Obstacles all_, drawn_;
  bool hasDrawn_ = false;
  std::vector<Door> doors_;
  std::vector<sim2d::Obstacles::Point> buffer_;
};

/// Corner points from end to end: a straight line where the robot can see along it, where the
/// context has no routes and where none leads there, else the way round the walls. Not thread safe.
std::vector<Vec2> shortestPath(const RunContext& context, const Vec2& from, const Vec2& to);

/// The part that a window selects; the events stay.
struct Window {
  std::string from = "begin";  // begin | goal | motion | time T | event KIND
  std::string until = "end";   // end | arrival | time T | event KIND
  double frequency = 0.0;      // [Hz], 0 = every sample
};
/// What is wrong with the texts of a window, if anything.
std::optional<base::Diagnostic> windowProblem(const Window& window);
/// Tells sample by sample what a window takes.
class WindowGate {
 public:
  WindowGate(Window window, const RunContext& context);
  /// An event of a time up to that of the next sample; in order.
  void note(double time, const sim2d::Event& event);
  bool takes(const Sample& sample);
  /// Takes nothing from this time on, whatever comes.
  bool isOver(double time) const;

 private:
  void begin(double time);
  bool isPast(double time) const;
  bool ends(const sim2d::Event& event) const;

  Window window_;
  int robotId_;
  std::optional<double> begin_, end_;  // [s]
  std::optional<double> lastEnding_;   // newest event that would end it [s]
  double newest_;                      // that was taken [s]
  double first_ = 0.0, next_;          // of the grid of `frequency` [s]
  long long taken_ = 0;
};

// Geometry that most metrics share.
double lengthOf(const Vec2& vector);  // rounded correctly, unlike a root of squares
double distance(const Body& a, const Body& b);
double distance(const Robot& robot, const Person& person);  // of the same sample
double gap(const Robot& robot, const Person& person);       // surface to surface, < 0: they overlap
const Person* findPerson(const Sample& sample, int id);
/// The entry with this id; quick when entries are asked for in their order. `next` = where to look
/// first, 0 at the beginning.
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
