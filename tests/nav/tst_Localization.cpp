#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "sim2d/nav/Localization.h"

using base::Pose2;
using base::Vec2;
using sim2d::inverse;
using sim2d::kMaxDeviations;
using sim2d::LocalizationError;
using sim2d::LocalizationParameters;
using sim2d::Localizer;
using sim2d::toFrame;
using sim2d::toParent;

namespace {

constexpr std::uint64_t kSeed = 7;
constexpr int kRobot = -1;

/// 0.1 m, 0.2 m, 0.05 rad; 5 s; corrections at 2 Hz: neighbours have the correlation exp(-0.1).
LocalizationParameters usual() {
  LocalizationParameters parameters;
  parameters.stdX = 0.1;
  parameters.stdY = 0.2;
  parameters.stdYaw = 0.05;
  parameters.correlationTime = 5.0;
  parameters.rate = 2.0;
  return parameters;
}

std::vector<LocalizationError::Value> series(const LocalizationParameters& parameters, int count,
                                             std::uint64_t seed = kSeed) {
  LocalizationError error(parameters, seed, kRobot);
  std::vector<LocalizationError::Value> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    error.advanceTo(i);
    values.push_back(error.value());
  }
  return values;
}

/// Mean of value(i) value(i + lag).
double covariance(const std::vector<LocalizationError::Value>& values,
                  double LocalizationError::Value::*member, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t i = 0; i + lag < values.size(); ++i) {
    sum += values[i].*member * values[i + lag].*member;
  }
  return sum / static_cast<double>(values.size() - lag);
}

bool isClose(double value, double expected, double tolerance) {
  return std::fabs(value - expected) <= tolerance;
}

bool isClose(const Pose2& a, const Pose2& b, double tolerance = 1e-12) {
  return (a.position - b.position).norm() <= tolerance &&
         std::fabs(base::angleDiff(a.heading, b.heading)) <= tolerance;
}

}  // namespace

