#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/Nav2Robots.h"
#include "sim2d/base/Text.h"
#include "tests/run/Nav2Scene.h"

/// Runs of robots that dock, are charged, follow somebody, are driven by hand or have a task at
/// each of their goals, by trees of Nav2.
class Nav2DockRunsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void tree_docksAndUndocks();
  void tree_docksWhenTheBatteryIsLow();
  void tree_thatDocksNowhere_fails();
  void person_isFollowed();
  void teleoperator_isSlowedBeforeAWall();
  void teleoperation_withoutATeleoperator_timesOut();
  void waypoints_arePausedAt();
  void waypoints_arePhotographed();
};

namespace {

using namespace nav2scene;
using base::Vec2;
using Words = std::vector<std::string>;

/// A plane with a person who walks along y = 6 m and one robot from the origin.
std::string planeWith(const std::string& name, const std::string& robot,
                      const std::string& block = {}) {
  return written(name + ".yaml",
                 planeText(kAtOrigin + robot + block, {"0.3", "x: 2.0, y: 3.0", "4", "Impassive"},
                           R"(      1: {x: 2.0, y: 0.0}
      2: {x: 4.0, y: 0.0}
      3: {x: 30.0, y: 30.0}
      4: {x: 8.0, y: 3.0}
)"));
}

const std::string kFar = "      goals: [3]\n";
const std::string kDock =
    "    docks: [dock1]\n    dock1: {kind: charging, x: 3.0, y: -1.0, h: 0.0}\n";

/// A tree of one node.
std::string treeWith(const std::string& name, const std::string& nodes) {
  return written(name + ".xml",
                 "<root BTCPP_format=\"4\" main_tree_to_execute=\"MainTree\">\n"
                 "<BehaviorTree ID=\"MainTree\">\n" +
                     nodes + "</BehaviorTree>\n</root>\n");
}

/// Nav2's file with further behaviours and nodes.
std::string paramsWith(const std::string& name, const std::string& nodes) {
  return written(name + ".yaml", textOf(SOURCE_DIR "/maps/planners/nav2_rpp.yaml") + nodes);
}

struct Driven {
  std::vector<Vec2> places;
  std::vector<double> speeds, headings;
  Words events;  // "dock docked dock1" … of the robot, in order
  std::vector<double> eventTimes;
  std::string problems;
  double time = 0.0;
  bool hasRun = false;
  Vec2 person = Vec2::Zero();
};

Driven drive(const std::string& scenario, const std::string& params, const std::string& tree,
             double seconds, const std::function<sim2d::StepInputs(double)>& inputs = {}) {
  app::RunSpec options;
  options.scenario = scenario;
  options.nav2Params = {params};
  options.nav2Tree = tree;
  options.nav2Distro = "main";
  const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
  app::Verdict verdict = app::check(bundle);
  Driven driven;
  driven.problems = problemsText(verdict.problems);
  if (!verdict.world) {
    return driven;
  }
  driven.hasRun = true;
  sim2d::World& world = *verdict.world;
  while (!world.arrivedAt() && world.time() < seconds &&
         world.step(inputs ? inputs(world.time()) : sim2d::StepInputs())) {
    const sim2d::Frame& frame = world.frame();
    driven.places.emplace_back(frame.robots.x[0], frame.robots.y[0]);
    driven.headings.push_back(frame.robots.heading[0]);
    driven.speeds.push_back(std::hypot(frame.robots.vx[0], frame.robots.vy[0]));
    driven.person = Vec2(frame.humans.x[0], frame.humans.y[0]);
    for (const sim2d::Event& event : frame.events) {
      const bool isTold =
          event.kind == sim2d::EventKind::Dock || event.kind == sim2d::EventKind::Photo ||
          event.kind == sim2d::EventKind::Battery || event.kind == sim2d::EventKind::Goal;
      if (event.id == -1 && isTold) {
        driven.events.push_back(std::string(eventKindName(event.kind)) + " " + event.text);
        driven.eventTimes.push_back(frame.time);
      }
    }
  }
  driven.time = world.time();
  return driven;
}

std::string wordsOf(const Driven& driven) {
  return base::join(driven.events, ", ") + "\n" + driven.problems;
}

}  // namespace

/// The dock is 3 m away: planner and controller drive to 0.7 m before it, the docking controller
/// into it.
void Nav2DockRunsTest::tree_docksAndUndocks() {
  const Driven driven =
      drive(planeWith("dock_plain", kFar, kDock), SOURCE_DIR "/maps/planners/nav2_rpp.yaml",
            treeWith("dock_plain_tree",
                     "<Sequence><DockRobot dock_id=\"dock1\" error_code_id=\"{code}\"/>"
                     "<UndockRobot dock_type=\"\"/></Sequence>\n"),
            60.0);
  QVERIFY2(driven.hasRun, driven.problems.c_str());
  QVERIFY2(driven.events == (Words{"dock docked dock1", "dock undocked dock1"}),
           wordsOf(driven).c_str());
  double nearest = 10.0;
  for (const Vec2& place : driven.places) {
    nearest = std::min(nearest, (place - Vec2(3.0, -1.0)).norm());
  }
  QVERIFY2(nearest < 0.05, qPrintable(QString::number(nearest)));
  // It stands where it came out: 0.7 m before the dock.
  QVERIFY2((driven.places.back() - Vec2(2.3, -1.0)).norm() < 0.15,
           qPrintable(QString::number(driven.places.back().x())));
  QVERIFY(std::fabs(driven.headings.back()) < 0.15);
  QVERIFY(driven.speeds.back() < 0.26);
}

/// 1 Wh = 3600 J: from 0.5 to 0.45 it has 180 J, about 4 s of driving; then it docks, is charged
/// to 0.6 and drives on.
void Nav2DockRunsTest::tree_docksWhenTheBatteryIsLow() {
  const std::string battery = "      battery: {capacity: 1.0, level: 0.5}\n";
  const Driven driven =
      drive(planeWith("dock_low", kFar + battery, kDock), SOURCE_DIR "/maps/planners/nav2_rpp.yaml",
            treeWith("dock_low_tree", R"(
<Sequence>
  <KeepRunningUntilFailure>
    <Inverter><IsBatteryLow min_battery="0.45" battery_topic="/battery_state"/></Inverter>
  </KeepRunningUntilFailure>
  <AlwaysFailure/>
</Sequence>
)"),
            5.0);
  QVERIFY2(driven.hasRun, driven.problems.c_str());
  const Driven charged =
      drive(planeWith("dock_low_2", kFar + battery, kDock),
            SOURCE_DIR "/maps/planners/nav2_rpp.yaml", treeWith("dock_low_2_tree", R"(
<Sequence>
  <ReactiveFallback>
    <IsBatteryLow min_battery="0.45" battery_topic="/battery_state"/>
    <PipelineSequence>
      <RateController hz="1.0"><ComputePathToPose goal="{goal}" path="{path}"/></RateController>
      <FollowPath path="{path}"/>
    </PipelineSequence>
  </ReactiveFallback>
  <DockRobot dock_id="dock1"/>
  <IsBatteryCharging battery_topic="/battery_state"/>
  <RetryUntilSuccessful num_attempts="1000">
    <Inverter><IsBatteryLow min_battery="0.5" battery_topic="/battery_state"/></Inverter>
  </RetryUntilSuccessful>
  <UndockRobot dock_type=""/>
</Sequence>
)"),
            90.0);
  QVERIFY2(charged.hasRun, charged.problems.c_str());
  QVERIFY2(
      charged.events == (Words{"battery charging", "dock docked dock1", "dock undocked dock1"}),
      wordsOf(charged).c_str());
  // 180 J with 20 to 80 W take 2.3 to 9 s; until then it drives to its goal, after that to the
  // dock.
  double farthest = 0.0;
  for (std::size_t i = 0; i < charged.places.size() && i < 180; ++i) {
    farthest = std::max(farthest, charged.places[i].y());
  }
  QVERIFY2(farthest > 0.5, qPrintable(QString::number(farthest)));
}

void Nav2DockRunsTest::tree_thatDocksNowhere_fails() {
  const Driven driven = drive(
      planeWith("dock_nowhere", kFar, kDock), SOURCE_DIR "/maps/planners/nav2_rpp.yaml",
      treeWith("dock_nowhere_tree",
               "<Fallback><DockRobot dock_id=\"attic\" error_code_id=\"{code}\"/>"
               "<Sequence><AreErrorCodesPresent error_code=\"{code}\" "
               "error_codes_to_check=\"901\"/><Spin spin_dist=\"1.57\"/></Sequence></Fallback>\n"),
      10.0);
  QVERIFY2(driven.hasRun, driven.problems.c_str());
  QVERIFY(driven.events.empty());
  QVERIFY2(driven.headings.back() > 1.4, qPrintable(QString::number(driven.headings.back())));
}

/// She walks 6 m at 0.3 m/s, and a little farther as the robot comes near; the controller may drive
/// 0.25 m/s and catches up once she is slower. Filtered poses of a topic lag behind by 0.45 s of
/// her way (weight 0.1 in each 0.05 s).
void Nav2DockRunsTest::person_isFollowed() {
  for (const std::string port : {"tracked_frame=\"anna\"", "tracked_frame=\"1\"",
                                 "pose_topic=\"/anna/pose\"", "pose_topic=\"detected_pose\""}) {
    const Driven driven = drive(
        planeWith("follow_anna", kFar), SOURCE_DIR "/maps/planners/nav2_rpp.yaml",
        treeWith("follow_anna_tree", "<FollowObject " + port + " max_duration=\"95\"/>\n"), 90.0);
    QVERIFY2(driven.hasRun, driven.problems.c_str());
    const Vec2 line = driven.person - driven.places.back();
    const double distance = line.norm();
    QVERIFY2(distance > 0.9 && distance < 1.4,
             qPrintable(QString::number(distance) + QString::fromStdString(port)));
    QVERIFY(driven.person.x() > 7.0);
    QVERIFY(std::fabs(base::wrapToPi(base::headingOf(line) - driven.headings.back())) < 0.3);
  }
}

namespace {

sim2d::StepInputs ahead(double /*time*/) {
  sim2d::Input input;
  input.kind = sim2d::InputKind::Robot;
  input.id = -1;
  input.velocity = Vec2(0.5, 0.0);
  return {input};
}

}  // namespace

/// A person drives at 0.5 m/s towards a wall at x = 3 m: scaled by what is left until a contact
/// within 1 s, the robot does not touch it.
void Nav2DockRunsTest::teleoperator_isSlowedBeforeAWall() {
  const Driven driven = drive(
      planeWith("teleop_wall", kFar,
                "    obstacles: [wall1]\n    wall1: {kind: wall, xs: [3.0, 3.0], ys: [-4.0, 4.0], "
                "thickness: 0.2}\n"),
      SOURCE_DIR "/maps/planners/nav2_rpp.yaml",
      treeWith("teleop_tree", "<AssistedTeleop time_allowance=\"30.0\" is_recovery=\"false\"/>\n"),
      25.0, ahead);
  QVERIFY2(driven.hasRun, driven.problems.c_str());
  QVERIFY2(driven.speeds[60] > 0.45, qPrintable(QString::number(driven.speeds[60])));
  QVERIFY2(driven.places.back().x() > 1.8 && driven.places.back().x() < 2.56,
           qPrintable(QString::number(driven.places.back().x())));
  QVERIFY(driven.speeds.back() < 0.1);
}

void Nav2DockRunsTest::teleoperation_withoutATeleoperator_timesOut() {
  const Driven driven =
      drive(planeWith("teleop_alone", kFar), SOURCE_DIR "/maps/planners/nav2_rpp.yaml",
            treeWith("teleop_alone_tree",
                     "<Fallback><AssistedTeleop time_allowance=\"3.0\" error_code_id=\"{code}\"/>"
                     "<Spin spin_dist=\"1.57\"/></Fallback>\n"),
            10.0);
  QVERIFY2(driven.hasRun, driven.problems.c_str());
  const auto turned = std::find_if(driven.headings.begin(), driven.headings.end(),
                                   [](double heading) { return heading > 0.01; });
  const double begun = 0.05 * static_cast<double>(turned - driven.headings.begin());
  QVERIFY2(begun > 2.9 && begun < 3.6, qPrintable(QString::number(begun)));
}

namespace {

const std::string kWaypoints =
    "      goals: [1, 2]\n      planner_parameters: {waypoint_tasks: 1}\n";

/// Longest time within 30 cm of a place [s].
double stayAt(const Driven& driven, const Vec2& place) {
  double longest = 0.0, now = 0.0;
  for (std::size_t i = 0; i < driven.places.size(); ++i) {
    const bool stands = (driven.places[i] - place).norm() < 0.3 && driven.speeds[i] < 0.02;
    now = stands ? now + 0.05 : 0.0;
    longest = std::max(longest, now);
  }
  return longest;
}

}  // namespace

void Nav2DockRunsTest::waypoints_arePausedAt() {
  const std::string tree =
      SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
  const std::string params =
      paramsWith("waypoint_wait",
                 "waypoint_follower:\n  ros__parameters:\n    wait_at_waypoint:\n"
                 "      plugin: \"nav2_waypoint_follower::WaitAtWaypoint\"\n"
                 "      enabled: true\n      waypoint_pause_duration: 4000\n");
  const Driven paused = drive(planeWith("waypoints_wait", kWaypoints), params, tree, 60.0);
  QVERIFY2(paused.hasRun, paused.problems.c_str());
  QCOMPARE(paused.events, (Words{"goal 1", "goal 2"}));
  // It takes a moment to stand.
  QVERIFY2(stayAt(paused, {2.0, 0.0}) > 3.0, qPrintable(QString::number(stayAt(paused, {2, 0}))));
  const Driven direct =
      drive(planeWith("waypoints_direct", "      goals: [1, 2]\n"), params, tree, 60.0);
  QVERIFY(stayAt(direct, {2.0, 0.0}) < 2.0);
  const double later = paused.eventTimes[1] - direct.eventTimes[1];
  QVERIFY2(later > 3.5 && later < 5.5, qPrintable(QString::number(later)));
}

void Nav2DockRunsTest::waypoints_arePhotographed() {
  const std::string tree =
      SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
  const std::string params = paramsWith(
      "waypoint_photo",
      "waypoint_follower:\n  ros__parameters:\n    waypoint_task_executor_plugin: camera\n"
      "    camera:\n      plugin: \"nav2_waypoint_follower::PhotoAtWaypoint\"\n"
      "      save_dir: \"/tmp/images\"\n");
  const Driven driven = drive(planeWith("waypoints_photo", kWaypoints), params, tree, 60.0);
  QVERIFY2(driven.hasRun, driven.problems.c_str());
  QVERIFY2(driven.events.size() >= 3, wordsOf(driven).c_str());
  QCOMPARE(driven.events[0], std::string("goal 1"));
  QCOMPARE(driven.events[1].substr(0, 8), std::string("photo 1."));  // x, y, heading
  QCOMPARE(base::split(driven.events[1], ' ').size(), std::size_t{4});
}

QTEST_GUILESS_MAIN(Nav2DockRunsTest)
#include "tst_Nav2DockRuns.moc"
