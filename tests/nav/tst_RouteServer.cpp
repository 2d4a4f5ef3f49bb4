#include <cmath>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/route/RouteServer.h"
#include "tests/nav/RouteGraphs.h"

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using routes::edgeOf;
using routes::house;

constexpr double kPi = 3.14159265358979323846;
constexpr double kTolerance = 1e-9;
bool isNear(double a, double b) {
  return std::fabs(a - b) <= kTolerance;
}
bool isAt(const Vec2& place, double x, double y) {
  return isNear(place.x(), x) && isNear(place.y(), y);
}

RouteSettings settings() {
  RouteSettings all;
  all.scorers = {{"DistanceScorer", DistanceScorerParameters()}};
  all.server.pruneGoal = false;
  return all;
}

RouteRequest byIds(std::uint32_t from, std::uint32_t to) {
  return {false, {}, {}, from, to};
}
RouteRequest byPoses(const Vec2& from, const Vec2& to) {
  return {true, {from, 0.0}, {to, 0.0}, 0, 0};
}

RouteScene at(double x, double y, double time = 0.0, const Costmap* costmap = nullptr) {
  return {{{x, y}, 0.0}, costmap, costmap, time};
}

Route routeOf(const RouteGraph& graph, const std::vector<std::uint32_t>& ids) {
  Route route;
  for (const std::uint32_t id : ids) {
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      if (graph.edges[i].id == id) {
        route.edges.push_back(i);
        route.costs.push_back(graph.lengthOf(graph.edges[i]));
        route.cost += route.costs.back();
      }
    }
  }
  route.start = graph.edges[route.edges.front()].from;
  return route;
}

/// Drives on a line at 1 m/s from `time` on in steps of 0.05 s.
void drive(RouteServer& server, Vec2 from, const Vec2& to, double& time,
           const Costmap* costmap = nullptr) {
  const double length = (to - from).norm();
  for (double way = 0.0; way <= length; way += 0.05) {
    const Vec2 place = from + (way / length) * (to - from);
    time += 0.05;
    server.update({{place, 0.0}, costmap, costmap, time});
  }
}

}  // namespace

