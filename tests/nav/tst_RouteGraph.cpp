#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/route/RouteGraph.h"

namespace {

using namespace sim2d::nav2;  // NOLINT: this file is about nothing else

std::string node(int id, double x, double y, const std::string& more = {}) {
  return R"({"type": "Feature", "properties": {"id": )" + std::to_string(id) +
         R"(, "frame": "map")" + more + R"(}, "geometry": {"type": "Point", "coordinates": [)" +
         std::to_string(x) + ", " + std::to_string(y) + "]}}";
}
std::string edge(int id, int from, int to, const std::string& more = {}) {
  return R"({"type": "Feature", "properties": {"id": )" + std::to_string(id) + R"(, "startid": )" +
         std::to_string(from) + R"(, "endid": )" + std::to_string(to) + more +
         R"(}, "geometry": {"type": "MultiLineString", "coordinates": [[[0, 0], [1, 1]]]}})";
}
std::string graph(const std::string& features) {
  return R"({"type": "FeatureCollection", "features": [)" + features + "]}";
}
base::Result<RouteGraph> read(const std::string& text) {
  return readRouteGraph(text, "g.geojson");
}
std::string problemsOf(const std::string& text) {
  std::string all;
  const auto graph = read(text);
  for (const base::Diagnostic& problem : graph.diagnostics()) {
    all += (all.empty() ? "" : "\n") + problem.text();
  }
  return all;
}

}  // namespace

/// Graphs of nav2_route from GeoJSON.
class RouteGraphTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void read_nodesAndEdges_areThoseOfTheFile() {
    const auto read_ =
        read(graph(edge(20, 7, 3) + "," + node(3, 1.5, -2.0) + "," + node(7, 4.5, 2.0) + "," +
                   edge(21, 3, 7, R"(, "cost": 2.5, "overridable": false)")));
    QVERIFY(read_);
    QCOMPARE(read_->nodes.size(), std::size_t{2});
    QCOMPARE(read_->nodes[0].id, 3U);
    QCOMPARE(read_->nodes[0].place.y(), -2.0);
    QCOMPARE(read_->edges.size(), std::size_t{2});
    QCOMPARE(read_->edges[0].from, std::size_t{1});
    QCOMPARE(read_->edges[0].to, std::size_t{0});
    QVERIFY(read_->edges[0].overridable);
    QCOMPARE(read_->edges[1].cost, 2.5);
    QVERIFY(!read_->edges[1].overridable);
    QCOMPARE(read_->lengthOf(read_->edges[0]), 5.0);  // 3, 4, 5
    QCOMPARE(read_->outgoing[0], (std::vector<std::size_t>{1}));
    QCOMPARE(*read_->nodeOf(7), std::size_t{1});
    QVERIFY(!read_->nodeOf(20));
  }

  void read_metadataAndOperations_areKept() {
    const std::string of = R"(, "metadata": {"class": "hall", "speed_limit": 40, "wet": true},
      "operations": {"a": {"type": "Open", "trigger": "ON_ENTER", "metadata": {"door": "d1"}},
                     "b": {"type": "Close", "trigger": "ON_EXIT"}})";
    const auto read_ = read(graph(node(0, 0, 0, R"(, "operations": {"c": {"type": "Beep"}})") +
                                  "," + node(1, 1, 0) + "," + edge(2, 0, 1, of)));
    QVERIFY(read_);
    const RouteEdge& of2 = read_->edges.front();
    QCOMPARE(of2.metadata.text("class"), std::optional<std::string>("hall"));
    QCOMPARE(of2.metadata.number("speed_limit"), std::optional<double>(40.0));
    QVERIFY(of2.metadata.has("wet") && !of2.metadata.number("wet") && !of2.metadata.has("dry"));
    QCOMPARE(of2.operations.size(), std::size_t{2});
    QCOMPARE(of2.operations[0].type, std::string("Open"));
    QVERIFY(of2.operations[0].trigger == RouteOperation::Trigger::OnEnter);
    QCOMPARE(of2.operations[0].metadata.text("door"), std::optional<std::string>("d1"));
    QVERIFY(of2.operations[1].trigger == RouteOperation::Trigger::OnExit);
    QVERIFY(read_->nodes[0].operations[0].trigger == RouteOperation::Trigger::Node);
  }

  void read_otherFeatures_areLeftOut() {
    const std::string polygon =
        R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": []}})";
    const auto read_ =
        read(graph(polygon + "," + node(0, 0, 0) + "," + node(1, 1, 0) + "," + edge(2, 0, 1)));
    QVERIFY(read_ && read_.diagnostics().empty());
    QCOMPARE(read_->nodes.size(), std::size_t{2});
  }

  void read_wrongFiles_tellPlaces_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("problem");
    const auto row = [](const char* name, const std::string& text, const char* problem) {
      QTest::newRow(name) << QString::fromStdString(text) << QString::fromUtf8(problem);
    };
    const std::string two = node(0, 0, 0) + "," + node(1, 1, 0);
    row("no JSON", "{\n  \"features\": [,]\n}",
        "g.geojson:2:16: error: not valid JSON, or nested too deep");
    row("no object", "[]", "g.geojson:1:1: error: 'the file' must be an object");
    row("no features", "{}", "g.geojson:1:1: error: 'features' is missing");
    row("no list", "{\"features\": 1\n}", "g.geojson:1:14: error: 'features' must be a list");
    row("empty", "{\"features\":\n []}",
        "g.geojson:2:2: error: there are no nodes (Point) or no edges (MultiLineString)");
    row("id", "{\"features\":[\n" + node(-1, 0, 0) + "]}",
        "g.geojson:2:43: error: 'id' must be an integer of 0 or greater");
    row("no such node", "{\"features\":[" + two + ",\n" + edge(5, 0, 9) + "]}",
        "g.geojson:2:68: error: endid: there is no node 9");
    row("twice", "{\"features\":[" + two + ",\n" + node(1, 2, 2) + "," + edge(5, 0, 1) + "]}",
        "g.geojson:2:35: error: id 1 is used by two nodes");
  }

  void read_wrongFiles_tellPlaces() {
    QFETCH(QString, text);
    QTEST(QString::fromStdString(problemsOf(text.toStdString())), "problem");
  }

  void read_severalErrors_areAllTold() {
    const std::string problems =
        problemsOf(graph(node(-1, 0, 0) + "," + node(1, 0, 0) + "," + edge(3, 1, 8) + "," +
                         edge(4, 9, 1, R"(, "cost": "much")")));
    QCOMPARE(std::count(problems.begin(), problems.end(), '\n'), std::ptrdiff_t{3});
  }

  void read_deepNesting_isRefused() {
    const std::string problems = problemsOf(std::string(100000, '['));
    QVERIFY(problems.find("nested too deep") != std::string::npos);
  }
};

QTEST_GUILESS_MAIN(RouteGraphTest)
#include "tst_RouteGraph.moc"
