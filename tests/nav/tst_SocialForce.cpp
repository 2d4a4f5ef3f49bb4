#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/nav/SocialForce.h"

using namespace sim2d;

namespace {

constexpr double kRounding = 1e-6;  // the reference numbers have six decimals

/// Parameters of the reference values: no side preference.
ForceParameters plain() {
  ForceParameters parameters;
  parameters.epsilon = 0.0;
  return parameters;
}

Walker walker(int id, const Vec2& position, const Vec2& velocity) {
  return {id, position, velocity, 0.4};
}

bool isNear(const Vec2& a, const Vec2& b, double tolerance = kRounding) {
  return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

Obstacles::Point point(const Vec2& position) {
  Obstacles::Point result;
  result.position = position;
  return result;
}

/// The explicit step of the model: new velocity first, limited to the desired speed.
void advance(Walker& self, const Vec2& force, double limit, double dt) {
  self.velocity += force * dt;
  if (self.velocity.norm() > limit) {
    self.velocity *= limit / self.velocity.norm();
  }
  self.position += self.velocity * dt;
}

}  // namespace

class SocialForceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void goalForce_referenceValues_data() {
    QTest::addColumn<double>("vx");
    QTest::addColumn<double>("vy");
    QTest::addColumn<bool>("hasGoal");
    QTest::addColumn<double>("fx");
    QTest::addColumn<double>("fy");
    QTest::newRow("from rest") << 0.0 << 0.0 << true << 6.0 << 0.0;
    QTest::newRow("walking") << 0.5 << 0.2 << true << 4.0 << -0.8;
    QTest::newRow("no goal") << 0.5 << 0.2 << false << -1.0 << -0.4;
  }

  void goalForce_referenceValues() {
    QFETCH(double, vx);
    QFETCH(double, vy);
    QFETCH(bool, hasGoal);
    QFETCH(double, fx);
    QFETCH(double, fy);
    const Vec2 direction = hasGoal ? Vec2(1.0, 0.0) : Vec2(Vec2::Zero());
    QVERIFY(isNear(goalForce(plain(), Vec2(vx, vy), direction, 1.5), Vec2(fx, fy), 1e-12));
  }

  void meanGoalForce_longTime_followsTheExponential() {
    const Vec2 way(1.0, 0.0);
    const Vec2 slow(0.2, 0.1);
    const Vec2 none = Vec2::Zero();
    // One sub-step: the force itself.
    QVERIFY(meanGoalForce(plain(), slow, way, 1.5, Vec2(3.0, 0.0), 0.05) ==
            goalForce(plain(), slow, way, 1.5));
    // dv/dt = 4 (1.5 - v) from rest: v(0.5 s) = 1.5 (1 - e^-2) = 1.297.
    const Vec2 gained = 0.5 * meanGoalForce(plain(), none, way, 1.5, none, 0.5);
    QVERIFY(std::fabs(gained.x() - 1.297) < 0.05);
    // dv/dt = 4 (1.5 - v) - 6: nothing moves.
    QVERIFY(isNear(meanGoalForce(plain(), none, way, 1.5, Vec2(-6.0, 0.0), 0.5), Vec2(6.0, 0.0)));
    ForceParameters stiff = plain();
    stiff.goalFactor = 10.0;
    const Vec2 atOnce = 0.1 * meanGoalForce(stiff, none, way, 1.5, none, 0.1);
    QVERIFY(atOnce.x() > 1.2 && atOnce.x() < 1.5);  // the plain step would reach 3 m/s
  }

  void obstacleForce_referenceValues() {
    const Walker self = walker(1, Vec2::Zero(), Vec2::Zero());
    QVERIFY(isNear(obstacleForce(plain(), self, {point({1.0, 0.0})}), Vec2(-0.497871, 0.0)));
    QVERIFY(isNear(obstacleForce(plain(), self, {point({0.3, 0.4}), point({-0.6, 0.0})}),
                   Vec2(0.039610, -4.852245)));
    QVERIFY(obstacleForce(plain(), self, {point({0.0, 0.0})}).isZero(0.0));
  }

