#pragma once

#include <limits>
#include <string>
#include <vector>

#include "sim2d/base/Result.h"
#include "sim2d/world/realism/TestScene.h"

/// Tests that hold simulated people against what is known of real ones. A test plays small scenes
/// with one model and one seed and measures some quantities; a quantity passes when its summary
/// over the seeds lies within the limits. Sources of the limits: sim2d/world/realism/README.md.
namespace sim2d {

enum class Summary { Mean, Smallest, Largest };  // over the seeds

struct Quantity {
  std::string name;
  std::string unit;
  Summary summary = Summary::Mean;
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();

  static constexpr double kRounding = 1e-9;  // of sums over seeds

  /// NaN: not measured, fails.
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
  Play play = nullptr;     // one value per quantity, or NotPlayed is thrown
  Scene scene = nullptr;   // what it plays, or one of it; comes with the program as a file
  bool isSeeded = true;    // false: every seed gives the same
  double duration = 40.0;  // of the scene on file [s]

  base::Result<std::vector<double>> measure(const RealismRun& run) const;
};

const std::vector<RealismTest>& realismTests();

// A scene of each test as a scenario to open and watch, with seed 1 and model `das`. The build
// writes them beside the program.
std::string sceneName(const RealismTest& test);  // "realism_fd_one_way_agents"
Scenario sceneOf(const RealismTest& test);

/// `<folder>/<sceneName>.yaml` of each test; files of tests that are no more are removed.
base::Diagnostics writeScenes(const std::string& folder);

/// Parts of tests that can be used alone; who cannot be played throws NotPlayed.
struct Flow {
  double speed = 0.0;    // mean along the way [m/s]
  double overlap = 0.0;  // share of people whose body is in another one
  double order = 0.0;    // of lanes: 1 all people walk among their own kind
};
struct CorridorFlow {
  double density = 1.0;  // [1/m²]
  double width = 4.0;    // [m]
  double seconds = 40.0;
  double meanSpeed = 1.34, speedDeviation = 0.26;  // [m/s]
  bool isTwoWay = false;
  double dt = 0.05;  // [s]
};
/// A closed corridor of 26 m; the second half of the time counts.
Flow corridorFlow(const RealismRun& run, const CorridorFlow& setting);

struct Meeting {
  double leastDistance = 0.0;  // between two centres [m]
  double slowest = 0.0;        // while on the way [m/s]
  double timeRatio = 0.0;      // time of the last one over that of a straight walk
};
/// `count` people on a circle who all want to the opposite place.
Meeting circle(const RealismRun& run, int count, double radius);
/// Two people who walk exactly towards each other.
Meeting headOn(const RealismRun& run);

/// Speed at a density by the fit of Weidmann 1993 [m/s].
double weidmannSpeed(double density);

}  // namespace sim2d
