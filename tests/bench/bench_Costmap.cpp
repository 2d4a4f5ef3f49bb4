#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/base/Math.h"
#include "sim2d/nav/nav2/costmap/CostmapLayer.h"
#include "tests/nav/CostmapScenes.h"
#include "tests/nav/MetaTypes.h"

using namespace costmapscenes;

/// An update of a local costmap from a scan, beside a plain one that looks from each cell for the
/// obstacles around and walks rays in small steps.
class CostmapBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void update_localCostmap_data();
  void update_localCostmap();
  void update_globalCostmap_data();
  void update_globalCostmap();
};

namespace {

constexpr int kUpdates = 60;
constexpr int kRounds = 20, kPlainRounds = 3;
constexpr double kResolution = 0.05;  // [m]
constexpr int kLocalSide = 3;         // [m]

/// A corridor with people: distances between 0.4 m and 2 m in stretches.
LaserScan scanOf(int number) {
  std::mt19937 random(static_cast<unsigned>(number + 1));
  LaserScan scan = turnOf({1.5 + 0.02 * number, 1.5}, 360, 2.0, 0.1 * number);
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const double wall = 1.1 / std::fmax(std::fabs(std::sin(0.01745 * static_cast<double>(i))), 0.1);
    const bool isPerson = (i + static_cast<std::size_t>(number) * 7) % 60 < 8;
    scan.distances[i] = isPerson ? 0.6 : std::fmin(wall, 25.0);
    scan.distances[i] += 0.01 * static_cast<double>(random() % 100) / 100.0;
  }
  return scan;
}

CostmapSetup localSetup(Distro distro) {
  CostmapSetup setup = plainSetup(kLocalSide, kResolution);
  setup.settings.parameters.rollingWindow = true;
  setup.settings.parameters.robotRadius = 0.22;
  setup.settings.parameters.footprintPadding = 0.01;
  setup.distro = distro;
  ObservationSource source;
  source.maxObstacleHeight = 2.0;
  source.clearing = true;
  ObstacleLayerParameters obstacles = obstacleLayer(source);
  obstacles.footprintClearingEnabled = true;
  setup.settings.plugins = {{"obstacle_layer", obstacles},
                            {"inflation_layer", inflationLayer(0.70, 3.0)}};
  return setup;
}

double meanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return sum / static_cast<double>(values.size());
}

/// Marks, clears and inflates the plain way; the sum of its costs.
long long plainUpdate(Costmap& costmap, const LaserScan& scan, const InflationCostFunction& law) {
  costmap.setOrigin(scan.sensor.position - Vec2(1.5, 1.5));
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const Vec2 ahead =
        base::directionOf(scan.angleMin + static_cast<double>(i) * scan.angleIncrement);
    for (double way = 0.0; way < std::fmin(scan.distances[i], 3.0); way += 0.5 * kResolution) {
      if (const auto cell = costmap.worldToCell(scan.sensor.position + way * ahead)) {
        costmap.set(*cell, kFreeSpace);
      }
    }
  }
  for (std::size_t i = 0; i < scan.distances.size(); ++i) {
    const Vec2 ahead =
        base::directionOf(scan.angleMin + static_cast<double>(i) * scan.angleIncrement);
    const auto cell = costmap.worldToCell(scan.sensor.position + scan.distances[i] * ahead);
    if (cell && scan.distances[i] <= 2.5) {
      costmap.set(*cell, kLethal);
    }
  }
  const int radius = costmap.cellDistance(law.radius);
  long long sum = 0;
  for (int row = 0; row < costmap.height(); ++row) {
    for (int column = 0; column < costmap.width(); ++column) {
      int cost = 0;
      for (int up = std::max(-radius, -row); up <= std::min(radius, costmap.height() - 1 - row);
           ++up) {
        for (int across = std::max(-radius, -column);
             across <= std::min(radius, costmap.width() - 1 - column); ++across) {
          if (costmap.at({column + across, row + up}) == kLethal) {
            const double distance = kResolution * std::sqrt(across * across + up * up);
            cost = std::max(cost, distance <= law.radius ? int{law.cost(distance)} : 0);
          }
        }
      }
      sum += cost;
    }
  }
  return sum;
}

}  // namespace

void CostmapBench::update_localCostmap_data() {
  QTest::addColumn<Distro>("distro");
  QTest::newRow("humble") << Distro::Humble;
  QTest::newRow("main") << Distro::Main;
}

void CostmapBench::update_localCostmap() {
  QFETCH(Distro, distro);
  const CostmapSetup setup = localSetup(distro);
  std::vector<LaserScan> scans;
  for (int i = 0; i < kUpdates; ++i) {
    scans.push_back(scanOf(i));
  }
  std::vector<double> updates(scans.size(), 1e18), plain(scans.size(), 1e18);  // [us], the best
  long long sum = 0;
  for (int round = 0; round < kRounds; ++round) {
    LayeredCostmap costmap(setup);
    Costmap plainly = costmap.costmap();
    const InflationCostFunction law = *costmap.inflation();
    for (std::size_t i = 0; i < scans.size(); ++i) {
      QElapsedTimer timer;
      timer.start();
      costmap.updateNow(at(scans[i].sensor.position, scans[i].time, &scans[i]));
      updates[i] = std::min(updates[i], 1e-3 * static_cast<double>(timer.nsecsElapsed()));
      if (round < kPlainRounds) {
        timer.restart();
        sum += plainUpdate(plainly, scans[i], law);
        plain[i] = std::min(plain[i], 1e-3 * static_cast<double>(timer.nsecsElapsed()));
      }
    }
    sum += count(costmap.costmap(), kLethal);
  }
  const double update = meanOf(updates), plainly = meanOf(plain);
  QVERIFY(sum > 0);
  qInfo("an update %.0f us, the plain way %.0f us, ratio %.0f", update, plainly, plainly / update);
  QTest::setBenchmarkResult(update * 1e3, QTest::WalltimeNanoseconds);
}

void CostmapBench::update_globalCostmap_data() {
  update_localCostmap_data();
}

/// 20 m x 20 m with its map, written whole, as the first update and each one after a clear do.
void CostmapBench::update_globalCostmap() {
  QFETCH(Distro, distro);
  CostmapSetup setup = localSetup(distro);
  constexpr int kSide = 400;  // [cells]
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kSide * kSide), 0);
  std::mt19937 random(3);
  for (int wall = 0; wall < 60; ++wall) {
    const auto start = random() % (kSide * (kSide - 41));
    for (unsigned i = 0; i < 40; ++i) {
      cells[start + (wall % 2 == 0 ? i : i * kSide)] = 100;
    }
  }
  setup.map = OccupancyGrid(kSide, kSide, kResolution, {}, cells);
  setup.settings.parameters.rollingWindow = false;
  setup.settings.plugins.insert(setup.settings.plugins.begin(),
                                {"static_layer", StaticLayerParameters{}});
  LayeredCostmap costmap(setup);
  double best = 1e18;  // [ms]
  for (int i = 0; i < 10; ++i) {
    costmap.clearEntirely();
    const LaserScan scan = scanOf(i);
    QElapsedTimer timer;
    timer.start();
    costmap.updateNow(at(scan.sensor.position, scan.time, &scan));
    best = std::min(best, 1e-6 * static_cast<double>(timer.nsecsElapsed()));
  }
  QVERIFY(count(costmap.costmap(), kLethal) > 1000);
  qInfo("a whole update %.1f ms", best);
  QTest::setBenchmarkResult(best * 1e6, QTest::WalltimeNanoseconds);
}

QTEST_APPLESS_MAIN(CostmapBench)
#include "bench_Costmap.moc"
