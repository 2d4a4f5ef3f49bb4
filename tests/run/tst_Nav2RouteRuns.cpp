#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <QtTest>

#include "app/run/Bundle.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/run/Nav2Scene.h"

/// Runs of the planner `nav2` whose trees ask the route server, another navigator, or topics: a
/// robot on a free plane, from (0, 0) to (8, 0).
class Nav2RouteRunsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shippedTree_graphWithADetour_isFollowed_data();
  void shippedTree_graphWithADetour_isFollowed();
  void trackedRoute_slowEdge_limitsTheSpeed();
  void trackedRoute_closedEdge_isRoutedRound();
  void graph_missingOrBad_isToldAtItsPlace_data();
  void graph_missingOrBad_isToldAtItsPlace();
  void noGraph_failsWithNav2sCode();
  void navigateToPose_ownTree_drivesThere();
  void navigateToPose_missingTree_isAnError();
  void navigateToPose_insideAnother_isRefused();
  void controllerSelector_topic_switchesTheController();
  void topics_badText_isAnError();
};

namespace {

using namespace nav2scene;
using base::Vec2;

std::string scenario() {
  return written("nav2_routes.yaml", planeText(kStraight));
}

/// Nodes 0 (0.5, 0), 1 (1, 3), 2 (7, 3), 3 (7.5, 0), 4 (4, -3); edges 10, 11, 12 over the top, 13,
/// 14 through node 4 below, which are longer.
std::string graph() {
  const auto node = [](int id, double x, double y) {
    return R"({"type": "Feature", "properties": {"id": )" + std::to_string(id) +
           R"(, "frame": "map"}, "geometry": {"type": "Point", "coordinates": [)" +
           base::formatDouble(x) + ", " + base::formatDouble(y) + "]}}";
  };
  const auto edge = [](int id, int from, int to, const std::string& metadata) {
    return R"({"type": "Feature", "properties": {"id": )" + std::to_string(id) +
           R"(, "startid": )" + std::to_string(from) + R"(, "endid": )" + std::to_string(to) +
           metadata + R"(}, "geometry": {"type": "MultiLineString", "coordinates": []}})";
  };
  const std::string slow = R"(, "metadata": {"slow": 40})";
  return R"({"type": "FeatureCollection", "features": [)" + node(0, 0.5, 0) + "," + node(1, 1, 3) +
         "," + node(2, 7, 3) + "," + node(3, 7.5, 0) + "," + node(4, 4, -6) + ",\n" +
         edge(10, 0, 1, "") + "," + edge(11, 1, 2, slow) + "," + edge(12, 2, 3, "") + "," +
         edge(13, 0, 4, "") + "," + edge(14, 4, 3, "") + "]}";
}

/// The generic robot's file with a route server.
std::string params(const std::string& graphFile, const std::string& keys = {}) {
  return written("nav2_routes_params.yaml",
                 textOf(SOURCE_DIR "/resources/nav2_params/generic.yaml") +
                     "\nroute_server:\n  ros__parameters:\n    graph_filepath: \"" + graphFile +
                     "\"\n" + keys);
}

std::string tree(const std::string& nodes) {
  return treeFile("nav2_routes_tree.xml", nodes);
}

struct Driven {
  std::vector<Vec2> places;
  std::vector<double> speeds, times;  // [m/s], [s]
  bool hasArrived = false;
  std::string problems, failure;
  nlohmann::json report;

