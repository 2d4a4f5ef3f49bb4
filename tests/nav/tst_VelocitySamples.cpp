#include <algorithm>
#include <cmath>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/dwb/DwbTrajectory.h"
#include "tests/nav/ControlScene.h"

using namespace sim2d::nav2;
using base::Vec2;
using control_scene::isNear;
using sim2d::BodyTwist;

namespace {

using Values = QVector<double>;

/// Parameters of Nav2's twist_gen.cpp.
DwbParameters ofTwistTests() {
  DwbParameters p;
  p.minVelX = 0.0;
  p.maxVelX = 0.55;
  p.minVelY = -0.1;
  p.maxVelY = 0.1;
  p.maxVelTheta = 1.0;
  p.accLimX = p.accLimY = 2.5;
  p.accLimTheta = 3.2;
  p.decelLimX = p.decelLimY = -2.5;
  p.decelLimTheta = -3.2;
  p.minSpeedXy = 0.1;
  p.maxSpeedXy = 0.55;
  p.minSpeedTheta = 0.4;
  return p;
}

std::size_t countOf(const DwbParameters& p, const BodyTwist& now = {}, double time = 1.7) {
  std::vector<BodyTwist> samples;
  velocitySamples(p, now, time, samples);
  return samples.size();
}

/// A trajectory from the origin at the velocity.
DwbTrajectory rolledOut(const DwbParameters& p, const BodyTwist& command, const BodyTwist& speed,
                        TrajectoryGenerator::Kind kind = TrajectoryGenerator::Kind::Standard) {
  const Costmap map(60, 60, 0.05, Vec2(-1.5, -1.5));
  TrajectoryGenerator generator(kind, 20.0);
  generator.start(p, {}, speed, map);
  DwbTrajectory trajectory;
  generator.generate(command, trajectory);
  generator.locate(trajectory);
  return trajectory;
}

}  // namespace

class VelocitySamplesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void axis_vectors_data() {  // 21 to 25
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    QTest::addColumn<double>("acceleration");
    QTest::addColumn<double>("v");
    QTest::addColumn<double>("time");
    QTest::addColumn<int>("count");
    QTest::addColumn<Values>("values");
    QTest::newRow("basics") << 0.0 << 5.0 << 1.0 << 2.0 << 1.0 << 2 << Values{1.0, 3.0};
    QTest::newRow("limits") << 1.5 << 2.5 << 1.0 << 2.0 << 1.0 << 2 << Values{1.5, 2.5};
    QTest::newRow("acceleration") << 0.0 << 5.0 << 0.5 << 2.0 << 1.0 << 2 << Values{1.5, 2.5};
    QTest::newRow("time") << 0.0 << 5.0 << 1.0 << 2.0 << 0.5 << 2 << Values{1.5, 2.5};
    QTest::newRow("samples") << 0.0 << 5.0 << 1.0 << 2.0 << 1.0 << 3 << Values{1.0, 2.0, 3.0};
    QTest::newRow("samples2") << 0.0 << 5.0 << 1.0 << 2.0 << 1.0 << 5
                              << Values{1.0, 1.5, 2.0, 2.5, 3.0};
    QTest::newRow("around zero") << -5.0 << 5.0 << 1.0 << 0.0 << 1.0 << 2 << Values{-1.0, 0.0, 1.0};
    QTest::newRow("around zero2") << -5.0 << 5.0 << 1.0 << 0.0 << 1.0 << 4
                                  << Values{-1.0, -1.0 / 3.0, 0.0, 1.0 / 3.0, 1.0};
    QTest::newRow("one") << 0.3 << 0.3 << 1.0 << 0.3 << 1.0 << 20 << Values{0.3};
    QTest::newRow("too fast: clamped first")
        << 0.0 << 1.0 << 0.1 << 9.0 << 1.0 << 2 << Values{0.9, 1.0};
    QTest::newRow("no fewer than two") << 0.0 << 5.0 << 1.0 << 2.0 << 1.0 << 1 << Values{1.0, 3.0};
  }

  void axis_vectors() {
    QFETCH(double, least);
    QFETCH(double, most);
    QFETCH(double, acceleration);
    QFETCH(double, v);
    QFETCH(double, time);
    QFETCH(int, count);
    QFETCH(Values, values);
    const auto found = axisSamples({least, most, acceleration, -acceleration}, v, time, count);
    QCOMPARE(static_cast<int>(found.size()), values.size());
    for (int i = 0; i < values.size(); ++i) {
      QVERIFY(isNear(found[static_cast<std::size_t>(i)], values[i]));
    }
  }

  /// As in Nav2 the steps are added one by one.
  void axis_samplesAddUp_andMayPassTheEnd() {
    const auto found = axisSamples({0.0, 0.26, 2.5, -2.5}, 0.0, 1.7, 20);
    double sum = 0.0;
    for (const double value : found) {
      QCOMPARE(value, sum);
      sum += 0.26 / 19.0;
    }
    QCOMPARE(found.size(), std::size_t{20});
  }

  void combinations_vectors() {  // 26 to 28
    DwbParameters p = ofTwistTests();
    QCOMPARE(countOf(p), std::size_t{1926});
    p.maxSpeedXy = 1.0;
    QCOMPARE(countOf(p), std::size_t{2010});
    p = ofTwistTests();
    p.minSpeedXy = -1.0;
    QCOMPARE(countOf(p), std::size_t{2015});
    p = ofTwistTests();
    p.minSpeedTheta = -1.0;
    QCOMPARE(countOf(p), std::size_t{2015});
    p.minSpeedXy = p.maxSpeedXy = -1.0;
    QCOMPARE(countOf(p), std::size_t{2099});
    p.vxSamples = 10;
    p.vySamples = 3;
    p.vthetaSamples = 5;
    QCOMPARE(countOf(p), std::size_t{149});
  }

  void combinations_order_thetaFastest() {
    DwbParameters p = ofTwistTests();
    p.minSpeedXy = p.maxSpeedXy = p.minSpeedTheta = -1.0;
    p.vxSamples = 2;
    p.vySamples = 2;
    p.vthetaSamples = 2;
    std::vector<BodyTwist> samples;
    velocitySamples(p, {}, 1.7, samples);
    const double expected[][3] = {{0, -0.1, -1}, {0, -0.1, 0}, {0, -0.1, 1}, {0, 0, -1},
                                  {0, 0, 1},  // not standing still
                                  {0, 0.1, -1},  {0, 0.1, 0},  {0, 0.1, 1},  {0.55, -0.1, -1}};
    for (std::size_t i = 0; i < std::size(expected); ++i) {
      QVERIFY(isNear(samples[i].linear, expected[i][0]));
      QVERIFY(isNear(samples[i].lateral, expected[i][1]));
      QVERIFY(isNear(samples[i].angular, expected[i][2]));
    }
  }

  void combinations_limitedAccel_reachable() {  // 29, 30
    DwbParameters p = ofTwistTests();
    p.minSpeedTheta = -1.0;
    p.minSpeedXy = p.maxSpeedXy = -1.0;
    const Costmap map(60, 60, 0.05, Vec2(-1.5, -1.5));
    TrajectoryGenerator generator(TrajectoryGenerator::Kind::LimitedAccel, 20.0);
    generator.start(p, {}, {}, map);
    QCOMPARE(generator.commands().size(), std::size_t{2099});
    double mostX = 0.0, mostY = 0.0, mostTheta = 0.0;
    for (const BodyTwist& each : generator.commands()) {
      QVERIFY(each.linear >= 0.0);
      mostX = std::max(mostX, each.linear);
      mostY = std::max(mostY, std::abs(each.lateral));
      mostTheta = std::max(mostTheta, std::abs(each.angular));
    }
    QVERIFY(isNear(mostX, 0.125) && isNear(mostY, 0.1) && isNear(mostTheta, 0.16));
    generator.start(p, {}, {0.1, 0.05, -0.08}, map);
    QCOMPARE(generator.commands().size(), std::size_t{2519});
    p.simPeriod = 0.1;
    generator.start(p, {}, {}, map);
    QVERIFY(isNear(generator.commands().back().linear, 0.25));
  }

  void trajectory_poses_vectors() {  // 31, 32
    DwbParameters p = ofTwistTests();
    DwbTrajectory trajectory = rolledOut(p, {0.3, 0.0}, {0.3, 0.0});
    QCOMPARE(trajectory.poses.size(), std::size_t{4});
    QVERIFY(isNear(trajectory.step * 2.0, 1.7));
    QVERIFY(isNear(trajectory.poses.back().position.x(), 0.51));
    p.includesLastPoint = false;
    trajectory = rolledOut(p, {0.3, 0.0}, {0.3, 0.0});
    QCOMPARE(trajectory.poses.size(), std::size_t{3});
    QVERIFY(isNear(trajectory.step, 0.85));
    p.includesLastPoint = true;
    QCOMPARE(rolledOut(p, {0.2, 0.0}, {0.2, 0.0}).poses.size(), std::size_t{3});
    QCOMPARE(rolledOut(p, {0.3, 0.111, -0.2}, {}).poses.size(), std::size_t{10});
  }

  /// From rest with 2.5 m/s^2 and steps of 0.1 s: 0.25, 0.5, 0.5 m/s.
  void trajectory_standard_ramps() {
    DwbParameters p = ofTwistTests();
    p.discretizesByTime = true;
    p.simTime = 0.3;
    p.timeGranularity = 0.1;
    const DwbTrajectory trajectory = rolledOut(p, {0.5, 0.0}, {});
    QCOMPARE(trajectory.poses.size(), std::size_t{5});
    const double expected[] = {0.0, 0.025, 0.075, 0.125, 0.125};
    for (std::size_t i = 0; i < 5; ++i) {
      QVERIFY(isNear(trajectory.poses[i].position.x(), expected[i]));
    }
    QCOMPARE(trajectory.velocity, (BodyTwist{0.5, 0.0}));  // the target, not what is reached
  }

  void trajectory_limitedAccel_isAtOnce() {
    DwbParameters p = ofTwistTests();
    p.simTime = 1.0;
    const DwbTrajectory trajectory =
        rolledOut(p, {0.3, 0.0, 0.4}, {}, TrajectoryGenerator::Kind::LimitedAccel);
    QVERIFY((trajectory.poses.back().position - Vec2(0.3, 0.4)).norm() < 1e-12);
  }

  /// Each step moves along the heading before it.
  void trajectory_headingFirst_oldHeadingMoves() {
    DwbParameters p = ofTwistTests();
    p.discretizesByTime = true;
    p.simTime = 2.0;
    p.timeGranularity = 1.0;
    const DwbTrajectory trajectory =
        rolledOut(p, {1.0, base::kPi / 2.0, 0.5}, {}, TrajectoryGenerator::Kind::LimitedAccel);
    QVERIFY((trajectory.poses[1].position - Vec2(1.0, 0.5)).norm() < 1e-12);
    QVERIFY((trajectory.poses[2].position - Vec2(0.5, 1.5)).norm() < 1e-12);
    QVERIFY(isNear(trajectory.poses[2].heading, base::kPi));
  }

  void trajectory_byTime_hasItsSteps() {
    DwbParameters p;
    p.discretizesByTime = true;
    QCOMPARE(stepCount(p, {0.1, 0.0}), 4);  // 1.7 / 0.5
    p.discretizesByTime = false;
    QCOMPARE(stepCount(p, {0.0, 0.0}), 1);
    QCOMPARE(stepCount(p, {-0.3, 0.0}), 2);
    QCOMPARE(stepCount(p, {0.0, -1.0}), 68);
  }

  void trajectory_limitedCommand_isFirstStep() {
    DwbParameters p = ofTwistTests();
    p.limitsCommand = true;
    p.discretizesByTime = true;
    p.simTime = 0.2;
    p.timeGranularity = 0.1;
    QVERIFY(isNear(rolledOut(p, {0.5, -1.0}, {}).velocity.linear, 0.25));
    QVERIFY(isNear(rolledOut(p, {0.5, -1.0}, {}).velocity.angular, -0.32));
  }

  void trajectory_cells_areThoseOfTheMap() {
    DwbParameters p = ofTwistTests();
    p.simTime = 8.0;
    p.linearGranularity = 0.1;
    const Costmap map(60, 60, 0.05, Vec2(-1.5, -1.5));
    const DwbTrajectory trajectory = rolledOut(p, {0.5, 0.2}, {});
    QCOMPARE(trajectory.cells.size(), trajectory.poses.size());
    std::size_t onMap = 0;
    for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
      const auto cell = map.worldToCell(trajectory.poses[i].position);
      QCOMPARE(trajectory.cells[i], cell ? static_cast<int>(map.indexOf(*cell)) : -1);
      onMap += onMap == i && cell ? 1 : 0;
    }
    QCOMPARE(trajectory.onMap, onMap);
    QCOMPARE(trajectory.endCell, trajectory.cells.back());
    QVERIFY(onMap > 2 && onMap < trajectory.poses.size());
  }

  /// Headings kept from one command to the next give the same bits as those of a fresh generator.
  void trajectory_sharedTurns_changeNothing() {
    DwbParameters p = ofTwistTests();
    p.linearGranularity = 0.05;
    const Costmap map(60, 60, 0.05, Vec2(-1.5, -1.5));
    const Pose2 robot{Vec2(0.1, -0.2), 0.7};
    const BodyTwist speed{0.2, -0.3};
    TrajectoryGenerator shared(TrajectoryGenerator::Kind::Standard, 20.0);
    for (int cycle = 0; cycle < 2; ++cycle) {
      shared.start(p, robot, speed, map);
      for (const BodyTwist& command : std::vector<BodyTwist>(shared.commands())) {
        DwbTrajectory one, other;
        shared.generate(command, one);
        TrajectoryGenerator fresh(TrajectoryGenerator::Kind::Standard, 20.0);
        fresh.start(p, robot, speed, map);
        fresh.generate(command, other);
        QVERIFY(one.poses == other.poses);
        QVERIFY(one.endDirection == one.poses.back().direction());
      }
    }
  }

  void at_betweenPoses_isStraight() {
    DwbTrajectory trajectory;
    trajectory.poses = {{Vec2(0, 0), 0.0}, {Vec2(1, 0), 0.5}, {Vec2(1, 2), 1.0}};
    trajectory.step = 0.5;
    QCOMPARE(trajectory.at(-1.0), trajectory.poses[0]);
    QVERIFY((trajectory.at(0.75).position - Vec2(1.0, 1.0)).norm() < 1e-12);
    QVERIFY(isNear(trajectory.at(0.1).heading, 0.1));
    QCOMPARE(trajectory.at(1.0), trajectory.poses[2]);
    QCOMPARE(trajectory.at(9.0), trajectory.poses[2]);
  }
};

QTEST_APPLESS_MAIN(VelocitySamplesTest)
#include "tst_VelocitySamples.moc"
