#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/Nav2Robots.h"
#include "bt/robot/Nav2Goals.h"
#include "sim2d/base/Text.h"
#include "tests/run/Nav2Scene.h"

/// Robots with Nav2 that have several goals, and masks that keep them out or slow them down.
class Nav2RoutesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void route_tellsPassedFromReached();
  void severalGoals_areOneRoute();
  void severalGoals_withATreeToAPose_areDrivenOneByOne();
  void keepout_isNotEntered();
  void speedMask_limitsTheSpeedWhereItLies();
  void mask_thatIsNotThere_isAnError();
  void keepout_byTopics_isNotEntered();
  void speedMask_byTopics_countsAsTheServerSays();
  void mask_ofAServerThatIsNotThere_isAWarning();
};

namespace {

using namespace nav2scene;
using base::Vec2;

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  QVERIFY2(at != std::string::npos, from.c_str());
  text.replace(at, from.size(), to);
}

/// A plane and one robot from the origin, with these keys.
std::string planeWith(const std::string& name, const std::string& robot,
                      const std::string& goals = "      1: {x: 30.0, y: 30.0}\n") {
  return written(name + ".yaml", planeText(kAtOrigin + robot, {"0.5", "x: 30.0, y: 30.0"}, goals));
}

struct RouteDriven {
  std::vector<Vec2> places;
  std::vector<double> speeds;
  std::vector<std::string> goals;  // texts of its events `goal`, in order
  bool hasArrived = false;
  std::string problems;
};

RouteDriven driveRoute(const std::string& scenario, const std::string& params,
                       const std::string& tree = {}) {
  app::RunSpec options;
  options.scenario = scenario;
  options.nav2Params = {params};
  options.nav2Tree = tree.empty() ? std::nullopt : std::optional(tree);
  const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
  app::Verdict verdict = app::check(bundle);
  RouteDriven driven;
  driven.problems = problemsText(verdict.problems);
  if (!verdict.world) {
    return driven;
  }
  sim2d::World& world = *verdict.world;
  while (!world.arrivedAt() && world.time() < 90.0 && world.step()) {
    const sim2d::RobotColumns& robots = world.frame().robots;
    driven.places.emplace_back(robots.x[0], robots.y[0]);
    driven.speeds.push_back(std::hypot(robots.vx[0], robots.vy[0]));
    for (const sim2d::Event& event : world.frame().events) {
      if (event.kind == sim2d::EventKind::Goal && event.id == -1) {
        driven.goals.push_back(event.text);
      }
    }
  }
  driven.hasArrived = world.arrivedAt().has_value();
  return driven;
}

const std::string kGoals =
    "      1: {x: 4.0, y: 0.0}\n      2: {x: 8.0, y: 0.5}\n      3: {x: 12.0, y: 0.0}\n";

/// Least speed within half a metre of a place [m/s].
double slowestNear(const RouteDriven& driven, const Vec2& place) {
  double least = 10.0;
  for (std::size_t k = 0; k < driven.places.size(); ++k) {
    least = (driven.places[k] - place).norm() < 0.5 ? std::min(least, driven.speeds[k]) : least;
  }
  return least;
}
/// Speed nearest to a place [m/s].
double speedAt(const RouteDriven& driven, const Vec2& place) {
  std::size_t nearest = 0;
  for (std::size_t k = 0; k < driven.places.size(); ++k) {
    if ((driven.places[k] - place).norm() < (driven.places[nearest] - place).norm()) {
      nearest = k;
    }
  }
  return driven.speeds.at(nearest);
}
double distanceTo(const RouteDriven& driven, const Vec2& place) {
  double least = 100.0;
  for (const Vec2& each : driven.places) {
    least = std::min(least, (each - place).norm());
  }
  return least;
}

