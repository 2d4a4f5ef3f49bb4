#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/base/Rng.h"
#include "sim2d/world/World.h"

namespace sim2d {

/// Parameters of a realism test.
struct RealismRun {
  std::string model = "sfm";
  long long seed = 1;
  std::function<bool()> wantsStop;  // may be empty
};

/// Thrown if a test scene cannot be simulated.
struct SceneFailed {
  base::Diagnostic why;
};

/// A small world built in code, with walls and people with targets. SI, world frame.
class TestScene {
 public:
  /// Target of a person at `place`; the path to it is straight or planned.
  using Target = std::function<Vec2(const Vec2& place)>;

  struct Actor {
    Vec2 start = Vec2::Zero();
    double speed = 1.34;  // v0 [m/s]
    Target target;
    std::optional<Vec2> goal = {};  // in the scenario file; none: the target at the start
    double goalRadius = 0.3;        // in the scenario file [m]
    /// Condition for leaving the world; empty: never.
    std::function<bool(const Vec2& place)> isDone = {};
    double heading = 0.0;  // [rad]
    double radius = 0.2;   // [m]
    int group = -1;
  };

  explicit TestScene(RealismRun run, double dt = 0.05);

  void add(Actor actor);
  void addWall(const std::vector<Vec2>& line);  // 0.2 m thick
  /// Instead of straight paths.
  void usePlannedRoutes() { scenario_.desktop.route = Route::Planned; }
  /// Makes a closed corridor from x = 0 to kRingLength, with walls at y = 0 and y = `width`.
  void addRing(double width);
  const std::vector<Actor>& actors() const { return actors_; }

  /// Steps for `seconds` and calls `look` after each step, until it returns false. Throws
  /// SceneFailed if the run was stopped, failed, or could not begin.
  using Look = std::function<bool(const World& world)>;
  void play(double seconds, const Look& look) const;
  double dt() const { return dt_; }
  /// The scene as a scenario file: people with goals and generated trees instead of targets.
  Scenario scenario(const std::string& name, double duration) const;

 private:
  std::unique_ptr<World> build() const;

  RealismRun run_;
  double dt_;
  Scenario scenario_;
  std::vector<Actor> actors_;
};

constexpr double kRingLength = 26.0;  // [m]

/// A person who walks along the x axis indefinitely.
TestScene::Actor ringWalker(const Vec2& start, double speed, bool goesLeft = false);
TestScene::Target endlessTarget(const Vec2& direction);
TestScene::Target constantTarget(const Vec2& place);

/// Free speeds of adults: normal, 1.34 ± 0.26 m/s (Weidmann 1993), clamped to 0.5 and 2.2.
double freeSpeed(const RealismRun& run, int person, double mean = 1.34, double deviation = 0.26);

struct Box {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
};
/// `count` random places at least `apart` from each other, also across the ends if `isClosed`;
/// fewer if no more fit.
std::vector<Vec2> randomPlaces(const RealismRun& run, int count, const Box& box, double apart,
                               bool isClosed = false);

/// Validation tests of simulated people against data of real ones. A test simulates small scenes
/// with one model and one seed and measures some quantities; a quantity passes if its summary over
/// the seeds is within the limits. Sources of the limits: sim2d/world/realism/README.md.

enum class Summary { Mean, Smallest, Largest };  // over the seeds

struct Quantity {
  std::string name;
  std::string unit;
  Summary summary = Summary::Mean;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  static constexpr double kRounding = 1e-9;  // of sums over seeds

  /// NaN: not measured, which fails.
  double summaryOf(const std::vector<double>& values) const;
  bool passes(double value) const {
    return value >= least - kRounding && value <= most + kRounding;
  }
};

using Quantities = std::vector<Quantity>;

struct RealismTest {
  using Play = std::vector<double> (*)(const RealismRun& run);
  using Scene = TestScene (*)(const RealismRun& run);
  std::string name;
  std::string description;
  Quantities quantities;
  Play play = nullptr;     // one value per quantity; throws SceneFailed
  Scene scene = nullptr;   // the scene, or one of several; installed as a file
  bool isSeeded = true;    // false: independent of the seed
  double duration = 40.0;  // of the scene file [s]

  base::Result<std::vector<double>> measure(const RealismRun& run) const;
};

const std::vector<RealismTest>& realismTests();

// One scene of each test as a scenario file, with seed 1 and model `das`. The build writes them
// next to the program.
std::string sceneName(const RealismTest& test);  // "realism_fd_one_way_agents"
Scenario sceneOf(const RealismTest& test);

/// Writes `<folder>/<sceneName>.yaml` of each test and removes files of tests that no longer exist.
base::Diagnostics writeScenes(const std::string& folder);

/// Parts of tests that can be used separately; they throw SceneFailed if the scene cannot be
/// simulated.
struct Flow {
  double speed = 0.0;    // mean along the path [m/s]
  double overlap = 0.0;  // fraction of people with an overlapping body
  double order = 0.0;    // of lanes; 1: all people walk in lanes of the same direction
};
struct CorridorFlow {
  double density = 1.0;  // [1/m²]
  double width = 4.0;    // [m]
  double seconds = 40.0;
  double meanSpeed = 1.34, speedDeviation = 0.26;  // [m/s]
  bool isTwoWay = false;
  double dt = 0.05;  // [s]
};
/// Flow in a closed corridor of 26 m, measured in the second half of the time.
Flow corridorFlow(const RealismRun& run, const CorridorFlow& setting);

struct Meeting {
  double leastDistance = 0.0;  // between two centres [m]
  double slowest = 0.0;        // minimum speed while walking [m/s]
  double timeRatio = 0.0;      // time of the last person relative to a straight walk
};
/// `count` people on a circle who all walk to the opposite point.
Meeting circle(const RealismRun& run, int count, double radius);
/// Two people who walk exactly towards each other.
Meeting headOn(const RealismRun& run);

/// Speed at a density by the fit of Weidmann 1993 [m/s].
double weidmannSpeed(double density);

}  // namespace sim2d
