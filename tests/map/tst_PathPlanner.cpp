#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "tests/map/MapSketch.h"
#include "tests/support/Columns.h"

using namespace sketch;

class PathPlannerTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void plan_free_isStraight() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({1.02, 1.03}, {8.5, 7.0});
    QCOMPARE(path.size(), std::size_t{2});
    QVERIFY(path[0] == Vec2(1.02, 1.03));
    QVERIFY(path[1] == Vec2(8.5, 7.0));
    QCOMPARE(polylineLength(path), (Vec2(8.5, 7.0) - Vec2(1.02, 1.03)).norm());
    QCOMPARE(polylineLength({}), 0.0);
  }

  void plan_uWall_goesRound_data() {
    QTest::addColumn<bool>("drawn");
    QTest::newRow("map") << false;
    QTest::newRow("drawn on the open plane") << true;
  }

  void plan_uWall_goesRound() {
    QFETCH(const bool, drawn);
    // Open to the left; the way leads back out of it and round one arm.
    const std::vector<Outline> uWall = wallOutlines({{3, 3}, {7, 3}, {7, 7}, {3, 7}}, 0.2);
    MapSketch sketch(12.0, 10.0);
    sketch.fill({3, 2.9}, {7.1, 3.1}).fill({6.9, 2.9}, {7.1, 7.1}).fill({3, 6.9}, {7.1, 7.1});
    const Scene scene = drawn ? sceneOf(OccupancyGrid(), {uWall}, {{6.0, 4.9}, {9.0, 4.9}})
                              : sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({6.0, 4.9}, {9.0, 4.9});
    QVERIFY(path.size() >= 4);
    QVERIFY(lowestClearance(scene, path) > 0.34);
    // Shortest round the ends of an arm at the radius: about 3.5 + 2.3 + 4.6 + 2.4.
    QVERIFY2(polylineLength(path) > 11.0 && polylineLength(path) < 14.0,
             QByteArray::number(polylineLength(path)));
    QVERIFY(path.front() == Vec2(6.0, 4.9) && path.back() == Vec2(9.0, 4.9));
  }

  void plan_corner_keepsClearance() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).fill({0, 0}, {5, 5}).grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({1.0, 6.0}, {6.0, 1.0});
    QVERIFY2(lowestClearance(scene, path) > 0.5, QByteArray::number(lowestClearance(scene, path)));
    QVERIFY2(polylineLength(path) < 9.2,
             QByteArray::number(polylineLength(path)));  // 8.25 to the corner itself
    QVERIFY(path.size() <= 8);
  }

  void plan_closedRoom_isUnreachable() {
    MapSketch sketch(10.0, 10.0);
    sketch.fill({3, 3}, {7, 7}).fill({3.1, 3.1}, {6.9, 6.9}, 0);
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    QVERIFY(planner.plan({1, 1}, {5, 5}).empty());
    QVERIFY(planner.plan({5, 5}, {1, 1}).empty());
    QVERIFY(!planner.isReachable({1, 1}, {5, 5}));
    QVERIFY(planner.isReachable({4, 4}, {6, 6}));
  }

  void plan_narrowDoor_isPassable_data() {
    addColumns<double, bool>({"resolution", "drawn"});
    QTest::newRow("map 0.05") << 0.05 << false;
    QTest::newRow("map 0.1") << 0.1 << false;
    QTest::newRow("drawn 0.05") << 0.05 << true;
    QTest::newRow("drawn 0.1") << 0.1 << true;
  }

  void plan_narrowDoor_isPassable() {
    QFETCH(const double, resolution);
    QFETCH(const bool, drawn);
    MapSketch sketch(10.0, 10.0, resolution);
    if (!drawn) {
      sketch.fill({5.0, 0.0}, {5.2, 4.5}).fill({5.0, 5.3}, {5.2, 10.0});
    }
    const std::vector<std::vector<Outline>> walls{wallOutlines({{5.1, -1.0}, {5.1, 4.53}}, 0.2),
                                                  wallOutlines({{5.1, 5.33}, {5.1, 11.0}}, 0.2)};
    const Scene scene = sceneOf(sketch.grid(), drawn ? walls : std::vector<std::vector<Outline>>{});
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({2.0, 2.0}, {8.0, 3.0});
    QVERIFY(!path.empty());
    QVERIFY2(lowestClearance(scene, path) > 0.34, QByteArray::number(lowestClearance(scene, path)));
    QVERIFY2(polylineLength(path) < 8.2, QByteArray::number(polylineLength(path)));
  }

  void plan_tooNarrowDoor_isUnreachable() {
    MapSketch sketch(10.0, 10.0);
    sketch.fill({5.0, 0.0}, {5.2, 4.5}).fill({5.0, 5.1}, {5.2, 10.0});
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    QVERIFY(planner.plan({2.0, 2.0}, {8.0, 3.0}).empty());
    PathPlanner small(scene.field, 0.25);
    QVERIFY(!small.plan({2.0, 2.0}, {8.0, 3.0}).empty());
  }

  void plan_closedDoor_takesOtherWay() {
    MapSketch sketch(10.0, 10.0);
    sketch.fill({5.0, 0.0}, {5.2, 2.0}).fill({5.0, 3.0}, {5.2, 8.5});
    Scene scene = sceneOf(sketch.grid(), {wallOutlines({{5.1, 1.9}, {5.1, 3.1}}, 0.05)});
    PathPlanner closed(scene.field, 0.35);
    const std::vector<Vec2> round = closed.plan({2.0, 2.5}, {8.0, 2.5});
    QVERIFY(polylineLength(round) > 12.0);
    QVERIFY(lowestClearance(scene, round) > 0.34);
    scene.obstacles.setEnabled(1, false);
    PathPlanner open(std::make_shared<const DistanceField>(sketch.grid(), scene.obstacles), 0.35);
    QVERIFY(polylineLength(open.plan({2.0, 2.5}, {8.0, 2.5})) < 6.1);
  }

  void plan_wideGap_prefersClearance() {
    MapSketch sketch(10.0, 6.0);
    sketch.fill({5.0, 0.0}, {5.2, 2.0}).fill({5.0, 4.0}, {5.2, 6.0});
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({2.0, 1.0}, {8.0, 1.0});
    QVERIFY2(lowestClearance(scene, path) > 0.5, QByteArray::number(lowestClearance(scene, path)));
  }

  void plan_unknown_isAvoided() {
    MapSketch sketch(20.0, 10.0);
    sketch.fill({4.0, 2.0}, {16.0, 10.0}, -1);
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({2.0, 8.0}, {18.0, 8.0});
    QVERIFY(path.size() > 2);
    for (std::size_t i = 1; i < path.size(); ++i) {
      for (int part = 0; part <= 100; ++part) {
        const Vec2 point = path[i - 1] + 0.01 * part * (path[i] - path[i - 1]);
        QVERIFY(point.y() < 2.03 || point.x() < 4.03 || point.x() > 15.97);
      }
    }
    QVERIFY(planner.isClear({2.0, 8.0}, {18.0, 8.0}));  // unknown is no wall
  }

  void plan_unknown_isCrossedWhenNeeded() {
    MapSketch sketch(20.0, 10.0);
    sketch.fill({4.0, 0.0}, {16.0, 10.0}, -1);
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({2.0, 8.0}, {18.0, 2.0});
    QVERIFY(!path.empty());
    QVERIFY(polylineLength(path) < 21.0);
    QVERIFY(planner.isReachable({18.0, 2.0}, {2.0, 8.0}));
  }

  void plan_pointsInUnknown_works() {
    MapSketch sketch(20.0, 10.0);
    sketch.fill({4.0, 0.0}, {20.0, 10.0}, -1).fill({8.0, 2.0}, {8.2, 10.0});
    const Scene scene = sceneOf(sketch.grid());
    PathPlanner planner(scene.field, 0.35);
    for (const auto& [from, to] : {std::pair<Vec2, Vec2>({2.0, 8.0}, {10.0, 8.0}),
                                   std::pair<Vec2, Vec2>({10.0, 8.0}, {2.0, 8.0}),
                                   std::pair<Vec2, Vec2>({7.0, 8.0}, {10.0, 8.0})}) {
      const std::vector<Vec2> path = planner.plan(from, to);
      QVERIFY(path.size() > 2);
      QVERIFY(lowestClearance(scene, path) > 0.34);
    }
  }

  void plan_oneCellWall_isNotCrossed_data() {
    QTest::addColumn<double>("radius");
    QTest::newRow("0") << 0.0;
    QTest::newRow("0.01") << 0.01;
    QTest::newRow("0.2") << 0.2;
  }

  void plan_oneCellWall_isNotCrossed() {
    QFETCH(const double, radius);
    MapSketch straight(6.0, 6.0);
    straight.fill({3.0, 0.0}, {3.05, 6.0});
    MapSketch slanted(6.0, 6.0);
    for (int i = 0; i < 120; ++i) {
      const double x = 0.05 * i;
      slanted.fill({x, 5.95 - x}, {x + 0.05, 6.0 - x});
    }
    for (const MapSketch& sketch : {straight, slanted}) {
      const Scene scene = sceneOf(sketch.grid());
      PathPlanner planner(scene.field, radius);
      QVERIFY(planner.plan({1.0, 1.0}, {5.0, 5.0}).empty());
      QVERIFY(!planner.isClear({1.0, 1.0}, {5.0, 5.0}));
      QVERIFY(!planner.isReachable({5.0, 4.5}, {1.0, 1.5}));
    }
  }

  void plan_startInWall_isMoved() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).fill({4.0, 0.0}, {4.2, 10.0}).grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> near = planner.plan({4.3, 5.0}, {8.0, 5.0});  // too near to the wall
    QVERIFY(near.size() >= 3);
    QVERIFY(near[0] == Vec2(4.3, 5.0));
    QVERIFY(std::fabs(near[1].x() - 4.575) < 0.03);
    const std::vector<Vec2> inside = planner.plan({4.15, 5.0}, {8.0, 5.0});
    QVERIFY(!inside.empty());
    QVERIFY(inside.back() == Vec2(8.0, 5.0));
  }

  void plan_goalTooNearWall_endsWhereItFits() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).fill({4.0, 0.0}, {5.0, 10.0}).grid());
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({8.0, 5.0}, {5.1, 6.0});
    QVERIFY(!path.empty());
    QVERIFY((path.back() - Vec2(5.375, 6.0)).norm() < 0.06);
    QVERIFY(planner.plan({8.0, 5.0}, {4.6, 6.0}).size() >= 2);  // 0.4 m inside the wall
    const Scene solid = sceneOf(MapSketch(10.0, 10.0).fill({0.0, 0.0}, {6.0, 10.0}).grid());
    PathPlanner none(solid.field, 0.35);
    QVERIFY(none.plan({8.0, 5.0}, {2.0, 6.0}).empty());
  }

  void plan_outsideMap_isEmpty() {
    const Scene scene = sceneOf(MapSketch(10.0, 10.0).grid());
    PathPlanner planner(scene.field, 0.35);
    QVERIFY(planner.plan({5.0, 5.0}, {12.0, 5.0}).empty());
    QVERIFY(planner.plan({-3.0, 5.0}, {5.0, 5.0}).empty());
    QVERIFY(!planner.isClear({5.0, 5.0}, {12.0, 5.0}));
    QVERIFY(!planner.plan({5.0, 5.0}, {10.5, 5.0}).empty());  // moved in by half a metre
  }

  void plan_openPlane_outsideGrid_works() {
    const Scene scene = sceneOf(OccupancyGrid(), {{boxOutline({}, 4.0, 4.0)}});
    PathPlanner planner(scene.field, 0.35);
    const std::vector<Vec2> path = planner.plan({-30.0, 0.0}, {40.0, 1.0});
    QVERIFY(path.size() >= 3);
    QVERIFY(path.front() == Vec2(-30.0, 0.0) && path.back() == Vec2(40.0, 1.0));
    QVERIFY(lowestClearance(scene, path) > 0.34);
    QVERIFY(polylineLength(path) < 72.0);
    QCOMPARE(planner.plan({-30.0, 20.0}, {40.0, 30.0}).size(), std::size_t{2});
  }

  void plan_samePoints_isTwoPoints() {
    MapSketch sketch(4.0, 4.0);
    sketch.fill({0.0, 0.0}, {4.0, 1.5}).fill({0.0, 2.5}, {4.0, 4.0});  // a tight corridor
    for (const OccupancyGrid& grid : {MapSketch(4.0, 4.0).grid(), sketch.grid()}) {
      const Scene scene = sceneOf(grid);
      PathPlanner planner(scene.field, 0.35);
      const std::vector<Vec2> path = planner.plan({2.01, 2.01}, {2.01, 2.01});
      QCOMPARE(path.size(), std::size_t{2});
      QCOMPARE(polylineLength(path), 0.0);
    }
  }

  void plan_notFinite_isEmpty() {
    const Scene scene = sceneOf(OccupancyGrid());
    PathPlanner planner(scene.field, 0.35);
    QVERIFY(planner.plan({std::nan(""), 0.0}, {1.0, 1.0}).empty());
    QVERIFY(planner.plan({0.0, 0.0}, {1.0, INFINITY}).empty());
  }
};

QTEST_APPLESS_MAIN(PathPlannerTest)
#include "tst_PathPlanner.moc"
