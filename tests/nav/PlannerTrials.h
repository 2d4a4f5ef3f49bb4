#pragma once

#include <QtTest>

#include "tests/nav/DrivenRobot.h"

/// Trials that every planner that gives way to people stands, as rows and checks of Qt Test.
namespace trials {

using namespace driven;

struct Trial {
  std::string name;
  Pose2 start;
  Vec2 goal = Vec2::Zero();
  std::vector<TrackedBody> people;
  std::vector<std::pair<Vec2, Vec2>> blocks;
  double seconds = 60.0;  // in which it has to arrive
  int mostTurns = 8;      // changes of the side to which it turns
};

/// Two walls with an opening of `width` at the origin, across the way along x.
inline std::vector<std::pair<Vec2, Vec2>> doorway(double width) {
  return {{Vec2(-0.1, 0.5 * width), Vec2(0.1, 6.0)}, {Vec2(-0.1, -6.0), Vec2(0.1, -0.5 * width)}};
}

/// Along x, so wide.
inline std::vector<std::pair<Vec2, Vec2>> corridor(double width) {
  return {{Vec2(-9.0, 0.5 * width), Vec2(9.0, 0.5 * width + 0.3)},
          {Vec2(-9.0, -0.5 * width - 0.3), Vec2(9.0, -0.5 * width)}};
}

inline std::vector<Trial> allTrials() {
  using Blocks = std::vector<std::pair<Vec2, Vec2>>;
  const Pose2 west{Vec2(-5.0, 0.0), 0.0};
  const Pose2 middle{Vec2(0.0, 0.0), 0.0};
  const Vec2 east(5.0, 0.0);
  const Vec2 none = Vec2::Zero();
  std::vector<Trial> rows;
  const auto row = [&](const char* name, std::vector<TrackedBody> people, const Blocks& blocks = {},
                       double seconds = 40.0, int mostTurns = 8) {
    rows.push_back({name, west, east, std::move(people), blocks, seconds, mostTurns});
  };
  row("nobody", {}, {}, 20.0);
  rows.push_back({"goal behind", middle, Vec2(-4.0, 0.0), {}, {}, 25.0});
  rows.push_back({"goal beside", middle, Vec2(0.0, 3.0), {}, {}, 25.0});
  rows.push_back({"goal close beside", middle, Vec2(0.0, -0.6), {}, {}, 30.0});
  row("head on", {person(1, east, Vec2(-1.0, 0.0))});
  row("fast head on", {person(1, east, Vec2(-1.8, 0.01))});
  row("standing", {person(1, none, none)});
  row("crossing", {person(1, Vec2(0.0, -5.0), Vec2(0.0, 1.0))});
  row("overtaken", {person(1, Vec2(-8.0, 0.05), Vec2(1.6, 0.0))});
  row("slow ahead", {person(1, Vec2(-3.0, 0.0), Vec2(0.3, 0.0))});
  row("two abreast",
      {person(1, Vec2(5.0, 0.4), Vec2(-1.0, 0.0)), person(2, Vec2(5.0, -0.4), Vec2(-1.0, 0.0))});
  std::vector<TrackedBody> crowd;
  for (int i = 0; i < 12; ++i) {
    const double x = -3.0 + 0.6 * i;
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    crowd.push_back(person(i, Vec2(x, side * (2.0 + 0.7 * i)), Vec2(0.1 * side, -0.9 * side)));
  }
  row("crowd crossing", crowd, {}, 60.0, 16);
  row("doorway", {}, doorway(1.0));
  rows.push_back(
      {"doorway aslant", {Vec2(-3.0, 2.5), -1.5}, Vec2(3.0, 2.5), {}, doorway(1.0), 50.0});
  row("doorway, somebody comes", {person(1, Vec2(4.0, 0.0), Vec2(-1.0, 0.4))}, doorway(1.4), 60.0);
  row("corridor, head on", {person(1, Vec2(5.0, 0.3), Vec2(-1.0, 0.0))}, corridor(2.6), 60.0);
  row("corridor, gap on the left", {person(1, Vec2(0.0, -0.35), none)}, corridor(2.4), 80.0);
  // Where the way to the right ends between people and wall, and among people who stand.
  row("pocket on the right", {person(1, Vec2(0.0, 0.02), none)},
      {{Vec2(-9.0, 2.0), Vec2(9.0, 2.3)}, {Vec2(-9.0, -1.1), Vec2(9.0, -0.8)}}, 90.0, 12);
  row("cup of people",
      {person(1, none, none), person(2, Vec2(0.0, 0.7), none), person(3, Vec2(0.0, -0.7), none),
       person(4, Vec2(-0.5, 1.2), none), person(5, Vec2(-0.5, -1.2), none)},
      {}, 90.0, 30);
  rows.push_back({"narrow place to turn", middle, Vec2(-4.0, 0.0), {}, corridor(1.6), 60.0, 12});
  row("narrow door", {}, doorway(0.8));
  return rows;
}

inline const std::vector<Kinematics> kAllKinematics = {
    Kinematics::Differential, Kinematics::Omnidirectional, Kinematics::Ackermann};

inline void addRows() {
  QTest::addColumn<int>("kinematics");
  QTest::addColumn<int>("trial");
  const std::vector<Trial> rows = allTrials();
  for (const Kinematics kinematics : kAllKinematics) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      QTest::addRow("%s, %s", kinematicsName(kinematics), rows[i].name.c_str())
          << static_cast<int>(kinematics) << static_cast<int>(i);
    }
  }
}

