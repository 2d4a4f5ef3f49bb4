#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/report/Figure.h"
#include "sim2d/scenario/Scenario.h"
#include "sim2d/world/World.h"

namespace app {

/// The benchmark scene: two opposing streams of half a person per square metre, from a jittered
/// grid, on a square; a stationary robot in the middle.
struct BenchScene {
  int people = 1000;
  bool walls = false;  // a jagged wall of 100 segments along either side
  std::string tree;    // tree file for all agents
  int threads = 1;
  bool singlePerson = false;  // the same square with only the first agent
};
sim2d::Scenario makeBenchScenario(const BenchScene& scene);
base::Result<std::unique_ptr<sim2d::World>> makeBenchWorld(const BenchScene& scene);
/// The number of steps from the start during which the streams still overlap: no agent has walked
/// more than a seventh of the square. Later steps are cheaper, and the earlier so, the fewer agents
/// there are.
int crossingSteps(const BenchScene& scene);

/// A behaviour tree of twenty nodes, most of which are ticked in each step.
std::string benchTreeText();

/// Seconds per step of a reference implementation of the same forces: all pairs, double precision,
/// C library functions.
double plainStepSeconds(const sim2d::Scenario& scenario, double atLeastSeconds);

/// One measured size of the open scene.
struct BenchPoint {
  int people = 0;
  double whole = 0.0;     // a step [ms]
  double forces = 0.0;    // the forces in it [ms]
  double plain = 0.0;     // the same forces over all pairs [ms]
  bool isScaled = false;  // `plain` is extrapolated from a smaller size
};
/// Times per step over the number of people, both axes logarithmic; at least two sizes.
report::Figure benchFigure(const std::vector<BenchPoint>& points, const std::string& machine);

}  // namespace app
