#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <utility>
#include <vector>

#include <QtTest>

#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "tests/nav/CostmapScenes.h"
#include "tests/nav/MetaTypes.h"

using namespace costmapscenes;

namespace {

/// A square of cells of 1 m with an inflation layer alone; `inscribed` by a custom footprint.
struct Scene {
  Scene(int side, Distro distro, double inscribed, const InflationLayerParameters& parameters,
        std::uint8_t cost = kFreeSpace)
      : costmap(side, side, 1.0, {0.0, 0.0}, cost) {
    context.distro = distro;
    context.footprint.inscribed = inscribed;
    layer = makeLayer(parameters, LayerSite{"inflation_layer", context, costmap, setup});
  }
  void inflate() { layer->updateCosts(costmap, wholeWindow(costmap)); }

  CostmapContext context;
  Costmap costmap;
  CostmapSetup setup;
  LayerPointer layer;
};

int squareTo(Cell from, Cell to) {
  const int across = to.column - from.column, up = to.row - from.row;
  return across * across + up * up;
}

void addDistros() {
  QTest::addColumn<Distro>("distro");
  QTest::newRow("humble") << Distro::Humble;
  QTest::newRow("jazzy") << Distro::Jazzy;
  QTest::newRow("main") << Distro::Main;
}

Costmap scattered(int side, double share, unsigned seed) {
  Costmap costmap(side, side, 1.0, {0.0, 0.0});
  std::mt19937 random(seed);
  for (std::uint8_t& cost : costmap.costs()) {
    cost = static_cast<double>(random() % 10000) < 10000.0 * share ? kLethal : kFreeSpace;
  }
  return costmap;
}

}  // namespace

