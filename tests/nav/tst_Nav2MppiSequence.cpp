#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/mppi/MppiSequence.h"

using namespace sim2d::nav2;

namespace {

MppiSequence sequenceOf(std::size_t count, const std::vector<float>& vx,
                        const std::vector<float>& wz = {}) {
  MppiSequence sequence;
  for (std::vector<float>& axis : sequence) {
    axis.assign(count, 0.0F);
  }
  std::copy(vx.begin(), vx.end(), sequence[0].begin());
  std::copy(wz.begin(), wz.end(), sequence[1].begin());
  return sequence;
}

bool isNear(float found, double wanted, double tolerance = 1e-6) {
  return std::fabs(static_cast<double>(found) - wanted) <= tolerance;
}

/// One trajectory whose controls are `controls` of vx and whose noise is 0.
struct OneRoll {
  explicit OneRoll(const MppiSequence& sequence)
      : mean(sequence), columns(1, static_cast<int>(sequence[0].size())) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      problem.mean[axis] = mean[axis].data();
      problem.least[axis] = -0.3F;
      problem.most[axis] = 0.1F;
    }
  }
  void roll() { trajectoryKernelOf(sim2d::fastestMppiSimdLevel()).roll(problem, columns.view()); }
  float speed(int step, std::size_t axis = 0) const {
    return columns.speeds[axis][columns.elementIndex(step, 0)];
  }
  float control(int step, std::size_t axis = 0) const {
    return columns.controls[axis][columns.elementIndex(step, 0)];
  }
  float x(int step) const { return columns.x[columns.elementIndex(step, 0)]; }
  float y(int step) const { return columns.y[columns.elementIndex(step, 0)]; }

  MppiSequence mean;
  TrajectoryBuffer columns;
  RolloutProblem problem;
};

}  // namespace

