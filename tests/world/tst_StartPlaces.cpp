#include <algorithm>
#include <random>

#include <QtTest>

#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

constexpr double kAllowed = 0.01;  // [m] that starts may stand in each other

struct Disc {
  Vec2 position;
  double radius;
};

std::vector<Disc> discsOf(const World& world, const Scenario& scenario) {
  const Frame& frame = world.frame();
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < frame.humans.size(); ++i) {
    discs.push_back({Vec2(frame.humans.x[i], frame.humans.y[i]), *scenario.humans[i].radius});
  }
  for (std::size_t i = 0; i < frame.robots.size(); ++i) {
    discs.push_back({Vec2(frame.robots.x[i], frame.robots.y[i]), *scenario.robots[i].radius});
  }
  return discs;
}

}  // namespace

/// Starts that are taken by other bodies are moved to the nearest free place.
class StartPlacesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void create_crowdedStarts_nobodyStandsInAnother_data() {
    addColumns<int, double>({"seed", "offset"});
    QTest::newRow("round the origin") << 1 << 0.0;
    QTest::newRow("far out") << 2 << -4000.0;
  }

  /// Small people beside large ones, a sixth of a square of 24 m filled.
  void create_crowdedStarts_nobodyStandsInAnother() {
    QFETCH(int, seed);
    QFETCH(double, offset);
    std::mt19937 random(static_cast<unsigned>(seed));
    std::uniform_real_distribution<double> place(offset - 12.0, offset + 12.0);
    std::uniform_real_distribution<double> radius(0.1, 0.4);
    Scenario scenario;
    for (int i = 0; i < 400; ++i) {
      addPerson(scenario, i + 1, Vec2(place(random), place(random))).radius = radius(random);
    }
    addRobot(scenario, Vec2(offset, offset), Vec2(offset + 5.0, offset)).radius = 0.6;
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    for (const base::Diagnostic& said : world.diagnostics()) {
      QVERIFY2(said.message.find("no free space") == std::string::npos, said.message.c_str());
    }
    const std::vector<Disc> discs = discsOf(**world, scenario);
    QCOMPARE(discs.size(), std::size_t(401));
    for (std::size_t i = 0; i < discs.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const double apart = (discs[i].position - discs[k].position).norm();
        QVERIFY(apart > discs[i].radius + discs[k].radius - kAllowed - 1e-9);
      }
    }
    const auto moved = std::count_if(world.diagnostics().begin(), world.diagnostics().end(),
                                     [](const base::Diagnostic& said) {
                                       return said.message.find("is used") != std::string::npos;
                                     });
    QVERIFY(moved > 50);
  }

  void create_farApart_staysWhereItIs() {
    Scenario scenario;
    for (int i = 0; i < 10; ++i) {
      addPerson(scenario, i + 1, Vec2(0.8 * i, -0.8 * i));
    }
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QVERIFY(world.diagnostics().empty());
    const std::vector<Disc> discs = discsOf(**world, scenario);
    for (int i = 0; i < 10; ++i) {
      QVERIFY(discs[static_cast<std::size_t>(i)].position == Vec2(0.8 * i, -0.8 * i));
    }
  }

  void create_tooManyInOnePlace_aWarningSaysSo() {
    Scenario scenario;
    for (int i = 0; i < 12; ++i) {
      addPerson(scenario, i + 1, Vec2(3.0, 4.0));
    }
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    const bool isTold = std::any_of(
        world.diagnostics().begin(), world.diagnostics().end(), [](const base::Diagnostic& said) {
          return said.message.find("no free space within 1 m") != std::string::npos;
        });
    QVERIFY(isTold);
  }

  /// 5000 are 12 million pairs: memory and time without end.
  void create_farTooManyInOnePlace_isRefused() {
    Scenario scenario;
    for (int i = 0; i < 5000; ++i) {
      addPerson(scenario, i + 1, Vec2(3.0, 4.0));
    }
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(!world);
    const auto refused = std::count_if(
        world.diagnostics().begin(), world.diagnostics().end(), [](const base::Diagnostic& said) {
          return said.severity == base::Severity::Error &&
                 said.message.find("more than 1000 bodies start at occupied places") == 0;
        });
    QCOMPARE(static_cast<int>(refused), 1);
  }
};

QTEST_APPLESS_MAIN(StartPlacesTest)
#include "tst_StartPlaces.moc"
