#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/nav/DriveKinematics.h"
#include "sim2d/nav/RobotRoute.h"

using namespace sim2d;

namespace {

RobotBody bodyOf(Kinematics kinematics) {
  RobotBody body;
  body.kinematics = kinematics;
  body.limits = {1.0, 0.5, 1.0, 1.5, 3.0, kinematics == Kinematics::Ackermann ? 0.8 : 0.0};
  return body;
}

/// The shortest way that a search over turns finds, forwards only: first arc (left, right or
/// straight), then second arc or line, to within `near` of the point.
double searchedLength(const Vec2& point, double radius) {
  const double fine = 0.01;  // [rad]
  double best = 1e9;
  for (const double side : {1.0, -1.0}) {
    for (int n = 0; n * fine < 2.0 * base::kPi; ++n) {
      const double first = n * fine;
      const Vec2 centre(0.0, side * radius);
      const double heading = side * first;
      const Vec2 place = centre + radius * Vec2(std::sin(first), -side * std::cos(first));
      // A line from there.
      const Vec2 way(std::cos(heading), std::sin(heading));
      const Vec2 to = point - place;
      if (way.dot(to) >= 0.0 &&
          std::fabs(base::cross(way, to)) < 0.012 * std::max(1.0, to.norm())) {
        best = std::min(best, radius * first + to.norm());
      }
      // An arc to the other side.
      const Vec2 other = place + side * radius * Vec2(way.y(), -way.x());
      if (std::fabs((point - other).norm() - radius) < 0.008 * radius) {
        const Vec2 a = place - other;
        const Vec2 b = point - other;
        double turn = -side * std::atan2(base::cross(a, b), a.dot(b));
        turn += turn < 0.0 ? 2.0 * base::kPi : 0.0;
        best = std::min(best, radius * (first + turn));
      }
    }
  }
  return best;
}

}  // namespace

class RolloutTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void sampleEvenly_acrossZero_holdsZero() {
    std::vector<double> samples;
    sampleEvenly(0.5, 1.5, 5, samples);
    QVERIFY(samples == (std::vector<double>{0.5, 0.75, 1.0, 1.25, 1.5}));
    sampleEvenly(-0.75, 0.75, 20, samples);
    QCOMPARE(samples.size(), std::size_t{20});
    QCOMPARE(std::count(samples.begin(), samples.end(), 0.0), std::ptrdiff_t{1});
    QCOMPARE(samples.front(), -0.75);
    QCOMPARE(samples.back(), 0.75);
    sampleEvenly(0.2, 0.4, 1, samples);
    QVERIFY(samples.size() == 1 && std::fabs(samples.front() - 0.3) < 1e-12);
  }

  void sampleCounts_omnidirectional_sharesThemOut() {
    const SampleCounts omni = sampleCounts(Kinematics::Omnidirectional, 20, 20);
    QVERIFY(omni.linear == 7 && omni.angular == 7 && omni.lateral == 7);  // 343 <= 400 < 512
    const SampleCounts plain = sampleCounts(Kinematics::Differential, 20, 20);
    QVERIFY(plain.linear == 20 && plain.angular == 20 && plain.lateral == 1);
    std::vector<BodyTwist> twists;
    TwistSampler(bodyOf(Kinematics::Differential), plain).sample({0.0, 1.0, -1.0, 1.0}, twists);
    QCOMPARE(twists.size(), std::size_t{400});
  }

  void sample_ackermann_isFeasible() {
    const RobotBody body = bodyOf(Kinematics::Ackermann);
    std::vector<BodyTwist> twists;
    TwistSampler(body, {9, 9, 1}).sample({-0.2, 0.4, -1.2, 1.2}, twists);
    QCOMPARE(twists.size(), std::size_t{81});
    double tightest = 0.0;
    for (const BodyTwist& twist : twists) {
      QVERIFY(clampedToLimits(body, twist) == twist);
      QVERIFY(std::fabs(twist.angular) * 0.8 <= std::fabs(twist.linear) + 1e-12);
      tightest = std::max(tightest, twist.angular);
    }
    QVERIFY(std::fabs(tightest - 0.5) < 1e-12);  // 0.4 m/s on the least circle
  }

  void rollOut_constantTwist_isTheCircle() {
    const BodyTwist twist{0.8, 0.5};
    std::vector<Pose2> poses(21);
    rollOut(bodyOf(Kinematics::Differential), {Vec2(1.0, 2.0), 0.3}, twist, twist, 0.1, poses);
    const double radius = 1.6;
    for (int i = 0; i <= 20; ++i) {
      const double heading = 0.3 + 0.05 * i;
      const Vec2 expected = Vec2(1.0, 2.0) + radius * Vec2(std::sin(heading) - std::sin(0.3),
                                                           std::cos(0.3) - std::cos(heading));
      const Pose2& pose = poses[static_cast<std::size_t>(i)];
      QVERIFY((pose.position - expected).norm() < 1e-9);
      QVERIFY(std::fabs(pose.heading - heading) < 1e-9);
    }
  }

  void rollOut_gettingFast_isTheIntegral() {
    std::vector<Pose2> poses(21);
    // 0.2 to 0.5 m/s at 1 m/s²: 0.3, 0.4, 0.5 m/s in the first steps, then 17 at 0.5.
    rollOut(bodyOf(Kinematics::Differential), {}, {0.2, 0.0}, {0.5, 0.0}, 0.1, poses);
    QVERIFY(std::fabs(poses[3].position.x() - 0.12) < 1e-9);
    QVERIFY(std::fabs(poses[20].position.x() - (0.12 + 17 * 0.05)) < 1e-9);
  }

  void rollOut_sideways_isTurnedIntoTheWorld() {
    std::vector<Pose2> poses(11);
    const BodyTwist twist{0.0, 0.0, 0.4};
    rollOut(bodyOf(Kinematics::Omnidirectional), {Vec2::Zero(), 0.5 * base::kPi}, twist, twist, 0.1,
            poses);
    QVERIFY((poses.back().position - Vec2(-0.4, 0.0)).norm() < 1e-9);
  }

  void relaxedDubins_knownWays_areExact() {
    QVERIFY(std::fabs(relaxedDubinsLength(3.0, 0.0, 0.8) - 3.0) < 1e-9);
    // Half of the circle, a quarter and then straight on; the same to the right.
    QVERIFY(std::fabs(relaxedDubinsLength(1.6, 0.5 * base::kPi, 0.8) - 0.8 * base::kPi) < 1e-6);
    const double corner = std::sqrt(0.8 * 0.8 + 2.8 * 2.8);
    const double bearing = std::atan2(2.8, 0.8);
    QVERIFY(std::fabs(relaxedDubinsLength(corner, bearing, 0.8) - (0.4 * base::kPi + 2.0)) < 1e-6);
    QVERIFY(std::fabs(relaxedDubinsLength(corner, -bearing, 0.8) - (0.4 * base::kPi + 2.0)) < 1e-6);
    // The middle of the left circle: by triangles of sides 2r, r and 2r, in degrees 28.955 to the
    // right and then 360 - 75.522 to the left.
    const double degrees = 28.955 + 360.0 - 75.522;
    QVERIFY(std::fabs(relaxedDubinsLength(1.0, 0.5 * base::kPi, 1.0) -
                      degrees * base::kPi / 180.0) < 1e-4);
  }

  void relaxedDubins_anyPoint_isWhatASearchFinds() {
    for (int i = 0; i < 60; ++i) {
      const double angle = 0.83 * i;
      const double distance = 0.15 + 0.06 * i;
      const Vec2 point = distance * Vec2(std::cos(angle), std::sin(angle));
      if (std::fabs(std::hypot(point.x(), std::fabs(point.y()) - 0.8) - 0.8) < 0.05) {
        continue;  // on the turning circle, where the length jumps
      }
      const double found = searchedLength(point, 0.8);
      const double length = relaxedDubinsLength(distance, base::wrapToPi(angle), 0.8);
      // The search ends near the point, a little early or late.
      QVERIFY2(std::fabs(length - found) < 0.12,
               qPrintable(QStringLiteral("%1: %2, searched %3").arg(i).arg(length).arg(found)));
    }
  }

  void stuckWatch_noProgress_movesOffAndNarrows() {
    StuckDetector watch(4.0, 0.4);
    const Vec2 goal(5.0, 0.0);
    double time = 0.0;
    const auto drive = [&](double seconds, const Vec2& place, double from, double speed) {
      for (int i = 0; i < static_cast<int>(std::lround(seconds / 0.1)); ++i) {
        time += 0.1;
        watch.update(time, place, goal, from - speed * 0.1 * i);
      }
    };
    drive(10.0, Vec2::Zero(), 10.0, 0.2);  // slow, but gets on
    QVERIFY(!watch.isRecovering() && watch.tries() == 0 && watch.marginScale() == 1.0);
    drive(4.5, Vec2::Zero(), 8.0, 0.0);
    QVERIFY(watch.isRecovering() && watch.tries() == 1 && watch.marginScale() == 0.5);
    drive(0.1, Vec2(-0.41, 0.0), 8.4, 0.0);
    QVERIFY(!watch.isRecovering());
    drive(4.5, Vec2::Zero(), 8.0, 0.0);
    QVERIFY(watch.isRecovering() && watch.tries() == 2 && watch.marginScale() == 0.25);
    drive(2.2, Vec2::Zero(), 8.0, 0.0);  // cannot move either
    QVERIFY(!watch.isRecovering());
    drive(3.0, Vec2::Zero(), 8.0, 0.3);
    QVERIFY(watch.tries() == 0 && watch.marginScale() == 1.0);
    drive(4.5, Vec2::Zero(), 7.0, 0.0);
    watch.update(time + 0.1, Vec2::Zero(), Vec2(0.0, 3.0), 3.0);  // another goal
    QVERIFY(!watch.isRecovering() && watch.tries() == 0);
  }
};

QTEST_GUILESS_MAIN(RolloutTest)
#include "tst_Rollout.moc"
