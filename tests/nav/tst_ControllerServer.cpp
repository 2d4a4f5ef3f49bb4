#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/control/ControllerServer.h"
#include "tests/nav/ControlScene.h"

using namespace control_scene;
using base::Vec2;
using sim2d::BodyTwist;

namespace {

/// Answers as it is told and notes what it is asked.
class Puppet final : public Controller {
 public:
  void setPlan(const Path& plan) override { plans.push_back(plan); }
  ControlResult computeVelocityCommands(const ControlInput& input) override {
    ++asked;
    seen = input.speed;
    seenPlan = input.localPlan != nullptr ? *input.localPlan : Path();
    return answer;
  }
  void setSpeedLimit(double limit, bool /*isPercentage*/) override { speedLimit = limit; }
  bool cancel() override { return isCancellable; }
  void reset() override { ++resets; }

  ControlResult answer = BodyTwist{0.4, 0.1};
  bool isCancellable = true;
  std::vector<Path> plans;
  int asked = 0, resets = 0;
  double speedLimit = -1.0;
  BodyTwist seen;
  Path seenPlan;
};

/// A server with two puppets, and the robot 2 m from the goal.
struct Stage {
  explicit Stage(Distro distro, ControllerServerParameters parameters = {}) : scene(distro) {
    ControllerServer::Setup setup;
    setup.parameters = std::move(parameters);
    setup.distro = distro;
    for (const char* name : {"A", "B"}) {
      auto puppet = std::make_unique<Puppet>();
      puppets.push_back(puppet.get());
      setup.controllers[name] = std::move(puppet);
    }
    setup.goalCheckers["goal"] = goalChecker(distro);
    setup.progressCheckers["progress"] =
        *makeProgressChecker("nav2_controller::SimpleProgressChecker", distro, {});
    if (distro == Distro::Main) {
      PathPruning pruning;
      pruning.keepsLastTwo = true;
      setup.pathHandlers["PathHandler"] = std::make_unique<PathHandler>(pruning);
    }
    server = std::make_unique<ControllerServer>(std::move(setup));
  }

  void follow(const Path& path, const std::string& controller = "A") {
    FollowPathGoal goal;
    goal.path = path;
    goal.controller = controller;
    server->follow(goal);
  }
  FollowFeedback step(double dt = 0.05) {
    const FollowFeedback feedback = server->update(
        {scene.robot, scene.speed, scene.costmap, scene.shape, isCurrent, scene.time});
    scene.time += dt;
    return feedback;
  }
  Puppet& a() { return *puppets[0]; }
  Puppet& b() { return *puppets[1]; }

  Scene scene;
  std::vector<Puppet*> puppets;
  std::unique_ptr<ControllerServer> server;
  bool isCurrent = true;
};

ControllerServerParameters patient(double tolerance) {
  ControllerServerParameters parameters;
  parameters.failureTolerance = tolerance;
  return parameters;
}

void addDistros() {
  QTest::addColumn<int>("distro");
  QTest::newRow("humble") << static_cast<int>(Distro::Humble);
  QTest::newRow("jazzy") << static_cast<int>(Distro::Jazzy);
  QTest::newRow("main") << static_cast<int>(Distro::Main);
}

}  // namespace

class ControllerServerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void goal_isFollowedUntilReached_data() { addDistros(); }

  void goal_isFollowedUntilReached() {
    QFETCH(int, distro);
    Stage stage(static_cast<Distro>(distro));
    QCOMPARE(stage.step().status, FollowStatus::Idle);
    stage.follow(straight(1.4));
    FollowFeedback feedback = stage.step();
    QCOMPARE(feedback.status, FollowStatus::Running);
    QCOMPARE(*feedback.command, (BodyTwist{0.4, 0.1}));
    QCOMPARE(stage.a().plans.size(), std::size_t{1});
    stage.scene.robot.position.x() = 1.2;
    feedback = stage.step();
    QCOMPARE(feedback.status, FollowStatus::Succeeded);
    QCOMPARE(feedback.code, ControllerError::None);
    QCOMPARE(*feedback.command, BodyTwist());
    QCOMPARE(stage.a().resets, distro == static_cast<int>(Distro::Humble) ? 0 : 1);
    QCOMPARE(stage.step().status, FollowStatus::Idle);
    QVERIFY(!stage.server->isRunning());
  }
  void goalReached_orderOfDistro_data() { addDistros(); }

  /// Humble computes a command first and tests the goal then.
  void goalReached_orderOfDistro() {
    QFETCH(int, distro);
    const bool isHumble = distro == static_cast<int>(Distro::Humble);
    Stage stage(static_cast<Distro>(distro));
    stage.scene.robot.position.x() = 1.3;
    stage.follow(straight(1.4));
    QCOMPARE(stage.step().status, FollowStatus::Succeeded);
    QCOMPARE(stage.a().asked, isHumble ? 1 : 0);
    stage.follow(straight(1.4));
    stage.a().answer = {ControllerError::NoValidControl, "none"};
    QCOMPARE(stage.step().status, isHumble ? FollowStatus::Failed : FollowStatus::Succeeded);
  }

  void newPath_replacesWithoutStop() {
    Stage stage(Distro::Jazzy);
    stage.follow(straight(1.4));
    stage.step();
    stage.follow(straight(1.0));
    QCOMPARE(*stage.step().command, (BodyTwist{0.4, 0.1}));
    QCOMPARE(stage.a().plans.size(), std::size_t{2});
    stage.scene.robot.position.x() = 0.9;  // the new goal counts
    QCOMPARE(stage.step().status, FollowStatus::Succeeded);
  }

  void newPath_otherController_isSwapped() {
    Stage stage(Distro::Jazzy);
    stage.follow(straight(1.4));
    stage.step();
    stage.b().answer = BodyTwist{0.1, 0.0};
    stage.follow(straight(1.4), "B");
    QCOMPARE(*stage.step().command, (BodyTwist{0.1, 0.0}));
    QVERIFY(stage.server->controller() == &stage.b());
  }

  void names_unknown_fail() {
    Stage stage(Distro::Jazzy);
    stage.follow(straight(1.4), "");  // two controllers: it must have a name
    FollowFeedback feedback = stage.step();
    QCOMPARE(feedback.status, FollowStatus::Failed);
    QCOMPARE(feedback.code, ControllerError::InvalidController);
    QCOMPARE(feedback.words, std::string("Failed to find controller name: "));
    FollowPathGoal goal;
    goal.path = straight(1.4);
    goal.controller = "A";
    goal.goalChecker = "other";
    stage.server->follow(goal);
    feedback = stage.step();
    QCOMPARE(feedback.code, ControllerError::Unknown);
    QCOMPARE(feedback.words, std::string("Failed to find goal checker name: other"));
    goal.goalChecker = "";
    goal.progressChecker = "goal";
    stage.server->follow(goal);
    QCOMPARE(stage.step().words, std::string("Failed to find progress checker name: goal"));
  }

  void emptyPath_fails() {
    Stage stage(Distro::Jazzy);
    stage.follow({});
    const FollowFeedback feedback = stage.step();
    QCOMPARE(feedback.code, ControllerError::InvalidPath);
    QCOMPARE(feedback.words, std::string("Path is empty."));
  }

  void noValidControl_withoutTolerance_failsAtOnce() {
    Stage stage(Distro::Jazzy);
    stage.follow(straight(1.4));
    stage.a().answer = {ControllerError::NoValidControl, "no way"};
    const FollowFeedback feedback = stage.step();
    QCOMPARE(feedback.status, FollowStatus::Failed);
    QCOMPARE(feedback.code, ControllerError::NoValidControl);
    QCOMPARE(feedback.words, std::string("no way"));
    QCOMPARE(*feedback.command, BodyTwist());
  }

  /// 0.3 s from the last valid command at 0: at 0.30 still, at 0.35 no more.
  void noValidControl_patience_thenExceeded() {
    Stage stage(Distro::Jazzy, patient(0.301));
    stage.follow(straight(1.4));
    QVERIFY(!stage.step().isFailureTolerated);
    stage.a().answer = {ControllerError::NoValidControl, "no way"};
    for (int i = 1; i <= 6; ++i) {
      const FollowFeedback feedback = stage.step();
      QCOMPARE(feedback.status, FollowStatus::Running);
      QCOMPARE(*feedback.command, BodyTwist());
      QVERIFY(feedback.isFailureTolerated);
      QCOMPARE(feedback.words, std::string("no way"));
    }
    const FollowFeedback feedback = stage.step();
    QCOMPARE(feedback.status, FollowStatus::Failed);
    QCOMPARE(feedback.code, ControllerError::PatienceExceeded);
    QCOMPARE(feedback.words, std::string("Controller patience exceeded"));
  }

  void noValidControl_forEver_neverFails() {
    Stage stage(Distro::Jazzy, patient(-1.0));
    stage.follow(straight(1.4));
    stage.a().answer = {ControllerError::NoValidControl, "no way"};
    for (int i = 0; i < 100; ++i) {
      QCOMPARE(stage.step().status, FollowStatus::Running);
    }
  }

  void noValidControl_validBetween_startsAnew() {
    Stage stage(Distro::Jazzy, patient(0.301));
    stage.follow(straight(1.4));
    for (int i = 0; i < 40; ++i) {
      stage.a().answer = i % 5 == 4 ? ControlResult(BodyTwist{0.1, 0.0})
                                    : ControlResult(ControllerError::NoValidControl, "no way");
      QCOMPARE(stage.step().status, FollowStatus::Running);
    }
  }

  /// Since Jazzy only NoValidControl may pass by itself.
  void otherFailures_patienceOfHumbleAlone() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      Stage stage(distro, patient(5.0));
      stage.follow(straight(1.4));
      stage.a().answer = {ControllerError::InvalidPath, "Resulting plan has 0 poses in it."};
      QCOMPARE(stage.step().status,
               distro == Distro::Humble ? FollowStatus::Running : FollowStatus::Failed);
    }
  }

  void noProgress_fails_andNewPathDoesNotReset() {
    Stage stage(Distro::Jazzy);
    stage.follow(straight(1.4));
    stage.step(6.0);  // clock of the checker: 0
    stage.follow(straight(1.4));
    QCOMPARE(stage.step(4.1).status, FollowStatus::Running);  // 6 s
    const FollowFeedback feedback = stage.step();             // 10.1 s
    QCOMPARE(feedback.status, FollowStatus::Failed);
    QCOMPARE(feedback.code, ControllerError::FailedToMakeProgress);
    QCOMPARE(feedback.words, std::string("Failed to make progress"));
    stage.follow(straight(1.4));  // a new goal does
    QCOMPARE(stage.step(9.9).status, FollowStatus::Running);
    QCOMPARE(stage.step().status, FollowStatus::Running);
  }

  void costmapNotCurrent_waits_timesOut() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      Stage stage(distro);
      stage.follow(straight(1.4));
      stage.step();
      stage.isCurrent = false;
      for (int i = 0; i < 6; ++i) {  // 0.25 s
        const FollowFeedback feedback = stage.step();
        QCOMPARE(feedback.status, FollowStatus::Running);
        QVERIFY(!feedback.command);
      }
      QCOMPARE(stage.a().asked, 1);
      stage.isCurrent = true;
      QVERIFY(stage.step().command.has_value());
      stage.isCurrent = false;  // the wait begins anew
      stage.step(0.29);
      QCOMPARE(stage.step().status, FollowStatus::Running);
      const FollowFeedback feedback = stage.step();
      if (distro == Distro::Humble) {
        QCOMPARE(feedback.status, FollowStatus::Running);
      } else {
        QCOMPARE(feedback.code, ControllerError::ControllerTimedOut);
        QCOMPARE(feedback.words, std::string("Costmap timed out waiting for update"));
      }
    }
  }

  void cancel_endsAtOnceOrWhenBraked() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy}) {
      Stage stage(distro);
      stage.a().isCancellable = false;
      stage.follow(straight(1.4));
      stage.step();
      stage.server->cancel();
      if (distro == Distro::Jazzy) {
        QCOMPARE(*stage.step().command, (BodyTwist{0.4, 0.1}));  // it is asked on
        stage.a().isCancellable = true;
      }
      const FollowFeedback feedback = stage.step();
      QCOMPARE(feedback.status, FollowStatus::Canceled);
      QCOMPARE(*feedback.command, BodyTwist());
      stage.server->cancel();  // nothing to cancel: the next goal is not touched
      stage.follow(straight(1.4));
      QCOMPARE(stage.step().status, FollowStatus::Running);
    }
  }

  void cancel_beforeTheFirstCycle_neverDrives() {
    Stage stage(Distro::Jazzy);
    stage.follow(straight(1.4));
    stage.server->cancel();
    QCOMPARE(stage.step().status, FollowStatus::Canceled);
    QCOMPARE(stage.a().asked, 0);
  }

  void slowSpeeds_areZero() {
    ControllerServerParameters parameters;
    parameters.minXVelocity = 0.001;
    parameters.minYVelocity = 0.5;
    Stage stage(Distro::Humble, parameters);
    stage.scene.speed = {0.001, -0.0002, -0.49};
    stage.follow(straight(1.4));
    stage.step();
    QCOMPARE(stage.a().seen, (BodyTwist{0.0, -0.0002, 0.0}));
    stage.scene.speed = {-0.0011, 1e-4, -0.51};
    stage.step();
    QCOMPARE(stage.a().seen, (BodyTwist{-0.0011, 0.0, -0.51}));
  }

  void zeroVelocity_isPublishedAtTheEnd() {
    ControllerServerParameters parameters;
    parameters.publishesZeroVelocity = false;
    Stage stage(Distro::Jazzy, parameters);
    stage.scene.robot.position.x() = 1.3;
    stage.follow(straight(1.4));
    QVERIFY(!stage.step().command);
  }

  void speedLimit_reachesAll() {
    Stage stage(Distro::Jazzy);
    stage.server->setSpeedLimit(0.3, false);
    QCOMPARE(stage.a().speedLimit, 0.3);
    QCOMPARE(stage.b().speedLimit, 0.3);
  }

  void main_localPath_isCutByTheHandler() {
    Stage stage(Distro::Main);
    stage.scene.robot.position.x() = 0.31;
    stage.follow(straight(5.0));
    stage.step();
    QVERIFY(isNear(stage.a().seenPlan.front().position.x(), 0.3));
    QVERIFY(isNear(stage.a().seenPlan.back().position.x(), 1.45));  // the map ends at 1.5
    // 2 m of path bring the robot by its goal again: not reached while more than 1 m is left
    Path loop = straight(1.0);
    for (int i = 1; i <= 20; ++i) {
      loop.push_back({Vec2(1.0 - 0.05 * i, 0.05), 0.0});
    }
    stage.scene.robot.position = {0.0, 0.0};
    stage.follow(loop);
    QCOMPARE(stage.step().status, FollowStatus::Running);
  }

  void main_pathOffTheMap_fails() {
    Stage stage(Distro::Main);
    stage.follow({{Vec2(9.0, 9.0), 0.0}, {Vec2(9.0, 9.5), 0.0}});
    QCOMPARE(stage.step().code, ControllerError::InvalidPath);
  }

  void make_defaults_needNoPlugins() {
    for (const Distro distro : {Distro::Humble, Distro::Jazzy, Distro::Main}) {
      const Nav2ParameterBlock node{
          {"FollowPath.critics", std::vector<std::string>{"BaseObstacle"}},
          {"FollowPath.max_vel_x", 0.26},
          {"FollowPath.max_speed_xy", 0.26},
          {"FollowPath.acc_lim_x", 2.5}};
      auto made = makeControllerServer(node, distro);
      QVERIFY(made);
      Scene scene(distro);
      FollowPathGoal goal;
      goal.path = straight(1.4);
      (*made)->follow(goal);
      const FollowFeedback feedback =
          (*made)->update({scene.robot, scene.speed, scene.costmap, scene.shape, true, 0.0});
      QCOMPARE(feedback.status, FollowStatus::Running);
      QVERIFY(feedback.command->linear > 0.0);
    }
  }

  void make_everyProblemAtOnce() {
    using Names = std::vector<std::string>;
    const Nav2ParameterBlock node{
        {"controller_frequency", 0.0},
        {"failure_tolerance", 1},
        {"controller_plugins", Names{"FollowPath", "Slow"}},
        {"FollowPath.plugin", std::string("dwb_core::DWBLocalPlaner")},
        {"goal_checker_plugins", Names{"general"}},
        {"general.plugin", std::string("nav2_controller::SimpleGoalChecker")},
        {"general.xy_goal_tolerance", 1}};
    const auto made = makeControllerServer(node, Distro::Humble);
    QVERIFY(!made);
    Names codes;
    for (const base::Diagnostic& each : made.diagnostics()) {
      codes.emplace_back(each.code);
    }
    QCOMPARE(codes, (Names{"nav2.wrong-type", "nav2.wrong-value", "nav2.unknown-plugin",
                           "nav2.missing-key", "nav2.wrong-type"}));
    QCOMPARE(made.diagnostics()[2].value("where"), std::string("FollowPath"));
    QCOMPARE(made.diagnostics()[3].value("key"), std::string("Slow.plugin"));
  }

  void make_humble_oneProgressChecker() {
    const Nav2ParameterBlock node{
        {"FollowPath.plugin",
         std::string("nav2_regulated_pure_pursuit_controller/RegulatedPurePursuitController")},
        {"progress_checker_plugin", std::string("pc")},
        {"pc.plugin", std::string("nav2_controller::SimpleProgressChecker")}};
    QVERIFY(makeControllerServer(node, Distro::Humble));
    QVERIFY(makeControllerServer(node, Distro::Jazzy));  // the key is not known there
  }

  void keys_ofTheNode() {
    const Nav2ParameterBlock node{
        {"FollowPath.plugin",
         std::string("nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController")}};
    const Nav2KeyTable keys = controllerServerNodeKeys(node, Distro::Jazzy);
    QVERIFY(keys.find("controller_frequency", Distro::Jazzy) != nullptr);
    QVERIFY(keys.find("FollowPath.lookahead_dist", Distro::Jazzy) != nullptr);
    QVERIFY(keys.find("FollowPath.critics", Distro::Jazzy) == nullptr);
    QVERIFY(keys.find("goal_checker.xy_goal_tolerance", Distro::Jazzy) != nullptr);
    QVERIFY(keys.find("progress_checker.movement_time_allowance", Distro::Jazzy) != nullptr);
    const Nav2KeyTable main = controllerServerNodeKeys({}, Distro::Main);
    QVERIFY(main.find("PathHandler.prune_distance", Distro::Main) != nullptr);
    QCOMPARE(std::get<std::string>(main.find("FollowPath.plugin", Distro::Main)->fallback),
             std::string("dwb_core::DWBLocalPlanner"));
  }
};

QTEST_APPLESS_MAIN(ControllerServerTest)
#include "tst_ControllerServer.moc"