  void obstacleForce_insideObstacle_leadsOut() {
    Obstacles::Point boundary = point({0.5, 0.0});
    boundary.inside = true;
    QVERIFY(obstacleForce(plain(), walker(1, Vec2::Zero(), Vec2::Zero()), {boundary}).x() > 0.0);
  }

  void socialForce_referenceValues_data() {
    QTest::addColumn<QVector<double>>("motion");  // own velocity, other's position and velocity
    QTest::addColumn<double>("fx");
    QTest::addColumn<double>("fy");
    using Motion = QVector<double>;
    QTest::newRow("head on, offset") << Motion{1, 0, 3, 0.5, -1, 0} << -0.518734 << -0.725410;
    QTest::newRow("exactly head on") << Motion{1, 0, 3, 0, -1, 0} << -0.900462 << 0.0;
    QTest::newRow("at rest") << Motion{0, 0, 1, 0, 0, 0} << -0.287163 << 0.0;
    QTest::newRow("crossing") << Motion{1, 0, 2, 1, 0, -1} << -0.689317 << 0.231068;
  }

  void socialForce_referenceValues() {
    QFETCH(QVector<double>, motion);
    QFETCH(double, fx);
    QFETCH(double, fy);
    const Walker self = walker(1, Vec2::Zero(), Vec2(motion[0], motion[1]));
    const Walker other = walker(2, Vec2(motion[2], motion[3]), Vec2(motion[4], motion[5]));
    QVERIFY(isNear(socialForce(plain(), self, other), Vec2(fx, fy)));
  }

  void socialForce_headOn_withSidePreference() {
    const Walker self = walker(1, Vec2::Zero(), Vec2(1.0, 0.0));
    const Walker other = walker(2, Vec2(3.0, 0.0), Vec2(-1.0, 0.0));
    const Vec2 force = socialForce(ForceParameters{}, self, other);
    QVERIFY(isNear(force, Vec2(-0.898563, -0.899617)));
    QVERIFY(isNear(socialForce(ForceParameters{}, other, self), Vec2(-force)));  // both give way
  }

