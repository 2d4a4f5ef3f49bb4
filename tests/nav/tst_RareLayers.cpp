#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/nav/CostmapScenes.h"
#include "tests/nav/CostmapSketch.h"

using namespace costmapscenes;  // NOLINT: this file is about nothing else

namespace {

/// A layer of a costmap of Jazzy.
struct Alone {
  template <class Parameters>
  Alone(const Parameters& parameters, const Costmap& master, bool tracksUnknown = true) {
    context.distro = Distro::Jazzy;
    context.tracksUnknown = tracksUnknown;
    layer = makeLayer(parameters, LayerSite{"layer", context, master, setup});
  }
  CostmapLayer* operator->() const { return layer.get(); }

  CostmapContext context;
  CostmapSetup setup;
  LayerPointer layer;
};

/// Rows from the top, as costs::drawn reads them.
std::vector<std::string> rowsOf(const Costmap& costmap) {
  std::vector<std::string> rows;
  for (int row = costmap.height() - 1; row >= 0; --row) {
    std::string line;
    for (int column = 0; column < costmap.width(); ++column) {
      const int cost = costmap.at({column, row});
      line += cost == 254 ? '#' : cost == 253 ? 'i' : cost == 255 ? '?' : '.';
    }
    rows.push_back(line);
  }
  return rows;
}

using Rows = std::vector<std::string>;

Rows denoised(const Rows& rows, int size, int neighbours, bool tracksUnknown = true) {
  Costmap costmap = costs::drawn(rows);
  const Alone layer(DenoiseLayerParameters{true, size, neighbours}, costmap, tracksUnknown);
  layer->updateCosts(costmap, wholeWindow(costmap));
  return rowsOf(costmap);
}

}  // namespace

Q_DECLARE_METATYPE(Rows)

namespace {

LayeredCostmap decayCostmap(const SpatioTemporalVoxelLayerParameters& decay) {
  CostmapSetup setup = plainSetup(10, 0.5);
  setup.distro = Distro::Jazzy;
  setup.settings.plugins = {{"stvl", decay}};
  return LayeredCostmap(setup);
}

SpatioTemporalVoxelLayerParameters decayOf(double seconds,
                                           const SpatioTemporalVoxelSource& source) {
  SpatioTemporalVoxelLayerParameters decay;
  decay.voxelDecay = seconds;
  decay.voxelSize = 0.5;
  decay.updateFootprintEnabled = false;
  decay.sources = {source};
  return decay;
}

}  // namespace

