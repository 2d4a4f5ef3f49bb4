#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/route/RoutePlanner.h"
#include "tests/nav/RouteGraphs.h"

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else
using routes::edgeOf;
using routes::house;
using Settings = std::vector<std::pair<std::string, EdgeScorerSettings>>;

const RouteRequest kByPoses{true, {}, {}, 0, 0};
const Settings kDistance = {{"DistanceScorer", DistanceScorerParameters()}};

struct Asked {
  RouteGraph graph = house();
  Settings settings = kDistance;
  RouteRequest request = kByPoses;
  DynamicEdges dynamic;
  BlockedEdges blocked;
  const Costmap* costmap = nullptr;
  int iterations = 0;

  RouteResult route(std::uint32_t from, std::uint32_t to) const {
    const RouteScene scene{{}, costmap, costmap};
    return findRoute(graph, {*graph.nodeOf(from), *graph.nodeOf(to), iterations}, blocked, settings,
                     {request, dynamic, scene});
  }
  std::string way(std::uint32_t from, std::uint32_t to) const {
    const RouteResult result = route(from, to);
    std::string text;
    for (const std::size_t edge : result.route.edges) {
      text += (text.empty() ? "" : " ") + std::to_string(graph.edges[edge].id);
    }
    return result.error == RouteError::None ? text : std::to_string(static_cast<int>(result.error));
  }
  /// Of one edge between two nodes that has no alternative.
  double cost(std::uint32_t from, std::uint32_t to) const { return route(from, to).route.cost; }
};

constexpr double kTolerance = 1e-12;
bool isNear(double a, double b) {
  return std::fabs(a - b) <= kTolerance;
}

}  // namespace

