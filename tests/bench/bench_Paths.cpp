#include <QElapsedTimer>
#include <QtTest>

#include "tests/map/MapSketch.h"

using namespace sketch;

/// The first way to a goal, for which the whole hall is searched, beside later ones to it.
class WaysBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void plan_warehouse();
  void plan_hall_manyGoals_data();
  void plan_hall_manyGoals();
};

namespace {

/// A hall of 50 x 50 m with rows of shelves.
OccupancyGrid warehouse() {
  MapSketch sketch(50.0, 50.0);
  for (int row = 0; row < 8; ++row) {
    for (int shelf = 0; shelf < 3; ++shelf) {
      const Vec2 low(3.0 + 15.5 * shelf, 4.0 + 5.5 * row);
      sketch.fill(low, low + Vec2(13.0, 1.2));
    }
  }
  for (const double edge : {0.0, 49.9}) {
    sketch.fill({edge, 0.0}, {edge + 0.1, 50.0}).fill({0.0, edge}, {50.0, edge + 0.1});
  }
  return sketch.grid();
}

double millisecondsOf(const QElapsedTimer& timer) {
  return static_cast<double>(timer.nsecsElapsed()) * 1e-6;
}

}  // namespace

void WaysBench::plan_warehouse() {
  const Scene scene = sceneOf(warehouse());
  PathPlanner planner(scene.field, 0.35);
  QElapsedTimer timer;
  timer.start();
  QVERIFY(!planner.plan({1.0, 1.0}, {48.0, 46.0}).empty());
  const double first = millisecondsOf(timer);
  timer.restart();
  constexpr int kWays = 98;
  for (int i = 0; i < kWays; ++i) {
    QVERIFY(!planner.plan({2.0, 1.0 + 0.4 * i}, {48.0, 46.0}).empty());
  }
  const double later = millisecondsOf(timer) / kWays;
  qInfo("first way %.2f ms, a later one %.3f ms, ratio %.0f", first, later, first / later);
  QTest::setBenchmarkResult(later, QTest::WalltimeMilliseconds);
}

void WaysBench::plan_hall_manyGoals_data() {
  QTest::addColumn<double>("side");  // [m]
  QTest::newRow("2000 x 2000 cells") << 100.0;
  QTest::newRow("4000 x 4000 cells, a large map") << 200.0;
}

/// A hundred people with twenty goals, beside the clearance of all cells, which is worked out
/// before.
void WaysBench::plan_hall_manyGoals() {
  QFETCH(double, side);
  const double scale = side / 200.0;
  MapSketch sketch(side, side);
  for (int row = 0; row < 19 * scale; ++row) {
    for (int shelf = 0; shelf < std::floor(7.0 * scale); ++shelf) {
      const Vec2 low(5.0 + 27.0 * shelf, 6.0 + 10.0 * row);
      sketch.fill(low, low + Vec2(20.0, 0.4));
    }
  }
  const OccupancyGrid grid = sketch.grid();
  QElapsedTimer timer;
  timer.start();
  const Scene scene = sceneOf(grid);
  const double before = millisecondsOf(timer);
  timer.restart();
  PathPlanner planner(scene.field, 0.35);
  for (int i = 0; i < 100; ++i) {
    const Vec2 start(2.0, 1.0 + 1.97 * scale * i);
    const Vec2 goal(side - 2.0 - 9.0 * scale * (i % 20), 1.0 + 9.9 * scale * (i * 7 % 20));
    QVERIFY(!planner.plan(start, goal).empty());
  }
  const double ways = millisecondsOf(timer);
  qInfo("clearance %.0f ms, %d searches for 100 ways %.0f ms, ratio %.2f", before,
        planner.searches(), ways, ways / before);
  QTest::setBenchmarkResult(ways, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(WaysBench)
#include "bench_Paths.moc"
