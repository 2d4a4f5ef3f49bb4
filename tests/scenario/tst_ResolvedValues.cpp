#include <cmath>

#include "ScenarioTest.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Rng.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/nav/RobotTypes.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "tests/support/Columns.h"

using namespace sim2d;
using namespace scenariotest;

namespace {

struct Spread {
  double least = 1e9, most = -1e9, mean = 0.0;
};

/// The values that 4000 people with different ids get.
template <class Value>
Spread spreadOf(Human human, Value value) {
  Spread spread;
  const Scenario plain = Scenario();
  const int count = 4000;
  for (int id = 0; id < count; ++id) {
    human.id = id;
    const double drawn = value(resolveHuman(plain, human, 1));
    spread.least = std::min(spread.least, drawn);
    spread.most = std::max(spread.most, drawn);
    spread.mean += drawn / count;
  }
  return spread;
}

Human personWith(BehaviorType type, Configuration configuration) {
  Human human;
  human.name = "anna";
  human.id = 1;
  human.behavior.type = type;
  human.behavior.configuration = configuration;
  return human;
}

}  // namespace

class DefaultsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void resolveHuman_nothingWritten_defaults() {
    Human human;
    human.id = 3;
    const ResolvedHuman resolved = resolveHuman(Scenario{}, human, 1);
    QCOMPARE(resolved.id, 3);
    QCOMPARE(resolved.groupId, -1);
    QCOMPARE(resolved.desiredSpeed, 1.0);
    QCOMPARE(resolved.radius, 0.35);
    QCOMPARE(resolved.mass, 80.0);
    QCOMPARE(resolved.goalRadius, 0.1);
    QVERIFY(resolved.cyclicGoals && resolved.behavior == BehaviorType::Regular);
    QCOMPARE(resolved.noticeDistance, 5.0);
    QCOMPARE(resolved.reactionDuration, 40.0);
    QVERIFY(!resolved.reactionOnce);
    QCOMPARE(resolved.reactionSpeed, 2.0);
    QCOMPARE(resolved.safeDistance, 5.0);
    QCOMPARE(resolved.stopDistance, 1.5);
    QCOMPARE(resolved.frontDistance, 1.5);
    QCOMPARE(resolved.goalFactor, 2.0);
    QCOMPARE(resolved.obstacleFactor, 10.0);
    QCOMPARE(resolved.socialFactor, 5.0);
    QCOMPARE(resolved.otherFactor, 20.0);
    QCOMPARE(resolved.model, std::string("sfm"));
    QVERIFY(resolved.route == Route::Planned && resolved.atEnd == AtEnd::Stop);
  }

  void resolveHuman_reactionSpeed_velElseMaxVel() {
    Human human;
    human.maxVel = 1.3;
    QCOMPARE(resolveHuman(Scenario{}, human, 1).reactionSpeed, 1.3);
    human.behavior.vel = 0.6;
    QCOMPARE(resolveHuman(Scenario{}, human, 1).reactionSpeed, 0.6);
  }

  void resolveHuman_configurations_factors_data() {
    addColumns<int, bool, double, double, double>(
        {"configuration", "rays", "goal", "obstacle", "social"});
    QTest::newRow("default") << 0 << false << 2.0 << 10.0 << 5.0;
    QTest::newRow("default, rays") << 0 << true << 10.0 << 2.0 << 5.0;
    QTest::newRow("custom") << 1 << false << 3.5 << 90.0 << 1.0;
    QTest::newRow("custom, rays") << 1 << true << 3.5 << 90.0 << 1.0;
  }
  void resolveHuman_configurations_factors() {
    QFETCH(int, configuration);
    QFETCH(bool, rays);
    QFETCH(double, goal);
    QFETCH(double, obstacle);
    QFETCH(double, social);
    Human human = personWith(BehaviorType::Regular, static_cast<Configuration>(configuration));
    human.behavior.goalForceFactor = 3.5;
    human.behavior.obstacleForceFactor = 90.0;
    human.behavior.socialForceFactor = 1.0;
    human.behavior.otherForceFactor = 12.0;
    Scenario scenario;
    if (rays) {
      scenario.desktop.obstaclePoints = ObstaclePoints::Rays;
    }
    const ResolvedHuman resolved = resolveHuman(scenario, human, 1);
    QCOMPARE(resolved.goalFactor, goal);
    QCOMPARE(resolved.obstacleFactor, obstacle);
    QCOMPARE(resolved.socialFactor, social);
    QCOMPARE(resolved.otherFactor, 12.0);
  }

  void resolveHuman_draws_followTheDistribution_data() {
    addColumns<int, int, double, double, double, double>(
        {"configuration", "parameter", "least", "most", "mean", "tolerance"});
    // means of the cut normal distributions: by numerical integration
    QTest::newRow("goal, normal") << 2 << 0 << 0.5 << 5.0 << 2.1122 << 0.07;
    QTest::newRow("goal, uniform") << 3 << 0 << 2.0 << 5.0 << 3.5 << 0.05;
    QTest::newRow("obstacle, normal") << 2 << 1 << 0.5 << 50.0 << 10.01 << 0.25;
    QTest::newRow("obstacle, uniform") << 3 << 1 << 2.0 << 50.0 << 26.0 << 0.8;
    QTest::newRow("social, uniform") << 3 << 2 << 4.0 << 20.0 << 12.0 << 0.3;
    QTest::newRow("duration, uniform") << 3 << 3 << 25.0 << 60.0 << 42.5 << 0.6;
    QTest::newRow("dist, uniform") << 3 << 4 << 5.0 << 15.0 << 10.0 << 0.2;
    QTest::newRow("vel, uniform") << 3 << 5 << 0.6 << 1.2 << 0.9 << 0.02;
    QTest::newRow("stop, uniform") << 3 << 6 << 1.0 << 2.5 << 1.75 << 0.03;
    QTest::newRow("duration, normal") << 2 << 3 << 10.0 << 110.0 << 40.13 << 0.9;
  }
  void resolveHuman_draws_followTheDistribution() {
    QFETCH(int, configuration);
    QFETCH(int, parameter);
    QFETCH(double, least);
    QFETCH(double, most);
    QFETCH(double, mean);
    QFETCH(double, tolerance);
    const Human human =
        personWith(BehaviorType::Curious, static_cast<Configuration>(configuration));
    const Spread spread = spreadOf(human, [&](const ResolvedHuman& resolved) {
      const std::vector<double> all = {resolved.goalFactor,     resolved.obstacleFactor,
                                       resolved.socialFactor,   resolved.reactionDuration,
                                       resolved.noticeDistance, resolved.reactionSpeed,
                                       resolved.stopDistance};
      return all[static_cast<std::size_t>(parameter)];
    });
    QVERIFY(spread.least >= least && spread.most <= most);
    QVERIFY2(std::fabs(spread.mean - mean) < tolerance, qPrintable(QString::number(spread.mean)));
  }

  void resolveHuman_draw_dependsOnSeedAndIdOnly() {
    Human human = personWith(BehaviorType::Surprised, Configuration::Uniform);
    const ResolvedHuman first = resolveHuman(Scenario{}, human, 5);
    human.name = "ben";
    human.maxVel = 0.7;
    human.behavior.type = BehaviorType::Curious;
    QCOMPARE(resolveHuman(Scenario{}, human, 5).goalFactor, first.goalFactor);
    QVERIFY(resolveHuman(Scenario{}, human, 6).goalFactor != first.goalFactor);
    human.id = 2;
    QVERIFY(resolveHuman(Scenario{}, human, 5).goalFactor != first.goalFactor);
  }

  void resolveHuman_drawnReaction_replacesTheFilesNumbers() {
    Human human = personWith(BehaviorType::Threatening, Configuration::Normal);
    human.behavior.frontDist = 19.0;
    human.behavior.stopDist = 2.2;
    const ResolvedHuman resolved = resolveHuman(Scenario{}, human, 1);
    QVERIFY(resolved.frontDistance < 4.0);
    QCOMPARE(resolved.stopDistance, 2.2);  // not of this type: as written
    human.behavior.configuration = Configuration::Default;
    QCOMPARE(resolveHuman(Scenario{}, human, 1).frontDistance, 19.0);
  }

  void resolveHuman_ours_overScenario() {
    Scenario scenario = readScenario(dataFile("block.yaml")).scenario;
    const ResolvedHuman anna = resolveHuman(scenario, *scenario.human("anna"), 7);
    QCOMPARE(anna.mass, 30.5);
    QCOMPARE(anna.model, std::string("orca"));
    QVERIFY(anna.route == Route::Planned && anna.atEnd == AtEnd::Leave);
    QCOMPARE(anna.startTime, 2.5);
    QCOMPARE(anna.wait.size(), std::size_t(3));
    const ResolvedHuman ben = resolveHuman(scenario, *scenario.human("ben"), 7);
    QCOMPARE(ben.model, std::string("das"));
    QVERIFY(ben.route == Route::Direct);
  }

  void resolveRobot_generic_defaults() {
    const ResolvedRobot robot = resolveRobot(Scenario{}, Robot{}, -1);
    QCOMPARE(robot.id, -1);
    QCOMPARE(robot.type, std::string("generic"));
    QCOMPARE(robot.planner, std::string("pursuit"));
    QCOMPARE(robot.radius, 0.35);
    QCOMPARE(robot.mass, 50.0);
    QCOMPARE(robot.maxVel, 1.0);
    QCOMPARE(robot.maxAcc, 1.0);
    QCOMPARE(robot.maxOmega, 1.5);
    QCOMPARE(robot.maxAlpha, 3.0);
    QCOMPARE(robot.goalRadius, 0.2);
    QVERIFY(robot.goals.empty() && robot.footprint.empty());
  }

  /// Figures of the manufacturers: TurtleBot 3 Burger 0.22 m/s; Nova Carter 0.725 x 0.500 m.
  void resolveRobot_ofAType_hasItsNumbers() {
    Robot robot;
    robot.type = "turtlebot3_burger";
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).maxVel, 0.22);
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).type, std::string("turtlebot3_burger"));
    robot.maxVel = 0.11;
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).maxVel, 0.11);
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).maxReverse, 0.11);
    robot.type = "nova_carter";
    const ResolvedRobot carter = resolveRobot(Scenario{}, robot, -1);
    QVERIFY(std::fabs(std::fabs(signedArea(carter.footprint)) - 0.725 * 0.5) < 0.03);
    QVERIFY(carter.radius > 0.6);
    robot.radius = 0.4;  // instead of the type's polygon
    QVERIFY(resolveRobot(Scenario{}, robot, -1).footprint.empty());
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).radius, 0.4);
    robot.type = "pepper";
    QVERIFY(resolveRobot(Scenario{}, robot, -1).kinematics == Kinematics::Omnidirectional);
    robot.type = "ackermann_car";
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).turningRadius, 0.65);
  }

  void resolveRobot_goalsAndFootprint() {
    const Scenario scenario = readScenario(dataFile("block.yaml")).scenario;
    const ResolvedRobot first = resolveRobot(scenario, scenario.robots[0], -1);
    QCOMPARE(first.goals.size(), std::size_t(1));
    QCOMPARE(first.goalIds[0], 0);
    QCOMPARE(first.plannerParameters.size(), std::size_t(2));  // 'style' is no number
    QVERIFY(first.plannerTexts[2] == std::make_pair(std::string("style"), std::string("smooth")));
    QVERIFY(first.command == *scenario.robots[0].command);
    ResolvedRobot second = resolveRobot(scenario, scenario.robots[1], -2);
    QVERIFY(second.goalIds == (std::vector<int>{1, 3}));
    QVERIFY(second.goals[1] == Vec2(9.125, -5.0));
    QVERIFY(std::fabs(second.radius - std::sqrt(0.13)) < 1e-12);
    Robot clockwise = scenario.robots[1];
    std::reverse(clockwise.footprintX.begin(), clockwise.footprintX.end());
    std::reverse(clockwise.footprintY.begin(), clockwise.footprintY.end());
    second = resolveRobot(scenario, clockwise, -2);
    QVERIFY(second.footprint[0] == Vec2(-0.3, -0.2) && second.footprint[1] == Vec2(0.3, -0.2));
  }

  void resolveRobot_localizationError_isCorrectedUnlessTheFileHasARate() {
    Robot robot;
    robot.localization.stdYaw = 0.035;
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).localization.rate, 2.0);
    robot.localization.rate = 0.0;
    QCOMPARE(resolveRobot(Scenario{}, robot, -1).localization.rate, 0.0);
    Robot jumping;
    jumping.localization.jumpRate = 0.1;  // without a size there is no error
    QVERIFY(!resolveRobot(Scenario{}, jumping, -1).localization.isActive());
    jumping.localization.jumpDistance = 0.3;
    QCOMPARE(resolveRobot(Scenario{}, jumping, -1).localization.rate, 2.0);
    Robot exact;
    exact.localization.rate = 5.0;
    QVERIFY(resolveRobot(Scenario{}, exact, -1).localization.isActive());
  }

  void resolveRobot_withoutKeys_seesWithoutFaults() {
    const ResolvedRobot robot = resolveRobot(Scenario{}, Robot{}, -1);
    QVERIFY(robot.detectorKind == DetectorKind::Sensor && robot.odometry.isExact());
    QVERIFY(!robot.localization.isActive());
    QCOMPARE(robot.detector.range, 10.0);
    QCOMPARE(robot.detector.field, 2.0 * M_PI);
    QVERIFY(robot.detector.isOccluded && robot.detector.measuresVelocity);
    QCOMPARE(robot.detector.rate + robot.detector.latency + robot.detector.noise, 0.0);
    QCOMPARE(robot.detector.misses + robot.detector.swaps, 0.0);
    QCOMPARE(robot.detector.coastTime, 1.0);
    QVERIFY(!robot.recordsScans);
    Robot noisy;
    noisy.detector.noise = 0.1;
    QVERIFY(!resolveRobot(Scenario{}, noisy, -1).detector.measuresVelocity);
    noisy.detector.velocities = TrackVelocities::Measured;
    QVERIFY(resolveRobot(Scenario{}, noisy, -1).detector.measuresVelocity);
    noisy.detector.kind = DetectorKind::GroundTruth;
    const DetectorParameters all = resolveRobot(Scenario{}, noisy, -1).detector;
    QVERIFY(std::isinf(all.range) && all.noise == 0.0 && !all.isOccluded);
  }

  /// Beams stand as the type has them; all round it is a whole turn, so that another number of
  /// beams leaves no gap.
  void robotOfType_lidars_keepTheirBeams() {
    for (const RobotType& type : robotTypes()) {
      const LidarParameters lidar = robotOfType(type.name).lidar;
      QCOMPARE(lidar.beams, type.lidar ? type.lidar->beams : 0);
      if (!type.lidar) {
        continue;
      }
      QVERIFY2(areValidParameters(lidar), type.name.c_str());
      const double apart = (type.lidar->angleMax - type.lidar->angleMin) / (lidar.beams - 1);
      const double span = lidar.angleMax - lidar.angleMin;
      const bool isRound = std::fabs(span - 2.0 * M_PI) < 1e-12;
      QCOMPARE(isRound, apart * lidar.beams > 2.0 * M_PI - 1e-6);
      QVERIFY(std::fabs(span / (isRound ? lidar.beams : lidar.beams - 1) - apart) < 1e-12);
      QCOMPARE(lidar.angleMin, type.lidar->angleMin);
      QCOMPARE(lidar.range, type.lidar->range);
      QCOMPARE(lidar.mount.position.x(), type.lidar->x);
    }
  }

  void massOf_kinds_ordered() {
    QCOMPARE(massOf(PersonKind::Adult), 80.0);
    QVERIFY(massOf(PersonKind::Child) < massOf(PersonKind::Elderly));
    QVERIFY(massOf(PersonKind::Wheelchair) > massOf(PersonKind::Adult));
    QCOMPARE(QString::fromUtf8(personKindName(PersonKind::Luggage)), QStringLiteral("luggage"));
  }
};

QTEST_APPLESS_MAIN(DefaultsTest)
#include "tst_ResolvedValues.moc"
