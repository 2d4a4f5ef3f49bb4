#include <algorithm>
#include <cmath>
#include <map>

#include "sim2d/world/realism/RealismTest.h"

namespace sim2d {
namespace {

constexpr double kBody = 0.2;      // radius [m]
constexpr double kInside = 0.3;    // [m]; farther in than the distance at which a target is reached
constexpr double kWideGoal = 2.0;  // [m], radius; a crowd arrives without a jam

/// Times at which people pass a line across the x axis, each person once.
class Gate {
 public:
  explicit Gate(double x) : x_(x) {}

  void look(const World& world) {
    const HumanColumns& people = world.frame().humans;
    for (std::size_t i = 0; i < people.size(); ++i) {
      const bool isBehind = people.x[i] > x_;
      bool& was = passed_[people.id[i]];
      if (isBehind && !was) {
        times_.push_back(world.time());
        was = true;
      }
    }
  }
  const std::vector<double>& times() const { return times_; }
  /// Between the `first` and the `last` person to pass (from 1) [1/s]; NaN when they did not.
  double flow(std::size_t first, std::size_t last) const {
    if (times_.size() < last) {
      return std::numeric_limits<double>::quiet_NaN();
    }
    return static_cast<double>(last - first) / (times_[last - 1] - times_[first - 1]);
  }
  double longestGap(std::size_t upTo) const {
    double longest = 0.0;
    for (std::size_t i = 1; i < std::min(upTo, times_.size()); ++i) {
      longest = std::max(longest, times_[i] - times_[i - 1]);
    }
    return longest;
  }

