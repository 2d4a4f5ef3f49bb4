#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <QtTest>

#include "app/run/Bundle.h"
#include "sim2d/base/Math.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/run/Nav2Scene.h"

/// Whole runs of the planner `nav2`: files like those of real robots drive from start to goal, a
/// changed parameter has its known effect, and all of it twice alike.
class Nav2RunsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shippedFiles_inShippedMaps_arrive_data();
  void shippedFiles_inShippedMaps_arrive();
  void sameRunTwice_isEqualToTheBit();
  void twoRobots_withTwoFiles_bothArrive();
  void ownTree_thatOnlySpins_spins();
  void ownTree_thatFails_isCounted();
  void backUp_withoutCollisionChecks_goesOn();
  void plannerAfterAClear_waitsAsLongAsSaid();
  void report_hasKeysDefaultsAndCounts();
  void effect_inflationRadius_keepsFartherOff();
  void effect_costScaling_goesNearer();
  void effect_lookahead_cutsCorners();
  void effect_pathAlignWeight_keepsToThePath();
  void effect_temperature_isBolderWhenLow();
  void effect_topSpeed_isKept();
  void effect_goalTolerance_stopsEarlier();
  void effect_smootherAcceleration_isKept();
  void badInput_isToldNotRun_data();
  void badInput_isToldNotRun();
  void monitor_thatIsDisabled_changesNothing();
  void bodyOfTheFile_otherThanTheRobots_isReported_data();
  void bodyOfTheFile_otherThanTheRobots_isReported();
  void errorOfTheFile_isAtItsLine_data();
  void errorOfTheFile_isAtItsLine();
};

namespace {

using namespace nav2scene;
using base::Vec2;
using Words = std::vector<std::string>;

std::string paramsFile(const std::string& name) {
  return SOURCE_DIR "/resources/nav2_params/" + name + ".yaml";
}
const std::string kTree =
    SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
const std::string kHumbleTree =
    SOURCE_DIR "/resources/nav2_trees/humble/navigate_to_pose_w_replanning_and_recovery.xml";

app::RunSpec optionsOf(const std::string& scenario, const std::string& params) {
  app::RunSpec options;
  options.scenario = scenario;
  options.planner = "nav2";
  options.nav2Params = {paramsFile(params)};
  const bool isHumble = params == "turtlebot3" || params == "tiago";
  options.nav2Tree = isHumble ? kHumbleTree : kTree;
  return options;
}

/// A plane with a box between start and goal, nobody else. The robot looks along +x.
std::string boxScenario(double heading = 0.0, bool hasBox = true) {
  const std::string turned = base::formatDecimals(heading, 3);
  std::string yaml = planeText("      start: {x: 0.0, y: 0.0, h: " + turned + R"(}
      goal: {x: 8.0, y: 0.0}
    robot2:
      start: {x: 0.0, y: 3.0, h: 0.0}
      goal: {x: 7.0, y: 3.0}
)");
  if (hasBox) {
    yaml += R"(    obstacles: [box1]
    box1: {kind: box, x: 4.0, y: 0.3, h: 0.0, length: 1.0, width: 2.0}
)";
  }
  return written("nav2_box" + base::formatDecimals(heading, 1) + (hasBox ? "b" : "") + ".yaml",
                 yaml);
}

struct Driven {
  std::vector<Vec2> places;
  std::vector<double> speeds;  // ahead [m/s]
  bool hasArrived = false;
  double time = 0.0;  // [s]
  std::string problems, failure;
  nlohmann::json report;
  int recoveries = 0;

  /// Least distance to the box of boxScenario [m].
  double clearance() const {
    double least = 100.0;
    for (const Vec2& place : places) {
      const double dx = std::max(std::fabs(place.x() - 4.0) - 0.5, 0.0);
      const double dy = std::max(std::fabs(place.y() - 0.3) - 1.0, 0.0);
      least = std::min(least, std::hypot(dx, dy));
    }
    return least;
  }
  double topSpeed() const {
    return speeds.empty() ? 0.0 : *std::max_element(speeds.begin(), speeds.end());
  }
};

