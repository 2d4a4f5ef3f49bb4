#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/ControllerRegistry.h"
#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "sim2d/nav/nav2/control/PathHandler.h"
#include "sim2d/nav/nav2/mppi/MppiSettings.h"
#include "tests/nav/Nav2MppiScenes.h"

using namespace sim2d::nav2;
using nav2test::HandScene;
using sim2d::BodyTwist;

namespace {

const char kMppi[] = "nav2_mppi_controller::MPPIController";

Nav2ParameterBlock stockBlock() {
  return {{"critics", nav2test::stockCritics()}, {"batch_size", 200}};
}

std::unique_ptr<Controller> made(Distro distro, const Nav2ParameterBlock& block = stockBlock(),
                                 double frequency = 20.0) {
  ControllerSetup setup;
  setup.distro = distro;
  setup.block = block;
  setup.frequency = frequency;
  auto result = makeController(kMppi, setup);
  return result ? std::move(*result) : nullptr;
}

/// A robot with its controller.
struct Driver {
  explicit Driver(Distro distro, std::unique_ptr<Controller> drives)
      : controller(std::move(drives)),
        checker(std::move(*makeGoalChecker("nav2_controller::SimpleGoalChecker", distro, {}))) {
    scene.goAhead(6.0, 121);
    controller->setPlan(scene.path);
  }
  ControlResult command(const Path* local = nullptr) {
    ControlInput input{scene.robot, scene.speed, scene.costmap, scene.shape, *checker, time};
    input.localPlan = local;
    time += 0.05;
    return controller->computeVelocityCommands(input);
  }

  HandScene scene;
  std::unique_ptr<Controller> controller;
  std::unique_ptr<GoalChecker> checker;
  double time = 100.0;
};

std::vector<std::string> problemsOf(const base::Diagnostics& diagnostics) {
  std::vector<std::string> texts;
  for (const base::Diagnostic& problem : diagnostics) {
    texts.push_back(problem.text());
  }
  return texts;
}

}  // namespace

