#include <algorithm>
#include <random>

#include <QtTest>

#include "tests/map/MapSketch.h"

using namespace sketch;

namespace {

constexpr double kAlways = 0.0;  // cells from which on a map is large

/// A hall with rows of shelves, 105 m x 105 m: a little more than the cells of an ordinary map.
OccupancyGrid hall() {
  MapSketch sketch(105.0, 105.0);
  for (int row = 0; row < 10; ++row) {
    for (int shelf = 0; shelf < 5; ++shelf) {
      const Vec2 low(4.0 + 20.0 * shelf, 5.0 + 10.0 * row);
      sketch.fill(low, low + Vec2(17.0, 1.0));
    }
  }
  return sketch.grid();
}

/// Two maps of one ground, the second treated as large.
struct Pair {
  explicit Pair(const OccupancyGrid& grid)
      : ordinary(sceneOf(grid)), large(sceneOf(grid, {}, {}, kAlways)) {}
  Scene ordinary, large;
};

}  // namespace

/// Maps of which not every cell is searched: what they must have in common with ordinary ones.
class LargeMapsTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void isLarge_dependsOnTheCells() {
    QVERIFY(!sceneOf(MapSketch(100.0, 100.0).grid()).field->isLarge());
    QVERIFY(sceneOf(MapSketch(100.0, 100.05).grid()).field->isLarge());
  }

  void distanceAt_isAtMostTwoStepsLess() {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const OccupancyGrid grid = randomMap(seed);
      const std::vector<std::vector<Outline>> drawn = {{circleOutline({4.0, 6.0}, 0.7)}};
      const Scene ordinary = sceneOf(grid, drawn);
      const Scene large = sceneOf(grid, drawn, {}, kAlways);
      for (int row = 0; row < grid.height(); ++row) {
        for (int column = 0; column < grid.width(); ++column) {
          const double exact = ordinary.field->distanceAt(Cell{column, row});
          const double less = exact - large.field->distanceAt(Cell{column, row});
          // Of ordinary maps the outlines count as well, which are off the cells by half of one.
          QVERIFY2(less > -0.5 * grid.resolution() - 1e-6 &&
                       less <= 2.0 * grid.resolution() / 256.0 + 1e-6,
                   qPrintable(QStringLiteral("%1 %2: %3").arg(column).arg(row).arg(less)));
        }
      }
    }
    const Pair pair(randomMap(6));  // without what is drawn the outlines of the map do not count
    for (int row = 0; row < 200; ++row) {
      for (int column = 0; column < 200; ++column) {
        const double exact = pair.ordinary.field->distanceAt(Cell{column, row});
        const double large = pair.large.field->distanceAt(Cell{column, row});
        QVERIFY(std::fabs(exact - large) < 0.5 * 0.05 + 1e-6);
      }
    }
    const Scene empty = sceneOf(MapSketch(5.0, 5.0).grid(), {}, {}, kAlways);
    QVERIFY(std::isinf(empty.field->distanceAt(Vec2(2.0, 2.0))));
  }

  /// Beside a door that closes the outlines of the map count, which are off its cells; elsewhere
  /// not.
  void distanceAt_doorFarAway_isTheSame() {
    const Segment door{{4.0, 6.0}, {4.0, 7.0}};
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const OccupancyGrid grid = randomMap(seed);
      Scene scene = sceneOf(grid, {wallOutlines({door.a, door.b}, 0.1)}, {}, kAlways);
      scene.obstacles.setEnabled(1, false);
      const DistanceField open(grid, scene.obstacles, {}, kAlways);
      for (int row = 0; row < grid.height(); ++row) {
        for (int column = 0; column < grid.width(); ++column) {
          const Cell cell{column, row};
          const double toDoor = distanceToSegment(door, grid.cellToWorld(cell));
          if (open.distanceAt(cell) + 0.2 < toDoor) {
            QCOMPARE(scene.field->distanceAt(cell), open.distanceAt(cell));
          }
        }
      }
    }
  }

  void distanceAt_obstacleBesideAWall_counts() {
    MapSketch sketch(10.0, 10.0);
    sketch.fill({5.0, 2.0}, {5.1, 8.0});
    const Scene scene =
        sceneOf(sketch.grid(), {{boxOutline({{5.125, 5.0}, 0.0}, 0.05, 1.0)}}, {}, kAlways);
    QCOMPARE(scene.field->distanceAt(Cell{102, 100}), 0.0);
    QVERIFY(scene.field->distanceAt(Cell{102, 60}) > 0.0);
  }

  void distanceAt_obstacleOnAMapWithoutWalls_isFarAway() {
    const Scene scene =
        sceneOf(MapSketch(20.0, 2.0).grid(), {{circleOutline({1.0, 1.0}, 0.5)}}, {}, kAlways);
    QVERIFY(std::fabs(scene.field->distanceAt(Vec2(5.0, 1.0)) - 3.5) < 0.05);
    QVERIFY(std::fabs(scene.field->distanceAt(Vec2(18.0, 1.0)) - 255.0 * 0.05) < 0.06);
  }

  void unknownDistance_isNeverMore() {
    const Pair pair(randomMap(3));
    const OccupancyGrid& grid = pair.large.field->grid();
    bool isFarAnywhere = false;
    for (int row = 0; row < grid.height(); ++row) {
      for (int column = 0; column < grid.width(); ++column) {
        const Cell cell{column, row};
        const double exact = pair.ordinary.field->unknownDistance(cell);
        const double bound = pair.large.field->unknownDistance(cell);
        QVERIFY(bound <= std::max(exact, 1.0));
        QCOMPARE(bound > 0.0, exact > 0.0);
        isFarAnywhere = isFarAnywhere || bound > 16.0;
      }
    }
    QVERIFY(isFarAnywhere);
  }

  void isReachable_randomMaps_agrees() {
    int apart = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
      const Pair pair(randomMap(seed));
      for (const double radius : {0.2, 0.6}) {
        PathPlanner ordinary(pair.ordinary.field, radius);
        PathPlanner large(pair.large.field, radius);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(0.0, 10.0);
        for (int i = 0; i < 20; ++i) {
          const Vec2 from(place(random), place(random));
          const Vec2 to(place(random), place(random));
          QCOMPARE(large.isReachable(from, to), ordinary.isReachable(from, to));
          QCOMPARE(large.plan(from, to).empty(), ordinary.plan(from, to).empty());
          apart += ordinary.isReachable(from, to) ? 0 : 1;
        }
      }
    }
    QVERIFY2(apart > 30, qPrintable(QString::number(apart)));
  }

  void plan_randomMaps_keepsClearanceAndIsShort() {
    double longest = 0.0, ofLarge = 0.0, ofOrdinary = 0.0;
    for (unsigned seed = 1; seed <= 60; ++seed) {
      const Pair pair(randomMap(seed));
      for (const double radius : {0.1, 0.2, 0.35}) {
        PathPlanner ordinary(pair.ordinary.field, radius);
        PathPlanner large(pair.large.field, radius);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> place(0.0, 10.0);
        for (int i = 0; i < 8; ++i) {
          const Vec2 from(place(random), place(random));
          const std::vector<Vec2> way = large.plan(from, {place(random), place(random)});
          if (way.empty() || large.space().nearestFreePosition(from) != from) {
            continue;
          }
          const double lowest = lowestClearance(pair.large, way);
          QVERIFY2(lowest > radius - 0.01 - 0.025, qPrintable(QString::number(lowest)));
          // Unknown ground counts 16 times, and so does the error of a block.
          if (large.space().isUnknown(from) || large.space().isUnknown(way.back())) {
            continue;
          }
          const double best = polylineLength(ordinary.plan(from, way.back()));
          longest = std::max(longest, polylineLength(way) - best);
          ofLarge += polylineLength(way);
          ofOrdinary += best;
        }
      }
    }
    qInfo("%.2f m longer at most, %.4f times as long on the whole", longest, ofLarge / ofOrdinary);
    QVERIFY(longest < 1.2);  // two blocks
    QVERIFY(ofLarge < 1.02 * ofOrdinary);
  }

  /// In every direction, also between those in which blocks lie beside each other.
  void plan_amongPillars_isAtMostEightPercentLonger() {
    MapSketch sketch(40.0, 40.0);
    for (int row = 0; row < 12; ++row) {
      for (int column = 0; column < 12; ++column) {
        const Vec2 low(2.0 + 3.2 * column + 0.4 * (row % 3), 2.0 + 3.2 * row);
        sketch.fill(low, low + Vec2(1.0, 1.0));
      }
    }
    const Pair pair(sketch.grid());
    PathPlanner ordinary(pair.ordinary.field, 0.35);
    PathPlanner large(pair.large.field, 0.35);
    double worst = 0.0;
    for (int degrees = 0; degrees < 90; degrees += 15) {
      const double angle = (degrees + 7.5) * 3.14159265 / 180.0;
      const Vec2 goal = Vec2(1.0, 1.0) + 37.5 * Vec2(std::cos(angle), std::sin(angle));
      const double best = polylineLength(ordinary.plan({1.0, 1.0}, goal));
      QVERIFY(best > 36.0);
      worst = std::max(worst, (polylineLength(large.plan({1.0, 1.0}, goal)) - 1.2) / best);
    }
    qInfo("%.4f times as long at most, but for two blocks", worst);
    QVERIFY(worst > 0.9 && worst <= 1.083);
  }

  void plan_narrowDoorBetweenBlocks_isFound_data() {
    QTest::addColumn<double>("bottom");
    for (int i = 0; i < 9; ++i) {  // [m], over the side of a block
      QTest::addRow("%d", i) << 4.0 + 0.05 * i;
    }
  }

  /// Wherever a door just wide enough lies, also across the border of two blocks.
  void plan_narrowDoorBetweenBlocks_isFound() {
    QFETCH(double, bottom);
    MapSketch sketch(10.0, 10.0);
    sketch.fill({bottom, 0.0}, {bottom + 0.1, bottom});
    sketch.fill({bottom, bottom + 0.8}, {bottom + 0.1, 10.0});
    const Pair pair(sketch.grid());
    PathPlanner large(pair.large.field, 0.35);
    const std::vector<Vec2> way = large.plan({2.0, 1.0}, {8.0, 9.0});
    QVERIFY(!way.empty());
    QVERIFY(lowestClearance(pair.large, way) > 0.33);
    PathPlanner wide(pair.large.field, 0.42);
    QVERIFY(wide.plan({2.0, 1.0}, {8.0, 9.0}).empty());
  }

  void plan_otherCallsBefore_isTheSame() {
    for (unsigned seed = 1; seed <= 10; ++seed) {
      const Scene scene = sceneOf(randomMap(seed), {}, {}, kAlways);
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

  void plan_manyToFewGoals_searchesOncePerGoal() {
    const Scene scene = sceneOf(hall());
    QVERIFY(scene.field->isLarge());
    PathPlanner planner(scene.field, 0.35);
    QCOMPARE(planner.searches(), 0);
    for (int i = 0; i < 100; ++i) {
      const Vec2 goal(2.0, 2.0 + 5.0 * (i * 7 % 20));
      QVERIFY(!planner.plan({102.0, 1.0 + i}, goal).empty());
    }
    QVERIFY2(planner.searches() <= 20, qPrintable(QString::number(planner.searches())));
    QVERIFY(planner.searches() > 10);
  }

  /// The map itself takes one byte more.
  void bytes_largeMap_areFewPerCell() {
    const Scene scene = sceneOf(hall());
    PathPlanner planner(scene.field, 0.35);
    QVERIFY(!planner.plan({102.0, 1.0}, {2.0, 97.0}).empty());
    const double cells = 105.0 * 105.0 * 400.0;
    const double bytes = static_cast<double>(scene.field->bytes() + planner.bytes());
    QVERIFY2(bytes > 2.0 * cells && bytes < 3.0 * cells,
             qPrintable(QString::number(bytes / cells)));
  }
};

QTEST_APPLESS_MAIN(LargeMapsTest)
#include "tst_LargeMaps.moc"
