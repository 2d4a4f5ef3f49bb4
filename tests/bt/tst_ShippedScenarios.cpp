#include <cmath>
#include <map>
#include <sstream>

#include <QtTest>

#include "tests/bt/ShippedScenario.h"
#include "tests/support/Sanitizers.h"
#include "tests/support/TraceHash.h"

using namespace shipped;
namespace fs = std::filesystem;

namespace {

constexpr double kLeastRun = 20.0;        // [s]
constexpr double kDeepestOverlap = 0.05;  // [m]
constexpr std::size_t kLargeCrowd = 60;
constexpr double kLongestRun = 20.0;  // [s] of a large crowd
constexpr double kShortRun = 1.0;     // [s] of a scenario without a hash on file

/// Name -> path.
std::map<std::string, std::string> scenarios() {
  std::map<std::string, std::string> found;
  for (const std::string& folder : {mapsFolder(), std::string(GENERATED_MAPS)}) {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      const base::Result<std::string> text = base::readTextFile(entry.path().string());
      if (entry.path().extension() == ".yaml" && text &&
          text->find("hunav_loader:") != std::string::npos) {
        found[entry.path().stem().string()] = entry.path().string();
      }
    }
  }
  return found;
}

/// tests/golden/shipped_scenarios.txt: "<name> <hash>" per line. HUNAV_UPDATE=1 writes it anew.
std::string goldenPath() {
  return SOURCE_DIR "/tests/golden/shipped_scenarios.txt";
}

std::map<std::string, std::string> readGolden() {
  std::map<std::string, std::string> hashes;
  const base::Result<std::string> text = base::readTextFile(goldenPath());
  std::istringstream lines(text ? *text : "");
  std::string name;
  std::string hash;
  while (lines >> name >> hash) {
    hashes[name] = hash;
  }
  return hashes;
}

bool writeGolden(const std::map<std::string, std::string>& hashes) {
  std::string text;
  for (const auto& [name, hash] : hashes) {
    text.append(name).append(" ").append(hash).append("\n");
  }
  return base::writeFileAtomically(goldenPath(), text).empty();
}

/// Scenarios without a hash on file (the library) run for a short time only.
bool isRunCompletely(const std::string& name) {
  static const std::map<std::string, std::string> kGolden = readGolden();
  return kGolden.count(name) != 0;
}

sim2d::StopRule stopRuleOf(const Loaded& loaded) {
  sim2d::StopRule rule = sim2d::stopRuleOf(*loaded.scenario);
  if (loaded.scenario->humans.size() > kLargeCrowd) {
    const double dt = loaded.scenario->desktop.dt.value_or(0.05);
    rule.maximumSteps = std::min<std::int64_t>(rule.maximumSteps, std::llround(kLongestRun / dt));
  }
  return rule;
}

std::string hashOfRun(const std::string& path, int threads) {
  Loaded loaded = load(path);
  const std::unique_ptr<sim2d::World> world = makeWorld(loaded, threads);
  if (!world) {
    return {};
  }
  sim2d::Recording recording(loaded.scenario->desktop.recordEvery.value_or(1));
  const sim2d::RunResult result = sim2d::run(*world, stopRuleOf(loaded), recording);
  if (result.status != sim2d::RunStatus::Finished) {
    return result.reason;
  }
  return QByteArray::number(qulonglong(sim2d::hashOf(recording.trace(world->header()))), 16)
      .toStdString();
}

bool isTooLarge(const Loaded& loaded) {
  return kIsSanitized && loaded.scenario->humans.size() > kLargeCrowd;
}

struct Disc {
  Vec2 position = Vec2::Zero();
  double radius = 0.0;
};

/// People, then robots.
std::vector<Disc> discsOf(const sim2d::Frame& frame, const sim2d::WorldView& view) {
  std::vector<Disc> discs;
  for (std::size_t i = 0; i < frame.humans.size(); ++i) {
    const int index = view.indexOf(frame.humans.id[i]);
    discs.push_back({poseOf(frame, i).position, view.constants(index).radius});
  }
  for (std::size_t i = 0; i < frame.robots.size(); ++i) {
    discs.push_back(
        {Vec2(frame.robots.x[i], frame.robots.y[i]), view.robotRadius(static_cast<int>(i))});
  }
  return discs;
}

double deepestOverlap(const std::vector<Disc>& discs) {
  double deepest = 0.0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t k = i + 1; k < discs.size(); ++k) {
      deepest = std::max(deepest, discs[i].radius + discs[k].radius -
                                      (discs[i].position - discs[k].position).norm());
    }
  }
  return deepest;
}

}  // namespace