  void socialForce_vanishingInteraction_isZero() {
    const Walker self = walker(1, Vec2::Zero(), Vec2(0.5, 0.0));
    const Walker other = walker(2, Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    QVERIFY(socialForce(plain(), self, other).isZero(0.0));
    QVERIFY(socialForce(ForceParameters{}, self, other).isZero(0.0));
  }

  void socialForce_inOnePlace_partsThem() {
    const Walker self = walker(3, Vec2(1.0, 1.0), Vec2::Zero());
    const Walker other = walker(8, Vec2(1.0, 1.0), Vec2::Zero());
    const Vec2 force = socialForce(plain(), self, other);
    QVERIFY(force.allFinite() && force.norm() > 1.0);
    QVERIFY(isNear(socialForce(plain(), other, self), Vec2(-force)));
  }

  void socialForce_equalParameters_isAntisymmetric() {
    for (int i = 0; i < 50; ++i) {
      const double t = 0.37 * i;
      const Walker self = walker(1, Vec2::Zero(), Vec2(std::cos(t), std::sin(2.0 * t)));
      const Walker other = walker(2, Vec2(2.0 + std::sin(t), 1.5 * std::cos(3.0 * t)),
                                  Vec2(std::sin(t), -std::cos(t)));
      const Vec2 sum = socialForce(plain(), self, other) + socialForce(plain(), other, self);
      QVERIFY(sum.norm() < 1e-12);
    }
  }

  void isNegligible_pairs_neverDropsAboveTheBound() {
    int dropped = 0;
    for (int i = 0; i < 4000; ++i) {
      const double t = 0.731 * i;
      const Walker self = walker(1, Vec2::Zero(), 1.4 * Vec2(std::cos(t), std::sin(t)));
      const double far = 0.5 + std::fmod(1.37 * i, 25.0);
      const Walker other = walker(2, far * Vec2(std::cos(5.0 * t), std::sin(5.0 * t)),
                                  1.2 * Vec2(std::cos(3.1 * t), std::sin(3.1 * t)));
      const Vec2 force = socialForce(plain(), self, other);
      if (isNegligible(plain(), self, other, cutOff(1e-4))) {
        ++dropped;
        QVERIFY(force.norm() <= std::sqrt(2.0) * 1e-4 * plain().socialFactor);
      }
      if (far > socialRange(plain(), 1.4, 1.2, cutOff(1e-4))) {
        QVERIFY(isNegligible(plain(), self, other, cutOff(1e-4)));
      }
    }
    QVERIFY(dropped > 1000 && dropped < 4000);
  }

  void isWeaker_sidePreference_neverDropsAboveTheForce() {
    constexpr double kForce = 1e-6;
    ForceParameters parameters;
    parameters.epsilon = 0.3;
    const double cut = cutOffOfForce(parameters, kForce);
    int dropped = 0;
    for (int i = 0; i < 20000; ++i) {
      const double t = 0.731 * i;
      const Walker self = walker(1, Vec2::Zero(), 1.4 * Vec2(std::cos(t), std::sin(t)));
      const double far = 0.5 + std::fmod(1.37 * i, 25.0);
      const Walker other = walker(2, far * Vec2(std::cos(5.0 * t), std::sin(5.0 * t)),
                                  1.2 * Vec2(std::cos(3.1 * t), std::sin(3.1 * t)));
      if (isWeaker(parameters, self, other, cut)) {
        ++dropped;
        QVERIFY(socialForce(parameters, self, other).norm() < kForce);
      }
    }
    QVERIFY(dropped > 1000);
  }

  void groupForce_twoMembers_referenceValues() {
    const Walker self = walker(1, Vec2::Zero(), Vec2(1.0, 0.0));
    const Walker other = walker(2, Vec2(-2.0, 1.0), Vec2(0.8, 0.0));
    const Vec2 direction(1.0, 0.0);
    const Vec2 goal = goalForce(plain(), self.velocity, direction, 1.5);
    const Vec2 social = socialForce(plain(), self, other);
    const GroupForce group = groupForce(plain(), self, direction, {other});
    QVERIFY(isNear(goal, Vec2(2.0, 0.0)));
    QVERIFY(isNear(social, Vec2(0.000474, 0.000029)));
    QVERIFY(isNear(group.gaze, Vec2(-6.0, 0.0)));
    QVERIFY(isNear(group.coherence, Vec2(-1.549758, 0.774879)));
    QVERIFY(group.repulsion.isZero(0.0));
    QVERIFY(isNear(goal + social + group.sum(), Vec2(-5.549284, 0.774907)));
  }

  void groupForce_threeMembers_referenceValues() {
    const Walker self = walker(1, Vec2::Zero(), Vec2(1.0, 0.0));
    const Walker second = walker(2, Vec2(0.5, 0.3), Vec2(0.8, 0.0));
    const Walker third = walker(3, Vec2(0.2, -1.5), Vec2(1.0, 0.0));
    const Vec2 direction(1.0, 0.0);
    const Vec2 social = socialForce(plain(), self, second) + socialForce(plain(), self, third);
    const GroupForce group = groupForce(plain(), self, direction, {second, third});
    QVERIFY(isNear(social, Vec2(-0.760105, -1.794017)));
    QVERIFY(group.gaze.isZero(0.0));
    QVERIFY(isNear(group.coherence, Vec2(0.118848, -0.203739)));
    QVERIFY(isNear(group.repulsion, Vec2(-0.5, -0.3)));
    const Vec2 total = goalForce(plain(), self.velocity, direction, 1.5) + social + group.sum();
    QVERIFY(isNear(total, Vec2(0.858743, -2.297757)));
  }

  void groupForce_exactlyBehindOrNoGoal_isFinite() {
    const Walker self = walker(1, Vec2::Zero(), Vec2(0.3, 0.1));
    const Walker behind = walker(2, Vec2(-3.0, 0.0), Vec2::Zero());
    QVERIFY(isNear(groupForce(plain(), self, Vec2(1.0, 0.0), {behind}).gaze, Vec2(-9.0, 0.0)));
    QVERIFY(groupForce(plain(), self, Vec2::Zero(), {behind}).gaze.isZero(0.0));
    QVERIFY(groupForce(plain(), self, Vec2(1.0, 0.0), {}).sum().isZero(0.0));
  }

  void walk_toTheGoal_takesTheReferenceTime_data() {
    QTest::addColumn<double>("goalFactor");
    QTest::addColumn<double>("dt");
    QTest::addColumn<double>("xAfterOneSecond");
    QTest::addColumn<double>("reached");
    QTest::newRow("k_g 2") << 2.0 << 0.05 << 1.203459 << 6.70;
    QTest::newRow("k_g 10") << 10.0 << 0.05 << 1.5 << 6.50;
    QTest::newRow("k_g 2, dt 0.01") << 2.0 << 0.01 << 0.0 << 6.71;
  }

  void walk_toTheGoal_takesTheReferenceTime() {
    QFETCH(double, goalFactor);
    QFETCH(double, dt);
    QFETCH(double, xAfterOneSecond);
    QFETCH(double, reached);
    ForceParameters parameters = plain();
    parameters.goalFactor = goalFactor;
    Walker self = walker(1, Vec2::Zero(), Vec2::Zero());
    int steps = 0;
    while (10.0 - self.position.x() > 0.3) {
      advance(self, goalForce(parameters, self.velocity, Vec2(1.0, 0.0), 1.5), 1.5, dt);
      ++steps;
      if (xAfterOneSecond > 0.0 && steps == 20) {
        QVERIFY(std::fabs(self.position.x() - xAfterOneSecond) < kRounding);
      }
    }
    QVERIFY(std::fabs(steps * dt - reached) < 1e-9);
  }

  void walk_straightIntoAPoint_standsInEquilibrium() {
    Walker self = walker(1, Vec2::Zero(), Vec2::Zero());
    for (int i = 0; i < 2000; ++i) {
      const Vec2 force = goalForce(plain(), self.velocity, Vec2(1.0, 0.0), 1.5) +
                         obstacleForce(plain(), self, {point({5.0, 0.0})});
      advance(self, force, 1.5, 0.05);
    }
    QVERIFY(std::fabs(self.position.x() - 4.497835) < kRounding);
  }

  void walk_headOnWithOffset_passesAtReferenceDistance() {
    Walker first = walker(1, Vec2(-4.0, 0.0), Vec2::Zero());
    Walker second = walker(2, Vec2(4.0, 0.2), Vec2::Zero());
    const Vec2 firstGoal(4.0, 0.0);
    const Vec2 secondGoal(-4.0, 0.2);
    double least = 1e9;
    for (int i = 0; i < 200; ++i) {
      const Vec2 onFirst =
          goalForce(plain(), first.velocity, (firstGoal - first.position).normalized(), 1.5) +
          socialForce(plain(), first, second);
      const Vec2 onSecond =
          goalForce(plain(), second.velocity, (secondGoal - second.position).normalized(), 1.5) +
          socialForce(plain(), second, first);
      advance(first, onFirst, 1.5, 0.05);
      advance(second, onSecond, 1.5, 0.05);
      least = std::min(least, (first.position - second.position).norm());
    }
    QVERIFY(std::fabs(least - 0.537917) < kRounding);
  }
};

QTEST_APPLESS_MAIN(SocialForceTest)
#include "tst_SocialForce.moc"
