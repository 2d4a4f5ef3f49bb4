#include <algorithm>
#include <random>

#include <QtTest>

#include "tests/map/MapSketch.h"

using namespace sketch;

/// What holds for ways on any map, and which places a body fits in.
class WaysOnMapsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void plan_randomMaps_neverCrossWalls() {
    int found = 0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
      const Scene scene = sceneOf(randomMap(seed));
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> place(0.0, 10.0);
      for (const double radius : {0.1, 0.2, 0.35}) {
        PathPlanner planner(scene.field, radius);
        for (int i = 0; i < 8; ++i) {
          const Vec2 from(place(random), place(random));
          const Vec2 to(place(random), place(random));
          const std::vector<Vec2> path = planner.plan(from, to);
          const bool startFits = planner.space().nearestFreePosition(from) == from;
          if (path.empty() || !startFits) {
            continue;
          }
          ++found;
          const double lowest = lowestClearance(scene, path);
          QVERIFY2(lowest > radius - 0.01 - 0.025,  // outlines may be half a cell off their cells
                   qPrintable(
                       QStringLiteral("seed %1 radius %2: %3").arg(seed).arg(radius).arg(lowest)));
        }
      }
    }
    QVERIFY(found > 500);
  }

  void plan_otherCallsBefore_isTheSame() {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const Scene scene = sceneOf(randomMap(seed));
      PathPlanner busy(scene.field, 0.2);
      std::mt19937 random(seed + 100);
      std::uniform_real_distribution<double> place(0.0, 10.0);
      for (int i = 0; i < 20; ++i) {
        const Vec2 from(place(random), place(random));
        const Vec2 to(i % 2 == 0 ? Vec2(5.0, 5.0) : Vec2(place(random), place(random)));
        PathPlanner fresh(scene.field, 0.2);
        QVERIFY(busy.plan(from, to) == fresh.plan(from, to));
      }
    }
  }

  void plan_manyGoals_staysBounded() {
    MapSketch sketch(10.0, 10.0);
    sketch.fill({5.0, 0.0}, {5.2, 9.0});
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    double first = 0.0;
    for (int i = 0; i < 200; ++i) {
      const std::vector<Vec2> path = planner.plan({2.0, 1.0}, {8.0, 1.0 + 0.03 * i});
      QVERIFY(!path.empty());
      first = i == 0 ? polylineLength(path) : first;
    }
    QCOMPARE(polylineLength(planner.plan({2.0, 1.0}, {8.0, 1.0})), first);  // searched anew
  }

  void isReachable_randomMaps_agreesWithPlan() {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const Scene scene = sceneOf(randomMap(seed));
      PathPlanner planner(scene.field, 0.3);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> place(0.0, 10.0);
      for (int i = 0; i < 20; ++i) {
        const Vec2 from(place(random), place(random));
        const Vec2 to(place(random), place(random));
        QCOMPARE(planner.isReachable(from, to), !planner.plan(from, to).empty());
        QCOMPARE(planner.isReachable(from, to), planner.isReachable(to, from));
      }
    }
  }

  void nearestFit_cases() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).fill({4.0, 0.0}, {4.1, 10.0}).grid());
    const PathPlanner planner(scene.field, 0.35);
    QVERIFY(planner.space().nearestFreePosition({2.0, 2.0}) == Vec2(2.0, 2.0));
    const auto left = planner.space().nearestFreePosition({3.95, 5.0});
    QVERIFY(left && left->x() < 3.66 && left->x() > 3.6);
    const auto right = planner.space().nearestFreePosition({4.13, 5.0});
    QVERIFY(right && right->x() > 4.44 && right->x() < 4.5);
    const Scene solid = sceneOf(MapSketch(5.0, 5.0).fill({0.0, 0.0}, {5.0, 5.0}).grid());
    QVERIFY(!PathPlanner(solid.field, 0.35).space().nearestFreePosition({2.0, 2.0}));
    QVERIFY(!planner.space().nearestFreePosition({20.0, 2.0}));
  }

  void isClear_cases() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).fill({4.0, 4.0}, {6.0, 6.0}).grid());
    const PathPlanner planner(scene.field, 0.35);
    QVERIFY(planner.isClear({1.0, 5.0}, {3.6, 5.0}));
    QVERIFY(!planner.isClear({1.0, 5.0}, {3.7, 5.0}));
    QVERIFY(!planner.isClear({1.0, 5.0}, {9.0, 5.0}));
    QVERIFY(planner.isClear({1.0, 3.6}, {9.0, 3.6}));
    QVERIFY(!planner.isClear({1.0, 3.7}, {9.0, 3.7}));
    QCOMPARE(planner.space().radius(), 0.35);
  }
};

QTEST_APPLESS_MAIN(WaysOnMapsTest)
#include "tst_PathsOnMaps.moc"
