#include <algorithm>
#include <cmath>

#include "sim2d/base/Math.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/realism/RealismTest.h"

namespace sim2d {
namespace {

constexpr double kLength = 26.0;        // [m]
constexpr double kBeyond = 8.0;         // [m]; walls reach so far past the ends
constexpr double kBody = 0.2;           // radius [m]
constexpr double kOverlap = 0.005;      // [m]
constexpr double kSampleEvery = 0.5;    // [s]
constexpr double kLaneHalfWidth = 0.4;  // [m]
constexpr double kLaneReach = 3.0;      // [m]

struct Sums {
  double speed = 0.0, overlapping = 0.0, people = 0.0;
  double order = 0.0, ordered = 0.0;
};

/// What one person sees of the others: bodies too near, companions in the own lane.
void addPerson(const HumanColumns& people, const TestScene& stage, std::size_t self, Sums& sums) {
  const Ring ring{0.0, kLength};
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

void addWalls(TestScene& stage, double width) {
  for (const double y : {-0.1, width + 0.1}) {
    stage.addWall({Vec2(-kBeyond, y), Vec2(kLength + kBeyond, y)});
  }
}

base::Result<Flow> playCorridor(TestScene& stage, double seconds) {
  Sums sums;
  const auto every = std::max<std::int64_t>(1, std::llround(kSampleEvery / stage.dt()));
  const bool isPlayed = stage.play(seconds, [&](const World& world) {
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
  return stage.orProblem(isPlayed, flow);
}

int peopleIn(const CorridorFlow& setting) {
  return static_cast<int>(std::lround(setting.density * kLength * setting.width));
}

/// Fewer people than wanted when they do not fit.
TestScene corridorOf(const RealismRun& run, const CorridorFlow& setting) {
  TestScene stage(run, setting.dt);
  addWalls(stage, setting.width);
  const Box box{Vec2(0.0, kBody), Vec2(kLength, setting.width - kBody)};
  const std::vector<Vec2> places = randomPlaces(run, peopleIn(setting), box, 2.0 * kBody, true);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool goesLeft = setting.isTwoWay && i % 2 == 1;
    const double speed =
        freeSpeed(run, static_cast<int>(i), setting.meanSpeed, setting.speedDeviation);
    TestScene::Actor actor{places[i], speed, endlessly(Vec2(goesLeft ? -1.0 : 1.0, 0.0)),
                           endlessGoal(places[i], goesLeft)};
    actor.heading = goesLeft ? base::kPi : 0.0;
    stage.add(actor);
  }
  stage.close(0.0, kLength);
  return stage;
}

/// Mean distance to the Weidmann fit, largest overlap, largest specific flow, largest rise of
/// speed.
base::Result<std::vector<double>> fundamentalDiagram(const RealismRun& run,
                                                     const std::vector<double>& densities,
                                                     CorridorFlow setting) {
  double deviation = 0.0;
  double overlap = 0.0;
  double peak = 0.0;
  double rise = -1e9;
  double before = 1e9;
  for (const double density : densities) {
    setting.density = density;
    const base::Result<Flow> flow = corridorFlow(run, setting);
    if (!flow) {
      return flow.diagnostics();
    }
    deviation += std::fabs(flow->speed - weidmannSpeed(density));
    overlap = std::max(overlap, flow->overlap);
    peak = std::max(peak, flow->speed * density);
    rise = std::max(rise, flow->speed - before);
    before = flow->speed;
  }
  return std::vector<double>{deviation / static_cast<double>(densities.size()), overlap, peak,
                             rise};
}

base::Result<std::vector<double>> oneWayWith(const RealismRun& run, double dt) {
  CorridorFlow setting;
  setting.dt = dt;
  base::Result<std::vector<double>> values =
      fundamentalDiagram(run, {0.5, 1.0, 1.5, 2.0, 2.5, 3.0}, setting);
  if (values) {
    values->pop_back();
  }
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

base::Result<std::vector<double>> rimea4(const RealismRun& run) {
  const base::Result<std::vector<double>> values =
      fundamentalDiagram(run, {0.5, 1.0, 2.0, 3.0}, corridorOfRimea4());
  if (!values) {
    return values.diagnostics();
  }
  return std::vector<double>{(*values)[0], (*values)[3]};
}

TestScene singleFileOf(const RealismRun& run, int count) {
  TestScene stage(run);
  addWalls(stage, 0.8);
  for (int i = 0; i < count; ++i) {
    const Vec2 start(kLength * (i + 0.5) / count, 0.4);
    stage.add({start, freeSpeed(run, i, 1.24, 0.05), endlessly(Vec2(1.0, 0.0)),
               endlessGoal(start, false)});
  }
  stage.close(0.0, kLength);
  return stage;
}

/// Relative error of the headway law 0.36 m + 1.06 s · v (Seyfried et al. 2005), worst of all
/// densities whose speed lies between 0.1 and 1 m/s; NaN when there is none.
base::Result<std::vector<double>> singleFile(const RealismRun& run) {
  double worst = std::numeric_limits<double>::quiet_NaN();
  double least = 1e9;
  for (const int count : {17, 20, 25, 30, 36, 42, 50}) {
    TestScene stage = singleFileOf(run, count);
    const base::Result<Flow> flow = playCorridor(stage, 60.0);
    if (!flow) {
      return flow.diagnostics();
    }
    least = std::min(least, flow->speed);
    if (flow->speed > 0.1 && flow->speed < 1.0) {
      const double error = std::fabs(kLength / count / (0.36 + 1.06 * flow->speed) - 1.0);
      worst = std::isnan(worst) ? error : std::max(worst, error);
    }
  }
  return std::vector<double>{worst, least};
}

base::Result<std::vector<double>> lanes(const RealismRun& run) {
  std::vector<double> values;
  for (const double density : {1.0, 2.0}) {
    CorridorFlow setting;
    setting.density = density;
    setting.seconds = 80.0;
    setting.isTwoWay = true;
    const base::Result<Flow> flow = corridorFlow(run, setting);
    if (!flow) {
      return flow.diagnostics();
    }
    values.push_back(flow->order);
    values.push_back(flow->speed);
  }
  return values;
}

TestScene longStepsScene(const RealismRun& run) {
  CorridorFlow setting;
  setting.dt = 0.1;
  return corridorOf(run, setting);
}

TestScene lanesScene(const RealismRun& run) {
  CorridorFlow setting;
  setting.isTwoWay = true;
  return corridorOf(run, setting);
}

}  // namespace

double weidmannSpeed(double density) {
  return 1.34 * (1.0 - base::exp(-1.913 * (1.0 / density - 1.0 / 5.4)));
}

base::Result<Flow> corridorFlow(const RealismRun& run, const CorridorFlow& setting) {
  TestScene stage = corridorOf(run, setting);
  if (static_cast<int>(stage.actors().size()) < peopleIn(setting)) {
    return base::error("run.corridor-too-small");
  }
  return playCorridor(stage, setting.seconds);
}

void addCorridorTests(std::vector<RealismTest>& tests);
void addCorridorTests(std::vector<RealismTest>& tests) {
  const std::vector<Quantity> ofDiagram = {
      {"distance to Weidmann", "m/s", Summary::Mean, 0.0, 0.07},
      {"bodies overlap", "", Summary::Largest, 0.0, 0.001},
      {"largest specific flow", "1/(m s)", Summary::Mean, 1.0, 1.5}};
  tests.push_back({"fd-one-way", "speed against density, 0.5 to 3 people per m², corridor 26 x 4 m",
                   ofDiagram, [](const RealismRun& run) { return oneWayWith(run, 0.05); },
                   [](const RealismRun& run) { return corridorOf(run, {}); }});
  tests.push_back({"fd-long-steps", "the same with steps of 0.1 s", ofDiagram,
                   [](const RealismRun& run) { return oneWayWith(run, 0.1); }, longStepsScene});
  tests.push_back({"fd-single-file",
                   "headway against speed, ring of 26 m, no overtaking",
                   {{"error of headway", "", Summary::Largest, 0.0, 0.15},
                    {"speed when densest", "m/s", Summary::Mean, 0.0, 0.3}},
                   singleFile,
                   [](const RealismRun& run) { return singleFileOf(run, 30); }});
  tests.push_back({"lanes",
                   "two-way flow, half and half, corridor 26 x 4 m",
                   {{"order at 1 per m²", "", Summary::Mean, 0.9, 1.0},
                    {"speed at 1 per m²", "m/s", Summary::Mean, 0.5},
                    {"order at 2 per m²", "", Summary::Mean, 0.9, 1.0},
                    {"speed at 2 per m²", "m/s", Summary::Mean, 0.2}},
                   lanes,
                   lanesScene});
  tests.push_back({"rimea-4",
                   "RiMEA 4: speed falls with density, corridor 26 x 2 m",
                   {{"distance to Weidmann", "m/s", Summary::Mean, 0.0, 0.10},
                    {"largest rise of speed", "m/s", Summary::Largest,
                     -std::numeric_limits<double>::infinity(), 0.0}},
                   rimea4,
                   [](const RealismRun& run) { return corridorOf(run, corridorOfRimea4()); }});
}

}  // namespace sim2d