/// Whatever lies in maps/ or is made by the build must work out of the box, and run as it did
/// before.
class ShippedScenariosTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void scenario_loaded_saysNothing_data() { addScenarios(); }
  void scenario_loaded_saysNothing() {
    QFETCH(QString, path);
    Loaded loaded = load(path.toStdString());
    const std::unique_ptr<sim2d::World> world = makeWorld(loaded);
    const std::string said = pendingDiagnostics(loaded.diagnostics);
    QVERIFY2(said.empty(), said.c_str());
    QVERIFY(world != nullptr);
    QVERIFY(loaded.map.isEmpty() == (loaded.scenario->desktop.mapFile == "none"));
    const fs::path file = path.toStdString();
    QVERIFY(loaded.scenario->yamlBaseName == file.stem().string());
    QVERIFY(*base::readTextFile(file.string()) == sim2d::writeScenario(*loaded.scenario));
    for (const fs::directory_entry& entry : fs::directory_iterator(file.parent_path())) {
      if (entry.path().filename().string().rfind(file.stem().string() + "__agent_", 0) == 0) {
        const bool isUsed =
            std::any_of(loaded.trees.begin(), loaded.trees.end(), [&](const auto& tree) {
              return fs::path(tree.second.path).filename() == entry.path().filename();
            });
        QVERIFY2(isUsed, entry.path().c_str());
      }
    }
  }

  void scenario_run_keepsPeopleApartAndOutOfWalls_data() { addScenarios(); }
  void scenario_run_keepsPeopleApartAndOutOfWalls() {
    QFETCH(QString, path);
    Loaded loaded = load(path.toStdString());
    if (isTooLarge(loaded)) {
      QSKIP("a large crowd, too slow under a sanitizer");
    }
    const std::unique_ptr<sim2d::World> world = makeWorld(loaded);
    QVERIFY(world != nullptr);
    const sim2d::Surroundings around = sim2d::makeSurroundings(*loaded.scenario, loaded.map);
    const bool isComplete = isRunCompletely(fs::path(path.toStdString()).stem().string());
    const double dt = loaded.scenario->desktop.dt.value_or(0.05);
    const std::vector<sim2d::Frame> frames = framesOf(
        *world, isComplete ? stopRuleOf(loaded).maximumSteps : std::llround(kShortRun / dt));
    QVERIFY2(world->failure().empty(), world->failure().c_str());
    QVERIFY(frames.back().time >= (isComplete ? kLeastRun : kShortRun) - 1e-9);
    for (const sim2d::Frame& frame : frames) {
      const std::vector<Disc> discs = discsOf(frame, world->view());
      for (const Disc& disc : discs) {
        QVERIFY2(!around.obstacles.isInside(disc.position), std::to_string(frame.time).c_str());
      }
      const double overlap = deepestOverlap(discs);
      QVERIFY2(overlap <= kDeepestOverlap,
               qPrintable(QStringLiteral("%1 m at %2 s").arg(overlap).arg(frame.time)));
    }
    base::Diagnostics found;
    world->behavior().takeDiagnostics(found);
    QVERIFY2(found.empty(), pendingDiagnostics(found).c_str());
  }

  void scenario_run_givesTheHashOnFile_data() { addScenarios(true); }
  void scenario_run_givesTheHashOnFile() {
    QFETCH(QString, path);
    if (isTooLarge(load(path.toStdString()))) {
      QSKIP("a large crowd, too slow under a sanitizer");
    }
    const std::string name = fs::path(path.toStdString()).stem().string();
    const std::string hash = hashOfRun(path.toStdString(), 1);
    QCOMPARE(QString::fromStdString(hashOfRun(path.toStdString(), 2)),
             QString::fromStdString(hash));
    std::map<std::string, std::string> golden = readGolden();
    if (qEnvironmentVariableIntValue("HUNAV_UPDATE") == 1) {
      golden[name] = hash;
      QVERIFY(writeGolden(golden));
    }
    QCOMPARE(QString::fromStdString(hash), QString::fromStdString(golden[name]));
  }

  void hashesOnFile_areOfScenariosThatExist() {
    std::map<std::string, std::string> golden = readGolden();
    const std::map<std::string, std::string> existing = scenarios();
    for (const auto& entry : readGolden()) {
      if (existing.count(entry.first) == 0) {
        golden.erase(entry.first);
      }
    }
    if (qEnvironmentVariableIntValue("HUNAV_UPDATE") == 1) {
      QVERIFY(writeGolden(golden));
    }
    QCOMPARE(readGolden().size(), golden.size());
  }

 private:
  static void addScenarios(bool onlyThoseWithHash = false) {
    QTest::addColumn<QString>("path");
    const std::map<std::string, std::string> golden = readGolden();
    for (const auto& [name, path] : scenarios()) {
      const bool isInLibrary = path.find("/library/") != std::string::npos;
      if (!onlyThoseWithHash || !isInLibrary || golden.count(name) != 0) {
        QTest::newRow(name.c_str()) << QString::fromStdString(path);
      }
    }
  }
};

QTEST_APPLESS_MAIN(ShippedScenariosTest)
#include "tst_ShippedScenarios.moc"
