#include <algorithm>
#include <filesystem>
#include <set>

#include <QtTest>

#include "app/run/Certificate.h"
#include "app/studies/FailureKind.h"
#include "app/studies/RunPool.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace fs = std::filesystem;

/// The scenarios of maps/library/failures: failures of shipped planners that searches have found.
class ShippedFailuresTest : public QObject {
  Q_OBJECT

 private:
  static std::vector<fs::path> files() {
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry :
         fs::directory_iterator(SOURCE_DIR "/maps/library/failures")) {
      const base::Result<std::string> text = base::readTextFile(entry.path().string());
      if (entry.path().extension() == ".yaml" && text &&
          text->find("hunav_loader:") != std::string::npos) {
        found.push_back(entry.path());
      }
    }
    std::sort(found.begin(), found.end());
    return found;
  }
  /// "failure_dwa_contact_left_moving" of planner "dwa" -> "contact-left-moving".
  static std::string kindIn(const std::string& name, const std::string& planner) {
    std::string kind = name.substr(std::min(name.size(), planner.size() + 9));
    std::replace(kind.begin(), kind.end(), '_', '-');
    return kind;
  }

 private Q_SLOTS:
  void failure_run_failsAsItsNameSays_data() {
    QTest::addColumn<QString>("path");
    for (const fs::path& file : files()) {
      QTest::newRow(file.stem().c_str()) << QString::fromStdString(file.string());
    }
  }
  void failure_run_failsAsItsNameSays() {
    QFETCH(QString, path);
    const sim2d::Scenario scenario = sim2d::readScenario(path.toStdString()).scenario;
    app::RunRequest request;
    request.scenario = path.toStdString();
    request.seed = *scenario.desktop.seed;
    const auto pool = app::RunPool::open({});
    const auto rows = (*pool)->run({request});
    QVERIFY(bool(rows));
    const auto kind = app::failureKindOf(rows->front());
    QVERIFY2(kind.has_value(), rows->front().reason.c_str());
    const std::string name = fs::path(path.toStdString()).stem().string();
    QCOMPARE(kind->name(), kindIn(name, scenario.robots.front().planner.value_or("pursuit")));
    QVERIFY(scenario.desktop.card.family == std::string(app::kFailureFamily));
  }

  void failures_differInKindAndPlanner() {
    std::set<std::string> kinds;
    for (const fs::path& file : files()) {
      const sim2d::Scenario scenario = sim2d::readScenario(file.string()).scenario;
      kinds.insert(
          kindIn(file.stem().string(), scenario.robots.front().planner.value_or("pursuit")));
    }
    QVERIFY(files().size() >= 10);
    QVERIFY2(kinds.size() >= 8, std::to_string(kinds.size()).c_str());
  }
};

QTEST_APPLESS_MAIN(ShippedFailuresTest)
#include "tst_ShippedFailures.moc"