/// A mask of 10 cm cells over x -2 … 12, y -6 … 6 m with one value within a box, 0 elsewhere.
std::string maskFile(const std::string& name, const std::string& mode, int inside, int outside,
                     const Vec2& low, const Vec2& high) {
  constexpr int kColumns = 140, kRows = 120;
  std::string pixels = "P5\n140 120\n255\n";
  for (int line = 0; line < kRows; ++line) {
    for (int column = 0; column < kColumns; ++column) {
      const Vec2 place(-2.0 + 0.1 * (column + 0.5), 6.0 - 0.1 * (line + 0.5));
      const bool isInside =
          (place.array() > low.array()).all() && (place.array() < high.array()).all();
      pixels.push_back(static_cast<char>(isInside ? inside : outside));
    }
  }
  base::writeFileAtomically(inTmp(name + ".pgm"), pixels);
  base::writeFileAtomically(inTmp(name + ".yaml"),
                            "image: " + name + ".pgm\nmode: " + mode +
                                "\nresolution: 0.1\norigin: [-2.0, -6.0, 0.0]\nnegate: 0\n"
                                "occupied_thresh: 0.65\nfree_thresh: 0.196\n");
  return name + ".yaml";
}

/// Nav2's file with a filter in the global costmap. Both trees by their paths: tests do not know
/// where the shipped ones lie.
std::string withFilter(const std::string& name, const std::string& filter,
                       const std::string& topSpeed = "1.0") {
  const std::string trees = SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_";
  const std::string end = "_w_replanning_and_recovery.xml\"\n";
  std::string text = textOf(SOURCE_DIR "/maps/planners/nav2_rpp.yaml");
  const std::string plugins =
      "      plugins: [\"static_layer\", \"obstacle_layer\", \"inflation_layer\"]\n";
  replace(text, plugins, plugins + filter);
  replace(text, "desired_linear_vel: 1.0", "desired_linear_vel: " + topSpeed);
  const std::string node = "bt_navigator:\n  ros__parameters:\n";
  replace(text, node,
          node + "    default_nav_to_pose_bt_xml: \"" + trees + "to_pose" + end +
              "    default_nav_through_poses_bt_xml: \"" + trees + "through_poses" + end);
  return written(name + ".yaml", text);
}
std::string pursuitFile() {
  return withFilter("nav2_pursuit_params", {});
}
/// So slow that RemovePassedGoals, which looks every 3 s round 0.7 m, meets every goal; a faster
/// robot turns back to those that it missed.
std::string slowFile() {
  return withFilter("nav2_slow_params", {}, "0.4");
}

}  // namespace

void Nav2RoutesTest::route_tellsPassedFromReached() {
  const std::vector<Vec2> after = {{2.0, 0.0}, {2.0, 3.0}};
  bt::Nav2GoalTracker route;
  QVERIFY(!route.continuesTo({1.0, 0.0}, after));
  route.begin({{0.0, 0.0}, 1.0}, {1.0, 0.0}, after, true);
  QCOMPARE(route.poses().size(), std::size_t{3});
  QCOMPARE(route.poses()[0].heading, 0.0);
  QVERIFY(std::abs(route.poses()[2].heading - 0.5 * base::kPi) < 1e-12);
  QVERIFY(route.continuesTo({1.0, 0.0}, after));
  route.setGoalsLeftInTree(2);
  QCOMPARE(route.takePassed(), std::size_t{1});  // the world hears of it once
  QCOMPARE(route.takePassed(), std::size_t{0});
  QVERIFY(route.continuesTo({2.0, 0.0}, {{2.0, 3.0}}));
  QVERIFY(route.continuesTo({2.0, 3.0}, {}));  // the world was first
  route.setGoalsLeftInTree(1);
  QCOMPARE(route.takePassed(), std::size_t{0});
  QVERIFY(!route.continuesTo({5.0, 0.0}, {}));
}

void Nav2RoutesTest::severalGoals_areOneRoute() {
  const RouteDriven driven =
      driveRoute(planeWith("nav2_route", "      goals: [1, 2, 3]\n", kGoals), slowFile());
  QVERIFY2(driven.hasArrived, driven.problems.c_str());
  QCOMPARE(driven.goals, (std::vector<std::string>{"1", "2", "3"}));
  for (const Vec2& goal : {Vec2(4.0, 0.0), Vec2(8.0, 0.5)}) {
    QVERIFY(distanceTo(driven, goal) < 0.7);   // the radius of RemovePassedGoals
    QVERIFY(slowestNear(driven, goal) > 0.3);  // it drives through
  }
}

