#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/nav/CostmapScenes.h"

using namespace costmapscenes;

namespace {

CostmapSetup obstacleSetup(int side, const ObstacleLayerParameters& parameters,
                           double resolution = 1.0) {
  CostmapSetup setup = plainSetup(side, resolution);
  setup.settings.plugins = {{"obstacle_layer", parameters}};
  return setup;
}

const Costmap& gridOf(const LayeredCostmap& costmap) {
  return *costmap.layer("obstacle_layer")->grid();
}

/// Cells of a row of the layer's grid.
std::string rowText(const Costmap& costmap, int row) {
  std::string text;
  for (int column = 0; column < costmap.width(); ++column) {
    const int cost = costmap.at({column, row});
    text += cost == kLethal ? '#' : cost == kNoInformation ? '?' : '.';
  }
  return text;
}

}  // namespace

/// Vectors of nav2_costmap_2d: obstacle_tests.cpp; keys of a source, by hand.
class ObstacleLayerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Vector 45: one of the points at 0.4 m and 2.2 m is marked.
  void update_pointAboveTheLayer_isNotMarked_data() {
    QTest::addColumn<double>("height");
    QTest::addColumn<double>("least");  // of the layer
    QTest::addColumn<bool>("isHumble");
    QTest::addColumn<int>("lethal");
    QTest::newRow("0.4 m") << 0.4 << 0.0 << true << 1;
    QTest::newRow("2.2 m") << 2.2 << 0.0 << true << 0;
    QTest::newRow("2.0 m") << 2.0 << 0.0 << true << 1;
    QTest::newRow("too low") << 0.1 << 0.2 << false << 0;
    QTest::newRow("too low, humble has no such key") << 0.1 << 0.2 << true << 1;
  }

  void update_pointAboveTheLayer_isNotMarked() {
    QFETCH(double, height);
    QFETCH(double, least);
    QFETCH(bool, isHumble);
    QFETCH(int, lethal);
    ObstacleLayerParameters parameters = obstacleLayer();
    parameters.minObstacleHeight = least;
    CostmapSetup setup = obstacleSetup(10, parameters);
    setup.lidarHeight = height;
    setup.distro = isHumble ? Distro::Humble : Distro::Jazzy;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {5.5, 0.5}, 0.0);
    QCOMPARE(count(costmap.costmap(), kLethal), lethal);
  }

  void update_sourceHeights_dropPointsForMarkingAndClearing() {
    ObservationSource source;  // the code's: heights 0 to 0
    source.clearing = true;
    CostmapSetup setup = obstacleSetup(5, obstacleLayer(source));
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {2.5, 0.5}, 0.0);
    QCOMPARE(count(costmap.costmap(), kNoInformation), 25);
    setup.lidarHeight = 0.0;
    LayeredCostmap low(setup);
    look(low, {0.5, 0.5}, {2.5, 0.5}, 0.0);
    QCOMPARE(rowText(low.costmap(), 0), std::string("..#??"));
  }

  /// Vector 44, testWaveInterference.
  void update_threePoints_leaveRaysBetweenThem() {
    CostmapSetup setup = obstacleSetup(10, obstacleLayer());
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {3.5, 3.5}, 0.0);
    look(costmap, {0.5, 0.5}, {5.5, 5.5}, 0.1);
    look(costmap, {0.5, 0.5}, {7.5, 7.5}, 0.2);
    QCOMPARE(count(costmap.costmap(), kLethal), 3);
    QCOMPARE(count(costmap.costmap(), kNoInformation), 92);
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 5);
  }

  /// Vector 46: a mark in a map of unknown cells. Then over a static map, by hand.
  void update_combinationMethods_mergeAsTheirNumbersSay_data() {
    QTest::addColumn<int>("method");
    QTest::addColumn<int>("unknown");
    QTest::addColumn<QString>("overMap");  // the map "#.??" with marks at 1 and 2, a free cell at 0
    QTest::newRow("overwrite") << 0 << 99 << ".##?";
    QTest::newRow("maximum") << 1 << 99 << "###?";
    QTest::newRow("maximum of known") << 2 << 100 << "##??";
    QTest::newRow("no such method") << 3 << 100 << "#.??";
  }

  void update_combinationMethods_mergeAsTheirNumbersSay() {
    QFETCH(int, method);
    QFETCH(int, unknown);
    QFETCH(QString, overMap);
    ObservationSource source = farSource();
    source.clearing = false;
    ObstacleLayerParameters parameters = obstacleLayer(source);
    parameters.combinationMethod = method;
    CostmapSetup setup = obstacleSetup(10, parameters);
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {4.5, 4.5}, 0.0);
    QCOMPARE(count(costmap.costmap(), kNoInformation), unknown);

    parameters.sources[0].clearing = true;
    setup.settings.plugins = {{"static_layer", StaticLayerParameters{}},
                              {"obstacle_layer", parameters}};
    setup.map = costmapscenes::gridOf({"#.??", "????"});
    LayeredCostmap onMap(setup);
    look(onMap, {0.5, 1.5}, {2.5, 1.5}, 0.0);
    look(onMap, {0.5, 1.5}, {1.5, 1.5}, 0.1);
    QCOMPARE(QString::fromStdString(rowText(onMap.costmap(), 1)), overMap);
  }

  void update_ray_clearsWhatItPassesAndMarksItsEnd() {
    LayeredCostmap costmap(obstacleSetup(10, obstacleLayer(newestSource())));
    look(costmap, {0.5, 0.5}, {4.5, 0.5}, 0.0);
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("....#....."));
    look(costmap, {0.5, 0.5}, {7.5, 0.5}, 0.1);
    QCOMPARE(rowText(costmap.costmap(), 0), std::string(".......#.."));
    look(costmap, {0.5, 0.5}, {2.5, 0.5}, 0.2);  // what is behind stays
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("..#....#.."));
  }

  void update_obstacleRanges_boundMarks() {
    ObservationSource source = farSource();
    source.obstacleMaxRange = 4.0;
    source.obstacleMinRange = 2.0;
    LayeredCostmap costmap(obstacleSetup(10, obstacleLayer(source)));
    for (int i = 1; i < 8; ++i) {
      look(costmap, {0.5, i + 0.5}, {0.5 + i, i + 0.5}, 0.1 * i);
    }
    for (int i = 1; i < 8; ++i) {
      QCOMPARE(costmap.costmap().at({i, i}) == kLethal, i >= 2 && i <= 4);
    }
  }

  void update_raytraceRanges_boundClearing() {
    ObservationSource marking = farSource();
    marking.clearing = false;
    ObservationSource clearing = farSource();
    clearing.marking = false;
    clearing.observationPersistence = 0.0;
    clearing.raytraceMaxRange = 5.0;
    clearing.raytraceMinRange = 2.0;
    ObstacleLayerParameters parameters = obstacleLayer(clearing);
    CostmapSetup setup = obstacleSetup(10, parameters);
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    // The line begins 2 cells on; of its 7 steps to the end the share 5/9 is taken: 3 steps.
    look(costmap, {0.5, 0.5}, {9.5, 0.5}, 0.0);
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("??....????"));
    look(costmap, {0.5, 1.5}, {1.5, 1.5}, 0.1);  // nearer than the least range
    QCOMPARE(rowText(costmap.costmap(), 1), std::string("??????????"));
    look(costmap, {0.5, 2.5}, {4.5, 2.5}, 0.2);
    QCOMPARE(rowText(costmap.costmap(), 2), std::string("??...?????"));
  }

  void update_rayOffTheMap_isCutAtItsBorder() {
    CostmapSetup setup = obstacleSetup(6, obstacleLayer());
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {2.5, 2.5}, {50.5, 2.5}, 0.0);
    look(costmap, {2.5, 2.5}, {-50.5, 2.5}, 0.1);
    QCOMPARE(rowText(costmap.costmap(), 2), std::string("......"));
    look(costmap, {3.5, 3.5}, {3.5 + 20.0, 3.5 + 40.0}, 0.2);  // leaves by the top at x 4.75
    QCOMPARE(rowText(costmap.costmap(), 5), std::string("????.?"));
    QCOMPARE(count(costmap.costmap(), kLethal), 0);
  }

  void update_sensorOffTheMap_clearsNothing() {
    CostmapSetup setup = obstacleSetup(6, obstacleLayer());
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {-1.5, 2.5}, {3.5, 2.5}, 0.0);
    QCOMPARE(rowText(costmap.costmap(), 2), std::string("???#??"));
  }

  void update_infiniteBeams_clearOnlyWhenValid() {
    for (const bool isValid : {false, true}) {
      ObservationSource source = farSource();
      source.infIsValid = isValid;
      CostmapSetup setup = obstacleSetup(10, obstacleLayer(source));
      setup.settings.parameters.trackUnknownSpace = true;
      LayeredCostmap costmap(setup);
      LaserScan scan = beamTo({0.5, 0.5}, {6.5, 0.5}, 0.0);
      scan.range = 6.0;  // the beam has all of it: no hit
      costmap.updateNow(at({0.0, 0.0}, 0.0, &scan));
      // The end lies 1e-4 m before 6.5; being a point it is marked, as nav2 does.
      QCOMPARE(rowText(costmap.costmap(), 0), std::string(isValid ? "......#???" : "??????????"));
    }
  }

  /// A person walks across; rays that meet nothing clear nothing, so its trail stays.
  void update_turnAwayAndBack_leavesATrail() {
    LayeredCostmap costmap(obstacleSetup(10, obstacleLayer(newestSource())));
    for (int i = 0; i < 5; ++i) {
      look(costmap, {4.5, 0.5}, {2.5 + i, 6.5}, 0.1 * i);
    }
    QCOMPARE(rowText(costmap.costmap(), 6), std::string("..#####..."));
    look(costmap, {4.5, 0.5}, {4.5, 9.5}, 1.0);
    QCOMPARE(rowText(costmap.costmap(), 6), std::string("..##.##..."));
  }

  void update_persistence_keepsScansForItsTime() {
    ObservationSource source = farSource();
    source.observationPersistence = 0.5;
    LayeredCostmap costmap(obstacleSetup(10, obstacleLayer(source)));
    look(costmap, {0.5, 0.5}, {4.5, 0.5}, 0.0);
    look(costmap, {0.5, 0.5}, {8.5, 0.5}, 0.5);  // clears the first mark, which is marked again
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("....#...#."));
    costmap.updateNow(at({0.0, 0.0}, 0.55));
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("........#."));
    costmap.clearEntirely();
    costmap.updateNow(at({0.0, 0.0}, 1.0));
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("........#."));
    costmap.clearEntirely();
    costmap.updateNow(at({0.0, 0.0}, 1.05));
    QCOMPARE(rowText(costmap.costmap(), 0), std::string(".........."));
  }

  void update_zeroPersistence_keepsTheNewestScan() {
    LayeredCostmap costmap(obstacleSetup(10, obstacleLayer(newestSource())));
    const LaserScan first = beamTo({0.5, 0.5}, {4.5, 0.5}, 0.0);
    const LaserScan second = beamTo({0.5, 1.5}, {4.5, 1.5}, 0.05);
    costmap.update(at({0.0, 0.0}, 0.0));  // without a scan
    costmap.update(at({0.0, 0.0}, 0.05, &first));
    costmap.update(at({0.0, 0.0}, 0.10, &second));
    costmap.updateNow(at({0.0, 0.0}, 50.0));
    QCOMPARE(rowText(costmap.costmap(), 0), std::string(".........."));
    QCOMPARE(rowText(costmap.costmap(), 1), std::string("....#....."));
  }

  void update_footprint_isCleared() {
    ObstacleLayerParameters parameters = obstacleLayer();
    CostmapSetup setup = obstacleSetup(10, parameters);
    setup.settings.parameters.footprint = "[[1.5, 1.5], [-1.5, 1.5], [-1.5, -1.5], [1.5, -1.5]]";
    LayeredCostmap without(setup);
    std::get<ObstacleLayerParameters>(setup.settings.plugins[0].parameters)
        .footprintClearingEnabled = true;
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    const LaserScan scan = beamTo({9.5, 9.5}, {5.5, 5.5}, 0.0);  // into the robot
    costmap.updateNow(at({5.0, 5.0}, 0.0, &scan));
    without.updateNow(at({5.0, 5.0}, 0.0, &scan));
    QCOMPARE(count(without.costmap(), kLethal), 1);
    QCOMPARE(count(costmap.costmap(), kLethal), 0);
    for (int row = 3; row <= 6; ++row) {
      QCOMPARE(rowText(costmap.costmap(), row).substr(3, 4), std::string("...."));
    }
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 16 + 3);  // 3 of the ray lie outside
    costmap.updateNow(at({0.5, 5.0}, 0.1));                  // a corner off the map: not cleared
    QCOMPARE(count(costmap.costmap(), kLethal), 1);
  }

  void update_marksOfOneSource_surviveRaysOfAnother() {
    ObservationSource source = farSource();
    source.clearing = false;
    ObservationSource ray = farSource();
    ray.name = "ray";
    ray.marking = false;
    ObstacleLayerParameters parameters = obstacleLayer(source);
    parameters.sources.push_back(ray);
    LayeredCostmap costmap(obstacleSetup(10, parameters));
    look(costmap, {0.5, 0.5}, {4.5, 0.5}, 0.0);
    look(costmap, {0.5, 0.5}, {8.5, 0.5}, 0.1);
    QCOMPARE(rowText(costmap.costmap(), 0), std::string("....#...#."));
  }

  void update_clearingAlone_marksNothing() {
    ObservationSource source = farSource();
    source.marking = false;
    CostmapSetup setup = obstacleSetup(10, obstacleLayer(source));
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {4.5, 0.5}, 0.0);
    QCOMPARE(rowText(costmap.costmap(), 0), std::string(".....?????"));  // the end cell as well
  }

  void isCurrent_expectedRate_isHeldToScans() {
    ObservationSource source = farSource();
    source.expectedUpdateRate = 0.2;
    LayeredCostmap costmap(obstacleSetup(5, obstacleLayer(source)));
    costmap.updateNow(at({0.0, 0.0}, 0.2));
    QVERIFY(costmap.isCurrent());
    costmap.updateNow(at({0.0, 0.0}, 0.25));
    QVERIFY(!costmap.isCurrent());
    look(costmap, {0.5, 0.5}, {2.5, 0.5}, 0.3);
    QVERIFY(costmap.isCurrent());
    costmap.updateNow(at({0.0, 0.0}, 0.55));
    QVERIFY(!costmap.isCurrent());
  }

  void update_voxelLayer_endsRaysTwoCellsShort() {
    VoxelLayerParameters parameters;
    parameters.footprintClearingEnabled = false;
    parameters.sources = {farSource()};
    CostmapSetup setup = plainSetup(10);
    setup.settings.plugins = {{"obstacle_layer", parameters}};
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {6.5, 0.5}, 0.0);
    QCOMPARE(rowText(costmap.costmap(), 0), std::string(".....?#???"));
    look(costmap, {0.5, 1.5}, {2.0, 1.5}, 0.1);  // nearer than two cells: its own cell alone
    QCOMPARE(rowText(costmap.costmap(), 1), std::string(".?#???????"));
  }

  void update_voxelLayer_seesInItsHeightsOnly_data() {
    QTest::addColumn<double>("height");
    QTest::addColumn<int>("threshold");
    QTest::addColumn<QString>("row");
    QTest::newRow("inside") << 0.5 << 0 << "...?#?";
    QTest::newRow("below") << 0.1 << 0 << "????#?";
    QTest::newRow("above") << 2.3 << 0 << "??????";
    QTest::newRow("one voxel is no column") << 0.5 << 1 << "...???";
  }

  void update_voxelLayer_seesInItsHeightsOnly() {
    QFETCH(double, height);
    QFETCH(int, threshold);
    QFETCH(QString, row);
    VoxelLayerParameters parameters;
    parameters.footprintClearingEnabled = false;
    parameters.maxObstacleHeight = 10.0;
    parameters.originZ = 0.2;
    parameters.markThreshold = threshold;
    parameters.sources = {farSource()};
    CostmapSetup setup = plainSetup(6);
    setup.lidarHeight = height;
    setup.settings.plugins = {{"obstacle_layer", parameters}};
    setup.settings.parameters.trackUnknownSpace = true;
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {4.5, 0.5}, 0.0);
    QCOMPARE(QString::fromStdString(rowText(costmap.costmap(), 0)), row);
  }

  /// Range 2.5 cells is 3 cells; (4, 0) cells away is farther though the point is not.
  void update_cellsBeyondRange_areCutInMain() {
    ObservationSource source = farSource();
    source.obstacleMaxRange = 3.2;  // ceil: 4 cells
    CostmapSetup setup = obstacleSetup(10, obstacleLayer(source));
    for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
      setup.distro = distro;
      LayeredCostmap costmap(setup);
      look(costmap, {0.9, 0.5}, {4.05, 0.5}, 0.0);  // 3.15 m, 4 cells: marked by both
      QCOMPARE(count(costmap.costmap(), kLethal), 1);
      look(costmap, {0.9, 1.9}, {3.1, 4.1}, 0.1);  // 3.11 m, hypot(3, 3) = 4.2 -> 4 cells
      QCOMPARE(count(costmap.costmap(), kLethal), 2);
      look(costmap, {0.95, 5.5}, {0.95 + 3.19, 5.5}, 0.2);
      QCOMPARE(count(costmap.costmap(), kLethal), 3);
    }
    source.obstacleMaxRange = 3.0;  // 3 cells
    setup = obstacleSetup(10, obstacleLayer(source));
    for (const Distro distro : {Distro::Jazzy, Distro::Main}) {
      setup.distro = distro;
      LayeredCostmap costmap(setup);
      look(costmap, {0.95, 0.5}, {3.94, 0.5}, 0.0);
      QCOMPARE(count(costmap.costmap(), kLethal), 1);
      look(costmap, {0.99, 2.99}, {3.01, 5.01}, 0.1);  // 2.86 m, hypot(3, 3) -> 4 cells
      QCOMPARE(count(costmap.costmap(), kLethal), distro == Distro::Main ? 1 : 2);
    }
  }

  void update_disabled_saysNothing() {
    ObstacleLayerParameters parameters = obstacleLayer();
    parameters.enabled = false;
    LayeredCostmap costmap(obstacleSetup(10, parameters));
    look(costmap, {0.5, 0.5}, {4.5, 0.5}, 0.0);
    QCOMPARE(count(costmap.costmap(), kFreeSpace), 100);
    QCOMPARE(count(gridOf(costmap), kFreeSpace), 100);
    costmap.clearEntirely();
    QVERIFY(costmap.isCurrent());  // it does not take part
  }
};

QTEST_APPLESS_MAIN(ObstacleLayerTest)
#include "tst_ObstacleLayer.moc"
