#include <filesystem>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/realism/RealismTest.h"

using namespace sim2d;
namespace fs = std::filesystem;

/// Scenes of the realism tests lie in maps/realism as well, to be opened and watched. The files
/// are written by this test: HUNAV_UPDATE=1.
class RealismScenesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void scene_onFile_isThatOfTheTest_data();
  void scene_onFile_isThatOfTheTest();
  void folder_holdsNothingElse();
};

namespace {

std::string folder() {
  return SOURCE_DIR "/maps/realism/";
}

std::string nameOf(const RealismTest& test) {
  std::string name = "realism_" + test.name + "_agents";
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace

void RealismScenesTest::scene_onFile_isThatOfTheTest_data() {
  QTest::addColumn<int>("index");
  for (std::size_t i = 0; i < realismTests().size(); ++i) {
    QTest::newRow(realismTests()[i].name.c_str()) << static_cast<int>(i);
  }
}

void RealismScenesTest::scene_onFile_isThatOfTheTest() {
  QFETCH(int, index);
  const RealismTest& test = realismTests()[static_cast<std::size_t>(index)];
  QVERIFY(test.scene != nullptr);
  const std::string name = nameOf(test);
  const std::string text = writeScenario(test.scene({"das", 1, {}}).scenario(name, test.duration));
  const std::string path = folder() + name + ".yaml";
  if (qEnvironmentVariableIntValue("HUNAV_UPDATE") == 1) {
    fs::create_directories(folder());
    QVERIFY(base::writeFileAtomically(path, text).empty());
  }
  const base::Result<std::string> onFile = base::readTextFile(path);
  QVERIFY(onFile);
  QVERIFY(*onFile == text);
}

void RealismScenesTest::folder_holdsNothingElse() {
  for (const fs::directory_entry& entry : fs::directory_iterator(folder())) {
    const std::string stem = entry.path().stem().string();
    const bool isKnown = std::any_of(realismTests().begin(), realismTests().end(),
                                     [&](const RealismTest& test) { return nameOf(test) == stem; });
    QVERIFY2(isKnown, stem.c_str());
  }
}

QTEST_APPLESS_MAIN(RealismScenesTest)
#include "tst_RealismScenes.moc"
