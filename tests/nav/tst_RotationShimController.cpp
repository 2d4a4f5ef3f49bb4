#include <cmath>
#include <string>

#include <QtTest>

#include "sim2d/nav/nav2/control/RotationShimController.h"
#include "tests/nav/ControlScene.h"

using namespace control_scene;
using base::Vec2;

namespace {

constexpr char kShim[] = "nav2_rotation_shim_controller::RotationShimController";
const std::string kInner = "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController";

/// With pursuit inside, which does not turn on the spot itself.
Nav2ParameterBlock shimBlock(Distro distro) {
  const char* key = distro == Distro::Main ? "primary_controller.plugin" : "primary_controller";
  return {{key, kInner}, {"use_rotate_to_heading", false}, {"use_collision_detection", false}};
}

bool turnsBy(const ControlResult& control, double w) {
  return control && control.twist.linear == 0.0 && isNear(control.twist.angular, w);
}

/// A path that leaves the origin under an angle.
Path leaving(double angle, double length = 1.2) {
  Path path;
  for (int i = 0; i * 0.05 <= length; ++i) {
    path.push_back({0.05 * i * base::directionOf(angle), angle});
  }
  return path;
}

}  // namespace

class RotationShimControllerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void pathAside_turns_thenHandsOver() {
    Scene scene;
    const auto controller = scene.make(kShim, shimBlock(scene.distro));
    controller->setPlan(leaving(1.5));
    QVERIFY(turnsBy(scene.run(*controller), 0.16));  // 3.2 rad/s^2 * 0.05 s
    scene.speed.angular = 1.75;
    scene.robot.heading = 1.1;  // sqrt(2 * 3.2 * 0.4) rad/s
    QVERIFY(isNear(scene.run(*controller).twist.angular, 1.6));
    scene.robot.heading = 1.2;  // 0.3 rad left: done
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    scene.robot.heading = 0.0;  // pushed: not before the next path
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    controller->setPlan(leaving(1.5));
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
  }

  void pathAhead_isHandedOverAtOnce() {
    Scene scene;
    const auto controller = scene.make(kShim, shimBlock(scene.distro));
    controller->setPlan(leaving(0.78));
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    controller->setPlan(leaving(-0.79));
    QVERIFY(turnsBy(scene.run(*controller), -0.16));
  }

  void turning_endsByDistro_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<bool>("turns");
    QTest::newRow("humble: at 0.785") << static_cast<int>(Distro::Humble) << false;
    QTest::newRow("jazzy: at 0.3925") << static_cast<int>(Distro::Jazzy) << true;
  }

  void turning_endsByDistro() {
    QFETCH(int, distro);
    QFETCH(bool, turns);
    Scene scene(static_cast<Distro>(distro));
    const auto controller = scene.make(kShim, shimBlock(scene.distro));
    controller->setPlan(leaving(1.0));
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    scene.robot.heading = 0.4;
    QCOMPARE(scene.run(*controller).twist.linear == 0.0, turns);
  }

  /// 0.4 m ahead, then to the left: 0.5 m from the start it goes under 0.64 rad, later more.
  void sampledPose_isFarEnoughFromTheStart() {
    Path path = straight(0.4);
    for (int i = 1; i <= 20; ++i) {
      path.push_back({Vec2(0.4, 0.05 * i), 1.57});
    }
    Scene scene;
    const auto controller = scene.make(kShim, shimBlock(scene.distro));
    controller->setPlan(path);
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    Nav2ParameterBlock far = shimBlock(scene.distro);
    far["forward_sampling_distance"] = 0.9;  // at (0.4, 0.81): 1.11 rad
    const auto farther = scene.make(kShim, far);
    farther->setPlan(path);
    QCOMPARE(scene.run(*farther).twist.linear, 0.0);
    far["forward_sampling_distance"] = 9.0;  // none: the last pose
    const auto farthest = scene.make(kShim, far);
    farthest->setPlan(path);
    QCOMPARE(scene.run(*farthest).twist.linear, 0.0);
  }

  void sweepBlocked_primaryDrives() {
    Scene scene;
    scene.shape.vertices = {{0.6, 0.05}, {-0.05, 0.05}, {-0.05, -0.05}, {0.6, -0.05}};  // a bar
    scene.speed.angular = 1.0;
    const auto controller = scene.make(kShim, shimBlock(scene.distro));
    scene.block(0.4, 0.4, 0.45, 0.45);
    controller->setPlan(leaving(1.5));  // 1.16 rad/s for 1 s meet it
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    Nav2ParameterBlock brief = shimBlock(scene.distro);
    brief["simulate_ahead_time"] = 0.3;
    const auto blind = scene.make(kShim, brief);
    blind->setPlan(leaving(1.5));
    QCOMPARE(scene.run(*blind).twist.linear, 0.0);
  }

  void costThreshold_countsSinceJazzy() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      Scene scene(distro);
      scene.block(-2.0, -2.0, 2.0, 2.0, 200);
      Nav2ParameterBlock block = shimBlock(distro);
      block["max_cost_threshold"] = 200;
      const auto controller = scene.make(kShim, block);
      controller->setPlan(leaving(1.5));
      QCOMPARE(scene.run(*controller).twist.linear == 0.0, distro == Distro::Humble);
    }
  }

  void goalReached_turnsToItsHeading() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      Scene scene(distro);
      Nav2ParameterBlock block = shimBlock(distro);
      scene.local = straight(0.2);
      scene.local.back().heading = -1.0;
      const auto without = scene.make(kShim, block);
      without->setPlan(scene.local);
      QVERIFY(scene.run(*without).twist.linear > 0.0);
      block["rotate_to_goal_heading"] = true;
      const auto controller = scene.make(kShim, block);
      controller->setPlan(scene.local);
      QVERIFY(turnsBy(scene.run(*controller), -0.16));
      scene.robot.position.x() = -0.1;
      scene.checker->reset();
      QVERIFY(scene.run(*controller).twist.linear > 0.0);
    }
  }

  void once_sameGoal_isHandedOver() {
    Scene scene;
    Nav2ParameterBlock block = shimBlock(scene.distro);
    block["rotate_to_heading_once"] = true;
    const auto controller = scene.make(kShim, block);
    controller->setPlan(leaving(1.5));
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
    scene.robot.heading = 1.5;
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    scene.robot.heading = 0.0;
    controller->setPlan(leaving(1.5));  // the same goal
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    controller->setPlan(leaving(1.4));
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
  }

  void pathOrientations_areTaken() {
    Scene scene;
    Nav2ParameterBlock block = shimBlock(scene.distro);
    Path path = leaving(0.0);
    for (Pose2& pose : path) {
      pose.heading = -1.2;
    }
    const auto without = scene.make(kShim, block);
    without->setPlan(path);
    QVERIFY(scene.run(*without).twist.linear > 0.0);
    block["use_path_orientations"] = true;
    const auto controller = scene.make(kShim, block);
    controller->setPlan(path);
    QVERIFY(turnsBy(scene.run(*controller), -0.16));
  }

  void openLoop_goesByWhatWasSent() {
    Scene scene;
    Nav2ParameterBlock block = shimBlock(scene.distro);
    block["closed_loop"] = false;
    const auto controller = scene.make(kShim, block);
    controller->setPlan(leaving(1.5));
    QVERIFY(isNear(scene.run(*controller).twist.angular, 0.16));
    QVERIFY(isNear(scene.run(*controller).twist.angular, 0.32));  // though it is said to stand
    controller->reset();
    QVERIFY(isNear(scene.run(*controller).twist.angular, 0.16));
  }

  void main_testsLocalPathEachCycle() {
    Scene scene(Distro::Main);
    const auto controller = scene.make(kShim, shimBlock(scene.distro));
    controller->setPlan(leaving(0.0));
    scene.local = leaving(0.0);
    QVERIFY(scene.run(*controller).twist.linear > 0.0);
    scene.local = leaving(1.5);
    QCOMPARE(scene.run(*controller).twist.linear, 0.0);
  }

  void speedLimitAndCancel_reachThePrimary() {
    Scene scene;
    Nav2ParameterBlock block = shimBlock(scene.distro);
    block["use_cancel_deceleration"] = true;
    const auto controller = scene.make(kShim, block);
    controller->setPlan(leaving(0.0));
    controller->setSpeedLimit(0.3, false);
    QVERIFY(isNear(scene.run(*controller).twist.linear, 0.3));
    QVERIFY(!controller->cancel());
    QCOMPARE(controller->view().lookahead.size(), std::size_t{1});
  }

  void make_problems() {
    ControllerSetup setup;
    QCOMPARE(makeController(kShim, setup).diagnostics()[0].code,
             std::string_view("nav2.missing-key"));
    setup.block = {{"primary_controller", std::string(kShim)}};
    QCOMPARE(makeController(kShim, setup).diagnostics()[0].code,
             std::string_view("nav2.wrong-value"));
    setup.block = {{"primary_controller", std::string("dwb_core::DWBLocalPlaner")}};
    QCOMPARE(makeController(kShim, setup).diagnostics()[0].value("nearest"),
             std::string("dwb_core::DWBLocalPlanner"));
  }

  void keys_holdThePrimarys() {
    const ControllerType* type = findController(kShim);
    const Nav2KeyTable keys = type->keys(shimBlock(Distro::Main), Distro::Main);
    QVERIFY(keys.find("lookahead_dist", Distro::Main) != nullptr);
    QVERIFY(keys.find("primary_controller.lookahead_dist", Distro::Main) != nullptr);
    QVERIFY(keys.find("primary_controller", Distro::Main) == nullptr);
    Scene scene(Distro::Main);
    Nav2ParameterBlock block = shimBlock(Distro::Main);
    block["primary_controller.max_linear_vel"] = 0.4;
    scene.local = leaving(0.0);
    QVERIFY(isNear(scene.run(*scene.make(kShim, block)).twist.linear, 0.4));
  }
};

QTEST_APPLESS_MAIN(RotationShimControllerTest)
#include "tst_RotationShimController.moc"