  double highest() const {
    double y = 0.0;
    for (const Vec2& place : places) {
      y = std::max(y, place.y());
    }
    return y;
  }
  double lowest() const {
    double y = 0.0;
    for (const Vec2& place : places) {
      y = std::min(y, place.y());
    }
    return y;
  }
};

Driven drive(const std::string& paramsFile, const std::string& treeFile, double longest,
             const std::vector<std::string>& set = {}) {
  app::RunSpec options;
  options.scenario = scenario();
  options.planner = "nav2";
  options.nav2Params = {paramsFile};
  options.nav2Tree = treeFile;
  options.nav2Distro = "kilted";
  options.set = set;
  const auto settings = app::runSettingsOf(options);
  app::Verdict verdict = app::check(app::readBundle(options, *settings, {}));
  base::append(verdict.problems, verdict.wrongOptions);
  base::append(verdict.problems, verdict.worldRemarks);
  Driven driven;
  driven.problems = problemsText(verdict.problems);
  if (!verdict.world) {
    return driven;
  }
  sim2d::World& world = *verdict.world;
  while (!world.arrivedAt() && world.time() < longest && world.step()) {
    const sim2d::RobotColumns& robots = world.frame().robots;
    driven.places.push_back({robots.x[0], robots.y[0]});
    driven.speeds.push_back(std::hypot(robots.vx[0], robots.vy[0]));
    driven.times.push_back(world.time());
  }
  driven.hasArrived = world.arrivedAt().has_value();
  driven.failure = world.failure();
  driven.report = nlohmann::json::parse(world.plannerReports().at(0));
  return driven;
}

std::string shippedTree(const std::string& branch, const std::string& name) {
  return SOURCE_DIR "/resources/nav2_trees/" + branch + "/" + name + ".xml";
}

/// The route is tracked while its path is followed.
const std::string kTracked = R"(<Parallel success_count="2" failure_count="1">
    <ComputeAndTrackRoute goal="{goal}" use_poses="true" path="{path}"/>
    <Sequence><Delay delay_msec="100"><AlwaysSuccess/></Delay><FollowPath path="{path}"/></Sequence>
  </Parallel>)";

}  // namespace

void Nav2RouteRunsTest::shippedTree_graphWithADetour_isFollowed_data() {
  QTest::addColumn<QString>("branch");
  QTest::newRow("kilted") << "kilted";
  QTest::newRow("main") << "main";
}

void Nav2RouteRunsTest::shippedTree_graphWithADetour_isFollowed() {
  QFETCH(QString, branch);
  written("nav2_graph.geojson", graph());
  // The path of a robot's computer: the file beside the parameters counts.
  const Driven driven =
      drive(params("/opt/ros/graphs/nav2_graph.geojson"),
            shippedTree(branch.toStdString(), "navigate_on_route_graph_w_recovery"), 90.0,
            {"robot1.nav2_distro=" + branch.toStdString()});
  QVERIFY2(driven.hasArrived, (driven.problems + driven.failure + driven.report.dump()).c_str());
  QVERIFY2(driven.highest() > 2.5, base::formatDouble(driven.highest()).c_str());
  QVERIFY(driven.report["route"]["graph"].get<std::string>().find("nav2_graph.geojson") !=
          std::string::npos);
}

void Nav2RouteRunsTest::trackedRoute_slowEdge_limitsTheSpeed() {
  written("nav2_graph.geojson", graph());
  const std::string keys =
      "    prune_goal: false\n"
      "    operations: [\"Limit\"]\n    Limit:\n      plugin: \"nav2_route::AdjustSpeedLimit\"\n"
      "      speed_tag: \"slow\"\n";
  const Driven driven = drive(params("nav2_graph.geojson", keys), tree(kTracked), 90.0);
  QVERIFY2(driven.highest() > 2.5, (driven.problems + driven.failure).c_str());
  double onSlow = 0.0, elsewhere = 0.0;
  for (std::size_t i = 0; i < driven.places.size(); ++i) {
    const Vec2 place = driven.places[i];
    if (place.y() > 2.5 && place.x() > 3.0 && place.x() < 5.5) {  // in the middle of edge 11
      onSlow = std::max(onSlow, driven.speeds[i]);
    } else if (place.y() < 1.5) {
      elsewhere = std::max(elsewhere, driven.speeds[i]);
    }
  }
  // The file's vx_max is 0.8 m/s, 40 % of it 0.32 m/s.
  QVERIFY2(onSlow > 0.2 && onSlow < 0.36, base::formatDouble(onSlow).c_str());
  QVERIFY2(elsewhere > 0.5, base::formatDouble(elsewhere).c_str());
}

