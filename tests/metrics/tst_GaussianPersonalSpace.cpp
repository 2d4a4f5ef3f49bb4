#include <cmath>

#include <QtTest>

#include "metrics/MapFields.h"

using base::Vec2;
using metrics::GaussianPersonalSpace;
using metrics::personalSpaceOf;

class GaussianPersonalSpaceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// By hand: 1.2 m/s gives Vf = 2.4, Vr = 1.2, Vs = 1.6 m²; at 1 m ahead exp(-1/4.8) = 0.811936,
  /// behind exp(-1/2.4) = 0.659241, beside exp(-1/3.2) = 0.731616.
  void value_byHand_isTheSame() {
    const GaussianPersonalSpace walking = personalSpaceOf(1.2);
    QVERIFY(std::abs(std::exp(-walking.outsideness({1.0, 0.0})) - 0.811936) < 1e-6);
    QVERIFY(std::abs(std::exp(-walking.outsideness({-1.0, 0.0})) - 0.659241) < 1e-6);
    QVERIFY(std::abs(std::exp(-walking.outsideness({0.0, -1.0})) - 0.731616) < 1e-6);
    const GaussianPersonalSpace standing = personalSpaceOf(0.1);  // Vf = 0.5
    QVERIFY(std::abs(std::exp(-standing.outsideness({1.0, 0.0})) - 0.367879) < 1e-6);
  }

  void contour_everyCorner_hasTheLevel() {
    const GaussianPersonalSpace space = personalSpaceOf(0.9);
    const base::Pose2 person{{2.0, -1.0}, 2.2};
    for (const double level : {0.2, 0.5, 0.8}) {
      for (const Vec2& corner : metrics::personalSpaceContour(space, person, level)) {
        const double value = std::exp(-space.outsideness(person.toLocal(corner)));
        QVERIFY(std::abs(value - level) < 1e-12);
      }
    }
  }

  /// At exp(-1/2) the contour is one standard deviation away: sqrt(2 * 0.5) = 1 m ahead,
  /// sqrt(0.5) = 0.7071 m behind.
  void contour_oneDeviation_isWhereTheRootsSay() {
    const auto contour =
        metrics::personalSpaceContour(personalSpaceOf(0.5), {{0.0, 0.0}, 0.0}, std::exp(-0.5), 4);
    QVERIFY((contour[0] - Vec2(1.0, 0.0)).norm() < 1e-12);
    QVERIFY((contour[1] - Vec2(0.0, std::sqrt(2.0 / 3.0))).norm() < 1e-12);
    QVERIFY((contour[2] - Vec2(-std::sqrt(0.5), 0.0)).norm() < 1e-12);
  }
};

QTEST_APPLESS_MAIN(GaussianPersonalSpaceTest)
#include "tst_GaussianPersonalSpace.moc"
