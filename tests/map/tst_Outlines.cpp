#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "sim2d/map/Outlines.h"
#include "tests/support/Columns.h"

using namespace sim2d;

Q_DECLARE_METATYPE(std::vector<std::string>)
Q_DECLARE_METATYPE(std::vector<base::Vec2>)

namespace {

/// Rows from the top, '#' = wall.
OccupancyGrid gridOf(const std::vector<std::string>& rows, double resolution = 1.0) {
  const int width = static_cast<int>(rows[0].size());
  const int height = static_cast<int>(rows.size());
  std::vector<std::int8_t> cells;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row) {
    for (const char c : *row) {
      cells.push_back(c == '#' ? std::int8_t{100} : std::int8_t{0});
    }
  }
  return OccupancyGrid(width, height, resolution, {}, std::move(cells));
}

OccupancyGrid noise(int size, double share, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::int8_t> cells(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  std::uniform_real_distribution<double> draw(0.0, 1.0);
  for (std::int8_t& cell : cells) {
    cell = draw(random) < share ? std::int8_t{100} : std::int8_t{0};
  }
  return OccupancyGrid(size, size, 1.0, {}, std::move(cells));
}

bool touchOrCross(const std::vector<Outline>& outlines) {
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (!isSimple(outlines[i].points)) {
      return true;
    }
    for (std::size_t j = i + 1; j < outlines.size(); ++j) {
      const auto& a = outlines[i].points;
      const auto& b = outlines[j].points;
      for (std::size_t m = 0; m < a.size(); ++m) {
        for (std::size_t n = 0; n < b.size(); ++n) {
          if (segmentsTouch({a[m], a[(m + 1) % a.size()]}, {b[n], b[(n + 1) % b.size()]})) {
            return true;
          }
        }
      }
    }
  }
  return false;
}

double distanceToOutlines(const std::vector<Outline>& outlines, const Vec2& point) {
  double best = 1e9;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      best = std::min(
          best, distanceToSegment(
                    {outline.points[i], outline.points[(i + 1) % outline.points.size()]}, point));
    }
  }
  return best;
}

double totalArea(const std::vector<Outline>& outlines) {
  double area = 0.0;
  for (const Outline& outline : outlines) {
    area += signedArea(outline.points);
  }
  return area;
}

}  // namespace

class OutlinesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void traceOutlines_oneCell_isItsSquare() {
    const auto outlines = traceOutlines(gridOf({"...", ".#.", "..."}));
    QCOMPARE(outlines.size(), std::size_t{1});
    QCOMPARE(outlines[0].points.size(), std::size_t{4});
    QCOMPARE(signedArea(outlines[0].points), 1.0);
    for (const Vec2& corner : {Vec2(1, 1), Vec2(2, 1), Vec2(2, 2), Vec2(1, 2)}) {
      QVERIFY(std::count(outlines[0].points.begin(), outlines[0].points.end(), corner) == 1);
    }
  }

  void traceOutlines_room_hasTwoSquares() {
    const auto outlines = traceOutlines(gridOf({"######", "#....#", "#....#", "######"}));
    QCOMPARE(outlines.size(), std::size_t{2});
    QCOMPARE(outlines[0].points.size(), std::size_t{4});
    QCOMPARE(outlines[1].points.size(), std::size_t{4});
    QCOMPARE(signedArea(outlines[0].points), 24.0);
    QCOMPARE(signedArea(outlines[1].points), -8.0);
  }

  void traceOutlines_atMapEdge_isClosed() {
    const auto outlines = traceOutlines(gridOf({"##", "##"}, 0.5));
    QCOMPARE(outlines.size(), std::size_t{1});
    QCOMPARE(signedArea(outlines[0].points), 1.0);
  }

  void traceOutlines_openPlane_isEmpty() { QVERIFY(traceOutlines(OccupancyGrid()).empty()); }

  void traceOutlines_diagonalWall_isStraightAndClosed() {
    std::vector<std::string> rows(40, std::string(40, '.'));
    for (std::size_t i = 2; i < 38; ++i) {
      rows[i][i] = '#';
    }
    const auto outlines = traceOutlines(gridOf(rows));
    QCOMPARE(outlines.size(), std::size_t{1});
    QVERIFY(outlines[0].points.size() <= 8);
    QVERIFY(isSimple(outlines[0].points));
    QVERIFY(isInside(outlines[0].points, {20.0, 20.0}));  // the corner that two cells share
  }

  void traceOutlines_touchingCorners_staySimple_data() {
    QTest::addColumn<std::vector<std::string>>("rows");
    QTest::newRow("pair") << std::vector<std::string>{"#.", ".#"};
    QTest::newRow("ring") << std::vector<std::string>{".#.", "#.#", ".#."};
    QTest::newRow("big ring") << std::vector<std::string>{"..#..", ".#.#.", "#...#", ".#.#.",
                                                          "..#.."};
    QTest::newRow("checkers") << std::vector<std::string>{"#.#.#", ".#.#.", "#.#.#", ".#.#."};
    QTest::newRow("hole at a corner")
        << std::vector<std::string>{"#####", "#.###", "##.##", "#####"};
    QTest::newRow("plus") << std::vector<std::string>{".#.", "###", ".#."};
    QTest::newRow("thin corridor")
        << std::vector<std::string>{"####....", "....####", "####....", "....####"};
  }

  void traceOutlines_touchingCorners_staySimple() {
    QFETCH(const std::vector<std::string>, rows);
    const auto outlines = traceOutlines(gridOf(rows));
    QVERIFY(!outlines.empty());
    QVERIFY(!touchOrCross(outlines));
  }

  void traceOutlines_noise_staysSimpleAndNear_data() {
    QTest::addColumn<double>("share");
    for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9}) {
      QTest::addRow("%g", share) << share;
    }
  }

  void traceOutlines_noise_staysSimpleAndNear() {
    QFETCH(const double, share);
    for (unsigned seed = 1; seed <= 20; ++seed) {
      const OccupancyGrid grid = noise(16, share, seed);
      const auto outlines = traceOutlines(grid);
      QVERIFY(!touchOrCross(outlines));
      double cells = 0.0;
      for (int row = -1; row <= grid.height(); ++row) {
        for (int column = -1; column <= grid.width(); ++column) {
          const Cell cell{column, row};
          cells += grid.isWall(cell) ? 1.0 : 0.0;
          for (const Cell next : {Cell{column + 1, row}, Cell{column, row + 1}}) {
            if (grid.isWall(cell) != grid.isWall(next)) {
              const Vec2 middle = 0.5 * (grid.cellToWorld(cell) + grid.cellToWorld(next));
              QVERIFY(distanceToOutlines(outlines, middle) <= 0.5 + 1e-6);
            }
          }
        }
      }
      QVERIFY(std::fabs(totalArea(outlines) - cells) < 0.2 * 16 * 16);
    }
  }

  void traceOutlines_withOriginAndYaw_isInWorld() {
    const OccupancyGrid grid(1, 1, 0.5, {{1.0, 2.0}, base::kPi / 2.0}, {100});
    const auto outlines = traceOutlines(grid);
    QCOMPARE(outlines.size(), std::size_t{1});
    QVERIFY(isInside(outlines[0].points, {0.75, 2.25}));
    QVERIFY(signedArea(outlines[0].points) > 0.2499);
  }

  void traceOutlines_largeMap_hasFewPoints() {
    constexpr int kSize = 4000;
    std::vector<std::int8_t> cells(std::size_t{kSize} * kSize, 0);
    for (int row = 0; row < kSize; ++row) {
      for (int column = 0; column < kSize; ++column) {
        const bool wall = row % 200 < 3 || (column % 200 < 3 && row % 200 > 40) ||
                          std::abs(row % 200 - 100) + std::abs(column % 200 - 100) < 20;
        cells[static_cast<std::size_t>(row) * kSize + static_cast<std::size_t>(column)] =
            wall ? std::int8_t{100} : std::int8_t{0};
      }
    }
    const OccupancyGrid grid(kSize, kSize, 0.05, {}, std::move(cells));
    const auto outlines = traceOutlines(grid);
    std::size_t points = 0;
    for (const Outline& outline : outlines) {
      points += outline.points.size();
    }
    QVERIFY(outlines.size() > 400);
    QVERIFY2(points < 20 * outlines.size(), QByteArray::number(qulonglong(points)).constData());
  }

  void boxOutline_turned_hasCorners() {
    const Outline box = boxOutline({{1.0, 1.0}, base::kPi / 2.0}, 4.0, 2.0);
    QCOMPARE(box.points.size(), std::size_t{4});
    QVERIFY(std::fabs(signedArea(box.points) - 8.0) < 1e-9);
    QVERIFY(isInside(box.points, {1.9, 2.9}));
    QVERIFY(!isInside(box.points, {2.1, 1.0}));
  }

  void circleOutline_isCounterClockwise() {
    const Outline circle = circleOutline({1.0, 2.0}, 0.5);
    QCOMPARE(circle.points.size(), std::size_t{32});
    QVERIFY(std::fabs(signedArea(circle.points) - 16.0 * 0.25 * std::sin(base::kPi / 16.0)) < 1e-9);
  }

  void polygonOutline_clockwise_isTurned() {
    const Outline outline = polygonOutline({{0, 0}, {0, 1}, {1, 1}, {1, 0}});
    QCOMPARE(signedArea(outline.points), 1.0);
  }

  void wallOutlines_corner_isOnePolygon() {
    const auto outlines = wallOutlines({{0, 0}, {4, 0}, {4, 3}}, 0.2);
    QCOMPARE(outlines.size(), std::size_t{1});
    QCOMPARE(outlines[0].points.size(), std::size_t{6});
    QVERIFY(std::fabs(signedArea(outlines[0].points) - 0.2 * 7.0) < 1e-9);
    QVERIFY(isInside(outlines[0].points, {4.09, -0.09}));
  }

  void wallOutlines_closed_hasInnerBorder() {
    for (const bool clockwise : {false, true}) {
      std::vector<Vec2> line{{0, 0}, {4, 0}, {4, 3}, {0, 3}, {0, 0}};
      if (clockwise) {
        std::reverse(line.begin(), line.end());
      }
      const auto outlines = wallOutlines(line, 0.2);
      QCOMPARE(outlines.size(), std::size_t{2});
      QVERIFY(std::fabs(totalArea(outlines) - (4.2 * 3.2 - 3.8 * 2.8)) < 1e-9);
    }
  }

  void wallOutlines_sharpTurn_isUnionOfBoxes() {
    const auto outlines = wallOutlines({{0, 0}, {4, 0}, {0, 0.5}}, 0.2);
    QCOMPARE(outlines.size(), std::size_t{2});
    for (const Outline& outline : outlines) {
      QVERIFY(isSimple(outline.points));
      QVERIFY(signedArea(outline.points) > 0.0);
    }
  }

  void wallOutlines_degenerate_isSafe() {
    QVERIFY(wallOutlines({}, 0.1).empty());
    const auto point = wallOutlines({{1, 1}, {1, 1}}, 0.1);
    QCOMPARE(point.size(), std::size_t{1});
    QVERIFY(std::fabs(signedArea(point[0].points) - 0.01) < 1e-12);
    QCOMPARE(wallOutlines({{0, 0}, {1, 0}, {0, 0}}, 0.1).size(), std::size_t{2});
  }

  void isSimple_cases_data() {
    addColumns<std::vector<Vec2>, bool>({"polygon", "expected"});
    QTest::newRow("square") << std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}, {0, 1}} << true;
    QTest::newRow("bow tie") << std::vector<Vec2>{{0, 0}, {1, 1}, {1, 0}, {0, 1}} << false;
    QTest::newRow("two points") << std::vector<Vec2>{{0, 0}, {1, 1}} << false;
    QTest::newRow("spike") << std::vector<Vec2>{{0, 0}, {2, 0}, {1, 0}, {1, 1}} << false;
    QTest::newRow("flat corner") << std::vector<Vec2>{{0, 0}, {1, 0}, {2, 0}, {1, 1}} << true;
    QTest::newRow("touches itself")
        << std::vector<Vec2>{{0, 0}, {4, 0}, {4, 2}, {2, 0}, {0, 2}} << false;
  }

  void isSimple_cases() {
    QFETCH(const std::vector<Vec2>, polygon);
    QFETCH(const bool, expected);
    QCOMPARE(isSimple(polygon), expected);
  }
};

QTEST_APPLESS_MAIN(OutlinesTest)
#include "tst_Outlines.moc"
