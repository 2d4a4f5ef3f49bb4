#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/bt/ScriptedNavigator.h"

namespace {

using bt::Waypoint;
using namespace navigator;

std::string textEntry(const Played& played, const std::string& key) {
  for (const auto& [name, text] : played.state->entries()) {
    if (name == key) {
      return text;
    }
  }
  return "-";
}
/// The entry of a tree as a number.
int entry(const Played& played, const std::string& key) {
  const std::string text = textEntry(played, key);
  return text == "-" ? -1 : std::stoi(text);
}
const Path& pathEntry(const Played& played, const std::string& key) {
  return played.host.paths().get(entry(played, key));
}

bt::NavigatorTopics topics(const std::string& text) {
  const auto read = bt::NavigatorTopics::read(text);
  return read ? *read : bt::NavigatorTopics();
}

/// Goals along the x axis.
bt::PathId goalsAt(Played& played, const std::vector<double>& places) {
  Path goals;
  for (const double x : places) {
    goals.push_back({{x, 0.0}, 0.0});
  }
  return played.host.paths().add(goals);
}

/// Sets the goals, and their statuses in the entry `statuses`: all pending.
void setPendingGoals(Played& played, bt::PathId goals) {
  played.setGoal(goals);
  bt::Waypoints waypoints;
  for (const base::Pose2& goal : played.host.paths().get(goals)) {
    waypoints.push_back({goal, Waypoint::Status::Pending});
  }
  const auto number = played.host.waypoints().add(waypoints);
  played.state->set(played.program->findSlot("statuses"), static_cast<int>(number));
}

}  // namespace

