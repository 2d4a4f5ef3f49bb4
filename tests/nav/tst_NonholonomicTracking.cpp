#include <cmath>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "sim2d/nav/NonholonomicTracking.h"
#include "tests/nav/DrivenRobot.h"

using namespace sim2d;

namespace {

TrackingModel modelOf(Kinematics kinematics) {
  TrackingModel model;
  model.kinematics = kinematics;
  if (kinematics == Kinematics::Ackermann) {
    model.turningRadius = 0.8;
  }
  return model;
}

Vec2 at(double speed, double angle) {
  return {speed * std::cos(angle), speed * std::sin(angle)};
}

/// Greatest distance between a point that moves with `velocity` and a robot that turns by its
/// angle with the twist and goes straight on, by midpoints of steps of 20 microseconds.
double integratedError(const BodyTwist& arc, double speed, double angle) {
  constexpr double kStep = 2e-5;
  Vec2 robot = Vec2::Zero();
  double heading = 0.0;
  double greatest = 0.0;
  const double duration = angle == 0.0 ? 0.5 : angle / arc.angular;
  const int turning = static_cast<int>(std::lround(duration / kStep));
  for (int i = 1; i <= turning + 20000; ++i) {
    const bool isTurning = i <= turning;
    const double rate = isTurning ? angle / (turning * kStep) : 0.0;
    robot += at(kStep * (isTurning ? arc.linear : speed), heading + 0.5 * kStep * rate);
    heading += kStep * rate;
    greatest = std::max(greatest, (robot - at(i * kStep * speed, angle)).norm());
  }
  return greatest;
}

/// The error E(V_H, theta_H) in closed form.
double trackingError(const TrackingModel& model, double speed, double angle) {
  const double size = std::fabs(angle);
  if (model.kinematics == Kinematics::Differential && size > arcAngle(model)) {
    return speed * size / model.maxOmega;
  }
  const double tightest = 2.0 * model.turningRadius * std::tan(0.5 * size) / speed;
  const double least = std::max(model.turnTime, size / model.maxOmega);
  return speed * std::max(least, tightest) * std::sin(0.5 * size);
}

bool isIn(const std::vector<HalfPlane>& piece, const Vec2& velocity) {
  for (const HalfPlane& edge : piece) {
    if (edge.violation(velocity) > 0.0) {
      return false;
    }
  }
  return true;
}

constexpr double kMargin = 0.02;  // [m]

/// At the origin, heading for +x; 1 m/s², steps of 0.05 s, radius 0.3 m.
Observation seenAt(const driven::Place& place, double speed,
                   const std::vector<TrackedBody>& people) {
  Observation seen;
  seen.motion.linear = speed;
  seen.bodies = people;
  seen.obstacles = &place.obstacles();
  seen.navigation = &place.navigation();
  return seen;
}

TrackedBody ahead(double gap, double speed = 0.0) {
  return driven::person(1, Vec2(0.6 + gap, 0.0), Vec2(speed, 0.0));
}

}  // namespace

class NonholonomicTrackingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void trackingError_byHand() {
    const TrackingModel model = modelOf(Kinematics::Differential);  // 0.75 rad by an arc
    QVERIFY(std::fabs(trackingError(model, 1.0, 0.6) - 0.5 * 0.29552020666134) < 1e-12);
    QVERIFY(std::fabs(trackingError(model, 0.2, base::kPi) - 0.41887902047864) < 1e-12);
    QVERIFY(std::fabs(trackingError(model, 0.2, -1.0) - 0.2 / 1.5) < 1e-12);
    QCOMPARE(trackingError(model, 1.0, 0.0), 0.0);
    // 2 R tan(30 degrees) sin(30 degrees) while the arc is as tight as can be.
    const TrackingModel car = modelOf(Kinematics::Ackermann);
    QVERIFY(std::fabs(trackingError(car, 0.1, base::kPi / 3.0) - 1.6 * 0.57735026918963 * 0.5) <
            1e-12);
  }

  void trackingError_againstIntegration_data() {
    QTest::addColumn<int>("kinematics");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("angle");
    const double most = base::kPi;
    for (const double speed : {0.05, 0.4, 1.0}) {
      for (const double angle : {0.0, 0.1, -0.4, 0.74, 0.8, -1.5, 2.4, most}) {
        QTest::addRow("differential %g %g", speed, angle)
            << static_cast<int>(Kinematics::Differential) << speed << angle;
      }
      for (const double angle : {0.1, -0.4, 0.8, 1.5}) {
        QTest::addRow("car %g %g", speed, angle)
            << static_cast<int>(Kinematics::Ackermann) << speed << angle;
      }
    }
  }

  void trackingError_againstIntegration() {
    QFETCH(int, kinematics);
    QFETCH(double, speed);
    QFETCH(double, angle);
    const TrackingModel model = modelOf(static_cast<Kinematics>(kinematics));
    const double closed = trackingError(model, speed, angle);
    const double found = integratedError(track(model, at(speed, angle)), speed, angle);
    QVERIFY2(std::fabs(closed - found) < 1e-4,
             qPrintable(QStringLiteral("%1, integrated %2").arg(closed).arg(found)));
  }

  void track_otherSpeedOnTheArc_isWorse() {
    const TrackingModel model = modelOf(Kinematics::Differential);
    for (const double angle : {0.2, -0.5, 0.7}) {
      BodyTwist arc = track(model, at(0.8, angle));
      const double best = integratedError(arc, 0.8, angle);
      arc.linear *= 1.03;
      QVERIFY(integratedError(arc, 0.8, angle) > best);
      arc.linear *= 0.97 / 1.03;
      QVERIFY(integratedError(arc, 0.8, angle) > best);
    }
  }

  void steeringAngle_solvesItsEquation() {
    for (const double radius : {0.3, 1.0, 5.0}) {
      for (const double epsilon : {0.01, 0.1, 0.2}) {
        const double half = 0.5 * maxTrackableAngle(radius, epsilon);
        QVERIFY(std::fabs(2.0 * radius * std::tan(half) * std::sin(half) - epsilon) < 1e-12);
      }
    }
    QCOMPARE(maxTrackableAngle(0.01, 1.0), 0.5 * base::kPi);
    QCOMPARE(maxTrackableAngle(0.0, 0.1), 0.5 * base::kPi);
  }

  void trackedVelocities_lieInTheSet_andFillMostOfIt_data() {
    QTest::addColumn<int>("kinematics");
    QTest::addColumn<double>("omega");
    QTest::addColumn<double>("epsilon");
    QTest::addColumn<double>("least");
    for (const double omega : {0.5, 1.5, 4.0}) {
      for (const double epsilon : {0.01, 0.1, 0.3}) {
        QTest::addRow("differential %g %g", omega, epsilon)
            << static_cast<int>(Kinematics::Differential) << omega << epsilon << 0.6;
        QTest::addRow("car %g %g", omega, epsilon)
            << static_cast<int>(Kinematics::Ackermann) << omega << epsilon << 0.3;
      }
    }
  }

  void trackedVelocities_lieInTheSet_andFillMostOfIt() {
    QFETCH(int, kinematics);
    QFETCH(double, omega);
    QFETCH(double, epsilon);
    QFETCH(double, least);
    TrackingModel model = modelOf(static_cast<Kinematics>(kinematics));
    model.maxOmega = omega;
    const std::vector<std::vector<HalfPlane>> pieces = trackableVelocities(model, epsilon);
    const base::AgentRng random(4, 2);
    int tracked = 0;
    int found = 0;
    for (std::uint32_t i = 0; i < 40000; ++i) {
      const Vec2 velocity(random.uniform(-1.0, 1.0, base::DrawPurpose::Test, 2 * i),
                          random.uniform(-1.0, 1.0, base::DrawPurpose::Test, 2 * i + 1));
      const double speed = velocity.norm();
      const double angle = std::atan2(velocity.y(), velocity.x());
      const bool isTracked =
          speed <= model.maxVel && trackingError(model, speed, angle) <= epsilon + 1e-9;
      bool isFound = false;
      for (const std::vector<HalfPlane>& piece : pieces) {
        isFound = isFound || (isIn(piece, velocity) && speed <= model.maxVel);
        QVERIFY(isIn(piece, Vec2::Zero()));
      }
      if (isFound) {
        QVERIFY2(isTracked, qPrintable(QStringLiteral("%1 at %2").arg(speed).arg(angle)));
      }
      tracked += isTracked ? 1 : 0;
      found += isFound ? 1 : 0;
    }
    QVERIFY(tracked > 100);
    QVERIFY2(found > least * tracked,
             qPrintable(QStringLiteral("%1 of %2").arg(found).arg(tracked)));
  }

  void track_car_turnsNoTighterThanItCan() {
    const TrackingModel model = modelOf(Kinematics::Ackermann);
    for (int i = -31; i <= 31; ++i) {
      for (const double speed : {0.02, 0.3, 1.0}) {
        const BodyTwist twist = track(model, at(speed, 0.1 * i));
        QVERIFY(twist.linear >= model.turningRadius * std::fabs(twist.angular) - 1e-9);
        QVERIFY(std::fabs(twist.angular) <= model.maxOmega + 1e-12);
        QVERIFY(i == 0 || twist.angular * i > 0.0);
      }
    }
  }

  void track_smallVelocity_turnsSlowly() {
    const TrackingModel model = modelOf(Kinematics::Differential);
    QVERIFY(track(model, Vec2::Zero()) == BodyTwist{});
    QVERIFY(std::fabs(track(model, Vec2(0.0, 0.005)).angular - 0.75) < 1e-12);
    QVERIFY(std::fabs(track(model, Vec2(0.0, -0.02)).angular + 1.5) < 1e-12);
  }

  void track_omnidirectional_isTheVelocity() {
    const BodyTwist twist = track(modelOf(Kinematics::Omnidirectional), Vec2(-0.3, 0.4));
    QVERIFY(std::fabs(twist.linear + 0.3) < 1e-12 && std::fabs(twist.lateral - 0.4) < 1e-12);
    QCOMPARE(twist.angular, 1.5);
  }

  void trackingModelOf_weakMotor_takesLonger() {
    RobotBody body;
    body.limits.maxOmega = 2.0;
    body.limits.maxAlpha = 2.5;
    QCOMPARE(trackingModelFor(body, 0.5).turnTime, 0.8);
    QCOMPARE(trackingModelFor(body, 1.0).turnTime, 1.0);
  }

  /// 1 m/s for a step, then 0.95, 0.9 … 0.05 m/s: 0.05 s * (1 + 9.5) m/s = 0.525 m.
  void isPassivelySafe_somebodyStands_needsTheWayOfBraking() {
    const BodyTwist on{1.0, 0.0};
    const double needed = 0.525 + kMargin;
    QVERIFY(isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed + 1e-6)}), on, kMargin));
    QVERIFY(!isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed - 1e-6)}), on, kMargin));
  }

  /// She walks 1 m in the 20 steps.
  void isPassivelySafe_somebodyComes_needsHerWayToo() {
    const BodyTwist on{1.0, 0.0};
    const double needed = 0.525 + 1.0 + kMargin;
    QVERIFY(isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed + 1e-6, -1.0)}), on, kMargin));
    QVERIFY(!isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed - 1e-6, -1.0)}), on, kMargin));
    // Who walks away as fast leaves more room all the time.
    QVERIFY(isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(0.1, 1.0)}), on, kMargin));
  }

  void isPassivelySafe_wall_needsTheWayOfBraking() {
    const BodyTwist on{1.0, 0.0};
    const double needed = 0.3 + 0.525 + kMargin;
    const driven::Place far({{Vec2(needed + 1e-6, -2.0), Vec2(2.0, 2.0)}});
    const driven::Place near({{Vec2(needed - 1e-6, -2.0), Vec2(2.0, 2.0)}});
    QVERIFY(isPassivelySafe(body_, seenAt(far, 1.0, {}), on, kMargin));
    QVERIFY(!isPassivelySafe(body_, seenAt(near, 1.0, {}), on, kMargin));
  }

  void isPassivelySafe_touching_mayPart() {
    const Observation seen = seenAt(open_, 0.0, {ahead(-0.05)});
    QVERIFY(isPassivelySafe(body_, seen, BodyTwist{-1.0, 0.0}, kMargin));
    QVERIFY(!isPassivelySafe(body_, seen, BodyTwist{1.0, 0.0}, kMargin));
    QVERIFY(isPassivelySafe(body_, seen, BodyTwist{}, kMargin));
  }

  /// Braking from v takes 0.05 s * (v + (v - 0.05) + …): 0.5125 m from 0.9875 m/s, 0.5 m from
  /// 0.975.
  void passivelySafe_tooFast_slowsDownAsLittleAsItMust() {
    const Observation seen = seenAt(open_, 1.0, {ahead(0.51 + kMargin)});
    const BodyTwist found = nearestSafeTwist(body_, seen, BodyTwist{1.0, 0.0}, kMargin);
    QVERIFY2(std::fabs(found.linear - 0.975) < 1e-12, qPrintable(QString::number(found.linear)));
    QCOMPARE(found.angular, 0.0);
  }

  void passivelySafe_blocked_turnsOnTheSpot() {
    const Observation seen = seenAt(open_, 0.0, {ahead(0.01)});
    const BodyTwist found = nearestSafeTwist(body_, seen, BodyTwist{1.0, 1.0}, kMargin);
    QCOMPARE(found.linear, 0.0);
    QVERIFY(std::fabs(found.angular - 0.15) < 1e-12);  // 3 rad/s² for a step
  }

  void passivelySafe_nothingHelps_brakes() {
    const Observation seen = seenAt(open_, 1.0, {ahead(0.1)});
    QVERIFY(nearestSafeTwist(body_, seen, BodyTwist{1.0, 1.0}, kMargin) == BodyTwist{});
  }

 private:
  const driven::Place open_;
  const RobotBody body_ = driven::bodyOf(Kinematics::Differential);
};

QTEST_GUILESS_MAIN(NonholonomicTrackingTest)
#include "tst_NonholonomicTracking.moc"
