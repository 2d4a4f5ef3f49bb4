#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/Nav2ParameterBlock.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "tests/nav/CostmapScenes.h"

using namespace costmapscenes;

namespace {

CostmapSetup tenByTenSetup() {
  CostmapSetup setup = plainSetup(10);
  setup.map = tenByTen();
  setup.settings.plugins = {{"static_layer", StaticLayerParameters{}},
                            {"obstacle_layer", obstacleLayer()}};
  return setup;
}

CostmapSetup otherLayerSetup() {
  CostmapSetup setup = tenByTenSetup();
  setup.settings.plugins[1].parameters = obstacleLayer(newestSource());
  setup.settings.plugins.push_back({"other_layer", obstacleLayer(newestSource())});
  return setup;
}

/// A row of marks that stay.
LayeredCostmap markedRow() {
  CostmapSetup setup = plainSetup(10);
  ObservationSource source = newestSource();
  source.clearing = false;
  setup.settings.plugins = {{"obstacle_layer", obstacleLayer(source)}};
  LayeredCostmap costmap(setup);
  for (int i = 0; i < 10; ++i) {
    look(costmap, {0.5, 0.5}, {i + 0.5, 5.5}, 0.1 * i);
  }
  return costmap;
}

std::string rowOf(const Costmap& costmap, int row) {
  std::string text;
  for (int column = 0; column < costmap.width(); ++column) {
    const int cost = costmap.at({column, row});
    text += cost == kLethal ? '#' : cost == kNoInformation ? '?' : cost == 0 ? '.' : '+';
  }
  return text;
}

CostmapSetup rollingSetup() {
  CostmapSetup setup = plainSetup(4);
  setup.settings.parameters.rollingWindow = true;
  return setup;
}

OccupancyGrid filled(int side, std::int8_t value) {
  return OccupancyGrid(side, side, 1.0, {},
                       std::vector<std::int8_t>(static_cast<std::size_t>(side * side), value));
}

}  // namespace

class LayeredCostmapTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Vector 43, testRaytracing: 20 walls and the obstacle.
  void update_mapWithObstacle_hasItsWallsAndOne() {
    LayeredCostmap costmap(tenByTenSetup());
    costmap.updateNow(at({0.0, 0.0}, 0.0));
    QCOMPARE(count(costmap.costmap(), kLethal), 20);
    look(costmap, {0.0, 0.0}, {0.0, 0.0}, 0.1);
    QCOMPARE(count(costmap.costmap(), kLethal), 21);
  }

  /// Vector 43, testRaytracing2: the ray passes walls of the map, which stay.
  void update_rayThroughWalls_leavesThem() {
    LayeredCostmap costmap(tenByTenSetup());
    look(costmap, {0.5, 0.5}, {9.5, 9.5}, 0.0);
    QCOMPARE(count(costmap.costmap(), kLethal), 20);  // its end is a wall here
    look(costmap, {0.5, 0.5}, {8.5, 0.5}, 0.1);
    QCOMPARE(count(costmap.costmap(), kLethal), 21);
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 79);
  }

  /// Vector 41 with walls in other places: each of them and of the obstacles has its four
  /// neighbours.
  void update_inflatedMap_hasTheRingOfEveryWall() {
    for (const Distro distro : {Distro::Humble, Distro::Main}) {
      CostmapSetup setup = tenByTenSetup();
      setup.distro = distro;
      setup.settings.plugins.push_back({"inflation_layer", inflationLayer(1.0)});
      setup.settings.parameters.footprint = "[[1, 1], [-1, 1], [-1, -1], [1, -1]]";
      LayeredCostmap costmap(setup);
      costmap.updateNow(at({0.0, 0.0}, 0.0));
      QCOMPARE(count(costmap.costmap(), kLethal), 20);
      const Costmap walls = costmapFromMap(setup.map, setup.settings.parameters, distro);
      int ring = 0;
      for (int row = 0; row < 10; ++row) {
        for (int column = 0; column < 10; ++column) {
          ring += nearestSquare(walls, {column, row}) == 1 ? 1 : 0;
        }
      }
      QCOMPARE(count(costmap.costmap(), kInscribed), ring);
      QCOMPARE(count(costmap.costmap(), kFreeSpace), 80 - ring);
      look(costmap, {0.0, 0.0}, {1.0, 9.0}, 0.1);
      QCOMPARE(int{costmap.costmap().at({1, 9})}, 254);
      QCOMPARE(int{costmap.costmap().at({0, 9})}, 253);
      QCOMPARE(int{costmap.costmap().at({2, 9})}, 253);
      look(costmap, {0.0, 0.0}, {0.0, 9.0}, 0.2);
      QCOMPARE(int{costmap.costmap().at({0, 9})}, 254);
    }
  }

  void costOfOccupancy_values_followTheRules_data() {
    QTest::addColumn<int>("occupancy");
    QTest::addColumn<int>("threshold");
    QTest::addColumn<bool>("isTrinary");
    QTest::addColumn<int>("tracked");    // with track_unknown_space
    QTest::addColumn<int>("untracked");  // without, Nav2 main
    QTest::newRow("free") << 0 << 100 << true << 0 << 0;
    QTest::newRow("occupied") << 100 << 100 << true << 254 << 254;
    QTest::newRow("unknown") << -1 << 100 << true << 255 << 0;
    QTest::newRow("trinary") << 50 << 100 << true << 0 << 0;
    QTest::newRow("at the threshold") << 65 << 65 << true << 254 << 254;
    QTest::newRow("below it") << 64 << 65 << true << 0 << 0;
    QTest::newRow("scaled") << 50 << 100 << false << 127 << 127;
    QTest::newRow("scaled to a threshold") << 13 << 65 << false << 50 << 50;  // 254 * 0.2 = 50.8
    QTest::newRow("inscribed in main") << 99 << 100 << false << 251 << 253;   // 251.46
    QTest::newRow("threshold too high") << 99 << 300 << true << 0 << 253;
  }

  void costOfOccupancy_values_followTheRules() {
    QFETCH(int, occupancy);
    QFETCH(int, threshold);
    QFETCH(bool, isTrinary);
    QFETCH(int, tracked);
    QFETCH(int, untracked);
    CostmapParameters parameters;
    parameters.lethalCostThreshold = threshold;
    parameters.trinaryCostmap = isTrinary;
    parameters.trackUnknownSpace = true;
    const auto value = static_cast<std::int8_t>(occupancy);
    QCOMPARE(int{costOfOccupancy(value, parameters, Distro::Humble)}, tracked);
    parameters.trackUnknownSpace = false;
    QCOMPARE(int{costOfOccupancy(value, parameters, Distro::Main)}, untracked);
  }

  /// A second static layer: true copies overwrite, unknown included; the maximum does not.
  void update_useMaximum_neverLowers() {
    CostmapSetup setup = plainSetup(3);
    setup.map = gridOf({"#.?"});
    setup.settings.parameters.trackUnknownSpace = true;
    ObservationSource source = farSource();
    source.clearing = false;
    setup.settings.plugins = {{"obstacle_layer", obstacleLayer(source)},
                              {"static_layer", StaticLayerParameters{}}};
    LayeredCostmap copy(setup);
    setup.settings.parameters.useMaximum = true;
    LayeredCostmap maximum(setup);
    for (LayeredCostmap* costmap : {&copy, &maximum}) {
      look(*costmap, {0.5, 0.5}, {1.5, 0.5}, 0.0);
      look(*costmap, {0.5, 0.5}, {2.5, 0.5}, 0.1);
    }
    QCOMPARE(rowOf(copy.costmap(), 0), std::string("#.?"));
    QCOMPARE(rowOf(maximum.costmap(), 0), std::string("###"));
  }

  void update_turnedMap_isSampled() {
    CostmapSetup setup = plainSetup(5);
    // A quarter turn: columns go up, rows to the left.
    setup.map = OccupancyGrid(3, 2, 1.0, {{10.0, 20.0}, base::kPi / 2.0}, {100, 0, 0, 0, 0, 100});
    setup.settings.parameters.trackUnknownSpace = true;
    setup.settings.plugins = {{"static_layer", StaticLayerParameters{}}};
    LayeredCostmap costmap(setup);
    costmap.updateNow(at({9.0, 21.0}, 0.0));
    QCOMPARE(costmap.costmap().width(), 2);
    QCOMPARE(costmap.costmap().height(), 3);
    QVERIFY((costmap.costmap().origin() - Vec2(8.0, 20.0)).norm() < 1e-9);
    QCOMPARE(rowOf(costmap.costmap(), 0), std::string(".#"));
    QCOMPARE(rowOf(costmap.costmap(), 1), std::string(".."));
    QCOMPARE(rowOf(costmap.costmap(), 2), std::string("#."));

    setup.map = OccupancyGrid(2, 2, 1.0, {{0.0, 0.0}, base::kPi / 4.0}, {100, 100, 100, 100});
    LayeredCostmap diamond(setup);
    diamond.updateNow(at({0.0, 1.0}, 0.0));
    QCOMPARE(int{diamond.costmap().at({0, 0})}, 255);  // off the map
    QCOMPARE(int{diamond.costmap().at({1, 1})}, 254);
  }

  void update_staticFootprint_isClearedAsTheDistroDoes() {
    StaticLayerParameters parameters;
    parameters.footprintClearingEnabled = true;
    CostmapSetup setup = plainSetup(9);
    setup.map = filled(9, 100);
    setup.settings.parameters.footprint = "[[0.9, 0.9], [-0.9, 0.9], [-0.9, -0.9], [0.9, -0.9]]";
    setup.settings.plugins = {{"static_layer", parameters}};
    const auto freeCells = [&setup](Distro distro, bool isRestored) {
      std::get<StaticLayerParameters>(setup.settings.plugins[0].parameters)
          .restoreClearedFootprint = isRestored;
      setup.distro = distro;
      LayeredCostmap costmap(setup);
      costmap.updateNow(at({2.5, 2.5}, 0.0));
      const int first = count(costmap.costmap(), kFreeSpace);
      costmap.clearEntirely();  // so that the whole map is written anew
      costmap.updateNow(at({6.5, 6.5}, 0.1));
      return std::make_pair(first, count(costmap.costmap(), kFreeSpace));
    };
    QVERIFY(freeCells(Distro::Humble, true) == std::make_pair(9, 18));
    QVERIFY(freeCells(Distro::Jazzy, true) == std::make_pair(9, 18));
    QVERIFY(freeCells(Distro::Kilted, true) == std::make_pair(9, 9));
    QVERIFY(freeCells(Distro::Main, true) == std::make_pair(9, 9));
    QVERIFY(freeCells(Distro::Main, false) == std::make_pair(9, 18));
  }

  void update_rolling_samplesTheMap() {
    CostmapSetup setup = rollingSetup();
    setup.settings.parameters.resolution = 0.5;
    setup.map = gridOf({"...#", "....", "#..."});
    setup.settings.plugins = {{"static_layer", StaticLayerParameters{}}};
    LayeredCostmap costmap(setup);
    costmap.updateNow(at({2.0, 2.0}, 0.0));  // 8 x 8 cells from (0.125 -> 0, 0)
    QCOMPARE(costmap.costmap().width(), 8);
    QVERIFY(costmap.costmap().origin() == Vec2(0.0, 0.0));
    // As in Nav2 the bounds begin at the centre of the map's first cell.
    QCOMPARE(rowOf(costmap.costmap(), 0), std::string("........"));
    QCOMPARE(rowOf(costmap.costmap(), 1), std::string(".#......"));
    QCOMPARE(rowOf(costmap.costmap(), 2), std::string("........"));
    QCOMPARE(rowOf(costmap.costmap(), 5), std::string("......##"));
    QCOMPARE(rowOf(costmap.costmap(), 6), std::string("........"));  // off the map: left alone
  }

  void moveOrigin_shift_isTruncatedToCells() {
    Costmap costmap(3, 2, 0.5, {1.0, 1.0});
    for (int i = 0; i < 6; ++i) {
      costmap.costs()[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(i + 1);
    }
    moveOrigin(costmap, {1.49, 0.51}, 9);  // less than a cell either way
    QVERIFY(costmap.origin() == Vec2(1.0, 1.0));
    QVERIFY(costmap.costs() == std::vector<std::uint8_t>({1, 2, 3, 4, 5, 6}));
    moveOrigin(costmap, {1.6, 0.3}, 9);  // one to the right, one down
    QVERIFY(costmap.origin() == Vec2(1.5, 0.5));
    QVERIFY(costmap.costs() == std::vector<std::uint8_t>({9, 9, 9, 2, 3, 9}));
    moveOrigin(costmap, {-100.0, 0.5}, 7);
    QVERIFY(costmap.costs() == std::vector<std::uint8_t>(6, 7));
    QVERIFY(nav2SizeOf(costmap) == Vec2(1.25, 0.75));
  }

  void update_rolling_keepsWhatStaysInside() {
    CostmapSetup setup = rollingSetup();
    setup.settings.plugins = {{"obstacle_layer", obstacleLayer()}};
    setup.settings.plugins[0].parameters = obstacleLayer(newestSource());
    LayeredCostmap costmap(setup);
    const LaserScan scan = beamTo({2.5, 2.5}, {3.5, 3.5}, 0.0);
    costmap.updateNow(at({2.5, 2.5}, 0.0, &scan));  // (0.75, 0.75) -> 0
    QVERIFY(costmap.costmap().origin() == Vec2(0.0, 0.0));
    QCOMPARE(rowOf(costmap.costmap(), 3), std::string("...#"));
    const LaserScan other = beamTo({4.5, 2.5}, {4.6, 2.5}, 0.1);
    costmap.updateNow(at({4.5, 2.5}, 0.1, &other));
    QVERIFY(costmap.costmap().origin() == Vec2(2.0, 0.0));
    QCOMPARE(rowOf(costmap.costmap(), 3), std::string(".#.."));
    QCOMPARE(rowOf(costmap.costmap(), 2), std::string("..#."));
    const LaserScan last = beamTo({6.5, 2.5}, {6.6, 2.5}, 0.2);
    costmap.updateNow(at({6.5, 2.5}, 0.2, &last));  // the first mark has left
    QCOMPARE(rowOf(costmap.costmap(), 3), std::string("...."));
    const LaserScan back = beamTo({4.5, 2.5}, {4.6, 2.5}, 0.3);
    costmap.updateNow(at({4.5, 2.5}, 0.3, &back));  // and is forgotten
    QCOMPARE(rowOf(costmap.costmap(), 3), std::string("...."));
  }

  void windowOf_bounds_areCellsWithBothEnds() {
    const Costmap costmap(10, 8, 0.5, {-1.0, -1.0});
    CostmapBounds bounds;
    bounds.touch({0.2, 0.6});
    bounds.touch({1.2, 0.6});
    CellWindow window = windowOf(costmap, bounds);
    QCOMPARE(window.left, 2);
    QCOMPARE(window.right, 5);
    QCOMPARE(window.bottom, 3);
    QCOMPARE(window.top, 4);
    window = windowOf(costmap, unboundedBounds());
    QVERIFY(window.left == 0 && window.bottom == 0 && window.right == 10 && window.top == 8);
    window = windowOf(costmap, {});
    QVERIFY(window.left == window.right);
    QVERIFY((nearestCell(costmap, {4.0, 3.0}) == Cell{9, 7}));  // on the upper border
  }

  void fillPolygon_triangle_fillsItsColumns() {
    for (const bool isReversed : {false, true}) {
      Polygon triangle = {{1.5, 1.5}, {5.5, 1.5}, {1.5, 5.5}};
      if (isReversed) {
        std::reverse(triangle.begin(), triangle.end());
      }
      Costmap costmap(8, 8, 1.0, {0.0, 0.0});
      fillPolygon(costmap, triangle, 9);
      QCOMPARE(count(costmap, 9), 15);  // columns of 5, 4, 3, 2, 1
      for (int column = 1; column <= 5; ++column) {
        QCOMPARE(int{costmap.at({column, 6 - column})}, 9);
        QCOMPARE(int{costmap.at({column, 7 - column})}, 0);
      }
    }
    Costmap costmap(8, 8, 1.0, {0.0, 0.0});
    fillPolygon(costmap, {{1.5, 1.5}, {8.5, 1.5}, {1.5, 5.5}}, 9);  // a corner off the map
    fillPolygon(costmap, {{1.5, 1.5}, {5.5, 1.5}}, 9);
    QCOMPARE(count(costmap, 0), 64);
  }

  /// Steps 3 and 4 of the cycle: what no layer touches is not even reset.
  void update_outsideTheWindow_keepsOldCosts() {
    CostmapSetup setup = plainSetup(10);
    setup.map = tenByTen();
    setup.settings.plugins = {{"static_layer", StaticLayerParameters{}},
                              {"obstacle_layer", obstacleLayer(newestSource())}};
    LayeredCostmap costmap(setup);
    costmap.updateNow(at({0.0, 0.0}, 0.0));
    costmap.clearEntirely();
    QCOMPARE(count(costmap.costmap(), kLethal), 0);
    // The static layer, reset, gives the whole map once; then only the beams' window is written.
    look(costmap, {0.5, 0.5}, {3.5, 0.5}, 0.1);
    QCOMPARE(count(costmap.costmap(), kLethal), 21);
    const Costmap before = costmap.costmap();
    look(costmap, {0.5, 9.5}, {3.5, 9.5}, 0.2);
    QCOMPARE(int{costmap.costmap().at({3, 9})}, 254);
    QCOMPARE(int{costmap.costmap().at({3, 0})}, 254);
  }

  void update_times_areCountedInWholes_data() {
    QTest::addColumn<double>("frequency");
    QTest::addColumn<int>("updates");  // in 400 steps of 0.05 s
    QTest::newRow("5 Hz") << 5.0 << 100;
    QTest::newRow("1 Hz") << 1.0 << 20;
    QTest::newRow("20 Hz") << 20.0 << 400;
    QTest::newRow("3 Hz") << 3.0 << 60;
    QTest::newRow("7.5 Hz") << 7.5 << 150;
    QTest::newRow("faster than steps") << 50.0 << 400;
  }

  void update_times_areCountedInWholes() {
    QFETCH(double, frequency);
    QFETCH(int, updates);
    CostmapSetup setup = plainSetup(2);
    setup.settings.parameters.updateFrequency = frequency;
    LayeredCostmap costmap(setup);
    int made = 0;
    for (int step = 0; step < 400; ++step) {
      // floor(t f) increases, in whole numbers: f is a multiple of 0.5, t of 0.05.
      const int doubled = static_cast<int>(2.0 * frequency);
      const bool isDue = step == 0 || step * doubled / 40 > (step - 1) * doubled / 40;
      const bool isMade = costmap.update(at({0.0, 0.0}, 0.05 * step));
      QCOMPARE(isMade, isDue);
      made += isMade ? 1 : 0;
    }
    QCOMPARE(made, updates);
    QCOMPARE(static_cast<int>(costmap.updates()), updates);
  }

  /// Updates at 5 Hz, copies at 2 Hz: at 0, 0.6 (first update after 0.5), 1.0, 1.6, 2.0 s.
  void published_copy_isOldAsItsRate() {
    CostmapSetup setup = plainSetup(40);
    setup.settings.parameters.publishFrequency = 2.0;
    setup.settings.plugins = {{"obstacle_layer", obstacleLayer()}};
    LayeredCostmap costmap(setup);
    setup.settings.parameters.publishFrequency = 0.0;
    LayeredCostmap never(setup);
    std::vector<int> copied;
    int before = 0;
    for (int step = 0; step <= 40; ++step) {  // a mark more at each step
      const LaserScan scan = beamTo({0.5, step * 0.9}, {20.5, step * 0.9 + 0.5}, 0.05 * step);
      costmap.update(at({0.0, 0.0}, 0.05 * step, &scan));
      never.update(at({0.0, 0.0}, 0.05 * step, &scan));
      const int marks = count(costmap.published(), kLethal);
      if (marks != before) {
        copied.push_back(step);
        QCOMPARE(marks, count(costmap.costmap(), kLethal));
      }
      before = marks;
      QVERIFY(never.published().costs() == never.costmap().costs());
    }
    QVERIFY(copied == std::vector<int>({0, 12, 20, 32, 40}));
  }

  void update_obstacleGone_deflates() {
    for (const Distro distro : {Distro::Humble, Distro::Main}) {
      CostmapSetup setup = plainSetup(12);
      setup.distro = distro;
      setup.settings.plugins = {{"obstacle_layer", obstacleLayer(newestSource())},
                                {"inflation_layer", inflationLayer(3.0)}};
      LayeredCostmap costmap(setup);
      look(costmap, {0.5, 5.5}, {5.5, 5.5}, 0.0);
      QCOMPARE(144 - count(costmap.costmap(), kFreeSpace), 29);
      look(costmap, {0.5, 5.5}, {11.5, 5.5}, 0.1);
      QCOMPARE(int{costmap.costmap().at({5, 5})}, 0);
      // Half of the disc at the right border: columns 8 to 11 hold 1 + 5 + 5 + 7 of its 29.
      QCOMPARE(144 - count(costmap.costmap(), kFreeSpace), 18);
    }
  }

  void clearEntirely_costs_areGoneAtOnceAndComeBack() {
    CostmapSetup setup = tenByTenSetup();
    setup.settings.plugins[1].parameters = obstacleLayer(newestSource());
    setup.settings.plugins.push_back({"inflation_layer", inflationLayer(1.0)});
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {3.5, 0.5}, 0.0);
    look(costmap, {0.5, 3.5}, {4.5, 3.5}, 0.1);
    QCOMPARE(count(costmap.costmap(), kLethal), 22);
    QVERIFY(costmap.isCurrent());
    costmap.clearEntirely();
    QVERIFY(!costmap.isCurrent());
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 100);
    costmap.updateNow(at({0.0, 0.0}, 0.2));
    QVERIFY(costmap.isCurrent());
    // The map is back, and what the last scan saw; what the one before saw is forgotten.
    QCOMPARE(count(costmap.costmap(), kLethal), 21);
    QCOMPARE(int{costmap.costmap().at({4, 3})}, 254);
  }

  void clearEntirely_unknownTracked_isUnknown() {
    CostmapSetup setup = plainSetup(4);
    setup.settings.parameters.trackUnknownSpace = true;
    setup.settings.plugins = {{"obstacle_layer", obstacleLayer()}};
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {3.5, 0.5}, 0.0);
    costmap.clearEntirely();
    QCOMPARE(count(costmap.costmap(), kNoInformation), 16);
  }

  void clearAround_square_isForgottenWithTheNextUpdate() {
    LayeredCostmap costmap = markedRow();
    look(costmap, {0.5, 0.5}, {9.5, 9.5}, 2.0);
    QCOMPARE(rowOf(costmap.costmap(), 5), std::string("##########"));
    QVERIFY(costmap.clearAround({5.5, 5.5}, 4.0));  // cells 3 to 7, both not included
    QVERIFY(!costmap.isCurrent());
    QCOMPARE(rowOf(costmap.costmap(), 5), std::string("##########"));
    QCOMPARE(rowOf(*costmap.layer("obstacle_layer")->grid(), 5), std::string("####???###"));
    costmap.updateNow(at({0.0, 0.0}, 2.1));
    QCOMPARE(rowOf(costmap.costmap(), 5), std::string("####...###"));
    QVERIFY(costmap.isCurrent());
  }

  void clearExcept_square_isAllThatStays() {
    LayeredCostmap costmap = markedRow();
    QVERIFY(costmap.clearExcept({5.5, 5.5}, 4.0));
    costmap.updateNow(at({0.0, 0.0}, 2.1));
    QCOMPARE(rowOf(costmap.costmap(), 5), std::string("....###..#"));  // the last scan marks again
  }

  void clearAround_names_restrictOrFail() {
    LayeredCostmap costmap(otherLayerSetup());
    look(costmap, {0.5, 0.5}, {1.5, 0.5}, 0.0);
    const auto marks = [&costmap](const char* layer) {
      return count(*costmap.layer(layer)->grid(), kLethal);
    };
    QVERIFY(!costmap.clearAround({1.5, 0.5}, 50.0, {"obstacle_layer", "no_layer"}));
    QVERIFY(!costmap.clearAround({1.5, 0.5}, 50.0, {"static_layer"}));
    QCOMPARE(marks("obstacle_layer") + marks("other_layer"), 2);
    QVERIFY(costmap.clearExcept({8.5, 8.5}, 1.0, {"other_layer"}));
    QCOMPARE(marks("obstacle_layer"), 1);
    QCOMPARE(marks("other_layer"), 0);
    QCOMPARE(count(*costmap.layer("static_layer")->grid(), kLethal), 20);
  }

  void clearEntirely_names_forgetThoseLayers() {
    LayeredCostmap costmap(otherLayerSetup());
    look(costmap, {0.5, 0.5}, {0.5, 0.5}, 0.0);  // the cell that the empty square lies in
    look(costmap, {0.5, 3.5}, {1.5, 3.5}, 0.1);
    QVERIFY(!costmap.clearEntirely({"static_layer"}));
    QVERIFY(costmap.clearEntirely({"other_layer"}));
    QCOMPARE(count(*costmap.layer("other_layer")->grid(), kNoInformation), 100);
    QCOMPARE(count(*costmap.layer("obstacle_layer")->grid(), kLethal), 2);
    QCOMPARE(count(costmap.costmap(), kLethal), 22);
    QVERIFY(!costmap.isCurrent());
  }

  /// What comes after the inflation is not inflated.
  void update_order_isThatOfTheList() {
    CostmapSetup setup = plainSetup(9);
    setup.settings.plugins = {{"inflation_layer", inflationLayer(2.0)},
                              {"obstacle_layer", obstacleLayer()}};
    LayeredCostmap after(setup);
    std::swap(setup.settings.plugins[0], setup.settings.plugins[1]);
    LayeredCostmap before(setup);
    for (int i = 0; i < 2; ++i) {
      look(after, {0.5, 4.5}, {4.5, 4.5}, 0.1 * i);
      look(before, {0.5, 4.5}, {4.5, 4.5}, 0.1 * i);
    }
    QCOMPARE(81 - count(after.costmap(), kFreeSpace), 1);
    QCOMPARE(81 - count(before.costmap(), kFreeSpace), 13);
  }

  void update_keepout_raisesCostsOnTheCombinedCopy() {
    CostmapSetup setup = plainSetup(6);
    setup.map = gridOf({"#.....", "......"});
    setup.settings.plugins = {{"static_layer", StaticLayerParameters{}},
                              {"inflation_layer", inflationLayer(1.0)}};
    setup.settings.parameters.footprint = "[[1, 1], [-1, 1], [-1, -1], [1, -1]]";
    setup.settings.filters = {{"keepout_filter", KeepoutFilterParameters{}}};
    setup.masks["keepout_filter"].grid = gridOf({"??5.#?", "55...."});
    LayeredCostmap costmap(setup);
    for (int i = 0; i < 2; ++i) {  // the zone is not inflated by the second update either
      costmap.clearEntirely();
      costmap.updateNow(at({3.0, 1.0}, 0.1 * i));
      QCOMPARE(int{costmap.costmap().at({0, 1})}, 254);
      QCOMPARE(int{costmap.costmap().at({1, 1})}, 253);
      QCOMPARE(int{costmap.costmap().at({2, 1})}, 127);  // 50 percent of 254
      QCOMPARE(int{costmap.costmap().at({4, 1})}, 254);
      QCOMPARE(int{costmap.costmap().at({3, 1})}, 0);
      QCOMPARE(int{costmap.costmap().at({5, 1})}, 0);
      QCOMPARE(int{costmap.costmap().at({0, 0})}, 253);  // more than 127
      QCOMPARE(int{costmap.costmap().at({1, 0})}, 127);
    }
    std::get<KeepoutFilterParameters>(setup.settings.filters[0].parameters).enabled = false;
    LayeredCostmap off(setup);
    off.updateNow(at({3.0, 1.0}, 0.0));
    QCOMPARE(count(off.costmap(), kLethal), 1);
  }

  void update_keepoutOverride_letsTheRobotOut() {
    CostmapSetup setup = plainSetup(6);
    KeepoutFilterParameters parameters;
    parameters.overrideLethalCost = true;
    setup.distro = Distro::Jazzy;
    setup.settings.filters = {{"keepout_filter", parameters}};
    setup.masks["keepout_filter"].grid = gridOf({"##....", "##...."});
    LayeredCostmap costmap(setup);
    costmap.updateNow(at({1.5, 1.5}, 0.0));
    QCOMPARE(count(costmap.costmap(), 252), 4);
    QCOMPARE(count(costmap.costmap(), kLethal), 0);
    costmap.updateNow(at({3.5, 1.5}, 0.1));  // out: closed again
    QCOMPARE(count(costmap.costmap(), kLethal), 4);
    setup.distro = Distro::Humble;  // has no such key
    LayeredCostmap humble(setup);
    humble.updateNow(at({1.5, 1.5}, 0.0));
    QCOMPARE(count(humble.costmap(), kLethal), 4);
  }

  void update_speedFilter_setsLimits() {
    CostmapSetup setup = plainSetup(6);
    setup.settings.filters = {{"speed_filter", SpeedFilterParameters{}}};
    FilterMask& mask = setup.masks["speed_filter"];
    mask.grid = gridOf({"5?.9##"});
    mask.base = 100.0;
    mask.multiplier = -1.0;
    LayeredCostmap costmap(setup);
    QVERIFY((costmap.speedLimit() == SpeedLimit{0.0, true}));
    const auto limitAt = [&costmap](double x) {
      costmap.updateNow(at({x, 0.5}, 0.0));
      return costmap.speedLimit().value;
    };
    QCOMPARE(limitAt(0.5), 50.0);
    QCOMPARE(limitAt(1.5), 50.0);  // unknown: as it was
    QCOMPARE(limitAt(2.5), 0.0);   // none
    QCOMPARE(limitAt(3.5), 10.0);
    QCOMPARE(limitAt(9.5), 10.0);  // off the mask
    mask.isPercentage = false;
    mask.base = 0.0;
    mask.multiplier = 0.01;
    LayeredCostmap metres(setup);
    metres.updateNow(at({0.5, 0.5}, 0.0));
    QVERIFY((metres.speedLimit() == SpeedLimit{0.5, false}));
  }

  void inflation_byName_isThatLayers() {
    CostmapSetup setup = plainSetup(4);
    QVERIFY(!LayeredCostmap(setup).inflation());
    setup.settings.plugins = {{"near", inflationLayer(1.0, 2.0)},
                              {"far", inflationLayer(3.0, 4.0)}};
    setup.settings.parameters.robotRadius = 0.22;
    setup.settings.parameters.footprintPadding = 0.01;
    const LayeredCostmap costmap(setup);
    QCOMPARE(costmap.inflation()->radius, 1.0);
    QCOMPARE(costmap.inflation("far")->scaling, 4.0);
    QVERIFY(std::fabs(costmap.inflation()->inscribed - 0.22550) < 1e-5);
    QVERIFY(!costmap.inflation("none"));
  }

  void footprint_unreadable_fallsBackToTheRadius() {
    CostmapSetup setup = plainSetup(4);
    setup.settings.parameters.footprint = "[[bad_string";
    setup.settings.parameters.robotRadius = 0.5;
    const LayeredCostmap costmap(setup);
    QVERIFY(costmap.footprint().isRadius);
    QCOMPARE(costmap.footprint().corners[0].x(), 0.5);
  }

  void problemsOf_settings_areAllTold() {
    CostmapSetup setup;
    setup.settings.plugins = {{"static_layer", StaticLayerParameters{}},
                              {"obstacle_layer", ObstacleLayerParameters{}},
                              {"inflation_layer", InflationLayerParameters{}}};
    const auto codesOf = [](const base::Diagnostics& problems) {
      std::set<std::string> codes;
      for (const base::Diagnostic& problem : problems) {
        codes.insert(std::string(problem.code));
      }
      return codes;
    };
    QVERIFY(codesOf(problemsOf(setup)) == std::set<std::string>({"nav2.no-map", "nav2.no-source"}));
    setup.settings.parameters.resolution = 0.0;
    setup.settings.parameters.updateFrequency = 0.0;
    setup.settings.parameters.footprint = "[[1, 2]]";
    setup.settings.parameters.robotRadius = 1.0;
    ObservationSource source;
    source.dataType = "PointCloud2";
    SocialLayerParameters social;
    social.cutoff = 0.0;
    setup.settings.plugins = {{"obstacle_layer", obstacleLayer(source)},
                              {"inflation_layer", inflationLayer(0.5)},
                              {"social_layer", social}};
    setup.settings.filters = {{"keepout_filter", KeepoutFilterParameters{}}};
    base::Diagnostics problems = problemsOf(setup);
    const std::set<std::string> codes = codesOf(problems);
    for (const char* code :
         {"nav2.polygon-too-small", "nav2.lidar-not-taken", "nav2.data-type", "nav2.no-mask"}) {
      QVERIFY2(codes.count(code) == 1, code);
    }
    QVERIFY(codes.count("nav2.inflation-cut") == 0);  // the footprint is wrong, not the radius
    QVERIFY(base::hasErrors(problems));
    const auto told = [&problems](const char* key) {
      return std::any_of(problems.begin(), problems.end(), [key](const base::Diagnostic& problem) {
        return problem.message.find(key) != std::string::npos;
      });
    };
    QVERIFY(told("resolution") && told("update_frequency") && told("social_layer.cutoff"));
    setup.settings.parameters.footprint = "[]";
    problems = problemsOf(setup);
    QVERIFY(told("inflation_layer.inflation_radius: 0.5 m is less than the robot's inscribed"));
    setup.settings.parameters.resolution = 5.0;
    setup.settings.parameters.width = 9;
    setup.settings.parameters.height = 4;
    problems = problemsOf(setup);
    QVERIFY(told("resolution: a cell of 5 m is larger than the costmap (height 4 m)"));
    QVERIFY(!told("width"));
  }

  void layerOfType_names_goBothWays() {
    std::size_t index = 0;
    for (const std::string& type : layerTypes()) {
      QCOMPARE(layerOfType(type)->index(), index++);
    }
    QVERIFY(
        std::holds_alternative<VoxelLayerParameters>(*layerOfType("nav2_costmap_2d::VoxelLayer")));
    QVERIFY(!layerOfType("spatio_temporal_voxel_layer/SpatioTemporalVoxelLayer"));
  }

  void keys_tables_haveDifferentNames() {
    const auto areDifferent = [](const auto& keys) {
      std::set<std::string> names;
      for (const auto& key : keys) {
        names.insert(key.name);
      }
      return !names.empty() && names.size() == keys.size();
    };
    QVERIFY(areDifferent(costmapKeys()));
    QVERIFY(areDifferent(keysOf(StaticLayerParameters())));
    QVERIFY(areDifferent(observationSourceKeys()));
    QVERIFY(areDifferent(keysOf(ObstacleLayerParameters())));
    QVERIFY(areDifferent(keysOf(VoxelLayerParameters())));
    QVERIFY(areDifferent(keysOf(InflationLayerParameters())));
    QVERIFY(areDifferent(keysOf(SocialLayerParameters())));
    QVERIFY(areDifferent(ignoredCostmapKeys()));
    QVERIFY(areDifferent(ignoredLayerKeys()));
    VoxelLayerParameters voxels;  // a key of the base has its member
    for (const Nav2Key<VoxelLayerParameters>& key : keysOf(VoxelLayerParameters())) {
      if (std::string(key.name) == "combination_method") {
        voxels.*std::get<int VoxelLayerParameters::*>(key.member) = 2;
      }
    }
    QCOMPARE(voxels.combinationMethod, 2);
  }

  /// As declared in costmap_2d_ros.cpp, obstacle_layer.cpp, voxel_layer.cpp and
  /// inflation_layer.cpp.
  void keys_defaults_areThoseOfNav2sCode() {
    const auto textOf = [](const auto& keys, const auto& defaults) {
      Nav2KeyTable rows;
      addKeyRows(rows, keys, defaults);
      std::string text;
      for (const Nav2KeyTable::Row& row : rows.rows) {
        text += row.name + " ";
        if (const auto* const real = std::get_if<double>(&row.fallback)) {
          text += base::formatDouble(*real) + " m; ";
        } else if (const auto* const whole = std::get_if<int>(&row.fallback)) {
          text += std::to_string(*whole) + "; ";
        } else if (const auto* const flag = std::get_if<bool>(&row.fallback)) {
          text += *flag ? "true; " : "false; ";
        } else if (const auto* const word = std::get_if<std::string>(&row.fallback)) {
          text += "'" + *word + "'; ";
        } else {
          text += base::join(std::get<std::vector<std::string>>(row.fallback), ",") + "; ";
        }
      }
      return text;
    };
    QCOMPARE(
        textOf(costmapKeys(), CostmapParameters()),
        std::string(
            "update_frequency 5 m; publish_frequency 1 m; width 5; height 5; "
            "resolution 0.1 m; origin_x 0 m; origin_y 0 m; rolling_window false; "
            "global_frame 'map'; track_unknown_space false; robot_radius 0.1 m; footprint '[]'; "
            "footprint_padding 0.01 m; plugins static_layer,obstacle_layer,"
            "inflation_layer; filters ; unknown_cost_value 255; "
            "lethal_cost_threshold 100; trinary_costmap true; "
            "inscribed_obstacle_cost_value 99; use_maximum false; "));
    QCOMPARE(textOf(observationSourceKeys(), ObservationSource()),
             std::string("topic ''; data_type 'LaserScan'; observation_persistence 0 m; "
                         "expected_update_rate 0 m; min_obstacle_height 0 m; max_obstacle_height 0 "
                         "m; inf_is_valid false; marking true; clearing false; obstacle_max_range "
                         "2.5 m; obstacle_min_range 0 m; raytrace_max_range 3 m; "
                         "raytrace_min_range 0 m; "));
    QCOMPARE(textOf(keysOf(VoxelLayerParameters()), VoxelLayerParameters()),
             std::string("enabled true; footprint_clearing_enabled true; min_obstacle_height 0 m; "
                         "max_obstacle_height 2 m; combination_method 1; observation_sources ''; "
                         "origin_z 0 m; z_resolution 0.2 m; z_voxels 10; mark_threshold 0; "));
    QCOMPARE(textOf(keysOf(InflationLayerParameters()), InflationLayerParameters()),
             std::string("enabled true; inflation_radius 0.55 m; cost_scaling_factor 10 m; "
                         "inflate_unknown false; inflate_around_unknown false; "
                         "custom_inscribed_radius -1 m; "));
    QCOMPARE(textOf(keysOf(StaticLayerParameters()), StaticLayerParameters()),
             std::string("enabled true; footprint_clearing_enabled false; "
                         "restore_cleared_footprint true; "));
    QCOMPARE(textOf(keysOf(KeepoutFilterParameters()), KeepoutFilterParameters()),
             std::string("enabled true; override_lethal_cost false; lethal_override_cost 252; "
                         "filter_info_topic ''; mask_file ''; "));  // the last is ours
  }

  void twoCostmaps_shareNothing() {
    LayeredCostmap one(tenByTenSetup()), other(tenByTenSetup());
    look(one, {0.5, 0.5}, {3.5, 0.5}, 0.0);
    other.updateNow(at({0.0, 0.0}, 0.0));
    QCOMPARE(count(one.costmap(), kLethal), 21);
    QCOMPARE(count(other.costmap(), kLethal), 20);
  }

  void move_costmap_goesOn() {
    LayeredCostmap one(tenByTenSetup());
    look(one, {0.5, 0.5}, {3.5, 0.5}, 0.0);
    LayeredCostmap other(std::move(one));
    look(other, {0.5, 0.5}, {4.5, 0.5}, 0.1);
    QCOMPARE(count(other.costmap(), kLethal), 22);
  }
};

QTEST_APPLESS_MAIN(LayeredCostmapTest)
#include "tst_LayeredCostmap.moc"
