#include <filesystem>
#include <string>

#include <QtTest>

#include "bt/robot/Nav2Files.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "tests/bt/ScriptedNavigator.h"

namespace {

using namespace navigator;

const std::string kToPose = "navigate_to_pose_w_replanning_and_recovery";
constexpr Answer kForEver = {State::Succeeded, 0, 0};

bt::TreeTable shipped(const std::string& name, const std::string& distro = "humble") {
  const auto table =
      bt::loadTrees(SOURCE_DIR "/resources/nav2_trees/" + distro + "/" + name + ".xml");
  return table ? *table : bt::TreeTable();
}

const char* folderOf(Distro distro) {
  return sim2d::nav2::distroName(distro);
}

/// A shipped tree whose FollowPath never ends, unless told.
class Following : public Played {
 public:
  explicit Following(const std::string& name, Distro distro = Distro::Humble)
      : Played(shipped(name, folderOf(distro)), distro) {
    host.script[RobotAction::FollowPath] = {kForEver};
  }
};

const std::string kTry = "plan follow clear-local follow ";
const std::string kClears = "clear-local clear-global ";
/// All recoveries, in vain.
const std::string kAllTries = kTry + kClears + kTry + "spin " + kTry + "wait " + kTry + "backup " +
                              kTry + kClears + kTry + "spin plan follow clear-local follow";

/// Every tree that is shipped, with its branch.
int addShipped() {
  QTest::addColumn<int>("distro");
  QTest::addColumn<QString>("path");
  int count = 0;
  for (const Distro distro : sim2d::nav2::kDistros) {
    const std::string folder = std::string(SOURCE_DIR "/resources/nav2_trees/") + folderOf(distro);
    if (!std::filesystem::is_directory(folder)) {
      continue;  // Lyrical's are those of main
    }
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string path = entry.path().string();
      QTest::newRow(path.c_str()) << static_cast<int>(distro) << QString::fromStdString(path);
      ++count;
    }
  }
  return count;
}

}  // namespace