void Nav2RoutesTest::severalGoals_withATreeToAPose_areDrivenOneByOne() {
  const std::string scenario = planeWith("nav2_one_by_one", "      goals: [1, 2, 3]\n", kGoals);
  const std::string tree =
      SOURCE_DIR "/resources/nav2_trees/jazzy/navigate_to_pose_w_replanning_and_recovery.xml";
  const RouteDriven one = driveRoute(scenario, slowFile(), tree);
  QVERIFY2(one.hasArrived, one.problems.c_str());
  QCOMPARE(one.goals, (std::vector<std::string>{"1", "2", "3"}));
  const RouteDriven route = driveRoute(scenario, slowFile());
  QVERIFY(distanceTo(one, {4.0, 0.0}) < 0.26);  // its goal radius
  const double slow = slowestNear(one, {4.0, 0.0}), fast = slowestNear(route, {4.0, 0.0});
  QVERIFY2(slow < 0.7 * fast, qPrintable(QStringLiteral("%1 %2").arg(slow).arg(fast)));
}

void Nav2RoutesTest::keepout_isNotEntered() {
  const std::string scenario = planeWith("nav2_keepout", "      goal: {x: 8.0, y: 0.0}\n");
  const RouteDriven straight = driveRoute(scenario, pursuitFile());
  QVERIFY2(straight.hasArrived, straight.problems.c_str());
  const auto highest = [](const RouteDriven& driven) {
    double most = -100.0;
    for (const Vec2& place : driven.places) {
      most = std::abs(place.x() - 4.0) < 0.9 ? std::max(most, std::abs(place.y())) : most;
    }
    return most;
  };
  QVERIFY(highest(straight) < 0.1);
  maskFile("keepout_mask", "trinary", 0, 254, {3.0, -3.0}, {5.0, 1.0});
  const RouteDriven round = driveRoute(
      scenario, withFilter("nav2_keepout_params",
                           "      filters: [\"keepout_filter\"]\n      keepout_filter:\n"
                           "        plugin: \"nav2_costmap_2d::KeepoutFilter\"\n"
                           "        enabled: true\n        mask_file: \"keepout_mask.yaml\"\n"));
  QVERIFY2(round.hasArrived, round.problems.c_str());
  double deepest = -10.0;  // in the zone [m]; pursuit cuts corners of the path
  for (const Vec2& place : round.places) {
    deepest = std::max(deepest, std::min({place.x() - 3.0, 5.0 - place.x(), 1.0 - place.y()}));
  }
  QVERIFY2(deepest < 0.15, qPrintable(QString::number(deepest)));
  QVERIFY(highest(round) > 0.99);
}

void Nav2RoutesTest::speedMask_limitsTheSpeedWhereItLies() {
  const std::string scenario = planeWith("nav2_speed", "      goal: {x: 8.0, y: 0.0}\n");
  maskFile("speed_mask", "raw", 30, 0, {3.0, -3.0}, {5.0, 3.0});  // 30 % of 1 m/s
  const RouteDriven driven = driveRoute(
      scenario, withFilter("nav2_speed_params",
                           "      filters: [\"speed_filter\"]\n      speed_filter:\n"
                           "        plugin: \"nav2_costmap_2d::SpeedFilter\"\n"
                           "        enabled: true\n        mask_file: \"speed_mask.yaml\"\n"));
  QVERIFY2(driven.hasArrived, driven.problems.c_str());
  // The global costmap is updated once a second: the limit comes up to 1 m late, and the robot
  // brakes with 1 m/s².
  QVERIFY(speedAt(driven, {2.8, 0.0}) > 0.9);
  for (const double x : {4.4, 4.7, 4.9}) {
    QVERIFY2(std::abs(speedAt(driven, {x, 0.0}) - 0.3) < 0.03,
             qPrintable(QString::number(speedAt(driven, {x, 0.0}))));
  }
  QVERIFY(speedAt(driven, {6.8, 0.0}) > 0.8);
}

void Nav2RoutesTest::mask_thatIsNotThere_isAnError() {
  const std::string params =
      withFilter("nav2_no_mask",
                 "      filters: [\"keepout_filter\"]\n      keepout_filter:\n"
                 "        plugin: \"nav2_costmap_2d::KeepoutFilter\"\n"
                 "        mask_file: \"nowhere.yaml\"\n");
  const base::Diagnostics found = app::checkNav2Files({params});
  QVERIFY(base::hasErrors(found));
  QVERIFY(std::any_of(found.begin(), found.end(), [](const base::Diagnostic& problem) {
    return problem.file.find("nowhere.yaml") != std::string::npos;
  }));
}