void Nav2RouteRunsTest::trackedRoute_closedEdge_isRoutedRound() {
  written("nav2_graph.geojson", graph());
  const std::string file = params("nav2_graph.geojson");
  const Driven driven =
      drive(file, tree(kTracked), 90.0,
            {"robot1.nav2_topics=0 route_server/DynamicEdgesScorer/adjust_edges close 11"});
  QVERIFY2(driven.lowest() < -4.0, (driven.problems + driven.failure).c_str());
  QVERIFY(driven.highest() < 1.0);
  const Driven later =
      drive(file, tree(kTracked), 30.0,
            {"robot1.nav2_topics=1 route_server/DynamicEdgesScorer/adjust_edges close 11; "
             "1 /route_server/ReroutingService/reroute"});
  QVERIFY2(later.lowest() < -4.0, (later.problems + later.failure).c_str());
  QCOMPARE(later.report["route"]["events"][0]["event"], "reroute");
}

void Nav2RouteRunsTest::graph_missingOrBad_isToldAtItsPlace_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("problem");
  QTest::addColumn<bool>("runs");
  QTest::newRow("missing") << "nav2_nowhere.geojson"
                           << "warning: route_server: graph_filepath: 'nav2_nowhere.geojson' was "
                              "not found"
                           << true;
  QTest::newRow("bad") << "nav2_bad.geojson"
                       << "nav2_bad.geojson:2:12: error: not valid JSON" << false;
}

void Nav2RouteRunsTest::graph_missingOrBad_isToldAtItsPlace() {
  QFETCH(QString, name);
  QFETCH(QString, problem);
  QFETCH(bool, runs);
  written("nav2_bad.geojson", "{\n\"features\":]}");
  const Driven driven = drive(params(name.toStdString()),
                              shippedTree("kilted", "navigate_on_route_graph_w_recovery"), 1.0);
  QVERIFY2(driven.problems.find(problem.toStdString()) != std::string::npos,
           driven.problems.c_str());
  QCOMPARE(!driven.places.empty(), runs);
}

void Nav2RouteRunsTest::noGraph_failsWithNav2sCode() {
  const std::string nodes = R"(<Fallback>
      <ComputeRoute goal="{goal}" use_poses="true" error_code_id="{code}"/>
      <Sequence><AreErrorCodesPresent error_code="{code}" error_codes_to_check="402"/><Spin/></Sequence>
    </Fallback>)";
  const Driven driven = drive(params(""), tree(nodes), 10.0);
  QVERIFY2(driven.problems.find("error:") == std::string::npos, driven.problems.c_str());
  QVERIFY2(driven.problems.find("the tree computes routes") != std::string::npos,
           driven.problems.c_str());
  QCOMPARE(driven.report["counts"]["recoveries"], 1);  // it has turned
  QCOMPARE(driven.report["counts"]["tree_failures"], 0);
}

void Nav2RouteRunsTest::navigateToPose_ownTree_drivesThere() {
  written("nav2_inner.xml", R"(<root BTCPP_format="4" main_tree_to_execute="I">
      <BehaviorTree ID="I"><Sequence><ComputePathToPose goal="{goal}" path="{path}"/>
      <FollowPath path="{path}"/></Sequence></BehaviorTree></root>)");
  const std::string nodes = R"(<Sequence>
      <Spin spin_dist="0.5"/>
      <NavigateToPose goal="{goal}" behavior_tree=")" +
                            inTmp("nav2_inner.xml") + R"("/></Sequence>)";
  const Driven driven = drive(params(""), tree(nodes), 60.0);
  QVERIFY2(driven.hasArrived, (driven.problems + driven.failure).c_str());
  const Driven usual = drive(params(""), tree("<NavigateToPose goal=\"{goal}\"/>"), 60.0,
                             {"nav2.default_nav_to_pose_bt_xml=" +
                              shippedTree("kilted", "navigate_to_pose_w_replanning_and_recovery")});
  QVERIFY2(usual.hasArrived, (usual.problems + usual.failure).c_str());
}

