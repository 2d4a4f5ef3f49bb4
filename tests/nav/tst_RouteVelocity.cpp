#include <cmath>

#include <QtTest>

#include "sim2d/nav/NonholonomicTracking.h"
#include "sim2d/nav/RobotRoute.h"
#include "tests/nav/DrivenRobot.h"

using namespace sim2d;

namespace {

constexpr double kStep = 0.05;  // [s]

Observation seenIn(const driven::Place& place) {
  Observation seen;
  seen.obstacles = &place.obstacles();
  seen.navigation = &place.navigation();
  return seen;
}

/// With 5 m left all the time until `time` [s].
void waitUntil(PassingSide& side, Observation& seen, double time) {
  while (seen.time < time - 0.5 * kStep) {
    seen.time += kStep;
    side.update(seen, 5.0);
  }
}

}  // namespace

class RouteVelocityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void velocityAlong_slowsDownToTheGoal() {
    const auto speedTo = [this](double distance) {
      Observation seen = seenIn(open_);
      seen.goal = Vec2(0.0, distance);
      RobotRoute route;
      route.update(seen, 0.3, 0.8);
      return routeVelocity(route, seen, 0.8, 0.7, 1.0);
    };
    QVERIFY((speedTo(9.0) - Vec2(0.0, 0.7)).norm() < 1e-12);
    QVERIFY((speedTo(0.2) - Vec2(0.0, std::sqrt(0.32))).norm() < 1e-12);  // 0.8 m/s² for 0.2 m
    QVERIFY(speedTo(0.09).isZero(0.0));                                   // within half of 0.2 m
  }

  void passingSide_noProgressInCompany_changesSides() {
    PassingSide side(0.1);
    Observation seen = seenIn(open_);
    seen.bodies = {driven::person(1, Vec2(1.0, 0.0), Vec2::Zero())};
    side.update(seen, 5.0);
    waitUntil(side, seen, 3.9);
    QCOMPARE(side.turn(), -0.1);
    QCOMPARE(side.detour(), 0.0);
    QVERIFY(!side.takeChanged());
    waitUntil(side, seen, 4.1);
    QCOMPARE(side.turn(), 0.1);
    QCOMPARE(side.detour(), 1.9);
    QVERIFY(side.takeChanged() && !side.takeChanged());
    waitUntil(side, seen, 7.2);  // three seconds long
    QCOMPARE(side.detour(), 0.0);
    QCOMPARE(side.turn(), 0.1);
    waitUntil(side, seen, 12.2);  // twice as patient, then to the right for twice as long
    QCOMPARE(side.detour(), -1.9);
    waitUntil(side, seen, 17.8);
    QCOMPARE(side.detour(), -1.9);
    waitUntil(side, seen, 18.4);
    QCOMPARE(side.detour(), 0.0);
  }

  void passingSide_progress_isTheRightAgain() {
    PassingSide side(0.1);
    Observation seen = seenIn(open_);
    seen.bodies = {driven::person(1, Vec2(1.0, 0.0), Vec2::Zero())};
    side.update(seen, 5.0);
    waitUntil(side, seen, 4.1);
    side.update(seen, 4.2);
    QCOMPARE(side.turn(), 0.1);
    side.update(seen, 3.9);
    QCOMPARE(side.turn(), -0.1);
    QCOMPARE(side.detour(), 0.0);
  }

  void passingSide_aloneOrOnTheWay_staysRight() {
    PassingSide alone(0.1);
    Observation seen = seenIn(open_);
    seen.bodies = {driven::person(1, Vec2(2.1, 0.0), Vec2::Zero())};
    alone.update(seen, 5.0);
    waitUntil(alone, seen, 30.0);
    QCOMPARE(alone.turn(), -0.1);
    PassingSide walking(0.1);
    seen.bodies.front().position.x() = 0.7;
    for (int i = 0; i < 600; ++i) {
      seen.time += kStep;
      walking.update(seen, 20.0 - 0.03 * i);  // 0.6 m/s
      QCOMPARE(walking.turn(), -0.1);
    }
  }

  /// Turning radius 0.6 m: a point 0.6 m to the left is the circle's centre.
  void driveGear_pointInsideTheTurningCircle_backsUp() {
    GearSelector gear(driven::bodyOf(Kinematics::Ackermann), 0.5);
    Observation seen = seenIn(open_);
    const Vec2 wanted(0.0, 1.0);
    const DriveReference aim = gear.choose(seen, Vec2(0.0, 0.6), wanted, 0.1);
    QVERIFY(aim.isReversing);
    QCOMPARE(aim.heading, base::kPi);
    QCOMPARE(aim.model.maxVel, 0.5);
    // Backwards and turning to the left, where the point is.
    const double aside = maxTrackableAngle(0.6, 0.1);
    const Vec2 behind = 0.5 * base::directionOf(base::wrapToPi(base::kPi + aside));
    QVERIFY((aim.wanted - behind).norm() < 1e-12);
    const BodyTwist command = aim.toRobotCommand(BodyTwist{0.4, 0.2});
    QVERIFY((command == BodyTwist{-0.4, 0.2}));
    // Clear of the circle, but not before two seconds.
    seen.motion.linear = -0.3;
    seen.time = 1.9;
    QVERIFY(gear.choose(seen, Vec2(2.0, 0.0), wanted, 0.1).isReversing);
    seen.time = 2.1;
    QVERIFY(!gear.choose(seen, Vec2(2.0, 0.0), wanted, 0.1).isReversing);
  }

  void driveGear_blocked_backsUpAfterASecond() {
    GearSelector gear(driven::bodyOf(Kinematics::Ackermann), 0.5);
    Observation seen = seenIn(open_);
    const Vec2 target(3.0, 0.0);
    for (int i = 0; i <= 20; ++i) {
      seen.time = 5.0 + kStep * i;
      QVERIFY(!gear.choose(seen, target, Vec2(1.0, 0.0), 0.1).isReversing);
    }
    seen.time = 6.1;
    QVERIFY(gear.choose(seen, target, Vec2(1.0, 0.0), 0.1).isReversing);
    GearSelector waiting(driven::bodyOf(Kinematics::Ackermann), 0.5);
    for (int i = 0; i < 100; ++i) {  // it does not want to go
      seen.time += kStep;
      QVERIFY(!waiting.choose(seen, target, Vec2::Zero(), 0.1).isReversing);
    }
  }

  void driveGear_wantedAside_steersAsFarAsItCan() {
    GearSelector gear(driven::bodyOf(Kinematics::Ackermann), 0.5);
    const Observation seen = seenIn(open_);
    const double most = maxTrackableAngle(0.6, 0.1);
    const DriveReference right = gear.choose(seen, Vec2(2.0, -2.0), Vec2(0.0, -0.8), 0.1);
    QVERIFY((right.wanted - 0.8 * base::directionOf(-most)).norm() < 1e-12);
    const DriveReference little = gear.choose(seen, Vec2(2.0, 0.2), Vec2(0.8, 0.08), 0.1);
    QVERIFY((little.wanted - Vec2(0.8, 0.08)).norm() < 1e-12);
  }

  void driveGear_otherKinematics_driveAhead() {
    for (const Kinematics kinematics : {Kinematics::Differential, Kinematics::Omnidirectional}) {
      GearSelector gear(driven::bodyOf(kinematics), 0.5);
      const DriveReference aim = gear.choose(seenIn(open_), Vec2(0.0, 0.1), Vec2(-0.3, 0.4), 0.1);
      QVERIFY(!aim.isReversing && aim.wanted == Vec2(-0.3, 0.4) && aim.heading == 0.0);
      QCOMPARE(gear.minLookahead(), 0.0);
    }
  }

  void wallPlanes_holdZero_andLimitTheSpeed() {
    const driven::Place walls({{Vec2(0.5, -2.0), Vec2(1.0, 2.0)}});
    const Observation seen = seenIn(walls);
    const std::vector<HalfPlane> roomy = wallPlanes(seen, 0.3, 1.0, 0.5);
    QCOMPARE(roomy.size(), std::size_t{1});
    QVERIFY(std::fabs(roomy.front().violation(Vec2(0.4, 0.0))) < 1e-12);  // 0.2 m in 0.5 s
    QVERIFY(roomy.front().violation(Vec2(0.41, 0.0)) > 0.0);
    const std::vector<HalfPlane> tight = wallPlanes(seen, 0.7, 1.0, 0.5);
    QVERIFY(tight.front().violation(Vec2::Zero()) < 0.0);
    QVERIFY(tight.front().violation(Vec2(0.01, 0.0)) > 0.0);
    QVERIFY(wallPlanes(seen, 0.2, 0.2, 0.5).empty());  // farther away than it gets
    QCOMPARE(worstViolation(roomy, 0, Vec2(0.5, 0.0)), roomy.front().violation(Vec2(0.5, 0.0)));
    QCOMPARE(worstViolation(roomy, 1, Vec2(0.5, 0.0)), 0.0);
  }

  void visibleBodies_nearestFirst_noneBehindWalls() {
    const driven::Place walls({{Vec2(0.5, -2.0), Vec2(1.0, 2.0)}});
    Observation seen = seenIn(walls);
    seen.bodies = {driven::person(1, Vec2(2.0, 0.0), Vec2::Zero()),
                   driven::person(2, Vec2(-2.0, 0.0), Vec2::Zero()),
                   driven::person(3, Vec2(0.0, 1.0), Vec2::Zero()),
                   driven::person(4, Vec2(0.0, -9.0), Vec2::Zero()),
                   driven::person(5, Vec2(0.0, -1.0), Vec2::Zero())};
    std::vector<int> ids;
    for (const TrackedBody& body : visibleBodies(seen, 8.0)) {
      ids.push_back(body.id);
    }
    QVERIFY((ids == std::vector<int>{3, 5, 2}));
    for (int i = 0; i < 40; ++i) {
      seen.bodies.push_back(driven::person(10 + i, Vec2(-3.0, 0.1 * i), Vec2::Zero()));
    }
    QCOMPARE(visibleBodies(seen, 8.0).size(), std::size_t{24});
  }

 private:
  const driven::Place open_;
};

QTEST_GUILESS_MAIN(RouteVelocityTest)
#include "tst_RouteVelocity.moc"
