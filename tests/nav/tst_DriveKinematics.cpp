#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>

#include <QtTest>

#include "sim2d/nav/DriveKinematics.h"

using namespace sim2d;

namespace {

RobotBody robotOf(Kinematics kinematics) {
  RobotBody body;
  body.kinematics = kinematics;
  body.limits = {1.0, 0.4, 0.5, 1.5, 2.0, 0.0};  // v 1.0, back 0.4, a 0.5, omega 1.5, alpha 2.0
  if (kinematics == Kinematics::Ackermann) {
    body.limits.turningRadius = 0.8;
  }
  return body;
}

bool isNear(const Pose2& pose, const Vec2& position, double heading, double tolerance = 1e-12) {
  return (pose.position - position).norm() <= tolerance &&
         std::fabs(base::angleDiff(pose.heading, heading)) <= tolerance;
}

/// The same motion by the midpoint rule in many small straight steps.
Pose2 integrated(Pose2 pose, const BodyTwist& twist, double time, int steps) {
  const double dt = time / steps;
  double heading = pose.heading;
  for (int i = 0; i < steps; ++i) {
    const double middle = heading + 0.5 * dt * twist.angular;
    const double c = std::cos(middle);
    const double s = std::sin(middle);
    pose.position +=
        dt * Vec2(c * twist.linear - s * twist.lateral, s * twist.linear + c * twist.lateral);
    heading += dt * twist.angular;
  }
  pose.heading = std::remainder(heading, 2.0 * base::kPi);
  return pose;
}

const std::array<Kinematics, 3> kAllKinematics = {
    Kinematics::Differential, Kinematics::Omnidirectional, Kinematics::Ackermann};

}  // namespace

class DriveKinematicsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void advanced_straight_goesAlongTheHeading() {
    const Pose2 start{{1.0, 2.0}, base::kPi / 6.0};
    QVERIFY(isNear(propagated(start, {2.0, 0.0}, 1.5), {1.0 + 3.0 * std::sqrt(0.75), 3.5},
                   base::kPi / 6.0));
    QVERIFY(isNear(propagated(start, {-2.0, 0.0}, 1.5), {1.0 - 3.0 * std::sqrt(0.75), 0.5},
                   base::kPi / 6.0));
    QVERIFY(isNear(propagated(start, {2.0, 1.0}, 0.0), {1.0, 2.0}, base::kPi / 6.0, 0.0));
  }

  void advanced_circles_areExact() {
    const Pose2 start{{1.0, -1.0}, 0.0};
    // Radius 2 to the left: a quarter ends 2 ahead and 2 to the left, looking left.
    QVERIFY(isNear(propagated(start, {1.0, 0.5}, base::kPi), {3.0, 1.0}, base::kPi / 2.0));
    QVERIFY(isNear(propagated(start, {1.0, -0.5}, base::kPi), {3.0, -3.0}, -base::kPi / 2.0));
    QVERIFY(isNear(propagated(start, {-1.0, 0.5}, base::kPi), {-1.0, -3.0}, base::kPi / 2.0));
    QVERIFY(isNear(propagated(start, {1.0, 0.5}, 2.0 * base::kPi), {1.0, 3.0}, base::kPi));
    QVERIFY(isNear(propagated(start, {1.0, 0.5}, 4.0 * base::kPi), {1.0, -1.0}, 0.0));
  }

  void advanced_onTheSpot_keepsThePlace() {
    const Pose2 turned = propagated({{3.0, 4.0}, 3.0}, {0.0, 1.0}, 1.0);
    QVERIFY(turned.position == Vec2(3.0, 4.0));
    QVERIFY(std::fabs(turned.heading - (4.0 - 2.0 * base::kPi)) < 1e-15);
  }

  void advanced_omni_followsTheTurningFrame() {
    // Sideways to the left and turning left: a circle round a point behind, half of it back.
    QVERIFY(isNear(propagated({}, {0.0, 1.0, 1.0}, base::kPi), {-2.0, 0.0}, base::kPi));
    // A quarter with both: the arc's chord of ahead is (1, 1), that of aside is (-1, 1).
    QVERIFY(isNear(propagated({}, {1.0, 1.0, 1.0}, base::kPi / 2.0), {0.0, 2.0}, base::kPi / 2.0));
    QVERIFY(isNear(propagated({{0.0, 0.0}, base::kPi / 2.0}, {1.0, 0.0, 0.5}, 2.0), {-1.0, 2.0},
                   base::kPi / 2.0));
  }

  void advanced_random_agreesWithSmallSteps() {
    std::mt19937 random(11);
    std::uniform_real_distribution<double> value(-2.0, 2.0);
    for (int round = 0; round < 20; ++round) {
      const Pose2 start{{value(random), value(random)}, value(random)};
      const BodyTwist twist{value(random), 2.0 * value(random), value(random)};
      const Pose2 end = integrated(start, twist, 3.0, 20000);
      QVERIFY(isNear(propagated(start, twist, 3.0), end.position, end.heading, 1e-6));
    }
  }

  /// Against the power series of the arc about a straight line, to the seventh power of the turn.
  void advanced_smallTurns_areSmooth() {
    for (const double turn : {0.0, 1e-300, 1e-12, 1e-8, 1e-4, 0.00999, 0.0199, 0.0201, 0.03}) {
      const Pose2 end = propagated({}, {1.0, turn, 0.5}, 1.0);
      const double square = turn * turn;
      const double fourth = square * square;
      const double s = 1.0 - square / 6.0 + fourth / 120.0 - square * fourth / 5040.0;
      const double c =
          turn / 2.0 * (1.0 - square / 12.0 + fourth / 360.0 - square * fourth / 20160.0);
      QVERIFY2(isNear(end, {s - 0.5 * c, c + 0.5 * s}, turn, 4e-15),
               qPrintable(QString::number(turn)));
    }
  }

  void advanced_inParts_isTheSame() {
    const BodyTwist twist{0.7, 0.9, -0.3};
    Pose2 pose;
    for (int i = 0; i < 100; ++i) {
      pose = propagated(pose, twist, 0.05);
    }
    const Pose2 atOnce = propagated({}, twist, 5.0);
    QVERIFY(isNear(pose, atOnce.position, atOnce.heading, 1e-12));
  }

  void feasible_differential_clampsAndDropsSideways() {
    const RobotBody body = robotOf(Kinematics::Differential);
    QVERIFY(clampedToLimits(body, {2.0, 3.0, 1.0}) == (BodyTwist{1.0, 1.5, 0.0}));
    QVERIFY(clampedToLimits(body, {-2.0, -3.0, -1.0}) == (BodyTwist{-0.4, -1.5, 0.0}));
    QVERIFY(clampedToLimits(body, {0.3, -0.2, 0.0}) == (BodyTwist{0.3, -0.2, 0.0}));
    QVERIFY(clampedToLimits(body, {0.0, 1.0, 0.0}) == (BodyTwist{0.0, 1.0, 0.0}));
  }

  void feasible_omni_clampsEachDirection() {
    const RobotBody body = robotOf(Kinematics::Omnidirectional);
    QVERIFY(clampedToLimits(body, {2.0, 3.0, 2.0}) == (BodyTwist{1.0, 1.5, 1.0}));
    QVERIFY(clampedToLimits(body, {-2.0, 0.0, -2.0}) == (BodyTwist{-0.4, 0.0, -1.0}));
    QVERIFY(clampedToLimits(body, {0.2, 0.0, -0.7}) == (BodyTwist{0.2, 0.0, -0.7}));
  }

  void feasible_ackermann_turnsNoTighterThanItsCircle() {
    const RobotBody body = robotOf(Kinematics::Ackermann);
    QVERIFY(clampedToLimits(body, {0.0, 1.0, 0.5}) == BodyTwist{});
    QVERIFY(clampedToLimits(body, {0.4, 1.0}) == (BodyTwist{0.4, 0.5}));  // 0.4 / 0.8
    QVERIFY(clampedToLimits(body, {-2.0, -9.0}) ==
            (BodyTwist{-0.4, -0.5}));  // reverse turns as tight
    QVERIFY(clampedToLimits(body, {5.0, 9.0}) ==
            (BodyTwist{1.0, 1.25}));  // the clamped speed counts
    QVERIFY(clampedToLimits(body, {1.0, 0.2}) == (BodyTwist{1.0, 0.2}));
    RobotBody agile = body;
    agile.limits.turningRadius = 0.1;
    QVERIFY(clampedToLimits(agile, {1.0, 9.0}) == (BodyTwist{1.0, 1.5}));
  }

  void reached_speedingUpAndBraking_keepsTheLimits() {
    const RobotBody body = robotOf(Kinematics::Omnidirectional);
    // In 0.2 s: speeds change by 0.1, turns by 0.4.
    const BodyTwist faster = reached(body, {0.5, 0.0, -0.5}, {1.0, 1.0, 0.5}, 0.2);
    QVERIFY(std::fabs(faster.linear - 0.6) < 1e-15);
    QVERIFY(std::fabs(faster.angular - 0.4) < 1e-15);
    QVERIFY(std::fabs(faster.lateral + 0.4) < 1e-15);
    const BodyTwist slower = reached(body, {0.5, 1.0, 0.05}, {}, 0.2);
    QVERIFY(std::fabs(slower.linear - 0.4) < 1e-15);
    QVERIFY(std::fabs(slower.angular - 0.6) < 1e-15);
    QCOMPARE(slower.lateral, 0.0);
    const BodyTwist near = reached(body, {0.95, 0.0, 0.0}, {9.0, 0.3, 0.0}, 0.2);
    QVERIFY(near == (BodyTwist{1.0, 0.3, 0.0}));
    const RobotBody wheels = robotOf(Kinematics::Differential);
    QCOMPARE(reached(wheels, {0.0, 0.0, 0.5}, {0.0, 0.0, 0.5}, 0.2).lateral, 0.0);
  }

  void reached_aboveALoweredLimit_brakesAtTheRate() {
    const RobotBody body = robotOf(Kinematics::Omnidirectional);
    const BodyTwist now{3.0, -4.0, 2.5};
    for (const BodyTwist& wish : {BodyTwist{}, BodyTwist{9.0, -9.0, 9.0}}) {
      const BodyTwist next = reached(body, now, wish, 0.1);
      QVERIFY(std::fabs(next.linear - 2.95) < 1e-15);
      QVERIFY(std::fabs(next.angular + 3.8) < 1e-15);
      QVERIFY(std::fabs(next.lateral - 2.45) < 1e-15);
    }
  }

  void reached_ackermann_turnFallsWithTheSpeed() {
    RobotBody body = robotOf(Kinematics::Ackermann);
    body.limits.maxAlpha = 0.1;
    // On its circle at 0.4 m/s, braking by 0.1 m/s: the turn is that of the circle at 0.3 m/s.
    const BodyTwist next = reached(body, {0.4, 0.5}, {}, 0.2);
    QVERIFY(std::fabs(next.linear - 0.3) < 1e-15);
    QVERIFY(std::fabs(next.angular - 0.375) < 1e-15);
    // From standing the turn comes with the speed.
    body.limits.maxAlpha = 20.0;
    const BodyTwist start = reached(body, {}, {1.0, 1.25}, 0.2);
    QVERIFY(std::fabs(start.linear - 0.1) < 1e-15);
    QVERIFY(std::fabs(start.angular - 0.125) < 1e-15);
  }

  void reached_randomWishes_lieInTheWindow() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> value(-2.0, 2.0);
    for (const Kinematics kinematics : kAllKinematics) {
      RobotBody body = robotOf(kinematics);
      for (int round = 0; round < 3000; ++round) {
        body.limits.maxAlpha = 0.1 + std::fabs(value(random));
        const BodyTwist now = clampedToLimits(body, {value(random), value(random), value(random)});
        const TwistWindow window = dynamicWindow(body, now, 0.3);
        const BodyTwist next =
            reached(body, now, {value(random), value(random), value(random)}, 0.3);
        QVERIFY(next.linear >= window.lowLinear && next.linear <= window.highLinear);
        QVERIFY(next.angular >= window.lowAngular && next.angular <= window.highAngular);
        QVERIFY(next.lateral >= window.lowLateral && next.lateral <= window.highLateral);
        QVERIFY(std::fabs(next.linear - now.linear) <= 0.15 + 1e-15);
        QVERIFY(std::fabs(next.lateral - now.lateral) <= 0.15 + 1e-15);
        if (kinematics == Kinematics::Ackermann) {
          QVERIFY(std::fabs(next.angular) <= std::fabs(next.linear) / 0.8);
        } else {
          const double most = 0.3 * body.limits.maxAlpha + 1e-15;
          QVERIFY(std::fabs(next.angular - now.angular) <= most);
        }
      }
    }
  }

  void windowOf_differential_isThatOfFox() {
    const RobotBody body = robotOf(Kinematics::Differential);
    const TwistWindow middle = dynamicWindow(body, {0.5, 0.2, 0.7}, 0.2);
    QVERIFY(std::fabs(middle.lowLinear - 0.4) < 1e-15);
    QVERIFY(std::fabs(middle.highLinear - 0.6) < 1e-15);
    QVERIFY(std::fabs(middle.lowAngular + 0.2) < 1e-15);
    QVERIFY(std::fabs(middle.highAngular - 0.6) < 1e-15);
    QVERIFY(middle.lowLateral == 0.0 && middle.highLateral == 0.0);
    const TwistWindow atLimits = dynamicWindow(body, {-0.35, 1.4}, 0.2);
    QCOMPARE(atLimits.lowLinear, -0.4);
    QVERIFY(std::fabs(atLimits.highLinear + 0.25) < 1e-15);
    QCOMPARE(atLimits.highAngular, 1.5);
    const TwistWindow omni =
        dynamicWindow(robotOf(Kinematics::Omnidirectional), {0.0, 0.0, 0.95}, 0.2);
    QVERIFY(std::fabs(omni.lowLateral - 0.85) < 1e-15);
    QCOMPARE(omni.highLateral, 1.0);
  }

  void windowOf_aboveALoweredLimit_isWhatBrakingReaches() {
    const TwistWindow window = dynamicWindow(robotOf(Kinematics::Differential), {3.0, -4.0}, 0.2);
    QVERIFY(std::fabs(window.lowLinear - 2.9) < 1e-15);
    QCOMPARE(window.highLinear, window.lowLinear);
    QVERIFY(std::fabs(window.lowAngular + 3.6) < 1e-15);
    QCOMPARE(window.highAngular, window.lowAngular);
  }

  void windowOf_ackermann_isBoundedByTheCircle() {
    RobotBody body = robotOf(Kinematics::Ackermann);
    const TwistWindow start = dynamicWindow(body, {}, 0.2);  // 0.1 m/s both ways, 0.1 / 0.8 rad/s
    QVERIFY(std::fabs(start.highLinear - 0.1) < 1e-15);
    QVERIFY(std::fabs(start.highAngular - 0.125) < 1e-15);
    QVERIFY(std::fabs(start.lowAngular + 0.125) < 1e-15);
    // Braking forces a smaller turn than alpha alone: 0.3 / 0.8 and 0.5 -+ 0.02.
    body.limits.maxAlpha = 0.1;
    const TwistWindow braking = dynamicWindow(body, {0.4, 0.5}, 0.2);
    QVERIFY(std::fabs(braking.lowAngular - 0.375) < 1e-15);
    QVERIFY(std::fabs(braking.highAngular - 0.52) < 1e-15);
  }
};

QTEST_GUILESS_MAIN(DriveKinematicsTest)
#include "tst_DriveKinematics.moc"