inline Drive driveTrial(void (*add)(PlannerRegistry&), Kinematics kinematics, int number) {
  const std::vector<Trial> all = allTrials();
  const Trial& trial = all[static_cast<std::size_t>(number)];
  const Place place(trial.blocks);
  const RobotBody body = bodyOf(kinematics);
  Robot robot(place, body, trial.start, trial.goal);
  robot.seen().bodies = trial.people;
  const std::shared_ptr<Planner> planner = drive::planner(add, body);
  return robot.driveFor(*planner, trial.seconds);
}

inline void addKinematics() {
  QTest::addColumn<int>("kinematics");
  for (const Kinematics kinematics : kAllKinematics) {
    QTest::newRow(kinematicsName(kinematics)) << static_cast<int>(kinematics);
  }
}

inline void checkTwice(void (*add)(PlannerRegistry&)) {
  const auto poses = [add] { return driveTrial(add, Kinematics::Differential, 11).poses; };
  const std::vector<Pose2> once = poses();
  QVERIFY(once.size() > 100 && once == poses());
}

/// Stands in the goal 3 m ahead in the end; after 3 s it has gone more than `way` [m].
inline void checkGoal(void (*add)(PlannerRegistry&), double way) {
  for (const Kinematics kinematics : kAllKinematics) {
    const Place open;
    const RobotBody body = bodyOf(kinematics);
    Robot robot(open, body, {Vec2::Zero(), 0.0}, Vec2(3.0, 0.0));
    const std::shared_ptr<Planner> planner = drive::planner(add, body);
    Drive drive;
    for (int i = 0; i < 400; ++i) {
      robot.step(*planner, drive);
    }
    QVERIFY((robot.seen().pose.position - Vec2(3.0, 0.0)).norm() < robot.seen().goalRadius);
    QVERIFY(robot.seen().motion == BodyTwist{});
    QVERIFY(drive.poses[60].position.x() > way);
  }
}

inline void checkParameters(void (*add)(PlannerRegistry&), const char* name, std::size_t count) {
  PlannerRegistry registry;
  add(registry);
  const auto* const entry = registry.find(name);
  QVERIFY(entry != nullptr);
  QCOMPARE(entry->parameters.size(), count);
  for (const base::ParameterSpec& spec : entry->parameters) {
    QVERIFY(!spec.help.empty());
    QVERIFY(spec.range.contains(std::get<double>(spec.fallback)));
  }
}

/// At 1 m/s among twenty people who come towards it.
inline Robot amongTwenty(const Place& place, const RobotBody& body) {
  Robot robot(place, body, {Vec2(-5.0, 0.0), 0.0}, Vec2(5.0, 0.0));
  robot.seen().motion.linear = 1.0;
  for (int i = 0; i < 20; ++i) {
    const Vec2 at(-4.0 + 0.45 * i, i % 2 == 0 ? 1.2 : -1.2);
    robot.seen().bodies.push_back(person(i, at, Vec2(-0.8, i % 2 == 0 ? -0.2 : 0.2)));
  }
  return robot;
}

/// Arrives, touches no wall and drives into nobody.
inline void check(const Drive& drive, int mostTurns) {
  QVERIFY2(!drive.droveInto, qPrintable(QStringLiteral("gap %1").arg(drive.leastGap)));
  QVERIFY2(drive.leastWallGap >= 0.0,
           qPrintable(QStringLiteral("gap to walls %1").arg(drive.leastWallGap)));
  const Vec2& end = drive.poses.back().position;
  QVERIFY2(drive.hasArrived, qPrintable(QStringLiteral("is at %1, %2").arg(end.x()).arg(end.y())));
  QVERIFY2(drive.turns <= mostTurns, qPrintable(QStringLiteral("%1 turns").arg(drive.turns)));
}

}  // namespace trials
