#include <cmath>

#include <QtTest>

#include "sim2d/nav/nav2/control/ControllerUtils.h"
#include "sim2d/nav/nav2/control/RegulatedPurePursuit.h"
#include "sim2d/nav/nav2/control/RegulationFunctions.h"
#include "tests/nav/ControlScene.h"

using namespace control_scene;
using base::Vec2;
using sim2d::BodyTwist;

namespace {

constexpr char kPursuit[] =
    "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";

/// Bounds that leave a command alone: free cell, long path.
SpeedRegulation freely(double curvature) {
  SpeedRegulation regulation;
  regulation.curvature = curvature;
  regulation.inscribedRadius = 0.2;
  regulation.pathLength = 1.6;
  regulation.goalDistance = 1.6;
  return regulation;
}

}  // namespace

class RegulatedPurePursuitTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // Vectors of Nav2's test_regulated_pp.cpp

  void speedLimit_absoluteShareLifted() {  // vector 1
    RegulatedPurePursuit controller(PursuitParameters(), Distro::Jazzy, 20.0);
    controller.setSpeedLimit(0.51, false);
    QCOMPARE(controller.parameters().maxLinearVelocity, 0.51);
    controller.setSpeedLimit(30.0, true);
    QVERIFY(isNear(controller.parameters().maxLinearVelocity, 0.3 * 0.5));
    controller.setSpeedLimit(0.0, true);
    QCOMPARE(controller.parameters().maxLinearVelocity, 0.5);
  }

  void lookahead_fixedAndScaled() {  // 2, 3
    PursuitParameters p;
    QCOMPARE(lookaheadDistance(p, 0.0), 0.6);
    QCOMPARE(lookaheadDistance(p, 10.0), 0.6);
    p.usesVelocityScaledLookahead = true;
    QCOMPARE(lookaheadDistance(p, 10.0), 0.9);
    QVERIFY(isNear(lookaheadDistance(p, 0.35), 0.525));
    QVERIFY(isNear(lookaheadDistance(p, -0.35), 0.525));
    QCOMPARE(lookaheadDistance(p, 0.0), 0.3);
  }

  void turn_reachesBrakesAndAccelerates() {  // 6, 7
    const RotationLimits turn;               // 1.8 rad/s, 3.2 rad/s^2
    QVERIFY(isNear(rotationVelocity(turn, 0.4, 1.75, 0.05), 1.6));
    QVERIFY(isNear(rotationVelocity(turn, -0.4, -1.75, 0.05), -1.6));
    QVERIFY(isNear(rotationVelocity(turn, 0.4, 0.0, 0.05), 0.16));
    QVERIFY(isNear(rotationVelocity(turn, 0.4, 1.0, 0.05), 1.16));
    QVERIFY(isNear(rotationVelocity(turn, -0.4, 1.0, 0.05), 0.84));
  }

  void regulatedSpeed_vectors() {  // 8, 11
    const PursuitParameters p;
    QCOMPARE(regulatedSpeed(p, Distro::Jazzy, 0.0, freely(0.5)), 0.25);
    QCOMPARE(regulatedSpeed(p, Distro::Jazzy, 1.0, freely(0.7407)), 0.5);
    QCOMPARE(regulatedSpeed(p, Distro::Jazzy, 1.0, freely(1000.0)), 0.25);
    SpeedRegulation atGoal = freely(0.0);
    atGoal.pathLength = 0.0;
    atGoal.goalDistance = 0.0;
    QCOMPARE(regulatedSpeed(p, Distro::Jazzy, 1.0, atGoal), 0.05);
    SpeedRegulation back = freely(0.0);
    back.sign = -1.0;
    QCOMPARE(regulatedSpeed(p, Distro::Jazzy, 0.5, back), -0.5);
  }

  void circleSegment_vectors() {  // 13
    const auto meets = [](const Vec2& from, const Vec2& to, double radius, const Vec2& at) {
      return (circleSegmentIntersection(from, to, radius) - at).norm() < 1e-9;
    };
    QVERIFY(meets({0.0, 0.0}, {2.0, 0.0}, 1.0, {1.0, 0.0}));
    QVERIFY(meets({0.0, 0.0}, {0.0, -2.0}, 1.0, {0.0, -1.0}));
    QVERIFY(meets({4.0, 0.0}, {-1.0, 0.0}, 2.0, {2.0, 0.0}));
    QVERIFY(meets({0.0, 4.0}, {0.0, -0.5}, 2.0, {0.0, 2.0}));
  }

  void dynamicWindow_fromRest_isOneStep() {  // 12
    Scene scene(Distro::Main);
    const auto controller = scene.make(kPursuit, {{"use_dynamic_window", true}});
    scene.local = straight(1.4);
    controller->setPlan(scene.local);
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QVERIFY(isNear(control.twist.linear, 0.125));  // 2.5 m/s^2 * 0.05 s
    QCOMPARE(control.twist.angular, 0.0);
  }

  void command_carrotAside_turnsOnTheSpot_data() {  // 4
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<bool>("turns");
    QTest::newRow("ahead") << 0.5 << 0.25 << false;
    QTest::newRow("aside") << 0.5 << 1.0 << true;
  }

  void command_carrotAside_turnsOnTheSpot() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(bool, turns);
    Scene scene;
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan({Pose2{}, Pose2{Vec2(x, y), 0.0}});
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QCOMPARE(control.twist.linear == 0.0, turns);
    if (turns) {
      QVERIFY(isNear(control.twist.angular, 0.16));  // 3.2 rad/s^2 * 0.05 s
    }
  }

  void command_nearGoal_turnsToItsHeading_data() {  // 5
    QTest::addColumn<double>("distance");
    QTest::addColumn<bool>("turns");
    QTest::newRow("within the tolerance of 0.25 m") << 0.24 << true;
    QTest::newRow("outside") << 0.26 << false;
  }

  void command_nearGoal_turnsToItsHeading() {
    QFETCH(double, distance);
    QFETCH(bool, turns);
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      Scene scene(distro);
      scene.local = {Pose2{}, Pose2{Vec2(distance, 0.0), -1.0}};
      const auto controller = scene.make(kPursuit, {});
      controller->setPlan(scene.local);
      const ControlResult control = scene.run(*controller);
      QVERIFY(control);
      QCOMPARE(control.twist.linear == 0.0, turns);
      QVERIFY(isNear(control.twist.angular, turns ? -0.16 : 0.0));
    }
  }

  void command_goalLeft_latchOfDistro_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<bool>("isStateful");
    QTest::addColumn<bool>("turns");
    QTest::newRow("humble") << static_cast<int>(Distro::Humble) << true << false;
    QTest::newRow("jazzy") << static_cast<int>(Distro::Jazzy) << true << true;
    QTest::newRow("jazzy, not stateful") << static_cast<int>(Distro::Jazzy) << false << false;
    QTest::newRow("main: by the checker") << static_cast<int>(Distro::Main) << true << true;
  }

  /// At the goal once, then pushed 0.4 m back.
  void command_goalLeft_latchOfDistro() {
    QFETCH(int, distro);
    QFETCH(bool, isStateful);
    QFETCH(bool, turns);
    Scene scene(static_cast<Distro>(distro));
    const auto controller = scene.make(kPursuit, scene.distro == Distro::Jazzy
                                                     ? Nav2ParameterBlock{{"stateful", isStateful}}
                                                     : Nav2ParameterBlock{});
    scene.local = {Pose2{}, Pose2{Vec2(0.2, 0.0), 1.0}};
    controller->setPlan(scene.local);
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    scene.robot.position.x() = -0.2;
    QCOMPARE(scene.run(*controller).twist.linear == 0.0, turns);
    controller->setPlan(scene.local);  // a new path: not there yet
    scene.checker->reset();
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
  }
  // By hand

  void curvature_ofPoints() {
    QVERIFY(isNear(curvatureTo({0.5, 0.5}), 2.0));  // a quarter of a circle of 0.5 m
    QVERIFY(isNear(curvatureTo({1.0, -1.0}), -1.0));
    QCOMPARE(curvatureTo({1.0, 0.0}), 0.0);
    QCOMPARE(curvatureTo({0.0, 0.03}), 0.0);  // 0.0009 m^2
  }

  void cusp_distanceToFirst() {
    Path path = straight(1.0, 0.25);
    QCOMPARE(distanceToCusp(path), std::numeric_limits<double>::infinity());
    path.push_back({Vec2(0.75, 0.1), 0.0});  // back
    QVERIFY(isNear(distanceToCusp(path), 1.0));
    Path turning = straight(1.0, 0.25);
    turning.insert(turning.begin() + 3, Pose2{turning[2].position, 1.0});  // a turn at 0.5 m
    QVERIFY(isNear(distanceToCusp(turning), 0.5));
    Path doubled = straight(1.0, 0.25);
    doubled.insert(doubled.begin() + 3, doubled[2]);  // the same pose twice is no turn
    QCOMPARE(distanceToCusp(doubled), std::numeric_limits<double>::infinity());
  }

  void carrot_beforeBetweenBeyond() {
    const Path path = straight(1.0, 0.25);
    QVERIFY((carrotAt(path, 0.6, true, false) - Vec2(0.6, 0.0)).norm() < 1e-12);
    QVERIFY((carrotAt(path, 0.6, false, false) - Vec2(0.75, 0.0)).norm() < 1e-12);
    QVERIFY((carrotAt(path, 3.0, true, false) - Vec2(1.0, 0.0)).norm() < 1e-12);
    QVERIFY((carrotAt(path, 3.0, true, true) - Vec2(3.0, 0.0)).norm() < 1e-12);
    QVERIFY((carrotAt({Pose2{Vec2(0.0, 2.0), 0.0}}, 1.0, true, true) - Vec2(0.0, 2.0)).norm() <
            1e-12);
  }

  void costSpeed_byDistro_data() {
    QTest::addColumn<int>("cost");
    QTest::addColumn<double>("humble");
    QTest::addColumn<double>("jazzy");
    // r_in 0.2 m, factor 3, v 0.5: d = 0.2 - ln(c/252 or c/253)/3, v d/0.6 when d < 0.6
    QTest::newRow("free") << 0 << 0.5 << 0.5;
    QTest::newRow("unknown") << 255 << 0.5 << 0.5;
    QTest::newRow("far: d 0.67, 0.68") << 61 << 0.5 << 0.5;
    QTest::newRow("128") << 128 << 0.35483301 << 0.35593312;
    QTest::newRow("252") << 252 << 0.16666667 << 0.16776678;
  }

  void costSpeed_byDistro() {
    QFETCH(int, cost);
    QFETCH(double, humble);
    QFETCH(double, jazzy);
    SpeedRegulation regulation = freely(0.0);
    regulation.cost = static_cast<std::uint8_t>(cost);
    const PursuitParameters p;
    QVERIFY(isNear(costSpeed(p, Distro::Humble, 0.5, regulation), humble, 1e-7));
    QVERIFY(isNear(costSpeed(p, Distro::Jazzy, 0.5, regulation), jazzy, 1e-7));
    QVERIFY(isNear(costSpeed(p, Distro::Main, 0.5, regulation), jazzy, 1e-7));
  }

  void approachSpeed_slowsDownButNotBelow() {
    const PursuitParameters p;
    SpeedRegulation regulation = freely(0.0);
    QCOMPARE(approachSpeed(p, 0.5, regulation), 0.5);
    regulation.pathLength = 0.5;
    regulation.goalDistance = 0.3;
    QVERIFY(isNear(approachSpeed(p, 0.5, regulation), 0.25));
    regulation.goalDistance = 0.03;
    QCOMPARE(approachSpeed(p, 0.5, regulation), 0.05);
    QCOMPARE(approachSpeed(p, 0.04, regulation), 0.04);  // never faster than before
  }

  void command_straight_isDesiredSpeed() {
    Scene scene;
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan(straight(1.4));
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QCOMPARE(control.twist, (BodyTwist{0.5, 0.0}));
    QCOMPARE(controller->view().lookahead.size(), std::size_t{1});
    QVERIFY((controller->view().lookahead[0] - Vec2(0.6, 0.0)).norm() < 1e-12);
  }

  /// A carrot on a circle of 0.5 m: v = 0.5 * 0.5/0.9, omega = v/0.5.
  void command_arc_followsCircle() {
    Scene scene;
    const auto controller = scene.make(kPursuit, {{"use_rotate_to_heading", false}});
    Path path;
    for (int i = 0; i <= 300; ++i) {
      const double angle = 0.01 * i;
      path.push_back({Vec2(0.5 * std::sin(angle), 0.5 - 0.5 * std::cos(angle)), angle});
    }
    controller->setPlan(path);
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QVERIFY(isNear(control.twist.linear, 0.5 * 0.5 / 0.9, 1e-4));
    QVERIFY(isNear(control.twist.angular, control.twist.linear / 0.5, 1e-3));
  }

  void command_obstacleAhead_isNoValidControl() {
    Scene scene;
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan(straight(1.4));
    scene.block(0.5, -0.1, 0.6, 0.1);  // met 0.5 m + 0.23 m ahead at most
    const ControlResult control = scene.run(*controller);
    QCOMPARE(control.code, ControllerError::NoValidControl);
    QCOMPARE(control.words,
             std::string("RegulatedPurePursuitController detected collision ahead!"));
    QCOMPARE(control.twist, BodyTwist());
    const auto blind = scene.make(kPursuit, {{"use_collision_detection", false}});
    blind->setPlan(straight(1.4));
    QVERIFY(scene.run(*blind));
  }

  /// 0.5 m/s for 1 s and a carrot at 0.6 m: the footprint's front comes to 0.5 + 0.23 m.
  void command_obstacleBehindCarrot_isNone() {
    Scene scene;
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan(straight(1.4));
    scene.block(0.8, -0.1, 0.9, 0.1);
    QVERIFY(scene.run(*controller));
    const auto patient = scene.make(
        kPursuit, {{"max_allowed_time_to_collision_up_to_carrot", 3.0}, {"lookahead_dist", 1.0}});
    patient->setPlan(straight(1.4));
    QVERIFY(!scene.run(*patient));
  }

  /// Turning, the distance driven stays 0: the sweep goes on for the whole time.
  void command_slowTurn_sweepsAllTheTime() {
    Scene scene;
    scene.shape.vertices = {{0.6, 0.05}, {-0.05, 0.05}, {-0.05, -0.05}, {0.6, -0.05}};  // a bar
    scene.shape.circumscribedRadius = 0.6021;
    scene.speed.angular = 1.8;
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan({Pose2{}, Pose2{Vec2(-0.5, 0.5), 0.0}, Pose2{Vec2(-1.0, 1.0), 0.0}});
    QVERIFY(scene.run(*controller));
    scene.block(0.1, 0.5, 0.2, 0.6);  // about 75 degrees to the left: 1.8 rad/s for 1 s reach 103
    QCOMPARE(scene.run(*controller).code, ControllerError::NoValidControl);
  }

  void command_unknownAhead_isFreeOnlyWhenTracked() {
    Scene scene;
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan(straight(1.4));
    scene.block(0.5, -0.1, 0.6, 0.1, kNoInformation);
    QVERIFY(!scene.run(*controller));
    scene.shape.tracksUnknown = true;
    QVERIFY(scene.run(*controller));
  }

  void command_offTheMap_isAnError() {
    Scene scene;
    scene.robot.position = {5.0, 0.0};
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan({Pose2{Vec2(5.0, 0.0), 0.0}, Pose2{Vec2(6.0, 0.0), 0.0}});
    QCOMPARE(scene.run(*controller).code, ControllerError::Unknown);
  }

  void command_emptyPath_isInvalidPath() {
    Scene scene;
    const auto controller = scene.make(kPursuit, {});
    QCOMPARE(scene.run(*controller).code, ControllerError::InvalidPath);
    QCOMPARE(scene.run(*controller).words, std::string("Received plan with zero length"));
    scene.robot.position = {5.0, 0.0};  // every pose is out of reach
    controller->setPlan(straight(1.0));
    QCOMPARE(scene.run(*controller).words, std::string("Resulting plan has 0 poses in it."));
  }

  /// Back 0.3 m, then ahead to a place in front of the robot.
  void command_cusp_reversesUntilJazzy() {
    Path path;
    for (const double x : {0.0, -0.1, -0.2, -0.3}) {
      path.push_back({Vec2(x, 0.0), 0.0});
    }
    for (const double x : {-0.2, 0.0, 0.2, 0.4, 0.6, 0.8}) {
      path.push_back({Vec2(x, 0.001), 0.0});
    }
    const Nav2ParameterBlock block{{"allow_reversing", true}, {"use_rotate_to_heading", false}};
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      Scene scene(distro);
      const auto controller = scene.make(kPursuit, block);
      scene.local = path;
      controller->setPlan(path);
      const ControlResult control = scene.run(*controller);
      QVERIFY(control);
      // Main does not look for cusps here: its carrot lies 0.6 m ahead, behind the cusp.
      QCOMPARE(control.twist.linear, distro == Distro::Main ? 0.5 : -0.5);
    }
  }

  void command_fixedCurvature_turnsByItsOwnCarrot() {
    Scene scene;
    Path path = straight(0.6, 0.1);
    for (int i = 1; i <= 6; ++i) {
      path.push_back({Vec2(0.6, 0.1 * i), 0.0});  // then to the left
    }
    const auto fixed = scene.make(kPursuit, {{"use_fixed_curvature_lookahead", true},
                                             {"curvature_lookahead_dist", 0.7},
                                             {"lookahead_dist", 0.4}});
    fixed->setPlan(path);
    const ControlResult control = scene.run(*fixed);
    QVERIFY(control);
    // Where the way crosses the circle of 0.7 m: (0.6, sqrt(0.13)); kappa = 2 y/0.49
    const double curvature = 2.0 * std::sqrt(0.13) / 0.49;
    const double v = 0.5 * (1.0 / curvature) / 0.9;
    QVERIFY(isNear(control.twist.linear, v, 1e-9));
    QVERIFY(isNear(control.twist.angular, v * curvature, 1e-9));
    QCOMPARE(fixed->view().lookahead.size(), std::size_t{2});
  }

  void cancel_deceleratesToStanding() {
    Scene scene;
    const auto atOnce = scene.make(kPursuit, {});
    QVERIFY(atOnce->cancel());
    const auto controller =
        scene.make(kPursuit, {{"use_cancel_deceleration", true}, {"cancel_deceleration", 2.0}});
    controller->setPlan(straight(1.4));
    QVERIFY(!controller->cancel());
    scene.speed.linear = 0.5;
    QVERIFY(isNear(scene.run(*controller).twist.linear, 0.4));  // 0.5 - 2 * 0.05
    QVERIFY(!controller->cancel());
    scene.speed.linear = 0.1;
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    QVERIFY(controller->cancel());
    controller->reset();
    QCOMPARE(scene.run(*controller).twist.linear, 0.5);
  }

  /// The handler ends the local path at a cusp: that is no place to turn to the goal's heading.
  void main_endOfLocalPath_isNotTheGoal() {
    Scene scene(Distro::Main);
    const auto controller = scene.make(kPursuit, {});
    controller->setPlan(straight(3.0));
    scene.local = straight(0.2);
    scene.local.back().heading = 1.0;
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
  }

  /// Main: min_distance_to_obstacle 1 m at 0.5 m/s makes 2 s of the time.
  void main_lookaheadTime_growsWithDistance() {
    Scene scene(Distro::Main);
    scene.local = straight(1.4);
    scene.block(0.8, -0.1, 0.9, 0.1);
    const Nav2ParameterBlock block{{"lookahead_dist", 1.2}};
    QVERIFY(scene.run(*scene.make(kPursuit, block)));
    Nav2ParameterBlock far = block;
    far["min_distance_to_obstacle"] = 1.0;
    QVERIFY(!scene.run(*scene.make(kPursuit, far)));
  }

  void make_contradictions_areSwitchedOff() {
    ControllerSetup setup;
    setup.block = {{"allow_reversing", true}, {"interpolate_curvature_after_goal", true}};
    const auto made = makeController(kPursuit, setup);
    QVERIFY(made);
    QCOMPARE(made.diagnostics().size(), std::size_t{2});
    QCOMPARE(made.diagnostics()[0].code, std::string_view("nav2.not-both"));
    QCOMPARE(made.diagnostics()[1].code, std::string_view("nav2.not-without"));
    setup.block = {{"inflation_cost_scaling_factor", 0.0}, {"lookahead_dist", 1}};
    const auto refused = makeController(kPursuit, setup);
    QVERIFY(!refused);
    QCOMPARE(refused.diagnostics().size(), std::size_t{2});
    QCOMPARE(refused.diagnostics()[0].code, std::string_view("nav2.wrong-type"));
    QCOMPARE(refused.diagnostics()[1].code, std::string_view("nav2.scaling-off"));
  }

  void dynamicWindow_noCrossing_takesNearestCorner() {
    const VelocityWindow window{0.3, 0.5, -0.1, 0.1};
    // omega = 2 v leaves the window below: |2 v - omega| is least at (0.3, 0.1)
    QCOMPARE(bestInWindow(window, 2.0, 1.0), (BodyTwist{0.3, 0.1}));
    // omega = 0.25 v: crosses at v = 0.4 (omega 0.1), the fastest
    const BodyTwist crossing = bestInWindow(window, 0.25, 1.0);
    QVERIFY(isNear(crossing.linear, 0.4) && isNear(crossing.angular, 0.1));
    QCOMPARE(bestInWindow(window, 0.0, 1.0), (BodyTwist{0.5, 0.0}));
    QCOMPARE(bestInWindow({0.3, 0.5, 0.2, 0.4}, 0.0, 1.0), (BodyTwist{0.5, 0.2}));
    PursuitParameters p;
    const VelocityWindow reached = velocityWindow(p, {0.2, -0.2}, 0.05);
    QVERIFY(isNear(reached.maxLinear, 0.325) && isNear(reached.minLinear, 0.075));
    QVERIFY(isNear(reached.maxAngular, -0.04) && isNear(reached.minAngular, -0.36));
    const VelocityWindow slow = regulatedWindow(reached, 0.05);  // cannot brake so fast
    QVERIFY(isNear(slow.maxLinear, 0.075) && isNear(slow.minLinear, 0.075));
  }
};

QTEST_APPLESS_MAIN(RegulatedPurePursuitTest)
#include "tst_RegulatedPurePursuit.moc"
