#include <cmath>

#include <QtTest>

#include "sim2d/nav/RobotRoute.h"
#include "tests/nav/DriveWorld.h"

using drive::robotBody;
using drive::wall;
using drive::World;
using namespace sim2d;

class RobotRouteTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void update_openPlane_isTheStraightLine() {
    World world(robotBody(Kinematics::Differential), {Vec2(1.0, 1.0), 0.0}, Vec2(4.0, 5.0));
    RobotRoute route;
    QVERIFY(route.isEmpty());
    route.update(world.observation(), 0.3, 1.0);
    QVERIFY(route.points() == (std::vector<Vec2>{Vec2(1.0, 1.0), Vec2(4.0, 5.0)}));
    QVERIFY(!route.takeReplanned());
  }

  void lengths_besideTheRoute_areThoseOfItsFoot() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(10.0, 0.0));
    RobotRoute route;
    route.update(world.observation(), 0.3, 1.0);
    const Vec2 beside(3.0, 0.4);
    QVERIFY(std::fabs(route.distanceFrom(beside) - 0.4) < 1e-12);
    QVERIFY((route.pointAhead(beside, 2.0) - Vec2(5.0, 0.0)).norm() < 1e-12);
    QVERIFY((route.pointAhead(beside, 20.0) - Vec2(10.0, 0.0)).norm() < 1e-12);
    // From the place itself: 7 m along and 0.4 m aside.
    QVERIFY(std::fabs(route.remainingLength(beside) - std::sqrt(49.16)) < 1e-12);
  }

  void update_roundAWall_keepsTheClearance() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(4.0, 0.0),
                {wall(1.9, -6.0, 2.1, 1.0)});
    RobotRoute route;
    route.update(world.observation(), 0.3, 1.0);
    QVERIFY(route.points().size() >= 3);
    for (int i = 0; i < 120; ++i) {
      QVERIFY(world.obstacles().clearance(route.pointAhead(Vec2::Zero(), 0.05 * i), 1.0) > 0.28);
    }
    // Touching the corners at 0.3 m it would be longer than the straight lines to them.
    const double rest = route.remainingLength(Vec2::Zero());
    QVERIFY(rest > 2.0 * std::sqrt(1.9 * 1.9 + 1.0) + 0.2 && rest < 6.0);
  }

  void update_newGoal_plansAtOnceWithoutReplan() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(10.0, 0.0));
    RobotRoute route;
    route.update(world.observation(), 0.3, 1.0);
    world.observation().goal = Vec2(0.0, 10.0);
    route.update(world.observation(), 0.3, 1.0);
    QVERIFY(route.points().back() == Vec2(0.0, 10.0));
    QVERIFY(!route.takeReplanned());
  }

  void update_offTheRoute_plansOnceASecond() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(10.0, 0.0));
    RobotRoute route;
    route.update(world.observation(), 0.3, 1.0);
    Observation& now = world.observation();
    now.pose.position = Vec2(2.0, 1.2);
    now.time = 0.5;
    route.update(now, 0.3, 1.0);
    QVERIFY(route.points().front() == Vec2(0.0, 0.0));
    now.time = 1.0;
    route.update(now, 0.3, 1.0);
    QVERIFY(route.points().front() == Vec2(2.0, 1.2));
    QVERIFY(route.takeReplanned());
    QVERIFY(!route.takeReplanned());
    now.pose.position = Vec2(3.0, 0.7);  // beside, but near
    now.time = 5.0;
    route.update(now, 0.3, 1.0);
    QVERIFY(route.points().front() == Vec2(2.0, 1.2));
  }

  void update_pointAheadHidden_plansAnew() {
    World world(robotBody(Kinematics::Differential), {Vec2(0.0, 2.0), 0.0}, Vec2(6.0, 2.0),
                {wall(2.0, -1.0, 4.0, 1.4)});
    RobotRoute route;
    route.update(world.observation(), 0.3, 3.0);
    Observation& now = world.observation();
    now.pose.position = Vec2(1.4, 1.1);  // 0.9 m off, but cannot look round the corner
    now.time = 2.0;
    route.update(now, 0.3, 3.0);
    QVERIFY(route.takeReplanned());
  }

  void update_doorMoves_plansAtOnce() {
    Obstacles obstacles;
    obstacles.add({wall(2.0, 0.5, 2.2, 9.0), wall(2.0, -3.0, 2.2, -0.5)});
    const int door = obstacles.add({wall(2.0, -0.5, 2.2, 0.5)}, false);
    obstacles.build();
    NavigationMap navigation(OccupancyGrid{}, obstacles, {Vec2::Zero(), Vec2(4.0, 0.0)});
    Observation now;
    now.goal = Vec2(4.0, 0.0);
    now.obstacles = &obstacles;
    now.navigation = &navigation;
    RobotRoute route;
    route.update(now, 0.3, 1.0);
    const double open = route.remainingLength(Vec2::Zero());
    QVERIFY(std::fabs(open - 4.0) < 0.05);
    obstacles.setEnabled(door, true);
    navigation.update(OccupancyGrid{}, obstacles);
    now.time = 0.05;
    route.update(now, 0.3, 1.0);
    QVERIFY(route.takeReplanned());
    QVERIFY(route.remainingLength(Vec2::Zero()) > 7.0);  // round the lower end
  }

  void update_noWay_isEmptyAndTriesAgain() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(5.0, 0.0),
                {wall(4.0, -1.0, 4.2, 1.0), wall(6.0, -1.0, 6.2, 1.0), wall(4.0, 1.0, 6.2, 1.2),
                 wall(4.0, -1.2, 6.2, -1.0)});
    RobotRoute route;
    route.update(world.observation(), 0.3, 1.0);
    QVERIFY(route.isEmpty());
    world.observation().time = 1.5;
    route.update(world.observation(), 0.3, 1.0);
    QVERIFY(route.isEmpty());
    QVERIFY(route.takeReplanned());
  }
};

QTEST_GUILESS_MAIN(RobotRouteTest)
#include "tst_RobotRoute.moc"