app::Verdict prepared(const app::RunSpec& options) {
  const auto settings = app::runSettingsOf(options);
  const app::Bundle bundle = app::readBundle(options, *settings, {});
  app::Verdict verdict = app::check(bundle);
  base::append(verdict.problems, verdict.wrongOptions);
  return verdict;
}

Driven drive(const app::RunSpec& options, double longest) {
  Driven driven;
  app::Verdict verdict = prepared(options);
  driven.problems = problemsText(verdict.problems);
  if (!verdict.world) {
    return driven;
  }
  sim2d::World& world = *verdict.world;
  while (!world.arrivedAt() && world.time() < longest && world.step()) {
    const sim2d::RobotColumns& robots = world.frame().robots;
    driven.places.push_back({robots.x[0], robots.y[0]});
    driven.speeds.push_back(std::hypot(robots.vx[0], robots.vy[0]));
  }
  driven.hasArrived = world.arrivedAt().has_value();
  driven.time = world.time();
  driven.failure = world.failure();
  driven.report = nlohmann::json::parse(world.plannerReports().at(0));
  return driven;
}

Driven driveBox(const std::string& params, const Words& set, double longest = 60.0,
                double heading = 0.0, bool hasBox = true) {
  app::RunSpec options = optionsOf(boxScenario(heading, hasBox), params);
  options.set = set;
  return drive(options, longest);
}

/// By a tree of these nodes, of Main.
Driven driveTree(const std::string& nodes, double heading, double longest, const Words& set = {}) {
  app::RunSpec options = optionsOf(boxScenario(heading), "generic");
  options.nav2Tree = treeFile("nav2_own.xml", nodes);
  options.nav2Distro = "main";
  options.set = set;
  return drive(options, longest);
}

const std::string kPursuit =
    "nav2.FollowPath.plugin=nav2_regulated_pure_pursuit_controller::"
    "RegulatedPurePursuitController";

}  // namespace

void Nav2RunsTest::shippedFiles_inShippedMaps_arrive_data() {
  QTest::addColumn<QString>("params");
  QTest::addColumn<QString>("type");
  QTest::addColumn<QString>("scenario");
  const std::vector<std::pair<const char*, const char*>> robots = {
      {"turtlebot3", "turtlebot3_waffle"},
      {"turtlebot4", "turtlebot4"},
      {"tiago", "tiago"},
      {"nova_carter", "nova_carter"}};
  for (const auto& [params, type] : robots) {
    for (const char* scenario : {"corner_cafe/corner_cafe_agents",
                                 "reactions/reaction_regular_agents", "planners/doorway_agents"}) {
      QTest::newRow((std::string(params) + " " + scenario).c_str()) << params << type << scenario;
    }
  }
}

void Nav2RunsTest::shippedFiles_inShippedMaps_arrive() {
  QFETCH(QString, params);
  QFETCH(QString, type);
  QFETCH(QString, scenario);
  app::RunSpec options =
      optionsOf(SOURCE_DIR "/maps/" + scenario.toStdString() + ".yaml", params.toStdString());
  options.robot = type.toStdString();
  const Driven driven = drive(options, 150.0);
  QVERIFY2(driven.hasArrived,
           (driven.problems + driven.failure + driven.report["counts"].dump()).c_str());
}

void Nav2RunsTest::sameRunTwice_isEqualToTheBit() {
  const Driven first = driveBox("generic", {}), second = driveBox("generic", {});
  QVERIFY2(first.hasArrived, first.problems.c_str());
  QVERIFY(first.places == second.places && first.speeds == second.speeds);
  QCOMPARE(first.report.dump(), second.report.dump());
}

void Nav2RunsTest::twoRobots_withTwoFiles_bothArrive() {
  app::RunSpec options = optionsOf(boxScenario(), "generic");
  options.set = {"robots=[robot1, robot2]", "robot2.planner=nav2", "robot2.type=turtlebot3_waffle",
                 "robot2.nav2_params=" + paramsFile("turtlebot3"),
                 "robot2.nav2_tree=" + kHumbleTree};
  app::Verdict verdict = prepared(options);
  QVERIFY2(verdict.world, problemsText(verdict.problems).c_str());
  sim2d::World& world = *verdict.world;
  while (!world.arrivedAt() && world.time() < 90.0 && world.step()) {
  }
  QVERIFY2(world.arrivedAt(), world.failure().c_str());
  const std::vector<std::string> reports = world.plannerReports();
  QCOMPARE(nlohmann::json::parse(reports[0])["distro"], "jazzy");
  QCOMPARE(nlohmann::json::parse(reports[1])["distro"], "humble");
}

