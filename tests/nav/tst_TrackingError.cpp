#include <cmath>

#include <QtTest>

#include "sim2d/nav/nav2/control/TrackingError.h"

/// How far a robot is off its path, by hand.
class TrackingErrorTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void besideThePath_hasASide();
  void heading_isOfTheSegment();
  void window_endsTheSearch();
  void shortPaths_haveAnAnswer();
};

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

constexpr double kPi = 3.14159265358979323846;
bool isNear(double a, double b) {
  return std::fabs(a - b) < 1e-9;
}

/// 4 m along x, then 3 m along y.
const Path kCorner = {{{0, 0}, 0}, {{2, 0}, 0}, {{4, 0}, 0}, {{4, 3}, 0}};

}  // namespace

void TrackingErrorTest::besideThePath_hasASide() {
  const TrackingFeedback left = trackingError(kCorner, {{1.0, 0.5}, 0.0}, 0, -1.0);
  QVERIFY(isNear(left.positionError, 0.5));
  QCOMPARE(left.index, std::size_t{0});
  QVERIFY(isNear(left.remaining, 6.0));
  QVERIFY(isNear(left.distanceToGoal, std::hypot(3.0, 2.5)));
  QVERIFY(isNear(trackingError(kCorner, {{1.0, -0.5}, 0.0}, 0, -1.0).positionError, -0.5));
  // East of the second leg, which leads north, is its right.
  const TrackingFeedback right = trackingError(kCorner, {{4.25, 2.0}, 0.0}, 0, -1.0);
  QVERIFY(isNear(right.positionError, -0.25));
  QCOMPARE(right.index, std::size_t{2});
  QVERIFY(isNear(right.remaining, 1.0));
}

void TrackingErrorTest::heading_isOfTheSegment() {
  QVERIFY(isNear(trackingError(kCorner, {{1.0, 0.1}, 0.3}, 0, -1.0).headingError, -0.3));
  QVERIFY(isNear(trackingError(kCorner, {{4.1, 2.0}, 0.3}, 0, -1.0).headingError, 0.5 * kPi - 0.3));
  const Path still = {{{1, 1}, 0.7}, {{1, 1}, 0.7}};
  QVERIFY(isNear(trackingError(still, {{0, 1}, 0.2}, 0, -1.0).headingError, 0.5));
}

void TrackingErrorTest::window_endsTheSearch() {
  const Pose2 robot{{4.0, 2.0}, 0.0};  // on the second leg
  QVERIFY(isNear(trackingError(kCorner, robot, 0, -1.0).positionError, 0.0));
  const TrackingFeedback near = trackingError(kCorner, robot, 0, 3.0);  // up to the corner
  QCOMPARE(near.index, std::size_t{1});
  QVERIFY(isNear(near.positionError, 2.0));
  QCOMPARE(trackingError(kCorner, {{0.0, 0.0}, 0.0}, 1, -1.0).index, std::size_t{1});
}

void TrackingErrorTest::shortPaths_haveAnAnswer() {
  QVERIFY(isNear(trackingError({}, {{1, 2}, 0.5}, 0, 2.0).positionError, 0.0));
  const TrackingFeedback one = trackingError({{{3, 4}, 1.0}}, {{0, 0}, 0.5}, 0, 2.0);
  QVERIFY(isNear(one.positionError, 5.0) && isNear(one.headingError, 0.5));
  QVERIFY(isNear(one.remaining, 0.0));
}

QTEST_GUILESS_MAIN(TrackingErrorTest)
#include "tst_TrackingError.moc"
