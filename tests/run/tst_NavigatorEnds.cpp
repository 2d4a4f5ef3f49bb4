#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/ResultRow.h"
#include "sim2d/base/Text.h"
#include "sim2d/trace/Recording.h"
#include "sim2d/world/Runner.h"
#include "tests/run/Nav2Scene.h"

/// Runs that end when Nav2's navigator does, with success or failure.
class NavigatorEndsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void success_outsideTheGoalRadius_isTheArrival();
  void success_besideAnOccupiedGoal_tellsWhatIsLeft();
  void finalTurn_isSeen();
  void unreachable_endsWithTheReason_data();
  void unreachable_endsWithTheReason();
  void failureOfNoAction_namesTheNode();
  void severalGoals_oneUnreachable_goesOn();
  void repeatedGoal_isNavigatedToAgain();
  void route_withAnUnreachableGoal_fails();
  void sameRunTwice_hasTheSameEvents();
  void columns_ofTheResults_areOneOfThem();
};

namespace {

using namespace nav2scene;
using base::Vec2;
using Words = std::vector<std::string>;

const std::string kTrees = SOURCE_DIR "/resources/nav2_trees/";
const std::string kToPose = kTrees + "jazzy/navigate_to_pose_w_replanning_and_recovery.xml";

/// A file of maps/planners with Smac 2D, and the trees by their paths.
std::string paramsFile(const std::string& controller, const std::string& tolerance) {
  std::string text = textOf(SOURCE_DIR "/maps/planners/nav2_" + controller + ".yaml");
  const auto replace = [&text](const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    QVERIFY2(at != std::string::npos, from.c_str());
    text.replace(at, from.size(), to);
  };
  replace("\"nav2_navfn_planner::NavfnPlanner\"\n      tolerance: 0.5",
          "\"nav2_smac_planner::SmacPlanner2D\"\n      tolerance: " + tolerance);
  replace("      use_astar: false\n", "");
  const std::string node = "bt_navigator:\n  ros__parameters:\n";
  replace(node, node + "    default_nav_to_pose_bt_xml: \"" + kToPose +
                    "\"\n    default_nav_through_poses_bt_xml: \"" + kTrees +
                    "jazzy/navigate_through_poses_w_replanning_and_recovery.xml\"\n");
  return written("ends_" + controller + tolerance + ".yaml", text);
}

/// Plans once and follows.
std::string plainTree() {
  return treeFile("ends_plain.xml", R"(<Sequence><ComputePathToPose goal="{goal}" path="{path}"/>
      <FollowPath path="{path}"/></Sequence>)");
}

/// Round (4, 0), with a gap of 1 m: wide enough for the body, too narrow for `kWide`.
constexpr const char* kNarrow = R"(    obstacles: [north, south, east, west1, west2]
    north: {kind: box, x: 4.0, y: 1.0, h: 0.0, length: 2.2, width: 0.2}
    south: {kind: box, x: 4.0, y: -1.0, h: 0.0, length: 2.2, width: 0.2}
    east: {kind: box, x: 5.0, y: 0.0, h: 0.0, length: 0.2, width: 2.0}
    west1: {kind: box, x: 3.0, y: 0.75, h: 0.0, length: 0.2, width: 0.5}
    west2: {kind: box, x: 3.0, y: -0.75, h: 0.0, length: 0.2, width: 0.5}
)";
const std::string kWide = "nav2.global_costmap.robot_radius=0.65";
constexpr const char* kPillar = R"(    obstacles: [pillar]
    pillar: {kind: box, x: 4.0, y: 0.0, h: 0.0, length: 0.2, width: 0.2}
)";

