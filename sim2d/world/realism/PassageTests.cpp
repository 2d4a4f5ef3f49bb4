#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "sim2d/world/realism/RealismTest.h"

namespace sim2d {
namespace {

constexpr double kBody = 0.2;      // radius [m]
constexpr double kInside = 0.3;    // [m]; beyond the distance at which a target is reached
constexpr double kWideGoal = 2.0;  // [m], radius; a crowd arrives without a jam

/// Times at which people cross a line x = const, each person once.
class Gate {
 public:
  explicit Gate(double x) : x_(x) {}

  void look(const World& world) {
    const HumanColumns& people = world.frame().humans;
    for (std::size_t i = 0; i < people.size(); ++i) {
      if (people.x[i] > x_ && passed_.insert(people.id[i]).second) {
        times_.push_back(world.time());
      }
    }
  }
  const std::vector<double>& times() const { return times_; }
  /// Mean flow between the `first` and the `last` person to pass (1-based) [1/s]; NaN if they did
  /// not pass.
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
  std::set<int> passed_;  // person ids
  std::vector<double> times_;
};

/// An opening about y = 0 in a wall across the x axis.
struct Opening {
  double x = 0.0;          // front of the wall [m]
  double depth = 0.4;      // of the wall [m]
  double halfWidth = 0.5;  // [m]
};

/// Target towards the nearest point of the opening; inside and behind it straight on.
Vec2 openingTarget(const Opening& opening, const Vec2& place) {
  const bool isInside = place.x() > opening.x && std::fabs(place.y()) <= opening.halfWidth;
  if (isInside || place.x() > opening.x + opening.depth) {
    return {place.x() + 10.0, place.y()};
  }
  const double free = std::max(0.0, opening.halfWidth - kBody);
  return {opening.x + kInside, std::clamp(place.y(), -free, free)};
}

constexpr double kHalfWall = 0.1;  // [m]

/// Adds the walls of a room at y = -half and y = half from x = `from` on, and its end wall with the
/// opening.
void addRoomWalls(TestScene& stage, double from, double half, const Opening& opening) {
  for (const double sense : {-1.0, 1.0}) {
    const double side = sense * (half + kHalfWall);
    const double jamb = sense * (opening.halfWidth + kHalfWall);
    const double front = opening.x + kHalfWall;
    const double back = opening.x + opening.depth - kHalfWall;
    stage.addWall({Vec2(from, side), Vec2(back, side)});
    stage.addWall({Vec2(front, side), Vec2(front, jamb), Vec2(back, jamb), Vec2(back, side)});
  }
}

/// Adds `count` copies of a person at random places with individual speeds.
void addCrowd(TestScene& stage, const RealismRun& run, int count, const Box& box,
              TestScene::Actor like) {
  for (const Vec2& place : randomPlaces(run, count, box, 2.0 * kBody)) {
    like.start = place;
    like.speed = freeSpeed(run, static_cast<int>(stage.actors().size()));
    stage.add(like);
  }
}

/// A person who leaves the world at x = `end`.
TestScene::Actor actorLeavingAt(double end, TestScene::Target target) {
  return {Vec2::Zero(),      0.0,
          std::move(target), Vec2(end + kWideGoal, 0.0),
          kWideGoal,         [end](const Vec2& place) { return place.x() > end; }};
}

struct Door {
  double specificFlow = 0.0;  // [1/(m s)]
  double longestGap = 0.0;    // [s]
  double left = 0.0;          // people who did not pass
};

constexpr int kPeopleAtDoor = 100;
constexpr double kDoorDepth = 0.4;  // [m]

/// A room of 7 x 6 m filled with people who want to leave.
TestScene roomWithDoor(const RealismRun& run, double width, double dt) {
  TestScene stage(run, dt);
  const Opening opening{0.0, kDoorDepth, width / 2.0};
  addRoomWalls(stage, -7.2, 3.0, opening);
  stage.addWall({Vec2(-7.1, -3.1), Vec2(-7.1, 3.1)});
  addCrowd(stage, run, kPeopleAtDoor, {Vec2(-6.8, -2.8), Vec2(-0.2, 2.8)},
           actorLeavingAt(4.0, [=](const Vec2& place) { return openingTarget(opening, place); }));
  return stage;
}

Door passDoor(const RealismRun& run, double width, double dt) {
  Gate gate(kDoorDepth);
  roomWithDoor(run, width, dt).play(200.0, [&](const World& world) {
    gate.look(world);
    return world.frame().humans.size() > 0;
  });
  const auto left = static_cast<double>(kPeopleAtDoor) - static_cast<double>(gate.times().size());
  return {gate.flow(10, 85) / width, gate.longestGap(kPeopleAtDoor), left};
}

std::vector<double> passDoors(const RealismRun& run, double dt) {
  std::vector<double> values;
  double gap = 0.0;
  double left = 0.0;
  double rise = 1e9;
  for (const double width : {0.8, 1.0, 1.2, 1.8}) {
    const Door door = passDoor(run, width, dt);
    rise = values.empty() ? rise : std::min(rise, door.specificFlow - values.back());
    gap = std::max(gap, door.longestGap);
    left += door.left;
    values.push_back(door.specificFlow);
  }
  values.insert(values.end(), {rise, gap, left});
  return values;
}

/// Two rooms of 10 x 10 m connected by a corridor of 5 x 1 m; the second has an exit of 1 m.
TestScene twoRooms(const RealismRun& run) {
  TestScene stage(run);
  const Opening corridor{0.0, 5.0, 0.5};
  const Opening exit{15.0, 0.4, 0.5};
  addRoomWalls(stage, -10.2, 5.0, corridor);
  addRoomWalls(stage, 5.0, 5.0, exit);
  stage.addWall({Vec2(-10.1, -5.1), Vec2(-10.1, 5.1)});
  const auto target = [=](const Vec2& place) {
    return openingTarget(place.x() < 5.0 ? corridor : exit, place);
  };
  addCrowd(stage, run, 150, {Vec2(-9.8, -4.8), Vec2(-0.2, 4.8)}, actorLeavingAt(18.0, target));
  return stage;
}

std::vector<double> rimea12(const RealismRun& run) {
  Gate end(5.0);
  Gate out(15.4);
  double most = 0.0;
  twoRooms(run).play(250.0, [&](const World& world) {
    end.look(world);
    out.look(world);
    const std::vector<double>& x = world.frame().humans.x;
    const auto inside =
        std::count_if(x.begin(), x.end(), [](double at) { return at > 5.0 && at < 15.0; });
    most = std::max(most, static_cast<double>(inside));
    return out.times().size() < 120;
  });
  return {end.flow(20, 110) - out.flow(20, 110), most};
}

/// Twenty people around a left corner between walls 2 m apart.
TestScene cornerScene(const RealismRun& run) {
  TestScene stage(run);
  stage.usePlannedRoutes();
  stage.addWall({Vec2(-2.0, 2.1), Vec2(9.9, 2.1), Vec2(9.9, 16.0)});
  stage.addWall({Vec2(-2.0, 2.1), Vec2(-2.0, -0.1), Vec2(12.1, -0.1), Vec2(12.1, 16.0)});
  addCrowd(stage, run, 20, {Vec2(0.0, 0.2), Vec2(6.0, 1.8)},
           {Vec2::Zero(), 0.0, constantTarget(Vec2(11.0, 15.0)), std::nullopt, 1.0,
            [](const Vec2& at) { return at.y() > 12.0; }});
  return stage;
}

std::vector<double> corner(const RealismRun& run) {
  const TestScene stage = cornerScene(run);
  double inWall = 0.0;
  std::size_t left = stage.actors().size();
  stage.play(60.0, [&](const World& world) {
    const HumanColumns& people = world.frame().humans;
    for (std::size_t i = 0; i < people.size(); ++i) {
      inWall += people.x[i] < 10.0 && people.y[i] > 2.0 ? 1.0 : 0.0;
    }
    left = people.size();
    return left > 0;
  });
  return {inWall, static_cast<double>(left)};
}

/// A hundred people in a corridor 4 m wide: straight for `length`, or around a corner with 10 m of
/// inner wall on both sides.
TestScene wideCorridor(const RealismRun& run, bool isCorner, double length) {
  constexpr int kPeople = 100;
  TestScene stage(run);
  const double end = isCorner ? 10.0 : length + 8.0;
  std::vector<Vec2> leftWall = {Vec2(-17.1, 4.1), Vec2(end - kHalfWall, 4.1)};
  std::vector<Vec2> rightWall = {Vec2(-17.1, 4.1), Vec2(-17.1, -0.1), Vec2(end + 4.1, -0.1)};
  if (isCorner) {
    stage.usePlannedRoutes();
    leftWall.emplace_back(end - kHalfWall, 22.0);
    rightWall.emplace_back(end + 4.1, 22.0);
  }
  stage.addWall(leftWall);
  stage.addWall(rightWall);
  addCrowd(
      stage, run, kPeople, {Vec2(-15.0, 0.2), Vec2(0.0, 3.8)},
      {Vec2::Zero(), 0.0,
       isCorner ? constantTarget(Vec2(12.0, 21.0)) : endlessTarget(Vec2(1.0, 0.0)), std::nullopt,
       kWideGoal, [=](const Vec2& at) { return isCorner ? at.y() > 14.0 : at.x() > length; }});
  return stage;
}

/// Time until all people have passed.
double passageTime(const RealismRun& run, bool isCorner, double length) {
  double time = std::numeric_limits<double>::quiet_NaN();
  wideCorridor(run, isCorner, length).play(200.0, [&](const World& world) {
    time = world.frame().humans.size() == 0 ? world.time() : time;
    return world.frame().humans.size() > 0;
  });
  return time;
}

std::vector<double> rimea15(const RealismRun& run) {
  try {
    const double shorter = passageTime(run, false, 20.0);
    const double corner = passageTime(run, true, 0.0);
    const double longer = passageTime(run, false, 28.0);
    return {corner - shorter, longer - corner};
  } catch (const SceneFailed&) {
    throw SceneFailed{base::error("run.corridors-not-played")};
  }
}

}  // namespace

void addPassageTests(std::vector<RealismTest>& tests);
void addPassageTests(std::vector<RealismTest>& tests) {
  const Quantities ofDoors = {{"specific flow, 0.8 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
                              {"specific flow, 1.0 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
                              {"specific flow, 1.2 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
                              {"specific flow, 1.8 m", "1/(m s)", Summary::Mean, 1.2, 2.1},
                              {"minimum increase with width", "1/(m s)", Summary::Mean, 0.0},
                              {"longest time gap", "s", Summary::Largest, 0.0, 10.0},
                              {"people who did not arrive", "", Summary::Largest, 0.0, 0.0}};
  tests.push_back({"bottleneck", "100 people through a door of 0.8, 1.0, 1.2 and 1.8 m", ofDoors,
                   [](const RealismRun& run) { return passDoors(run, 0.05); },
                   [](const RealismRun& run) { return roomWithDoor(run, 1.0, 0.05); }, true,
                   100.0});
  tests.push_back({"bottleneck-long-steps", "the same with time steps of 0.1 s", ofDoors,
                   [](const RealismRun& run) { return passDoors(run, 0.1); },
                   [](const RealismRun& run) { return roomWithDoor(run, 1.0, 0.1); }, true, 100.0});
  tests.push_back({"corner", "RiMEA 6: 20 people around a corner between walls 2 m apart",
                   Quantities{{"people inside the wall", "", Summary::Largest, 0.0, 0.0},
                              {"people who did not arrive", "", Summary::Largest, 0.0, 0.0}},
                   corner, cornerScene});
  tests.push_back(
      {"rimea-12", "RiMEA 12: 150 people, room, corridor of 1 m, room, exit of 1 m",
       Quantities{{"flow of corridor minus exit", "1/s", Summary::Mean, -0.05},
                  {"maximum people in the second room", "", Summary::Largest, 0.0, 25.0}},
       rimea12, twoRooms, true, 100.0});
  tests.push_back({"rimea-15",
                   "RiMEA 15 with 100 people: time around a corner compared with straight "
                   "corridors",
                   Quantities{{"corner minus inner length", "s", Summary::Mean, 0.0},
                              {"outer length minus corner", "s", Summary::Mean, 0.0}},
                   rimea15, [](const RealismRun& run) { return wideCorridor(run, true, 0.0); },
                   true, 80.0});
}

}  // namespace sim2d
