#include <algorithm>
#include <cctype>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "bt/robot/Nav2Servers.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "tests/bt/ScriptedNavigator.h"

namespace {

using namespace navigator;
using sim2d::nav2::ParameterFile;

/// Two of everything that a tree can choose, costmaps in the map frame that are updated in each
/// step and never cleared by beams.
const char* const kParameters = R"(
controller_server:
  ros__parameters:
    controller_frequency: 20.0
    controller_plugins: [FollowPath, Slow]
    goal_checker_plugins: [near, far]
    progress_checker_plugins: [usual, hasty]
    FollowPath: {plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController", desired_linear_vel: 0.5, use_rotate_to_heading: false}
    Slow: {plugin: "nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController", desired_linear_vel: 0.2}
    near: {plugin: "nav2_controller::SimpleGoalChecker", xy_goal_tolerance: 0.25, yaw_goal_tolerance: 6.3}
    far: {plugin: "nav2_controller::SimpleGoalChecker", xy_goal_tolerance: 1.5, yaw_goal_tolerance: 6.3}
    usual: {plugin: "nav2_controller::SimpleProgressChecker", required_movement_radius: 0.1, movement_time_allowance: 10.0}
    hasty: {plugin: "nav2_controller::SimpleProgressChecker", required_movement_radius: 9.0, movement_time_allowance: 1.0}
local_costmap:
  local_costmap:
    ros__parameters:
      global_frame: map
      rolling_window: true
      width: 6
      height: 6
      resolution: 0.05
      robot_radius: 0.1
      update_frequency: 20.0
      publish_frequency: 20.0
      plugins: [obstacles]
      obstacles:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        observation_sources: scan
        scan: {topic: /scan, data_type: LaserScan, clearing: false, marking: true, max_obstacle_height: 2.0, obstacle_max_range: 2.5}
global_costmap:
  global_costmap:
    ros__parameters:
      global_frame: map
      resolution: 0.05
      robot_radius: 0.1
      update_frequency: 20.0
      publish_frequency: 20.0
      plugins: [static_layer, obstacles]
      static_layer: {plugin: "nav2_costmap_2d::StaticLayer"}
      obstacles:
        plugin: "nav2_costmap_2d::ObstacleLayer"
        observation_sources: scan
        scan: {topic: /scan, data_type: LaserScan, clearing: false, marking: true, max_obstacle_height: 2.0, obstacle_max_range: 2.5}
planner_server:
  ros__parameters:
    planner_plugins: [GridBased, Second]
    GridBased: {plugin: "nav2_navfn_planner::NavfnPlanner"}
    Second: {plugin: "nav2_smac_planner::SmacPlanner2D"}
smoother_server:
  ros__parameters:
    smoother_plugins: [simple, Second]
    simple: {plugin: "nav2_smoother::SimpleSmoother"}
    Second: {plugin: "nav2_smoother::SavitzkyGolaySmoother"}
behavior_server:
  ros__parameters:
    cycle_frequency: 20.0
    behavior_plugins: [spin, backup, drive_on_heading, wait, assisted_teleop]
    spin: {plugin: "nav2_behaviors::Spin"}
    backup: {plugin: "nav2_behaviors::BackUp"}
    drive_on_heading: {plugin: "nav2_behaviors::DriveOnHeading"}
    wait: {plugin: "nav2_behaviors::Wait"}
    assisted_teleop: {plugin: "nav2_behaviors::AssistedTeleop"}
    global_frame: map
    local_frame: odom
)";

std::unique_ptr<bt::Nav2Servers> makeServers(const std::string& topics, Distro distro) {
  const auto file = ParameterFile::parse(kParameters, "nav2.yaml");
  const auto messages = bt::NavigatorTopics::read(topics);
  if (!file || !messages) {
    return nullptr;
  }
  constexpr std::size_t kColumns = 200, kRows = 120;  // 10 m x 6 m
  bt::Nav2Servers::Setup setup;
  setup.parameters = readNav2Parameters(*file, {distro, {}}).parameters;
  setup.map = sim2d::OccupancyGrid(kColumns, kRows, 0.05, {},
                                   std::vector<std::int8_t>(kColumns * kRows, 0));
  setup.topics = *messages;
  auto made = bt::Nav2Servers::make(std::move(setup));
  return made ? *std::move(made) : nullptr;
}

/// A robot at (2.025, 3.025) in a plane of 10 m x 6 m that does what Nav2's servers command.
class Robot {
 public:
  explicit Robot(const std::string& nodes, const std::string& topics = "",
                 Distro distro = Distro::Jazzy)
      : servers(makeServers(topics, distro)) {
    bt::CompileOptions options;
    options.hostEntries = {{"goal", bt::PortType::Any}, {"goals", bt::PortType::Any}};
    const auto program = bt::compile(tableOf(nodes), bt::robotNodes(), options);
    tree = program ? std::make_unique<bt::TreeState>(*program) : nullptr;
    seen.pose = {{2.025, 3.025}, 0.0};
    set("goal", {{{6.025, 3.025}, 0.0}});
    Path straight;
    for (int i = 0; i <= 40; ++i) {
      straight.push_back({{2.025 + 0.1 * i, 3.025}, 0.0});
    }
    set("path", straight);
  }