void Nav2RunsTest::ownTree_thatOnlySpins_spins() {
  app::RunSpec options = optionsOf(boxScenario(), "generic");
  options.nav2Tree = treeFile("nav2_spin.xml", "<Spin spin_dist=\"1.57\"/>");
  app::Verdict verdict = prepared(options);
  QVERIFY2(verdict.world, problemsText(verdict.problems).c_str());
  sim2d::World& world = *verdict.world;
  bool isTold = false;
  while (world.time() < 8.0 && world.step()) {
    world.frame().treeChanges.forEach([&](int id, const auto& paths, int node, auto status) {
      isTold = isTold || (id == -1 && paths->at(static_cast<std::size_t>(node)) == "Spin" &&
                          status == base::NodeStatus::Success);
    });
  }
  QVERIFY(isTold);
  QVERIFY(std::fabs(world.frame().robots.heading[0] - 1.57) < 0.15);
  QVERIFY(std::fabs(world.frame().robots.x[0]) < 0.01);
}

void Nav2RunsTest::ownTree_thatFails_isCounted() {
  const Driven given = driveTree("<AlwaysFailure/>", 0.0, 1.0);
  QCOMPARE(given.report["counts"]["tree_failures"], 1);  // it is not begun again
  QCOMPARE(driveTree("<AlwaysSuccess/>", 0.0, 1.0).report["counts"]["tree_failures"], 0);
}

/// Backwards to the box, whose side is 3.5 m off: the look ahead of 2 s ends the one, the other
/// goes on.
void Nav2RunsTest::backUp_withoutCollisionChecks_goesOn() {
  const std::string backUp =
      R"(<BackUp backup_dist="4.0" backup_speed="0.5" time_allowance="20.0")";
  const Driven looks = driveTree(backUp + "/>", base::kPi, 10.0);
  const Driven blind = driveTree(backUp + R"( disable_collision_checks="true"/>)", base::kPi, 10.0);
  QCOMPARE(looks.report["counts"]["tree_failures"], 1);
  QCOMPARE(blind.report["counts"]["tree_failures"], 0);
  QVERIFY2(blind.places.back().x() > looks.places.back().x() + 0.3,
           (base::formatDouble(blind.places.back().x()) + " " +
            base::formatDouble(looks.places.back().x()))
               .c_str());
}

/// The costmap comes back every 4 s: a planner that waits for 1 s has failed by then.
void Nav2RunsTest::plannerAfterAClear_waitsAsLongAsSaid() {
  const std::string tree =
      R"(<SequenceWithMemory><Wait wait_duration="1.0"/>
         <ClearEntireCostmap service_name="global_costmap/clear_entirely_global_costmap"/>
         <ComputePathToPose goal="{goal}" path="{path}"/></SequenceWithMemory>)";
  const auto failures = [&](const std::string& seconds) {
    const Driven driven = driveTree(tree, 0.0, 6.0,
                                    {"nav2.global_costmap.update_frequency=0.25",
                                     "nav2.planner_server.costmap_update_timeout=" + seconds});
    return driven.report["counts"]["plan_failures"].get<int>();
  };
  QCOMPARE(failures("1.0"), 1);
  QCOMPARE(failures("5.0"), 0);
}

