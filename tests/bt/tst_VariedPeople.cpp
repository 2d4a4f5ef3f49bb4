#include <map>
#include <set>

#include <QtTest>

#include "sim2d/scenario/Variation.h"
#include "tests/bt/ShippedScenario.h"
#include "tests/support/LibraryFiles.h"
#include "tests/support/TraceHash.h"

using namespace shipped;
namespace fs = std::filesystem;

namespace {

constexpr double kTouch = 1e-6;  // [m]

/// The scenario with a seed, and what `change` does to it.
template <class Change>
Loaded changed(const Loaded& loaded, long long seed, Change change) {
  Loaded copy = loaded;
  sim2d::Scenario scenario = *loaded.scenario;
  scenario.desktop.seed = seed;
  change(scenario);
  copy.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  return copy;
}
Loaded ofSeed(const Loaded& loaded, long long seed) {
  return changed(loaded, seed, [](const sim2d::Scenario& /*scenario*/) {});
}

std::uint64_t hashOfRun(Loaded loaded, std::int64_t steps, int threads = 1) {
  const std::unique_ptr<sim2d::World> world = makeWorld(loaded, threads);
  sim2d::Recording recording;
  sim2d::StopRule rule;
  rule.maximumSteps = steps;
  sim2d::run(*world, rule, recording);
  return sim2d::hashOf(recording.trace(world->header()));
}

/// What the seed drew for each person.
using Draws = std::map<int, std::vector<std::pair<std::string, double>>>;
Draws drawsOf(Loaded loaded) {
  static const std::set<std::string> kDrawn = {"max_vel", "start_time", "start_x",
                                               "start_y", "start_h",    "reaction_time"};
  Draws draws;
  const std::unique_ptr<sim2d::World> world = makeWorld(loaded);
  for (const sim2d::TraceHuman& human : world->header().humans) {
    for (const auto& parameter : human.parameters) {
      if (kDrawn.count(parameter.first) > 0) {
        draws[human.id].push_back(parameter);
      }
    }
    draws[human.id].emplace_back("first goal", human.goals.empty() ? 0 : human.goals.front().id);
  }
  return draws;
}

}  // namespace

/// A seed must matter: people of shipped scenarios are others in each, and the same for all robots.
class VariedPeopleTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void seeds_ofAShippedScenario_areDifferentRuns_data() { addScenarios(); }
  void seeds_ofAShippedScenario_areDifferentRuns() {
    QFETCH(QString, path);
    const Loaded loaded = load(path.toStdString());
    std::set<std::uint64_t> hashes;
    for (long long seed = 1; seed <= 10; ++seed) {
      hashes.insert(hashOfRun(ofSeed(loaded, seed), 60));
    }
    QCOMPARE(hashes.size(), std::size_t{10});
  }

  void starts_ofManySeeds_areFree_data() { addScenarios(); }
  void starts_ofManySeeds_areFree() {
    QFETCH(QString, path);
    const Loaded loaded = load(path.toStdString());
    const sim2d::Surroundings around = sim2d::makeSurroundings(*loaded.scenario, loaded.map);
    const long long seeds = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS") ? 200 : 20;
    for (long long seed = 1; seed <= seeds; ++seed) {
      Loaded drawn = ofSeed(loaded, seed);
      const std::unique_ptr<sim2d::World> world = makeWorld(drawn);
      QVERIFY(world != nullptr);
      const sim2d::Frame& frame = world->frame();
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        const Vec2 place = poseOf(frame, i).position;
        const double radius =
            world->view().constants(world->view().indexOf(frame.humans.id[i])).radius;
        QVERIFY(!around.obstacles.isInside(place));
        for (std::size_t k = 0; k < i; ++k) {
          const double other =
              world->view().constants(world->view().indexOf(frame.humans.id[k])).radius;
          QVERIFY((poseOf(frame, k).position - place).norm() > radius + other - kTouch);
        }
        for (std::size_t k = 0; k < frame.robots.size(); ++k) {
          const Vec2 robot(frame.robots.x[k], frame.robots.y[k]);
          QVERIFY((robot - place).norm() >
                  radius + world->view().robotRadius(static_cast<int>(k)) - kTouch);
        }
      }
    }
  }

  void people_ofOneSeed_areThoseOfEveryRobot_data() { addScenarios(); }
  void people_ofOneSeed_areThoseOfEveryRobot() {
    QFETCH(QString, path);
    const Loaded loaded = load(path.toStdString());
    const Draws usual = drawsOf(ofSeed(loaded, 5));
    QVERIFY(usual != drawsOf(ofSeed(loaded, 6)));
    const auto planner = changed(loaded, 5, [](sim2d::Scenario& scenario) {
      for (sim2d::Robot& robot : scenario.robots) {
        robot.planner = "mppi";
      }
    });
    QVERIFY(drawsOf(planner) == usual);
    const auto noRobot = changed(loaded, 5, [](sim2d::Scenario& scenario) {
      for (sim2d::Robot& robot : scenario.robots) {
        robot.listed = false;
      }
    });
    QVERIFY(drawsOf(noRobot) == usual);
    const auto otherStep =
        changed(loaded, 5, [](sim2d::Scenario& scenario) { scenario.desktop.dt = 0.02; });
    QVERIFY(drawsOf(otherStep) == usual);
  }

  void people_inAnotherOrder_areTheSame() {
    const Loaded loaded = load("corner_cafe", "corner_cafe_agents");
    const auto turned = changed(loaded, 5, [](sim2d::Scenario& scenario) {
      std::reverse(scenario.humans.begin(), scenario.humans.end());
    });
    QVERIFY(drawsOf(turned) == drawsOf(ofSeed(loaded, 5)));
    QCOMPARE(hashOfRun(ofSeed(loaded, 5), 100, 2), hashOfRun(ofSeed(loaded, 5), 100, 1));
  }

  void noVariation_isTheRunWithoutTheKey() {
    const Loaded loaded = load("corner_cafe", "corner_cafe_agents");
    const auto without = changed(loaded, 7, [](sim2d::Scenario& scenario) {
      scenario.desktop.variation = sim2d::VariationSettings();
    });
    const auto none = changed(loaded, 7, [](sim2d::Scenario& scenario) {
      scenario.desktop.variation.preset = sim2d::VariationPreset::None;
    });
    QCOMPARE(hashOfRun(none, 100), hashOfRun(without, 100));
    QVERIFY(hashOfRun(ofSeed(loaded, 7), 100) != hashOfRun(without, 100));
  }

 private:
  static void addScenarios() {
    QTest::addColumn<QString>("path");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(mapsFolder())) {
      const base::Result<std::string> text = base::readTextFile(entry.path().string());
      if (entry.path().extension() == ".yaml" && isTakenByLongTests(entry.path()) && text &&
          text->find("hunav_loader:") != std::string::npos) {
        QTest::newRow(entry.path().stem().c_str()) << QString::fromStdString(entry.path().string());
      }
    }
  }
};

QTEST_APPLESS_MAIN(VariedPeopleTest)
#include "tst_VariedPeople.moc"
