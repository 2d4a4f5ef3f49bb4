#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/realism/RealismTest.h"

namespace sim2d {
namespace {

constexpr double kBody = 0.2;           // radius [m]
constexpr double kOverlap = 0.005;      // [m]
constexpr double kSampleEvery = 0.5;    // [s]
constexpr double kLaneHalfWidth = 0.4;  // [m]
constexpr double kLaneReach = 3.0;      // [m]

struct Sums {
  double speed = 0.0, overlapping = 0.0, people = 0.0;
  double order = 0.0, ordered = 0.0;
};

/// Adds one person's overlaps with others and the walking directions in the same lane.
void addPerson(const HumanColumns& people, const TestScene& stage, std::size_t self, Sums& sums) {
  const PeriodicCorridor ring{0.0, kRingLength};
  const Vec2 place(people.x[self], people.y[self]);
  const bool goesLeft = stage.actors()[self].heading != 0.0;
  bool overlaps = false;
  double same = 0.0;
  double opposite = 0.0;
  for (std::size_t other = 0; other < people.size(); ++other) {
    const Vec2 there(people.x[other], people.y[other]);
    const Vec2 apart = there + ring.shift(there, place) - place;
    if (other == self || std::fabs(apart.x()) >= kLaneReach) {
      continue;
    }
    overlaps |= apart.norm() < 2.0 * kBody - kOverlap;
    if (std::fabs(apart.y()) < kLaneHalfWidth) {
      (goesLeft == (stage.actors()[other].heading != 0.0) ? same : opposite) += 1.0;
    }
  }
  sums.people += 1.0;
  sums.overlapping += overlaps ? 1.0 : 0.0;
  sums.speed += goesLeft ? -people.vx[self] : people.vx[self];
  if (same + opposite > 0.0) {
    sums.order += (same - opposite) / (same + opposite);
    sums.ordered += 1.0;
  }
}

Flow playCorridor(const TestScene& stage, double seconds) {
  Sums sums;
  const auto every = std::max<std::int64_t>(1, std::llround(kSampleEvery / stage.dt()));
  stage.play(seconds, [&](const World& world) {
    if (world.time() > seconds / 2.0 && world.stepIndex() % every == 0) {
      for (std::size_t i = 0; i < world.frame().humans.size(); ++i) {
        addPerson(world.frame().humans, stage, i, sums);
      }
    }
    return true;
  });
  Flow flow;
  flow.speed = sums.speed / sums.people;
  flow.overlap = sums.overlapping / sums.people;
  flow.order = sums.ordered > 0.0 ? sums.order / sums.ordered : 0.0;
  return flow;
}

int peopleIn(const CorridorFlow& setting) {
  return static_cast<int>(std::lround(setting.density * kRingLength * setting.width));
}

/// Contains fewer people than requested if they do not fit.
TestScene corridorOf(const RealismRun& run, const CorridorFlow& setting) {
  TestScene stage(run, setting.dt);
  stage.addRing(setting.width);
  const Box box{Vec2(0.0, kBody), Vec2(kRingLength, setting.width - kBody)};
  const std::vector<Vec2> places = randomPlaces(run, peopleIn(setting), box, 2.0 * kBody, true);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double speed =
        freeSpeed(run, static_cast<int>(i), setting.meanSpeed, setting.speedDeviation);
    stage.add(ringWalker(places[i], speed, setting.isTwoWay && i % 2 == 1));
  }
  return stage;
}

/// Mean distance to the Weidmann fit, largest overlap, largest specific flow, largest rise of
/// speed.
std::vector<double> fundamentalDiagram(const RealismRun& run, const std::vector<double>& densities,
                                       CorridorFlow setting) {
  double deviation = 0.0;
  double overlap = 0.0;
  double peak = 0.0;
  double rise = -1e9;
  double before = 1e9;
  for (const double density : densities) {
    setting.density = density;
    const Flow flow = corridorFlow(run, setting);
    deviation += std::fabs(flow.speed - weidmannSpeed(density));
    overlap = std::max(overlap, flow.overlap);
    peak = std::max(peak, flow.speed * density);
    rise = std::max(rise, flow.speed - before);
    before = flow.speed;
  }
  return {deviation / static_cast<double>(densities.size()), overlap, peak, rise};
}

CorridorFlow withSteps(double dt) {
  CorridorFlow setting;
  setting.dt = dt;
  return setting;
}

std::vector<double> oneWayWith(const RealismRun& run, double dt) {
  std::vector<double> values =
      fundamentalDiagram(run, {0.5, 1.0, 1.5, 2.0, 2.5, 3.0}, withSteps(dt));
  values.pop_back();
  return values;
}

CorridorFlow corridorOfRimea4() {
  CorridorFlow setting;
  setting.width = 2.0;
  setting.seconds = 70.0;
  setting.meanSpeed = 1.3;
  setting.speedDeviation = 0.05;
  return setting;
}

std::vector<double> rimea4(const RealismRun& run) {
  const std::vector<double> values =
      fundamentalDiagram(run, {0.5, 1.0, 2.0, 3.0}, corridorOfRimea4());
  return {values[0], values[3]};
}

TestScene singleFileOf(const RealismRun& run, int count) {
  TestScene stage(run);
  stage.addRing(0.8);
  for (int i = 0; i < count; ++i) {
    const Vec2 start(kRingLength * (i + 0.5) / count, 0.4);
    stage.add(ringWalker(start, freeSpeed(run, i, 1.24, 0.05)));
  }
  return stage;
}

/// Largest relative error of the headway law 0.36 m + 1.06 s · v (Seyfried et al. 2005) over all
/// densities with a speed between 0.1 and 1 m/s; NaN if there is none.
std::vector<double> singleFile(const RealismRun& run) {
  double worst = std::numeric_limits<double>::quiet_NaN();
  double least = 1e9;
  for (const int count : {17, 20, 25, 30, 36, 42, 50}) {
    const Flow flow = playCorridor(singleFileOf(run, count), 60.0);
    least = std::min(least, flow.speed);
    if (flow.speed > 0.1 && flow.speed < 1.0) {
      const double error = std::fabs(kRingLength / count / (0.36 + 1.06 * flow.speed) - 1.0);
      worst = std::isnan(worst) ? error : std::max(worst, error);
    }
  }
  return {worst, least};
}

CorridorFlow twoWay(double density) {
  CorridorFlow setting;
  setting.density = density;
  setting.seconds = 80.0;
  setting.isTwoWay = true;
  return setting;
}

std::vector<double> lanes(const RealismRun& run) {
  std::vector<double> values;
  for (const double density : {1.0, 2.0}) {
    const Flow flow = corridorFlow(run, twoWay(density));
    values.push_back(flow.order);
    values.push_back(flow.speed);
  }
  return values;
}

}  // namespace