/// Vectors of nav2_costmap_2d: inflation_tests.cpp.
class InflationLayerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// 252 e^-(d - 5): page 6.4, vector 40; with r_in 0.2255 and scaling 3 those of page 6.6.
  void law_distances_giveTheCostsOfTheFormula() {
    const InflationCostFunction slow{10.5, 1.0, 5.0};
    const std::vector<int> expected = {254, 253, 253, 253, 253, 253, 92, 34, 12, 4, 1, 0};
    for (std::size_t i = 0; i < expected.size(); ++i) {
      QCOMPARE(int{slow.cost(static_cast<double>(i))}, expected[i]);
    }
    const InflationCostFunction fine{0.7, 3.0, costmapFootprint(0.22, {}, 0.01).inscribed};
    const std::vector<std::pair<double, int>> page = {{0.25, 234}, {0.30, 201}, {0.40, 149},
                                                      {0.50, 110}, {0.55, 95},  {0.70, 60}};
    for (const auto& [distance, cost] : page) {
      QCOMPARE(int{fine.cost(distance)}, cost);
    }
  }

  void law_cost_givesTheDistanceBack() {
    const InflationCostFunction costFunction{0.7, 3.0, 0.2};
    QVERIFY(std::fabs(costFunction.distance(253) - 0.2) < 1e-12);
    QVERIFY(std::fabs(costFunction.distance(100) - (0.2 - std::log(100.0 / 253.0) / 3.0)) < 1e-12);
    QVERIFY(std::fabs(costFunction.distance(costFunction.cost(0.5)) - 0.5) <
            0.01);  // costs are whole
  }
  void updateCosts_cornerObstacle_leavesRoomBehindTheRing_data() { addDistros(); }

  /// Vector 38.
  void updateCosts_cornerObstacle_leavesRoomBehindTheRing() {
    QFETCH(Distro, distro);
    Scene scene(10, distro, 2.1, inflationLayer(4.1));
    scene.costmap.set({0, 0}, kLethal);
    scene.inflate();
    for (const Cell cell : {Cell{1, 0}, Cell{2, 0}, Cell{1, 1}}) {
      QCOMPARE(int{scene.costmap.at(cell)}, 253);
    }
    QVERIFY(scene.costmap.at({3, 0}) < kInscribed);
    QVERIFY(scene.costmap.at({2, 1}) < kInscribed);
  }
  void updateCosts_unknown_isInflatedWhenAsked_data() { addDistros(); }

  /// Vector 39: the corners are sqrt(32) cells away, more than 5.
  void updateCosts_unknown_isInflatedWhenAsked() {
    QFETCH(Distro, distro);
    InflationLayerParameters parameters = inflationLayer(4.1);
    parameters.inflateUnknown = true;
    Scene scene(9, distro, 2.1, parameters, kNoInformation);
    scene.costmap.set({4, 4}, kLethal);
    scene.inflate();
    QCOMPARE(count(scene.costmap, kNoInformation), 4);
  }
  void updateCosts_unknown_takesInscribedCostsAlone_data() { addDistros(); }

  void updateCosts_unknown_takesInscribedCostsAlone() {
    QFETCH(Distro, distro);
    Scene scene(9, distro, 1.0, inflationLayer(3.0), kNoInformation);
    scene.costmap.set({4, 4}, kLethal);
    scene.inflate();
    QCOMPARE(count(scene.costmap, kInscribed), 4);
    QCOMPARE(count(scene.costmap, kNoInformation), 81 - 5);
  }
  void updateCosts_aroundUnknown_makesItLethal_data() { addDistros(); }

  void updateCosts_aroundUnknown_makesItLethal() {
    QFETCH(Distro, distro);
    InflationLayerParameters parameters = inflationLayer(2.0);
    parameters.inflateAroundUnknown = true;
    Scene scene(9, distro, 1.0, parameters);
    scene.costmap.set({4, 4}, kNoInformation);
    scene.inflate();
    QCOMPARE(int{scene.costmap.at({4, 4})}, 254);
    QCOMPARE(count(scene.costmap, kInscribed), 4);
  }
  void updateCosts_oneObstacle_followsTheFormula_data() { addDistros(); }

  /// Vector 40.
  void updateCosts_oneObstacle_followsTheFormula() {
    QFETCH(Distro, distro);
    Scene scene(100, distro, 5.0, inflationLayer(10.5));
    scene.costmap.set({50, 50}, kLethal);
    scene.inflate();
    for (int i = 0; i <= 5; ++i) {
      QVERIFY(scene.costmap.at({50 + i, 50}) >= kInscribed);
      QVERIFY(scene.costmap.at({50, 50 - i}) >= kInscribed);
    }
    const std::vector<int> expected = {92, 34, 12, 4, 1, 0};
    for (int i = 6; i <= 11; ++i) {
      QCOMPARE(int{scene.costmap.at({50 + i, 50})}, expected[static_cast<std::size_t>(i - 6)]);
      QCOMPARE(int{scene.costmap.at({50, 50 + i})}, expected[static_cast<std::size_t>(i - 6)]);
    }
  }
  void updateCosts_radiusThree_touches29Cells_data() { addDistros(); }

  /// Vector 42: a disc of radius 3 has 29 cells, also after a second update.
  void updateCosts_radiusThree_touches29Cells() {
    QFETCH(Distro, distro);
    Scene scene(10, distro, 1.0, inflationLayer(3.0));
    scene.costmap.set({5, 5}, kLethal);
    for (int i = 0; i < 2; ++i) {
      scene.inflate();
      QCOMPARE(100 - count(scene.costmap, kFreeSpace), 29);
      QCOMPARE(count(scene.costmap, kLethal), 1);
      QCOMPARE(count(scene.costmap, kInscribed), 4);
    }
  }

  void updateCosts_manyObstacles_areAsFarAsTheNearest_data() {
    QTest::addColumn<Distro>("distro");
    QTest::addColumn<double>("share");
    QTest::addColumn<int>("most");  // cells in a thousand that may take another source
    QTest::newRow("main, few") << Distro::Main << 0.005 << 0;
    QTest::newRow("main, many") << Distro::Main << 0.1 << 0;
    QTest::newRow("humble, few") << Distro::Humble << 0.005 << 10;
    QTest::newRow("humble, many") << Distro::Humble << 0.1 << 1;
  }

  void updateCosts_manyObstacles_areAsFarAsTheNearest() {
    QFETCH(Distro, distro);
    QFETCH(double, share);
    QFETCH(int, most);
    constexpr int kRadius = 7;
    int others = 0, cells = 0;
    for (unsigned seed = 1; seed <= 5; ++seed) {
      Scene scene(40, distro, 1.5, inflationLayer(kRadius, 0.4));
      scene.costmap = scattered(40, share, seed);
      const Costmap before = scene.costmap;
      scene.inflate();
      for (int row = 0; row < 40; ++row) {
        for (int column = 0; column < 40; ++column) {
          const int square = nearestSquare(before, {column, row});
          int expected = 0;
          if (square >= 0 && square <= kRadius * kRadius) {
            double distance = std::sqrt(square);
            if (distro == Distro::Main) {
              distance = 0.01 * std::floor(100.0 * distance + 0.5);
            }
            expected = square == 0 ? 254
                       : distance <= 1.5
                           ? 253
                           : static_cast<int>(252.0 * std::exp(-0.4 * (distance - 1.5)));
          }
          const int cost = scene.costmap.at({column, row});
          ++cells;
          others += cost != expected ? 1 : 0;
          QVERIFY(cost <= expected);  // never nearer than the nearest
        }
      }
    }
    QVERIFY2(1000 * others <= most * cells, qPrintable(QString::number(others)));
  }

  /// Squares of more than 127 cells need more than 16 bits.
  void updateCosts_largeRadius_isExactToo() {
    for (const int radius : {127, 128, 180}) {
      Scene scene(200, Distro::Main, 1.5, inflationLayer(radius, 0.01));
      scene.costmap.set({3, 5}, kLethal);
      scene.costmap.set({190, 150}, kLethal);
      scene.inflate();
      for (int row = 0; row < 200; row += 3) {
        for (int column = 0; column < 200; ++column) {
          const int square =
              std::min(squareTo({column, row}, {3, 5}), squareTo({column, row}, {190, 150}));
          const double distance = 0.01 * std::floor(100.0 * std::sqrt(square) + 0.5);
          const int expected = square == 0 ? 254
                               : distance <= 1.5
                                   ? 253
                                   : static_cast<int>(252.0 * std::exp(-0.01 * (distance - 1.5)));
          QCOMPARE(int{scene.costmap.at({column, row})}, square <= radius * radius ? expected : 0);
        }
      }
    }
  }
  void updateCosts_window_isAllThatChanges_data() { addDistros(); }

  void updateCosts_window_isAllThatChanges() {
    QFETCH(Distro, distro);
    Scene scene(20, distro, 1.0, inflationLayer(4.0, 0.2));
    scene.costmap.set({4, 10}, kLethal);  // outside the window, reaches into it
    Scene whole(20, distro, 1.0, inflationLayer(4.0, 0.2));
    whole.costmap = scene.costmap;
    whole.inflate();
    scene.layer->updateCosts(scene.costmap, {6, 8, 12, 14});
    QVERIFY(scene.costmap.at({6, 10}) > 0);
    for (int row = 0; row < 20; ++row) {
      for (int column = 0; column < 20; ++column) {
        const bool isInside = column >= 6 && column < 12 && row >= 8 && row < 14;
        const Cell cell{column, row};
        const int outside = cell == Cell{4, 10} ? 254 : 0;
        const int expected = isInside ? whole.costmap.at(cell) : outside;
        QCOMPARE(int{scene.costmap.at(cell)}, expected);
      }
    }
  }
  void updateCosts_higherCosts_stay_data() { addDistros(); }

  void updateCosts_higherCosts_stay() {
    QFETCH(Distro, distro);
    Scene scene(10, distro, 0.5, inflationLayer(3.0, 2.0));
    scene.costmap.set({5, 5}, kLethal);
    scene.costmap.set({6, 5}, 200);
    scene.costmap.set({7, 5}, 1);
    scene.inflate();
    QCOMPARE(int{scene.costmap.at({6, 5})}, 200);                                // 252 e^-1 = 92
    QCOMPARE(int{scene.costmap.at({7, 5})}, int(252.0 * std::exp(-2.0 * 1.5)));  // 12
  }
  void updateCosts_inscribedCells_doNotInflate_data() { addDistros(); }

  void updateCosts_inscribedCells_doNotInflate() {
    QFETCH(Distro, distro);
    Scene scene(10, distro, 2.0, inflationLayer(3.0));
    scene.costmap.set({5, 5}, kInscribed);
    scene.inflate();
    QCOMPARE(count(scene.costmap, kFreeSpace), 99);
  }

  void updateBounds_secondUpdate_growsByRadiusAndTheLastOne() {
    Scene scene(50, Distro::Humble, 1.0, inflationLayer(3.0));
    CostmapBounds bounds;
    bounds.touch({10.0, 10.0});
    scene.layer->updateBounds({}, scene.costmap, bounds);
    QVERIFY(bounds.low.x() < -1e300 && bounds.high.y() > 1e300);  // the first one is whole
    CostmapBounds second;
    second.touch({20.0, 30.0});
    scene.layer->updateBounds({}, scene.costmap, second);
    QVERIFY(second.low == Vec2(7.0, 7.0));
    QVERIFY(second.high == Vec2(23.0, 33.0));
    CostmapBounds third;
    third.touch({40.0, 40.0});
    scene.layer->updateBounds({}, scene.costmap, third);
    QVERIFY(third.low == Vec2(17.0, 27.0));
    QVERIFY(third.high == Vec2(43.0, 43.0));
  }

  void updateCosts_disabled_doesNothing() {
    InflationLayerParameters parameters = inflationLayer(3.0);
    parameters.enabled = false;
    Scene off(10, Distro::Humble, 1.0, parameters);
    Scene none(10, Distro::Humble, 1.0, inflationLayer(0.0));
    for (Scene* scene : {&off, &none}) {
      scene->costmap.set({5, 5}, kLethal);
      scene->layer->reset(0.0);
      QVERIFY(!scene->layer->isCurrent());
      scene->inflate();
      QCOMPARE(count(scene->costmap, kFreeSpace), 99);
      QVERIFY(scene->layer->isCurrent());
    }
  }

  void law_customRadius_countsInMainOnly() {
    InflationLayerParameters parameters = inflationLayer(3.0);
    parameters.customInscribedRadius = 2.0;
    QCOMPARE(Scene(5, Distro::Main, 1.0, parameters).layer->inflation("")->inscribed, 2.0);
    QCOMPARE(Scene(5, Distro::Jazzy, 1.0, parameters).layer->inflation("")->inscribed, 1.0);
    parameters.customInscribedRadius = -1.0;
    QCOMPARE(Scene(5, Distro::Main, 1.0, parameters).layer->inflation("")->inscribed, 1.0);
  }
};

QTEST_APPLESS_MAIN(InflationLayerTest)
#include "tst_InflationLayer.moc"
