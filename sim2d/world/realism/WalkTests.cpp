#include <algorithm>
#include <cmath>

#include "sim2d/scenario/Defaults.h"
#include "sim2d/world/realism/RealismTest.h"
#include "sim2d/world/realism/TestList.h"

namespace sim2d {
namespace {

/// Mean speed of one person over 40 m of a corridor 2 m wide [m/s].
base::Result<double> speedAlone(const RealismRun& run, double desiredSpeed, double radius) {
  constexpr double kLength = 40.0;
  Stage stage(run);
  stage.addWall({Vec2(-2.0, -1.1), Vec2(kLength + 4.0, -1.1)});
  stage.addWall({Vec2(-2.0, 1.1), Vec2(kLength + 4.0, 1.1)});
  Stage::Actor actor;
  actor.speed = desiredSpeed;
  actor.radius = radius;
  actor.target = endlessly(Vec2(1.0, 0.0));
  stage.add(actor);
  double time = std::numeric_limits<double>::quiet_NaN();
  const bool isPlayed = stage.play(400.0, [&](const World& world) {
    const bool isThrough = world.frame().humans.x[0] >= kLength;
    time = isThrough ? world.time() : time;
    return !isThrough;
  });
  if (!isPlayed) {
    return base::makeError(stage.problem());
  }
  return kLength / time;
}

base::Result<std::vector<double>> rimea1(const RealismRun& run) {
  const base::Result<double> speed = speedAlone(run, 1.33, 0.2);
  if (!speed) {
    return speed.diagnostics();
  }
  return std::vector<double>{40.0 / *speed};
}

/// Fifty people of each kind, alone: how far outside the speeds of their kind the farthest is, and
/// how far their mean lies from the kind's.
base::Result<std::vector<double>> rimea7(const RealismRun& run) {
  double outside = 0.0;
  double off = 0.0;
  for (const PersonKind kind : {PersonKind::Adult, PersonKind::Child, PersonKind::Elderly,
                                PersonKind::Wheelchair, PersonKind::Luggage}) {
    const KindProfile& profile = profileOf(kind);
    constexpr int kPeople = 50;
    double sum = 0.0;
    for (int person = 0; person < kPeople; ++person) {
      const base::Result<double> speed =
          speedAlone(run, sampleSpeed(kind, run.seed, person), profile.radius);
      if (!speed) {
        return speed.diagnostics();
      }
      sum += *speed;
      outside = std::max({outside, 0.95 * profile.slowest - *speed, *speed - profile.fastest});
    }
    off = std::max(off, std::fabs(sum / kPeople - profile.meanSpeed) / profile.meanSpeed);
  }
  return std::vector<double>{outside, off};
}

struct Shape {
  double speed = 0.0;     // [m/s]
  double distance = 0.0;  // mean between neighbours of the row [m]
  double abreast = 0.0;   // share of it across the way
};

/// A group of `count` on 30 m of open ground, the second half of it.
base::Result<Shape> walkTogether(const RealismRun& run, int count) {
  Stage stage(run);
  for (int i = 0; i < count; ++i) {
    Stage::Actor actor;
    actor.start = Vec2(0.1 * i, 0.9 * i);
    actor.speed = 1.3;
    actor.group = 1;
    actor.target = endlessly(Vec2(1.0, 0.0));
    stage.add(actor);
  }
  Shape shape;
  double samples = 0.0;
  const bool isPlayed = stage.play(25.0, [&](const World& world) {
    const HumanColumns& people = world.frame().humans;
    if (people.x[0] < 15.0) {
      return true;
    }
    for (std::size_t i = 0; i < people.size(); ++i) {
      shape.speed += people.vx[i] / static_cast<double>(count);
    }
    for (std::size_t i = 1; i < people.size(); ++i) {
      const Vec2 apart(people.x[i] - people.x[i - 1], people.y[i] - people.y[i - 1]);
      shape.distance += apart.norm() / static_cast<double>(count - 1);
      shape.abreast += std::fabs(apart.y()) / apart.norm() / static_cast<double>(count - 1);
    }
    samples += 1.0;
    return people.x[0] < 30.0;
  });
  if (!isPlayed) {
    return base::makeError(stage.problem());
  }
  return Shape{shape.speed / samples, shape.distance / samples, shape.abreast / samples};
}

base::Result<std::vector<double>> groups(const RealismRun& run) {
  const base::Result<Shape> alone = walkTogether(run, 1);
  const base::Result<Shape> pair = walkTogether(run, 2);
  const base::Result<Shape> three = walkTogether(run, 3);
  if (!alone || !pair || !three) {
    return base::makeError("the groups could not be played");
  }
  return std::vector<double>{pair->distance, pair->abreast, three->abreast,
                             pair->speed / alone->speed, three->speed / alone->speed};
}

}  // namespace

void addWalkTests(std::vector<RealismTest>& tests) {
  tests.push_back({"rimea-1",
                   "RiMEA 1: 40 m of corridor alone at 1.33 m/s",
                   {{"time", "s", Summary::Mean, 26.0, 34.0}},
                   rimea1,
                   false});
  tests.push_back({"rimea-7",
                   "RiMEA 7: 50 people of each kind, alone",
                   {{"outside the kind's speeds", "m/s", Summary::Largest, 0.0, 0.0},
                    {"mean off the kind's", "", Summary::Mean, 0.0, 0.06}},
                   rimea7});
  tests.push_back({"groups",
                   "groups of two and three on 30 m of open ground",
                   {{"distance in a pair", "m", Summary::Mean, 0.4, 1.2},
                    {"pair abreast", "", Summary::Mean, 0.7, 1.0},
                    {"three abreast", "", Summary::Mean, 0.7, 1.0},
                    {"speed of a pair over alone", "", Summary::Mean, 0.85, 1.001},
                    {"speed of three over alone", "", Summary::Mean, 0.8, 1.001}},
                   groups,
                   false});
}

}  // namespace sim2d
