#include <algorithm>
#include <cmath>

#include "sim2d/world/realism/RealismTest.h"

namespace sim2d {
namespace {

constexpr double kArrived = 0.3;   // [m] from the goal
constexpr double kStarted = 2.0;   // [s]; speeds are measured from here on
constexpr double kPatience = 6.0;  // times the duration of a straight walk

TestScene::Actor walker(const Vec2& start, const Vec2& goal, double speed) {
  TestScene::Actor actor{start, speed, constantTarget(goal)};
  actor.heading = base::headingOf(goal - start);
  actor.isDone = [goal](const Vec2& place) { return (place - goal).norm() < kArrived; };
  return actor;
}

void look(const HumanColumns& people, double time, Meeting& meeting) {
  for (std::size_t i = 0; i < people.size(); ++i) {
    if (time > kStarted) {
      meeting.slowest = std::min(meeting.slowest, Vec2(people.vx[i], people.vy[i]).norm());
    }
    for (std::size_t k = i + 1; k < people.size(); ++k) {
      const Vec2 apart(people.x[i] - people.x[k], people.y[i] - people.y[k]);
      meeting.leastDistance = std::min(meeting.leastDistance, apart.norm());
    }
  }
}

/// All people walk the same distance; if one never arrives, the ratio is NaN.
Meeting meet(const TestScene& stage, double length, double speed) {
  Meeting meeting;
  meeting.leastDistance = meeting.slowest = 1e9;
  meeting.timeRatio = std::numeric_limits<double>::quiet_NaN();
  const double freeTime = (length - kArrived) / speed;
  stage.play(kPatience * freeTime, [&](const World& world) {
    if (world.frame().humans.size() == 0) {
      meeting.timeRatio = world.time() / freeTime;
      return false;
    }
    look(world.frame().humans, world.time(), meeting);
    return true;
  });
  return meeting;
}

/// Results that should not depend on the time step.
struct WalkResult {
  std::vector<Vec2> places;     // final positions
  std::vector<double> numbers;  // length of each path, minimum distance between two people [m]
};

/// Minimum distance of two people who moved straight from `before` to `after`, both relative
/// positions.
double nearestBetween(const Vec2& before, const Vec2& after) {
  const Vec2 moved = after - before;
  const double share = -before.dot(moved) / std::max(moved.squaredNorm(), 1e-12);
  return (before + std::clamp(share, 0.0, 1.0) * moved).norm();
}

void addStep(const std::vector<Vec2>& places, WalkResult& walked) {
  for (std::size_t i = 0; i < places.size(); ++i) {
    walked.numbers[i] += (places[i] - walked.places[i]).norm();
    for (std::size_t k = i + 1; k < places.size(); ++k) {
      walked.numbers.back() =
          std::min(walked.numbers.back(),
                   nearestBetween(walked.places[k] - walked.places[i], places[k] - places[i]));
    }
  }
  walked.places = places;
}

/// Three people with crossing paths.
TestScene threeCrossingPaths(const RealismRun& run, double dt) {
  TestScene stage(run, dt);
  stage.add(walker(Vec2(-6.0, 0.0), Vec2(40.0, 0.0), 1.3));
  stage.add(walker(Vec2(0.5, -5.0), Vec2(0.5, 40.0), 1.2));
  stage.add(walker(Vec2(6.0, 0.4), Vec2(-40.0, 0.4), 1.1));
  return stage;
}

/// Walks for 10 s with a time step of `dt`.
WalkResult walkWithStep(const RealismRun& run, double dt) {
  const TestScene stage = threeCrossingPaths(run, dt);
  WalkResult walked;
  for (const TestScene::Actor& actor : stage.actors()) {
    walked.places.push_back(actor.start);
  }
  walked.numbers.assign(walked.places.size(), 0.0);
  walked.numbers.push_back(1e9);
  stage.play(10.0, [&](const World& world) {
    const HumanColumns& people = world.frame().humans;
    std::vector<Vec2> places;
    for (std::size_t i = 0; i < people.size(); ++i) {
      places.emplace_back(people.x[i], people.y[i]);
    }
    addStep(places, walked);
    return true;
  });
  return walked;
}

std::vector<double> timeStep(const RealismRun& run) {
  const WalkResult finest = walkWithStep(run, 0.01);
  std::vector<double> values;
  double change = 0.0;
  for (const double dt : {0.1, 0.05, 0.02}) {
    const WalkResult walked = walkWithStep(run, dt);
    double worst = 0.0;
    for (std::size_t i = 0; i < walked.places.size(); ++i) {
      worst = std::max(worst, (walked.places[i] - finest.places[i]).norm());
    }
    for (std::size_t i = 0; i < walked.numbers.size(); ++i) {
      change = std::max(change, std::fabs(walked.numbers[i] / finest.numbers[i] - 1.0));
    }
    values.push_back(worst);
  }
  values.push_back(change);
  return values;
}

TestScene circleOf(const RealismRun& run, int count, double radius) {
  TestScene stage(run);
  for (int i = 0; i < count; ++i) {
    const Vec2 place = radius * base::directionOf(base::wrapToPi(2.0 * base::kPi * i / count));
    stage.add(walker(place, -place, 1.34));
  }
  return stage;
}

TestScene headOnScene(const RealismRun& run) {
  TestScene stage(run);
  stage.add(walker(Vec2(-6.0, 0.0), Vec2(6.0, 0.0), 1.29));
  stage.add(walker(Vec2(6.0, 0.0), Vec2(-6.0, 0.0), 1.29));
  return stage;
}

TestScene crossingScene(const RealismRun& run) {
  TestScene stage(run);
  stage.add(walker(Vec2(-5.0, 0.0), Vec2(5.0, 0.0), 1.3));
  stage.add(walker(Vec2(0.0, -5.0), Vec2(0.0, 5.0), 1.3));
  return stage;
}

std::vector<double> circles(const RealismRun& run) {
  const Meeting eight = circle(run, 8, 4.0);
  const Meeting sixteen = circle(run, 16, 5.0);
  return {eight.leastDistance, eight.timeRatio, sixteen.leastDistance, sixteen.timeRatio};
}

std::vector<double> headOnValues(const RealismRun& run) {
  const Meeting meeting = headOn(run);
  return {meeting.leastDistance, meeting.slowest};
}

/// Two people with paths that cross at a right angle.
std::vector<double> crossingValues(const RealismRun& run) {
  const Meeting meeting = meet(crossingScene(run), 10.0, 1.3);
  return {meeting.leastDistance, 1.0 - meeting.slowest / 1.3};
}

}  // namespace

Meeting circle(const RealismRun& run, int count, double radius) {
  return meet(circleOf(run, count, radius), 2.0 * radius, 1.34);
}

Meeting headOn(const RealismRun& run) {
  return meet(headOnScene(run), 12.0, 1.29);
}

void addMeetingTests(std::vector<RealismTest>& tests);
void addMeetingTests(std::vector<RealismTest>& tests) {
  tests.push_back({"circle", "8 and 16 people who swap positions across a circle of 4 and 5 m",
                   Quantities{{"minimum distance, 8", "m", Summary::Smallest, 0.4},
                              {"time / free time, 8", "", Summary::Largest, 1.0, 2.0},
                              {"minimum distance, 16", "m", Summary::Smallest, 0.4},
                              {"time / free time, 16", "", Summary::Largest, 1.0, 2.5}},
                   circles, [](const RealismRun& run) { return circleOf(run, 16, 5.0); }, false});
  tests.push_back({"head-on", "two people exactly head-on at 1.29 m/s",
                   Quantities{{"minimum distance", "m", Summary::Smallest, 0.44},
                              {"minimum speed", "m/s", Summary::Smallest, 1.0}},
                   headOnValues, headOnScene, false});
  tests.push_back({"crossing", "two people whose paths cross at 90 degrees",
                   Quantities{{"minimum distance", "m", Summary::Smallest, 0.4},
                              {"loss of speed", "", Summary::Largest, 0.0, 0.4}},
                   crossingValues, crossingScene, false});
  tests.push_back(
      {"time-step",
       "positions after 10 s with time steps of 0.1, 0.05 and 0.02 s compared with "
       "0.01 s",
       Quantities{{"distance, 0.1 s", "m", Summary::Largest, 0.0, 0.05},
                  {"distance, 0.05 s", "m", Summary::Largest, 0.0, 0.05},
                  {"distance, 0.02 s", "m", Summary::Largest, 0.0, 0.05},
                  {"change of paths and minimum distance", "", Summary::Largest, 0.0, 0.02}},
       timeStep, [](const RealismRun& run) { return threeCrossingPaths(run, 0.05); }, false});
}

}  // namespace sim2d
