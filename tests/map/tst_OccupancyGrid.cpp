#include <limits>

#include <QtTest>

#include "sim2d/map/OccupancyGrid.h"

using namespace sim2d;

class OccupancyGridTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void valueAt_outside_isFree() {
    const OccupancyGrid grid(2, 1, 1.0, {}, {100, 100});
    QCOMPARE(int{grid.valueAt({1, 0})}, 100);
    QCOMPARE(int{grid.valueAt({2, 0})}, 0);
    QCOMPARE(int{grid.valueAt({0, -1})}, 0);
    QVERIFY(!grid.contains({0, 1}));
  }

  void isWall_aboveFifty_isTrue() {
    const OccupancyGrid grid(5, 1, 1.0, {}, {50, 51, 100, -1, 0});
    QVERIFY(!grid.isWall({0, 0}));
    QVERIFY(grid.isWall({1, 0}));
    QVERIFY(grid.isWall({2, 0}));
    QVERIFY(!grid.isWall({3, 0}));
    QVERIFY(grid.isUnknown({3, 0}));
    QVERIFY(!grid.isUnknown({4, 0}));
  }

  void worldToCell_withOrigin_floors() {
    const OccupancyGrid grid(4, 4, 0.5, {{-1.0, 2.0}, 0.0}, std::vector<std::int8_t>(16, 0));
    QVERIFY((grid.worldToCell({-1.0, 2.0}) == Cell{0, 0}));
    QVERIFY((grid.worldToCell({-1.1, 2.6}) == Cell{-1, 1}));
    QVERIFY((grid.worldToCell({0.99, 3.99}) == Cell{3, 3}));
    QVERIFY(grid.cellToWorld({0, 3}).isApprox(Vec2(-0.75, 3.75)));
  }

  void worldToCell_withYaw_turnsBack() {
    // Turned by a quarter: columns grow along +y, rows along -x.
    const OccupancyGrid grid(3, 2, 1.0, {{10.0, 0.0}, base::kPi / 2.0},
                             std::vector<std::int8_t>(6, 0));
    QVERIFY((grid.worldToCell({9.5, 2.5}) == Cell{2, 0}));
    QVERIFY((grid.worldToCell({8.5, 0.5}) == Cell{0, 1}));
    QVERIFY((grid.cellToWorld({2, 1}) - Vec2(8.5, 2.5)).norm() < 1e-12);
  }

  void worldToCell_farOrNaN_staysDefined() {
    const OccupancyGrid grid(1, 1, 0.05, {}, {0});
    QVERIFY(!grid.contains(grid.worldToCell({1e300, -1e300})));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!grid.contains(grid.worldToCell({nan, nan})));
  }

  void cellToWorld_withYaw_isInverse() {
    const OccupancyGrid grid(30, 20, 0.05, {{-3.0, 1.0}, 0.7}, std::vector<std::int8_t>(600, 0));
    for (int row = 0; row < grid.height(); ++row) {
      for (int column = 0; column < grid.width(); ++column) {
        QVERIFY((grid.worldToCell(grid.cellToWorld({column, row})) == Cell{column, row}));
      }
    }
  }

  void openPlane_isFreeEverywhere() {
    const OccupancyGrid grid;
    QVERIFY(grid.isEmpty());
    QVERIFY(!grid.contains({0, 0}));
    QVERIFY(!grid.isWall({0, 0}));
    QVERIFY(grid == OccupancyGrid());
  }
};

QTEST_APPLESS_MAIN(OccupancyGridTest)
#include "tst_OccupancyGrid.moc"
