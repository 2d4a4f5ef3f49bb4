#include <cmath>

#include <QtTest>

#include "sim2d/nav/Battery.h"

/// The battery of a robot against numbers calculated by hand.
class BatteryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void effort_isTheLargerShare();
  void power_isOfMotionOrCharger();
  void level_isEnergyByCapacity();
  void voltage_isLinearInTheLevel();
};

namespace {

using namespace sim2d;  // NOLINT: this file is about nothing else

BatteryParameters battery() {
  BatteryParameters parameters;
  parameters.capacity = 100.0;
  return parameters;
}

}  // namespace

void BatteryTest::effort_isTheLargerShare() {
  DriveLimits limits;
  limits.maxVel = 2.0;
  limits.maxOmega = 1.0;
  QCOMPARE(driveEffort({}, limits), 0.0);
  QCOMPARE(driveEffort({1.0, 0.2, 0.0}, limits), 0.5);
  QCOMPARE(driveEffort({-1.0, 0.8, 0.0}, limits), 0.8);
  QCOMPARE(driveEffort({0.6, 0.0, 0.8}, limits), 0.5);  // sideways as well: 1 m/s
  QCOMPARE(driveEffort({5.0, 0.0, 0.0}, limits), 1.0);
}

/// 20 W and 60 W at full effort; 120 W at a charger.
void BatteryTest::power_isOfMotionOrCharger() {
  QCOMPARE(batteryPower(battery(), 0.0, false), -20.0);
  QCOMPARE(batteryPower(battery(), 0.5, false), -50.0);
  QCOMPARE(batteryPower(battery(), 0.5, true), 120.0);
}

/// 50 W of 100 Wh for half an hour take a quarter.
void BatteryTest::level_isEnergyByCapacity() {
  QVERIFY(std::fabs(chargeLevelAfter(battery(), 0.8, -50.0, 1800.0) - 0.55) < 1e-12);
  QVERIFY(std::fabs(chargeLevelAfter(battery(), 0.5, 120.0, 900.0) - 0.8) < 1e-12);
  QCOMPARE(chargeLevelAfter(battery(), 0.1, -50.0, 1800.0), 0.0);
  QCOMPARE(chargeLevelAfter(battery(), 0.9, 120.0, 1800.0), 1.0);
}

/// Half way between 21 and 25.2 V; 46.2 W are 2 A.
void BatteryTest::voltage_isLinearInTheLevel() {
  const BatteryState state = batteryState(battery(), 0.5, 46.2, true);
  QVERIFY(std::fabs(state.voltage - 23.1) < 1e-12);
  QVERIFY(std::fabs(state.current - 2.0) < 1e-12);
  QCOMPARE(state.level, 0.5);
  QVERIFY(state.isCharging);
  QVERIFY(std::fabs(batteryState(battery(), 1.0, -25.2, false).current + 1.0) < 1e-12);
}

QTEST_GUILESS_MAIN(BatteryTest)
#include "tst_Battery.moc"
