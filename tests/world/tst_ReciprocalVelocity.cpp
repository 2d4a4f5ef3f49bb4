#include <cmath>

#include <QtTest>

#include "sim2d/nav/ReciprocalVelocity.h"
#include "sim2d/world/realism/RealismTest.h"

using namespace sim2d;

namespace {

bool isNear(const Vec2& a, const Vec2& b, double tolerance = 1e-9) {
  return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

HalfPlane below(double y) {  // velocities with v_y <= y
  return {Vec2(0.0, y), Vec2(-1.0, 0.0)};
}
HalfPlane above(double y) {
  return {Vec2(0.0, y), Vec2(1.0, 0.0)};
}
HalfPlane leftOf(double x) {  // v_x <= x
  return {Vec2(x, 0.0), Vec2(0.0, 1.0)};
}

Walker walker(int id, const Vec2& position, const Vec2& velocity) {
  return {id, position, velocity, 0.5};
}

}  // namespace

class ReciprocalVelocityTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void nearestAllowed_corner_isFound() {
    QVERIFY(isNear(nearestFeasibleVelocity({below(0.3), leftOf(0.4)}, 0, Vec2(1.0, 1.0), 2.0),
                   Vec2(0.4, 0.3)));
  }

  void nearestAllowed_nothingInTheWay_isTheWantedVelocity() {
    QVERIFY(isNear(nearestFeasibleVelocity({below(0.3)}, 0, Vec2(1.0, 0.2), 2.0), Vec2(1.0, 0.2)));
    QVERIFY(isNear(nearestFeasibleVelocity({}, 0, Vec2(-1.0, 0.2), 2.0), Vec2(-1.0, 0.2)));
  }

  void nearestAllowed_fasterThanAllowed_isCut() {
    QVERIFY(isNear(nearestFeasibleVelocity({}, 0, Vec2(3.0, 4.0), 1.0), Vec2(0.6, 0.8)));
    QVERIFY(isNear(nearestFeasibleVelocity({below(0.6)}, 0, Vec2(0.0, 4.0), 1.0), Vec2(0.0, 0.6)));
  }

  void nearestAllowed_contradiction_isSharedEvenly() {
    const Vec2 found = nearestFeasibleVelocity({below(-0.3), above(0.5)}, 0, Vec2(0.2, 0.0), 2.0);
    QVERIFY(std::fabs(found.y() - 0.1) < 1e-9);
  }

  void nearestAllowed_contradiction_keepsWalls() {
    const Vec2 found = nearestFeasibleVelocity({below(-0.3), above(0.5)}, 1, Vec2(0.2, 0.0), 2.0);
    QVERIFY(found.y() <= -0.3 + 1e-9);
  }

  /// Against trying all velocities of a fine lattice.
  void nearestAllowed_manyPlanes_isAsNearAsASearchFinds() {
    for (int example = 0; example < 40; ++example) {
      std::vector<HalfPlane> planes;
      for (int k = 0; k < 5; ++k) {
        const double angle = 1.7 * example + 2.3 * k;
        const Vec2 direction(std::cos(angle), std::sin(angle));
        planes.push_back({Vec2(-0.4 * -direction.y(), -0.4 * direction.x()), direction});
      }
      const Vec2 wanted = 1.3 * Vec2(std::cos(0.9 * example), std::sin(0.9 * example));
      const Vec2 found = nearestFeasibleVelocity(planes, 0, wanted, 1.3);
      for (const HalfPlane& plane : planes) {
        QVERIFY(plane.violation(found) <= 1e-9);
      }
      double best = 1e9;
      for (int i = -130; i <= 130; ++i) {
        for (int k = -130; k <= 130; ++k) {
          const Vec2 tried(0.01 * i, 0.01 * k);
          bool isAllowed = tried.norm() <= 1.3;
          for (const HalfPlane& plane : planes) {
            isAllowed = isAllowed && plane.violation(tried) <= 0.0;
          }
          best = isAllowed ? std::min(best, (tried - wanted).norm()) : best;
        }
      }
      QVERIFY((found - wanted).norm() <= best + 1e-9);
      QVERIFY((found - wanted).norm() >= best - 0.015);
    }
  }