/// Layers that few robots have, against grids that are worked out by hand.
class RareLayersTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void denoise_groups_data() {
    QTest::addColumn<Rows>("before");
    QTest::addColumn<int>("size");
    QTest::addColumn<int>("neighbours");
    QTest::addColumn<Rows>("after");
    const Rows scattered = {"#...##", "......", ".#..#.", "..#..#", "#....#"};
    QTest::newRow("single cells") << scattered << 2 << 8
                                  << Rows{"....##", "......", ".#..#.", "..#..#", ".....#"};
    QTest::newRow("single cells of four neighbours")
        << scattered << 2 << 4 << Rows{"....##", "......", "......", ".....#", ".....#"};
    QTest::newRow("groups below three")
        << scattered << 3 << 8 << Rows{"......", "......", "....#.", ".....#", ".....#"};
    QTest::newRow("groups below four")
        << scattered << 4 << 8 << Rows{"......", "......", "......", "......", "......"};
    QTest::newRow("size 1 removes nothing") << scattered << 1 << 8 << scattered;
    QTest::newRow("size 0 removes nothing") << scattered << 0 << 8 << scattered;
    QTest::newRow("other types count as eight")
        << scattered << 2 << 7 << Rows{"....##", "......", ".#..#.", "..#..#", ".....#"};
    QTest::newRow("inscribed cells belong to a group")
        << Rows{"i#..i", "....."} << 2 << 8 << Rows{"i#...", "....."};
    QTest::newRow("unknown cells do not") << Rows{"?#..#?"} << 2 << 8 << Rows{"?....?"};
  }

  void denoise_groups() {
    QFETCH(Rows, before);
    QFETCH(int, size);
    QFETCH(int, neighbours);
    QFETCH(Rows, after);
    QCOMPARE(denoised(before, size, neighbours), after);
  }

  void denoise_unknownCells_countWhereTheyAreNotTracked() {
    QCOMPARE(denoised({"?#..?"}, 2, 8, false), (Rows{"?#..."}));
  }

  void denoise_window_isAllThatItSees() {
    Costmap costmap = costs::drawn({"##..", "...#"});
    const Alone layer(DenoiseLayerParameters(), costmap);
    layer->updateCosts(costmap, {1, 0, 4, 2});  // the first column lies outside
    QCOMPARE(rowsOf(costmap), (Rows{"#...", "...."}));
    DenoiseLayerParameters off;
    off.enabled = false;
    const Alone none(off, costmap);
    none->updateCosts(costmap, {0, 0, 4, 2});
    QCOMPARE(rowsOf(costmap), (Rows{"#...", "...."}));
  }

  /// By hand: range 1 m, cells of 0.05 m, phi 1.2, half angle 0.25 rad.
  void range_model_isThatOfASonar() {
    const auto model = [](double distance, double angle) {
      return sonarOccupancy(1.0, distance, angle, 0.25, 1.2, 0.05);
    };
    const auto near = [](double found, double wanted) { return std::abs(found - wanted) < 1e-12; };
    const double ahead = 1.0 - (1.0 + std::tanh(2.0 * (0.5 - 1.2))) / 2.0;  // 0.943 at 0.5 m
    QVERIFY(near(model(0.5, 0.0), (1.0 - ahead) * 0.5));
    QVERIFY(near(model(0.5, 0.3), 0.5));                                 // off the cone
    QVERIFY(near(model(0.5, 0.125), (1.0 - 0.75 * ahead) * 0.5));        // half way to its side
    const double at = 1.0 - (1.0 + std::tanh(2.0 * (1.0 - 1.2))) / 2.0;  // at the reading
    QVERIFY(near(model(1.0, 0.0), at * 0.5 + 0.5));
    const double before = 1.0 - (1.0 + std::tanh(2.0 * (0.925 - 1.2))) / 2.0;
    QVERIFY(near(model(0.925, 0.0), before * 0.5 * 0.25 + (1.0 - before) * 0.5));
    const double behind = 1.0 - (1.0 + std::tanh(2.0 * (1.025 - 1.2))) / 2.0;
    QVERIFY(near(model(1.025, 0.0), behind * (1.0 - 0.5 * 0.25 - 0.5) + 0.5));
    QVERIFY(near(model(1.2, 0.0), 0.5));  // beyond
  }

  /// A reading of 1 m along x from (1, 1): the target cell becomes lethal, what lies before it
  /// free.
  void range_reading_marksAndClears() {
    Costmap master(60, 40, 0.05, {0.0, 0.0}, kNoInformation);
    RangeSensorLayerParameters parameters;
    parameters.topics = {"/sonar"};
    const Alone layer(parameters, master);
    for (int i = 0; i < 3; ++i) {
      const LaserScan scan = beamTo({1.025, 1.025}, {2.025, 1.025}, 0.1 * i);
      const Observation observation = at({1.0, 1.0}, 0.1 * i, &scan);
      CostmapBounds bounds;
      layer->observe(observation);
      layer->updateBounds(observation, master, bounds);
      layer->updateCosts(master, {0, 0, 60, 40});
      QVERIFY(std::abs(bounds.low.x() - 1.025) < 1e-9);
      QVERIFY(std::abs(bounds.high.x() - (1.025 + 1.2 * std::cos(0.25))) < 1e-9);
    }
    QCOMPARE(int{master.at({40, 20})}, 254);  // 0.975 to 1.025 m ahead
    QCOMPARE(int{master.at({30, 20})}, 0);
    QCOMPARE(int{master.at({30, 30})}, 255);  // off the cone nothing is known
    QCOMPARE(int{master.at({50, 20})}, 255);  // nor behind the target
    // The odds of a cell half way: prior 127 / 254, three times p / (1 - p).
    const double distance = 0.5;
    const double p = sonarOccupancy(1.0, distance, 0.0, 0.25, 1.2, 0.05);
    double cost = 127.0;
    for (int i = 0; i < 3; ++i) {
      const double prior = std::floor(cost) / 254.0;
      cost = 254.0 * p * prior / (p * prior + (1.0 - p) * (1.0 - prior));
    }
    QCOMPARE(int{layer->grid()->at({30, 20})}, static_cast<int>(cost));
  }

  void range_maximum_clearsTheCone() {
    const Costmap empty(60, 40, 0.05, {0.0, 0.0});
    RangeSensorLayerParameters parameters;
    parameters.topics = {"/sonar"};
    parameters.clearOnMaxReading = true;
    const Alone layer(parameters, empty);
    const auto costAfter = [&](double distance, double time) {
      const LaserScan scan = beamTo({1.025, 1.025}, {1.025 + distance, 1.025}, time);
      const Observation observation = at({1.0, 1.0}, time, &scan);
      CostmapBounds bounds;
      layer->observe(observation);
      layer->updateBounds(observation, empty, bounds);
      return int{layer->grid()->at({40, 20})};
    };
    QVERIFY(costAfter(1.0, 0.0) > 200);
    QCOMPARE(costAfter(5.0, 0.1), 0);
    layer->reset(0.2);
    QVERIFY(!layer->isCurrent());
    QCOMPARE(int{layer->grid()->at({40, 20})}, 127);
  }

  void range_topics_lookWhereTheirNamesSay() {
    const auto degrees = [](const char* topic) {
      return qRound(directionOfSensor(topic) * 180.0 / base::kPi);
    };
    QCOMPARE(degrees("/sonar"), 0);
    QCOMPARE(degrees("/front_range"), 0);
    QCOMPARE(degrees("/us_left"), 90);
    QCOMPARE(degrees("/us_right"), -90);
    QCOMPARE(degrees("/range/front_left"), 45);
    QCOMPARE(degrees("/range/rear_right"), -135);
    QCOMPARE(degrees("/back"), 180);
  }

  /// Of a turn of 360 beams two are short: one in the cone, one off it.
  void range_lidar_givesTheLeastOfTheCone() {
    CostmapSetup setup = plainSetup(10, 0.05);
    setup.distro = Distro::Jazzy;
    setup.settings.parameters.trackUnknownSpace = true;
    RangeSensorLayerParameters range;
    range.topics = {"/sonar"};
    setup.settings.plugins = {{"range", range}};
    LayeredCostmap costmap(setup);
    LaserScan scan = turnOf({2.025, 2.025}, 360, 30.0, 0.0);
    scan.distances[190] = 2.0;  // 10 degrees to the left of x
    scan.distances[230] = 0.5;  // 50 degrees, off the cone of 28.6 degrees
    for (int i = 0; i < 4; ++i) {
      scan.time = 0.2 * i;
      costmap.updateNow(at({2.025, 2.025}, 0.2 * i, &scan));
    }
    QCOMPARE(int{costmap.costmap().at({70, 40})}, 0);    // 1.5 m ahead: nothing before 2 m
    QVERIFY(costmap.costmap().at({80, 40}) == kLethal);  // 2 m ahead
    QVERIFY(costmap.costmap().at({46, 47}) != kLethal);  // the short beam is not in it
  }

  void problems_ofRareLayers_areTold() {
    CostmapSetup setup = plainSetup(10, 0.5);
    RangeSensorLayerParameters range;
    range.topics = {"/sonar"};
    range.inputSensorType = "FIXED";
    range.markThreshold = 1.5;
    SpatioTemporalVoxelLayerParameters decay;
    decay.voxelSize = 0.0;
    SpatioTemporalVoxelSource low;
    low.maxObstacleHeight = 0.1;  // the lidar is at 0.2 m
    decay.sources = {low};
    PluginContainerLayerParameters container;
    container.layers = {{"both.sonar", range}};
    setup.settings.plugins = {{"both", container}, {"stvl", decay}};
    std::vector<std::string> codes;
    for (const base::Diagnostic& problem : problemsOf(setup)) {
      codes.emplace_back(problem.code);
    }
    for (const char* const code : {"nav2.range-type", "nav2.lidar-not-taken"}) {
      QCOMPARE(std::count(codes.begin(), codes.end(), code), 1);
    }
    QCOMPARE(codes.size(), std::size_t{4});  // and two values out of their ranges
    QVERIFY(base::hasErrors(problemsOf(setup)));
  }

  /// A hit at 0 s with a decay of 2 s is there at 2 s and gone at 2.2 s; no ray is needed.
  void decay_linear_forgetsAfterItsTime() {
    SpatioTemporalVoxelSource source;
    source.obstacleRange = 5.0;
    LayeredCostmap costmap = decayCostmap(decayOf(2.0, source));
    const LaserScan scan = beamTo({0.25, 0.25}, {4.25, 0.25}, 0.0);
    costmap.updateNow(at({0.0, 0.0}, 0.0, &scan));
    QCOMPARE(int{costmap.costmap().at({8, 0})}, 254);
    const LaserScan away = beamTo({0.25, 0.25}, {0.25, 9.0}, 0.2);  // beyond its range
    costmap.updateNow(at({0.0, 0.0}, 0.2, &away));
    costmap.updateNow(at({0.0, 0.0}, 2.0, &away));
    QCOMPARE(int{costmap.costmap().at({8, 0})}, 254);
    QCOMPARE(count(costmap.costmap(), 254), 1);
    costmap.updateNow(at({0.0, 0.0}, 2.2, &away));
    QCOMPARE(count(costmap.costmap(), 254), 0);
  }

  /// Age t costs a t³ / 6 more in the field of view: with a = 3 and updates at 1 and 2 s, a mark of
  /// 0 is one of -0.5 at 1 s; at 2 s its age is 2.5, and 10 - 2.5 - 3 · 2.5³ / 6 = -0.31.
  void decay_fieldOfView_isSooner() {
    SpatioTemporalVoxelSource source;
    source.obstacleRange = 5.0;
    source.clearing = true;
    source.decayAcceleration = 3.0;
    source.maxZ = 10.0;
    const auto leftAt2 = [&](const SpatioTemporalVoxelSource& each) {
      LayeredCostmap costmap = decayCostmap(decayOf(10.0, each));
      LaserScan scan = beamTo({0.25, 0.25}, {4.25, 0.25}, 0.0);
      costmap.updateNow(at({0.0, 0.0}, 0.0, &scan));
      scan = beamTo({0.25, 0.25}, {9.25, 0.25}, 1.0);  // looks through where it was
      costmap.updateNow(at({0.0, 0.0}, 1.0, &scan));
      const int before = count(costmap.costmap(), 254);
      costmap.updateNow(at({0.0, 0.0}, 2.0, &scan));
      return before == 1 ? count(costmap.costmap(), 254) : -1;
    };
    QCOMPARE(leftAt2(source), 0);
    SpatioTemporalVoxelSource slower = source;
    slower.decayAcceleration = 2.8;  // 10 - 2.467 - 2.8 · 2.467³ / 6 = 0.53
    QCOMPARE(leftAt2(slower), 1);
    SpatioTemporalVoxelSource shortSighted = source;
    shortSighted.maxZ = 3.0;  // the voxel is 4 m away
    QCOMPARE(leftAt2(shortSighted), 1);
    SpatioTemporalVoxelSource idle = source;
    idle.clearing = false;
    QCOMPARE(leftAt2(idle), 1);
  }

  void decay_persistent_staysBehindTheRays() {
    SpatioTemporalVoxelSource source;
    source.obstacleRange = 5.0;
    SpatioTemporalVoxelLayerParameters decay = decayOf(-1.0, source);
    decay.decayModel = -1;
    LayeredCostmap costmap = decayCostmap(decay);
    LaserScan scan = beamTo({0.25, 0.25}, {4.25, 0.25}, 0.0);
    costmap.updateNow(at({0.0, 0.0}, 0.0, &scan));
    scan = beamTo({0.25, 0.25}, {9.25, 0.25}, 50.0);
    costmap.updateNow(at({0.0, 0.0}, 50.0, &scan));
    QCOMPARE(int{costmap.costmap().at({8, 0})}, 254);
    QVERIFY(costmap.clearAround({4.25, 0.25}, 1.0));
    costmap.updateNow(at({0.0, 0.0}, 50.2, &scan));
    QCOMPARE(count(costmap.costmap(), 254), 0);
  }

  /// Two walls of a map and what the lidar sees, inflated for themselves: only the container's
  /// layers are; the map below is not.
  void container_isMergedAsOne() {
    CostmapSetup setup = plainSetup(9);
    setup.distro = Distro::Jazzy;
    setup.settings.parameters.robotRadius = 0.5;
    setup.map = gridOf({"#........", ".........", ".........", ".........", ".........",
                        ".........", ".........", ".........", "........."});
    PluginContainerLayerParameters container;
    container.layers = {{"both.seen", obstacleLayer(newestSource())},
                        {"both.grown", inflationLayer(1.0)}};
    setup.settings.plugins = {{"map", StaticLayerParameters{}}, {"both", container}};
    LayeredCostmap costmap(setup);
    look(costmap, {0.5, 0.5}, {5.5, 4.5}, 0.0);
    QCOMPARE(int{costmap.costmap().at({5, 4})}, 254);
    const double inscribed = costmap.footprint().inscribed;  // of a polygon in a circle of 0.5 m
    QVERIFY(inscribed > 0.48 && inscribed < 0.5);
    const int beside = static_cast<int>(252.0 * std::exp(-(1.0 - inscribed)));
    QCOMPARE(int{costmap.costmap().at({6, 4})}, beside);
    QCOMPARE(int{costmap.costmap().at({0, 8})}, 254);
    QCOMPARE(int{costmap.costmap().at({1, 8})}, 0);  // the map's wall lies below the container
    QVERIFY(costmap.clearAround({5.5, 4.5}, 4.0, {"both"}));
    look(costmap, {0.5, 0.5}, {0.5, 2.5}, 1.0);
    QCOMPARE(int{costmap.costmap().at({5, 4})}, 0);
    QCOMPARE(int{costmap.costmap().at({0, 8})}, 254);
  }

  void container_law_isFound() {
    CostmapSetup setup = plainSetup(9);
    PluginContainerLayerParameters container;
    container.layers = {{"both.grown", inflationLayer(2.0, 4.0)}};
    setup.settings.plugins = {{"both", container}};
    const LayeredCostmap costmap(setup);
    QVERIFY(costmap.inflation() && costmap.inflation("both.grown"));
    QCOMPARE(costmap.inflation()->scaling, 4.0);
    QVERIFY(!costmap.inflation("other"));
  }

  /// Cells that Jazzy's spreading reaches from a source that is not the nearest one.
  void legacy_inMain_isTheInflationOfJazzy() {
    LegacyInflationLayerParameters legacy;
    legacy.inflationRadius = 6.0;
    legacy.costScalingFactor = 0.4;
    const auto costsOf = [&](Distro distro, const LayerParameters& layer) {
      CostmapSetup setup = plainSetup(10);
      setup.distro = distro;
      setup.settings.parameters.robotRadius = 0.5;
      setup.map = tenByTen();
      setup.settings.plugins = {{"map", StaticLayerParameters{}}, {"inflation", layer}};
      LayeredCostmap costmap(setup);
      costmap.updateNow(at({0.0, 0.0}, 0.0));
      return costmap.costmap().costs();
    };
    const LayerParameters plain = static_cast<const InflationLayerParameters&>(legacy);
    QCOMPARE(costsOf(Distro::Main, legacy), costsOf(Distro::Jazzy, plain));
    CostmapSetup setup = plainSetup(10);
    setup.distro = Distro::Main;
    setup.settings.plugins = {{"legacy", legacy}};
    QCOMPARE(LayeredCostmap(setup).inflation("legacy")->scaling, 0.4);
  }

  /// A path along x between two walls: beside the left one costs fall off by 1, beside the right
  /// one by 2. Without a path, and near its end, the greater factor counts for both.
  void asymmetric_sides_fallOffByTheirFactors() {
    AsymmetricInflationLayerParameters sided;
    sided.inflationRadius = 3.0;
    sided.costScalingFactorLeft = 1.0;
    sided.costScalingFactorRight = 2.0;
    CostmapSetup setup = plainSetup(11);
    setup.distro = Distro::Main;
    setup.settings.parameters.robotRadius = 0.5;
    setup.map = gridOf({"###########", "...........", "...........", "...........", "...........",
                        "...........", "...........", "...........", "...........", "...........",
                        "###########"});
    setup.settings.plugins = {{"map", StaticLayerParameters{}}, {"inflation", sided}};
    LayeredCostmap costmap(setup);
    const auto costAt = [&](int row) { return int{costmap.costmap().at({5, row})}; };
    const double inscribed = costmap.footprint().inscribed;
    const auto costFunction = [inscribed](double factor, double distance) {
      return static_cast<int>(252.0 * std::exp(-factor * (distance - inscribed)));
    };
    costmap.updateNow(at({1.0, 5.5}, 0.0));
    QCOMPARE(costAt(8), costFunction(2.0, 2.0));
    QCOMPARE(costAt(2), costFunction(2.0, 2.0));
    costmap.setPlan({{{1.0, 5.5}, 0.0}, {{5.0, 5.5}, 0.0}, {{10.0, 5.5}, 0.0}});
    costmap.updateNow(at({1.0, 5.5}, 0.2));
    QCOMPARE(costAt(8), costFunction(1.0, 2.0));  // to the left
    QCOMPARE(costAt(2), costFunction(2.0, 2.0));  // to the right
    QCOMPARE(costAt(5), 0);
    costmap.setPlan({{{10.0, 5.5}, 0.0}, {{5.0, 5.5}, 0.0}, {{1.0, 5.5}, 0.0}});
    costmap.updateNow(at({10.0, 5.5}, 0.4));  // the other way the sides are exchanged
    QCOMPARE(costAt(8), costFunction(2.0, 2.0));
    QCOMPARE(costAt(2), costFunction(1.0, 2.0));
    costmap.updateNow(at({2.0, 5.5}, 0.6));  // 1 m before the end
    QCOMPARE(costAt(2), costFunction(2.0, 2.0));
    QCOMPARE(costmap.inflation()->scaling, 1.5);
  }

  void binary_mask_flipsTheState() {
    CostmapSetup setup = plainSetup(4);
    BinaryFilterParameters binary;
    setup.settings.filters = {{"lights", binary}};
    FilterMask mask;
    mask.grid = gridOf({"....", "....", "....", ".69?"});
    mask.base = -10.0;
    mask.multiplier = 1.0;
    setup.masks["lights"] = mask;
    LayeredCostmap costmap(setup);
    const auto stateAt = [&](double x, double time) {
      costmap.updateNow(at({x, 0.5}, time));
      return costmap.binaryStates().at("lights").state;
    };
    QVERIFY(!stateAt(0.5, 0.0));
    QVERIFY(!stateAt(1.5, 1.0));  // 60 - 10 is not above 50
    QVERIFY(stateAt(2.5, 2.0));   // 90 - 10 is
    QVERIFY(stateAt(3.5, 3.0));   // unknown: it stays
    QVERIFY(!stateAt(9.0, 4.0));  // off the mask
    QCOMPARE(costmap.binaryStates().at("lights").changes, 2);
    QCOMPARE(count(costmap.costmap(), 0), 16);
  }
};

QTEST_APPLESS_MAIN(RareLayersTest)
#include "tst_RareLayers.moc"