/// What Nav2's MPPI does to its sequence of controls: numbers of Nav2's own tests ("vector …"), and
/// by hand.
class Nav2MppiSequenceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shiftOf_vector68_areMet() {
    QCOMPARE(mppiShiftOf(1.0, 0.1), MppiShift::Refused);
    QCOMPARE(mppiShiftOf(1.0 / 30.0, 0.1), MppiShift::Keeps);
    QCOMPARE(mppiShiftOf(0.1, 0.1), MppiShift::Shifts);
    QCOMPARE(mppiShiftOf(0.1 + 9e-7, 0.1), MppiShift::Shifts);
    QCOMPARE(mppiShiftOf(0.1 + 2e-6, 0.1), MppiShift::Refused);
  }

  void retries_vector69_areMet() {
    using Next = MppiRetries::Next;
    MppiRetries retries(2);
    for (int round = 0; round < 2; ++round) {  // it begins anew after giving up
      QCOMPARE(retries.after(true), Next::Retry);
      QCOMPARE(retries.after(true), Next::Retry);
      QCOMPARE(retries.after(true), Next::GiveUp);
    }
    QCOMPARE(retries.after(true), Next::Retry);
    QCOMPARE(retries.after(false), Next::Done);
    QCOMPARE(retries.after(true), Next::Retry);
  }

  void shiftByOne_vector70_isMet() {
    MppiSequence sequence = sequenceOf(5, {9999.0F, 6.0F, 888.0F, 0.0F, 3.0F});
    shiftByOne(sequence);
    QCOMPARE(sequence[0], (std::vector<float>{6.0F, 888.0F, 0.0F, 3.0F, 3.0F}));
  }

  void limitedTo_vector71_areMet() {
    const MppiLimits base = mppiLimitsOf({});
    const MppiLimits half = withSpeedLimit(base, 50.0, true);
    QVERIFY(isNear(half.high[0], 0.25) && isNear(half.low[0], -0.175));
    QVERIFY(isNear(half.high[1], 0.95) && isNear(half.low[2], -0.25));
    const MppiLimits more = withSpeedLimit(base, 0.75, false);
    QVERIFY(isNear(more.high[0], 0.75) && isNear(more.low[0], -0.525));
    QVERIFY(isNear(more.high[1], 2.85));
    QCOMPARE(withSpeedLimit(base, 0.0, true).high[0], base.high[0]);
    QCOMPARE(half.most[0], base.most[0]);
  }

  void roll_vector72_areMet_data() {
    QTest::addColumn<double>("lateral");
    QTest::newRow("ahead") << 0.0;
    QTest::newRow("Omni") << 0.2;
  }

  /// 0.1 m/s and steps of 0.1 s: x(i) = 0.01 i, and y(i) = 0.02 i; at rest before.
  void roll_vector72_areMet() {
    QFETCH(double, lateral);
    MppiSequence sequence = sequenceOf(30, std::vector<float>(30, 0.1F));
    sequence[2].assign(30, static_cast<float>(lateral));
    OneRoll roll(sequence);
    roll.problem.isLimited = false;
    roll.problem.isHolonomic = lateral > 0.0;
    roll.problem.dt = 0.1F;
    roll.roll();
    for (int step = 0; step < 30; ++step) {
      QVERIFY(isNear(roll.x(step), 0.01 * step));
      QVERIFY(isNear(roll.y(step), 0.1 * lateral * step));
    }
    QVERIFY(isNear(roll.columns.length[0], 2.9 * std::hypot(0.1, lateral)));
  }

  void tieToSpeed_vector73_isMet() {
    MppiSettings settings;
    settings.axMax = 1.0;
    settings.axMin = -1.0;
    const MppiLimits limits = mppiLimitsOf(settings);
    MppiSequence sequence = sequenceOf(4, {1.0F, 1.0F, 1.0F, 1.0F});
    limitFirstToSpeed(sequence, limits, {}, 0.05F);
    QVERIFY(isNear(sequence[0][0], 0.05));
    QCOMPARE(sequence[0][1], 1.0F);
    limitFirstToSpeed(sequence, limits, {0.3F, 0.1F, 0.0F}, 0.0F);  // shifting: the present speed
    QCOMPARE(sequence[0][0], 0.3F);
    QCOMPARE(sequence[1][0], 0.1F);
  }

  /// A robot that goes ahead gains 0.1 and loses 0.3 per step; back, it is the other way round.
  void roll_accelerations_limitByTheSideOfZero() {
    OneRoll roll(sequenceOf(6, {1.0F, 1.0F, -1.0F, -1.0F, 1.0F, 1.0F}));
    roll.problem.speed[0] = 0.15F;
    roll.roll();
    const double wanted[] = {0.15, 0.25, 0.35, 0.05, -0.25, 0.05};
    for (int step = 0; step < 6; ++step) {
      QVERIFY(isNear(roll.speed(step), wanted[step]));
    }
    QCOMPARE(roll.control(2), -1.0F);  // main: the controls stay raw
  }

  void roll_writeBack_leavesTheLastControl() {
    OneRoll roll(sequenceOf(4, {1.0F, 1.0F, 1.0F, 1.0F}));
    roll.problem.writesLimitedControls = true;
    roll.problem.controlCost[0] = 2.0F;
    roll.roll();
    const double wanted[] = {0.3, 0.4, 0.5, 1.0};  // at rest it counts as going back
    double controlCost = 0.0;
    for (int step = 0; step < 4; ++step) {
      QVERIFY(isNear(roll.control(step), wanted[step]));
      controlCost += 2.0 * 1.0 * (wanted[step] - 1.0);  // gamma's share is of what is averaged
    }
    QVERIFY(isNear(roll.columns.controlCost[0], controlCost));
  }

  void roll_delays_holdTheSpeed() {
    OneRoll roll(sequenceOf(6, {1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F}));
    roll.problem.isLimited = false;
    roll.problem.speed[0] = 0.5F;
    roll.problem.delay[0] = 2;
    roll.roll();
    const float wanted[] = {0.5F, 0.5F, 0.5F, 1.0F, 2.0F, 3.0F};
    for (int step = 0; step < 6; ++step) {
      QCOMPARE(roll.speed(step), wanted[step]);
    }
  }

  /// Each step along the heading at its begin: 1 m/s, quarter turns per step of 1 s after the
  /// first.
  void roll_curve_byHand() {
    const auto quarter = static_cast<float>(base::kPi / 2.0);
    OneRoll roll(sequenceOf(5, std::vector<float>(5, 1.0F), std::vector<float>(5, quarter)));
    roll.problem.isLimited = false;
    roll.problem.dt = 1.0F;
    roll.problem.x = 10.0F;
    roll.problem.y = 20.0F;
    roll.problem.yaw = quarter;
    roll.problem.speed[0] = 1.0F;
    roll.roll();
    const double x[] = {10.0, 10.0, 9.0, 9.0, 10.0};  // turned from the end of step 1 on
    const double y[] = {21.0, 22.0, 22.0, 21.0, 21.0};
    for (int step = 0; step < 5; ++step) {
      QVERIFY(isNear(roll.x(step), x[step], 5e-6));
      QVERIFY(isNear(roll.y(step), y[step], 5e-6));
    }
  }

  void limitEachOther_firstElement_isFree() {
    const MppiLimits limits = mppiLimitsOf({});  // 0.15 per step of 0.05 s
    MppiSequence sequence = sequenceOf(4, {0.9F, 0.0F, -0.9F, -0.9F}, {3.0F, 1.0F, 1.8F, 1.8F});
    limitChanges(sequence, limits, 0.05F, true);
    const double vx[] = {0.5, 0.35, 0.2, 0.05};
    const double wz[] = {1.9, 1.725, 1.8, 1.8};
    for (std::size_t i = 0; i < 4; ++i) {
      QVERIFY(isNear(sequence[0][i], vx[i]));
      QVERIFY(isNear(sequence[1][i], wz[i]));
    }
    sequence = sequenceOf(3, {0.9F, 0.0F, -0.9F});
    limitChanges(sequence, limits, 0.05F, false);
    QCOMPARE(sequence[0], (std::vector<float>{0.5F, 0.0F, -0.35F}));
  }

  void limitFromSpeed_firstElement_isTied() {
    const MppiLimits limits = mppiLimitsOf({});
    MppiSequence sequence = sequenceOf(3, {0.9F, 0.9F, 0.9F});
    limitChangesFromSpeed(sequence, limits, {0.1F, 0.0F, 0.0F}, 0.02F, 0.05F);
    const double wanted[] = {0.16, 0.31, 0.46};
    for (std::size_t i = 0; i < 3; ++i) {
      QVERIFY(isNear(sequence[0][i], wanted[i]));
    }
    limitChangesFromSpeed(sequence, limits, {0.1F, 0.0F, 0.0F}, 0.0F, 0.05F);  // shifting
    QVERIFY(isNear(sequence[0][0], 0.1) && isNear(sequence[0][1], 0.25));
  }

  void limitTurns_anySpeed_byHand() {
    MppiSequence sequence = sequenceOf(4, {0.2F, -0.2F, 0.0F, 0.2F}, {1.5F, -1.5F, 1.0F, 0.5F});
    limitTurningRadius(sequence, 0.2F);
    QCOMPARE(sequence[1], (std::vector<float>{1.0F, -1.0F, 0.0F, 0.5F}));
  }

  /// The filter keeps a quadratic, away from what it pads with. The last element stays.
  void filter_quadratic_isKept() {
    MppiSequence sequence = sequenceOf(30, {});
    std::array<MppiControl, 4> sent{};
    const auto law = [](int i) { return static_cast<float>(0.1 + 0.02 * i - 0.001 * i * i); };
    for (int i = -4; i < 30; ++i) {
      if (i < 0) {
        sent[static_cast<std::size_t>(i + 4)][1] = law(i);
      } else {
        sequence[1][static_cast<std::size_t>(i)] = law(i);
      }
    }
    QVERIFY(filterSequence(sequence, sent, 2));
    for (int i = 0; i < 26; ++i) {
      QVERIFY(isNear(sequence[1][static_cast<std::size_t>(i)], static_cast<double>(law(i))));
    }
    QCOMPARE(sequence[1][29], law(29));
    // A step of 1 at the end: the last value is held, so element 28 sees it in four taps.
    sequence = sequenceOf(30, {});
    sequence[0][29] = 1.0F;
    QVERIFY(filterSequence(sequence, {}, 2));
    QVERIFY(isNear(sequence[0][28], (54.0 + 39.0 + 14.0 - 21.0) / 231.0));
    QVERIFY(isNear(sequence[0][25], -21.0 / 231.0));
    QCOMPARE(sequence[0][29], 1.0F);
  }

  void filter_orderOne_isTheMeanOfNine() {
    MppiSequence sequence = sequenceOf(30, {9.0F});
    const std::array<MppiControl, 4> sent = {{{0.0F}, {0.0F}, {0.0F}, {1.8F}}};
    QVERIFY(filterSequence(sequence, sent, 1));
    QVERIFY(isNear(sequence[0][0], 10.8 / 9.0));
    QVERIFY(isNear(sequence[0][3], 10.8 / 9.0));
    QVERIFY(isNear(sequence[0][4], 1.0));
    QVERIFY(isNear(sequence[0][5], 0.0));
  }

  void filter_short_isLeft() {
    MppiSequence sequence = sequenceOf(20, {9.0F});
    QVERIFY(!filterSequence(sequence, {}, 2));
    QCOMPARE(sequence[0][0], 9.0F);
    sequence = sequenceOf(21, {9.0F});
    QVERIFY(filterSequence(sequence, {}, 2));
  }

  void integrated_turn_byHand() {
    MppiSequence sequence = sequenceOf(3, {1.0F, 1.0F, 1.0F}, {0.0F, 2.0F, 0.0F});
    sequence[2] = {0.0F, 0.0F, 0.5F};
    const Path path = integratePath({Vec2(1.0, 1.0), base::kPi / 2.0}, sequence, 0.5);
    QVERIFY((path[0].position - Vec2(1.0, 1.5)).norm() < 1e-9);
    QVERIFY((path[1].position - Vec2(1.0, 2.0)).norm() < 1e-9);
    const double heading = base::kPi / 2.0 + 1.0;
    const Vec2 last = Vec2(1.0, 2.0) + 0.5 * Vec2(std::cos(heading), std::sin(heading)) +
                      0.25 * Vec2(-std::sin(heading), std::cos(heading));
    QVERIFY((path[2].position - last).norm() < 1e-9);
  }
};

QTEST_APPLESS_MAIN(Nav2MppiSequenceTest)
#include "tst_Nav2MppiSequence.moc"
