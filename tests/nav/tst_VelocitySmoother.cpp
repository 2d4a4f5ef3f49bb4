#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/servers/VelocitySmoother.h"

using namespace sim2d::nav2;
using sim2d::BodyTwist;

namespace {

bool isNear(double a, double b) {
  return std::fabs(a - b) < 1e-9;
}

/// The forward speeds sent in so many steps of 0.05 s while a command holds.
std::vector<double> speedsOf(VelocitySmoother& smoother, double command, int steps, double& time) {
  std::vector<double> speeds;
  for (int i = 0; i < steps; ++i, time += 0.05) {
    smoother.command({command, 0.0}, time);
    speeds.push_back(smoother.update(time, {})->linear);
  }
  return speeds;
}

bool areNear(const std::vector<double>& a, const std::vector<double>& b) {
  bool isRight = a.size() == b.size();
  for (std::size_t i = 0; i < a.size() && isRight; ++i) {
    isRight = isNear(a[i], b[i]);
  }
  return isRight;
}

}  // namespace

/// Vectors of nav2_velocity_smoother: test_velocity_smoother.cpp; sequences by hand.
class VelocitySmootherTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Vectors 74, 75: acceleration 0.1, deceleration -1, 20 Hz.
  void axisScale_changes_giveTheFactor_data() {
    QTest::addColumn<double>("current");
    QTest::addColumn<double>("command");
    QTest::addColumn<double>("factor");
    QTest::newRow("0.5 to 1.5") << 0.5 << 1.5 << 0.005;
    QTest::newRow("1.5 to 0.5") << 1.5 << 0.5 << 0.05;
    QTest::newRow("0 to 1") << 0.0 << 1.0 << 0.005;
    QTest::newRow("1 to 0") << 1.0 << 0.0 << 0.05;
    QTest::newRow("-0.2 to 0.8") << -0.2 << 0.8 << 0.05;
    QTest::newRow("none") << 1.0 << 1.0 << -1.0;
    QTest::newRow("faster, within") << 0.5 << 0.504 << -1.0;
    QTest::newRow("slower, within") << 0.04 << 0.0 << -1.0;
  }

  void axisScale_changes_giveTheFactor() {
    QFETCH(double, current);
    QFETCH(double, command);
    QFETCH(double, factor);
    QVERIFY(isNear(axisScale(current, command, {0.1, -1.0, 20.0}), factor));
  }

  /// Vector 76: acceleration 1.5, deceleration -2, 20 Hz, factor 1.
  void limitedAxis_changes_areLimited_data() {
    QTest::addColumn<double>("current");
    QTest::addColumn<double>("command");
    QTest::addColumn<double>("scale");
    QTest::addColumn<double>("velocity");
    QTest::newRow("none") << 1.0 << 1.0 << 1.0 << 1.0;
    QTest::newRow("faster, within") << 0.5 << 0.55 << 1.0 << 0.55;
    QTest::newRow("slower, within") << 0.5 << 0.45 << 1.0 << 0.45;
    QTest::newRow("faster") << 1.0 << 2.0 << 1.0 << 1.075;
    QTest::newRow("slower") << 1.0 << -1.0 << 1.0 << 0.9;
    QTest::newRow("scaled") << 1.0 << 1.1 << 0.5 << 1.05;
  }

  void limitedAxis_changes_areLimited() {
    QFETCH(double, current);
    QFETCH(double, command);
    QFETCH(double, scale);
    QFETCH(double, velocity);
    QVERIFY(isNear(limitedAxis(current, command, {1.5, -2.0, 20.0}, scale), velocity));
  }

  /// 2.5 m/s² at 20 Hz: 0.125 m/s a tick.
  void update_openLoop_rampsUpAndDown() {
    VelocitySmoother smoother{{}};
    double time = 0.0;
    QVERIFY(areNear(speedsOf(smoother, 0.4, 5, time), {0.125, 0.25, 0.375, 0.4, 0.4}));
    QVERIFY(areNear(speedsOf(smoother, 0.1, 4, time), {0.275, 0.15, 0.1, 0.1}));
  }

  void update_throughZero_brakesFirst() {
    VelocitySmootherParameters parameters;
    parameters.maxDecel = {-1.0, 0.0, -3.2};  // 0.05 m/s a tick while signs differ
    VelocitySmoother smoother(parameters);
    double time = 0.0;
    QVERIFY(areNear(speedsOf(smoother, 0.1, 2, time), {0.1, 0.1}));
    QVERIFY(areNear(speedsOf(smoother, -0.3, 4, time), {0.05, 0.0, -0.125, -0.25}));
  }

  void update_command_isClampedToSpeeds() {
    VelocitySmootherParameters parameters;
    parameters.minVelocity = {-0.2, 0.0, -2.5};
    VelocitySmoother smoother(parameters);
    double time = 0.0;
    QVERIFY(areNear(speedsOf(smoother, 2.0, 6, time), {0.125, 0.25, 0.375, 0.5, 0.5, 0.5}));
    speedsOf(smoother, -9.0, 20, time);
    QVERIFY(areNear(speedsOf(smoother, -9.0, 1, time), {-0.2}));
  }

  /// v 0.5 in steps of 0.125, omega 0.5 of 0.16: the factor 0.25 is farther from 1 than 0.32.
  void update_scaleVelocities_keepsTheArc() {
    VelocitySmootherParameters parameters;
    parameters.scaleVelocities = true;
    VelocitySmoother smoother(parameters);
    smoother.command({0.5, 0.5}, 0.0);
    const BodyTwist twist = *smoother.update(0.0, {});
    QVERIFY(isNear(twist.linear, 0.125));
    QVERIFY(isNear(twist.angular, 0.125));
    VelocitySmoother plain{{}};
    plain.command({0.5, 0.5}, 0.0);
    QVERIFY(isNear(plain.update(0.0, {})->angular, 0.16));
  }

  void update_closedLoop_startsFromTheMeasuredMean() {
    VelocitySmootherParameters parameters;
    parameters.feedback = "CLOSED_LOOP";
    VelocitySmoother smoother(parameters);
    smoother.command({0.5, 0.0}, 0.0);
    QVERIFY(isNear(smoother.update(0.0, {0.1, 0.0})->linear, 0.225));
    QVERIFY(isNear(smoother.update(0.05, {0.3, 0.0})->linear, 0.325));  // mean 0.2
    QVERIFY(isNear(smoother.update(0.10, {0.2, 0.0})->linear, 0.325));  // 0.1, 0.3, 0.2
    QVERIFY(isNear(smoother.update(0.15, {0.1, 0.0})->linear, 0.325));  // 0.3, 0.2, 0.1
    QVERIFY(isNear(smoother.update(0.20, {0.0, 0.0})->linear, 0.225));  // 0.2, 0.1, 0
  }

  void update_deadband_sendsZeroAndRemembersTheRest() {
    VelocitySmootherParameters parameters;
    parameters.deadbandVelocity = {0.2, 0.0, 0.0};
    VelocitySmoother smoother(parameters);
    double time = 0.0;
    QVERIFY(areNear(speedsOf(smoother, 0.5, 3, time), {0.0, 0.25, 0.375}));
  }

  void update_timeout_brakesThenFallsSilent() {
    VelocitySmoother smoother{{}};
    double time = 0.0;
    speedsOf(smoother, 0.3, 4, time);  // the last command at 0.15 s
    std::vector<double> speeds;
    int silent = 0;
    for (; time < 2.0; time += 0.05) {
      const std::optional<BodyTwist> twist = smoother.update(time, {});
      if (twist && time > 1.125) {
        speeds.push_back(twist->linear);
      }
      silent += twist ? 0 : 1;
    }
    // Due until 1.15 s; from 1.20 s on it brakes: 0.3, then 0.175, 0.05, 0, and silence.
    QVERIFY(areNear(speeds, {0.3, 0.175, 0.05, 0.0}));
    QCOMPARE(silent, 13);
    smoother.command({0.5, 0.0}, time);
    QVERIFY(isNear(smoother.update(time, {})->linear, 0.125));
  }

  void update_noCommand_sendsNothing() {
    VelocitySmoother smoother{{}};
    for (int i = 0; i < 10; ++i) {
      QVERIFY(!smoother.update(0.05 * i, {}));
    }
  }

  void update_frequency_isCountedInWholes() {
    VelocitySmootherParameters parameters;
    parameters.smoothingFrequency = 10.0;
    VelocitySmoother smoother(parameters);
    std::vector<double> speeds;
    for (int i = 0; i < 6; ++i) {
      smoother.command({0.5, 0.0}, 0.05 * i);
      const std::optional<BodyTwist> twist = smoother.update(0.05 * i, {});
      QCOMPARE(twist.has_value(), i % 2 == 0);
      if (twist) {
        speeds.push_back(twist->linear);
      }
    }
    QVERIFY(areNear(speeds, {0.25, 0.5, 0.5}));
  }

  void update_noAcceleration_neverMoves() {
    VelocitySmootherParameters parameters;
    parameters.maxVelocity = {0.5, 0.5, 2.5};
    VelocitySmoother smoother(parameters);
    smoother.command({0.0, 0.0, 0.4}, 0.0);
    QCOMPARE(smoother.update(0.0, {})->lateral, 0.0);
    parameters.maxAccel = {2.5, 1.0, 3.2};
    VelocitySmoother omni(parameters);
    omni.command({0.0, 0.0, 0.4}, 0.0);
    QVERIFY(isNear(omni.update(0.0, {})->lateral, 0.05));
  }

  void problemsOf_parameters_areTold() {
    QVERIFY(problemsOf(VelocitySmootherParameters{}).empty());
    VelocitySmootherParameters parameters;
    parameters.feedback = "HALF_OPEN";
    parameters.maxVelocity = {1.0, 0.0};
    QCOMPARE(problemsOf(parameters).size(), std::size_t{2});
    parameters = {};
    parameters.maxDecel = {2.5, 0.0, -3.2};
    parameters.maxAccel = {-2.5, 0.0, 3.2};
    QCOMPARE(problemsOf(parameters).size(), std::size_t{2});
    QVERIFY(problemsOf(parameters)[0].message.find("max_accel") != std::string::npos);
  }
};

QTEST_APPLESS_MAIN(VelocitySmootherTest)
#include "tst_VelocitySmoother.moc"