double weidmannSpeed(double density) {
  return 1.34 * (1.0 - base::exp(-1.913 * (1.0 / density - 1.0 / 5.4)));
}

Flow corridorFlow(const RealismRun& run, const CorridorFlow& setting) {
  const TestScene stage = corridorOf(run, setting);
  if (static_cast<int>(stage.actors().size()) < peopleIn(setting)) {
    throw SceneFailed{base::error("run.corridor-too-small")};
  }
  return playCorridor(stage, setting.seconds);
}

void addCorridorTests(std::vector<RealismTest>& tests);
void addCorridorTests(std::vector<RealismTest>& tests) {
  const Quantities ofDiagram = {{"distance to Weidmann", "m/s", Summary::Mean, 0.0, 0.07},
                                {"body overlap", "", Summary::Largest, 0.0, 0.001},
                                {"largest specific flow", "1/(m s)", Summary::Mean, 1.0, 1.5}};
  tests.push_back({"fd-one-way", "speed against density, 0.5 to 3 people per m², corridor 26 x 4 m",
                   ofDiagram, [](const RealismRun& run) { return oneWayWith(run, 0.05); },
                   [](const RealismRun& run) { return corridorOf(run, {}); }});
  tests.push_back({"fd-long-steps", "the same with time steps of 0.1 s", ofDiagram,
                   [](const RealismRun& run) { return oneWayWith(run, 0.1); },
                   [](const RealismRun& run) { return corridorOf(run, withSteps(0.1)); }});
  tests.push_back({"fd-single-file", "headway against speed, ring of 26 m, no overtaking",
                   Quantities{{"headway error", "", Summary::Largest, 0.0, 0.15},
                              {"speed at maximum density", "m/s", Summary::Mean, 0.0, 0.3}},
                   singleFile, [](const RealismRun& run) { return singleFileOf(run, 30); }});
  tests.push_back({"lanes", "two-way flow, half in each direction, corridor 26 x 4 m",
                   Quantities{{"lane order at 1 per m²", "", Summary::Mean, 0.9, 1.0},
                              {"speed at 1 per m²", "m/s", Summary::Mean, 0.5},
                              {"lane order at 2 per m²", "", Summary::Mean, 0.9, 1.0},
                              {"speed at 2 per m²", "m/s", Summary::Mean, 0.2}},
                   lanes, [](const RealismRun& run) { return corridorOf(run, twoWay(1.0)); }});
  tests.push_back({"rimea-4", "RiMEA 4: speed decreases with density, corridor 26 x 2 m",
                   Quantities{{"distance to Weidmann", "m/s", Summary::Mean, 0.0, 0.10},
                              {"largest increase of speed", "m/s", Summary::Largest,
                               -std::numeric_limits<double>::infinity(), 0.0}},
                   rimea4,
                   [](const RealismRun& run) { return corridorOf(run, corridorOfRimea4()); }});
}

}  // namespace sim2d
