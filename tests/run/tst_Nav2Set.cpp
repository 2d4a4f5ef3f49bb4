#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <QtTest>

#include "app/run/Bundle.h"
#include "app/run/Nav2Robots.h"
#include "sim2d/base/Text.h"
#include "tests/run/LatticeFile.h"
#include "tests/run/Nav2SetFiles.h"

/// A set of parameter files as real robots have them: each is accepted, and nine of ten drive a
/// robot to its goal in two scenes with people. With HUNAV_ALL_TESTS all of them drive.
class Nav2SetTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void set_isLargeAndVaried();
  void files_areAccepted_data();
  void files_areAccepted();
  void lattice_fileBesideTheParameters_isRead();
  void lattice_badFile_isAnError();
  void robots_arrive_data();
  void robots_arrive();
  void robots_arrive_inNineOfTenRuns();

 private:
  int driven_ = 0, arrived_ = 0;
};

namespace {

/// Writes a text of a case into a file with this ending.
std::string writtenText(const nav2set::Case& file, const std::string& text, const char* ending) {
  std::string name = file.name;
  for (char& letter : name) {
    letter = std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  }
  const std::string path = std::string(TEST_OUTPUT_DIR) + "/tmp/nav2_set_" + name + ending;
  base::writeFileAtomically(path, text);
  return path;
}

std::string writtenFile(const nav2set::Case& file) {
  return writtenText(file, file.text, ".yaml");
}

std::string writtenTree(const nav2set::Case& file) {
  if (!file.tree.empty()) {
    return writtenText(file, file.tree, ".xml");
  }
  return SOURCE_DIR "/resources/nav2_trees/humble/navigate_to_pose_w_replanning_and_recovery.xml";
}

std::string errorsIn(const base::Diagnostics& problems) {
  std::string all;
  for (const base::Diagnostic& problem : problems) {
    all += problem.severity == base::Severity::Error ? problem.text() + "\n" : "";
  }
  return all;
}

nav2set::Case latticeCase(const std::string& name, const std::string& json) {
  base::writeFileAtomically(std::string(TEST_OUTPUT_DIR) + "/tmp/" + name + ".json", json);
  nav2set::Pieces pieces;
  pieces.planner =
      "    GridBased:\n      plugin: \"nav2_smac_planner::SmacPlannerLattice\"\n"
      "      lattice_filepath: \"/opt/acme/share/" +
      name + ".json\"\n";
  return {name, nav2set::fileOf(pieces)};
}

const nav2set::Case& caseOf(const QString& name) {
  static const std::vector<nav2set::Case> kCases = nav2set::allCases();
  return *std::find_if(kCases.begin(), kCases.end(),
                       [&](const nav2set::Case& each) { return each.name == name.toStdString(); });
}

/// Whether a robot with these parameters reaches the goal of a scene within two minutes.
bool arrives(const nav2set::Case& file, const std::string& scene) {
  constexpr double kLongest = 120.0;  // [s]
  app::RunSpec options;
  options.scenario = std::string(SOURCE_DIR "/maps/planners/") + scene + "_agents.yaml";
  options.planner = "nav2";
  options.nav2Params = {writtenFile(file)};
  options.nav2Tree = writtenTree(file);
  const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
  app::Verdict verdict = app::check(bundle);
  if (!verdict.world) {
    qInfo("%s", errorsIn(verdict.problems).c_str());
    return false;
  }
  sim2d::World& world = *verdict.world;
  while (!world.arrivedAt() && world.time() < kLongest && world.step()) {
  }
  if (!world.arrivedAt()) {
    const sim2d::RobotColumns& robots = world.frame().robots;
    qInfo("stands at %s", base::pointText({robots.x[0], robots.y[0]}).c_str());
  }
  return world.arrivedAt().has_value();
}

}  // namespace

void Nav2SetTest::set_isLargeAndVaried() {
  std::set<std::string> names, texts;
  for (const nav2set::Case& file : nav2set::allCases()) {
    names.insert(file.name);
    texts.insert(file.text);
  }
  QVERIFY(names.size() >= 50);
  QCOMPARE(texts.size(), names.size());
}

void Nav2SetTest::files_areAccepted_data() {
  QTest::addColumn<QString>("name");
  for (const nav2set::Case& file : nav2set::allCases()) {
    QTest::newRow(file.name.c_str()) << QString::fromStdString(file.name);
  }
}

/// No errors, and no key that nothing reads.
void Nav2SetTest::files_areAccepted() {
  QFETCH(QString, name);
  const base::Diagnostics problems = app::checkNav2Files({writtenFile(caseOf(name))});
  QVERIFY2(errorsIn(problems).empty(), errorsIn(problems).c_str());
  for (const base::Diagnostic& problem : problems) {
    const bool isUnread =
        problem.code == "nav2.unknown-key" || problem.code == "nav2.unnamed-block";
    QVERIFY2(!isUnread, problem.text().c_str());
  }
}

void Nav2SetTest::lattice_fileBesideTheParameters_isRead() {
  const nav2set::Case file = latticeCase("lattice_good", nav2set::latticeText());
  const base::Diagnostics problems = app::checkNav2Files({writtenFile(file)});
  QVERIFY2(errorsIn(problems).empty(), errorsIn(problems).c_str());
  QVERIFY(std::none_of(problems.begin(), problems.end(), [](const base::Diagnostic& each) {
    return each.code == "nav2.treated-as";
  }));
  QVERIFY(arrives(file, "doorway"));
}

void Nav2SetTest::lattice_badFile_isAnError() {
  std::string text = nav2set::latticeText();
  text.replace(text.find("\"end_angle_index\": 0"), 20, "\"end_angle_index\": 7");
  for (const std::string& json : {text, std::string("{"), std::string("[1]"), std::string()}) {
    const base::Diagnostics problems =
        app::checkNav2Files({writtenFile(latticeCase("lattice_bad", json))});
    QVERIFY(std::any_of(problems.begin(), problems.end(), [](const base::Diagnostic& each) {
      return each.code == "nav2.bad-lattice" && each.severity == base::Severity::Error;
    }));
  }
}

void Nav2SetTest::robots_arrive_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<QString>("scene");
  const bool drivesAll = qEnvironmentVariableIsSet("HUNAV_ALL_TESTS");
  for (const char* const scene : {"crossing", "doorway"}) {
    for (const nav2set::Case& file : nav2set::allCases()) {
      if (file.isQuick || drivesAll) {
        QTest::newRow((file.name + ", " + scene).c_str())
            << QString::fromStdString(file.name) << QString::fromLatin1(scene);
      }
    }
  }
}

/// A robot among people may give up, as Nav2 does; how many do is looked at below.
void Nav2SetTest::robots_arrive() {
  QFETCH(QString, name);
  QFETCH(QString, scene);
  ++driven_;
  const bool hasArrived = arrives(caseOf(name), scene.toStdString());
  arrived_ += hasArrived ? 1 : 0;
  if (!hasArrived) {
    qInfo("%s does not arrive in %s", qPrintable(name), qPrintable(scene));
  }
}

void Nav2SetTest::robots_arrive_inNineOfTenRuns() {
  qInfo("%d of %d runs arrive", arrived_, driven_);
  QVERIFY(driven_ > 0 && 10 * arrived_ >= 9 * driven_);
}

QTEST_GUILESS_MAIN(Nav2SetTest)
#include "tst_Nav2Set.moc"
