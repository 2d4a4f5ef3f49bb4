#include <cmath>

#include <QtTest>

#include "sim2d/nav/PassiveSafety.h"
#include "tests/nav/DrivenRobot.h"

using namespace sim2d;

namespace {

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

class PassiveSafetyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void isPassivelySafe_somebodyStands_needsTheWayOfBraking();
  void isPassivelySafe_somebodyComes_needsHerWayToo();
  void isPassivelySafe_wall_needsTheWayOfBraking();
  void isPassivelySafe_touching_mayPart();
  void passivelySafe_tooFast_slowsDownAsLittleAsItMust();
  void passivelySafe_blocked_turnsOnTheSpot();
  void passivelySafe_nothingHelps_brakes();

 private:
  const driven::Place open_;
  const RobotBody body_ = driven::bodyOf(Kinematics::Differential);
};

/// 1 m/s for a step, then 0.95, 0.9 … 0.05 m/s: 0.05 s * (1 + 9.5) m/s = 0.525 m.
void PassiveSafetyTest::isPassivelySafe_somebodyStands_needsTheWayOfBraking() {
  const BodyTwist on{1.0, 0.0};
  const double needed = 0.525 + kMargin;
  QVERIFY(isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed + 1e-6)}), on, kMargin));
  QVERIFY(!isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed - 1e-6)}), on, kMargin));
}

/// She walks 1 m in the 20 steps.
void PassiveSafetyTest::isPassivelySafe_somebodyComes_needsHerWayToo() {
  const BodyTwist on{1.0, 0.0};
  const double needed = 0.525 + 1.0 + kMargin;
  QVERIFY(isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed + 1e-6, -1.0)}), on, kMargin));
  QVERIFY(!isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(needed - 1e-6, -1.0)}), on, kMargin));
  // Who walks away as fast leaves more room all the time.
  QVERIFY(isPassivelySafe(body_, seenAt(open_, 1.0, {ahead(0.1, 1.0)}), on, kMargin));
}

void PassiveSafetyTest::isPassivelySafe_wall_needsTheWayOfBraking() {
  const BodyTwist on{1.0, 0.0};
  const double needed = 0.3 + 0.525 + kMargin;
  const driven::Place far({{Vec2(needed + 1e-6, -2.0), Vec2(2.0, 2.0)}});
  const driven::Place near({{Vec2(needed - 1e-6, -2.0), Vec2(2.0, 2.0)}});
  QVERIFY(isPassivelySafe(body_, seenAt(far, 1.0, {}), on, kMargin));
  QVERIFY(!isPassivelySafe(body_, seenAt(near, 1.0, {}), on, kMargin));
}

void PassiveSafetyTest::isPassivelySafe_touching_mayPart() {
  const Observation seen = seenAt(open_, 0.0, {ahead(-0.05)});
  QVERIFY(isPassivelySafe(body_, seen, BodyTwist{-1.0, 0.0}, kMargin));
  QVERIFY(!isPassivelySafe(body_, seen, BodyTwist{1.0, 0.0}, kMargin));
  QVERIFY(isPassivelySafe(body_, seen, BodyTwist{}, kMargin));
}

/// Braking from v takes 0.05 s * (v + (v - 0.05) + …): 0.5125 m from 0.9875 m/s, 0.5 m from 0.975.
void PassiveSafetyTest::passivelySafe_tooFast_slowsDownAsLittleAsItMust() {
  const Observation seen = seenAt(open_, 1.0, {ahead(0.51 + kMargin)});
  const BodyTwist found = nearestSafeTwist(body_, seen, BodyTwist{1.0, 0.0}, kMargin);
  QVERIFY2(std::fabs(found.linear - 0.975) < 1e-12, qPrintable(QString::number(found.linear)));
  QCOMPARE(found.angular, 0.0);
}

void PassiveSafetyTest::passivelySafe_blocked_turnsOnTheSpot() {
  const Observation seen = seenAt(open_, 0.0, {ahead(0.01)});
  const BodyTwist found = nearestSafeTwist(body_, seen, BodyTwist{1.0, 1.0}, kMargin);
  QCOMPARE(found.linear, 0.0);
  QVERIFY(std::fabs(found.angular - 0.15) < 1e-12);  // 3 rad/s² for a step
}

void PassiveSafetyTest::passivelySafe_nothingHelps_brakes() {
  const Observation seen = seenAt(open_, 1.0, {ahead(0.1)});
  QVERIFY(nearestSafeTwist(body_, seen, BodyTwist{1.0, 1.0}, kMargin) == BodyTwist{});
}

QTEST_GUILESS_MAIN(PassiveSafetyTest)
#include "tst_PassiveSafety.moc"
