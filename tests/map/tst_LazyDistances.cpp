#include <cmath>
#include <limits>
#include <random>

#include <QtTest>

#include "sim2d/map/CellDistances.h"
#include "tests/map/MapSketch.h"
#include "tests/support/Columns.h"

using namespace sketch;

namespace {

constexpr double kNever = 0.0;  // cells of a map whose distances are kept

std::vector<char> randomMarks(int width, int height, double share, std::mt19937& random) {
  std::vector<char> marks(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  std::bernoulli_distribution isMarked(share);
  std::generate(marks.begin(), marks.end(), [&] { return isMarked(random) ? char{1} : char{0}; });
  return marks;
}

/// From the middle of a cell to the square of another one [cells].
double toSquare(Cell from, Cell to) {
  const double x = std::max(0.0, std::abs(from.column - to.column) - 0.5);
  const double y = std::max(0.0, std::abs(from.row - to.row) - 0.5);
  return std::hypot(x, y);
}

/// A random map with shapes on it, one of which ends at its edge; the last is a door.
Scene sceneWithShapes(unsigned seed) {
  Scene scene = sceneOf(randomMap(seed), {{circleOutline({4.0, 6.0}, 0.7)},
                                          {boxOutline({{10.1, 3.0}, 0.4}, 0.6, 0.3)},
                                          wallOutlines({{2.0, 2.0}, {2.0, 4.0}}, 0.1)});
  scene.obstacles.setEnabled(3, seed % 2 == 0);
  return scene;
}

struct Pair {
  explicit Pair(const OccupancyGrid& grid, const Obstacles& obstacles)
      : kept(DistanceField::withExactDistances(grid, obstacles, {})),
        asked(DistanceField::withExactDistances(grid, obstacles, {}, kNever)) {}
  std::shared_ptr<const DistanceField> kept, asked;
};

template <class Check>
void forEachCell(const OccupancyGrid& grid, Check check) {
  for (int row = 0; row < grid.height(); ++row) {
    for (int column = 0; column < grid.width(); ++column) {
      check(Cell{column, row});
    }
  }
}

}  // namespace

/// Distances that are worked out when they are asked for are those that are kept.
class AskedDistancesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void distance_randomMarks_isThatByBruteForce_data() {
    addColumns<int, int, double>({"width", "height", "share"});
    QTest::newRow("one cell, marked") << 1 << 1 << 1.0;
    QTest::newRow("one cell") << 1 << 1 << 0.0;
    QTest::newRow("one block") << 8 << 8 << 0.03;
    QTest::newRow("a row") << 600 << 1 << 0.01;
    QTest::newRow("a column") << 1 << 600 << 0.01;
    QTest::newRow("few") << 100 << 75 << 0.001;
    QTest::newRow("many") << 70 << 90 << 0.3;
  }

