#include <fstream>
#include <malloc.h>
#include <string>

#include "QuietWindow.h"
#include "app/run/Bundle.h"
#include "editor/canvas/RouteModel.h"
#include "tests/support/WrittenMap.h"

namespace {

constexpr int kSide = 9000;  // cells
constexpr double kCells = static_cast<double>(kSide) * kSide;

/// A hall with shelves and some ground that nobody knows.
sim2d::OccupancyGrid hall() {
  std::vector<std::int8_t> cells(std::size_t{kSide} * kSide, 0);
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const bool isBorder = std::min(row, column) < 8 || std::max(row, column) >= kSide - 8;
      const bool isShelf = row % 400 < 8 && column % 500 < 320;
      const bool isUnknown = row > 8000 && column > 8000;
      cells[std::size_t{kSide} * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)] =
          static_cast<std::int8_t>(isBorder || isShelf ? 100 : (isUnknown ? -1 : 0));
    }
  }
  return {kSide, kSide, 0.05, {}, std::move(cells)};
}

/// Memory of this program [bytes], after what is free has been given back.
double residentBytes() {
  ::malloc_trim(0);
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.rfind("VmRSS:", 0) == 0) {
      return 1024.0 * static_cast<double>(std::stoll(line.substr(6)));
    }
  }
  return 0.0;
}

}  // namespace

/// What a map of 81 million cells costs while it is open. With HUNAV_ALL_TESTS alone: it takes half
/// a minute.
class LargeMapMemoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    if (!qEnvironmentVariableIsSet("HUNAV_ALL_TESTS")) {
      QSKIP("takes half a minute (HUNAV_ALL_TESTS)");
    }
    map_ = folder_.filePath(QStringLiteral("hall.yaml"));
    QVERIFY(!base::hasErrors(sim2d::writeMap(hall(), map_.toStdString())));
    QVERIFY(!quiet::copyOnMap(file_, "hall").isEmpty());
  }

  void open_fourBytesPerCell() {
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    const double before = residentBytes();
    QVERIFY(window->open(file_));
    app::Workspace& workspace = window->workspace();
    QCOMPARE(workspace.document().map()->width(), kSide);
    workspace.document().checkNow();
    workspace.scene().routes().finish();
    for (const double factor : {20.0, 10.0, 0.001}) {
      workspace.view().zoomBy(factor, workspace.view().viewport()->rect().center());
      QVERIFY(!workspace.view().grab().isNull());
    }
    const double perCell = (residentBytes() - before) / kCells;
    qInfo("%.2f bytes per cell", perCell);
    QVERIFY(perCell > 1.0 && perCell <= 4.0);
    quiet::leave(window);
  }

  /// The check of the map is under way; closed, it ends at its next row.
  void close_whileChecked_endsTheWork() {
    std::unique_ptr<app::MainWindow> window = quiet::shownWindow();
    QVERIFY(window->open(file_));
    const editor::ScenarioDocument& document = window->workspace().document();
    const std::shared_ptr<app::SurroundingsCache> known = document.surroundings();
    const sim2d::Scenario scenario = document.scenario();
    const auto map = document.map();
    const base::StopFlagPtr work = document.mapStopFlag();
    work->check();
    QVERIFY(known.use_count() > 2);  // the check has them as well as the document
    quiet::leave(window);
    QCOMPARE(known.use_count(), 1L);
    const auto askLayer = [&] {
      const auto around = known->of(scenario, map, work);
      return around->layers->of(around->grid, around->obstacles, {});
    };
    QVERIFY_EXCEPTION_THROWN(askLayer(), base::Stopped);  // it has not been made
  }

 private:
  const QTemporaryDir folder_;
  const QString file_ = folder_.filePath(QStringLiteral("hall_agents.yaml"));
  QString map_;
};

QTEST_MAIN(LargeMapMemoryTest)
#include "tst_LargeMapMemory.moc"