void Nav2RouteRunsTest::navigateToPose_missingTree_isAnError() {
  const Driven driven = drive(
      params(""), tree(R"(<NavigateToPose goal="{goal}" behavior_tree="nowhere.xml"/>)"), 1.0);
  QVERIFY2(driven.problems.find("nowhere.xml") != std::string::npos, driven.problems.c_str());
  QVERIFY(driven.places.empty());
}

void Nav2RouteRunsTest::navigateToPose_insideAnother_isRefused() {
  written("nav2_inner.xml", R"(<root BTCPP_format="4" main_tree_to_execute="I">
      <BehaviorTree ID="I"><NavigateToPose goal="{goal}"/></BehaviorTree></root>)");
  const std::string nodes = R"(<Fallback><NavigateToPose goal="{goal}" error_code_id="{code}"
      behavior_tree=")" + inTmp("nav2_inner.xml") +
                            R"("/><Sequence>
      <AreErrorCodesPresent error_code="{code}" error_codes_to_check="9000"/><Spin/></Sequence>
    </Fallback>)";
  const Driven driven = drive(params(""), tree(nodes), 10.0);
  QCOMPARE(driven.report["counts"]["recoveries"], 1);
  QCOMPARE(driven.report["counts"]["tree_failures"], 0);
}

/// The second controller is slow.
void Nav2RouteRunsTest::controllerSelector_topic_switchesTheController() {
  const std::string nodes = R"(<PipelineSequence>
      <ControllerSelector topic_name="controller_selector" default_controller="FollowPath"
        selected_controller="{controller}"/>
      <RateController hz="1"><ComputePathToPose goal="{goal}" path="{path}"/></RateController>
      <FollowPath path="{path}" controller_id="{controller}"/></PipelineSequence>)";
  std::string text = *base::readTextFile(SOURCE_DIR "/resources/nav2_params/generic.yaml");
  const std::string list = "controller_plugins: [\"FollowPath\"]";
  text.replace(text.find(list), list.size(),
               "controller_plugins: [\"FollowPath\", \"Slow\"]\n"
               "    Slow:\n"
               "      plugin: \"nav2_regulated_pure_pursuit_controller::"
               "RegulatedPurePursuitController\"\n"
               "      desired_linear_vel: 0.2\n      regulated_linear_scaling_min_speed: 0.1");
  const std::string file = written("nav2_two.yaml", text);
  const Driven driven =
      drive(file, tree(nodes), 12.0, {"robot1.nav2_topics=5 /controller_selector Slow"});
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < driven.times.size(); ++i) {
    (driven.times[i] < 5.0 ? before : after) =
        driven.times[i] < 5.0   ? std::max(before, driven.speeds[i])
        : driven.times[i] > 8.0 ? std::max(after, driven.speeds[i])
                                : after;
  }
  QVERIFY2(before > 0.5, (driven.problems + driven.failure).c_str());
  QVERIFY2(after > 0.1 && after < 0.25, base::formatDouble(after).c_str());
}

void Nav2RouteRunsTest::topics_badText_isAnError() {
  const Driven driven = drive(params(""), tree("<AlwaysSuccess/>"), 1.0,
                              {"robot1.nav2_topics=soon controller_selector Slow"});
  QVERIFY2(
      driven.problems.find("'soon controller_selector Slow' must be a time") != std::string::npos,
      driven.problems.c_str());
  QVERIFY(driven.places.empty());
}

QTEST_GUILESS_MAIN(Nav2RouteRunsTest)
#include "tst_Nav2RouteRuns.moc"