  void distance_randomMarks_isThatByBruteForce() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(double, share);
    std::mt19937 random(7);
    const std::vector<char> marks = randomMarks(width, height, share, random);
    const OccupancyGrid grid(width, height, 1.0, {}, {marks.begin(), marks.end()});
    const auto isMarked = [&](Cell cell) { return marks[grid.indexOf(cell)] != 0; };
    const MarkedCellIndex nearest(width, height, isMarked, {});
    const std::vector<float> transform = distancesToMarked(width, height, marks);
    std::vector<Cell> marked;
    forEachCell(grid, [&](Cell cell) {
      if (isMarked(cell)) {
        marked.push_back(cell);
      }
    });
    QCOMPARE(nearest.isAny(), !marked.empty());
    forEachCell(grid, [&](Cell cell) {
      double best = std::numeric_limits<double>::infinity();
      for (const Cell other : marked) {
        best = std::min(best, toSquare(cell, other));
      }
      const float distance = nearest.distance(cell);
      QVERIFY(distance == transform[grid.indexOf(cell)]);
      QVERIFY(std::isinf(best) ? std::isinf(distance) : std::fabs(distance - best) < 1e-4);
      QCOMPARE(nearest.isMarked(cell), isMarked(cell));
    });
  }

  /// From its middle to the nearer border of the other, along each axis.
  void distance_farMark_isExact() {
    const MarkedCellIndex nearest(9000, 9000,
                                  [](Cell cell) {
                                    return cell == Cell{8999, 8999};
                                  },
                                  {});
    QCOMPARE(nearest.distance({8999, 0}), 8998.5F);
    QCOMPARE(nearest.distance({8999 - 3 * 1500 - 2, 8999 - 4 * 1500 - 2}),
             static_cast<float>(std::hypot(4501.5, 6001.5)));
    QCOMPARE(nearest.distance({8999 - 1, 8999 - 1}), static_cast<float>(std::sqrt(0.5)));
  }

  void distanceAt_everyCell_isTheSame() {
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Scene scene = sceneWithShapes(seed);
      const OccupancyGrid grid = randomMap(seed);
      const Pair pair(grid, scene.obstacles);
      QVERIFY(pair.asked->bytes() < pair.kept->bytes());  // they are of both kinds
      QCOMPARE(pair.asked->hasUnknown(), pair.kept->hasUnknown());
      forEachCell(grid, [&](Cell cell) {
        QVERIFY(pair.asked->distanceAt(cell) == pair.kept->distanceAt(cell));
        QVERIFY(pair.asked->unknownDistance(cell) == pair.kept->unknownDistance(cell));
        QCOMPARE(pair.asked->isUnknown(cell), pair.kept->isUnknown(cell));
      });
      for (const Vec2& point : {Vec2(-1.0, 3.0), Vec2(5.013, 5.027), Vec2(10.0, 10.0)}) {
        QVERIFY(pair.asked->distanceAt(point) == pair.kept->distanceAt(point));
      }
    }
  }

  /// Where nothing stands on it, what stands beside it is felt near its edge alone.
  void distanceAt_mapWithoutWalls_isTheSame() {
    const OccupancyGrid grid = MapSketch(6.0, 6.0).grid();
    Obstacles beside;
    beside.add({boxOutline({{-0.5, 3.0}, 0.0}, 0.6, 1.0)});
    beside.build();
    Obstacles none;
    none.build();
    for (const Obstacles* const obstacles : {&beside, &none}) {
      const Pair pair(grid, *obstacles);
      forEachCell(grid, [&](Cell cell) {
        QVERIFY(pair.asked->distanceAt(cell) == pair.kept->distanceAt(cell));
      });
    }
  }

  void evenTerrain_everyCell_isTheSame() {
    int open = 0, unknown = 0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
      const Scene scene = sceneWithShapes(seed);
      const OccupancyGrid grid = randomMap(seed);
      const Pair pair(grid, scene.obstacles);
      for (const double radius : {0.0, 0.2, 0.35, 0.9}) {
        const UniformTerrain kept(*pair.kept, radius);
        const UniformTerrain asked(*pair.asked, radius);
        forEachCell(grid, [&](Cell cell) {
          const Terrain::Index index = kept.indexOf(cell);
          QCOMPARE(asked.isOpen(index), kept.isOpen(index));
          QCOMPARE(asked.isUnknown(index), kept.isUnknown(index));
          open += kept.isOpen(index) ? 1 : 0;
          unknown += kept.isUnknown(index) ? 1 : 0;
        });
      }
    }
    QVERIFY(open > 100000 && unknown > 1000);
  }

  /// What stands beyond the edge acts on what is near it alone: from far in, nobody can tell.
  void evenTerrain_obstacleBesideTheMap_isTheSame() {
    const int width = 600, height = 30;
    const auto columns = static_cast<std::size_t>(width);
    std::vector<std::int8_t> cells(columns * static_cast<std::size_t>(height), std::int8_t{0});
    for (std::size_t left = 0; left < cells.size(); left += columns) {
      cells[left] = 100;  // a wall at the left end
    }
    const OccupancyGrid grid(width, height, 0.05, {}, cells);
    const Scene scene = sceneOf(grid, {{boxOutline({{30.2, 0.75}, 0.0}, 0.3, 3.0)}});
    const Pair pair(grid, scene.obstacles);
    const UniformTerrain kept(*pair.kept, 0.3);
    const UniformTerrain asked(*pair.asked, 0.3);
    int closed = 0;
    forEachCell(grid, [&](Cell cell) {
      const Terrain::Index index = kept.indexOf(cell);
      QCOMPARE(asked.isOpen(index), kept.isOpen(index));
      closed += cell.column > width / 2 && !kept.isOpen(index) ? 1 : 0;
    });
    QVERIFY(closed > 0);  // beside the obstacle
  }

  void plan_byLength_isTheSame() {
    int ways = 0;
    for (unsigned seed = 1; seed <= 8; ++seed) {
      const Scene scene = sceneWithShapes(seed);
      const Pair pair(randomMap(seed), scene.obstacles);
      PathPlanner kept(pair.kept, 0.25, PathObjective::Length);
      PathPlanner asked(pair.asked, 0.25, PathObjective::Length);
      std::mt19937 random(seed);
      std::uniform_real_distribution<double> place(0.0, 10.0);
      for (int i = 0; i < 12; ++i) {
        const Vec2 from(place(random), place(random));
        const Vec2 to(place(random), place(random));
        const std::vector<Vec2> way = kept.plan(from, to);
        QVERIFY(asked.plan(from, to) == way);
        ways += way.size() > 2 ? 1 : 0;
      }
    }
    QVERIFY2(ways > 25, qPrintable(QString::number(ways)));
  }

  void bytes_areHalfAByte() {
    const Scene scene = sceneOf(MapSketch(100.0, 60.0).fill({40.0, 0.0}, {40.2, 50.0}).grid());
    const OccupancyGrid& grid = scene.field->grid();
    const double cells = static_cast<double>(grid.width()) * grid.height();
    const Pair pair(grid, scene.obstacles);
    QVERIFY(static_cast<double>(pair.asked->bytes()) < 0.5 * cells);
    QVERIFY(static_cast<double>(pair.kept->bytes()) > 4.0 * cells);
  }
};

QTEST_APPLESS_MAIN(AskedDistancesTest)
#include "tst_LazyDistances.moc"
