#include <algorithm>
#include <cmath>

#include <QElapsedTimer>
#include <QtTest>

#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

/// Simulated seconds per wall second of the stepping, in the message beside the time of one run.
class WorldBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_hallWithShelves_fivePeopleAndARobot();
  void step_openPlane_crowd_data();
  void step_openPlane_crowd();
  void create_sameSurroundings_sharesTheMapWork_data();
  void create_sameSurroundings_sharesTheMapWork();
};

namespace {

/// 50 m by 50 m at 0.05 m: outer walls and rows of shelves.
OccupancyGrid hall() {
  constexpr int kSize = 1000;
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kSize) * kSize, 0);
  for (int row = 0; row < kSize; ++row) {
    for (int column = 0; column < kSize; ++column) {
      const bool isBorder = std::min(row, column) < 8 || std::max(row, column) >= kSize - 8;
      const bool isShelf =
          row % 100 >= 40 && row % 100 < 60 && column % 250 >= 60 && column % 250 < 220;
      const int cell = row * kSize + column;
      cells[static_cast<std::size_t>(cell)] = isBorder || isShelf ? 100 : 0;
    }
  }
  return {kSize, kSize, 0.05, {Vec2(-25.0, -25.0), 0.0}, std::move(cells)};
}

}  // namespace

void WorldBench::step_hallWithShelves_fivePeopleAndARobot() {
  Scenario scenario;
  for (int i = 0; i < 5; ++i) {
    addGoal(scenario, 2 * i + 1, 20.0, -20.5 + 10.0 * i);
    addGoal(scenario, 2 * i + 2, -20.0, 19.5 - 10.0 * i);
    addPerson(scenario, i, Vec2(-20.0, -20.5 + 10.0 * i), {2 * i + 1, 2 * i + 2}).cyclicGoals =
        true;
  }
  addRobot(scenario, Vec2(-22.0, -22.0), Vec2(22.0, 22.0));
  base::Result<std::unique_ptr<World>> world = create(scenario, {}, hall());
  QVERIFY(world);
  advance(**world, 20);
  QBENCHMARK_ONCE {
    advance(**world, 1200);
  }
}

void WorldBench::step_openPlane_crowd_data() {
  QTest::addColumn<int>("count");
  QTest::newRow("10") << 10;
  QTest::newRow("100") << 100;
  QTest::newRow("1000") << 1000;
}

void WorldBench::step_openPlane_crowd() {
  QFETCH(int, count);
  Scenario scenario;
  const int side = static_cast<int>(std::ceil(std::sqrt(count)));
  addGoal(scenario, 1, 500.0, 0.0);
  addGoal(scenario, 2, -500.0, 0.0);
  for (int i = 0; i < count; ++i) {
    addPerson(scenario, i, Vec2(1.9 * (i % side), 1.9 * (i / side)), {i % 2 + 1});
  }
  base::Result<std::unique_ptr<World>> world = create(scenario);
  QVERIFY(world);
  advance(**world, 20);
  QBENCHMARK_ONCE {
    advance(**world, 100);
  }
}

void WorldBench::create_sameSurroundings_sharesTheMapWork_data() {
  QTest::addColumn<QString>("place");
  QTest::newRow("corner_cafe") << "corner_cafe/corner_cafe";
  QTest::newRow("hall") << "";
}

/// The first world of a place and the ones after it; the fastest of some rounds.
void WorldBench::create_sameSurroundings_sharesTheMapWork() {
  QFETCH(QString, place);
  auto scenario = std::make_shared<Scenario>();
  OccupancyGrid grid = hall();
  if (!place.isEmpty()) {
    const std::string base = SOURCE_DIR "/maps/" + place.toStdString();
    *scenario = readScenario(base + "_agents.yaml").scenario;
    const base::Result<MapFile> file = readMap(base + ".yaml", {});
    QVERIFY(file);
    grid = file->grid;
  }
  for (int i = 0; i < 40 && place.isEmpty(); ++i) {
    addGoal(*scenario, i + 1, -22.0 + i, -22.0);
    addPerson(*scenario, i, Vec2(-22.0 + i, 20.0), {i + 1});
  }
  double first = 1e9;
  double again = 1e9;
  for (int round = 0; round < 5; ++round) {
    std::shared_ptr<const Surroundings> surroundings;
    for (double* const best : {&first, &again}) {
      QElapsedTimer timer;
      timer.start();
      if (surroundings == nullptr) {
        surroundings = std::make_shared<const Surroundings>(makeSurroundings(*scenario, grid));
      }
      WorldSetup setup;
      setup.scenario = scenario;
      setup.surroundings = surroundings;
      setup.behavior = std::make_unique<ScriptedBehavior>();
      QVERIFY(World::create(std::move(setup)));
      *best = std::min(*best, static_cast<double>(timer.nsecsElapsed()) * 1e-6);
    }
  }
  qInfo("first %.2f ms, again %.2f ms", first, again);
  QTest::setBenchmarkResult(again, QTest::WalltimeMilliseconds);
}

QTEST_APPLESS_MAIN(WorldBench)
#include "bench_World.moc"
