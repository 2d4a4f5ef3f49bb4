#include <algorithm>
#include <limits>

#include <QtTest>

#include "metrics/Samples.h"
#include "sim2d/map/TautWay.h"
#include "tests/map/MapSketch.h"

using namespace sketch;

namespace {

constexpr double kRadius = 0.35;  // [m]

/// More cells than an ordinary map has, with pillars out of line.
OccupancyGrid hall() {
  MapSketch sketch(105.0, 105.0);
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) {
      const Vec2 low(3.0 + 5.0 * column + 0.7 * (row % 4), 3.0 + 5.0 * row + 0.3 * (column % 3));
      sketch.fill(low, low + Vec2(2.0, 2.0));
    }
  }
  return sketch.grid();
}

}  // namespace

/// The ways that metrics measure against.
class ShortestWaysTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void shortestPath_largeMap_isThatOfCells();
};

void ShortestWaysTest::shortestPath_largeMap_isThatOfCells() {
  TraceHeader header;
  header.map = hall();
  header.obstacles.push_back({"map", false, false, {}, traceOutlines(header.map)});
  header.robots.push_back({});
  const metrics::RunContext context = metrics::SampleBuilder(header).context();
  const Scene scene = sceneOf(header.map, {}, {}, std::numeric_limits<double>::infinity());
  PathPlanner planner(scene.field, kRadius);
  const Vec2 from(1.5, 1.5);
  for (const Vec2& to : {Vec2(103.0, 42.0), Vec2(44.0, 103.0), Vec2(103.5, 22.0)}) {
    std::vector<Vec2> cells = planner.plan(to, from);
    std::reverse(cells.begin(), cells.end());
    const std::vector<Vec2> best = tautened(cells, scene.obstacles, kRadius);
    QVERIFY(best.size() > 2);
    QCOMPARE(lengthOfWay(metrics::shortestPath(context, from, to)), lengthOfWay(best));
  }
}

QTEST_APPLESS_MAIN(ShortestWaysTest)
#include "tst_ShortestWays.moc"