  /// At rest, 3 m apart, horizon 2 s: contact needs 1 m/s of closing speed; there is room.
  void avoidBody_behindTheDisc_takesHalf() {
    const HalfPlane plane = bodyHalfPlane(walker(1, Vec2::Zero(), Vec2::Zero()),
                                          walker(2, Vec2(3.0, 0.0), Vec2::Zero()), 2.0, 0.05);
    QVERIFY(std::fabs(plane.violation(Vec2(0.5, 0.0))) < 1e-9);
    QVERIFY(plane.violation(Vec2(0.51, 0.0)) > 0.0 && plane.violation(Vec2(0.49, 0.0)) < 0.0);
  }

  /// Other 2 m ahead and reach 1 m: the legs of the cone rise at 30 degrees.
  void avoidBody_sideways_touchesTheCone() {
    const Vec2 velocity(2.0, 0.5);
    const HalfPlane plane = bodyHalfPlane(walker(1, Vec2::Zero(), velocity),
                                          walker(2, Vec2(2.0, 0.0), Vec2::Zero()), 2.0, 0.05, 1.0);
    const Vec2 leg(std::sqrt(0.75), 0.5);
    QVERIFY(isNear(plane.direction, leg, 1e-12));
    QVERIFY(std::fabs(plane.violation(Vec2::Zero())) < 1e-12);
    QVERIFY(plane.violation(velocity) > 0.0);
  }

  void avoidBody_bothGiveWay_missEachOther() {
    const Walker first = walker(1, Vec2::Zero(), Vec2(1.0, 0.05));
    const Walker second = walker(2, Vec2(3.0, 0.0), Vec2(-1.0, -0.05));
    const Vec2 mine =
        nearestFeasibleVelocity({bodyHalfPlane(first, second, 2.0, 0.05)}, 0, first.velocity, 2.0);
    const Vec2 others =
        nearestFeasibleVelocity({bodyHalfPlane(second, first, 2.0, 0.05)}, 0, second.velocity, 2.0);
    double least = 1e9;
    for (int i = 0; i <= 200; ++i) {
      const Vec2 apart = second.position - first.position + 0.01 * i * (others - mine);
      least = std::min(least, apart.norm());
    }
    QVERIFY(least >= 1.0 - 1e-9 && least < 1.1);
  }

  void avoidBody_overlap_parts() {
    const Walker first = walker(1, Vec2::Zero(), Vec2::Zero());
    const Walker second = walker(2, Vec2(0.9, 0.0), Vec2::Zero());
    const HalfPlane plane = bodyHalfPlane(first, second, 2.0, 0.05);
    QVERIFY(plane.violation(Vec2::Zero()) > 0.0);
    QVERIFY(plane.violation(Vec2(-1.0, 0.0)) <= 1e-9);  // half of 0.1 m in 0.05 s
  }

  void avoidPoint_wall_limitsTheSpeedTowardsIt() {
    const Walker self = walker(1, Vec2::Zero(), Vec2::Zero());
    const HalfPlane outside = pointHalfPlane(self, {Vec2(0.0, 0.8), 0.8, false, 0}, 1.0, 0.05);
    QVERIFY(std::fabs(outside.violation(Vec2(2.0, 0.3))) < 1e-12);
    QVERIFY(outside.violation(Vec2(0.0, 0.31)) > 0.0);
    const HalfPlane inside = pointHalfPlane(self, {Vec2(0.0, 0.8), 0.8, true, 0}, 1.0, 0.05);
    QVERIFY(inside.violation(Vec2::Zero()) > 0.0 && inside.violation(Vec2(0.0, 0.5)) <= 1e-9);
  }

  void orca_pairAndCircle_keepApart_data() {
    QTest::addColumn<int>("count");
    QTest::newRow("head on") << 2;
    QTest::newRow("circle of 8") << 8;
  }

  void orca_pairAndCircle_keepApart() {
    QFETCH(int, count);
    RealismRun run;
    run.model = "orca";
    const Meeting meeting = circle(run, count, 4.0);
    QVERIFY2(meeting.leastDistance >= 0.395, qPrintable(QString::number(meeting.leastDistance)));
    QVERIFY2(meeting.timeRatio < 2.5, qPrintable(QString::number(meeting.timeRatio)));
  }
};

QTEST_APPLESS_MAIN(ReciprocalVelocityTest)
#include "tst_ReciprocalVelocity.moc"