void Nav2RunsTest::report_hasKeysDefaultsAndCounts() {
  const Driven driven = driveBox("turtlebot3", {}, 20.0);
  QCOMPARE(driven.report["distro"], "humble");
  QCOMPARE(driven.report["navigation2_commit"], "3c3db59");
  QCOMPARE(driven.report["plugins"]["controller_server.FollowPath"], "dwb_core::DWBLocalPlanner");
  QCOMPARE(driven.report["latency_steps"]["command"], 1.0);
  QCOMPARE(driven.report["treated_as"].size(), std::size_t{1});
  QVERIFY(driven.report["counts"]["replans"] > 10);  // once per second
  QCOMPARE(driven.report["code_defaults"]["controller_server.FollowPath.time_granularity"], "0.5");
  bool isIdle = false;
  for (const auto& key : driven.report["keys"]) {
    isIdle = isIdle || (key["key"] == "local_costmap.robot_base_frame" && key["use"] == "ignored" &&
                        !key["why"].get<std::string>().empty());
  }
  QVERIFY(isIdle);
}

void Nav2RunsTest::effect_inflationRadius_keepsFartherOff() {
  const Words narrow = {"nav2.local_costmap.inflation_layer.inflation_radius=0.4",
                        "nav2.global_costmap.inflation_layer.inflation_radius=0.4"};
  const Words wide = {"nav2.local_costmap.inflation_layer.inflation_radius=1.2",
                      "nav2.global_costmap.inflation_layer.inflation_radius=1.2"};
  const Driven near = driveBox("generic", narrow), far = driveBox("generic", wide);
  QVERIFY2(near.hasArrived && far.hasArrived, (near.problems + far.problems).c_str());
  QVERIFY2(
      far.clearance() > near.clearance() + 0.1,
      (base::formatDouble(near.clearance()) + " " + base::formatDouble(far.clearance())).c_str());
}

void Nav2RunsTest::effect_costScaling_goesNearer() {
  const auto words = [](const char* factor) {
    Words all;
    for (const char* costmap : {"local", "global"}) {
      const std::string layer = std::string("nav2.") + costmap + "_costmap.inflation_layer.";
      all.push_back(layer + "inflation_radius=1.5");
      all.push_back(layer + "cost_scaling_factor=" + factor);
    }
    return all;
  };
  const Driven flat = driveBox("generic", words("1.0")), steep = driveBox("generic", words("20.0"));
  QVERIFY2(flat.hasArrived && steep.hasArrived, (flat.problems + steep.problems).c_str());
  QVERIFY2(
      steep.clearance() < flat.clearance() - 0.1,
      (base::formatDouble(steep.clearance()) + " " + base::formatDouble(flat.clearance())).c_str());
}

void Nav2RunsTest::effect_lookahead_cutsCorners() {
  const auto words = [](const char* distance) {
    return Words{kPursuit, std::string("nav2.FollowPath.lookahead_dist=") + distance,
                 "nav2.FollowPath.use_cost_regulated_linear_velocity_scaling=false",
                 "nav2.FollowPath.use_collision_detection=false"};
  };
  const Driven shortOne = driveBox("generic", words("0.3"));
  const Driven longOne = driveBox("generic", words("1.5"));
  QVERIFY2(shortOne.hasArrived && longOne.hasArrived,
           (shortOne.problems + longOne.problems).c_str());
  QVERIFY2(
      longOne.clearance() < shortOne.clearance(),
      (base::formatDouble(longOne.clearance()) + " " + base::formatDouble(shortOne.clearance()))
          .c_str());
}

void Nav2RunsTest::effect_pathAlignWeight_keepsToThePath() {
  const auto deviation = [](const char* weight) {
    const Driven driven =
        driveBox("generic", {std::string("nav2.FollowPath.PathAlignCritic.cost_weight=") + weight},
                 60.0, 0.9, false);
    double sum = 0.0;
    for (const Vec2& place : driven.places) {
      sum += std::fabs(place.y());  // the path is the x axis, or leads back to it
    }
    return sum / static_cast<double>(driven.places.size());
  };
  const double loose = deviation("0.0"), tight = deviation("60.0");
  QVERIFY2(tight < loose, (base::formatDouble(tight) + " " + base::formatDouble(loose)).c_str());
}