/// The error of a localiser against formulas by hand, and its frames.
class LocalizationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void frames_composed_areThoseByHand() {
    const Pose2 mapToOdom{{1.0, 2.0}, base::kPi / 2.0};
    const Pose2 inOdom{{3.0, 0.5}, -base::kPi / 2.0};
    // (3, 0.5) turned to the left by a right angle is (-0.5, 3).
    const Pose2 inMap{{0.5, 5.0}, 0.0};
    QVERIFY(isClose(toParent(mapToOdom, inOdom), inMap));
    QVERIFY(isClose(toFrame(mapToOdom, inMap), inOdom));
    QVERIFY(isClose(sim2d::frameBetween(inMap, inOdom), mapToOdom));
    QVERIFY(isClose(inverse(mapToOdom), {{-2.0, 1.0}, -base::kPi / 2.0}));
    const Pose2 odd{{0.1, 0.2}, 0.3};
    QVERIFY(toParent({}, odd) == odd && toFrame({}, odd) == odd);
    QVERIFY(sim2d::frameBetween(odd, odd) == Pose2{});
  }

  /// Of a normal variable cut at ± 3 the variance is
  /// (1 - 2 Q) - 6 phi(3) + 18 Q = 0.99501 with Q = 0.00134990, phi(3) = 0.00443185. Neighbours are
  /// correlated: 400000 values count as 400000 tanh(0.1) = 40000, so that the variance has a
  /// relative deviation of sqrt(2 / 40000) = 0.7 %.
  void process_varianceAndAutocovariance_areAnalytic_data() {
    QTest::addColumn<double>("rate");
    QTest::addColumn<int>("count");
    QTest::newRow("2 Hz") << 2.0 << 400000;
    QTest::newRow("0.5 Hz") << 0.5 << 200000;
    QTest::newRow("10 Hz") << 10.0 << 1000000;
  }
  void process_varianceAndAutocovariance_areAnalytic() {
    QFETCH(double, rate);
    QFETCH(int, count);
    using Value = LocalizationError::Value;
    LocalizationParameters parameters = usual();
    parameters.rate = rate;
    const std::vector<Value> values = series(parameters, count);
    struct {
      double Value::*member;
      double deviation;
    } const kAxes[] = {{&Value::x, 0.1}, {&Value::y, 0.2}, {&Value::yaw, 0.05}};
    for (const auto& axis : kAxes) {
      const double variance = axis.deviation * axis.deviation;
      QVERIFY(isClose(covariance(values, axis.member, 0) / variance, 0.99501, 0.03));
      for (const double seconds : {2.0, 4.0, 10.0}) {
        const auto lag = static_cast<std::size_t>(std::lround(seconds * rate));
        const double found = covariance(values, axis.member, lag) / variance;
        const double expected = std::exp(-seconds / 5.0);
        QVERIFY2(isClose(found, expected, 0.03),
                 qPrintable(QStringLiteral("%1 s: %2").arg(seconds).arg(found)));
      }
    }
    double across = 0.0;
    for (const Value& value : values) {
      across += value.x * value.y + value.x * value.yaw + value.y * value.yaw;
    }
    QVERIFY(isClose(across / count / (0.1 * 0.2), 0.0, 0.03));  // the axes are independent
  }

  void process_bound_isThreeDeviations() {
    double most = 0.0;
    for (const auto& value : series(usual(), 100000)) {
      most = std::max(
          {most, std::fabs(value.x) / 0.1, std::fabs(value.y) / 0.2, std::fabs(value.yaw) / 0.05});
    }
    QVERIFY(isClose(most, kMaxDeviations, 1e-12));  // 270 of 100000 normal draws are beyond
  }

  void process_withoutCorrelation_isWhite() {
    LocalizationParameters parameters = usual();
    parameters.correlationTime = 0.0;
    const auto values = series(parameters, 100000);
    QVERIFY(isClose(covariance(values, &LocalizationError::Value::x, 0) / 0.01, 0.99501, 0.02));
    QVERIFY(isClose(covariance(values, &LocalizationError::Value::x, 1) / 0.01, 0.0, 0.02));
  }

  /// 0.4 jumps/s: an interval of T has one with the probability 1 - exp(-0.4 T). What is left of
  /// the last jump at its end has the mean d * l / (l + m) * (1 - exp(-(l + m) T)) / (1 - exp(-l
  /// T)) with l = 0.4, m = 1 / 5: for T = 0.5 s it is 0.95321 d.
  void jumps_rateAndSize_arePoissons_data() {
    QTest::addColumn<double>("rate");
    QTest::addColumn<double>("share");
    QTest::addColumn<double>("mean");
    QTest::newRow("2 Hz") << 2.0 << 0.181269 << 0.95321;
    QTest::newRow("0.5 Hz") << 0.5 << 0.550671 << 0.84600;
  }
  void jumps_rateAndSize_arePoissons() {
    QFETCH(double, rate);
    QFETCH(double, share);
    QFETCH(double, mean);
    LocalizationParameters parameters;
    parameters.rate = rate;
    parameters.jumpRate = 0.4;
    parameters.jumpDistance = 0.3;
    parameters.jumpYaw = 0.1;
    const double kept = std::exp(-1.0 / rate / 5.0);
    constexpr int kCount = 40000;
    const auto values = series(parameters, kCount);
    int jumps = 0, left = 0;
    double sizes = 0.0;
    Vec2 directions = Vec2::Zero();
    for (std::size_t i = 1; i < values.size(); ++i) {
      const Vec2 now(values[i].x, values[i].y), before(values[i - 1].x, values[i - 1].y);
      if ((now - kept * before).norm() < 1e-12) {
        continue;
      }
      ++jumps;
      sizes += now.norm();
      directions += now.normalized();
      left += values[i].yaw > 0.0 ? 1 : 0;
      QVERIFY(now.norm() <= 0.3 && now.norm() > 0.3 * kept);
      QVERIFY(isClose(std::fabs(values[i].yaw) / 0.1, now.norm() / 0.3, 1e-12));
    }
    const double expected = share * kCount;
    QVERIFY2(isClose(jumps, expected, 4.0 * std::sqrt(expected * (1.0 - share))),
             qPrintable(QString::number(jumps)));
    QVERIFY2(isClose(sizes / jumps / 0.3, mean, 0.004),
             qPrintable(QString::number(sizes / jumps / 0.3)));
    QVERIFY(directions.norm() / jumps < 0.05);
    QVERIFY(isClose(static_cast<double>(left) / jumps, 0.5, 0.03));
  }

  void startError_relaxes() {
    LocalizationParameters parameters;
    parameters.rate = 2.0;
    parameters.startX = 1.0;
    parameters.startY = -0.5;
    parameters.startYaw = 0.2;
    const auto values = series(parameters, 11);
    QCOMPARE(values[0].x, 1.0);
    QCOMPARE(values[0].yaw, 0.2);
    QVERIFY(isClose(values[10].x, 0.36787944117144233, 1e-12));  // after 5 s
    QVERIFY(isClose(values[10].y, -0.18393972058572117, 1e-12));
    QVERIFY(isClose(values[10].yaw, 0.073575888234288464, 1e-12));
  }

  /// Over 4000 seeds the deviation of the draw has a relative error of 1.1 %.
  void relocalize_replacesTheError_andRelaxes() {
    LocalizationParameters parameters;
    parameters.rate = 2.0;
    parameters.startX = 5.0;
    parameters.globalStd = 1.0;
    parameters.globalStdYaw = 0.4;
    double squares = 0.0, turns = 0.0;
    constexpr int kSeeds = 4000;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      LocalizationError error(parameters, static_cast<std::uint64_t>(seed), kRobot);
      error.advanceTo(0);
      error.relocalize();
      QCOMPARE(error.value().x, 5.0);  // with the next correction
      error.advanceTo(1);
      const LocalizationError::Value drawn = error.value();
      squares += 0.5 * (drawn.x * drawn.x + drawn.y * drawn.y);
      turns += drawn.yaw * drawn.yaw;
      QVERIFY(std::fabs(drawn.x) <= 3.0 && std::fabs(drawn.yaw) <= 1.2 + 1e-12);
      error.advanceTo(11);
      QVERIFY(isClose(error.value().x, drawn.x * std::exp(-1.0), 1e-12));
    }
    QVERIFY(isClose(squares / kSeeds, 0.99501, 0.05));
    QVERIFY(isClose(turns / kSeeds / 0.16, 0.99501, 0.07));
  }

  void draws_dependOnSeedRobotAndNumberAlone() {
    const auto once = series(usual(), 50), again = series(usual(), 50);
    LocalizationError leaping(usual(), kSeed, kRobot);
    leaping.advanceTo(49);
    QVERIFY(leaping.value().x == once[49].x && leaping.value().yaw == again[49].yaw);
    QVERIFY(series(usual(), 50, 8)[49].x != once[49].x);
    LocalizationError other(usual(), kSeed, -2);
    other.advanceTo(49);
    QVERIFY(other.value().x != once[49].x);
    LocalizationError branched(usual(), kSeed, kRobot);
    branched.advanceTo(20);
    branched.reseed(8);
    QVERIFY(branched.value().x == once[20].x);
    branched.advanceTo(21);
    QVERIFY(branched.value().x != once[21].x);
  }

  /// Odometry that is exact, corrections at 2 Hz: whatever the step, at 10 s it is the same.
  void localizer_stepSize_doesNotMatter() {
    std::vector<Pose2> frames;
    for (const double dt : {0.01, 0.05, 0.1, 2.5}) {
      Localizer localizer(usual(), kSeed, kRobot);
      const Pose2 pose{{3.0, 1.0}, 0.4};
      for (int step = 0; step * dt < 10.0 + 0.5 * dt; ++step) {
        localizer.update(pose, pose, step * dt);
      }
      frames.push_back(localizer.mapToOdom());
    }
    for (const Pose2& frame : frames) {
      QVERIFY(frame == frames.front());
    }
    QVERIFY(!sim2d::isIdentity(frames.front()));
  }

  void localizer_correctsAtItsRate_odometryMovesBetween() {
    LocalizationParameters parameters = usual();
    parameters.rate = 4.0;
    Localizer localizer(parameters, kSeed, kRobot);
    Pose2 truth, odometry, last;
    int changes = 0;
    for (int step = 0; step < 200; ++step) {  // 10 s
      truth = {{0.02 * step, 0.0}, 0.0};
      odometry = {{0.021 * step, 0.001 * step}, 0.0005 * step};
      localizer.update(truth, odometry, 0.05 * step);
      changes += localizer.mapToOdom() != last ? 1 : 0;
      last = localizer.mapToOdom();
    }
    QCOMPARE(changes, 40);  // at 0, 0.25 … 9.75 s
  }

  void localizer_estimate_isTruthPlusError() {
    LocalizationParameters parameters;
    parameters.startX = 0.3;
    parameters.startY = -0.2;
    parameters.startYaw = 0.1;
    Localizer localizer(parameters, kSeed, kRobot);
    const Pose2 truth{{2.0, 1.0}, 0.5}, odometry{{1.7, 1.4}, -0.3};
    localizer.update(truth, odometry, 0.0);
    QVERIFY(isClose(toParent(localizer.mapToOdom(), odometry), {{2.3, 0.8}, 0.6}));
    // Then odometry alone moves it: 1 m ahead of where it takes itself to be.
    const Pose2 ahead{odometry.ahead(1.0), odometry.heading};
    localizer.update({truth.ahead(1.0), truth.heading}, ahead, 5.0);
    QVERIFY(isClose(toParent(localizer.mapToOdom(), ahead),
                    {{2.3 + std::cos(0.6), 0.8 + std::sin(0.6)}, 0.6}));
  }

  void localizer_withoutErrors_takesDriftAway() {
    LocalizationParameters parameters;
    parameters.rate = 10.0;
    Localizer localizer(parameters, kSeed, kRobot);
    const Pose2 truth{{4.0, 1.0}, 0.2}, odometry{{3.5, 1.3}, 0.1};
    localizer.update(odometry, odometry, 0.0);
    QVERIFY(sim2d::isIdentity(localizer.mapToOdom()));
    localizer.update(truth, odometry, 0.1);
    QVERIFY(isClose(toParent(localizer.mapToOdom(), odometry), truth));
  }

  void localizer_unused_leavesFramesTogether() {
    Localizer localizer({}, kSeed, kRobot);
    localizer.update({{4.0, 1.0}, 0.2}, {{4.0, 1.0}, 0.2}, 0.0);
    localizer.update({{5.0, 1.0}, 0.2}, {{4.9, 1.1}, 0.1}, 1.0);
    QVERIFY(sim2d::isIdentity(localizer.mapToOdom()) && localizer.isLocalized());
    QVERIFY(!localizer.isActive() && !localizer.canRelocalize());
  }

  void localizer_lateInitialPose_isNotLocalizedBefore() {
    LocalizationParameters parameters = usual();
    parameters.initialPoseTime = 1.0;
    Localizer localizer(parameters, kSeed, kRobot);
    for (int step = 0; step <= 20; ++step) {
      localizer.update({{1.0, 0.0}, 0.0}, {{1.0, 0.0}, 0.0}, 0.05 * step);
      QCOMPARE(localizer.isLocalized(), step == 20);
      QCOMPARE(sim2d::isIdentity(localizer.mapToOdom()), step < 20);
    }
  }

  void localizer_robotIsPutElsewhere_correctsAtOnce() {
    Localizer localizer(usual(), kSeed, kRobot);
    localizer.update({}, {}, 0.0);
    const Pose2 error = localizer.mapToOdom();  // both poses are the origin
    const Pose2 elsewhere{{-3.0, 2.0}, 0.0};
    localizer.reset();
    localizer.update(elsewhere, {{1.0, 1.0}, 0.7}, 0.05);
    const Pose2 estimate = toParent(localizer.mapToOdom(), {{1.0, 1.0}, 0.7});
    QVERIFY(isClose(estimate, {elsewhere.position + error.position, error.heading}));
  }
};

QTEST_APPLESS_MAIN(LocalizationTest)
#include "tst_Localization.moc"
