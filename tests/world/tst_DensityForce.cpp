#include <cmath>
#include <limits>

#include <QtTest>

#include "sim2d/world/DensityForce.h"

using namespace sim2d;

namespace {

constexpr double kRounding = 1e-5;
constexpr double kDt = 0.05;

DensityParameters standard() {
  DensityParameters parameters;
  parameters.social.epsilon = 0.01;
  return parameters;
}

Pedestrian pedestrian(int id, const Vec2& position, const Vec2& velocity, const Vec2& goal) {
  Pedestrian who;
  who.body = {id, position, velocity, 0.2};
  who.desired.direction = goal;
  who.desired.heading = goal.isZero(0.0) ? Vec2(1.0, 0.0) : goal;
  who.desired.desiredSpeed = 1.3;
  return who;
}

/// The velocity after one step of the model, with the limit of speed and the guard.
Vec2 stepped(const DensityParameters& parameters, const Pedestrian& self,
             const std::vector<Pedestrian>& others,
             const std::vector<Obstacles::Point>& points = {},
             const std::vector<Walker>& mates = {}) {
  const DensityForce force = densityForce(parameters, self, others);
  const Vec2 group = groupForce(parameters.social, self.body, self.desired.direction, mates).sum();
  const Vec2 sum = force.goal + force.social + force.lane + group +
                   limitedObstacleForce(parameters, self, points);
  Vec2 velocity = self.body.velocity + sum * kDt;
  if (velocity.norm() > self.desired.desiredSpeed) {
    velocity *= self.desired.desiredSpeed / velocity.norm();
  }
  return avoidContacts(parameters, self, others, points, velocity, kDt);
}

bool isNear(const Vec2& a, const Vec2& b, double tolerance = kRounding) {
  return (a - b).cwiseAbs().maxCoeff() <= tolerance;
}

}  // namespace

using Numbers = QVector<double>;

class DensityForceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void densityForce_referenceValues_data() {
    QTest::addColumn<Numbers>("own");     // velocity
    QTest::addColumn<Numbers>("others");  // position, velocity, goal direction of each
    QTest::addColumn<double>("cap");
    QTest::addColumn<Numbers>("expected");  // goal, social, lane, velocity after the step
    QTest::newRow("alone") << Numbers{0.5, 0.2} << Numbers{} << 1.3
                           << Numbers{3.2, -0.8, 0, 0, 0, 0, 0.66, 0.16};
    QTest::newRow("slower one ahead")
        << Numbers{1, 0} << Numbers{1, 0, 0.5, 0, 1, 0} << 0.666667
        << Numbers{-1.333333, 0, -0.386423, -0.386447, 0, 0, 0.914012, -0.019322};
    QTest::newRow("slower one ahead on the left")
        << Numbers{1, 0} << Numbers{1, 0.3, 0.5, 0, 1, 0} << 1.3
        << Numbers{1.2, 0, -0.271650, -0.397008, 0, 0, 1.046417, -0.019850};
    QTest::newRow("head on") << Numbers{1.3, 0} << Numbers{3, 0, -1.3, 0, -1, 0} << 1.3
                             << Numbers{0, 0, -1.229974, -1.243686, 0, 0, 1.238501, -0.062184};
    QTest::newRow("crossing") << Numbers{1.3, 0} << Numbers{1.5, -0.2, 0, 1.3, 0, 1} << 1.3
                              << Numbers{0, 0, -0.070343, -0.087156, 0, 0, 1.296483, -0.004358};
    QTest::newRow("standing, without a goal")
        << Numbers{1.3, 0} << Numbers{1.2, 0, 0, 0, 0, 0} << 0.888889
        << Numbers{-1.644444, 0, -1.924735, -1.927163, 0, 0, 1.121541, -0.096358};
    QTest::newRow("nearly touching, gives way")
        << Numbers{0.6, 0} << Numbers{0.41, 0, 0, 0, 1, 0} << 0.011111
        << Numbers{-2.355556, 0, -1.264267, -1.264376, 0, 0, -0.1, -0.063219};
    QTest::newRow("one comes, one goes the same way")
        << Numbers{1, 0} << Numbers{2, 0.4, -1, 0, -1, 0, 1.5, -0.5, 1, 0, 1, 0} << 1.3
        << Numbers{1.2, 0, -0.445313, -1.096154, 0, -0.322724, 1.037734, -0.070944};
    QTest::newRow("both at rest") << Numbers{0, 0} << Numbers{0.6, 0.1, 0, 0, -1, 0} << 1.3
                                  << Numbers{5.2, 0, -1.731949, -2.068894,
                                             0,   0, 0.173403,  -0.103445};
  }

  void densityForce_referenceValues() {
    QFETCH(Numbers, own);
    QFETCH(Numbers, others);
    QFETCH(double, cap);
    QFETCH(Numbers, expected);
    const Pedestrian self = pedestrian(0, Vec2::Zero(), Vec2(own[0], own[1]), Vec2(1.0, 0.0));
    std::vector<Pedestrian> people;
    for (int i = 0; i + 5 < others.size(); i += 6) {
      people.push_back(pedestrian(1 + i / 6, Vec2(others[i], others[i + 1]),
                                  Vec2(others[i + 2], others[i + 3]),
                                  Vec2(others[i + 4], others[i + 5])));
    }
    const DensityForce force = densityForce(standard(), self, people);
    QVERIFY(std::fabs(force.speedCap - cap) <= kRounding);
    QVERIFY(isNear(force.goal, Vec2(expected[0], expected[1])));
    QVERIFY(isNear(force.social, Vec2(expected[2], expected[3])));
    QVERIFY(isNear(force.lane, Vec2(expected[4], expected[5])));
    QVERIFY(isNear(stepped(standard(), self, people), Vec2(expected[6], expected[7])));
  }

  void guardContacts_wallAhead_stopsAtIt() {
    const Pedestrian self = pedestrian(0, Vec2::Zero(), Vec2(1.3, 0.0), Vec2(1.0, 0.0));
    const Obstacles::Point wall{Vec2(0.25, 0.0), 0.25, false, 0};
    QVERIFY(isNear(stepped(standard(), self, {}, {wall}), Vec2(1.0, 0.0)));
  }

  void densityForce_mate_feelsThePlainPairAndTheGroup() {
    Pedestrian self = pedestrian(0, Vec2::Zero(), Vec2(1.2, 0.0), Vec2(1.0, 0.0));
    Pedestrian mate = pedestrian(1, Vec2(0.5, 0.3), Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    self.desired.group = mate.desired.group = 7;
    const DensityForce force = densityForce(standard(), self, {mate});
    QVERIFY(std::fabs(force.speedCap - 1.3) <= kRounding);
    QVERIFY(isNear(force.goal, Vec2(0.4, 0.0)));
    QVERIFY(isNear(force.social, Vec2(-0.751348, -1.859694)));
    QVERIFY(isNear(stepped(standard(), self, {mate}, {}, {mate.body}), Vec2(1.192364, -0.087026)));
  }

  void densityForce_everythingOff_isThePlainModel() {
    DensityParameters plain;
    plain.social.epsilon = 0.0;
    plain.coMovingWeight = 1.0;
    plain.intentShare = 0.0;
    plain.laneFactor = 0.0;
    plain.brakingShare = 1.0;
    plain.timeGap = 1e-9;
    plain.crowdWallShare = 1.0;
    plain.groupTurnWidth = 0.0;
    plain.pushBackLimit = std::numeric_limits<double>::infinity();
    const Pedestrian self = pedestrian(0, Vec2::Zero(), Vec2(1.1, 0.1), Vec2(1.0, 0.0));
    for (int i = 0; i < 200; ++i) {
      const double t = 0.61 * i;
      const double far = 0.5 + std::fmod(0.37 * i, 4.0);
      std::vector<Pedestrian> people;
      Vec2 expected = goalForce(plain.social, self.body.velocity, Vec2(1.0, 0.0), 1.3);
      for (int k = 0; k < 3; ++k) {
        const Vec2 place = far * Vec2(std::cos(t + 2.0 * k), std::sin(t + 2.0 * k));
        people.push_back(pedestrian(k + 1, place, Vec2(std::sin(3.0 * t + k), std::cos(t + k)),
                                    Vec2(k == 1 ? -1.0 : 1.0, 0.0)));
        expected += socialForce(plain.social, self.body, people.back().body);
      }
      const DensityForce force = densityForce(plain, self, people);
      QVERIFY(isNear(force.goal + force.social + force.lane, expected, 1e-12));
      const std::vector<Obstacles::Point> wall = {{Vec2(0.3, 0.05), 0.304, false, 0}};
      QVERIFY(isNear(limitedObstacleForce(plain, self, wall),
                     obstacleForce(plain.social, self.body, wall), 1e-12));
    }
  }

  void densityForce_alone_isThePlainModel() {
    const Pedestrian self = pedestrian(0, Vec2::Zero(), Vec2(0.7, -0.2), Vec2(0.6, 0.8));
    const DensityForce force = densityForce(standard(), self, {});
    QVERIFY(isNear(force.goal,
                   goalForce(standard().social, self.body.velocity, Vec2(0.6, 0.8), 1.3), 0.0));
    QVERIFY(force.social.isZero(0.0) && force.lane.isZero(0.0));
  }

  void densityForce_oneWayFlow_hasNoLaneForce() {
    const Pedestrian self = pedestrian(0, Vec2::Zero(), Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    std::vector<Pedestrian> people;
    for (int i = 1; i < 12; ++i) {
      people.push_back(
          pedestrian(i, Vec2(0.4 * i, std::sin(2.0 * i)), Vec2(0.9, 0.0), Vec2(1.0, 0.0)));
    }
    QVERIFY(densityForce(standard(), self, people).lane.isZero(0.0));
  }

  /// Radius 0.4 m, as in the plain model, for this comparison alone.
  void densityForce_twoMatesAbreast_settleAsInThePlainModel() {
    std::vector<Pedestrian> pair = {
        pedestrian(1, Vec2(0.0, 0.45), Vec2(1.3, 0.0), Vec2(1.0, 0.0)),
        pedestrian(2, Vec2(0.0, -0.45), Vec2(1.3, 0.0), Vec2(1.0, 0.0))};
    for (Pedestrian& who : pair) {
      who.desired.group = 3;
      who.body.radius = 0.4;
    }
    for (int step = 0; step < 2000; ++step) {
      const std::vector<Pedestrian> before = pair;
      for (std::size_t i = 0; i < 2; ++i) {
        const Pedestrian& other = before[1 - i];
        pair[i].body.velocity = stepped(standard(), before[i], {other}, {}, {other.body});
        pair[i].body.position += pair[i].body.velocity * kDt;
      }
    }
    QVERIFY(std::fabs(pair[0].body.position.x() - pair[1].body.position.x()) < 1e-6);
    QVERIFY(std::fabs((pair[0].body.position - pair[1].body.position).norm() - 0.875) < 0.0015);
  }

  /// Forty people who all want to the middle.
  void guardContacts_crowdPressed_neverOverlaps() {
    std::vector<Pedestrian> crowd;
    for (int i = 0; i < 40; ++i) {
      const double ring = i < 20 ? 3.5 : 5.0;
      const double angle = 2.0 * 3.14159265358979 * i / 20.0;
      crowd.push_back(
          pedestrian(i, ring * Vec2(std::cos(angle), std::sin(angle)), Vec2::Zero(), Vec2::Zero()));
    }
    double least = 1e9;
    for (int step = 0; step < 400; ++step) {
      std::vector<Pedestrian> after = crowd;
      for (std::size_t i = 0; i < crowd.size(); ++i) {
        Pedestrian& self = crowd[i];
        self.desired.direction = -self.body.position.normalized();
      }
      for (std::size_t i = 0; i < crowd.size(); ++i) {
        std::vector<Pedestrian> others = crowd;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
        after[i].body.velocity = stepped(standard(), crowd[i], others);
        after[i].body.position += after[i].body.velocity * kDt;
      }
      crowd = after;
      for (std::size_t i = 0; i < crowd.size(); ++i) {
        for (std::size_t k = i + 1; k < crowd.size(); ++k) {
          least = std::min(least, (crowd[i].body.position - crowd[k].body.position).norm());
        }
      }
    }
    QVERIFY2(least >= 0.395, qPrintable(QString::number(least)));
  }

  void guardContacts_touchingAbreast_largerIdYields() {
    const Pedestrian first = pedestrian(1, Vec2(0.0, 0.2), Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    const Pedestrian second = pedestrian(2, Vec2(0.0, -0.2), Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    const Vec2 ahead(1.0, 0.0);
    QVERIFY(isNear(avoidContacts(standard(), first, {second}, {}, ahead, kDt), ahead));
    QVERIFY(isNear(avoidContacts(standard(), second, {first}, {}, ahead, kDt), Vec2(1.0, -0.15)));
  }

  /// Three before a door: the one in the middle must let go those at both sides, to get out of
  /// which there is only the way back.
  void guardContacts_betweenTwoToGiveWayTo_goesBack() {
    const Pedestrian self = pedestrian(55, Vec2(-0.507, -0.081), Vec2::Zero(), Vec2(1.0, 0.0));
    const Pedestrian right = pedestrian(56, Vec2(-0.178, -0.308), Vec2::Zero(), Vec2(0.976, 0.218));
    const Pedestrian left = pedestrian(13, Vec2(-0.471, 0.330), Vec2::Zero(), Vec2(0.985, -0.17));
    const Vec2 velocity = avoidContacts(standard(), self, {left, right}, {}, Vec2(0.3, 0.0), kDt);
    for (const Pedestrian& other : {left, right}) {
      const Vec2 apart = other.body.position - self.body.position;
      const double gap = apart.norm() - 0.4;
      const double least = 0.15 * (1.0 - std::max(0.0, gap) / 0.03);
      QVERIFY(-velocity.dot(apart.normalized()) >= least - 1e-6);
    }
    QVERIFY(velocity.x() < -0.1);
  }

  void guardContacts_otherLeaves_mayFollow() {
    const Vec2 way(1.0, 0.0);
    const Pedestrian self = pedestrian(1, Vec2::Zero(), way, way);
    const Pedestrian other = pedestrian(2, Vec2(0.415, 0.0), Vec2(0.2, 0.0), way);
    QVERIFY(isNear(avoidContacts(standard(), self, {other}, {}, way, kDt), Vec2(0.125, 0.0)));
  }

  void guardContacts_insideAWall_leadsOut() {
    const Pedestrian self = pedestrian(1, Vec2::Zero(), Vec2::Zero(), Vec2(1.0, 0.0));
    const Obstacles::Point wayOut{Vec2(0.0, 0.1), 0.1, true, 0};
    QVERIFY(avoidContacts(standard(), self, {}, {wayOut}, Vec2::Zero(), kDt).y() > 0.29);
  }

  void limitedObstacleForce_walkingIntoAWall_isLimited() {
    const Pedestrian self = pedestrian(1, Vec2::Zero(), Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    const std::vector<Obstacles::Point> wall = {{Vec2(0.1, 0.05), 0.1118, false, 0}};
    const Vec2 force = limitedObstacleForce(standard(), self, wall);
    QVERIFY(std::fabs(force.x() + 0.7 * 2.0 * 1.3 / 0.5) < 1e-12);
    QVERIFY(std::fabs(force.y() - obstacleForce(standard().social, self.body, wall).y()) < 1e-12);
  }

  void limitedObstacleForce_crowdOnANarrowWay_pushesLessAside() {
    const Pedestrian self = pedestrian(1, Vec2::Zero(), Vec2(1.0, 0.0), Vec2(1.0, 0.0));
    const Obstacles::Point ahead{Vec2(1.0, 0.0), 1.0, false, 0};
    const Obstacles::Point left{Vec2(0.0, 0.5), 0.5, false, 0};
    const Obstacles::Point near{Vec2(0.0, -1.5), 1.5, false, 0};
    const Obstacles::Point far{Vec2(0.0, -3.0), 3.0, false, 0};
    const Vec2 alone = limitedObstacleForce(standard(), self, {ahead, left, near});
    const Vec2 crowded = limitedObstacleForce(standard(), self, {ahead, left, near}, 1.0);
    QVERIFY(isNear(crowded, Vec2(alone.x(), standard().crowdWallShare * alone.y())));
    const Vec2 onWideWay = limitedObstacleForce(standard(), self, {ahead, left, far}, 1.0);
    QVERIFY(isNear(onWideWay, limitedObstacleForce(standard(), self, {ahead, left, far})));
  }

  /// The turning part of the force is a step for strangers, a ramp for mates.
  void densityForce_matesNearlyInStep_turnLess() {
    ForceParameters parameters;
    parameters.epsilon = 0.0;
    const Walker self{1, Vec2::Zero(), Vec2(1.0, 0.02), 0.2};
    const Walker other{2, Vec2(0.0, 1.0), Vec2(1.01, 0.02), 0.2};
    const Vec2 step = socialForce(parameters, self, other);
    parameters.turnWidth = 0.1;  // theta is 0.02
    const Vec2 ramp = socialForce(parameters, self, other);
    QVERIFY(std::fabs(ramp.x() / step.x() - 0.2) < 0.05);
    QVERIFY(std::fabs(ramp.y() - step.y()) < 0.05 * std::fabs(step.y()));
  }
};

QTEST_APPLESS_MAIN(DensityForceTest)
#include "tst_DensityForce.moc"