/// nav2_mppi_controller::MPPIController: what it reads, refuses, follows and shows.
class Nav2MppiControllerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Each key given anew arrives in the struct: another value than the default comes back.
  void read_everyKey_isTaken() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      Nav2ParameterBlock block;
      block["critics"] = nav2test::stockCritics();
      for (const Nav2KeyTable::Row& row : mppiKeysOf(block, distro).rows) {
        if (!includesDistro(row.distros, distro)) {
          continue;
        }
        if (const double* number = std::get_if<double>(&row.fallback)) {
          block[row.name] = *number * 0.5;
        } else if (const bool* flag = std::get_if<bool>(&row.fallback)) {
          block[row.name] = !*flag;
        }
      }
      const auto mppi = readMppi(block, distro);
      QVERIFY2(mppi, mppi.diagnostics().empty() ? "" : mppi.diagnostics()[0].text().c_str());
      QCOMPARE(mppi->settings.modelDt, 0.025);
      QCOMPARE(mppi->settings.vxMin, -0.175);
      QCOMPARE(mppi->settings.minTurningRadius, 0.1);
      QCOMPARE(mppi->settings.axMin, distro == Distro::Humble ? -3.0 : -1.5);
      QCOMPARE(mppi->settings.vyStd, 0.1);
      QCOMPARE(mppi->settings.isOpenLoop, distro != Distro::Humble);
      QCOMPARE(mppi->settings.clampsRawControls, distro == Distro::Main);
      QVERIFY(mppi->settings.regeneratesNoises);
      QCOMPARE(mppi->critics.cost.weight, 1.905);
      QVERIFY(mppi->critics.cost.considersFootprint);
      QVERIFY(!mppi->critics.preferForward.isEnabled);
      QCOMPARE(mppi->critics.pathAlign.maxPathOccupancyRatio, 0.035);
      QCOMPARE(mppi->critics.twirling.weight, 10.0);
    }
  }

  void read_badBlock_tellsEveryProblem() {
    Nav2ParameterBlock block = stockBlock();
    block["critics"] = std::vector<std::string>{"CostCritc", "PathAlignLegacyCritic", "GoalCritic"};
    block["vx_max"] = 1;  // an integer is no double
    block["time_steps"] = 1;
    block["temperature"] = 0.0;
    block["motion_model"] = std::string("Diff");
    block["PathAngleCritic.mode"] = 3;
    block["CostCritic.critical_cost"] = std::numeric_limits<double>::infinity();
    block["VelocityDeadbandCritic.deadband_velocities"] = std::vector<double>{0.1};
    const auto mppi = readMppi(block, Distro::Jazzy);
    QVERIFY(!mppi);
    const auto texts = problemsOf(mppi.diagnostics());
    QCOMPARE(texts.size(), std::size_t(9));
    const auto has = [&](const char* part) {
      return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
        return text.find(part) != std::string::npos;
      });
    };
    QVERIFY(has("unknown plugin 'CostCritc' (did you mean 'CostCritic'?"));
    QVERIFY(has("'PathAlignLegacyCritic'"));
    QVERIFY(has("vx_max has an invalid type"));
    QVERIFY(has("time_steps 1 is not 2 to 200"));
    QVERIFY(has("temperature 0 is not greater than 0"));
    QVERIFY(has("'Diff'"));
    QVERIFY(has("PathAngleCritic.mode 3 is not 0 to 2"));
    QVERIFY(has("deadband_velocities"));
    QVERIFY(has("CostCritic.critical_cost"));
  }

  void read_motionModel_byRelease() {
    Nav2ParameterBlock block = stockBlock();
    block["motion_model"] = std::string("Ackermann");
    block["AckermannConstraints.min_turning_r"] = 0.7;
    QCOMPARE(readMppi(block, Distro::Jazzy)->motion, MppiMotion::Ackermann);
    QCOMPARE(readMppi(block, Distro::Jazzy)->settings.minTurningRadius, 0.7);
    block["motion_model"] = std::string("car");
    QVERIFY(!readMppi(block, Distro::Jazzy));
    QVERIFY(!readMppi(block, Distro::Main));
    block["car.plugin"] = std::string("mppi::AckermannMotionModel");
    block["car.min_turning_r"] = 0.9;
    QVERIFY(!readMppi(block, Distro::Jazzy));
    QCOMPARE(readMppi(block, Distro::Main)->motion, MppiMotion::Ackermann);
    QCOMPARE(readMppi(block, Distro::Main)->settings.minTurningRadius, 0.9);
    QVERIFY(mppiKeysOf(block, Distro::Main).find("car.min_turning_r", Distro::Main) != nullptr);
    block["car.plugin"] = std::string("mppi::OmniMotionModel");
    QCOMPARE(readMppi(block, Distro::Main)->motion, MppiMotion::Omni);
  }

  void keys_criticsListed_haveRows() {
    const Nav2KeyTable keys =
        mppiKeysOf({{"critics", std::vector<std::string>{"GoalCritic"}}}, Distro::Jazzy);
    QVERIFY(keys.find("GoalCritic.cost_weight", Distro::Jazzy) != nullptr);
    QVERIFY(keys.find("TwirlingCritic.cost_weight", Distro::Jazzy) == nullptr);
    const auto ignored = [&](const std::string& name) {
      return std::any_of(keys.ignored.begin(), keys.ignored.end(),
                         [&](const Nav2KeyTable::Ignored& key) { return key.name == name; });
    };
    QVERIFY(ignored("TwirlingCritic.cost_weight"));
    QVERIFY(!ignored("GoalCritic.cost_weight"));
    QVERIFY(ignored("visualize"));
  }

  void make_period_isComparedWithModelDt() {
    ControllerSetup setup;
    setup.block = stockBlock();
    setup.frequency = 10.0;
    const auto slow = makeController(kMppi, setup);
    QVERIFY(!slow);
    QCOMPARE(slow.diagnostics()[0].code, std::string_view("nav2.mppi-period"));
    setup.frequency = 20.0;
    const auto equal = makeController(kMppi, setup);
    QVERIFY(equal && equal.diagnostics().empty());
    setup.frequency = 30.0;
    setup.block.erase("critics");
    const auto ignored = makeController(kMppi, setup);
    QCOMPARE(ignored.diagnostics()[0].code, std::string_view("nav2.mppi-no-critics"));
    setup.block = stockBlock();
    const auto fast = makeController(kMppi, setup);
    QVERIFY(static_cast<bool>(fast));
    QCOMPARE(fast.diagnostics()[0].code, std::string_view("nav2.mppi-no-shift"));
  }

  void command_path_isCutAndFollowed() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      Driver driver(distro, made(distro));
      for (int call = 0; call < 30; ++call) {
        const ControlResult control = driver.command();
        QVERIFY(static_cast<bool>(control));
        driver.scene.speed = control.twist;
        driver.scene.robot.position.x() += 0.05 * control.twist.linear;
      }
      const double x = driver.scene.robot.position.x();
      QVERIFY(x > 0.3);
      QVERIFY(driver.scene.speed.linear > 0.3);
      const ControlView& view = driver.controller->view();
      QVERIFY(std::fabs(view.localPlan.front().position.x() - x) < 0.06);
      QVERIFY(pathLength(view.localPlan) <= 1.5 + 1e-9);
      QCOMPARE(view.predicted.size(), std::size_t(56));
      QVERIFY(view.predicted.back().position.x() > x + 0.5);
      QVERIFY(view.trajectories.empty());
      QCOMPARE(view.lookahead.size(), std::size_t(1));
      QVERIFY(view.lookahead[0].x() > x + 0.3);
    }
  }

  void command_main_takesTheServersPath() {
    Driver driver(Distro::Main, made(Distro::Main));
    Path local;
    for (int i = 0; i < 30; ++i) {  // to the left, whatever the plan says
      local.push_back({Vec2(0.0, 0.05 * i), base::kPi / 2.0});
    }
    ControlResult control = driver.command(&local);
    for (int call = 0; call < 10; ++call) {
      driver.scene.speed = control.twist;
      control = driver.command(&local);
    }
    QVERIFY(control.twist.angular > 0.2);
    QCOMPARE(driver.controller->view().localPlan, local);
  }

  void command_noPath_isInvalid() {
    for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
      Driver driver(distro, made(distro));
      driver.controller->setPlan({});
      const Path none;
      const ControlResult control = driver.command(distro == Distro::Main ? &none : nullptr);
      QCOMPARE(control.code, ControllerError::InvalidPath);
      QVERIFY(!control.words.empty());
      QCOMPARE(control.twist, BodyTwist{});
    }
  }

  void command_walledIn_isNoValidControl() {
    Driver driver(Distro::Jazzy, made(Distro::Jazzy));
    std::fill(driver.scene.costmap.costs().begin(), driver.scene.costmap.costs().end(), kLethal);
    driver.controller->watch(true);
    const ControlResult control = driver.command();
    QCOMPARE(control.code, ControllerError::NoValidControl);
    QCOMPARE(control.words, std::string("Optimizer fail to compute path"));
    const ControlView& view = driver.controller->view();
    QVERIFY(view.predicted.empty());
    QCOMPARE(view.trajectories.size(), std::size_t(40));  // why: they collide
    for (const EvaluatedTrajectory& one : view.trajectories) {
      QVERIFY(!one.isChosen && !one.rejection.empty());
    }
  }

  void command_footprintOfARadius_isInvalid() {
    Nav2ParameterBlock block = stockBlock();
    block["ObstaclesCritic.consider_footprint"] = true;  // is not listed
    Driver driver(Distro::Jazzy, made(Distro::Jazzy, block));
    driver.scene.shape.isRadius = true;
    QVERIFY(static_cast<bool>(driver.command()));
    block["CostCritic.consider_footprint"] = true;
    Driver edges(Distro::Jazzy, made(Distro::Jazzy, block));
    QVERIFY(static_cast<bool>(edges.command()));
    edges.scene.shape.isRadius = true;
    QCOMPARE(edges.command().code, ControllerError::InvalidController);
  }

  /// Humble forgets after a pause, the others when a goal begins. Speeds are held at 0, so commands
  /// grow by what the sequence remembers.
  void command_pauseOrNewGoal_resetsByRelease() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      const auto warm = [&](Driver& driver) {
        for (int call = 0; call < 20; ++call) {
          driver.command();
        }
      };
      Driver steady(distro, made(distro));
      Driver paused(distro, made(distro));
      Driver begun(distro, made(distro));
      warm(steady);
      warm(paused);
      warm(begun);
      paused.time += 1.0;
      begun.controller->reset();
      const double remembered = steady.command().twist.linear;
      const bool isHumble = distro == Distro::Humble;
      QCOMPARE(paused.command().twist.linear == remembered, !isHumble);
      QCOMPARE(begun.command().twist.linear == remembered, isHumble);
    }
  }

  void watch_trajectories_changesNoCommand() {
    Driver plain(Distro::Jazzy, made(Distro::Jazzy));
    Driver watched(Distro::Jazzy, made(Distro::Jazzy));
    plain.scene.addObstacle(Vec2(0.3, 0.3));
    watched.scene.addObstacle(Vec2(0.3, 0.3));
    watched.controller->watch(true);
    for (int call = 0; call < 5; ++call) {
      QVERIFY(plain.command().twist == watched.command().twist);
    }
    const auto& shown = watched.controller->view().trajectories;
    QCOMPARE(shown.size(), std::size_t(41));
    std::size_t refused = 0;
    for (const EvaluatedTrajectory& one : shown) {
      QCOMPARE(one.scores.size(), nav2test::stockCritics().size());
      double sum = 0.0;
      for (const CriticScore& score : one.scores) {
        sum += score.scale * score.raw;
      }
      QVERIFY(std::fabs(sum - one.total) <= 1e-9 * one.total);
      QCOMPARE(one.poses.size(), std::size_t(one.isChosen ? 56 : 15));
      QCOMPARE(one.isChosen, &one == &shown.back());
      refused += one.rejection.empty() ? 0 : 1;
      QCOMPARE(one.rejection.empty(), one.scores[1].raw < 1e3);  // CostCritic
    }
    QCOMPARE(shown[0].scores[2].scale, 0.0);  // the goal is far: GoalCritic was not asked
    QCOMPARE(shown[0].scores[1].scale, 1.0);
    QVERIFY(refused < 20);
  }

  void server_stockKeys_arrives_data() {
    QTest::addColumn<int>("distro");
    QTest::addColumn<bool>("isShim");
    QTest::addColumn<double>("start");
    QTest::newRow("Humble") << 0 << false << 0.0;
    QTest::newRow("Jazzy") << 1 << false << 0.0;
    QTest::newRow("main") << static_cast<int>(Distro::Main) << false << 0.0;
    QTest::newRow("Humble, looks away") << 0 << false << 2.5;
    QTest::newRow("main, looks away") << static_cast<int>(Distro::Main) << false << 2.5;
    QTest::newRow("Jazzy, behind a rotation shim") << 1 << true << 2.5;
  }

  /// controller_server with the numbers of the bringup drives 3 m past an obstacle.
  void server_stockKeys_arrives() {
    QFETCH(int, distro);
    QFETCH(bool, isShim);
    QFETCH(double, start);
    Nav2ParameterBlock node = {
        {"FollowPath.plugin", std::string(kMppi)},
        {"FollowPath.batch_size", 2000},
        {"FollowPath.regenerate_noises", true},
        {"FollowPath.critics", nav2test::stockCritics()},
        {"goal_checker.plugin", std::string("nav2_controller::SimpleGoalChecker")},
        {"progress_checker.plugin", std::string("nav2_controller::SimpleProgressChecker")}};
    if (isShim) {
      node["FollowPath.plugin"] =
          std::string("nav2_rotation_shim_controller::RotationShimController");
      node["FollowPath.primary_controller"] = std::string(kMppi);
    }
    auto server = makeControllerServer(node, static_cast<Distro>(distro), 3, 0);
    QVERIFY2(server, server ? "" : server.diagnostics()[0].text().c_str());
    HandScene scene;
    scene.costmap = Costmap(120, 120, 0.05, Vec2(-2.0, -2.0));
    scene.addObstacle(Vec2(1.525, -0.375));
    scene.goAhead(3.0, 61);
    scene.robot.heading = start;
    FollowPathGoal goal;
    goal.path = scene.path;
    (*server)->follow(goal);
    double nearest = 10.0;
    for (int step = 0; step < 600; ++step) {
      const FollowFeedback feedback = (*server)->update(
          {scene.robot, scene.speed, scene.costmap, scene.shape, true, 0.05 * step});
      if (feedback.status == FollowStatus::Succeeded) {
        QVERIFY((scene.robot.position - scene.goal.position).norm() <= 0.25);
        QVERIFY(std::fabs(base::wrapToPi(scene.robot.heading)) <= 0.25);
        QVERIFY(nearest > scene.shape.inscribedRadius);
        qInfo("%d steps, obstacle %.2f m away", step, nearest);
        return;
      }
      QVERIFY2(feedback.status == FollowStatus::Running, feedback.words.c_str());
      scene.speed = feedback.command.value_or(scene.speed);
      const Vec2 way = 0.05 * Vec2(scene.speed.linear, scene.speed.lateral);
      scene.robot.position = scene.robot.toWorld(way);
      scene.robot.heading = base::wrapToPi(scene.robot.heading + 0.05 * scene.speed.angular);
      nearest = std::min(nearest, (scene.robot.position - Vec2(1.525, -0.375)).norm());
    }
    QFAIL("did not arrive");
  }
};

QTEST_APPLESS_MAIN(Nav2MppiControllerTest)
#include "tst_Nav2MppiController.moc"
