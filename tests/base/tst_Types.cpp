#include <cmath>
#include <limits>

#include <QtTest>

#include "sim2d/base/Types.h"
#include "tests/support/Columns.h"

using base::kPi;

class TypesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void wrapToPi_angle_fallsIntoOneTurn_data() {
    addColumns<double, double>({"angle", "wrapped"});
    QTest::newRow("inside") << 1.25 << 1.25;
    QTest::newRow("pi") << kPi << kPi;
    QTest::newRow("minus pi") << -kPi << kPi;
    QTest::newRow("three pi") << 3.0 * kPi << kPi;
    QTest::newRow("minus three pi") << -3.0 * kPi << kPi;
    QTest::newRow("whole turns") << 20.0 * kPi << 0.0;
    QTest::newRow("above") << 4.0 << 4.0 - 2.0 * kPi;
    QTest::newRow("below") << -4.0 << 2.0 * kPi - 4.0;
  }

  void wrapToPi_angle_fallsIntoOneTurn() {
    QFETCH(double, angle);
    QFETCH(double, wrapped);
    const double got = base::wrapToPi(angle);
    QVERIFY(std::abs(got - wrapped) < 1e-14);
    QVERIFY(got > -kPi && got <= kPi);
  }

  void wrapToPi_notFinite_isNan() {
    QVERIFY(std::isnan(base::wrapToPi(std::numeric_limits<double>::infinity())));
    QVERIFY(std::isnan(base::wrapToPi(std::numeric_limits<double>::quiet_NaN())));
  }

  void angleDiff_acrossTheCut_isTheShortTurn() {
    QVERIFY(std::abs(base::angleDiff(-3.0, 3.0) - (2.0 * kPi - 6.0)) < 1e-15);
    QVERIFY(std::abs(base::angleDiff(3.0, -3.0) - (6.0 - 2.0 * kPi)) < 1e-15);
    QVERIFY(base::angleDiff(0.0, kPi) == kPi);  // half a turn counts as left
  }

  void headingOf_directionOf_undoEachOther() {
    for (int i = -31; i <= 31; ++i) {
      const double heading = 0.1 * i;
      const base::Vec2 direction = base::directionOf(heading);
      QVERIFY(std::abs(direction.norm() - 1.0) < 1e-15);
      QVERIFY(std::abs(base::headingOf(direction) - heading) < 1e-15);
    }
  }

  void headingOf_zeroVector_isZero() { QVERIFY(base::headingOf(base::Vec2::Zero()) == 0.0); }

  void pose_ahead_goesAlongItsHeading() {
    const base::Pose2 pose{base::Vec2(1.0, 2.0), kPi / 6};
    const base::Vec2 point = pose.ahead(2.0);
    QVERIFY(std::abs(point.x() - (1.0 + std::sqrt(3.0))) < 1e-15);
    QVERIFY(std::abs(point.y() - 3.0) < 1e-15);
  }

  void pose_toWorldToLocal_undoEachOther() {
    const base::Pose2 pose{base::Vec2(-4.0, 0.5), kPi / 2};
    const base::Vec2 world = pose.toWorld(base::Vec2(2.0, 1.0));  // two ahead, one to the left
    QVERIFY((world - base::Vec2(-5.0, 2.5)).norm() < 1e-15);
    QVERIFY((pose.toLocal(world) - base::Vec2(2.0, 1.0)).norm() < 1e-15);
  }

  void cross_vectorToTheLeft_isPositive() {
    QVERIFY(base::cross(base::Vec2(1.0, 0.0), base::Vec2(0.3, 2.0)) == 2.0);
    QVERIFY(base::cross(base::Vec2(1.0, 0.0), base::Vec2(0.3, -2.0)) == -2.0);
  }

  void entityId_orderAndTruth() {
    const base::EntityId none;
    const base::EntityId first{base::EntityKind::Human, 1};
    const base::EntityId second{base::EntityKind::Human, 2};
    QVERIFY(!none);
    QVERIFY(static_cast<bool>(first));
    QVERIFY(first != second && first < second && !(second < first));
    QVERIFY(second < (base::EntityId{base::EntityKind::Robot, 1}));
  }

  void nodeStatusName_eachStatus_isInCapitals() {
    QCOMPARE(base::nodeStatusName(base::NodeStatus::Idle), "IDLE");
    QCOMPARE(base::nodeStatusName(base::NodeStatus::Running), "RUNNING");
    QCOMPARE(base::nodeStatusName(base::NodeStatus::Success), "SUCCESS");
    QCOMPARE(base::nodeStatusName(base::NodeStatus::Failure), "FAILURE");
    QCOMPARE(base::nodeStatusName(base::NodeStatus::Skipped), "SKIPPED");
  }
};

QTEST_APPLESS_MAIN(TypesTest)
#include "tst_Types.moc"
