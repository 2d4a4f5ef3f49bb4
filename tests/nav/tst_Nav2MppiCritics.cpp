#include <cmath>
#include <vector>

#include <QtTest>

#include "tests/nav/Nav2CriticBench.h"

using nav2test::CriticBench;
using namespace sim2d::nav2;
using base::kPi;

namespace {

/// Of Nav2's numbers, which are given to three or four digits, in single precision.
void compareTo(double found, double wanted, double tolerance = 1e-4) {
  QVERIFY2(std::fabs(found - wanted) <= tolerance,
           qPrintable(QStringLiteral("%1, not %2").arg(found, 0, 'g', 9).arg(wanted, 0, 'g', 9)));
}

Path lineTo(const Vec2& end, int points) {
  Path path;
  for (int i = 0; i < points; ++i) {
    path.push_back({end * (static_cast<double>(i) / (points - 1)), 0.0});
  }
  return path;
}

}  // namespace

/// Critics of Nav2's MPPI against the numbers of Nav2's own tests ("vector …": 1000 trajectories of
/// 30 steps of 0.1 s, defaults of the code) and against numbers worked out by hand.
class Nav2MppiCriticsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void constraint_vectors52To54_areMet_data() {
    QTest::addColumn<int>("motion");
    QTest::addColumn<double>("vx");
    QTest::addColumn<double>("wz");
    QTest::addColumn<double>("vy");
    QTest::addColumn<int>("power");
    QTest::addColumn<double>("wanted");
    QTest::newRow("0.40") << 0 << 0.40 << 0.0 << 0.0 << 1 << 0.0;
    QTest::newRow("0.60") << 0 << 0.60 << 0.0 << 0.0 << 1 << 1.2;
    QTest::newRow("-0.45") << 0 << -0.45 << 0.0 << 0.0 << 1 << 1.2;
    QTest::newRow("0.60, power 2") << 0 << 0.60 << 0.0 << 0.0 << 2 << 1.44;
    QTest::newRow("Ackermann 1.5") << 2 << 0.40 << 1.5 << 0.0 << 1 << 0.0;
    QTest::newRow("Ackermann 2.5") << 2 << 0.40 << 2.5 << 0.0 << 1 << 0.48;
    QTest::newRow("Ackermann, power 2") << 2 << 0.40 << 2.5 << 0.0 << 2 << 0.2304;
    QTest::newRow("Omni vx") << 1 << 0.60 << 0.0 << 0.0 << 1 << 1.2;
    QTest::newRow("Omni vy") << 1 << 0.0 << 0.0 << 0.5 << 1 << 2.4;
    QTest::newRow("Omni both") << 1 << 0.60 << 0.0 << 0.5 << 1 << 3.6;
    QTest::newRow("Omni, power 2") << 1 << 0.60 << 0.0 << 0.5 << 2 << 12.96;
  }

  void constraint_vectors52To54_areMet() {
    QFETCH(int, motion);
    QFETCH(double, vx);
    QFETCH(double, wz);
    QFETCH(double, vy);
    QFETCH(int, power);
    QFETCH(double, wanted);
    CriticBench bench("ConstraintCritic", Distro::Main);
    bench.mppi.motion = static_cast<MppiMotion>(motion);
    bench.mppi.settings.vyMax = 0.3;
    bench.mppi.critics.constraint.power = power;
    bench.setSpeeds(vx, wz, vy);
    compareTo(bench.each(), wanted);
  }

  /// hypot(0.5, 0.5) = 0.7071 ahead; hypot(0.35, 0.5) = 0.6103 back. 4 * 3 s * (1 - 0.7071).
  void constraint_omniUntilJazzy_limitsThePlanarSpeed() {
    CriticBench bench("ConstraintCritic", Distro::Jazzy);
    bench.mppi.motion = MppiMotion::Omni;
    bench.setSpeeds(0.6, 0.0, 0.8);
    compareTo(bench.each(), 12.0 * (1.0 - std::sqrt(0.5)));
    bench.setSpeeds(-0.6, 0.0, 0.8);
    compareTo(bench.each(), 12.0 * (1.0 - std::sqrt(0.35 * 0.35 + 0.25)));
  }

  /// Until Kilted the limits of every motion model contain vy_max: hypot(0.5, 0.3) = 0.5831.
  void constraint_diffDriveUntilKilted_countsVyMax() {
    for (const Distro distro : kDistros) {
      CriticBench bench("ConstraintCritic", distro);
      bench.mppi.settings.vyMax = 0.3;
      bench.setSpeeds(0.7);
      const double most = distro < Distro::Lyrical ? std::sqrt(0.34) : 0.5;
      compareTo(bench.each(), 12.0 * (0.7 - most));
      bench.mppi.settings.vyMax = 0.0;  // as in Nav2's own tests
      bench.setSpeeds(-0.45);
      compareTo(bench.each(), 1.2);
    }
  }

  /// 30 steps with a stride of 4 are poses 0 to 24 in Jazzy, with 28 elsewhere; step 28 costs 100.
  void cost_stride_endsEarlierInJazzy() {
    for (const Distro distro : kDistros) {
      CriticBench bench("CostCritic", distro, 1);
      bench.mppi.critics.cost.pointStep = 4;
      bench.mppi.critics.cost.weight = 254.0;
      bench.setPoses(0.0, 0.0);
      bench.setPose(0, 28, 1.0, 1.0);
      bench.scene.costmap.set(*bench.scene.costmap.worldToCell({1.0, 1.0}), 100);
      compareTo(bench.all().front(), distro == Distro::Jazzy ? 0.0 : 100.0 / 8.0);
    }
  }

  void goalAngle_vector55_countsNearTheGoalAlone() {
    CriticBench bench("GoalAngleCritic", Distro::Main);
    for (const double length : {9.0, 0.8, 0.3}) {
      bench.scene.goAhead(length, 10);
      bench.scene.goal.heading = 3.14;
      compareTo(bench.each(), length < 0.5 ? 9.42 : 0.0);
    }
  }

  void goalAngle_vector56_takesEitherEnd() {
    CriticBench bench("GoalAngleCritic", Distro::Main);
    bench.mppi.critics.goalAngle.isSymmetric = true;
    bench.scene.goAhead(0.3, 10);
    const double headings[] = {3.14, 0.0, 1.57};
    const double wanted[] = {3.0 * (kPi - 3.14), 0.0, 4.71};
    for (int i = 0; i < 3; ++i) {
      bench.scene.goal.heading = headings[i];
      compareTo(bench.each(), wanted[i]);
    }
  }

  void goalAngle_release_saysWhoseGoal() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      CriticBench bench("GoalAngleCritic", distro);
      bench.scene.goAhead(0.3, 10);
      bench.scene.path.back().heading = 1.0;
      bench.scene.goal.heading = 2.0;
      compareTo(bench.each(), distro == Distro::Humble ? 3.0 : 6.0);
    }
  }

  void goal_vector57_isTheMeanDistance() {
    CriticBench bench("GoalCritic", Distro::Main);
    bench.scene.goAhead(0.5, 10);
    compareTo(bench.each(), 2.5);
    for (int step = 0; step < 15; ++step) {  // half of the way at (0.5, 0.4)
      bench.setPose(3, step, 0.5, 0.4);
    }
    compareTo(bench.all()[3], 5.0 * 0.5 * (0.4 + 0.5));
    bench.scene.goAhead(1.5, 10);
    compareTo(bench.each(), 0.0);
  }

  /// A path that turns back: 1.2 m of way to a goal 0.2 m away; it is cut 0.4 m from the robot.
  void near_releases_measureOtherWays() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      CriticBench bench("GoalAngleCritic", distro);
      bench.scene.path = {{Vec2(0.0, 0.0), 0.0}, {Vec2(0.8, 0.0), 0.0}, {Vec2(0.4, 0.0), 0.0}};
      bench.scene.goal = {Vec2(0.2, 0.0), 1.0};
      bench.mppi.critics.goalAngle.threshold = 0.3;
      bench.all();
      QCOMPARE(bench.wasEvaluated, distro == Distro::Jazzy);
      bench.mppi.critics.goalAngle.threshold = 0.5;
      bench.all();
      QCOMPARE(bench.wasEvaluated, distro != Distro::Main);
      bench.mppi.critics.goalAngle.threshold = 1.3;
      bench.all();
      QVERIFY(bench.wasEvaluated);
    }
  }

  void pathAngle_vectors58And59_areMet_data() {
    QTest::addColumn<int>("mode");
    QTest::addColumn<double>("wanted");
    QTest::newRow("forward") << 0 << 3.9947;
    QTest::newRow("either end") << 1 << 2.9167;
    QTest::newRow("along the path") << 2 << 2.9167;
  }

  void pathAngle_vectors58And59_areMet() {
    QFETCH(int, mode);
    QFETCH(double, wanted);
    CriticBench bench("PathAngleCritic", Distro::Jazzy);
    bench.scene.path = lineTo(Vec2(-1.0, 4.0), 5);  // point 0 is reached, 4 more is the end
    bench.scene.goal = bench.scene.path.back();
    bench.mppi.critics.pathAngle.mode = mode;
    compareTo(bench.each(), wanted);
    if (mode == 2) {  // a path that looks back there: towards it is right
      bench.scene.path.back().heading = kPi;
      compareTo(bench.each(), 3.9947);
    }
  }

  /// Half of the way heads for the point, the other half is off by 1.8158 rad.
  void pathAngle_humble_isTheMeanOverTheWay() {
    CriticBench bench("PathAngleCritic", Distro::Humble);
    bench.scene.path = lineTo(Vec2(-1.0, 4.0), 5);
    bench.scene.goal = bench.scene.path.back();
    const double angle = std::atan2(4.0, -1.0);
    compareTo(bench.each(), 2.0 * angle);
    for (int step = 0; step < 15; ++step) {
      bench.setPose(7, step, 0.0, 0.0, angle);
    }
    compareTo(bench.all()[7], angle);
    bench.mppi.critics.pathAngle.isForwardPreferred = false;
    bench.setPoses(0.0, 0.0);
    compareTo(bench.each(), 2.0 * (kPi - angle));
  }

  void pathAngle_robotLooksThere_isNotAsked() {
    CriticBench bench("PathAngleCritic", Distro::Main);
    bench.scene.path = lineTo(Vec2(-1.0, 4.0), 5);
    bench.setPoses(0.0, 0.0, 0.3);
    bench.scene.robot.heading = 1.8158 - 0.78;
    compareTo(bench.each(), 0.0);
    QVERIFY(!bench.wasEvaluated);
    bench.scene.robot.heading = 1.8158 - 0.79;
    compareTo(bench.each(), 2.2 * (std::atan2(4.0, -1.0) - 0.3));
  }

  void pathAngle_cannotGoBack_knowsOneEnd() {
    CriticBench bench("PathAngleCritic", Distro::Main);
    bench.scene.path = lineTo(Vec2(-1.0, 4.0), 5);
    bench.mppi.critics.pathAngle.mode = 1;
    bench.mppi.settings.vxMin = 0.0;
    compareTo(bench.each(), 3.9947);
  }

  void preferForward_vector60_countsBackwards() {
    CriticBench bench("PreferForwardCritic", Distro::Main);
    bench.setSpeeds(1.0);
    compareTo(bench.each(), 0.0);
    bench.setSpeeds(-1.0);
    compareTo(bench.each(), 15.0);
    bench.scene.goAhead(0.4, 10);
    compareTo(bench.each(), 0.0);
  }

  void twirling_vector61_isTheMeanTurn() {
    CriticBench bench("TwirlingCritic", Distro::Jazzy);
    bench.setSpeeds(0.0, 10.0);
    compareTo(bench.each(), 100.0);
    bench.setSpeeds(0.0, -10.0);
    compareTo(bench.each(), 100.0);
    bench.scene.goAhead(0.24, 10);  // within the goal checker's 0.25 m
    compareTo(bench.each(), 0.0);
  }

  void pathFollow_vector62_isTheDistanceOfTheEnd() {
    CriticBench bench("PathFollowCritic", Distro::Main);
    bench.mppi.critics.pathFollow.threshold = 0.1;
    bench.scene.goAhead(0.15, 6);
    compareTo(bench.each(), 0.75);
    bench.setPose(5, 29, -0.25, 0.3);
    compareTo(bench.all()[5], 5.0 * 0.5);
  }

  void pathFollow_blockedPoint_takesTheNextFree() {
    CriticBench bench("PathFollowCritic", Distro::Main);
    bench.scene.costmap = Costmap(300, 10, 0.05, Vec2(-0.25, -0.25));
    bench.scene.goAhead(10.0, 11);  // points 1 m apart; 0 is reached, 6 is asked
    compareTo(bench.each(), 30.0);
    for (const double x : {6.0, 7.0}) {
      bench.scene.costmap.set(*bench.scene.costmap.worldToCell(Vec2(x, 0.0)), 253);
    }
    compareTo(bench.each(), 40.0);
    bench.scene.costmap.set(*bench.scene.costmap.worldToCell(Vec2(6.0, 0.0)), 255);
    bench.scene.shape.tracksUnknown = true;
    compareTo(bench.each(), 30.0);
  }

  void pathAlign_vector63_isTheMeanDistance() {
    CriticBench bench("PathAlignCritic", Distro::Main);
    bench.scene.path.clear();
    for (int i = 0; i < 22; ++i) {
      bench.scene.path.push_back({Vec2(0.1 * std::min(i, 9), 0.0), 0.0});
    }
    bench.setPoses(0.66, 0.0);
    compareTo(bench.each(), 0.0);  // point 7 is reached, 20 are wanted
    QCOMPARE(bench.furthest, 7);
    bench.mppi.critics.pathAlign.offsetFromFurthest = 7;
    compareTo(bench.each(), 6.6);
  }

  /// Points every 0.1 m along +x. The way goes 0.05 m per step along +y; looked at after 0.2, 0.4,
  /// … 1.4 m: off by sqrt(2) of that from the points at 0.2 … 1.4.
  void pathAlign_curvedWay_byHand() {
    CriticBench bench("PathAlignCritic", Distro::Jazzy, 40);
    bench.scene.goAhead(10.0, 101);
    bench.scene.costmap = Costmap(300, 10, 0.05, Vec2(-0.25, -0.25));
    bench.mppi.critics.pathAlign.offsetFromFurthest = 5;
    for (int step = 0; step < 30; ++step) {
      bench.setPose(2, step, 0.0, 0.05 * step);
      bench.setPose(3, step, 0.1 * step, 0.0);     // along the path: reaches point 29
      bench.setPose(4, step, 0.0, 0.0125 * step);  // 0.05, 0.1 …: looked at once per half point
    }
    const std::vector<double> costs = bench.all();
    QCOMPARE(bench.furthest, 29);
    compareTo(costs[2], 10.0 * std::sqrt(2.0) * 0.8, 1e-3);
    compareTo(costs[3], 0.0, 1e-3);
    // Way 0.05 i, i = 1 … 7: equally near to two points is the later one, save for rounding.
    double sum = 0.0;
    for (int i = 1; i < 8; ++i) {
      sum += std::hypot(0.1 * ((i + 1) / 2), 0.05 * i);
    }
    compareTo(costs[4], 10.0 * sum / 7.0, 0.3);
  }

  void pathAlign_orientations_byHand() {
    CriticBench bench("PathAlignCritic", Distro::Main, 16);
    bench.scene.goAhead(10.0, 101);
    bench.scene.costmap = Costmap(300, 30, 0.05, Vec2(-0.25, -0.25));
    bench.mppi.critics.pathAlign.usesOrientations = true;
    bench.mppi.critics.pathAlign.power = 2;
    for (int step = 0; step < 30; ++step) {
      bench.setPose(0, step, 0.1 * step, 0.3, 0.4);
    }
    compareTo(bench.all()[0], 25.0, 1e-3);  // (10 hypot(0.3, 0.4))²
  }

  void pathAlign_blockedPath_isNotAsked() {
    CriticBench bench("PathAlignCritic", Distro::Main, 16);
    bench.scene.goAhead(10.0, 101);
    bench.scene.costmap = Costmap(300, 30, 0.05, Vec2(-0.275, -0.275));
    for (int step = 0; step < 30; ++step) {
      bench.setPose(0, step, 0.1 * step, 0.0);
    }
    const auto block = [&](int point) {
      bench.scene.costmap.set(*bench.scene.costmap.worldToCell(Vec2(0.1 * point, 0.0)), 254);
    };
    block(5);
    block(6);
    bench.all();
    QVERIFY(bench.wasEvaluated);  // two are never too many
    block(7);                     // 3 of the 29 up to the one reached are more than 7 %
    bench.all();
    QVERIFY(!bench.wasEvaluated);
    bench.mppi.critics.pathAlign.maxPathOccupancyRatio = 3.0 / 29.0 + 0.01;
    bench.all();
    QVERIFY(bench.wasEvaluated);
  }

  void deadband_vector64_areMet() {
    CriticBench bench("VelocityDeadbandCritic", Distro::Main);
    bench.mppi.motion = MppiMotion::Omni;
    bench.mppi.critics.deadband.velocities = {0.08, 0.08, 0.08};
    bench.setSpeeds(0.80, 0.80, 0.60);
    compareTo(bench.each(), 0.0);
    bench.setSpeeds(0.01, 0.021, 0.02);
    compareTo(bench.each(), 19.845);
    bench.setSpeeds(-0.01, -0.021, -0.02);
    compareTo(bench.each(), 19.845);
    bench.mppi.motion = MppiMotion::DiffDrive;  // without vy
    compareTo(bench.each(), 35.0 * 3.0 * (0.07 + 0.059));
    bench.mppi.critics.deadband.velocities = {0.0, 1.0, 0.08};  // vx, vy, wz
    compareTo(bench.each(), 35.0 * 3.0 * 0.059);
  }

  /// 66: a U of 8 m, dense in its turn; ways of 5.1 m from (0, 0) to (5, 1).
  void furthest_vectors65And66_areMet() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      CriticBench bench("PathFollowCritic", distro, 100, 2);
      bench.scene.goAhead(1.8, 10);
      CriticBench::fill(bench.columns.x, 1.0);
      CriticBench::fill(bench.columns.length, 1.0);
      bench.all();
      QCOMPARE(bench.furthest, 5);

      bench.scene.path.clear();
      for (const Vec2& place :
           {Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(3, 0), Vec2(4, 0), Vec2(5, 0), Vec2(5.25, 0),
            Vec2(5.5, 0), Vec2(5.5, 0.25), Vec2(5.5, 0.5), Vec2(5.5, 0.75), Vec2(5.5, 1),
            Vec2(5, 1), Vec2(4, 1)}) {
        bench.scene.path.push_back({place, 0.0});
      }
      bench.scene.goal = bench.scene.path.back();
      bench.setPoses(5.0, 1.0);
      CriticBench::fill(bench.columns.length, std::hypot(5.0, 1.0));
      bench.all();
      if (distro == Distro::Main) {
        QVERIFY(bench.furthest <= 6);
        QCOMPARE(bench.furthest, 5);
      } else {
        QCOMPARE(bench.furthest, 12);
      }
    }
  }

  void posePointAngle_vector67_areMet() {
    const Pose2 robot;
    compareTo(posePointAngle(robot, Vec2(1.0, 0.0), true), 0.0);
    compareTo(posePointAngle(robot, Vec2(-1.0, 0.0), true), kPi);
    compareTo(posePointAngle(robot, Vec2(1.0, 0.0), false), 0.0);
    compareTo(posePointAngle(robot, Vec2(-1.0, 0.0), false), 0.0);
    compareTo(posePointAngle(robot, Vec2(-1.0, 0.0), 0.0), 0.0);  // a path that is backed along
    compareTo(posePointAngle(robot, Vec2(-1.0, 0.0), kPi), kPi);
    compareTo(posePointAngle({Vec2(1.0, 1.0), 0.5}, Vec2(1.0, 3.0), true), kPi / 2.0 - 0.5);
  }

  /// 15 poses of 30 are looked at (each second one); the way lies on a cell of 100 from step 20 on,
  /// which are 5 of them, and on one of 253 that is no collision at step 10.
  void cost_summands_byHand() {
    CriticBench bench("CostCritic", Distro::Main, 20);
    Costmap& costmap = bench.scene.costmap;
    const auto cellAt = [&](double x, double y) { return *costmap.worldToCell(Vec2(x, y)); };
    costmap.set(cellAt(1.01, 1.01), 100);
    costmap.set(cellAt(-1.01, -1.01), 252);
    bench.mppi.critics.cost.nearCollisionCost = 252;
    for (int step = 20; step < 30; ++step) {
      bench.setPose(6, step, 1.01, 1.01);
    }
    bench.setPose(6, 10, -1.01, -1.01);
    bench.setPose(7, 11, -1.01, -1.01);  // not looked at
    bench.setPose(8, 10, 50.0, 0.0);     // off the map: 255
    const double weight = 3.81 / 254.0;
    std::vector<double> costs = bench.all();
    compareTo(costs[0], 0.0);
    compareTo(costs[6], weight * (5.0 * 100.0 + 300.0) / 15.0, 1e-3);
    compareTo(costs[7], 0.0);
    compareTo(costs[8], weight * 1e6 / 15.0, 0.01);
    bench.scene.shape.tracksUnknown = true;  // 255 is no collision, but critical
    costs = bench.all();
    compareTo(costs[8], weight * 300.0 / 15.0, 1e-3);
    bench.scene.goAhead(0.4, 5);  // near the goal what is not critical is forgiven
    compareTo(bench.all()[6], weight * 300.0 / 15.0, 1e-3);

    CriticBench humble("CostCritic", Distro::Humble, 20);  // every pose
    humble.scene.costmap = costmap;
    humble.setPose(7, 11, 1.01, 1.01);
    humble.mppi.critics.cost.power = 2;
    compareTo(humble.all()[7], std::pow(weight * 100.0 / 30.0, 2.0), 1e-4);
  }

  void cost_collision_setsTheWholeWay() {
    CriticBench bench("CostCritic", Distro::Jazzy, 20);
    Costmap& costmap = bench.scene.costmap;
    for (const int cost : {252, 253, 254}) {
      costmap.set(*costmap.worldToCell(Vec2(1.01, 1.01)), static_cast<std::uint8_t>(cost));
      costmap.set(*costmap.worldToCell(Vec2(0.51, 0.51)), 200);
      for (int step = 0; step < 30; ++step) {
        bench.setPose(9, step, 0.51, 0.51);
      }
      bench.setPose(9, 28, 1.01, 1.01);
      const double raw = cost == 252 ? (14.0 * 200.0 + 252.0) / 15.0 : 1e6 / 15.0;
      compareTo(bench.all()[9], 3.81 / 254.0 * raw, 0.01);
      QVERIFY(!bench.hasFailed);
    }
  }

  /// A footprint of 0.6 x 0.4 m; the wall's cell is 0.25 m to the left of the centre of sample 0,
  /// which clears it lengthwise (0.2 m) and meets it across (0.3 m).
  void cost_footprint_asksTheEdges() {
    CriticBench bench("CostCritic", Distro::Jazzy, 20);
    bench.mppi.critics.cost.considersFootprint = true;
    Costmap& costmap = bench.scene.costmap;
    for (int column = 0; column < costmap.width(); ++column) {
      costmap.set({column, costmap.worldToCell(Vec2(0.0, 0.26))->row}, 254);
    }
    bench.scene.shape.inflationRadius = 0.0;  // no layer: edges are asked wherever there is a cost
    costmap.set(*costmap.worldToCell(Vec2(0.01, 0.01)), 1);
    bench.setPoses(-1.01, -1.01);
    bench.setPose(0, 4, 0.01, 0.01, 0.0);
    bench.setPose(1, 4, 0.01, 0.01, kPi / 2.0);
    bench.setPose(2, 4, 0.01, 0.06, kPi / 2.0);  // cost 0: not asked
    const double weight = 3.81 / 254.0 / 15.0;
    std::vector<double> costs = bench.all();
    compareTo(costs[0], weight * 1.0);
    compareTo(costs[1], weight * 1e6, 0.01);
    compareTo(costs[2], 0.0);
    // With inflation centres that cost less than one at r_circ cannot touch: trunc(252 e^(-3 *
    // (0.36056 - 0.2))) = 155.
    bench.scene.shape.inflationRadius = 0.7;
    compareTo(circumscribedCost(bench.scene.shape), 155.0);
    compareTo(bench.all()[1], weight * 1.0);
    costmap.set(*costmap.worldToCell(Vec2(0.01, 0.01)), 155);
    compareTo(bench.all()[1], weight * 1e6, 0.01);
    // 253 under the centre of a robot with a footprint is no collision, but critical.
    costmap.set(*costmap.worldToCell(Vec2(0.01, 0.01)), 253);
    compareTo(bench.all()[0], weight * 300.0, 1e-3);
  }

  void cost_allCollide_fails() {
    for (const char* critic : {"CostCritic", "ObstaclesCritic"}) {
      CriticBench bench(critic, Distro::Main, 20);  // 12 lanes fill the last block up
      bench.mppi.settings.critics = {critic, "PreferForwardCritic"};
      bench.setSpeeds(-1.0);
      bench.scene.costmap.set(*bench.scene.costmap.worldToCell(Vec2(1.01, 1.01)), 254);
      bench.setPoses(1.01, 1.01);
      for (int step = 0; step < 30; ++step) {
        bench.setPose(19, step, 0.0, 0.0);
      }
      QVERIFY(bench.all()[19] > 14.9);  // the next critic was asked
      QVERIFY(!bench.hasFailed);
      for (int step = 4; step < 30; ++step) {
        bench.setPose(19, step, 1.01, 1.01);
        const std::size_t beyond = bench.columns.elementIndex(step, 25);
        bench.columns.x[beyond] = bench.columns.y[beyond] = 0.0F;  // padding does not count
      }
      const double cost = bench.all()[19];
      QVERIFY(bench.hasFailed);
      bench.mppi.settings.critics = {critic};
      compareTo(bench.all()[19], cost);  // the next critic was not asked
    }
  }

  /// d = -ln(c / 253) / 3 for the centre: c = 219: 0.0481 m, in the margin of 0.1; c = 31: 0.6998
  /// m.
  void obstacles_summands_byHand() {
    const double near = -std::log(219.0 / 253.0) / 3.0;
    const double far = -std::log(31.0 / 253.0) / 3.0;
    for (const Distro distro : {Distro::Humble, Distro::Main}) {
      const bool isHumble = distro == Distro::Humble;
      CriticBench bench("ObstaclesCritic", distro, 20);
      bench.mppi.critics.obstacles.costScaling = 3.0;  // Humble: the critic's own
      bench.mppi.critics.obstacles.inflationRadius = 0.7;
      Costmap& costmap = bench.scene.costmap;
      costmap.set(*costmap.worldToCell(Vec2(1.01, 1.01)), 219);
      costmap.set(*costmap.worldToCell(Vec2(0.51, 0.51)), 31);
      costmap.set(*costmap.worldToCell(Vec2(-1.01, -1.01)), 253);
      bench.setPoses(0.51, 0.51);
      for (int step = 0; step < 6; ++step) {
        bench.setPose(4, step, 1.01, 1.01);
      }
      bench.setPose(5, 7, -1.01, -1.01);
      const std::vector<double> costs = bench.all();
      const double all = 30.0 * (0.7 - far);
      if (isHumble) {  // no least is taken off; what is in the margin does not repel
        compareTo(costs[0], 1.5 * all / 30.0);
        compareTo(costs[4], 20.0 * 6.0 * (0.1 - near) + 1.5 * (24.0 * (0.7 - far)) / 30.0, 1e-3);
        compareTo(costs[5], 20.0 * 1e4 + 1.5 * 7.0 * (0.7 - far) / 30.0, 0.1);
      } else {  // the least repelled is the one that collides, after 7 steps
        compareTo(costs[0], 1.5 * 23.0 * (0.7 - far) / 30.0);
        const double repulsion = 6.0 * (0.7 - near) + 17.0 * (0.7 - far);
        compareTo(costs[4], 20.0 * 6.0 * (0.1 - near) + 1.5 * repulsion / 30.0, 1e-3);
        compareTo(costs[5], 20.0 * 1e5, 0.5);
      }
      bench.scene.goAhead(0.3, 5);  // near the goal nothing repels
      compareTo(bench.all()[4], 20.0 * 6.0 * (0.1 - near), 1e-3);
    }
  }

  /// Edges tell distances with the inscribed radius.
  void obstacles_footprint_countsFromTheEdge() {
    CriticBench bench("ObstaclesCritic", Distro::Jazzy, 20);
    bench.mppi.critics.obstacles.considersFootprint = true;
    bench.scene.shape.inflationRadius = 0.25;
    std::fill(bench.scene.costmap.costs().begin(), bench.scene.costmap.costs().end(), 160);
    bench.setPoses(1000.0, 0.0);  // off the map: a collision
    for (int step = 0; step < 30; ++step) {
      bench.setPose(0, step, 0.0, 0.0, 0.3);
    }
    bench.scene.shape.tracksUnknown = false;
    const double edge = 0.2 - std::log(160.0 / 253.0) / 3.0;
    QVERIFY(edge > 0.25);
    // The others have no repulsion, this one 30 (0.25 - d) < 0: it is the least.
    const std::vector<double> costs = bench.all();
    compareTo(costs[0], 0.0, 1e-4);
    compareTo(costs[1], 20.0 * 1e5 + 1.5 * (edge - 0.25), 0.5);
    bench.mppi.critics.obstacles.marginDistance = 0.5;
    compareTo(bench.all()[0], 20.0 * 30.0 * (0.5 - edge), 1e-2);
    bench.mppi.critics.obstacles.considersFootprint = false;
    compareTo(bench.all()[0], 20.0 * 30.0 * (0.5 - edge + 0.2) + 1.5 * (0.25 - edge + 0.2), 1e-2);
  }

  void disabled_anyCritic_isNotAsked() {
    MppiCriticSettings settings;
    visitCritics(settings, [](const char* name, const auto&) {
      CriticBench bench(name, Distro::Main, 20);
      bench.setSpeeds(-2.0, 3.0);
      visitCritics(bench.mppi.critics, [](const char*, auto& critic) { critic.isEnabled = false; });
      QCOMPARE(bench.each(), 0.0);
      QVERIFY(!bench.wasEvaluated);
    });
  }
};

QTEST_APPLESS_MAIN(Nav2MppiCriticsTest)
#include "tst_Nav2MppiCritics.moc"
