#include <cmath>
#include <string>

#include <QtTest>

#include "sim2d/nav/nav2/control/GracefulController.h"
#include "tests/nav/ControlScene.h"

using namespace control_scene;
using base::Vec2;
using sim2d::BodyTwist;

namespace {

constexpr char kGraceful[] = "nav2_graceful_controller::GracefulController";

Pose2 at(double x, double y, double heading = 0.0) {
  return {Vec2(x, y), heading};
}

/// Parameters of Nav2's test_egopolar.cpp.
GracefulParameters ofLawTests() {
  GracefulParameters p;
  p.kPhi = 1.0;
  p.kDelta = 10.0;
  p.beta = 0.2;
  p.lambda = 2.0;
  p.slowdownRadius = 0.1;
  p.maxDeceleration = 2.5;
  p.minLinear = 0.0;
  p.maxLinear = 1.0;
  p.maxAngular = 1.0;
  return p;
}

}  // namespace

class GracefulControllerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void egoPolar_vectors() {  // 14 to 16
    EgoPolar polar = egoPolar(at(3, 4, 0.8), at(1, 1, -0.2), false);
    QVERIFY(isNear(polar.r, 3.6055512, 1e-7));
    QVERIFY(isNear(polar.phi, -0.1827937, 1e-7));
    QVERIFY(isNear(polar.delta, -1.1827937, 1e-7));
    polar = egoPolar(at(3, 3, base::kPi), at(0, 0), false);
    QVERIFY(isNear(polar.r, 4.2426405, 1e-6));
    QVERIFY(isNear(polar.phi, 2.3561945, 1e-7));
    QVERIFY(isNear(polar.delta, -base::kPi / 4.0));
    polar = egoPolar(at(-3, -4, 0.8), at(1, 1, -0.2), true);
    QVERIFY(isNear(polar.r, 6.4031243, 1e-6));
    QVERIFY(isNear(polar.phi, -0.0960555, 1e-6));
    QVERIFY(isNear(polar.delta, -1.0960555, 1e-6));
  }

  void curvature_vectors() {  // 17, 18
    const GracefulParameters p = ofLawTests();
    QVERIFY(isNear(gracefulCurvature(p, egoPolar(at(0, 5), at(0, 0), false)), 5.407042, 1e-5));
    const EgoPolar other = egoPolar(at(4.5, -2.17, -0.785), at(0, 0), false);
    QVERIFY(isNear(gracefulCurvature(p, other), -0.416228, 1e-4));
  }

  void command_vectors() {  // 19, 20
    const GracefulParameters p = ofLawTests();
    BodyTwist twist = gracefulCommand(p, Distro::Main, at(0, 5), at(0, 0), false);
    QVERIFY(isNear(twist.linear, 0.1460446, 1e-5));
    QVERIFY(isNear(twist.angular, 0.7896695, 1e-5));
    twist = gracefulCommand(p, Distro::Main, at(4.5, -2.17, -0.785), at(0, 0), false);
    QVERIFY(isNear(twist.linear, 0.966512, 1e-4));
    QVERIFY(isNear(twist.angular, -0.4022844, 1e-4));
  }

  /// The same curve seen in a mirror: what lies ahead to the left lies behind to the left.
  void command_backward_mirrorsForward() {
    const GracefulParameters p;
    const BodyTwist ahead = gracefulCommand(p, Distro::Jazzy, at(1, 0.4, 0.3), at(0, 0), false);
    const BodyTwist back = gracefulCommand(p, Distro::Jazzy, at(-1, 0.4, -0.3), at(0, 0), true);
    QVERIFY(ahead.linear > 0.0);
    QVERIFY(isNear(back.linear, -ahead.linear));
    QVERIFY(isNear(back.angular, -ahead.angular));
  }

  void command_atTheTarget_isFinite() {
    const GracefulParameters p;
    for (const double heading : {0.0, 0.5}) {
      const BodyTwist twist = gracefulCommand(p, Distro::Jazzy, at(1, 1), at(1, 1, heading), false);
      QVERIFY(std::isfinite(twist.linear) && std::isfinite(twist.angular));
    }
  }

  void main_brakesByDeceleration() {
    GracefulParameters p;
    p.maxLinear = 3.0;
    p.slowdownRadius = 0.1;
    p.maxDeceleration = 1.0;
    // sqrt(2 * 0.5 * 1)
    QVERIFY(isNear(gracefulCommand(p, Distro::Main, at(0.5, 0), at(0, 0), false).linear, 1.0));
    QVERIFY(isNear(gracefulCommand(p, Distro::Jazzy, at(0.5, 0), at(0, 0), false).linear, 3.0));
  }

  void goalReached_turnsToItsHeading() {
    for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
      for (const auto& [heading, w] : {std::pair{1.0, 0.5}, {-0.8, -0.4}, {0.3, 0.25}}) {
        Scene scene(distro);
        scene.local = straight(0.2);
        scene.local.back().heading = heading;
        const auto controller = scene.make(kGraceful, {});
        controller->setPlan(scene.local);
        const ControlResult control = scene.run(*controller);
        QVERIFY(control);
        QCOMPARE(control.twist.linear, 0.0);
        QVERIFY(isNear(control.twist.angular, w));  // 0.5 * angle * 1 rad/s, at least 0.25
      }
    }
  }

  void goalReached_latchesUntilNewPath() {
    Scene scene;
    Path path = straight(0.2);
    path.back().heading = 1.0;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(path);
    scene.run(*controller);
    scene.robot.position.x() = -0.4;
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    path.insert(path.begin(), at(-0.4, 0.0));  // planned anew from where it is
    controller->setPlan(path);
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
  }

  /// A bar that cannot turn: what stands at its left is hit half way.
  void goalTurn_blocked_followsTheLaw() {
    Scene scene;
    scene.shape.isRadius = false;
    scene.shape.vertices = {{0.6, 0.05}, {-0.05, 0.05}, {-0.05, -0.05}, {0.6, -0.05}};
    Path path = straight(0.2);
    path.back().heading = 1.5;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(path);
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    scene.block(0.4, 0.4, 0.45, 0.45);
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QVERIFY(control.twist.linear > 0.0);
  }

  void newPathAside_turnsFirst_onceOnly() {
    Scene scene;
    Path path;
    for (int i = 0; i <= 24; ++i) {
      path.push_back(at(0.0, 0.05 * i, base::kPi / 2.0));
    }
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(path);
    ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QCOMPARE(control.twist.linear, 0.0);
    QVERIFY(isNear(control.twist.angular, 0.5 * base::kPi / 2.0));
    scene.robot.heading = 1.0;  // 0.57 are left: below 0.75
    control = scene.run(*controller);
    QVERIFY(control.twist.linear > 0.0);
    scene.robot.heading = 0.0;  // pushed back: it does not turn on the spot again
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    controller->setPlan(path);
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    const auto never = scene.make(kGraceful, {{"initial_rotation", false}});
    never->setPlan(path);
    QVERIFY(scene.run(*never).twist.linear > 0.0);
  }

  void target_isFarthestWithinLookahead() {
    Scene scene;
    const auto controller = scene.make(kGraceful, {{"max_lookahead", 0.82}});
    controller->setPlan(straight(1.4, 0.1));
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QVERIFY((controller->view().lookahead.at(0) - Vec2(0.8, 0.0)).norm() < 1e-9);
    QVERIFY(isNear(control.twist.linear, 0.5 * 0.8 / 1.5));  // slowdown_radius 1.5
    QVERIFY(isNear(control.twist.angular, 0.0));
  }

  void target_blocked_nearerOneIsTaken() {
    Scene scene;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(straight(1.4, 0.1));
    scene.block(0.7, -0.2, 0.8, 0.2, kInscribed);
    QVERIFY(scene.run(*controller));
    // Steps of 0.1 r/3 m, at least 0.01 m, 3 r/0.05 of them: towards 0.8 m they end at 0.69 m,
    // before the obstacle, towards 0.9 m at 0.82 m.
    QVERIFY(isNear(controller->view().lookahead.at(0).x(), 0.8, 1e-9));
  }

  void target_nearerThanLeast_isNone() {
    Scene scene;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(straight(1.4, 0.1));
    scene.block(0.1, -0.2, 0.3, 0.2, kInscribed);  // only 0.1 m can be reached: less than 0.25
    QCOMPARE(scene.run(*controller).code, ControllerError::NoValidControl);
    const auto near = scene.make(kGraceful, {{"min_lookahead", 0.1}});
    near->setPlan(straight(1.4, 0.1));
    QVERIFY(scene.run(*near));
  }

  void allBlocked_isNoValidControl() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      Scene scene(distro);
      scene.local = straight(1.4);
      const auto controller = scene.make(kGraceful, {});
      controller->setPlan(scene.local);
      scene.block(-2.0, -2.0, 2.0, 2.0, kInscribed);
      const ControlResult control = scene.run(*controller);
      QCOMPARE(control.code, ControllerError::NoValidControl);
      QCOMPARE(control.words, std::string("Collision detected in trajectory"));
    }
  }

  void polygon_edgesCount_notTheCentre() {
    Scene scene;
    scene.shape.isRadius = false;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(straight(1.4));
    scene.block(-2.0, -2.0, 2.0, 2.0, kInscribed);
    QVERIFY(scene.run(*controller));  // 253 on an edge is no collision
    scene.block(0.1, 0.2, 0.2, 0.25, kLethal);
    QVERIFY(!scene.run(*controller));
  }

  void unknown_isFreeWhenTracked() {
    Scene scene;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(straight(1.4));
    scene.block(-2.0, -2.0, 2.0, 2.0, kNoInformation);
    QVERIFY(!scene.run(*controller));
    scene.shape.tracksUnknown = true;
    QVERIFY(scene.run(*controller));
  }

  void backward_targetBehind_drivesBack() {
    Scene scene;
    Path path;
    for (int i = 0; i <= 24; ++i) {
      path.push_back(at(-0.05 * i, 0.0, base::kPi));
    }
    const auto controller =
        scene.make(kGraceful, {{"allow_backward", true}, {"initial_rotation", false}});
    controller->setPlan(path);
    const ControlResult control = scene.run(*controller);
    QVERIFY(control);
    QVERIFY(control.twist.linear < -0.1);
    QVERIFY(isNear(control.twist.angular, 0.0, 1e-6));
    QVERIFY(controller->view().predicted.back().position.x() < -0.5);
  }

  /// Planners without headings: poses look at the next one, unless any two differ.
  void equalHeadings_areThoseOfSegments() {
    const auto turnOf = [](double oneHeading, bool looksAhead) {
      Scene scene;
      Path path;
      for (int i = 0; i <= 30; ++i) {
        const double angle = 0.05 * i;
        path.push_back(
            at(std::sin(angle), 1.0 - std::cos(angle), looksAhead ? angle + 0.025 : 0.0));
      }
      path[7].heading = looksAhead ? path[7].heading : oneHeading;
      const auto controller = scene.make(kGraceful, {});
      controller->setPlan(path);
      return scene.run(*controller).twist.angular;
    };
    QVERIFY(isNear(turnOf(0.0, false), turnOf(0.0, true), 1e-6));
    QVERIFY(!isNear(turnOf(0.1, false), turnOf(0.0, true), 1e-2));
  }

  void speedLimit_scalesBothAxes() {
    GracefulController controller(GracefulParameters(), Distro::Jazzy);
    const auto holds = [&controller](double linear, double angular) {
      return isNear(controller.parameters().maxLinear, linear) &&
             isNear(controller.parameters().maxAngular, angular);
    };
    controller.setSpeedLimit(50.0, true);
    QVERIFY(holds(0.25, 0.5));
    controller.setSpeedLimit(0.3, false);
    QVERIFY(holds(0.3, 0.6));
    controller.setSpeedLimit(0.05, false);
    QVERIFY(holds(0.1, 0.1));  // no less than v_linear_min
    controller.setSpeedLimit(0.0, false);
    QVERIFY(holds(0.5, 1.0));
  }

  void humble_oneTarget_turnsWhenAside() {
    Scene scene(Distro::Humble);
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(straight(1.4, 0.25));
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    QVERIFY((controller->view().lookahead.at(0) - Vec2(0.75, 0.0)).norm() < 1e-9);  // >= 0.6
    scene.robot.heading = 1.0;  // more than 0.75 aside, whenever it is
    const ControlResult control = scene.run(*controller);
    QCOMPARE(control.twist.linear, 0.0);
    QVERIFY(isNear(control.twist.angular, -0.5));
  }

  void humble_atGoal_turnsToItsHeading() {
    Scene scene(Distro::Humble);
    Path path = straight(0.2);
    path.back().heading = 0.2;
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(path);
    QCOMPARE(scene.run(*controller).twist, (BodyTwist{0.0, 0.1}));  // no least angular velocity
    const auto without = scene.make(kGraceful, {{"final_rotation", false}});
    without->setPlan(path);
    QVERIFY(scene.run(*without).twist.linear > 0.0);
  }

  void main_targetIsInterpolated() {
    Scene scene(Distro::Main);
    scene.local = straight(1.4, 0.35);
    const auto controller = scene.make(kGraceful, {});
    controller->setPlan(scene.local);
    QVERIFY(scene.run(*controller));
    QVERIFY((controller->view().lookahead.at(0) - Vec2(1.0, 0.0)).norm() < 1e-9);
    scene.block(0.8, -0.2, 0.9, 0.2, kInscribed);  // then the poses before it
    QVERIFY(scene.run(*controller));
    QVERIFY((controller->view().lookahead.at(0) - Vec2(0.7, 0.0)).norm() < 1e-9);
  }

  /// At 1 m/s the polygon counts half as large again; at 0.7 m/s it passes.
  void main_footprintGrowsWithSpeed() {
    Scene scene(Distro::Main);
    scene.shape.isRadius = false;
    scene.shape.vertices = {{0.2, 0.2}, {-0.2, 0.2}, {-0.2, -0.2}, {0.2, -0.2}};
    scene.local = straight(1.4);
    const auto controller = scene.make(
        kGraceful,
        {{"v_linear_max", 1.0}, {"slowdown_radius", 0.1}, {"footprint_scaling_factor", 0.5}});
    controller->setPlan(scene.local);
    QVERIFY(isNear(scene.run(*controller).twist.linear, 1.0));
    scene.block(0.3, 0.25, 0.4, 0.3);
    // Sides at 0.2 (1 + (v - 0.5)) m, tried from 1 m/s down in steps of 0.1: free below 0.25
    QVERIFY(isNear(scene.run(*controller).twist.linear, 0.7));
    QVERIFY(isNear(controller->view().lookahead.at(0).x(), 1.0));
    // Before its front at 0.3 m: a step of 0.05 m to the target 0.1 m, and 0.24 m of body at 0.7
    // m/s
    scene.block(0.3, 0.1, 0.4, 0.3);
    QVERIFY(isNear(scene.run(*controller).twist.linear, 0.7));
    QVERIFY(isNear(controller->view().lookahead.at(0).x(), 0.1));
  }

  void main_withoutCollisionDetection_drivesOn() {
    Scene scene(Distro::Main);
    scene.local = straight(1.4);
    scene.block(-2.0, -2.0, 2.0, 2.0);
    const auto controller = scene.make(kGraceful, {{"use_collision_detection", false}});
    QVERIFY(scene.run(*controller));
  }

  void make_problems() {
    ControllerSetup setup;
    setup.block = {{"slowdown_radius", 0.0}, {"v_linear_max", -1.0}, {"beta", true}};
    const auto wrong = makeController(kGraceful, setup);
    QVERIFY(!wrong);
    QCOMPARE(wrong.diagnostics().size(), std::size_t{3});
    const ControllerType* type = findController(kGraceful);
    const Nav2KeyTable humble = type->keys({}, Distro::Humble);
    QCOMPARE(std::get<double>(humble.find("k_phi", Distro::Humble)->fallback), 3.0);
    QVERIFY(humble.find("max_lookahead", Distro::Humble) == nullptr);
    QVERIFY(humble.find("motion_target_dist", Distro::Humble) != nullptr);
  }
};

QTEST_APPLESS_MAIN(GracefulControllerTest)
#include "tst_GracefulController.moc"