  std::unique_ptr<bt::Nav2Servers> servers;
  std::unique_ptr<bt::TreeState> tree;
  sim2d::Observation seen;
  sim2d::BodyTwist command;
  double fastest = 0.0;  // [m/s]
  long long ticks = 0;

  void set(const char* entry, const Path& path) {
    const int slot = tree->program().findSlot(entry);
    if (slot >= 0) {
      tree->set(slot, static_cast<int>(servers->paths().add(path)));
    }
  }
  int number(const char* entry) const {
    return bt::valueAs<int>(tree->get(tree->program().findSlot(entry))).value_or(-1);
  }
  const Path& path(const char* entry) const { return servers->paths().get(number(entry)); }

  NodeStatus step() {
    seen.scan = scan_.distances.empty() ? nullptr : &scan_;
    servers->sense(seen);
    const NodeStatus status =
        tree->tickOnce({++ticks, seen.dt, static_cast<bt::NavigatorHost*>(servers.get())});
    command = servers->act();
    fastest = std::max(fastest, std::fabs(command.linear));
    seen.pose.position += command.linear * seen.dt * seen.pose.direction();
    seen.pose.heading += command.angular * seen.dt;
    seen.motion = command;
    seen.time += seen.dt;
    return status;
  }
  /// Until the tree has ended, at most that many steps.
  NodeStatus play(int most) {
    NodeStatus status = kRunning;
    for (int i = 0; i < most && status == kRunning; ++i) {
      status = step();
    }
    return status;
  }
  /// The next scan: beams to the front, left, back and right [m]; 30: no hit.
  void scan(const std::vector<double>& distances) {
    scan_.sensor = seen.pose;
    scan_.time = seen.time;
    scan_.angleIncrement = 0.5 * M_PI;
    scan_.distances = distances;
  }
  /// Whether a place, given relative to the start, is an obstacle.
  bool isOccupied(bool isLocal, double x, double y) const {
    const auto cost = servers->costAt(isLocal, {{2.025 + x, 3.025 + y}, 0.0}, false);
    return cost && *cost == 254;
  }

 private:
  sim2d::LaserScan scan_;
};

/// A tree that selects a name and uses it.
std::string selecting(const std::string& kind, const std::string& usual, const std::string& use) {
  std::string node = kind;  // goal_checker: GoalChecker
  for (std::size_t i = 0; i < node.size(); ++i) {
    const bool isFirst = i == 0 || node[i - 1] == '_';
    node[i] = isFirst ? static_cast<char>(std::toupper(node[i])) : node[i];
  }
  node.erase(std::remove(node.begin(), node.end(), '_'), node.end());
  return "<Sequence><" + node + "Selector default_" + kind + "=\"" + usual + "\" selected_" + kind +
         "=\"{name}\"/>" + use + "</Sequence>";
}

const std::string kFollow =
    R"(<FollowPath path="{path}" controller_id="FollowPath" goal_checker_id="near" progress_checker_id="usual" error_code_id="{code}"/>)";

/// kFollow with a selected name in one port.
std::string followWith(const std::string& port, const std::string& usual) {
  std::string text = kFollow;
  const std::string given = port + "=\"" + usual + "\"";
  return text.replace(text.find(given), given.size(), port + "=\"{name}\"");
}

}  // namespace