/// Paths along routes of nav2_route, nodes of poses, progress on a route, operations. Expected
/// numbers are calculated by hand.
class RouteServerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void corner_ofARightAngle_isAQuarterOfACircle() {
    const CornerArc arc({0, 0}, {4, 0}, {4, 3}, 1.0);
    QVERIFY(arc.isValid());
    QVERIFY(isAt(arc.begin(), 3, 0) && isAt(arc.end(), 4, 1) && isAt(arc.centre(), 3, 1));
    const std::vector<Vec2> points = arc.points(0.05);  // pi/2 / 0.05 = 31.4
    QCOMPARE(points.size(), std::size_t{32});
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double angle = -0.5 * kPi + 0.5 * kPi * static_cast<double>(i) / 32.0;
      QVERIFY(isAt(points[i], 3.0 + std::cos(angle), 1.0 + std::sin(angle)));
    }
    // 60 degrees between the edges: the tangents are radius / tan 30 degrees long.
    const CornerArc sharp({5, 0}, {0, 0}, {2.5, 2.5 * std::sqrt(3.0)}, 1.0);
    QVERIFY(isAt(sharp.begin(), std::sqrt(3.0), 0));
    QVERIFY(isAt(sharp.centre(), std::sqrt(3.0), 1.0));
  }

  void corner_impossible_isNotValid_data() {
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    QTest::addColumn<double>("radius");
    QTest::newRow("straight on") << 8.0 << 0.0 << 1.0;
    QTest::newRow("back") << 0.0 << 0.0 << 1.0;
    QTest::newRow("no length") << 4.0 << 0.0 << 1.0;
    QTest::newRow("longer than an edge") << 4.0 << 3.0 << 3.5;
  }

  void corner_impossible_isNotValid() {
    QFETCH(double, x);
    QFETCH(double, y);
    QFETCH(double, radius);
    QVERIFY(!CornerArc({0, 0}, {4, 0}, {x, y}, radius).isValid());
  }

  void path_ofTwoEdges_hasPosesOfTheDensity() {
    const RouteGraph graph = house();
    RouteServerParameters parameters;
    parameters.pathDensity = 0.7;  // 4 m in 6 parts, 3 m in 5
    const Path path = pathOf(routeOf(graph, {10, 11}), graph, parameters);
    QCOMPARE(path.size(), std::size_t{6 + 5 + 1});
    QVERIFY(isAt(path[1].position, 4.0 / 6.0, 0.0) && isAt(path[7].position, 4.0, 0.6));
    QVERIFY(isAt(path.back().position, 4.0, 3.0));
    for (std::size_t i = 0; i < path.size(); ++i) {
      QVERIFY(isNear(path[i].heading, i < 6 ? 0.0 : 0.5 * kPi));
    }
  }

  void path_withSmoothCorners_keepsTheRadius() {
    const RouteGraph graph = house();
    RouteServerParameters parameters;
    parameters.smoothCorners = true;
    parameters.pathDensity = 0.1;
    const Path path = pathOf(routeOf(graph, {10, 11}), graph, parameters);
    // 3 m in 30 parts, the arc in ceil(pi/2 / 0.1) = 16, 2 m in 20, and the end.
    QCOMPARE(path.size(), std::size_t{30 + 16 + 20 + 1});
    for (std::size_t i = 30; i <= 46; ++i) {
      QVERIFY(isNear((path[i].position - Vec2(3.0, 1.0)).norm(), 1.0));
    }
    parameters.smoothingRadius = 3.5;  // does not fit: the corner stays
    QCOMPARE(pathOf(routeOf(graph, {10, 11}), graph, parameters).size(), std::size_t{40 + 30 + 1});
  }

  void path_withoutEdges_isTheNode() {
    const RouteGraph graph = house();
    Route route;
    route.start = 2;
    const Path path = pathOf(route, graph, {});
    QCOMPARE(path.size(), std::size_t{1});
    QVERIFY(isAt(path[0].position, 4.0, 3.0));
  }

  void nearest_nodes_areInOrder() {
    const RouteGraph graph = house();
    QCOMPARE(nearestNodes(graph, {3.5, 1.0}, 3), (std::vector<std::size_t>{1, 2, 0}));
    QCOMPARE(nearestNodes(graph, {0.0, 1.0}, 2), (std::vector<std::size_t>{0, 3}));  // equally near
  }

  void nodeOfPose_behindAWall_isOneThatCanBeReached() {
    const RouteGraph graph = house();
    RouteServerParameters parameters;
    Costmap costmap(100, 60, 0.1, {-1.0, -1.0});
    const Vec2 pose(3.0, 1.0);  // node 1 is sqrt 2 m away, node 2 sqrt 5 m
    QCOMPARE(*nodeOfPose(graph, pose, &costmap, parameters), std::size_t{1});
    for (int column = 0; column < 100; ++column) {
      costmap.set({column, 15}, kLethal);  // a wall at y = 0.55 m
    }
    QCOMPARE(*nodeOfPose(graph, pose, &costmap, parameters), std::size_t{2});
    QCOMPARE(*nodeOfPose(graph, pose, nullptr, parameters), std::size_t{1});
    parameters.maxNnSearchIterations = 5;
    QCOMPARE(*nodeOfPose(graph, pose, &costmap, parameters), std::size_t{1});
    parameters.enableNnSearch = false;
    QCOMPARE(*nodeOfPose(graph, pose, &costmap, parameters), std::size_t{1});
    QVERIFY(!nodeOfPose(RouteGraph(), pose, &costmap, parameters));
  }

  void pruned_startBesideTheFirstEdge_leavesItOut() {
    const RouteGraph graph = house();
    const Route whole = routeOf(graph, {10, 11});
    RouteServerParameters parameters;
    const auto edges = [&](const Vec2& start, bool isFirst = true, bool usesPoses = true) {
      ContinuedEdge none;
      RouteRequest request = byPoses(start, {4.0, 3.0});
      request.usesPoses = usesPoses;
      return pruneRoute(whole, graph, request, isFirst, parameters, none).edges.size();
    };
    QCOMPARE(edges({1.0, 0.5}), std::size_t{1});
    QCOMPARE(edges({-1.0, 0.5}), std::size_t{2});              // before the node
    QCOMPARE(edges({0.05, 0.0}), std::size_t{2});              // at the node: 0.05 < 0.10
    QCOMPARE(edges({1.0, 8.5}), std::size_t{2});               // farther than 8 m from the edge
    QCOMPARE(edges({1.0, 0.5}, true, false), std::size_t{2});  // by ids there is no start
    QCOMPARE(edges({1.0, 0.5}, false, false), std::size_t{1});
    ContinuedEdge continued{whole.edges[0], Vec2::Zero()};
    const Route left =
        pruneRoute(whole, graph, byPoses({1.0, 0.5}, {4.0, 3.0}), false, parameters, continued);
    QCOMPARE(left.start, std::size_t{1});
    QVERIFY(isNear(left.cost, 3.0));
    QVERIFY(continued.edge == whole.edges[0] && isAt(continued.nearest, 1.0, 0.0));
    continued = {whole.edges[1], Vec2::Zero()};
    pruneRoute(whole, graph, byPoses({1.0, 0.5}, {4.0, 3.0}), false, parameters, continued);
    QVERIFY(!continued.edge);
  }

  void pruned_goalBeforeTheLastNode_leavesTheEdgeOut() {
    const RouteGraph graph = house();
    const Route whole = routeOf(graph, {10, 11});
    RouteServerParameters parameters;
    const auto edges = [&](const Vec2& goal) {
      ContinuedEdge none;
      return pruneRoute(whole, graph, byPoses({0.0, 0.0}, goal), true, parameters, none)
          .edges.size();
    };
    QCOMPARE(edges({4.2, 2.0}), std::size_t{1});
    QCOMPARE(edges({4.2, 3.5}), std::size_t{2});  // past the last node
    QCOMPARE(edges({4.0, 2.9}), std::size_t{2});  // 0.1 m < 0.15 m
    parameters.pruneGoal = false;
    QCOMPARE(edges({4.2, 2.0}), std::size_t{2});
  }

  void compute_errors_haveNav2sNumbers() {
    const auto code = [](const RouteServer& server, const RouteRequest& request) {
      const RoutePlan plan = server.compute(request, at(0, 0));
      return plan.text.empty() ? 0 : static_cast<int>(plan.error);
    };
    const RouteServer server(settings(), house());
    QCOMPARE(code(RouteServer(settings(), RouteGraph()), byIds(0, 4)), 402);
    QCOMPARE(code(server, byIds(0, 77)), 403);
    QCOMPARE(code(server, byIds(77, 0)), 403);
    QCOMPARE(code(server, byIds(4, 0)), 405);
    RouteSettings few = settings();
    few.server.maxIterations = 1;
    QCOMPARE(code(RouteServer(few, house()), byIds(0, 4)), 404);
    RouteSettings headings = settings();
    headings.scorers.emplace_back("start", OrientationScorerParameters());
    QCOMPARE(code(RouteServer(headings, house()), byIds(0, 4)), 407);
  }

  void compute_startIsGoal_isASinglePose() {
    const RoutePlan plan = RouteServer(settings(), house()).compute(byIds(2, 2), at(0, 0));
    QVERIFY(plan.error == RouteError::None && plan.route.edges.empty());
    QCOMPARE(plan.path.size(), std::size_t{1});
  }

  void tracking_alongARoute_achievesNodes() {
    RouteServer server(settings(), house());
    server.track(byIds(0, 2), at(-3, 0));
    const TrackFeedback& now = server.feedback();
    QVERIFY(now.status == TrackStatus::Running);
    QCOMPARE(now.nextNode, 0U);
    double time = 0.0;
    drive(server, {-3, 0}, {-1.1, 0}, time);
    QCOMPARE(now.number, 1);  // not within a metre of node 0
    drive(server, {-1.1, 0}, {-0.9, 0}, time);
    QCOMPARE(now.number, 2);
    QCOMPARE(now.currentEdge, 12U);
    QCOMPARE(now.nextNode, 3U);
    // Node 3 (0, 2): the bisector of its edges leans forward; on the way it is passed at the node.
    drive(server, {-0.9, 0}, {0, 1.9}, time);
    QCOMPARE(now.currentEdge, 12U);
    drive(server, {0, 1.9}, {0.2, 2.1}, time);
    QCOMPARE(now.currentEdge, 13U);
    QCOMPARE(now.lastNode, 3U);
    drive(server, {0.2, 2.1}, {2.9, 3.0}, time);
    QVERIFY(now.status == TrackStatus::Running);
    drive(server, {2.9, 3.0}, {3.2, 3.0}, time);
    QVERIFY(now.status == TrackStatus::Succeeded);
    QVERIFY(std::fabs(now.duration - time) < 0.3);
  }

  void tracking_cutCorner_achievesTheNodeOnTheBisector() {
    const RouteGraph graph = house();
    const Route route = routeOf(graph, {10, 11});
    const RouteServerParameters parameters;
    const auto achieves = [&](const Vec2& place, bool wasNear = false) {
      TrackState state = beginTracking(route, graph, {});
      advanceToNextEdge(state, route, graph);  // on edge 10, to node 1 (4, 0)
      state.isNear = wasNear;
      return isNodeAchieved(state, place, route, graph, parameters);
    };
    // The bisector of (1, 0) and (0, 1): passed where x + y > 4.
    QVERIFY(!achieves({3.4, 0.5}));
    QVERIFY(achieves({3.6, 0.5}));
    QVERIFY(achieves({4.0, 0.0}));
    QVERIFY(!achieves({4.0, 2.5}));       // too far, never near
    QVERIFY(achieves({4.0, 2.5}, true));  // has been near and left
  }

  void tracking_slowRate_looksThatOften() {
    RouteSettings slow = settings();
    slow.server.trackerUpdateRate = 1.0;
    RouteServer server(slow, house());
    server.track(byIds(0, 2), at(-3, 0));
    server.update(at(-3, 0, 0.0));
    server.update(at(0, 0, 0.95));
    QCOMPARE(server.feedback().number, 1);
    server.update(at(0, 0, 1.0));
    QCOMPARE(server.feedback().number, 2);
  }

  void speedLimit_ofAnEdge_isSetOnEntering() {
    RouteSettings with = settings();
    with.operations = {{"AdjustSpeedLimit", AdjustSpeedLimitParameters{"slow"}}};
    RouteGraph graph = house();
    edgeOf(graph, 12).metadata.set("slow", 40.0);
    RouteServer server(with, graph);
    server.track(byIds(0, 2), at(-3, 0));
    QVERIFY(!server.takeSpeedLimit());
    double time = 0.0;
    drive(server, {-3, 0}, {0, 0}, time);
    QCOMPARE(server.takeSpeedLimit(), std::optional<double>(40.0));
    QVERIFY(!server.takeSpeedLimit());
    drive(server, {0, 0}, {0, 2.1}, time);
    drive(server, {0, 2.1}, {0.5, 2.2}, time);
    QCOMPARE(server.takeSpeedLimit(), std::optional<double>(100.0));
  }

  void collision_ahead_isRoutedRound() {
    RouteSettings with = settings();
    with.operations = {{"CollisionMonitor", RouteCollisionParameters()}};
    RouteServer server(with, house());
    Costmap costmap(100, 60, 0.1, {-1.0, -1.0});
    server.track(byIds(0, 2), at(-3, 0));
    double time = 0.0;
    drive(server, {-0.5, 0}, {0, 0}, time, &costmap);
    QCOMPARE(server.feedback().currentEdge, 12U);
    costmap.set({10, 20}, kLethal);  // (0.05, 1.05): on edge 12, where x is 0
    for (int i = 0; i < 25; ++i) {
      time += 0.05;
      server.update(at(0, 0.0, time, &costmap));
    }
    // The new route begins at node 0, where the robot stands, and goes over node 1.
    QCOMPARE(server.feedback().currentEdge, 10U);
    QCOMPARE(server.feedback().nextNode, 1U);
    const Route& route = server.feedback().plan.route;
    QCOMPARE(server.graph().edges[route.edges.front()].id, 10U);
    QCOMPARE(server.events().back().what, std::string("reroute"));
  }

  void collision_withoutRerouting_fails() {
    RouteSettings with = settings();
    RouteCollisionParameters monitor;
    monitor.rerouteOnCollision = false;
    with.operations = {{"CollisionMonitor", monitor}};
    RouteServer server(with, house());
    Costmap costmap(100, 60, 0.1, {-1.0, -1.0});
    server.track(byIds(0, 2), at(-3, 0));
    double time = 0.0;
    drive(server, {-0.5, 0}, {0, 0}, time, &costmap);
    costmap.set({10, 20}, kLethal);
    server.update(at(0, 0, time, &costmap));
    QVERIFY(server.feedback().status == TrackStatus::Running);  // it looks once a second
    drive(server, {0, 0}, {0, 0.8}, time, &costmap);
    QVERIFY(server.feedback().status == TrackStatus::Failed);
    QCOMPARE(static_cast<int>(server.feedback().plan.error), 406);
  }

  void reroute_onTheSameEdge_goesOnFromThere() {
    RouteSettings with = settings();
    with.operations = {{"ReroutingService", ReroutingServiceParameters()}};
    RouteServer server(with, house());
    server.track(byIds(0, 4), at(-3, 0));
    double time = 0.0;
    drive(server, {-0.5, 0}, {1.0, 0.5}, time);
    QCOMPARE(server.feedback().currentEdge, 10U);
    server.requestReroute();
    server.update(at(1.0, 0.5, time + 0.05));
    QVERIFY(server.feedback().isRerouted);
    QCOMPARE(server.feedback().currentEdge, 10U);  // still on it
    QCOMPARE(server.feedback().nextNode, 1U);
    const Path& path = server.feedback().plan.path;
    QVERIFY(isAt(path.front().position, 1.0, 0.0));  // the nearest point of the edge
    QVERIFY(isAt(path.back().position, 8.0, 0.0));
  }

  void rerouteService_findsTheRouteAnew() {
    RouteSettings with = settings();
    with.operations = {{"ReroutingService", ReroutingServiceParameters()}};
    with.scorers.emplace_back("DynamicEdgesScorer", DynamicEdgesParameters());
    RouteServer server(with, house());
    server.track(byIds(0, 4), at(-3, 0));
    QVERIFY(server.adjustEdges("close 14"));
    server.update(at(-3, 0, 0.1));
    QCOMPARE(server.feedback().number, 1);
    server.requestReroute();
    server.update(at(-3, 0, 0.2));
    QVERIFY(server.feedback().isRerouted);
    QCOMPARE(server.feedback().plan.route.edges.size(), std::size_t{3});
  }

  void timeMarker_recordsTheTimeOfAnEdge() {
    RouteSettings with = settings();
    with.operations = {{"TimeMarker", TimeMarkerParameters()}};
    RouteServer server(with, house());
    server.track(byIds(0, 2), at(-3, 0));
    server.update(at(0, 0, 1.0));  // node 0
    server.update(at(0, 1.0, 4.0));
    server.update(at(0.1, 2.1, 6.5));  // node 3
    const auto time =
        edgeOf(const_cast<RouteGraph&>(server.graph()), 12).metadata.number("abs_time_taken");
    QVERIFY(time && isNear(*time, 5.5));
  }

  void triggerEvent_ofNodesAndEdges_isRecorded() {
    using Trigger = RouteOperation::Trigger;
    RouteSettings with = settings();
    with.operations = {{"Door", TriggerEventParameters{"usual"}}};
    RouteGraph graph = house();
    RouteMetadata named;
    named.set("service_name", std::string("open_door"));
    graph.nodes[0].operations = {{"Door", Trigger::Node, {}}};
    edgeOf(graph, 12).operations = {{"Door", Trigger::OnEnter, named}};
    edgeOf(graph, 13).operations = {{"Door", Trigger::OnExit, named}};
    RouteServer server(with, graph);
    server.track(byIds(0, 2), at(-3, 0));
    server.update(at(0, 0, 1.0));
    QCOMPARE(server.events().size(), std::size_t{2});
    QCOMPARE(server.events()[0].what, std::string("usual"));
    QCOMPARE(server.events()[1].what, std::string("open_door"));
    QCOMPARE(server.events()[1].time, 1.0);
    server.update(at(0.1, 2.1, 3.0));
    QCOMPARE(server.events().size(), std::size_t{2});  // edge 13 is left at its end alone
    server.update(at(3.5, 3.0, 6.0));
    QCOMPARE(server.events().size(), std::size_t{3});
  }

  void unknownOperation_ofTheGraph_fails() {
    RouteGraph graph = house();
    graph.nodes[0].operations = {{"Door", RouteOperation::Trigger::Node, {}}};
    RouteServer server(settings(), graph);
    server.track(byIds(0, 2), at(-3, 0));
    server.update(at(0, 0, 1.0));
    QVERIFY(server.feedback().status == TrackStatus::Failed);
    QCOMPARE(static_cast<int>(server.feedback().plan.error), 406);
    QVERIFY(server.feedback().plan.text.find("Door") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(RouteServerTest)
#include "tst_RouteServer.moc"
