#pragma once

#include <memory>
#include <string>

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

}  // namespace app