 private:
  double x_;
  std::map<int, bool> passed_;
  std::vector<double> times_;
};

/// An opening in a wall across the x axis, about y = 0.
struct Opening {
  double x = 0.0;          // where it begins [m]
  double depth = 0.4;      // of the wall [m]
  double halfWidth = 0.5;  // [m]
};

/// Towards its nearest place, inside and behind it straight on.
Vec2 throughOpening(const Opening& opening, const Vec2& place) {
  const bool isInside = place.x() > opening.x && std::fabs(place.y()) <= opening.halfWidth;
  if (isInside || place.x() > opening.x + opening.depth) {
    return {place.x() + 10.0, place.y()};
  }
  const double free = std::max(0.0, opening.halfWidth - kBody);
  return {opening.x + kInside, std::clamp(place.y(), -free, free)};
}

constexpr double kHalfWall = 0.1;  // [m]

/// The walls of a room beside y = -half and y = half from x = `from` on, and the one with the
/// opening, where it ends.
void addRoom(TestScene& stage, double from, double half, const Opening& opening) {
  for (const double sense : {-1.0, 1.0}) {
    const double side = sense * (half + kHalfWall);
    const double jamb = sense * (opening.halfWidth + kHalfWall);
    const double front = opening.x + kHalfWall;
    const double back = opening.x + opening.depth - kHalfWall;
    stage.addWall({Vec2(from, side), Vec2(back, side)});
    stage.addWall({Vec2(front, side), Vec2(front, jamb), Vec2(back, jamb), Vec2(back, side)});
  }
}

void addCrowd(TestScene& stage, const RealismRun& run, int count, const Box& box,
              const TestScene::Target& target, double leavesAt) {
  const std::vector<Vec2> places = randomPlaces(run, count, box, 2.0 * kBody);
  for (std::size_t i = 0; i < places.size(); ++i) {
    stage.add({places[i], freeSpeed(run, static_cast<int>(i)), target,
               Vec2(leavesAt + kWideGoal, 0.0), kWideGoal,
               [leavesAt](const Vec2& place) { return place.x() > leavesAt; }});
  }
}

struct Door {
  double specificFlow = 0.0;  // [1/(m s)]
  double longestGap = 0.0;    // [s]
  double left = 0.0;          // people who never got through
};

constexpr int kPeopleAtDoor = 100;
constexpr double kDoorDepth = 0.4;  // [m]

/// A room of 7 x 6 m full of people who want to leave.
TestScene roomWithDoor(const RealismRun& run, double width, double dt) {
  TestScene stage(run, dt);
  const Opening opening{0.0, kDoorDepth, width / 2.0};
  addRoom(stage, -7.2, 3.0, opening);
  stage.addWall({Vec2(-7.1, -3.1), Vec2(-7.1, 3.1)});
  addCrowd(
      stage, run, kPeopleAtDoor, {Vec2(-6.8, -2.8), Vec2(-0.2, 2.8)},
      [opening](const Vec2& place) { return throughOpening(opening, place); }, 4.0);
  return stage;
}

base::Result<Door> passDoor(const RealismRun& run, double width, double dt) {
  TestScene stage = roomWithDoor(run, width, dt);
  Gate gate(kDoorDepth);
  const bool isPlayed = stage.play(200.0, [&](const World& world) {
    gate.look(world);
    return world.frame().humans.size() > 0;
  });
  const auto left = static_cast<double>(kPeopleAtDoor) - static_cast<double>(gate.times().size());
  return stage.orProblem(isPlayed,
                         Door{gate.flow(10, 85) / width, gate.longestGap(kPeopleAtDoor), left});
}

base::Result<std::vector<double>> passDoors(const RealismRun& run, double dt) {
  std::vector<double> values;
  double gap = 0.0;
  double left = 0.0;
  double rise = 1e9;
  for (const double width : {0.8, 1.0, 1.2, 1.8}) {
    const base::Result<Door> door = passDoor(run, width, dt);
    if (!door) {
      return door.diagnostics();
    }
    const double flow = door->specificFlow;
    rise = values.empty() ? rise : std::min(rise, flow - values.back());
    gap = std::max(gap, door->longestGap);
    left += door->left;
    values.push_back(flow);
  }
  values.insert(values.end(), {rise, gap, left});
  return values;
}

/// Two rooms of 10 x 10 m joined by a corridor of 5 x 1 m; the second has an exit of 1 m.
TestScene twoRooms(const RealismRun& run) {
  TestScene stage(run);
  const Opening corridor{0.0, 5.0, 0.5};
  const Opening exit{15.0, 0.4, 0.5};
  addRoom(stage, -10.2, 5.0, corridor);
  addRoom(stage, 5.0, 5.0, exit);
  stage.addWall({Vec2(-10.1, -5.1), Vec2(-10.1, 5.1)});
  addCrowd(
      stage, run, 150, {Vec2(-9.8, -4.8), Vec2(-0.2, 4.8)},
      [=](const Vec2& place) { return throughOpening(place.x() < 5.0 ? corridor : exit, place); },
      18.0);
  return stage;
}

base::Result<std::vector<double>> rimea12(const RealismRun& run) {
  TestScene stage = twoRooms(run);
  Gate end(5.0);
  Gate out(15.4);
  double most = 0.0;
  const bool isPlayed = stage.play(250.0, [&](const World& world) {
    end.look(world);
    out.look(world);
    const std::vector<double>& x = world.frame().humans.x;
    const auto inside =
        std::count_if(x.begin(), x.end(), [](double at) { return at > 5.0 && at < 15.0; });
    most = std::max(most, static_cast<double>(inside));
    return out.times().size() < 120;
  });
  return stage.orProblem(isPlayed,
                         std::vector<double>{end.flow(20, 110) - out.flow(20, 110), most});
}

/// Twenty people round a left corner between walls 2 m apart.
TestScene cornerScene(const RealismRun& run) {
  TestScene stage(run);
  stage.planWays();
  stage.addWall({Vec2(-2.0, 2.1), Vec2(9.9, 2.1), Vec2(9.9, 16.0)});
  stage.addWall({Vec2(-2.0, 2.1), Vec2(-2.0, -0.1), Vec2(12.1, -0.1), Vec2(12.1, 16.0)});
  for (const Vec2& place : randomPlaces(run, 20, {Vec2(0.0, 0.2), Vec2(6.0, 1.8)}, 2.0 * kBody)) {
    stage.add({place, freeSpeed(run, static_cast<int>(stage.actors().size())),
               always(Vec2(11.0, 15.0)), std::nullopt, 1.0,
               [](const Vec2& at) { return at.y() > 12.0; }});
  }
  return stage;
}

base::Result<std::vector<double>> corner(const RealismRun& run) {
  TestScene stage = cornerScene(run);
  double inWall = 0.0;
  std::size_t left = stage.actors().size();
  const bool isPlayed = stage.play(60.0, [&](const World& world) {
    const HumanColumns& people = world.frame().humans;
    for (std::size_t i = 0; i < people.size(); ++i) {
      inWall += people.x[i] < 10.0 && people.y[i] > 2.0 ? 1.0 : 0.0;
    }
    left = people.size();
    return left > 0;
  });
  return stage.orProblem(isPlayed, std::vector<double>{inWall, static_cast<double>(left)});
}

/// A hundred people in a corridor 4 m wide: straight on for `length`, or round a corner with 10 m
/// of inner wall on both sides of it.
TestScene wideCorridor(const RealismRun& run, bool isCorner, double length) {
  constexpr int kPeople = 100;
  TestScene stage(run);
  const double end = isCorner ? 10.0 : length + 8.0;
  std::vector<Vec2> leftWall = {Vec2(-17.1, 4.1), Vec2(end - kHalfWall, 4.1)};
  std::vector<Vec2> rightWall = {Vec2(-17.1, 4.1), Vec2(-17.1, -0.1), Vec2(end + 4.1, -0.1)};
  if (isCorner) {
    stage.planWays();
    leftWall.emplace_back(end - kHalfWall, 22.0);
    rightWall.emplace_back(end + 4.1, 22.0);
  }
  stage.addWall(leftWall);
  stage.addWall(rightWall);
  const Box box{Vec2(-15.0, 0.2), Vec2(0.0, 3.8)};
  for (const Vec2& place : randomPlaces(run, kPeople, box, 2.0 * kBody)) {
    stage.add({place, freeSpeed(run, static_cast<int>(stage.actors().size())),
               isCorner ? always(Vec2(12.0, 21.0)) : endlessly(Vec2(1.0, 0.0)), std::nullopt,
               kWideGoal,
               [=](const Vec2& at) { return isCorner ? at.y() > 14.0 : at.x() > length; }});
  }
  return stage;
}

/// Until all have passed.
base::Result<double> timeThrough(const RealismRun& run, bool isCorner, double length) {
  TestScene stage = wideCorridor(run, isCorner, length);
  double time = std::numeric_limits<double>::quiet_NaN();
  const bool isPlayed = stage.play(200.0, [&](const World& world) {
    time = world.frame().humans.size() == 0 ? world.time() : time;
    return world.frame().humans.size() > 0;
  });
  return stage.orProblem(isPlayed, time);
}

base::Result<std::vector<double>> rimea15(const RealismRun& run) {
  const base::Result<double> shorter = timeThrough(run, false, 20.0);
  const base::Result<double> corner = timeThrough(run, true, 0.0);
  const base::Result<double> longer = timeThrough(run, false, 28.0);
  if (!shorter || !corner || !longer) {
    return base::error("run.corridors-not-played");
  }
  return std::vector<double>{*corner - *shorter, *longer - *corner};
}

}  // namespace

void addPassageTests(std::vector<RealismTest>& tests);
void addPassageTests(std::vector<RealismTest>& tests) {
  const std::vector<Quantity> ofDoors = {
      {"specific flow, 0.8 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
      {"specific flow, 1.0 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
      {"specific flow, 1.2 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
      {"specific flow, 1.8 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
      {"least rise with width", "1/(m s)", Summary::Mean, 0.0},
      {"longest gap", "s", Summary::Largest, 0.0, 10.0},
      {"people left behind", "", Summary::Largest, 0.0, 0.0}};
  tests.push_back({"bottleneck", "100 people through a door of 0.8, 1.0, 1.2 and 1.8 m", ofDoors,
                   [](const RealismRun& run) { return passDoors(run, 0.05); },
                   [](const RealismRun& run) { return roomWithDoor(run, 1.0, 0.05); }, true,
                   100.0});
  tests.push_back({"bottleneck-long-steps", "the same with steps of 0.1 s", ofDoors,
                   [](const RealismRun& run) { return passDoors(run, 0.1); },
                   [](const RealismRun& run) { return roomWithDoor(run, 1.0, 0.1); }, true, 100.0});
  tests.push_back({"corner",
                   "RiMEA 6: 20 people round a corner between walls 2 m apart",
                   {{"people seen in the wall", "", Summary::Largest, 0.0, 0.0},
                    {"people left behind", "", Summary::Largest, 0.0, 0.0}},
                   corner,
                   cornerScene});
  tests.push_back({"rimea-12",
                   "RiMEA 12: 150 people, room, corridor of 1 m, room, exit of 1 m",
                   {{"flow of corridor less exit", "1/s", Summary::Mean, -0.05},
                    {"most people in the second room", "", Summary::Largest, 0.0, 25.0}},
                   rimea12,
                   twoRooms,
                   true,
                   100.0});
  tests.push_back({"rimea-15",
                   "RiMEA 15 with 100 people: time round a corner against straight corridors",
                   {{"corner less inner length", "s", Summary::Mean, 0.0},
                    {"outer length less corner", "s", Summary::Mean, 0.0}},
                   rimea15,
                   [](const RealismRun& run) { return wideCorridor(run, true, 0.0); },
                   true,
                   80.0});
}

}  // namespace sim2d