/// The navigator trees that are shipped, each played with servers that fail as a script says. What
/// is asked for, in which order, follows from Nav2's description of its trees alone.
class NavigatorTreesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shipped_all_compileWithoutAWord_data() { QCOMPARE(addShipped(), 12 + 12 + 13 + 13); }

  /// Nodes and ports are those of the branch.
  void shipped_all_compileWithoutAWord() {
    QFETCH(int, distro);
    QFETCH(QString, path);
    sim2d::nav2::Nav2Parameters parameters;
    parameters.distro = static_cast<Distro>(distro);
    const bt::NavigatorTree tree = bt::loadNavigatorTree(path.toStdString(), parameters);
    for (const base::Diagnostic& problem : tree.problems) {
      qWarning("%s", problem.text().c_str());
    }
    QVERIFY(tree.program && tree.problems.empty());
  }

  void shipped_all_arrive_data() { addShipped(); }

  /// Each tree is played to its end with servers that succeed. Trees that follow a point end when
  /// the controller fails alone.
  void shipped_all_arrive() {
    QFETCH(int, distro);
    QFETCH(QString, path);
    const auto table = bt::loadTrees(path.toStdString());
    QVERIFY(table);
    Played played(*table, static_cast<Distro>(distro));
    const bool isFollowing = path.contains(QStringLiteral("follow_point"));
    const bool drives = !path.contains(QStringLiteral("odometry_calibration"));
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 10}};
    if (isFollowing) {
      played.host.script[RobotAction::FollowPath].push_back({State::Failed, 106, 5});
    }
    QCOMPARE(played.play(1000), isFollowing ? NodeStatus::Failure : NodeStatus::Success);
    QVERIFY(played.step > 10 || !drives);
    QCOMPARE(played.host.text().find("follow") != std::string::npos, drives);
    QCOMPARE(played.host.text().find("route") != std::string::npos,
             path.contains(QStringLiteral("route_graph")));
  }

  void navigateToPose_allGoesWell_plansOncePerSecond() {
    Following played(kToPose);
    QCOMPARE(played.stepsOf("plan", 70), (Steps{1, 22, 43, 64}));
    QCOMPARE(played.host.text(), std::string("plan follow plan follow plan follow plan follow"));
    QCOMPARE(played.host.recoveries, 0);
    Played arriving(shipped(kToPose));
    arriving.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 10}};
    QCOMPARE(arriving.play(100), NodeStatus::Success);
    QCOMPARE(arriving.step, 12LL);
  }

  void navigateToPose_controllerAlwaysFails_recoversSixTimes() {
    Played played(shipped(kToPose));
    played.host.script[RobotAction::FollowPath] = {{State::Failed, 106, 1}};
    QCOMPARE(played.play(500), NodeStatus::Failure);
    QCOMPARE(played.host.text(), kAllTries);
    // Seven times the clearing of FollowPath, twice two clearings, and four behaviours.
    QCOMPARE(played.host.recoveries, 7 + 4 + 4);
  }

  void navigateToPose_plannerFailsOnce_clearsTheGlobalCostmap() {
    Following played(kToPose);
    played.host.script[RobotAction::ComputePath] = {{State::Failed, 208, 1},
                                                    {State::Succeeded, 0, 1}};
    played.play(5);
    QCOMPARE(played.host.text(), std::string("plan clear-global plan follow"));
  }

  void navigateToPose_newGoalWhileRecovering_stopsTheRecovery() {
    Played played(shipped(kToPose));
    played.host.script[RobotAction::FollowPath] = {{State::Failed, 106, 1},
                                                   {State::Failed, 106, 1},
                                                   {State::Failed, 106, 1},
                                                   {State::Failed, 106, 1},
                                                   kForEver};
    played.host.script[RobotAction::Spin] = {kForEver};
    played.play(30);
    QCOMPARE(played.host.text(), kTry + kClears + kTry + "spin");
    played.host.log.clear();
    played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
    played.play(5);
    QCOMPARE(played.host.text(), std::string("cancel plan follow"));
  }

  void navigateToPose_ofJazzy_recoversWhereItHelps() {
    Played played(shipped(kToPose, "jazzy"), Distro::Jazzy);
    played.host.script[RobotAction::FollowPath] = {{State::Failed, 106, 1}};
    QCOMPARE(played.play(500), NodeStatus::Failure);
    QCOMPARE(played.host.text(), kAllTries);
  }

  void navigateToPose_ofJazzy_invalidPath_doesNotRecover() {
    Played played(shipped(kToPose, "jazzy"), Distro::Jazzy);
    played.host.script[RobotAction::FollowPath] = {{State::Failed, 103, 1}};  // INVALID_PATH
    QCOMPARE(played.play(500), NodeStatus::Failure);
    QCOMPARE(played.host.text(), std::string("plan follow"));
    QCOMPARE(played.host.recoveries, 0);
  }

  void navigateToPose_ofMain_plansWhenThePathIsBlocked() {
    Following played(kToPose, Distro::Main);
    played.host.nextLength = 3.0;  // nearer than 4 m: one plan is enough
    played.host.place.position = {7.0, 0.0};
    QCOMPARE(played.stepsOf("plan", 100), (Steps{1}));
    played.host.pathIsValid = false;
    QVERIFY(!played.stepsOf("plan", 25).empty());
    Following far(kToPose, Distro::Main);
    QVERIFY(far.stepsOf("plan", 100).size() > 3);  // 10 m: once per second
    Played failing(shipped(kToPose, "main"), Distro::Main);
    failing.host.script[RobotAction::FollowPath] = {{State::Failed, 106, 1}};
    QCOMPARE(failing.play(500), NodeStatus::Failure);
    // The round does not begin anew after the last recovery.
    QCOMPARE(failing.host.text(),
             kTry + kClears + kTry + "spin " + kTry + "wait " + kTry + "backup");
  }

  void navigateThroughPoses_plansEveryThreeSeconds_data() {
    QTest::addColumn<int>("distro");
    QTest::newRow("humble") << 0;
    QTest::newRow("jazzy") << 1;
  }

  void navigateThroughPoses_plansEveryThreeSeconds() {
    QFETCH(int, distro);
    Following played("navigate_through_poses_w_replanning_and_recovery",
                     static_cast<Distro>(distro));
    played.setGoal(played.host.paths().add({{{0.5, 0.0}, 0.0}, {{9.0, 0.0}, 0.0}}));
    // Asked in 1, done in 2; 1/0.333 s = 3.003 s is 61 steps of 0.05 s.
    QCOMPARE(played.stepsOf("through", 130), (Steps{1, 63, 125}));
    QCOMPARE(
        played.host.paths()
            .get(static_cast<bt::PathId>(played.state->get(played.program->hostSlot(1)).number()))
            .size(),
        std::size_t{1});  // the first pose, 0.5 m away, counts as passed
  }

  void goalPatience_longerPathNearTheGoal_waitsAndGoesOn() {
    Following played("navigate_to_pose_w_replanning_goal_patience_and_recovery");
    played.host.nextLength = 2.0;
    played.stepsOf("plan", 20);
    played.host.log.clear();
    played.host.nextLength = 5.0;  // round an obstacle
    played.host.script[RobotAction::Wait] = {{State::Succeeded, 0, 4}};
    played.stepsOf("plan", 12);
    const std::string text = played.host.text();
    QVERIFY2(text.rfind("plan ", 0) == 0 && text.find("cancel wait") != std::string::npos,
             text.c_str());
    QCOMPARE(played.tick(), NodeStatus::Running);
    QCOMPARE(played.host.log.back(), std::string("follow"));
  }

  void distance_plansAfterEachMetre() {
    Following played("navigate_w_replanning_distance");
    Steps steps;
    for (int i = 1; i <= 60; ++i) {
      played.host.place.position.x() = 0.0625 * i;
      if (!played.stepsOf("plan", 1).empty()) {
        steps.push_back(i);
      }
    }
    QCOMPARE(steps, (Steps{1, 18, 35, 52}));
  }

  void time_controllerFails_failsAtOnce() {
    Played played(shipped("navigate_w_replanning_time"));
    played.host.script[RobotAction::FollowPath] = {{State::Failed, 106, 15}};
    QCOMPARE(played.play(500), NodeStatus::Failure);
    QCOMPARE(played.host.text(), std::string("plan follow"));
    QCOMPARE(played.step, 17LL);  // 15 steps after the request, of step 2
  }

  void speed_atRest_plansEveryTenSeconds() {
    Following played("navigate_w_replanning_speed");
    // 1 s at first, then 1/0.1 Hz = 10 s.
    QCOMPARE(played.stepsOf("plan", 430), (Steps{1, 21, 221, 421}));
    Following fast("navigate_w_replanning_speed");
    fast.host.driven = 0.26;
    QCOMPARE(fast.stepsOf("plan", 50), (Steps{1, 21, 41}));
  }

  void goalUpdated_newGoal_plansAgain() {
    Following played("navigate_w_replanning_only_if_goal_is_updated");
    QCOMPARE(played.stepsOf("plan", 100), (Steps{1}));
    played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
    QCOMPARE(played.stepsOf("plan", 100), (Steps{101}));
  }

  void pathInvalid_plansOnlyThen_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("plain") << "navigate_w_replanning_only_if_path_becomes_invalid";
    QTest::newRow("recovery") << "navigate_w_recovery_and_replanning_only_if_path_becomes_invalid";
  }

  void pathInvalid_plansOnlyThen() {
    QFETCH(QString, name);
    Following played(name.toStdString());
    QCOMPARE(played.stepsOf("plan", 100), (Steps{1}));
    played.host.pathIsValid = false;
    // Looked at once per second from step 2 on: 22, 42 … 102.
    QCOMPARE(played.stepsOf("plan", 20), (Steps{102}));
    played.host.pathIsValid = true;
    QCOMPARE(played.stepsOf("plan", 25), Steps());
    played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
    QCOMPARE(played.stepsOf("plan", 25).size(), std::size_t{1});
  }

  void consistent_oldPath_plansAfterTenSeconds() {
    Following played("nav_to_pose_with_consistent_replanning_and_if_path_becomes_invalid");
    const Steps steps = played.stepsOf("plan", 500);
    QVERIFY(steps.size() >= 2);
    const long long gap = steps[1] - steps[0];
    QVERIFY2(gap >= 200 && gap <= 242, std::to_string(gap).c_str());  // 10 s, looked at each second
  }

  void followPoint_pathEnds_goesOnUntilItFails() {
    Played played(shipped("follow_point"));
    played.host.script[RobotAction::FollowPath] = {
        {State::Succeeded, 0, 3}, {State::Succeeded, 0, 3}, {State::Failed, 106, 3}};
    QCOMPARE(played.play(200), NodeStatus::Failure);
    QCOMPARE(played.host.text(), std::string("plan follow follow follow"));
    // A path of two poses is never cut.
    QCOMPARE(played.host.paths().get(played.host.last.path).back().position.x(), 10.0);
  }

  void odometryCalibration_drivesThreeSquares() {
    Played played(shipped("odometry_calibration"));
    QCOMPARE(played.play(500), NodeStatus::Success);
    std::string square;
    for (int i = 0; i < 12; ++i) {
      square += i == 0 ? "heading spin" : " heading spin";
    }
    QCOMPARE(played.host.text(), square);
    QCOMPARE(played.host.recoveries, 0);
  }
};

QTEST_GUILESS_MAIN(NavigatorTreesTest)
#include "tst_NavigatorTrees.moc"