namespace {

/// The nodes of nav2_map_server that publish a mask, as nav2_bringup's files have them.
std::string maskServers(const std::string& kind, int type, const std::string& yaml,
                        const std::string& values = {}) {
  return kind + "_filter_mask_server:\n  ros__parameters:\n    topic_name: \"" + kind +
         "_filter_mask\"\n    yaml_filename: \"" + yaml + "\"\n" + kind +
         "_costmap_filter_info_server:\n  ros__parameters:\n    type: " + std::to_string(type) +
         "\n    filter_info_topic: \"/" + kind + "_costmap_filter_info\"\n    mask_topic: \"/" +
         kind + "_filter_mask\"\n" + values;
}

std::string withServers(const std::string& name, const std::string& kind, const std::string& plugin,
                        const std::string& servers) {
  const std::string path = withFilter(name, "      filters: [\"" + kind + "_filter\"]\n      " +
                                                kind + "_filter:\n        plugin: \"" + plugin +
                                                "\"\n        enabled: true\n"
                                                "        filter_info_topic: \"" +
                                                kind + "_costmap_filter_info\"\n");
  base::writeFileAtomically(path, textOf(path) + servers);
  return path;
}

}  // namespace

/// A path of another computer: its last part lies beside the parameter file.
void Nav2RoutesTest::keepout_byTopics_isNotEntered() {
  const std::string scenario = planeWith("nav2_keepout_topics", "      goal: {x: 8.0, y: 0.0}\n");
  maskFile("keepout_topic_mask", "trinary", 0, 254, {3.0, -3.0}, {5.0, 1.0});
  const RouteDriven round = driveRoute(
      scenario,
      withServers(
          "nav2_keepout_topics_params", "keepout", "nav2_costmap_2d::KeepoutFilter",
          maskServers("keepout", 0, "$(find-pkg-share my_robot)/maps/keepout_topic_mask.yaml")));
  QVERIFY2(round.hasArrived, round.problems.c_str());
  double highest = 0.0;
  for (const Vec2& place : round.places) {
    highest = std::max(highest, std::abs(place.y()));
  }
  QVERIFY2(highest > 0.99, qPrintable(QString::number(highest)));
}

/// Nav2's example: base 100 and multiplier -1, so that 70 in the mask is 30 %.
void Nav2RoutesTest::speedMask_byTopics_countsAsTheServerSays() {
  const std::string scenario = planeWith("nav2_speed_topics", "      goal: {x: 8.0, y: 0.0}\n");
  maskFile("speed_topic_mask", "raw", 70, 0, {3.0, -3.0}, {5.0, 3.0});
  const RouteDriven driven = driveRoute(
      scenario, withServers("nav2_speed_topics_params", "speed", "nav2_costmap_2d::SpeedFilter",
                            maskServers("speed", 1, "speed_topic_mask.yaml",
                                        "    base: 100.0\n    multiplier: -1.0\n")));
  QVERIFY2(driven.hasArrived, driven.problems.c_str());
  QVERIFY2(std::abs(speedAt(driven, {4.7, 0.0}) - 0.3) < 0.03,
           qPrintable(QString::number(speedAt(driven, {4.7, 0.0}))));
  QVERIFY(speedAt(driven, {2.0, 0.0}) > 0.9);
}

void Nav2RoutesTest::mask_ofAServerThatIsNotThere_isAWarning() {
  const base::Diagnostics found = app::checkNav2Files(
      {withServers("nav2_lost_mask", "keepout", "nav2_costmap_2d::KeepoutFilter",
                   maskServers("keepout", 0, "/home/robot/lost_mask.yaml"))});
  QVERIFY(!base::hasErrors(found));
  QVERIFY(std::any_of(found.begin(), found.end(), [](const base::Diagnostic& problem) {
    return problem.code == "nav2.mask-not-found" && problem.line > 0 && problem.column > 0;
  }));
}

QTEST_GUILESS_MAIN(Nav2RoutesTest)
#include "tst_Nav2Routes.moc"