/// An open plane. The robot looks along +x; goals 1, 2, 3 at (2, 2), (4, 0), (2, -2).
std::string scene(const std::string& name, const std::string& robot, const std::string& rest = {}) {
  return written("ends_" + name + ".yaml",
                 planeText(kAtOrigin + robot + rest, {"0.5", "x: 1.0, y: 4.0", "4"},
                           R"(      1: {x: 2.0, y: 2.0}
      2: {x: 4.0, y: 0.0}
      3: {x: 2.0, y: -2.0}
      4: {x: 1.0, y: 4.0}
)"));
}

struct Ended {
  sim2d::RunResult result;
  sim2d::Trace trace;
  nlohmann::json report;
  std::string problems;

  const sim2d::RobotResult& robot() const { return result.robots.at(0); }
  const sim2d::GoalResult& last() const { return robot().goalResults.back(); }
  std::string events() const {
    std::string text;
    for (const auto& [step, event] : trace.events) {
      if (event.hasId && event.id == -1 && event.kind != sim2d::EventKind::Replan) {
        text += std::string(sim2d::eventKindName(event.kind)) + " " + event.text + "\n";
      }
    }
    return text;
  }
  Vec2 place() const {
    const sim2d::RobotColumns& robots = trace.frames.back().robots;
    return {robots.x[0], robots.y[0]};
  }
};

Ended ended(const std::string& scenario, const std::string& params, const std::string& tree = {},
            const Words& set = {}) {
  app::RunSpec options;
  options.scenario = scenario;
  options.nav2Params = {params};
  options.nav2Tree = tree.empty() ? std::nullopt : std::optional(tree);
  options.set = set;
  const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
  app::Verdict verdict = app::check(bundle);
  Ended run;
  for (const base::Diagnostic& problem : verdict.problems) {
    run.problems += problem.severity == base::Severity::Info ? "" : problem.text() + "\n";
  }
  if (!verdict.world) {
    return run;
  }
  sim2d::Recording recording;
  run.result = sim2d::run(*verdict.world, sim2d::stopRuleOf(*bundle.scenario), recording);
  run.trace = recording.trace(verdict.world->header());
  run.report = nlohmann::json::parse(verdict.world->plannerReports().at(0));
  return run;
}

/// Of the robot's last state.
double distanceTo(const Ended& run, const Vec2& goal) {
  return (run.place() - goal).norm();
}

}  // namespace

/// DWB stops where its goal checker lets it, 0.25 m off; the scenario wants 0.05 m.
void NavigatorEndsTest::success_outsideTheGoalRadius_isTheArrival() {
  const Ended run = ended(scene("dwb", "      goal: {x: 3.0, y: 0.0}\n      goal_radius: 0.05\n"),
                          paramsFile("dwb", "0.25"));
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(QString::fromStdString(run.result.reason), QStringLiteral("arrived"));
  QVERIFY(run.robot().result == sim2d::NavigationOutcome::Arrived);
  QVERIFY2(run.last().distance > 0.05 && run.last().distance < 0.3,
           base::formatDouble(run.last().distance).c_str());
  QVERIFY(run.events().find("navigation_succeeded 0.") != std::string::npos);
  QVERIFY(std::fabs(run.last().distance - distanceTo(run, {3.0, 0.0})) < 0.1);  // it brakes on
}

/// The body fits at the goal, Nav2's wider one does not: Smac 2D takes the nearest cell that is
/// free.
void NavigatorEndsTest::success_besideAnOccupiedGoal_tellsWhatIsLeft() {
  const Ended run = ended(scene("pillar", "      goal: {x: 4.0, y: 0.5}\n", kPillar),
                          paramsFile("rpp", "0.6"), {}, {"nav2.global_costmap.robot_radius=0.8"});
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QVERIFY2(run.robot().result == sim2d::NavigationOutcome::Arrived, run.events().c_str());
  QVERIFY(run.last().result.hasSucceeded);
  // Farther than its checker allows, and within the limit: 0.25 + 0.5 m.
  QVERIFY2(run.last().distance > 0.25 && run.last().distance < 0.75,
           base::formatDouble(run.last().distance).c_str());
}

