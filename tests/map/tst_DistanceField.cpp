#include <cmath>
#include <limits>
#include <random>

#include <QtTest>

#include "sim2d/map/DistanceField.h"

using namespace sim2d;

namespace {

OccupancyGrid emptyGrid(int width, int height, double resolution, const Pose2& origin = {}) {
  const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  return OccupancyGrid(width, height, resolution, origin, std::vector<std::int8_t>(count, 0));
}

Obstacles obstaclesOf(const std::vector<Outline>& outlines) {
  Obstacles obstacles;
  for (const Outline& outline : outlines) {
    obstacles.add({outline});
  }
  obstacles.build();
  return obstacles;
}

/// Unit vector away from the nearest wall; zero where it is flat or where no wall is felt.
Vec2 gradientAt(const DistanceField& field, const Vec2& point) {
  const double step = field.grid().resolution();
  const auto slope = [&](const Vec2& offset) {
    return field.distanceAt(Vec2(point + offset)) - field.distanceAt(Vec2(point - offset));
  };
  const Vec2 gradient(slope({step, 0.0}), slope({0.0, step}));
  const double length = gradient.norm();
  return length > 1e-6 * step && std::isfinite(length) ? Vec2(gradient / length) : Vec2::Zero();
}

}  // namespace

class DistanceFieldTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void distancesToMarked_random_agrees() {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> draw(0.0, 1.0);
    for (const double share : {0.01, 0.05, 0.3}) {
      constexpr int kWidth = 37;
      constexpr int kHeight = 23;
      std::vector<char> marked(std::size_t{kWidth} * kHeight);
      for (char& mark : marked) {
        mark = draw(random) < share ? char{1} : char{0};
      }
      marked[100] = 1;
      const auto distances = distancesToMarked(kWidth, kHeight, marked);
      for (int i = 0; i < kWidth * kHeight; ++i) {
        double expected = 1e9;
        for (int j = 0; j < kWidth * kHeight; ++j) {
          if (marked[static_cast<std::size_t>(j)] != 0) {
            const double x = std::max(0.0, std::abs(i % kWidth - j % kWidth) - 0.5);
            const double y = std::max(0.0, std::abs(i / kWidth - j / kWidth) - 0.5);
            expected = std::min(expected, std::sqrt(x * x + y * y));
          }
        }
        QVERIFY(std::fabs(static_cast<double>(distances[static_cast<std::size_t>(i)]) - expected) <
                1e-5);
      }
    }
  }

  void distancesToMarked_none_isInfinite() {
    for (const float distance : distancesToMarked(3, 2, std::vector<char>(6, 0))) {
      QVERIFY(std::isinf(distance));
    }
  }

  void distanceAt_mapWall_isToItsBorder() {
    std::vector<std::int8_t> cells(100, 0);
    cells[55] = 100;
    const DistanceField field(OccupancyGrid(10, 10, 0.1, {{5.0, 0.0}, 0.0}, cells), Obstacles());
    QCOMPARE(field.distanceAt(Cell{5, 5}), 0.0);
    QVERIFY(std::fabs(field.distanceAt(Cell{8, 5}) - 0.25) < 1e-6);
    QVERIFY(std::fabs(field.distanceAt(Cell{1, 1}) - 0.35 * std::sqrt(2.0)) < 1e-6);
    QVERIFY(std::fabs(field.distanceAt(Vec2(5.9, 0.55)) - 0.3) < 1e-6);  // between two centres
    QVERIFY(!field.isOpenPlane());
  }

  void distanceAt_outside_isToNearestWall() {
    std::vector<std::int8_t> cells(100, 0);
    cells[55] = 100;
    const DistanceField field(OccupancyGrid(10, 10, 0.1, {}, cells), Obstacles());
    QVERIFY(std::fabs(field.distanceAt(Vec2(10.6, 0.55)) - 10.0) < 1e-9);
    QVERIFY(std::fabs(field.distanceAt(Cell{105, 5}) - 9.95) < 1e-9);
  }

  /// Against all wall cells, from places all round: beside, beyond a corner, next to the edge.
  void distanceAt_outsideManyWalls_isTheLeastOfAll() {
    constexpr int kWidth = 60, kHeight = 40;
    constexpr double kSide = 0.1;
    std::vector<std::int8_t> cells(static_cast<std::size_t>(kWidth) * kHeight, 0);
    unsigned draw = 7;
    for (std::int8_t& cell : cells) {
      draw = draw * 1664525U + 1013904223U;
      cell = draw >> 24U < 20 ? 100 : 0;
    }
    const OccupancyGrid grid(kWidth, kHeight, kSide, {}, cells);
    const DistanceField field(grid, Obstacles());
    const Vec2 middle(0.5 * kWidth * kSide, 0.5 * kHeight * kSide);
    for (int k = 0; k < 720; ++k) {
      const double angle = k * base::kPi / 360.0;
      const Vec2 place = middle + (4.0 + 0.01 * k) * Vec2(std::cos(angle), std::sin(angle));
      double least = 1e9;
      for (int row = 0; row < kHeight; ++row) {
        for (int column = 0; column < kWidth; ++column) {
          if (grid.isWall({column, row})) {
            const Vec2 low(column * kSide, row * kSide);
            const Vec2 near = place.cwiseMax(low).cwiseMin(low + Vec2::Constant(kSide));
            least = std::min(least, (place - near).norm());
          }
        }
      }
      QVERIFY(std::fabs(field.distanceAt(place) - least) < 1e-9);
    }
  }

  /// A square with a ragged border, from places all round: against all its walls, and how many
  /// cells and boxes are examined, of more and more cells.
  void outsideDistance_longBorder_examinesFew() {
    for (const int side : {100, 400, 1600}) {
      std::vector<std::int8_t> cells(
          static_cast<std::size_t>(side) * static_cast<std::size_t>(side), 0);
      std::vector<Cell> walls;
      unsigned draw = 11;
      const auto add = [&](int column, int row) {
        cells[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) +
              static_cast<std::size_t>(column)] = 100;
        walls.push_back({column, row});
      };
      for (int k = 0; k < side; ++k) {
        draw = draw * 1664525U + 1013904223U;
        const int depth = static_cast<int>(draw >> 30U);  // 0 to 3 cells
        add(k, depth);
        add(k, side - 1 - depth);
        add(depth, k);
        add(side - 1 - depth, k);
      }
      const DistanceField field(OccupancyGrid(side, side, 0.1, {}, cells), Obstacles());
      std::size_t most = 0;
      for (int k = 0; k < 90; ++k) {
        const double angle = k * base::kPi / 45.0;
        const Vec2 place = Vec2::Constant(0.5 * side) +
                           (0.8 + 0.1 * k) * side * Vec2(std::cos(angle), std::sin(angle));
        double least = 1e9;
        for (const Cell wall : walls) {
          const Vec2 low(wall.column, wall.row);
          least =
              std::min(least, (place - place.cwiseMax(low).cwiseMin(low + Vec2::Ones())).norm());
        }
        std::size_t examined = 0;
        QVERIFY(std::fabs(field.outsideDistance(place, &examined) - 0.1 * least) < 1e-9 * side);
        most = std::max(most, examined);
      }
      QVERIFY2(most < 250, QByteArray::number(static_cast<int>(most)).constData());
    }
  }

  void distanceAt_withoutWalls_isInfinite() {
    const DistanceField field(emptyGrid(4, 4, 0.1), Obstacles());
    QVERIFY(std::isinf(field.distanceAt(Cell{1, 1})));
    QVERIFY(std::isinf(field.distanceAt(Vec2(0.2, 0.2))));
    QVERIFY(std::isinf(field.distanceAt(Vec2(-9.0, 0.2))));
    QVERIFY(gradientAt(field, {0.2, 0.2}) == Vec2::Zero());
  }

  void distanceAt_drawnObstacles_areExactNearby() {
    const std::vector<Outline> outlines{boxOutline({{3.0, 3.0}, 0.3}, 2.0, 0.72),
                                        circleOutline({7.0, 5.0}, 0.4)};
    const Obstacles obstacles = obstaclesOf(outlines);
    for (const double resolution : {0.05, 0.1}) {
      const int size = static_cast<int>(10.0 / resolution);
      const DistanceField field(emptyGrid(size, size, resolution), obstacles);
      for (int row = 0; row < size; row += 3) {
        for (int column = 0; column < size; column += 3) {
          const double expected =
              std::max(0.0, obstacles.clearance(field.grid().cellToWorld({column, row}), 50.0));
          const double actual = field.distanceAt(Cell{column, row});
          const bool isExact = expected < 1.2 && !field.grid().isWall({column, row});
          QVERIFY(std::fabs(actual - expected) <= (isExact ? 1e-6 : resolution + 1e-6));
        }
      }
    }
  }

  void distanceAt_mapOutlinesGiven_areNotThicker() {
    std::vector<std::int8_t> cells(400, 0);
    for (std::size_t i = 0; i < 20; ++i) {
      cells[i] = cells[200 + i] = 100;
    }
    const OccupancyGrid grid(20, 20, 0.05, {}, cells);
    Obstacles obstacles;
    obstacles.add(traceOutlines(grid));
    obstacles.build();
    const DistanceField with(grid, obstacles);
    const DistanceField without(grid, Obstacles());
    QVERIFY(with.grid() == grid);
    for (int row = 0; row < 20; ++row) {
      QCOMPARE(with.distanceAt(Cell{7, row}), without.distanceAt(Cell{7, row}));
    }
  }

  void distanceAt_disabledPart_isFree() {
    Obstacles obstacles;
    const int door = obstacles.add(wallOutlines({{0.0, 1.0}, {2.0, 1.0}}, 0.05));
    obstacles.build();
    const OccupancyGrid grid = emptyGrid(40, 40, 0.05);
    const DistanceField closed(grid, obstacles);
    QVERIFY(closed.distanceAt(Vec2(1.0, 1.0)) < 0.03);
    QVERIFY(std::fabs(closed.distanceAt(Vec2(1.0, 1.5)) - 0.475) < 1e-3);
    obstacles.setEnabled(door, false);
    QVERIFY(std::isinf(DistanceField(grid, obstacles).distanceAt(Vec2(1.0, 1.0))));
  }

  void distanceAt_obstacleBeyondMap_isFelt() {
    const Obstacles obstacles = obstaclesOf({boxOutline({{-1.2, 2.0}, 0.0}, 2.0, 8.0)});
    const DistanceField field(emptyGrid(80, 80, 0.05), obstacles);
    QVERIFY(std::fabs(field.distanceAt(Vec2(0.3, 2.0)) - 0.5) < 1e-3);
    QVERIFY(field.distanceAt(Vec2(3.0, 2.0)) >= 1.19);
    QVERIFY((gradientAt(field, {0.3, 2.0}) - Vec2(1, 0)).norm() < 1e-3);
    QVERIFY(gradientAt(field, {-50.0, 2.0}) == Vec2::Zero());
  }

  void grid_thinWall_hasNoHoles() {
    // Thinner than a cell, oblique: every way from left to right over free cells must be cut.
    const DistanceField field(emptyGrid(60, 60, 0.1),
                              obstaclesOf({wallOutlines({{2.03, -1.0}, {3.9, 7.0}}, 0.01)[0]}));
    std::vector<Cell> open{{0, 30}};
    std::vector<char> seen(3600, 0);
    while (!open.empty()) {
      const Cell cell = open.back();
      open.pop_back();
      const bool isFree = field.grid().contains(cell) && !field.grid().isWall(cell);
      if (!isFree || seen[field.grid().indexOf(cell)] != 0) {
        continue;
      }
      seen[field.grid().indexOf(cell)] = 1;
      for (const Cell step : {Cell{1, 0}, Cell{-1, 0}, Cell{0, 1}, Cell{0, -1}}) {
        open.push_back({cell.column + step.column, cell.row + step.row});
      }
    }
    QVERIFY(seen[0] != 0);
    QVERIFY(seen[59] == 0);
    QVERIFY(seen[3599] == 0);
  }

  void gradientAt_pointsAway() {
    std::vector<std::int8_t> cells(10000, 0);
    for (std::size_t row = 0; row < 100; ++row) {
      cells[row * 100] = 100;
    }
    const DistanceField field(OccupancyGrid(100, 100, 0.05, {}, cells), Obstacles());
    QVERIFY((gradientAt(field, {1.0, 2.5}) - Vec2(1, 0)).norm() < 1e-6);
  }

  void openPlane_coversBounds() {
    const DistanceField field(OccupancyGrid(), obstaclesOf({boxOutline({}, 2.0, 2.0)}),
                              {{-20.0, 3.0}, {0.0, 9.0}});
    QVERIFY(field.isOpenPlane());
    for (const Vec2& point : {Vec2(-22.9, 0.0), Vec2(3.9, -3.9), Vec2(0.0, 11.9)}) {
      QVERIFY(field.grid().contains(field.grid().worldToCell(point)));
    }
    QVERIFY(std::fabs(field.distanceAt(Vec2(1.6, 0.0)) - 0.6) < 1e-3);
    QVERIFY(std::isinf(DistanceField(OccupancyGrid(), Obstacles()).distanceAt(Vec2(0, 0))));
  }

  void openPlane_huge_staysBounded() {
    const DistanceField field(OccupancyGrid(), obstaclesOf({boxOutline({}, 2.0, 2.0)}),
                              {{-1e6, 3.0}, {0.0, 1e6}, {1e3, 1e3}});
    QVERIFY(field.grid().cells().size() <= 4'000'000);
    QVERIFY(field.distanceAt(Vec2(0.0, 0.0)) >= 0.0);
  }

  void construct_largeMap_findsTheNearestWall() {
    std::vector<std::int8_t> cells(1'000'000, 0);
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i] = i % 97 == 0 && (i / 1000) % 50 < 30 ? std::int8_t{100} : std::int8_t{0};
    }
    const OccupancyGrid grid(1000, 1000, 0.05, {}, cells);
    Obstacles obstacles;
    obstacles.add(traceOutlines(grid));
    obstacles.build();
    const DistanceField field(grid, obstacles);
    for (int row = 7; row < 1000; row += 199) {
      for (int column = 3; column < 1000; column += 97) {
        double nearest = std::numeric_limits<double>::infinity();  // to the border of a wall cell
        for (int i = 0; i < 1'000'000; ++i) {
          if (cells[static_cast<std::size_t>(i)] == 0) {
            continue;
          }
          const double dx = std::max(0.0, std::abs(i % 1000 - column) - 0.5);
          const double dy = std::max(0.0, std::abs(i / 1000 - row) - 0.5);
          nearest = std::min(nearest, 0.05 * std::sqrt(dx * dx + dy * dy));
        }
        const double found = field.distanceAt(Cell{column, row});
        QVERIFY2(std::fabs(found - nearest) < 0.036,
                 QByteArray::number(found - nearest).constData());
      }
    }
  }

  /// Those of the same map give the same field; those of another one show that they are not worked
  /// out again.
  void construct_wallsGiven_takesThem() {
    std::vector<std::int8_t> cells(10000, 0);
    std::fill(cells.begin(), cells.begin() + 100, std::int8_t{100});
    const OccupancyGrid grid(100, 100, 0.05, {}, cells);
    const Obstacles obstacles = obstaclesOf({circleOutline({2.5, 3.0}, 0.4)});
    const auto stop = std::make_shared<const base::StopFlag>();
    const auto fieldWith = [&](const OccupancyGrid& walls) {
      return DistanceField(grid, obstacles, {}, DistanceField::kMaxCells, stop,
                           DistanceField::mapWallDistances(walls, false, *stop));
    };
    const DistanceField fresh(grid, obstacles);
    const DistanceField same = fieldWith(grid);
    const DistanceField other = fieldWith(emptyGrid(100, 100, 0.05));
    for (int row = 0; row < 100; ++row) {
      QCOMPARE(same.distanceAt(Cell{50, row}), fresh.distanceAt(Cell{50, row}));
    }
    QVERIFY(other.distanceAt(Cell{50, 5}) > fresh.distanceAt(Cell{50, 5}) + 1.0);
  }
};

QTEST_APPLESS_MAIN(DistanceFieldTest)
#include "tst_DistanceField.moc"
