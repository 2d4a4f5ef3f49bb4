#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "sim2d/nav/nav2/costmap/Footprint.h"

using namespace sim2d::nav2;
using sim2d::Cell;

namespace {

bool isNear(const Vec2& place, double x, double y, double within = 1e-6) {
  return std::fabs(place.x() - x) < within && std::fabs(place.y() - y) < within;
}

bool isFootprintFree(const Costmap& costmap, const Polygon& corners, double x, double y) {
  return footprintCost(costmap, corners, {{x, y}, 0.0}) != kLethal;
}

}  // namespace

/// Vectors of nav2_costmap_2d: footprint_tests.cpp, footprint_collision_checker_test.cpp.
class CostmapFootprintTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void costmapFootprint_nothingGiven_isTheRadiusOfTheCode() {
    const CostmapFootprint footprint = costmapFootprint(0.1, {}, 0.01);
    QCOMPARE(footprint.corners.size(), std::size_t{16});
    QVERIFY(isNear(footprint.corners[0], 0.11, 0.0));
    QVERIFY(footprint.isRadius);
  }

  void costmapFootprint_radius_hasSixteenCorners() {
    const CostmapFootprint footprint = costmapFootprint(10.0, {}, 0.0);
    QCOMPARE(footprint.corners.size(), std::size_t{16});
    QVERIFY(isNear(footprint.corners[0], 10.0, 0.0));
    QVERIFY(isNear(footprint.corners[4], 0.0, 10.0));
  }

  void costmapFootprint_radius_padsRoundingOfRightAngles() {
    const Polygon corners = costmapFootprint(0.22, {}, 0.01).corners;
    QVERIFY(isNear(corners[0], 0.23, 0.0));
    QVERIFY(isNear(corners[1], 0.2132535, 0.0941904));  // 0.22 (cos, sin) of pi/8, plus 0.01
    QVERIFY(isNear(corners[4], 0.01, 0.23));
    QVERIFY(isNear(corners[8], -0.23, 0.01));
    QVERIFY(isNear(corners[12], -0.01, -0.23));
  }

  void costmapFootprint_radius_hasRadii_data() {
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("inscribed");
    QTest::addColumn<double>("circumscribed");
    QTest::newRow("turtlebot 4") << 0.22 << 0.22550 << 0.23414;
    QTest::newRow("burger") << 0.105 << 0.11268 << 0.11914;
    QTest::newRow("code") << 0.1 << 0.10778 << 0.11414;
  }

  void costmapFootprint_radius_hasRadii() {
    QFETCH(double, radius);
    QFETCH(double, inscribed);
    QFETCH(double, circumscribed);
    const CostmapFootprint footprint = costmapFootprint(radius, {}, 0.01);
    QVERIFY(std::fabs(footprint.inscribed - inscribed) < 1e-5);
    QVERIFY(std::fabs(footprint.circumscribed - circumscribed) < 1e-5);
  }

  void costmapFootprint_corners_areNoRadius() {
    const CostmapFootprint footprint =
        costmapFootprint(5.0, {{0.3, 0.2}, {-0.3, 0.2}, {-0.3, -0.2}, {0.3, -0.2}}, 0.0);
    QVERIFY(!footprint.isRadius);
    QVERIFY(std::fabs(footprint.inscribed - 0.2) < 1e-12);
    QVERIFY(std::fabs(footprint.circumscribed - std::sqrt(0.13)) < 1e-12);
  }

  void padded_corners_moveAwayFromTheAxes() {
    const Polygon wide = padded({{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {0.0, -2.0}}, 0.5);
    QVERIFY(isNear(wide[0], 1.5, 1.5));
    QVERIFY(isNear(wide[1], -1.5, 1.5));
    QVERIFY(isNear(wide[2], -1.5, -1.5));
    QVERIFY(isNear(wide[3], 0.0, -2.5));
  }

  void readPolygon_text_isReadOrRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("corners");  // 0: refused
    QTest::newRow("of nav2") << "[[1, 2.2], [.3, -4e4], [-.3, -4e4], [-1, 2.2]]" << 4;
    QTest::newRow("blanks") << " [ [0,0] ,[1 , 0],\n[1, 1] ]  " << 3;
    QTest::newRow("no commas") << "[[0 0] [1 0] [1 1]]" << 3;
    QTest::newRow("two corners") << "[[1, 2.2], [.3, -4e4]]" << 0;
    QTest::newRow("triple") << "[[1, 2.2], [.3, -4e4, 5], [-.3, -4e4], [-1, 2.2]]" << 0;
    QTest::newRow("cut off") << "[[bad_string" << 0;
    QTest::newRow("one number") << "[[1], [2, 3], [4, 5], [6, 7]]" << 0;
    QTest::newRow("not closed") << "[[0, 0], [1, 0], [1, 1]" << 0;
    QTest::newRow("more behind") << "[[0, 0], [1, 0], [1, 1]] x" << 0;
    QTest::newRow("not finite") << "[[0, 0], [inf, 0], [1, 1]]" << 0;
    QTest::newRow("empty") << "[]" << 0;
    QTest::newRow("nothing") << "" << 0;
  }

  void readPolygon_text_isReadOrRefused() {
    QFETCH(QString, text);
    QFETCH(int, corners);
    const base::Result<Polygon> polygon = readPolygon(text.toStdString());
    QCOMPARE(static_cast<bool>(polygon), corners > 0);
    if (polygon) {
      QCOMPARE(static_cast<int>(polygon->size()), corners);
    }
  }

  void readPolygon_exponents_areRead() {
    const Polygon polygon = {{0.14, 0.25}, {0.14, -0.25}, {-0.607, -1e-9}};
    QVERIFY(*readPolygon("[[0.14, 0.25], [0.14, -0.25], [-0.607, -1e-09]]") == polygon);
  }

  void inscribedRadius_box_isOfTheNearestEdge() {
    // The origin on an edge; beside the box; nothing.
    QCOMPARE(inscribedRadius({{0.0, 0.2}, {0.0, -0.2}, {1.0, -0.2}, {1.0, 0.2}}), 0.0);
    QVERIFY(std::fabs(inscribedRadius({{0.3, 1.0}, {0.3, -1.0}, {2.0, 0.0}}) - 0.3) < 1e-12);
    QVERIFY(std::fabs(circumscribedRadius({{0.3, 1.0}, {0.3, -1.0}, {2.0, 0.0}}) - 2.0) < 1e-12);
    QCOMPARE(inscribedRadius({}), 0.0);
  }

  void placed_turnedPose_turnsAndMoves() {
    const Polygon world = transformed({{1.0, 0.0}, {0.0, 2.0}}, {{10.0, 20.0}, base::kPi / 2.0});
    QVERIFY(isNear(world[0], 10.0, 21.0));
    QVERIFY(isNear(world[1], 8.0, 20.0));
  }

  void visitLine_steps_areBresenhams() {
    // By hand, error 5/2 = 2, + 2 per step: 4, 6 -> 1 (up), 3, 5 -> 0 (up).
    const std::vector<Cell> right = {{0, 0}, {1, 0}, {2, 1}, {3, 1}, {4, 2}, {5, 2}};
    std::vector<Cell> cells;
    visitLine({0, 0}, {5, 2}, [&cells](Cell cell) {
      cells.push_back(cell);
      return true;
    });
    QVERIFY(cells == right);
    // Steep and downwards: error 3/2 = 1, + 1: 2, 3 -> 0 (left), 1.
    const std::vector<Cell> down = {{4, 4}, {4, 3}, {3, 2}, {3, 1}};
    cells.clear();
    visitLine({4, 4}, {3, 1}, [&cells](Cell cell) {
      cells.push_back(cell);
      return true;
    });
    QVERIFY(cells == down);
    cells.clear();
    visitLine({2, 2}, {2, 2}, [&cells](Cell cell) {
      cells.push_back(cell);
      return true;
    });
    QVERIFY(cells == std::vector<Cell>({{2, 2}}));
  }

  /// Vector 50: 0.1 m cells, free only just round (5, 5).
  void footprintCost_boxOfNav2_meetsTheWalls() {
    Costmap costmap(100, 100, 0.1, {0.0, 0.0}, kLethal);
    fillWindow(costmap, {40, 40, 61, 61}, kFreeSpace);
    const Polygon box = {{1.0, 1.0}, {1.0, -1.0}, {-1.0, -1.0}, {-1.0, 1.0}};
    QVERIFY(footprintCost(costmap, box, {{5.0, 5.0}, 0.0}) == kFreeSpace);
    QVERIFY(!isFootprintFree(costmap, box, 5.0, 4.9));
    QVERIFY(!isFootprintFree(costmap, box, 5.0, 5.2));
  }

  void footprintCost_edgesAndInside_onlyEdgesCount() {
    Costmap costmap(20, 20, 1.0, {0.0, 0.0});
    const Polygon box = {{3.0, 3.0}, {-3.0, 3.0}, {-3.0, -3.0}, {3.0, -3.0}};
    const Pose2 centre{{10.5, 10.5}, 0.0};
    costmap.set({10, 10}, kLethal);  // inside
    QCOMPARE(int{footprintCost(costmap, box, centre)}, 0);
    costmap.set({13, 10}, kInscribed);
    QCOMPARE(int{footprintCost(costmap, box, centre)}, 253);
    QVERIFY(!isEdgeCollision(kInscribed, false));
    costmap.set({10, 7}, kLethal);  // between the last corners
    QCOMPARE(int{footprintCost(costmap, box, centre)}, 254);
  }

  /// As nav2's code has it: 254 wins on its edge, then the greatest of the edges.
  void footprintCost_unknown_hidesLaterWalls() {
    Costmap costmap(20, 20, 1.0, {0.0, 0.0});
    costmap.set({5, 5}, kNoInformation);
    costmap.set({6, 5}, kLethal);
    QCOMPARE(int{lineCost(costmap, {2, 5}, {9, 5})}, 254);
    costmap.set({6, 5}, kFreeSpace);
    QCOMPARE(int{lineCost(costmap, {2, 5}, {9, 5})}, 255);
    const Polygon edges = {{2.5, 5.5}, {9.5, 5.5}, {9.5, 12.5}};
    costmap.set({9, 8}, kLethal);
    QCOMPARE(int{polygonCost(costmap, edges)}, 255);
    costmap.set({5, 5}, 7);
    QCOMPARE(int{polygonCost(costmap, edges)}, 254);
  }

  void footprintCost_cornerOffTheMap_isLethal() {
    const Costmap costmap(10, 10, 1.0, {0.0, 0.0});
    const Polygon box = {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}};
    QCOMPARE(int{footprintCost(costmap, box, {{5.0, 5.0}, 0.0})}, 0);
    QCOMPARE(int{footprintCost(costmap, box, {{0.9, 5.0}, 0.0})}, 254);
    QCOMPARE(int{pointCost(costmap, {-0.1, 5.0})}, 254);
  }

  void isInCollision_roundAndPolygon_lookElsewhere() {
    Costmap costmap(20, 20, 1.0, {0.0, 0.0});
    const CostmapFootprint round = costmapFootprint(2.0, {}, 0.0);
    const CostmapFootprint box =
        costmapFootprint(0.0, {{2.0, 2.0}, {-2.0, 2.0}, {-2.0, -2.0}, {2.0, -2.0}}, 0.0);
    const Pose2 pose{{10.5, 10.5}, 0.0};
    costmap.set({12, 10}, kLethal);  // on the edges of both
    QVERIFY(!isInCollision(costmap, round, pose, true));
    QVERIFY(isInCollision(costmap, box, pose, true));
    costmap.set({12, 10}, kFreeSpace);
    costmap.set({10, 10}, kInscribed);  // at the centre
    QVERIFY(isInCollision(costmap, round, pose, true));
    QVERIFY(!isInCollision(costmap, box, pose, true));
    costmap.set({10, 10}, kNoInformation);
    QVERIFY(!isInCollision(costmap, round, pose, true));
    QVERIFY(isInCollision(costmap, round, pose, false));
  }
};

QTEST_APPLESS_MAIN(CostmapFootprintTest)
#include "tst_CostmapFootprint.moc"
