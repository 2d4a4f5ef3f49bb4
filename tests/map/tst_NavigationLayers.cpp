#include <QtTest>

#include "sim2d/map/NavigationMap.h"
#include "tests/map/MapSketch.h"

using namespace sketch;

/// What is kept of the ways on a map, and how much of it.
class NavigationLayersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// 200 kB each; the one asked for most often is not the one that goes.
  void plannerFor_manyRadii_staysWithinTheBytes() {
    constexpr std::size_t kMost = 1000000;
    const OccupancyGrid grid = randomMap(1);
    const Scene scene = sceneOf(grid);
    const NavigationLayer layer(grid, scene.obstacles, {}, std::make_shared<const base::StopFlag>(),
                                nullptr, kMost);
    const auto first = layer.plannerFor(0.2);
    for (int i = 0; i < 30; ++i) {
      (void)layer.plannerFor(0.2)->isReachable({0.3, 0.3}, {9.7, 9.7});
      (void)layer.plannerFor(0.3 + 0.001 * i)->isReachable({0.3, 0.3}, {9.7, 9.7});
    }
    QCOMPARE(layer.plannerFor(0.2), first);
    const std::size_t bytes = layer.bytes() - layer.field()->bytes();
    QVERIFY2(bytes > kMost / 2 && bytes < kMost + kMost / 2, qPrintable(QString::number(bytes)));
  }

  void of_doorOnALargeMap_keepsBothLayers() {
    MapSketch sketch(75.0, 75.0);
    const OccupancyGrid grid = sketch.fill({30.0, 0.0}, {30.2, 70.0}).grid();
    Obstacles obstacles =
        sceneOf(grid, {wallOutlines({{30.1, 70.0}, {30.1, 75.0}}, 0.1)}).obstacles;
    NavigationLayerCache layers;
    const auto closed = layers.of(grid, obstacles, {});
    obstacles.setEnabled(1, false);
    const auto open = layers.of(grid, obstacles, {});
    QVERIFY(open != closed);
    QVERIFY(!closed->plannerFor(0.35)->isReachable({20.0, 5.0}, {40.0, 5.0}));
    QVERIFY(open->plannerFor(0.35)->isReachable({20.0, 5.0}, {40.0, 5.0}));
    obstacles.setEnabled(1, true);
    QCOMPARE(layers.of(grid, obstacles, {}), closed);
  }

  void of_tooManyBytes_keepsTheLastLayer() {
    const OccupancyGrid grid = randomMap(2);
    Obstacles obstacles = sceneOf(grid, {{circleOutline({4.0, 6.0}, 0.7)}}).obstacles;
    NavigationLayerCache layers(std::make_shared<const base::StopFlag>(), 1);
    const auto with = layers.of(grid, obstacles, {});
    obstacles.setEnabled(1, false);
    const auto without = layers.of(grid, obstacles, {});
    QCOMPARE(layers.of(grid, obstacles, {}), without);
    obstacles.setEnabled(1, true);
    QVERIFY(layers.of(grid, obstacles, {}) != with);
  }

  /// What counts is how far has been searched, not how large the map is.
  void plan_goalsInTurn_searchesOncePerGoal() {
    MapSketch sketch(100.0, 100.0);
    for (int i = 0; i < 20; ++i) {
      sketch.fill({4.0 + 4.0 * i, 50.0}, {6.0 + 4.0 * i, 50.2});
    }
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    for (int i = 0; i < 60; ++i) {
      const double x = 5.0 + 4.0 * (i % 20);
      QVERIFY(planner.plan({x, 49.0}, {x, 51.2}).size() > 2);
    }
    QCOMPARE(planner.searches(), 20);
  }
};

QTEST_APPLESS_MAIN(NavigationLayersTest)
#include "tst_NavigationLayers.moc"