/// Nav2's nodes that take poses and goals, ask services, choose by topics, pause, and ask a
/// navigator or the route server: what they do by Nav2's documentation and code.
class RobotServicesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// A tree that writes the robot's pose in each step of half an hour.
  void paths_manyPoses_leaveTheGoalKnown() {
    Played played(R"(<GetCurrentPose current_pose="{pose}"/>)");
    for (int i = 0; i < 36'000; ++i) {
      played.host.place.position.x() = 0.001 * i;
      played.tick();
    }
    QCOMPARE(played.host.paths().get(played.host.goal).size(), std::size_t{1});
    bt::PathStore store;
    const Path large(bt::PathStore::kMostPoses / 2 + 1);
    const bt::PathId first = store.add({{{1.0, 0.0}, 0.0}});
    store.add(large);
    QCOMPARE(store.get(first).size(), std::size_t{1});
    store.add(large);
    store.add({});
    QVERIFY(store.get(first).empty());  // the limit of poses
    QCOMPARE(store.get(first + 2).size(), large.size());
  }

  void topics_text_isReadOrRefused() {
    const bt::NavigatorTopics read =
        topics(" 12.0 /speed  0.5 m/s; 3 pause ;; 20 speed 1; 3 pause");
    QCOMPARE(read.lastOf("speed", 11.9).number, 0);
    QCOMPARE(read.lastOf("speed", 12.0).text, std::string("0.5 m/s"));
    QCOMPARE(read.lastOf("/speed", 25.0).number, 2);
    QCOMPARE(read.lastOf("pause", 3.0).number, 2);
    QCOMPARE(read.after("speed", 1, 25.0).size(), std::size_t{1});
    for (const char* bad : {"x speed 1", "-1 speed 1", "12", "1 /", "inf speed"}) {
      const auto refused = bt::NavigatorTopics::read(bad);
      QVERIFY2(!refused && refused.diagnostics().size() == 1, bad);
    }
    QCOMPARE(bt::NavigatorTopics::read("x a; y b").diagnostics().size(), std::size_t{2});
  }

  void selector_topic_choosesFromThenOn() {
    Played played(R"(<ControllerSelector topic_name="/controller_selector"
      default_controller="FollowPath" selected_controller="{chosen}"/>)");
    played.host.topics = topics("0.2 controller_selector Second");
    std::vector<std::string> chosen;
    for (int i = 0; i < 5; ++i) {
      QCOMPARE(played.tick(), kSuccess);
      chosen.push_back(textEntry(played, "chosen"));
    }
    // The host's time is 0.05 s times the step: 0.2 s is step 4.
    QCOMPARE(chosen, (std::vector<std::string>{"FollowPath", "FollowPath", "FollowPath", "Second",
                                               "Second"}));
  }

  void goalUpdater_topic_isNewerThanTheGoal() {
    Played played(R"(<GoalUpdater input_goal="{goal}" output_goal="{new}" input_goals="{goals}"
      output_goals="{news}"><AlwaysSuccess/></GoalUpdater>)");
    played.host.topics =
        topics("0.1 goal_update 3 4 1.5; 0.1 /goals_update 1 2, 5 6; 0.3 goal_update x");
    played.tick();
    QCOMPARE(pathEntry(played, "new").front().position.x(), 10.0);
    played.tick();
    QCOMPARE(pathEntry(played, "new").front().position.y(), 4.0);
    QCOMPARE(pathEntry(played, "new").front().heading, 1.5);
    QCOMPARE(pathEntry(played, "news").size(), std::size_t{2});
    const int before = entry(played, "new");
    played.tick();
    QCOMPARE(entry(played, "new"), before);  // the same goal is no new one
    played.setGoal(played.host.paths().add({{{7.0, 0.0}, 0.0}}));
    played.tick();
    QCOMPARE(pathEntry(played, "new").front().position.x(), 7.0);  // newer than the message
  }

  void pauseResume_services_switchTheChildren() {
    Played played(R"(<PauseResumeController pause_service_name="/pause"
      resume_service_name="/resume"><FollowPath path="{goal}"/><Wait wait_duration="9"/>
      <Spin/><BackUp/></PauseResumeController>)");
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0},
                                                   {State::Succeeded, 0, 2}};
    played.host.script[RobotAction::Wait] = {{State::Succeeded, 0, 0}};
    played.host.topics = topics("0.15 pause; 0.4 resume");
    QCOMPARE(played.play(40), kSuccess);
    // Paused in step 3: Spin in 3, done in 4, Wait from 5 on until 8: BackUp, done in 9, follow
    // in 10.
    QCOMPARE(played.host.text(), std::string("follow cancel spin wait cancel backup follow"));
    QCOMPARE(played.step, 12LL);
  }

  void pauseResume_calledWhilePaused_hasNoEffect() {
    Played played(R"(<PauseResumeController pause_service_name="pause"
      resume_service_name="resume"><FollowPath path="{goal}"/></PauseResumeController>)");
    played.host.script[RobotAction::FollowPath] = {{State::Succeeded, 0, 0}};
    played.host.topics = topics("0.05 resume; 0.1 pause; 0.2 pause; 0.5 resume");
    for (int i = 0; i < 9; ++i) {
      QCOMPARE(played.tick(), kRunning);
    }
    QCOMPARE(played.host.text(), std::string("follow cancel"));
    played.play(4);
    QCOMPARE(played.host.text(), std::string("follow cancel follow"));
  }

  void persistentSequence_failure_goesOnThere() {
    Played played(R"(<PersistentSequence current_child_idx="{child}"><BackUp/>
      <Spin/><Wait/></PersistentSequence>)");
    played.host.script[RobotAction::Spin] = {{State::Failed, 701, 1}, {State::Succeeded, 0, 1}};
    QCOMPARE(played.play(10), kFailure);
    QCOMPARE(entry(played, "child"), 1);
    QCOMPARE(played.play(10), kSuccess);
    QCOMPARE(played.host.text(), std::string("backup spin spin wait"));
    QCOMPARE(entry(played, "child"), 0);
  }

  void poseFromPath_index_data() {
    QTest::addColumn<int>("index");
    QTest::addColumn<double>("x");  // negative: it fails
    QTest::newRow("first") << 0 << 1.0;
    QTest::newRow("third") << 2 << 3.0;
    QTest::newRow("last") << -1 << 3.0;
    QTest::newRow("third from the end") << -3 << 1.0;
    QTest::newRow("beyond") << 3 << -1.0;
    QTest::newRow("before") << -4 << -1.0;
  }

  void poseFromPath_index() {
    QFETCH(int, index);
    QFETCH(double, x);
    Played played("<GetPoseFromPath path=\"{goals}\" index=\"" + std::to_string(index) +
                  "\" pose=\"{pose}\"/>");
    played.setGoal(goalsAt(played, {1.0, 2.0, 3.0}));
    QCOMPARE(played.tick(), x < 0.0 ? kFailure : kSuccess);
    if (x >= 0.0) {
      QCOMPARE(pathEntry(played, "pose").size(), std::size_t{1});
      QCOMPARE(pathEntry(played, "pose").front().position.x(), x);
    }
  }

  void currentPose_isTheRobots() {
    Played played(R"(<GetCurrentPose current_pose="{pose}"/>)");
    played.host.place = {{2.0, 3.0}, 0.5};
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(pathEntry(played, "pose").front().position.y(), 3.0);
    QCOMPARE(pathEntry(played, "pose").front().heading, 0.5);
  }

  void concatenatePaths_oneMayBeEmpty() {
    Played played(R"(<ConcatenatePaths input_path1="{goal}" input_path2="{goals}"
      output_path="{path}"/>)");
    const bt::PathId two = goalsAt(played, {1.0, 2.0});
    const auto set = [&](int slot, bt::PathId id) {
      played.state->set(played.program->hostSlot(slot), static_cast<int>(id));
    };
    set(0, two);
    set(1, goalsAt(played, {3.0}));
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(pathEntry(played, "path").size(), std::size_t{3});
    QCOMPARE(pathEntry(played, "path").back().position.x(), 3.0);
    set(1, 0);
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(pathEntry(played, "path").size(), std::size_t{2});
    set(0, 0);
    QCOMPARE(played.tick(), kFailure);
  }

  void goals_appendAndNextFew() {
    Played played(R"(<Sequence><AppendGoalPoseToGoals input_goals="{goals}" goal_pose="{goal}"
      output_goals="{more}"/><GetNextFewGoals input_goals="{more}" num_goals="2"
      output_goals="{few}"/><GetNextFewGoals input_goals="{more}" num_goals="9"
      output_goals="{all}"/></Sequence>)");
    played.state->set(played.program->hostSlot(1), static_cast<int>(goalsAt(played, {1.0, 2.0})));
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(pathEntry(played, "more").size(), std::size_t{3});
    QCOMPARE(pathEntry(played, "more").back().position.x(), 10.0);
    QCOMPARE(pathEntry(played, "few").size(), std::size_t{2});
    QCOMPARE(pathEntry(played, "few").back().position.x(), 2.0);
    QCOMPARE(pathEntry(played, "all").size(), std::size_t{3});
  }

  void poseOccupancy_costs_data() {
    QTest::addColumn<int>("cost");
    QTest::addColumn<QString>("ports");
    QTest::addColumn<bool>("free");
    QTest::newRow("free") << 0 << "" << true;
    QTest::newRow("inscribed is below 254") << 253 << "" << true;
    QTest::newRow("lethal") << 254 << "" << false;
    QTest::newRow("threshold") << 100 << "cost_threshold=\"100\"" << false;
    QTest::newRow("unknown") << 255 << "" << true;
    QTest::newRow("unknown counts") << 255 << "consider_unknown_as_obstacle=\"true\"" << false;
    QTest::newRow("off the map") << -1 << "" << false;
  }

  void poseOccupancy_costs() {
    QFETCH(int, cost);
    QFETCH(QString, ports);
    QFETCH(bool, free);
    Played played("<CheckPoseOccupancy pose=\"{goal}\" " + ports.toStdString() + "/>");
    played.host.costs[10.0] =
        cost < 0 ? std::nullopt : std::optional<std::uint8_t>(static_cast<std::uint8_t>(cost));
    QCOMPARE(played.tick(), free ? kSuccess : kFailure);
  }

  void collidingGoals_areTakenAwayAndMarked() {
    Played played(R"(<RemoveInCollisionGoals input_goals="{goals}" output_goals="{goals}"
      input_waypoint_statuses="{statuses}" output_waypoint_statuses="{statuses}"/>)");
    const bt::PathId goals = goalsAt(played, {1.0, 2.0, 3.0});
    setPendingGoals(played, goals);
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(entry(played, "goals"), static_cast<int>(goals));  // nothing in the way
    played.host.costs[2.0] = 254;
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(pathEntry(played, "goals").size(), std::size_t{2});
    QCOMPARE(pathEntry(played, "goals").back().position.x(), 3.0);
    const bt::Waypoints& marked = played.host.waypoints().get(entry(played, "statuses"));
    QCOMPARE(marked.size(), std::size_t{3});
    QVERIFY(marked[0].status == Waypoint::Status::Pending);
    QVERIFY(marked[1].status == Waypoint::Status::Skipped);
  }

  void collidingGoals_offTheMap_fails() {
    Played played(R"(<RemoveInCollisionGoals input_goals="{goals}" output_goals="{goals}"/>)");
    const bt::PathId goals = goalsAt(played, {1.0, 2.0});
    played.setGoal(goals);
    played.host.costs[2.0] = std::nullopt;
    QCOMPARE(played.tick(), kFailure);
    QCOMPARE(entry(played, "goals"), static_cast<int>(goals));
  }

  void passedGoals_areMarkedAsCompleted() {
    Played played(R"(<RemovePassedGoals input_goals="{goals}" output_goals="{goals}" radius="0.5"
      input_waypoint_statuses="{statuses}" output_waypoint_statuses="{statuses}"/>)");
    setPendingGoals(played, goalsAt(played, {0.25, 3.0}));
    QCOMPARE(played.tick(), kSuccess);
    const bt::Waypoints& marked = played.host.waypoints().get(entry(played, "statuses"));
    QVERIFY(marked[0].status == Waypoint::Status::Completed);
    QVERIFY(marked[1].status == Waypoint::Status::Pending);
  }

  void validatePath_ports_areHandedOn() {
    Played played(R"(<ValidatePath path="{goal}" max_cost="200" layer_name="voxels"
      footprint="[[0, 0], [1, 0], [0, 1]]" consider_unknown_as_obstacle="true"
      max_lookahead_distance="2.5" stop_at_first_collision="false" collision_poses="{hits}"/>)");
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(entry(played, "hits"), 0);
    const bt::PathCheck& check = played.host.lastCheck;
    QVERIFY(check.maxCost == 200 && check.unknownBlocks && !check.stopsAtFirst);
    QVERIFY(check.lookahead == 2.5 && check.layer == "voxels" && check.footprint.size() == 24);
    played.host.pathIsValid = false;
    played.host.collisions = {{{4.0, 0.0}, 0.0}, {{5.0, 0.0}, 0.0}};
    QCOMPARE(played.tick(), kFailure);
    QCOMPARE(pathEntry(played, "hits").size(), std::size_t{2});
  }

  void stopStatus_standing_takesItsTime_data() {
    QTest::addColumn<QString>("node");
    QTest::newRow("Kilted") << "IsStopped";
    QTest::newRow("main") << "CheckStopStatus";
  }

  void stopStatus_standing_takesItsTime() {
    QFETCH(QString, node);
    Played played("<" + node.toStdString() +
                  " velocity_threshold=\"0.1\" duration_stopped=\"200\"/>");
    played.host.driven = 0.2;
    QCOMPARE(played.tick(), kFailure);
    played.host.driven = 0.05;
    QCOMPARE(played.play(20), kSuccess);
    QCOMPARE(played.step, 2LL + 4);     // 0.2 s are four steps
    QCOMPARE(played.tick(), kRunning);  // it begins anew
    played.host.driven = 0.2;
    QCOMPARE(played.tick(), kFailure);
  }

  void trackingBounds_sidesAndHeading() {
    Played played(R"(<IsWithinPathTrackingBounds tracking_feedback="{goal}" max_error_left="0.5"
      max_error_right="0.2" max_error_heading="1.0"/>)");
    QCOMPARE(played.tick(), kFailure);  // there is no feedback yet
    const auto within = [&](double position, double heading) {
      played.host.tracked = {3, position, heading, 0, 0.0, 0.0};
      return played.tick() == kSuccess;
    };
    QVERIFY(within(0.4, 0.0) && !within(0.6, 0.0));     // left
    QVERIFY(within(-0.15, 0.0) && !within(-0.3, 0.0));  // right
    QVERIFY(within(0.0, -0.9) && !within(0.0, 1.1));
  }

  void collisionMonitor_isToggled() {
    Played played(R"(<Sequence><ToggleCollisionMonitor enable="false"/>
      <ToggleCollisionMonitor enable="true"/></Sequence>)");
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(played.host.text(), std::string("monitor-off monitor-on"));
  }

  void errorText_isWritten() {
    for (const char* node :
         {"<ComputePathToPose goal=\"{goal}\" ", "<FollowPath path=\"{goal}\" ",
          "<SmoothPath unsmoothed_path=\"{goal}\" ", "<Spin ", "<BackUp ", "<DriveOnHeading ",
          "<Wait ", "<NavigateToPose goal=\"{goal}\" ", "<ComputeRoute goal=\"{goal}\" "}) {
      Played played(std::string(node) + "error_msg=\"{text}\" error_code_id=\"{code}\"/>");
      for (const auto action :
           {RobotAction::ComputePath, RobotAction::FollowPath, RobotAction::SmoothPath,
            RobotAction::Spin, RobotAction::BackUp, RobotAction::DriveOnHeading, RobotAction::Wait,
            RobotAction::NavigateToPose, RobotAction::ComputeRoute}) {
        played.host.script[action] = {{State::Failed, 77, 1}};
      }
      QCOMPARE(played.play(5), kFailure);
      QCOMPARE(textEntry(played, "text"), std::string("as the script has it"));
      QCOMPARE(entry(played, "code"), 77);
    }
  }

  void computePath_viaPoints_areHandedOn() {
    Played played(R"(<ComputePathToPose goal="{goal}" viapoints="{goals}"/>)");
    const bt::PathId via = goalsAt(played, {1.0, 2.0});
    played.state->set(played.program->hostSlot(1), static_cast<int>(via));
    played.tick();
    QCOMPARE(played.host.last.viaPoints, via);
  }

  void computePathThroughPoses_lastReached_isWritten() {
    Played played(R"(<ComputePathThroughPoses goals="{goals}" last_reached_index="{reached}"/>)");
    played.host.lastReached = 2;
    QCOMPARE(played.play(5), kSuccess);
    QCOMPARE(entry(played, "reached"), 2);
  }

  void navigate_ports_areHandedOnAndCancelled() {
    Played played(R"(<Sequence><NavigateToPose goal="{goal}" behavior_tree="a.xml"/>
      <NavigateThroughPoses goals="{goals}"/></Sequence>)");
    played.host.script[RobotAction::NavigateThroughPoses] = {{State::Succeeded, 0, 0}};
    played.tick();
    QCOMPARE(played.host.last.tree, std::string("a.xml"));
    QCOMPARE(played.host.last.path, played.host.goal);
    played.play(3);
    QCOMPARE(played.host.text(), std::string("to-pose through-poses"));
    played.state->halt({played.step, 0.05, static_cast<bt::NavigatorHost*>(&played.host)});
    QCOMPARE(played.host.log.back(), std::string("cancel"));
  }

  void computeRoute_idsOrPoses_areHandedOn() {
    Played ids(R"(<ComputeRoute goal_id="7" start_id="3" use_poses="false"/>)");
    ids.tick();
    QVERIFY(!ids.host.last.usesPoses && ids.host.last.goalId == 7 && ids.host.last.startId == 3);
    Played poses(R"(<ComputeRoute goal="{goal}" use_poses="true" start="{goals}"
      use_start="true"/>)");
    poses.tick();
    QVERIFY(poses.host.last.usesPoses && poses.host.last.path == poses.host.goal);
    QCOMPARE(poses.host.last.start, std::optional<bt::PathId>(poses.host.goal));
    Played usual(R"(<ComputeRoute goal="{goal}" start="{goals}"/>)");
    usual.tick();
    QVERIFY(usual.host.last.usesPoses && !usual.host.last.start);
  }

  void trackRoute_feedback_isWritten() {
    Played played(R"(<ComputeAndTrackRoute goal="{goal}" last_node_id="{last}"
      next_node_id="{next}" current_edge_id="{edge}" rerouted="{again}" path="{path}"
      route="{route}"/>)");
    played.host.script[RobotAction::ComputeAndTrackRoute] = {{State::Succeeded, 0, 5}};
    played.host.progress = {1, played.host.goal, 0, 4, 0, false};
    played.tick();
    played.tick();
    QCOMPARE(entry(played, "next"), 4);
    QCOMPARE(entry(played, "route"), static_cast<int>(played.host.goal));
    played.host.progress = {2, played.host.goal, 4, 5, 11, true};
    played.tick();
    QCOMPARE(entry(played, "last"), 4);
    QCOMPARE(entry(played, "edge"), 11);
    QCOMPARE(textEntry(played, "again"), std::string("true"));
    QCOMPARE(played.play(9), kSuccess);
  }

  void trackRoute_otherGoal_isANewRequest() {
    Played played(R"(<ComputeAndTrackRoute goal="{goal}"/>)");
    played.host.script[RobotAction::ComputeAndTrackRoute] = {{State::Succeeded, 0, 0}};
    played.play(3);
    QCOMPARE(played.host.text(), std::string("track"));
    played.setGoal(played.host.paths().add({{{3.0, 0.0}, 0.0}}));
    played.play(3);
    QCOMPARE(played.host.text(), std::string("track track"));
  }

  void trackRoute_cancelled_ends() {
    Played played(R"(<Parallel success_count="2"><ComputeAndTrackRoute goal="{goal}"/>
      <CancelComputeAndTrackRoute/></Parallel>)");
    played.host.script[RobotAction::ComputeAndTrackRoute] = {{State::Succeeded, 0, 0}};
    QCOMPARE(played.play(5), kSuccess);
    QCOMPARE(played.host.text(), std::string("track cancel"));
  }

  void extractRouteNodes_areGoals() {
    Played played(R"(<ExtractRouteNodesAsGoals route="{goals}" goals="{out}"/>)");
    played.state->set(played.program->hostSlot(1), static_cast<int>(goalsAt(played, {1.0, 2.0})));
    QCOMPARE(played.tick(), kSuccess);
    QCOMPARE(pathEntry(played, "out").size(), std::size_t{2});
    played.state->set(played.program->hostSlot(1), 0);
    QCOMPARE(played.tick(), kFailure);
  }
};

QTEST_GUILESS_MAIN(RobotServicesTest)
#include "tst_RobotServices.moc"