/// Costs of edges and routes through graphs of nav2_route. Expected numbers are calculated by hand;
/// on random graphs the costs are those of Bellman and Ford's method, written here.
class RoutePlannerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void distance_shortestWay_isTaken() {
    Asked asked;
    QCOMPARE(asked.way(0, 4), std::string("10 14"));
    QVERIFY(isNear(asked.cost(0, 4), 8.0));
    QCOMPARE(asked.way(0, 2), std::string("12 13"));  // 2 + sqrt(17) < 4 + 3
    QVERIFY(isNear(asked.cost(0, 2), 2.0 + std::sqrt(17.0)));
    QCOMPARE(asked.route(0, 2).route.costs.size(), std::size_t{2});
    QVERIFY(isNear(asked.route(0, 2).route.costs[0], 2.0));
  }

  void distance_speedOfAnEdge_lengthensIt() {
    Asked asked;
    edgeOf(asked.graph, 12).metadata.set("speed_limit", 0.5);  // 2 m count as 4
    QCOMPARE(asked.way(0, 2), std::string("10 11"));
    asked.settings = {{"d", DistanceScorerParameters{"v", 3.0}}};
    QVERIFY(isNear(asked.cost(1, 2), 9.0));
    edgeOf(asked.graph, 11).metadata.set("v", 0.0);  // the edge is closed
    QCOMPARE(asked.way(1, 2), std::string("405"));
  }

  void blockedEdges_areNotTaken() {
    Asked asked;
    asked.blocked = {14};
    QCOMPARE(asked.way(0, 4), std::string("12 13 15"));
    QVERIFY(isNear(asked.cost(0, 4), 2.0 + std::sqrt(17.0) + 5.0));
  }

  void time_measuredOrBySpeed() {
    Asked asked;
    asked.settings = {{"TimeScorer", TimeScorerParameters()}};
    QVERIFY(isNear(asked.cost(1, 2), 6.0));  // 3 m at 0.5 m/s
    edgeOf(asked.graph, 11).metadata.set("abs_speed_limit", 0.25);
    QVERIFY(isNear(asked.cost(1, 2), 12.0));
    edgeOf(asked.graph, 11).metadata.set("abs_time_taken", 7.5);
    QVERIFY(isNear(asked.cost(1, 2), 7.5));
  }

  void penalty_ofAnEdge_isAdded() {
    Asked asked;
    asked.settings.emplace_back("PenaltyScorer", PenaltyScorerParameters{"penalty", 2.0});
    edgeOf(asked.graph, 13).metadata.set("penalty", 1.5);  // 3.0 more
    QCOMPARE(asked.way(0, 2), std::string("10 11"));
    asked.blocked = {10};
    QVERIFY(isNear(asked.cost(0, 2), 2.0 + std::sqrt(17.0) + 3.0));
  }

  void costmap_greatestOrMean_data() {
    QTest::addColumn<bool>("maximum");
    QTest::addColumn<int>("every");
    QTest::addColumn<double>("cost");
    // The line from (0, 0) to (4, 0) has the cells 0 to 8 of 0.5 m; cell 3 costs 100, cell 4
    // costs 50.
    QTest::newRow("greatest") << true << 1 << 2.0 * 100.0 / 253.0;
    QTest::newRow("greatest of every second") << true << 2 << 2.0 * 50.0 / 253.0;
    QTest::newRow("mean") << false << 1 << 2.0 * (150.0 / 9.0) / 253.0;
    QTest::newRow("mean of every second") << false << 2 << 2.0 * (50.0 / 5.0) / 253.0;
  }

  void costmap_greatestOrMean() {
    QFETCH(bool, maximum);
    QFETCH(int, every);
    Costmap costmap(20, 20, 0.5, {0.0, 0.0});
    costmap.set({3, 0}, 100);
    costmap.set({4, 0}, 50);
    Asked asked;
    asked.costmap = &costmap;
    CostmapScorerParameters scorer;
    scorer.useMaximum = maximum;
    scorer.checkResolution = every;
    scorer.weight = 2.0;
    asked.settings = {{"CostmapScorer", scorer}};
    QTEST(asked.cost(0, 1), "cost");
  }

  void costmap_obstacleOrOffTheMap_cannotBeTaken() {
    Costmap costmap(20, 20, 0.5, {0.0, 0.0});
    Asked asked;
    CostmapScorerParameters scorer;
    scorer.checkResolution = 1;
    asked.settings = {{"CostmapScorer", scorer}};
    QCOMPARE(asked.way(0, 1), std::string("405"));  // there is no costmap yet
    asked.costmap = &costmap;
    QCOMPARE(asked.way(0, 1), std::string("10"));
    costmap.set({5, 0}, 253);
    QCOMPARE(asked.way(0, 1), std::string("405"));
    scorer.invalidOnCollision = false;
    asked.settings = {{"CostmapScorer", scorer}};
    QCOMPARE(asked.cost(0, 1), 1.0);            // 253 of 253
    costmap = Costmap(4, 20, 0.5, {0.0, 0.0});  // 2 m wide
    QCOMPARE(asked.way(0, 1), std::string("405"));
    scorer.invalidOffMap = false;
    asked.settings = {{"CostmapScorer", scorer}};
    QCOMPARE(asked.cost(0, 1), 0.0);
  }

  void semantic_classesOfEdgeAndNode_addUp() {
    Asked asked;
    SemanticScorerParameters scorer;
    scorer.costs = {{"hall", 1.5}, {"office", 4.0}};
    scorer.weight = 2.0;
    asked.settings = {{"SemanticScorer", scorer}};
    edgeOf(asked.graph, 11).metadata.set("class", std::string("hall"));
    QCOMPARE(asked.cost(1, 2), 3.0);
    asked.graph.nodes[2].metadata.set("class", std::string("office"));  // where the edge leads
    QCOMPARE(asked.cost(1, 2), 11.0);
    scorer.semanticKey.clear();  // now the keys are classes
    asked.settings = {{"SemanticScorer", scorer}};
    QCOMPARE(asked.cost(1, 2), 0.0);
    edgeOf(asked.graph, 11).metadata.set("office", true);
    QCOMPARE(asked.cost(1, 2), 8.0);
  }

  void orientation_ofStartAndGoal_isOfTheirEdgesAlone() {
    Asked asked;
    OrientationScorerParameters start;
    start.orientationWeight = 10.0;
    asked.settings.emplace_back("StartPoseOrientationScorer", start);
    asked.request.start.heading = 0.0;  // edge 10 leads there, edge 12 to the left
    QCOMPARE(asked.way(0, 2), std::string("10 11"));
    asked.request.start.heading = 1.5707963267948966;
    QCOMPARE(asked.way(0, 2), std::string("12 13"));
    QVERIFY(isNear(asked.cost(0, 2), 2.0 + std::sqrt(17.0)));
    start.useOrientationThreshold = true;
    start.orientationTolerance = 1.0;
    asked.settings.back().second = start;
    asked.blocked = {12};
    QCOMPARE(asked.way(0, 2), std::string("405"));  // edge 10 is pi/2 off
    OrientationScorerParameters goal;
    goal.isOfGoal = true;
    asked.settings.back().second = goal;
    asked.request.goal.heading = 0.0;  // edge 11 arrives at pi/2
    QVERIFY(isNear(asked.cost(0, 2), 7.0 + 1.5707963267948966));
    asked.request.usesPoses = false;
    QCOMPARE(asked.way(0, 2), std::string("407"));
  }

  void dynamicEdges_closedOrDearer() {
    Asked asked;
    asked.settings.emplace_back("DynamicEdgesScorer", DynamicEdgesParameters());
    QVERIFY(asked.dynamic.apply("close 12 14"));
    QCOMPARE(asked.way(0, 4), std::string("10 11 15"));
    QVERIFY(asked.dynamic.apply("open 14"));
    QVERIFY(asked.dynamic.apply("cost 14 100.5"));
    QCOMPARE(asked.way(0, 4), std::string("10 11 15"));
    QVERIFY(isNear(asked.cost(1, 4), 8.0));  // 3 + 5 < 4 + 100.5
    QVERIFY(asked.dynamic.apply("cost 14 0"));
    QCOMPARE(asked.way(0, 4), std::string("10 14"));
  }

  void dynamicEdges_badTexts_changeNothing() {
    DynamicEdges edges;
    for (const char* text :
         {"", "close", "shut 3", "close 3 x", "cost 3", "cost 3 x", "close -1"}) {
      QVERIFY2(!edges.apply(text), text);
    }
    QVERIFY(edges.closed.empty() && edges.costs.empty());
  }

  void fixedCost_countsInstead() {
    Asked asked;
    edgeOf(asked.graph, 10).overridable = false;
    edgeOf(asked.graph, 10).cost = 0.5;
    QCOMPARE(asked.way(0, 2), std::string("10 11"));
    QVERIFY(isNear(asked.cost(0, 2), 3.5));
  }

  void noCost_isNoValidGraph() {
    Asked asked;
    asked.settings.clear();  // the costs of the file count, which are 0
    QCOMPARE(asked.way(0, 2), std::string("402"));
  }

  void noWay_isNoValidRoute() {
    QCOMPARE(Asked().way(4, 0), std::string("405"));  // edges are directed
  }

  void iterations_usedUp_isATimeout() {
    Asked asked;
    asked.iterations = 2;
    QCOMPARE(asked.way(0, 4), std::string("404"));
    asked.iterations = 10;
    QCOMPARE(asked.way(0, 4), std::string("10 14"));
  }

  void randomGraphs_costsAreThoseOfBellmanAndFord() {
    std::mt19937 rng(7);
    const auto uniform = [&] { return static_cast<double>(rng()) / 4294967296.0; };
    const auto below = [&](int count) { return static_cast<std::uint32_t>(uniform() * count); };
    int reachable = 0;
    for (int trial = 0; trial < 300; ++trial) {
      const int count = 2 + static_cast<int>(below(12));
      std::vector<std::pair<std::uint32_t, Vec2>> nodes;
      for (int i = 0; i < count; ++i) {
        nodes.emplace_back(i, Vec2(10.0 * uniform(), 10.0 * uniform()));
      }
      std::vector<routes::Way> ways;
      for (int i = 0; i < 2 * count; ++i) {
        ways.push_back({static_cast<std::uint32_t>(100 + i), below(count), below(count)});
      }
      Asked asked;
      asked.graph = routes::graphOf(nodes, ways);
      std::vector<double> costs(nodes.size(), std::numeric_limits<double>::infinity());
      costs[0] = 0.0;
      for (int round = 0; round < count; ++round) {
        for (const routes::Way& way : ways) {
          const double length = (nodes[way.to].second - nodes[way.from].second).norm();
          costs[way.to] = std::fmin(costs[way.to], costs[way.from] + length);
        }
      }
      const auto goal = static_cast<std::uint32_t>(count - 1);
      const RouteResult found = asked.route(0, goal);
      if (std::isfinite(costs[goal])) {
        ++reachable;
        QVERIFY(found.error == RouteError::None &&
                std::fabs(found.route.cost - costs[goal]) < 1e-9);
      } else {
        QVERIFY(found.error == RouteError::NoValidRoute);
      }
    }
    QVERIFY2(reachable > 100, std::to_string(reachable).c_str());
  }
};

QTEST_GUILESS_MAIN(RoutePlannerTest)
#include "tst_RoutePlanner.moc"
