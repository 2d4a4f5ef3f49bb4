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
  const Pose2 west{Vec2(-5.0, 0.0), 0.0};
  const Vec2 east(5.0, 0.0);
  const Vec2 none = Vec2::Zero();
  std::vector<Trial> rows;
  rows.push_back({"nobody", west, east, {}, {}, 20.0});
  rows.push_back({"goal behind", {Vec2(0.0, 0.0), 0.0}, Vec2(-4.0, 0.0), {}, {}, 25.0});
  rows.push_back({"goal beside", {Vec2(0.0, 0.0), 0.0}, Vec2(0.0, 3.0), {}, {}, 25.0});
  rows.push_back({"goal close beside", {Vec2(0.0, 0.0), 0.0}, Vec2(0.0, -0.6), {}, {}, 30.0});
  rows.push_back({"head on", west, east, {person(1, east, Vec2(-1.0, 0.0))}, {}, 40.0});
  rows.push_back({"fast head on", west, east, {person(1, east, Vec2(-1.8, 0.01))}, {}, 40.0});
  rows.push_back({"standing", west, east, {person(1, none, none)}, {}, 40.0});
  rows.push_back({"crossing", west, east, {person(1, Vec2(0.0, -5.0), Vec2(0.0, 1.0))}, {}, 40.0});
  rows.push_back(
      {"overtaken", west, east, {person(1, Vec2(-8.0, 0.05), Vec2(1.6, 0.0))}, {}, 40.0});
  rows.push_back(
      {"slow ahead", west, east, {person(1, Vec2(-3.0, 0.0), Vec2(0.3, 0.0))}, {}, 40.0});
  rows.push_back(
      {"two abreast",
       west,
       east,
       {person(1, Vec2(5.0, 0.4), Vec2(-1.0, 0.0)), person(2, Vec2(5.0, -0.4), Vec2(-1.0, 0.0))},
       {},
       40.0});
  std::vector<TrackedBody> crowd;
  for (int i = 0; i < 12; ++i) {
    const double x = -3.0 + 0.6 * i;
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    crowd.push_back(person(i, Vec2(x, side * (2.0 + 0.7 * i)), Vec2(0.1 * side, -0.9 * side)));
  }
  rows.push_back({"crowd crossing", west, east, crowd, {}, 60.0, 16});
  rows.push_back({"doorway", west, east, {}, doorway(1.0), 40.0});
  rows.push_back(
      {"doorway aslant", {Vec2(-3.0, 2.5), -1.5}, Vec2(3.0, 2.5), {}, doorway(1.0), 50.0});
  rows.push_back({"doorway, somebody comes",
                  west,
                  east,
                  {person(1, Vec2(4.0, 0.0), Vec2(-1.0, 0.4))},
                  doorway(1.4),
                  60.0});
  rows.push_back({"corridor, head on",
                  west,
                  east,
                  {person(1, Vec2(5.0, 0.3), Vec2(-1.0, 0.0))},
                  corridor(2.6),
                  60.0});
  rows.push_back({"corridor, gap on the left",
                  west,
                  east,
                  {person(1, Vec2(0.0, -0.35), none)},
                  corridor(2.4),
                  80.0});
  // Where the way to the right ends between people and wall, and among people who stand.
  rows.push_back({"pocket on the right",
                  west,
                  east,
                  {person(1, Vec2(0.0, 0.02), none)},
                  {{Vec2(-9.0, 2.0), Vec2(9.0, 2.3)}, {Vec2(-9.0, -1.1), Vec2(9.0, -0.8)}},
                  90.0,
                  12});
  rows.push_back(
      {"cup of people",
       west,
       east,
       {person(1, none, none), person(2, Vec2(0.0, 0.7), none), person(3, Vec2(0.0, -0.7), none),
        person(4, Vec2(-0.5, 1.2), none), person(5, Vec2(-0.5, -1.2), none)},
       {},
       90.0,
       30});
  rows.push_back({"narrow place to turn",
                  {Vec2(0.0, 0.0), 0.0},
                  Vec2(-4.0, 0.0),
                  {},
                  corridor(1.6),
                  60.0,
                  12});
  rows.push_back({"narrow door", west, east, {}, doorway(0.8), 40.0});
  return rows;
}

inline void addRows(const std::vector<Kinematics>& all) {
  QTest::addColumn<int>("kinematics");
  QTest::addColumn<int>("trial");
  const std::vector<Trial> rows = allTrials();
  for (const Kinematics kinematics : all) {
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
  const std::shared_ptr<Planner> planner = plannerOf(add, body);
  return robot.driveFor(*planner, trial.seconds);
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
