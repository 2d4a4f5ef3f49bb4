#pragma once

#include <memory>
#include <string>
#include <vector>

#include <QString>

#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/World.h"

namespace app {

/// The measured scene: two opposing streams of half a person per square metre, from a jittered
/// grid, on a square; a robot that stands in the middle.
struct BenchScene {
  int people = 1000;
  bool walls = false;  // a jagged wall of 100 segments along either side
  std::string tree;    // file that everybody runs
  int threads = 1;
  bool lonely = false;  // the square with the first of the people alone
};
sim2d::Scenario makeBenchScenario(const BenchScene& scene);
base::Result<std::unique_ptr<sim2d::World>> makeBenchWorld(const BenchScene& scene);
/// Steps from the start in which the streams have not yet left each other: nobody has walked more
/// than a seventh of the square. Later steps cost less, the fewer people the sooner.
int crossingSteps(const BenchScene& scene);

/// A behaviour tree of twenty nodes of which most run in each step.
std::string benchTreeText();

/// Seconds for one step of the same forces written plainly: every pair, double precision, the
/// functions of the C library.
double plainStepSeconds(const sim2d::Scenario& scenario, double atLeastSeconds);

/// One measured size of the open scene.
struct BenchPoint {
  int people = 0;
  double whole = 0.0;     // a step [ms]
  double forces = 0.0;    // of which the forces [ms]
  double plain = 0.0;     // the same forces over all pairs [ms]
  bool isScaled = false;  // `plain` is, from a smaller size
};
/// Times per step over the number of people, both on scales of powers of ten, as the file's ending
/// says: .png, .svg or .pdf. False = it cannot be written. Needs a QApplication.
bool drawBench(const std::vector<BenchPoint>& points, const QString& machine, const QString& file);

}  // namespace app
