#include <algorithm>
#include <array>
#include <cmath>

#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/world/WorldState.h"
#include "sim2d/world/realism/RealismTest.h"

namespace sim2d {
namespace {

constexpr double kLength = 40.0;  // [m]

/// Adds a corridor of 2 m width about y = `middle` with one person.
void addCorridor(TestScene& stage, double middle, double desiredSpeed, double radius) {
  stage.addWall({Vec2(-2.0, middle - 1.1), Vec2(kLength + 4.0, middle - 1.1)});
  stage.addWall({Vec2(-2.0, middle + 1.1), Vec2(kLength + 4.0, middle + 1.1)});
  TestScene::Actor actor{Vec2(0.0, middle), desiredSpeed, endlessTarget(Vec2(1.0, 0.0)),
                         Vec2(kLength, middle)};
  actor.radius = radius;
  stage.add(actor);
}

TestScene corridorAlone(const RealismRun& run, double desiredSpeed, double radius) {
  TestScene stage(run);
  addCorridor(stage, 0.0, desiredSpeed, radius);
  return stage;
}

/// Mean speed of one person over the length of a corridor [m/s].
double speedAlone(const RealismRun& run, double desiredSpeed, double radius) {
  double time = std::numeric_limits<double>::quiet_NaN();
  corridorAlone(run, desiredSpeed, radius).play(400.0, [&](const World& world) {
    const bool isThrough = world.frame().humans.x[0] >= kLength;
    time = isThrough ? world.time() : time;
    return !isThrough;
  });
  return kLength / time;
}

std::vector<double> rimea1(const RealismRun& run) {
  return {40.0 / speedAlone(run, 1.33, 0.2)};
}

constexpr std::array<PersonKind, 5> kKinds = {PersonKind::Adult, PersonKind::Child,
                                              PersonKind::Elderly, PersonKind::Wheelchair,
                                              PersonKind::Luggage};

/// One person of each kind in parallel corridors.
TestScene rimea7Scene(const RealismRun& run) {
  TestScene stage(run);
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    addCorridor(stage, 3.0 * static_cast<double>(i), sampleSpeed(kKinds[i], run.seed, 0),
                profileOf(kKinds[i]).radius);
  }
  return stage;
}

/// Fifty people of each kind, each alone: largest deviation outside the speed range of the kind,
/// and largest relative deviation of the mean.
std::vector<double> rimea7(const RealismRun& run) {
  double outside = 0.0;
  double off = 0.0;
  for (const PersonKind kind : kKinds) {
    const KindProfile& profile = profileOf(kind);
    constexpr int kPeople = 50;
    double sum = 0.0;
    for (int person = 0; person < kPeople; ++person) {
      const double speed = speedAlone(run, sampleSpeed(kind, run.seed, person), profile.radius);
      sum += speed;
      outside = std::max({outside, 0.95 * profile.slowest - speed, speed - profile.fastest});
    }
    off = std::max(off, std::fabs(sum / kPeople - profile.meanSpeed) / profile.meanSpeed);
  }
  return {outside, off};
}

struct Shape {
  double speed = 0.0;     // [m/s]
  double distance = 0.0;  // mean between neighbours in the row [m]
  double abreast = 0.0;   // fraction of it perpendicular to the path
};

void addGroup(TestScene& stage, int group, int count, double side) {
  for (int i = 0; i < count; ++i) {
    TestScene::Actor actor{Vec2(0.1 * i, side + 0.9 * i), 1.3, endlessTarget(Vec2(1.0, 0.0)),
                           Vec2(40.0, side), 3.0};
    actor.group = group;
    stage.add(actor);
  }
}

TestScene groupsScene(const RealismRun& run) {
  TestScene stage(run);
  addGroup(stage, 1, 2, 0.0);
  addGroup(stage, 2, 3, 15.0);
  return stage;
}

/// A group of `count` on 30 m of open ground, measured in the second half.
Shape walkTogether(const RealismRun& run, int count) {
  TestScene stage(run);
  addGroup(stage, 1, count, 0.0);
  Shape shape;
  double samples = 0.0;
  stage.play(25.0, [&](const World& world) {
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
  return {shape.speed / samples, shape.distance / samples, shape.abreast / samples};
}

std::vector<double> groups(const RealismRun& run) {
  try {
    const Shape alone = walkTogether(run, 1);
    const Shape pair = walkTogether(run, 2);
    const Shape three = walkTogether(run, 3);
    return {pair.distance, pair.abreast, three.abreast, pair.speed / alone.speed,
            three.speed / alone.speed};
  } catch (const SceneFailed&) {
    throw SceneFailed{base::error("run.groups-not-played")};
  }
}

constexpr int kGroupsOfThree = 8;  // number of groups
constexpr double kTogether = 2.0;  // [m] along the path; a group farther apart has no shape

/// Sorts places so that `count` groups of three neighbours come first.
std::vector<Vec2> groupPlacesByThree(std::vector<Vec2> places, int count) {
  for (int group = 0; group < count; ++group) {
    const auto first = places.begin() + std::ptrdiff_t{3} * group;
    const Vec2 middle = *first;
    std::sort(first + 1, places.end(), [&middle](const Vec2& a, const Vec2& b) {
      return (a - middle).squaredNorm() < (b - middle).squaredNorm();
    });
  }
  return places;
}

/// Distance by which the middle one of three walks behind the outer two [m]; NaN if they are not
/// together.
double vShapeDepth(const HumanColumns& people, std::size_t first) {
  const PeriodicCorridor ring{0.0, kRingLength};
  std::array<Vec2, 3> places;
  const Vec2 origin(people.x[first], people.y[first]);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec2 place(people.x[first + i], people.y[first + i]);
    places[i] = place + ring.shift(place, origin) - origin;
  }
  std::sort(places.begin(), places.end(),
            [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  for (const Vec2& place : places) {
    if (std::fabs(place.x() - places[1].x()) > kTogether) {
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  return (places[0].x() + places[2].x()) / 2.0 - places[1].x();
}

/// Groups of three among others, one person per m², in a closed corridor 4 m wide.
TestScene groupsInCrowdScene(const RealismRun& run) {
  constexpr int kPeople = 104;
  TestScene stage(run);
  stage.addRing(4.0);
  const std::vector<Vec2> places = groupPlacesByThree(
      randomPlaces(run, kPeople, {Vec2(0.0, 0.2), Vec2(kRingLength, 3.8)}, 0.4, true),
      kGroupsOfThree);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto person = static_cast<int>(i);
    const bool isInGroup = person < 3 * kGroupsOfThree;
    TestScene::Actor actor = ringWalker(places[i], isInGroup ? 1.3 : freeSpeed(run, person));
    actor.group = isInGroup ? 1 + person / 3 : -1;
    stage.add(actor);
  }
  return stage;
}

/// Depth of the V, and fraction of the time in which a group is together.
std::vector<double> groupsInCrowd(const RealismRun& run) {
  double depth = 0.0;
  double together = 0.0;
  double samples = 0.0;
  groupsInCrowdScene(run).play(60.0, [&](const World& world) {
    for (std::size_t group = 0; world.time() > 30.0 && group < kGroupsOfThree; ++group) {
      const double found = vShapeDepth(world.frame().humans, 3 * group);
      depth += std::isnan(found) ? 0.0 : found;
      together += std::isnan(found) ? 0.0 : 1.0;
      samples += 1.0;
    }
    return true;
  });
  return {depth / together, together / samples};
}

}  // namespace

void addWalkTests(std::vector<RealismTest>& tests);
void addWalkTests(std::vector<RealismTest>& tests) {
  tests.push_back({"rimea-1", "RiMEA 1: one person in a corridor of 40 m at 1.33 m/s",
                   Quantities{{"time", "s", Summary::Mean, 26.0, 34.0}}, rimea1,
                   [](const RealismRun& run) { return corridorAlone(run, 1.33, 0.2); }, false});
  tests.push_back(
      {"rimea-7", "RiMEA 7: 50 people of each kind, alone",
       Quantities{{"deviation from the kind's speed range", "m/s", Summary::Largest, 0.0, 0.0},
                  {"deviation from the kind's mean", "", Summary::Mean, 0.0, 0.06}},
       rimea7, rimea7Scene, true, 70.0});
  tests.push_back({"groups", "groups of two and three on 30 m of open ground",
                   Quantities{{"distance in a pair", "m", Summary::Mean, 0.4, 1.2},
                              {"pair side by side", "", Summary::Mean, 0.7, 1.0},
                              {"three side by side", "", Summary::Mean, 0.7, 1.0},
                              {"speed of a pair / alone", "", Summary::Mean, 0.85, 1.001},
                              {"speed of three / alone", "", Summary::Mean, 0.8, 1.001}},
                   groups, groupsScene, false});
  tests.push_back({"groups-in-crowd", "groups of three among others, 1 person per m²",
                   Quantities{{"middle member behind the outer two", "m", Summary::Mean, 0.0},
                              {"share of time together", "", Summary::Mean, 0.8, 1.0}},
                   groupsInCrowd, groupsInCrowdScene});
}

}  // namespace sim2d