/// The path comes in along +x; the way to the goal, and with it its heading, is that of the
/// straight line. Within its radius the robot goes on turning until the checker is content.
void NavigatorEndsTest::finalTurn_isSeen() {
  const std::string turn =
      treeFile("ends_turn.xml", R"(<Sequence><ComputePathToPose goal="{goal}" path="{path}"/>
      <FollowPath path="{path}"/><Spin spin_dist="1.57"/></Sequence>)");
  const Ended run =
      ended(scene("turn", "      goal: {x: 2.0, y: 0.0}\n"), paramsFile("rpp", "0.25"), turn);
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(QString::fromStdString(run.result.reason), QStringLiteral("arrived"));
  QVERIFY(std::fabs(run.trace.frames.back().robots.heading[0] - 1.57) < 0.15);
}

void NavigatorEndsTest::unreachable_endsWithTheReason_data() {
  QTest::addColumn<QString>("distro");
  QTest::addColumn<QString>("tree");
  QTest::addColumn<QString>("reason");
  QTest::newRow("stock tree") << "jazzy" << QString::fromStdString(kToPose)
                              << "planner NO_VALID_PATH (208)";
  QTest::newRow("plain tree") << "main" << QString::fromStdString(plainTree())
                              << "planner NO_VALID_PATH (208)";
  QTest::newRow("humble") << "humble"
                          << QString::fromStdString(
                                 kTrees + "humble/navigate_to_pose_w_replanning_and_recovery.xml")
                          << "planner NO_VALID_PATH";
}

void NavigatorEndsTest::unreachable_endsWithTheReason() {
  QFETCH(QString, distro);
  QFETCH(QString, tree);
  QFETCH(QString, reason);
  const Ended run =
      ended(scene("walled", "      goal: {x: 4.0, y: 0.0}\n", kNarrow), paramsFile("rpp", "0.1"),
            tree.toStdString(), {kWide, "robot1.nav2_distro=" + distro.toStdString()});
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(QString::fromStdString(run.result.reason),
           QStringLiteral("navigation_failed: robot1, ") + reason);
  QVERIFY(run.robot().result == sim2d::NavigationOutcome::NavigationFailed);
  QCOMPARE(run.last().result.reason, reason.toStdString());
  QCOMPARE(run.last().result.errorCode, distro == QLatin1String("humble") ? 0 : 208);
  QCOMPARE(run.last().result.message, std::string("there is no path to the goal"));
  const int failures = run.report["counts"]["plan_failures"].get<int>();
  QVERIFY(failures > 0);
  QCOMPARE(run.report["plan_failure_reasons"].size(), std::size_t{1});
  QCOMPARE(run.report["plan_failure_reasons"][reason.toStdString()].get<int>(), failures);
  QCOMPARE(run.report["counts"]["tree_failures"].get<int>(), 1);
  QVERIFY(run.events().find("navigation_failed " + reason.toStdString()) != std::string::npos);
}

void NavigatorEndsTest::failureOfNoAction_namesTheNode() {
  const Ended run =
      ended(scene("node", "      goal: {x: 4.0, y: 0.0}\n"), paramsFile("rpp", "0.25"),
            treeFile("ends_node.xml",
                     R"(<Sequence><AlwaysSuccess/><GoalReached goal="{goal}"/></Sequence>)"));
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(QString::fromStdString(run.result.reason),
           QStringLiteral("navigation_failed: robot1, node GoalReached"));
  QCOMPARE(run.last().result.errorCode, 0);
}

/// One by one: Nav2 finds no way to the second.
void NavigatorEndsTest::severalGoals_oneUnreachable_goesOn() {
  const Ended run = ended(scene("three", "      goals: [1, 2, 3]\n", kNarrow),
                          paramsFile("rpp", "0.1"), plainTree(), {kWide});
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(run.robot().goalResults.size(), std::size_t{3});
  const auto& ends = run.robot().goalResults;
  QVERIFY(ends[0].isReached && !ends[1].result.hasSucceeded && ends[2].isReached);
  QVERIFY(ends[0].goal == 1 && ends[1].goal == 2 && ends[2].goal == 3);
  QCOMPARE(QString::fromStdString(run.result.reason),
           QStringLiteral("navigation_failed: robot1, goal 2: planner NO_VALID_PATH (208)"));
  const std::string events = run.events();
  QVERIFY2(events.find("goal 1\nnavigation_succeeded goal 1: ") != std::string::npos,
           events.c_str());
  QVERIFY(events.find("goal 3\nnavigation_succeeded goal 3: ") != std::string::npos);
  QVERIFY(events.find("arrived") == std::string::npos);
  QVERIFY(distanceTo(run, {2.0, -2.0}) < 0.5);
}

