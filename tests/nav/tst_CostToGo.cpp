#include <cmath>

#include <QtTest>

#include "sim2d/nav/CostToGo.h"
#include "tests/nav/DriveWorld.h"
#include "tests/nav/MetaTypes.h"

using drive::person;
using drive::robotBody;
using drive::wall;
using drive::World;
using namespace sim2d;

namespace {

CostToGo solved(World& world) {
  RobotRoute route;
  route.update(world.observation(), 0.3, 1.0);
  CostToGo toGo(0.3, 0.3, 0.1);
  toGo.update(world.observation(), route, 0.25, {});
  return toGo;
}

}  // namespace

class CostToGoTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void at_openPlane_isTheDistance() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(2.4, 1.0));
    const CostToGo toGo = solved(world);
    QVERIFY(toGo.containsRouteEnd());
    for (int i = 0; i < 200; ++i) {
      const Vec2 place(2.5 * std::cos(0.7 * i), 2.5 * std::sin(0.41 * i));
      const Vec2 way = Vec2(2.4, 1.0) - place;
      QVERIFY(std::fabs(toGo.at(place) - way.norm()) < 0.06 + 0.04 * way.norm());
      if (way.norm() > 0.1) {
        QVERIFY(toGo.direction(place).dot(way.normalized()) > 0.97);  // 14 degrees
      }
    }
  }

  void at_farGoal_isTheDistance() {
    World world(robotBody(Kinematics::Differential), {Vec2(3.0, 3.0), 0.0}, Vec2(33.0, 3.0));
    const CostToGo toGo = solved(world);
    QVERIFY(!toGo.containsRouteEnd());
    QVERIFY(std::fabs(toGo.at(Vec2(3.0, 3.0)) - 30.0) < 0.3);
    QVERIFY(std::fabs(toGo.at(Vec2(4.0, 3.0)) - 29.0) < 0.3);
    QVERIFY(toGo.direction(Vec2(3.0, 3.0)).x() > 0.99);
  }

  void at_behindAWall_isTheWayRound() {
    // The wall ends at y = 1; the robot's middle passes about 0.3 to 0.5 m beside the end.
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(2.0, 0.0),
                {wall(0.9, -9.0, 1.1, 1.0)});
    const CostToGo toGo = solved(world);
    const double tight = 2.0 * std::sqrt(0.9 * 0.9 + 1.2 * 1.2) + 0.2;
    const double wide = 2.0 * std::sqrt(1.0 + 1.5 * 1.5) + 0.8;
    const double found = toGo.at(Vec2::Zero());
    QVERIFY2(found > tight && found < wide, QByteArray::number(found));
    QVERIFY(toGo.direction(Vec2::Zero()).y() > 0.7);
  }

  void direction_personOnTheWay_leadsRound() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(3.0, 0.0));
    world.observation().bodies = {person(1, Vec2(1.2, 0.2))};
    const CostToGo toGo = solved(world);
    const Vec2 way = toGo.direction(Vec2::Zero());
    QVERIFY2(way.y() < -0.3 && way.x() > 0.0, QByteArray::number(way.y()));  // on the nearer side
    QVERIFY(toGo.at(Vec2::Zero()) > 3.1);
  }

  void direction_personWhoWalks_isStraight() {
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, Vec2(3.0, 0.0));
    world.observation().bodies = {person(1, Vec2(1.2, 0.2), Vec2(0.0, 1.0))};
    QVERIFY(solved(world).direction(Vec2::Zero()).x() > 0.98);
  }

  void at_thinWall_isNotCrossed() {
    // 1 cm thick, between the middles of cells wherever they lie.
    for (int i = 0; i < 15; ++i) {
      const double x = 1.0 + 0.01 * i;
      World world(robotBody(Kinematics::Differential, 0.1), {Vec2::Zero(), 0.0}, Vec2(1.6, 0.0),
                  {wall(x, -0.8, x + 0.01, 9.0)});
      RobotRoute route;
      route.update(world.observation(), 0.1, 1.0);
      QVERIFY(!route.isEmpty());
      CostToGo toGo(0.1, 0.1, 0.05);
      toGo.update(world.observation(), route, 0.25, {});
      QVERIFY2(toGo.at(Vec2::Zero()) > 2.0, QByteArray::number(toGo.at(Vec2::Zero())));
    }
  }

  void leastWithin_placesInReach_haveNoLess_data() {
    QTest::addColumn<Vec2>("goal");
    QTest::newRow("in the square") << Vec2(2.4, 1.0);
    QTest::newRow("near") << Vec2(0.5, -0.2);
    QTest::newRow("beyond") << Vec2(12.0, 3.0);
  }

  void leastWithin_placesInReach_haveNoLess() {
    QFETCH(Vec2, goal);
    World world(robotBody(Kinematics::Differential), {Vec2::Zero(), 0.0}, goal,
                {wall(0.9, -9.0, 1.1, 0.6)});
    world.observation().bodies = {person(1, Vec2(1.5, 1.2)), person(2, Vec2(-0.6, 0.7))};
    const CostToGo toGo = solved(world);
    for (int i = 0; i < 4000; ++i) {
      const Vec2 from(0.2 * std::cos(1.3 * i), 0.2 * std::sin(0.9 * i));
      const double radius = 3.0 * std::fabs(std::sin(0.37 * i));
      const double share = std::fabs(std::cos(2.1 * i));
      const Vec2 place = from + share * radius * Vec2(std::cos(0.61 * i), std::sin(0.61 * i));
      QVERIFY2(toGo.minWithin(from, radius) <= toGo.at(place) + 1e-12, QByteArray::number(i));
    }
    // No better guess than the straight way where nothing is in between.
    QVERIFY(toGo.minWithin(Vec2::Zero(), 0.0) > 0.8 * goal.norm() - 0.4);
  }
};

QTEST_GUILESS_MAIN(CostToGoTest)
#include "tst_CostToGo.moc"
