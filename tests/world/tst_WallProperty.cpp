#include <filesystem>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"
#include "sim2d/map/MapReader.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "tests/support/LibraryFiles.h"
#include "tests/world/TestWorld.h"

using namespace testworld;
namespace fs = std::filesystem;

namespace {

constexpr double kRadius = 0.25;   // [m]
constexpr double kDeepest = 0.05;  // [m] that a body may be in a wall
constexpr int kMaxPeople = 120;    // enough for the ways of large worlds
constexpr int kAgentSteps = 1000000;

bool isTaken(const Scenario& scenario, const Vec2& place) {
  return std::any_of(scenario.humans.begin(), scenario.humans.end(), [&](const Human& human) {
    return (human.initPose.position - place).norm() < 2.2 * kRadius;
  });
}

Vec2 placeIn(const OccupancyGrid& map, const base::AgentRng& rng, std::uint32_t number) {
  return map.cornerToWorld(rng.uniform(0.0, map.width(), base::DrawPurpose::Test, 2 * number),
                           rng.uniform(0.0, map.height(), base::DrawPurpose::Test, 2 * number + 1));
}

/// People at random places that are free.
Scenario crowdIn(const OccupancyGrid& map, const Obstacles& obstacles) {
  Scenario scenario;
  const base::AgentRng rng(5, 0, 0);
  for (std::uint32_t trial = 0; trial < 20000; ++trial) {
    const Vec2 place = placeIn(map, rng, trial);
    if (static_cast<int>(scenario.humans.size()) < kMaxPeople && !isTaken(scenario, place) &&
        obstacles.clearance(place) > 1.2 * kRadius) {
      Human& human = addPerson(scenario, static_cast<int>(scenario.humans.size()) + 1, place);
      human.radius = kRadius;
      human.maxVel = 2.0;
      human.ours.route = Route::Direct;
    }
  }
  return scenario;
}

/// A new place every second.
void walkAbout(const OccupancyGrid& map, const WorldView& view, Intents& intents) {
  for (int human = 0; human < view.humanCount(); ++human) {
    const base::AgentRng rng(view.seed(), human, static_cast<std::uint64_t>(view.step() / 20));
    Intent& intent = intents.of(human);
    intent.motion = Motion::Walk;
    intent.speed = 2.0;
    intent.target.position = placeIn(map, rng, 0);
  }
}

}  // namespace

/// Nobody ever gets through a wall: a million steps of people who walk to random places, straight
/// on, in each map that comes with the program.
class WallPropertyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void millionAgentSteps_inEachMap_neverPassAWall_data() {
    QTest::addColumn<QString>("path");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(SOURCE_DIR "/maps")) {
      const base::Result<std::string> text = base::readTextFile(entry.path().string());
      if (entry.path().extension() == ".yaml" && isTakenByLongTests(entry.path()) && text &&
          text->find("occupied_thresh") != std::string::npos) {
        QTest::newRow(entry.path().stem().c_str()) << QString::fromStdString(entry.path().string());
      }
    }
  }

  void millionAgentSteps_inEachMap_neverPassAWall() {
    QFETCH(QString, path);
    const base::Result<MapFile> file = readMap(path.toStdString(), {}, MapRule::Humble);
    QVERIFY(file);
    const OccupancyGrid& map = file->grid;
    const Obstacles obstacles = makeSurroundings(Scenario{}, map).obstacles;
    const Scenario scenario = crowdIn(map, obstacles);
    const int people = static_cast<int>(scenario.humans.size());
    QVERIFY(people > 10);
    const base::Result<std::unique_ptr<World>> world = create(
        scenario, [&](const WorldView& view, Intents& intents) { walkAbout(map, view, intents); },
        map);
    QVERIFY(world);
    std::vector<Vec2> before;
    before.reserve(static_cast<std::size_t>(people));
    for (int i = 0; i < people; ++i) {
      before.push_back(positionOf((*world)->frame(), static_cast<std::size_t>(i)));
    }
    int through = 0;
    double least = 1e9;
    for (int step = 0; step * people < kAgentSteps; ++step) {
      QVERIFY2((*world)->step(), (*world)->failure().c_str());
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Vec2 place = positionOf((*world)->frame(), i);
        through += obstacles.isVisible(before[i], place) ? 0 : 1;
        least = step % 10 == 0 ? std::min(least, obstacles.clearance(place, 1.0)) : least;
        before[i] = place;
      }
    }
    QCOMPARE(through, 0);
    QVERIFY2(least >= kRadius - kDeepest, qPrintable(QString::number(least)));
  }
};

QTEST_APPLESS_MAIN(WallPropertyTest)
#include "tst_WallProperty.moc"
