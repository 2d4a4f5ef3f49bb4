#include <filesystem>
#include <set>

#include <QTemporaryDir>
#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/realism/RealismTest.h"

using namespace sim2d;
namespace fs = std::filesystem;

/// Scenes of the realism tests come with the program as well, to be opened and watched: the build
/// writes them.
class RealismScenesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void scene_ofTheBuild_isThatOfTheTest_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < realismTests().size(); ++i) {
      QTest::newRow(realismTests()[i].name.c_str()) << static_cast<int>(i);
    }
  }

  void scene_ofTheBuild_isThatOfTheTest() {
    QFETCH(int, index);
    const RealismTest& test = realismTests()[static_cast<std::size_t>(index)];
    QVERIFY(test.scene != nullptr);
    const Scenario scene = sceneOf(test);
    const ScenarioReading read =
        readScenario(GENERATED_MAPS "/realism/" + sceneName(test) + ".yaml");
    QVERIFY(read.diagnostics.empty());
    QVERIFY(!scene.humans.empty());
    QCOMPARE(read.scenario.humans.size(), scene.humans.size());
    QVERIFY(writeScenario(read.scenario) == writeScenario(scene));
  }

  void writeScenes_oldFiles_areRemoved() {
    const QTemporaryDir place;
    const std::string folder = place.filePath(QStringLiteral("scenes")).toStdString();
    QVERIFY(fs::create_directory(folder));
    QVERIFY(base::writeFileAtomically(folder + "/realism_of_before_agents.yaml", "x").empty());
    QVERIFY(writeScenes(folder).empty());
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
      names.insert(entry.path().stem().string());
    }
    QCOMPARE(names.size(), realismTests().size());
    QVERIFY(names.count("realism_lanes_agents") == 1);
  }
};

QTEST_APPLESS_MAIN(RealismScenesTest)
#include "tst_RealismScenes.moc"