void Nav2RunsTest::effect_temperature_isBolderWhenLow() {
  const auto reached = [](const char* temperature) {
    const Driven driven = driveBox(
        "generic", {std::string("nav2.FollowPath.temperature=") + temperature}, 6.0, 0.0, false);
    return driven.places.empty() ? -1.0 : driven.places.back().x();
  };
  const double bold = reached("0.1"), shy = reached("30.0");  // [m] after 6 s
  QVERIFY2(bold > shy + 0.2, (base::formatDouble(bold) + " " + base::formatDouble(shy)).c_str());
}

/// Of main, which limits after it has smoothed; Humble and Jazzy may go a little above.
void Nav2RunsTest::effect_topSpeed_isKept() {
  const Driven slow = driveBox("generic", {"robot1.nav2_distro=main", "nav2.FollowPath.vx_max=0.3"},
                               12.0, 0.0, false);
  const Driven fast = driveBox("generic", {"robot1.nav2_distro=main", "nav2.FollowPath.vx_max=0.6"},
                               12.0, 0.0, false);
  QVERIFY2(slow.topSpeed() <= 0.3 + 1e-6 && slow.topSpeed() > 0.2,
           base::formatDouble(slow.topSpeed()).c_str());
  QVERIFY2(fast.topSpeed() > 0.45 && fast.topSpeed() <= 0.6 + 1e-6,
           base::formatDouble(fast.topSpeed()).c_str());
}

void Nav2RunsTest::effect_goalTolerance_stopsEarlier() {
  const auto rest = [](const char* tolerance) {
    const std::string key = "nav2.general_goal_checker.xy_goal_tolerance=";
    const Driven driven = driveBox("generic", {key + tolerance}, 60.0, 0.0, false);
    return driven.hasArrived ? 8.0 - driven.places.back().x() : -1.0;
  };
  const double small = rest("0.15"), large = rest("0.8");
  QVERIFY2(small > 0.0 && small <= 0.15, base::formatDouble(small).c_str());
  QVERIFY2(large > 0.6 && large <= 0.8, base::formatDouble(large).c_str());
}

void Nav2RunsTest::effect_smootherAcceleration_isKept() {
  const Driven soft =
      driveBox("generic", {"nav2.velocity_smoother.max_accel=[0.2, 0.0, 3.0]"}, 4.0, 0.0, false);
  double fastest = 0.0;  // gain of speed in a second [m/s]
  for (std::size_t i = 20; i < soft.speeds.size(); ++i) {
    fastest = std::max(fastest, soft.speeds[i] - soft.speeds[i - 20]);
  }
  QVERIFY2(fastest > 0.1 && fastest <= 0.2 + 0.011, base::formatDouble(fastest).c_str());
}

void Nav2RunsTest::badInput_isToldNotRun_data() {
  QTest::addColumn<QString>("set");
  QTest::addColumn<QString>("part");
  QTest::newRow("unknown") << "nav2.FollowPath.temperatur=0.2"
                           << "FollowPath.temperature";
  QTest::newRow("type") << "nav2.FollowPath.temperature=warm"
                        << "double";
  QTest::newRow("file") << "robot1.nav2_params=nowhere.yaml"
                        << "nowhere.yaml";
  QTest::newRow("tree") << "robot1.nav2_tree=nowhere.xml"
                        << "nowhere.xml";
}

void Nav2RunsTest::badInput_isToldNotRun() {
  QFETCH(QString, set);
  QFETCH(QString, part);
  app::RunSpec options = optionsOf(boxScenario(), "generic");
  options.nav2Params.clear();
  options.nav2Tree.reset();
  options.set = {"robot1.nav2_params=" + paramsFile("generic"), "robot1.nav2_tree=" + kTree,
                 "robot1.planner=nav2", set.toStdString()};
  const app::Verdict verdict = prepared(options);
  QVERIFY(!verdict.world);
  const std::string text = problemsText(verdict.problems);
  QVERIFY2(text.find(part.toStdString()) != std::string::npos, text.c_str());
}

/// Its polygon holds the whole room; an enabled node would stop the robot immediately.
void Nav2RunsTest::monitor_thatIsDisabled_changesNothing() {
  app::RunSpec options = optionsOf(boxScenario(0.0, false), "generic");
  options.nav2Params = {SOURCE_DIR "/tests/data/nav2/nav2_monitor_disabled.yaml"};
  const Driven driven = drive(options, 12.0);
  QVERIFY2(!driven.places.empty() && driven.places.back().x() > 2.0,
           (driven.problems + driven.failure).c_str());
}

