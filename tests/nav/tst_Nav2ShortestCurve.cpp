#include <cmath>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/global/ShortestCurve.h"
#include "tests/nav/CostmapSketch.h"
#include "tests/nav/MetaTypes.h"

using costs::Numbers;
using namespace sim2d::nav2;

namespace {

constexpr double kTurn = base::kPi;

Pose2 randomPose(Numbers& numbers, double spread) {
  return {{numbers.between(-spread, spread), numbers.between(-spread, spread)},
          numbers.between(-kTurn, kTurn)};
}

double lengthOf(CarMotion motion, const Pose2& from, const Pose2& to, double radius) {
  return shortestCurve(motion, from, to, radius).length();
}

}  // namespace

class Nav2ShortestCurveTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void length_posesOfOmpl_isOmpls_data() {
    QTest::addColumn<Pose2>("to");
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("dubins");
    QTest::addColumn<double>("reedsShepp");
    // From (0, 0, 0), by OMPL 1.5.2: DubinsStateSpace and ReedsSheppStateSpace.
    const auto row = [](const char* name, const Pose2& to, double radius, double dubins,
                        double reedsShepp) {
      QTest::newRow(name) << to << radius << dubins << reedsShepp;
    };
    row("turn on the spot", {{0, 0}, 0.5 * kTurn}, 1.0, 6.4085131383, 1.5707963268);
    row("turn round nearby", {{0, 0.5}, kTurn}, 1.0, 6.7242518290, 3.1415926536);
    row("near", {{1, 1}, 0.5}, 1.0, 7.6402046473, 1.7636584979);
    row("behind", {{-2, 0.3}, 0.1}, 0.4, 4.4564695749, 2.0236946541);
    row("three cusps", {{0.2, 0.1}, 2.5}, 0.4, 2.8747535251, 1.0);
    row("far", {{10, -7}, -2.0}, 1.5, 12.9173915115, 12.9173915115);
    row("beside", {{0, 1}, 0}, 1.0, 7.2831853072, 2.6362321433);
    row("across", {{3, 3}, -0.5 * kTurn}, 1.0, 6.7123889804, 5.4253867628);
    row("almost round", {{0.5, 0}, 3.0}, 1.0, 7.1632306903, 3.0);
    row("ahead", {{2, -0.4}, 0.7}, 0.8, 2.1777636718, 2.1777636718);
    row("half left, straight", {{-3, 2}, kTurn}, 1.0, kTurn + 3.0, 4.7471439291);
    row("close beside", {{0.05, 0.6}, -0.3}, 1.2, 7.8597325689, 2.1213894653);
  }

  void length_posesOfOmpl_isOmpls() {
    QFETCH(Pose2, to);
    QFETCH(double, radius);
    QFETCH(double, dubins);
    QFETCH(double, reedsShepp);
    QVERIFY(std::fabs(lengthOf(CarMotion::Dubins, {}, to, radius) - dubins) < 1e-9);
    QVERIFY(std::fabs(lengthOf(CarMotion::ReedsShepp, {}, to, radius) - reedsShepp) < 1e-9);
  }

  void length_byHand_isThat_data() {
    QTest::addColumn<Pose2>("to");
    QTest::addColumn<double>("dubins");
    QTest::addColumn<double>("reedsShepp");
    QTest::newRow("nowhere") << Pose2{} << 0.0 << 0.0;
    QTest::newRow("straight") << Pose2{{4, 0}, 0} << 4.0 << 4.0;
    QTest::newRow("quarter left") << Pose2{{1, 1}, 0.5 * kTurn} << 0.5 * kTurn << 0.5 * kTurn;
    QTest::newRow("half right") << Pose2{{0, -2}, kTurn} << kTurn << kTurn;
    QTest::newRow("back one") << Pose2{{-1, 0}, 0} << 2.0 * kTurn + 1.0 << 1.0;
    QTest::newRow("quarter right backward")
        << Pose2{{-1, -1}, 0.5 * kTurn} << 1.5 * kTurn << 0.5 * kTurn;
    QTest::newRow("lane change") << Pose2{{4, 2}, 0}
                                 // Inner tangent of circles at (0, 1) and (4, 1): asin(2 / 4) each.
                                 << 2.0 * kTurn / 6.0 + 2.0 * std::sqrt(3.0)
                                 << 2.0 * kTurn / 6.0 + 2.0 * std::sqrt(3.0);
  }

  void length_byHand_isThat() {
    QFETCH(Pose2, to);
    QFETCH(double, dubins);
    QFETCH(double, reedsShepp);
    // At any scale, and seen from anywhere.
    for (const double radius : {1.0, 0.4, 7.0}) {
      const Pose2 from{{3.0, -2.0}, 0.9};
      const Pose2 there{from.toWorld(radius * to.position), from.heading + to.heading};
      QVERIFY(std::fabs(lengthOf(CarMotion::Dubins, from, there, radius) - radius * dubins) <
              1e-6 * radius);
      QVERIFY(std::fabs(lengthOf(CarMotion::ReedsShepp, from, there, radius) -
                        radius * reedsShepp) < 1e-6 * radius);
    }
  }

  void length_farApart_isBetweenBounds() {
    Numbers numbers(1);
    for (int i = 0; i < 2000; ++i) {
      const Pose2 from = randomPose(numbers, 5.0), to = randomPose(numbers, 5.0);
      const double radius = numbers.between(0.1, 2.0);
      const double straight = (to.position - from.position).norm();
      const double dubins = lengthOf(CarMotion::Dubins, from, to, radius);
      const double reedsShepp = lengthOf(CarMotion::ReedsShepp, from, to, radius);
      QVERIFY(straight <= reedsShepp + 1e-9);
      QVERIFY(reedsShepp <= dubins + 1e-9);
      // Dubins: d + 7/3 pi R (Goaoc et al. 2013); Reeds and Shepp need no loops: d + pi R.
      QVERIFY(dubins <= straight + 7.0 / 3.0 * kTurn * radius + 1e-9);
      QVERIFY(reedsShepp <= straight + kTurn * radius + 1e-9);
    }
  }

  void at_end_isTheGoal() {
    Numbers numbers(2);
    for (int i = 0; i < 4000; ++i) {
      const CarMotion motion = i % 2 == 0 ? CarMotion::Dubins : CarMotion::ReedsShepp;
      const Pose2 from = randomPose(numbers, i % 3 == 0 ? 0.3 : 6.0);
      const Pose2 to = randomPose(numbers, i % 3 == 0 ? 0.3 : 6.0);
      const ShortestCurve curve = shortestCurve(motion, from, to, 0.7);
      const Pose2 end = curve.at(curve.length());
      QVERIFY((end.position - to.position).norm() < 1e-8);
      QVERIFY(std::fabs(base::angleDiff(end.heading, to.heading)) < 1e-8);
      QCOMPARE(curve.at(0.0).position, from.position);
    }
  }

  void at_anywhere_turnsNoSharperThanTheCircle() {
    Numbers numbers(3);
    constexpr double kStep = 0.01, kRadius = 0.5;
    for (int i = 0; i < 100; ++i) {
      const bool isForward = i % 2 == 0;
      const ShortestCurve curve =
          shortestCurve(isForward ? CarMotion::Dubins : CarMotion::ReedsShepp,
                        randomPose(numbers, 2.0), randomPose(numbers, 2.0), kRadius);
      Pose2 before = curve.at(0.0);
      for (double s = kStep; s < curve.length(); s += kStep) {
        const Pose2 pose = curve.at(s);
        const Vec2 way = pose.position - before.position;
        QVERIFY(way.norm() <= kStep + 1e-9);
        QVERIFY(std::fabs(base::angleDiff(pose.heading, before.heading)) <= kStep / kRadius + 1e-9);
        const double aside = base::cross(before.direction(), way);
        QVERIFY(std::fabs(aside) <= kStep * kStep / kRadius);  // it moves along its heading
        QVERIFY(!isForward || way.dot(before.direction()) > 0.0);
        before = pose;
      }
    }
  }

  void length_reedsShepp_isSymmetric() {
    Numbers numbers(4);
    for (int i = 0; i < 2000; ++i) {
      const Pose2 a = randomPose(numbers, 3.0), b = randomPose(numbers, 3.0);
      QVERIFY(std::fabs(lengthOf(CarMotion::ReedsShepp, a, b, 0.8) -
                        lengthOf(CarMotion::ReedsShepp, b, a, 0.8)) < 1e-7);
    }
  }

  void length_reedsShepp_isAMetric() {
    Numbers numbers(5);
    for (int i = 0; i < 2000; ++i) {
      const Pose2 a = randomPose(numbers, 2.0), b = randomPose(numbers, 2.0),
                  c = randomPose(numbers, 2.0);
      for (const CarMotion motion : {CarMotion::Dubins, CarMotion::ReedsShepp}) {
        QVERIFY(lengthOf(motion, a, c, 0.8) <=
                lengthOf(motion, a, b, 0.8) + lengthOf(motion, b, c, 0.8) + 1e-7);
      }
    }
  }

  void length_mirrored_isTheSame() {
    Numbers numbers(6);
    for (int i = 0; i < 2000; ++i) {
      const Pose2 to = randomPose(numbers, 3.0);
      const Pose2 mirrored{{to.position.x(), -to.position.y()}, -to.heading};
      for (const CarMotion motion : {CarMotion::Dubins, CarMotion::ReedsShepp}) {
        QVERIFY(std::fabs(lengthOf(motion, {}, to, 0.8) - lengthOf(motion, {}, mirrored, 0.8)) <
                1e-7);
      }
    }
  }
};

QTEST_APPLESS_MAIN(Nav2ShortestCurveTest)
#include "tst_Nav2ShortestCurve.moc"