/// What nodes of trees do to a robot that Nav2's servers drive in an empty plane.
class Nav2NodeEffectsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cancel_runningAction_stopsTheRobot_data() {
    QTest::addColumn<QString>("action");
    QTest::addColumn<QString>("cancel");
    QTest::addColumn<bool>("moves");
    QTest::newRow("control") << QString::fromStdString(kFollow) << "CancelControl" << true;
    QTest::newRow("spin") << "<Spin spin_dist=\"3\"/>"
                          << "CancelSpin" << true;
    QTest::newRow("backup") << "<BackUp backup_dist=\"1\" backup_speed=\"0.2\"/>"
                            << "CancelBackUp" << true;
    QTest::newRow("drive") << "<DriveOnHeading dist_to_travel=\"1\" speed=\"0.2\"/>"
                           << "CancelDriveOnHeading" << true;
    QTest::newRow("wait") << "<Wait wait_duration=\"5\"/>"
                          << "CancelWait" << false;
    QTest::newRow("teleop") << "<AssistedTeleop/>"
                            << "CancelAssistedTeleop" << false;
  }

  /// After half a second; each action would take longer than two.
  void cancel_runningAction_stopsTheRobot() {
    QFETCH(QString, action);
    QFETCH(QString, cancel);
    QFETCH(bool, moves);
    Robot robot("<Parallel success_count=\"2\">" + action.toStdString() +
                "<Delay delay_msec=\"500\"><" + cancel.toStdString() + "/></Delay></Parallel>");
    QCOMPARE(robot.play(10), kRunning);
    QCOMPARE(std::fabs(robot.command.linear) + std::fabs(robot.command.angular) > 0.1, moves);
    QCOMPARE(robot.play(5), kSuccess);
    for (int i = 0; i < 20; ++i) {
      robot.servers->sense(robot.seen);
      robot.command = robot.servers->act();
      robot.seen.time += robot.seen.dt;
    }
    QCOMPARE(robot.command.linear, 0.0);
    QCOMPARE(robot.command.angular, 0.0);
    // Without the cancellation it still runs.
    Robot other(action.toStdString());
    QCOMPARE(other.play(40), kRunning);
  }

  void clear_partsOfACostmap_data() {
    QTest::addColumn<QString>("node");
    QTest::addColumn<bool>("isLocal");
    QTest::addColumn<bool>("keepsNear");
    QTest::addColumn<bool>("keepsFar");
    const auto row = [](const char* node, const char* service, const char* ports, bool local,
                        bool keepsNear, bool keepsFar) {
      QTest::newRow(service) << QStringLiteral("<%1 service_name=\"%2\" %3/>")
                                    .arg(QLatin1String(node), QLatin1String(service),
                                         QLatin1String(ports))
                             << local << keepsNear << keepsFar;
    };
    // One obstacle 0.5 m in front of the robot, one 1 m to its left.
    row("ClearEntireCostmap", "local_costmap/clear_entirely_local_costmap", "", true, false, false);
    row("ClearEntireCostmap", "global_costmap/clear_entirely_global_costmap", "", false, false,
        false);
    row("ClearCostmapAroundRobot", "local_costmap/clear_around_local_costmap",
        "reset_distance=\"1.4\"", true, false, true);
    row("ClearCostmapAroundRobot", "global_costmap/clear_around_global_costmap",
        "reset_distance=\"0.8\"", false, true, true);
    row("ClearCostmapExceptRegion", "local_costmap/clear_except_local_costmap",
        "reset_distance=\"1.4\"", true, true, false);
    row("ClearCostmapExceptRegion", "global_costmap/clear_except_global_costmap",
        "reset_distance=\"0.8\"", false, false, false);
    row("ClearCostmapAroundPose", "local_costmap/clear_around_pose_local_costmap",
        "pose=\"{place}\" reset_distance=\"0.4\"", true, true, false);
    row("ClearCostmapAroundPose", "global_costmap/clear_around_pose_global_costmap",
        "pose=\"{place}\" reset_distance=\"2.4\"", false, false, false);
  }

  void clear_partsOfACostmap() {
    QFETCH(QString, node);
    QFETCH(bool, isLocal);
    QFETCH(bool, keepsNear);
    QFETCH(bool, keepsFar);
    Robot robot("<Sequence><Wait wait_duration=\"0.3\"/>" + node.toStdString() + "</Sequence>");
    robot.set("place", {{{2.025, 4.025}, 0.0}});
    robot.scan({0.5, 1.0, 30.0, 30.0});
    robot.step();
    robot.step();
    for (const bool local : {true, false}) {
      QVERIFY(robot.isOccupied(local, 0.5, 0.0) && robot.isOccupied(local, 0.0, 1.0));
    }
    robot.scan({30.0, 30.0, 30.0, 30.0});  // from now on nothing is marked
    QCOMPARE(robot.play(20), kSuccess);
    robot.step();
    QCOMPARE(robot.isOccupied(isLocal, 0.5, 0.0), keepsNear);
    QCOMPARE(robot.isOccupied(isLocal, 0.0, 1.0), keepsFar);
    QVERIFY(robot.isOccupied(!isLocal, 0.5, 0.0) && robot.isOccupied(!isLocal, 0.0, 1.0));
  }

  void selectors_controller_hasItsSpeed() {
    const std::string tree =
        selecting("controller", "FollowPath", followWith("controller_id", "FollowPath"));
    Robot usual(tree), slow(tree, "0 controller_selector Slow");
    QCOMPARE(usual.play(60), kRunning);
    QCOMPARE(slow.play(60), kRunning);
    QVERIFY(std::fabs(usual.fastest - 0.5) < 1e-6);
    QVERIFY(std::fabs(slow.fastest - 0.2) < 1e-6);
    Robot unknown(tree, "0 controller_selector Nowhere");
    QCOMPARE(unknown.play(60), kFailure);
    QCOMPARE(unknown.number("code"), 101);
  }

  void selectors_goalChecker_hasItsTolerance() {
    const std::string tree =
        selecting("goal_checker", "near", followWith("goal_checker_id", "near"));
    const auto distance = [&](const std::string& topics) {
      Robot robot(tree, topics);
      const bool isThere = robot.play(600) == kSuccess;
      return isThere ? 6.025 - robot.seen.pose.position.x() : -1.0;
    };
    const double near = distance(""), far = distance("0 goal_checker_selector far");
    QVERIFY2(near > 0.1 && near <= 0.25, std::to_string(near).c_str());
    QVERIFY2(far > 1.35 && far <= 1.5, std::to_string(far).c_str());
    QCOMPARE(distance("0 goal_checker_selector nowhere"), -1.0);
  }

  void selectors_progressChecker_hasItsPatience() {
    const std::string tree =
        selecting("progress_checker", "usual", followWith("progress_checker_id", "usual"));
    Robot usual(tree), hasty(tree, "0 progress_checker_selector hasty");
    QCOMPARE(usual.play(40), kRunning);
    QCOMPARE(hasty.play(40), kFailure);
    QCOMPARE(hasty.number("code"), 105);  // FAILED_TO_MAKE_PROGRESS
    QVERIFY(hasty.ticks >= 20);           // 1 s
  }

  void selectors_pathHandler_isFoundByName() {
    const std::string tree = selecting(
        "path_handler", "PathHandler",
        R"(<FollowPath path="{path}" controller_id="FollowPath" goal_checker_id="near" progress_checker_id="usual" path_handler_id="{name}" error_code_id="{code}"/>)");
    Robot usual(tree, "", Distro::Main), unknown(tree, "0 path_handler_selector no", Distro::Main);
    QCOMPARE(usual.play(20), kRunning);
    QCOMPARE(unknown.play(20), kFailure);
    QCOMPARE(unknown.number("code"), 100);
  }

  void selectors_planner_makesThePlan() {
    const std::string tree = selecting(
        "planner", "GridBased",
        R"(<ComputePathToPose goal="{aside}" path="{plan}" planner_id="{name}" error_code_id="{code}"/>)");
    const auto plan = [&](const std::string& topics) {
      Robot robot(tree, topics);
      robot.set("aside", {{{7.0, 5.0}, 0.0}});
      const NodeStatus status = robot.play(20);
      return std::make_pair(status == kSuccess ? 0 : robot.number("code"), robot.path("plan"));
    };
    const auto usual = plan(""), second = plan("0 planner_selector Second");
    QVERIFY(usual.first == 0 && second.first == 0);
    QVERIFY(usual.second.size() > 20 && second.second.size() > 20);
    QVERIFY(!(usual.second == second.second));
    QCOMPARE(plan("0 planner_selector Nowhere").first, 201);
  }

  void selectors_smoother_smooths() {
    const std::string tree = selecting(
        "smoother", "simple",
        R"(<SmoothPath unsmoothed_path="{corner}" smoothed_path="{smooth}" smoother_id="{name}" error_code_id="{code}"/>)");
    Path corner;
    for (int i = 0; i <= 40; ++i) {
      corner.push_back({{2.0 + 0.05 * std::min(i, 20), 3.0 + 0.05 * std::max(0, i - 20)}, 0.0});
    }
    const auto smoothed = [&](const std::string& topics) {
      Robot robot(tree, topics);
      robot.set("corner", corner);
      const NodeStatus status = robot.play(20);
      return std::make_pair(status == kSuccess ? 0 : robot.number("code"), robot.path("smooth"));
    };
    const auto usual = smoothed(""), second = smoothed("0 smoother_selector Second");
    QVERIFY(usual.first == 0 && second.first == 0);
    QVERIFY(!usual.second.empty() && !(usual.second == corner));
    QVERIFY(!second.second.empty() && !(usual.second == second.second));
    QCOMPARE(smoothed("0 smoother_selector Nowhere").first, 501);
  }

  void plan_startAndViaPoints_areOnThePath() {
    const auto plan = [](const std::string& ports) {
      Robot robot("<ComputePathToPose goal=\"{goal}\" path=\"{plan}\" planner_id=\"GridBased\" " +
                      ports + "/>",
                  "", Distro::Main);
      robot.set("start", {{{4.025, 1.025}, 0.0}});
      robot.set("via", {{{4.025, 5.025}, 0.0}});
      return robot.play(20) == kSuccess ? robot.path("plan") : Path();
    };
    const auto nearest = [](const Path& path, const base::Vec2& place) {
      double least = 1e9;
      for (const base::Pose2& pose : path) {
        least = std::min(least, (pose.position - place).norm());
      }
      return least;
    };
    const base::Vec2 robot(2.025, 3.025), start(4.025, 1.025), via(4.025, 5.025);
    const Path usual = plan("");
    QVERIFY(nearest(usual, robot) < 0.1 && nearest(usual, start) > 1.0 &&
            nearest(usual, via) > 1.0);
    const Path given = plan("start=\"{start}\"");
    QVERIFY(nearest(given, start) < 0.1 && nearest(given, robot) > 1.0);
    QVERIFY(nearest(plan("start=\"{start}\" use_start=\"false\""), robot) < 0.1);
    QVERIFY(nearest(plan("viapoints=\"{via}\""), via) < 0.1);
  }

  void behaviors_limitsAndChecks() {
    const auto code = [](const std::string& node, double behind) {
      Robot robot("<Sequence><Wait wait_duration=\"0.3\"/><" + node +
                      " error_code_id=\"{code}\"/></Sequence>",
                  "", Distro::Main);
      robot.scan({30.0, 30.0, behind, 30.0});
      return robot.play(200) == kSuccess ? 0 : robot.number("code");
    };
    QCOMPARE(code("Spin spin_dist=\"3\" time_allowance=\"1\"", 30.0), 701);
    QCOMPARE(code("Spin spin_dist=\"0.5\"", 30.0), 0);
    const std::string back = "BackUp backup_dist=\"0.6\" backup_speed=\"0.2\"";
    QCOMPARE(code(back, 30.0), 0);
    QCOMPARE(code(back, 0.4), 714);
    QCOMPARE(code(back + " disable_collision_checks=\"true\"", 0.4), 0);
    QCOMPARE(code(back + " time_allowance=\"1\"", 30.0), 711);
    const std::string ahead = "DriveOnHeading dist_to_travel=\"0.6\" speed=\"0.2\"";
    QCOMPARE(code(ahead, 0.4), 0);
    QCOMPARE(code(ahead + " time_allowance=\"1\"", 30.0), 721);
  }

  /// A correction by the localization, 1 m, is no way that the robot has driven.
  void distance_frames_mapOrOdometry() {
    const auto steps = [](const std::string& frame) {
      Robot robot("<ReactiveFallback><DistanceTraveled distance=\"0.8\" " + frame +
                  "/><Wait wait_duration=\"9\"/></ReactiveFallback>");
      robot.play(3);
      robot.seen.mapToOdom = {{1.0, 0.0}, 0.0};
      robot.seen.pose.position.x() += 1.0;
      return robot.play(3);
    };
    QCOMPARE(steps(""), kSuccess);
    QCOMPARE(steps("global_frame=\"odom\""), kRunning);
    QCOMPARE(steps("global_frame=\"/map\""), kSuccess);
  }

  void smoothing_checksCollisions() {
    const auto code = [](const std::string& ports) {
      Robot robot(
          "<Sequence><Wait wait_duration=\"0.3\"/><SmoothPath unsmoothed_path=\"{path}\" "
          "smoother_id=\"Second\" error_code_id=\"{code}\" " +
          ports + "/></Sequence>");
      robot.scan({1.0, 30.0, 30.0, 30.0});  // on the path
      return robot.play(20) == kSuccess ? 0 : robot.number("code");
    };
    QCOMPARE(code(""), 0);
    QCOMPARE(code("check_for_collisions=\"true\""), 503);
  }
};

QTEST_GUILESS_MAIN(Nav2NodeEffectsTest)
#include "tst_Nav2NodeEffects.moc"