void Nav2RunsTest::bodyOfTheFile_otherThanTheRobots_isReported_data() {
  QTest::addColumn<QString>("shape");
  QTest::addColumn<QString>("told");  // after the path; empty: nothing
  QTest::newRow("radius") << "robot_radius: 0.175"
                          << ":8:21: warning: local_costmap.robot_radius reaches 0.175 m from the "
                             "centre, the body of robot 'robot1' 0.35 m";
  // hypot(0.3, 0.4) = 0.5
  QTest::newRow("corners") << "footprint: \"[[0.3, 0.4], [-0.3, 0.4], [-0.3, -0.4], [0.3, -0.4]]\""
                           << ":8:18: warning: local_costmap.footprint reaches 0.5 m from the "
                              "centre, the body of robot 'robot1' 0.35 m";
  QTest::newRow("the same") << "robot_radius: 0.35"
                            << "";
  QTest::newRow("not given") << "robot_base_frame: base_link"
                             << "";
}

/// The robot of the scenario is a disc of 0.35 m.
void Nav2RunsTest::bodyOfTheFile_otherThanTheRobots_isReported() {
  QFETCH(QString, shape);
  QFETCH(QString, told);
  const std::string path = std::string(TEST_OUTPUT_DIR) + "/tmp/nav2_body.yaml";
  base::writeFileAtomically(
      path,
      "controller_server:\n  ros__parameters:\n    FollowPath:\n      plugin: "
      "\"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\"\n"
      "local_costmap:\n  local_costmap:\n    ros__parameters:\n      " +
          shape.toStdString() + "\n");
  app::RunSpec options = optionsOf(boxScenario(), "generic");
  options.nav2Params = {path};
  const app::Verdict verdict = prepared(options);
  const std::string text = problemsText(verdict.problems) + problemsText(verdict.worldRemarks);
  const bool isReported = text.find(" reaches ") != std::string::npos;
  QVERIFY2(isReported != told.isEmpty(), text.c_str());
  QVERIFY2(told.isEmpty() || text.find(path + told.toStdString()) != std::string::npos,
           text.c_str());
}

void Nav2RunsTest::errorOfTheFile_isAtItsLine_data() {
  QTest::addColumn<QString>("yaml");
  QTest::addColumn<QString>("told");  // after the path
  const QString controller = QStringLiteral(
      "controller_server:\n  ros__parameters:\n    FollowPath:\n      plugin: "
      "\"nav2_regulated_pure_pursuit_controller::RegulatedPurePursuitController\"\n");
  const QString costmap =
      QStringLiteral("local_costmap:\n  local_costmap:\n    ros__parameters:\n");
  QTest::newRow("size") << controller + costmap + QStringLiteral("      width: 30000\n")
                        << ":8:14: error: ";
  QTest::newRow("type and size") << controller + QStringLiteral("      lookahead_dist: true\n") +
                                        costmap + QStringLiteral("      width: 30000\n")
                                 << ":9:14: error: ";
  QTest::newRow("nodes without a controller")
      << QStringLiteral("amcl:\n  ros__parameters: {alpha1: 0.2}\n") << ":1: error: ";
}

/// Not at the robot's line of the scenario.
void Nav2RunsTest::errorOfTheFile_isAtItsLine() {
  QFETCH(QString, yaml);
  QFETCH(QString, told);
  const std::string path = std::string(TEST_OUTPUT_DIR) + "/tmp/nav2_wrong.yaml";
  base::writeFileAtomically(path, yaml.toStdString());
  app::RunSpec options = optionsOf(boxScenario(), "generic");
  options.nav2Params = {path};
  const app::Verdict verdict = prepared(options);
  QVERIFY(!verdict.world);
  const std::string text = problemsText(verdict.problems);
  QVERIFY2(text.find(path + told.toStdString()) != std::string::npos, text.c_str());
}

QTEST_GUILESS_MAIN(Nav2RunsTest)
#include "tst_Nav2Runs.moc"