/// The same place twice in the list is two navigations.
void NavigatorEndsTest::repeatedGoal_isNavigatedToAgain() {
  const Ended run =
      ended(scene("twice", "      goals: [1, 1]\n"), paramsFile("rpp", "0.25"), plainTree());
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(run.robot().goalResults.size(), std::size_t{2});
  QVERIFY(run.robot().result == sim2d::NavigationOutcome::Arrived);
  QVERIFY(run.robot().goalResults[1].time > run.robot().goalResults[0].time);
}

/// NavigateThroughPoses is given up as a whole, with the codes of its own action.
void NavigatorEndsTest::route_withAnUnreachableGoal_fails() {
  const Ended run = ended(scene("route", "      goals: [1, 2, 3]\n", kNarrow),
                          paramsFile("rpp", "0.1"), {}, {kWide});
  QVERIFY2(!run.result.robots.empty(), run.problems.c_str());
  QCOMPARE(run.robot().goalResults.size(), std::size_t{1});
  QCOMPARE(run.last().result.errorCode, 308);
  QCOMPARE(run.last().result.goals, std::size_t{3});
  QCOMPARE(QString::fromStdString(run.result.reason),
           QStringLiteral("navigation_failed: robot1, goal 3: planner NO_VALID_PATH (308)"));
}

void NavigatorEndsTest::sameRunTwice_hasTheSameEvents() {
  const std::string scenario = scene("three", "      goals: [1, 2, 3]\n", kNarrow);
  const Ended first = ended(scenario, paramsFile("rpp", "0.1"), plainTree(), {kWide});
  const Ended second = ended(scenario, paramsFile("rpp", "0.1"), plainTree(), {kWide});
  QVERIFY2(first.result.steps > 0, first.problems.c_str());
  QCOMPARE(sim2d::eventsCsv(first.trace), sim2d::eventsCsv(second.trace));
  QCOMPARE(sim2d::trajectoryCsv(first.trace), sim2d::trajectoryCsv(second.trace));
}

void NavigatorEndsTest::columns_ofTheResults_areOneOfThem() {
  using sim2d::NavigationOutcome;
  const std::pair<NavigationOutcome, const char*> ends[] = {
      {NavigationOutcome::Arrived, "ended_by_success"},
      {NavigationOutcome::GoalMissed, "ended_by_success"},
      {NavigationOutcome::NavigationFailed, "ended_by_failure"},
      {NavigationOutcome::Collision, "ended_by_contact"},
      {NavigationOutcome::Stuck, "ended_by_standstill"},
      {NavigationOutcome::Timeout, "ended_by_time"}};
  for (const auto& [end, key] : ends) {
    app::FinishedRun run{{}, {}, {}, base::error("metrics.no-samples"), {}, false, {}, {}};
    run.header.robots.emplace_back().name = "robot1";
    sim2d::RobotResult robot{-1, "robot1", end, 2.0, true, {}};
    robot.goalResults.emplace_back().distance = 0.25;
    run.result.robots = {robot};
    const app::ResultRow row = app::rowOf(run);
    QCOMPARE(row.fields.size(), std::size_t{6});
    for (const auto& [column, field] : row.fields) {
      const std::string wanted = column == "distance_left" ? "0.25"
                                 : column == key           ? "True"
                                                           : "False";
      QCOMPARE(column + " " + field, column + " " + wanted);
    }
    run.result.robots[0].decidesGoalEnd = false;  // of other planners nothing
    QVERIFY(app::rowOf(run).fields.empty());
  }
}

QTEST_GUILESS_MAIN(NavigatorEndsTest)
#include "tst_NavigatorEnds.moc"
