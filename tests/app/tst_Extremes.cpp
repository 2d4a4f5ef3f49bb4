#include <cmath>

#include <QTemporaryDir>
#include <QtTest>

#include "app/window/MainWindow.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/support/WrittenMap.h"

using app::MainWindow;

namespace {

using Cells = std::vector<std::int8_t>;

/// People in rows half a metre apart, with one goal for all.
sim2d::Scenario crowd(int people) {
  sim2d::Scenario scenario;
  scenario.yamlBaseName = "crowd";
  sim2d::GlobalGoal goal;
  goal.id = 1;
  goal.position = {0.5, 0.5};
  scenario.goals = {goal};
  for (int i = 0; i < people; ++i) {
    sim2d::Human human;
    human.id = i + 1;
    human.name = "p" + std::to_string(i + 1);
    const int row = i / 50;
    human.initPose.position = {1.0 + 0.8 * (i % 50), 1.0 + 0.8 * row};
    human.behavior.type = static_cast<sim2d::BehaviorType>(i % 6 + 1);
    human.goals = {1};
    scenario.humans.push_back(human);
  }
  return scenario;
}

}  // namespace

/// The window with next to nothing, or with very much, in it: it is opened, looked at, edited, run
/// and closed.
class ExtremesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }

  void scenario_anySize_isOpenedEditedAndRun_data() {
    QTest::addColumn<int>("people");
    QTest::addColumn<int>("side");   // of the map [cells], 0: none
    QTest::addColumn<int>("value");  // of its cells
    QTest::newRow("nothing at all") << 0 << 0 << 0;
    QTest::newRow("nobody on a map") << 0 << 400 << 0;
    QTest::newRow("one cell") << 0 << 1 << 0;
    QTest::newRow("nothing but wall") << 3 << 200 << 100;
    QTest::newRow("nothing known") << 3 << 200 << -1;
    QTest::newRow("people without a map") << 20 << 0 << 0;
    QTest::newRow("2000 people without a map") << 2000 << 0 << 0;
    QTest::newRow("2000 people on a map") << 2000 << 900 << 0;
  }
  void scenario_anySize_isOpenedEditedAndRun() {
    QFETCH(int, people);
    QFETCH(int, side);
    QFETCH(int, value);
    const QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("crowd.yaml"));
    write(crowd(people), side, value, folder);

    app::WindowSetup setup;
    setup.followsSystem = false;
    setup.storesSettings = false;
    MainWindow window(setup);
    window.resize(1280, 800);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    QVERIFY(window.open(file));
    editor::ScenarioDocument& document = window.workspace().document();
    QCOMPARE(static_cast<int>(document.scenario().humans.size()), people);
    QCOMPARE(document.map()->width(), side);
    look(window);
    edit(window);
    run(window);
    QVERIFY(window.files().saveTo(file));
    window.actions().close->trigger();
    QVERIFY(window.isOnStartPage());
  }

 private:
  static void write(sim2d::Scenario scenario, int side, int value, const QTemporaryDir& folder) {
    if (side > 0) {
      const sim2d::OccupancyGrid grid(
          side, side, 0.05, {},
          Cells(static_cast<std::size_t>(side) * static_cast<std::size_t>(side),
                static_cast<std::int8_t>(value)));
      const QString map = folder.filePath(QStringLiteral("place.yaml"));
      QVERIFY(!base::hasErrors(sim2d::writeMap(grid, map.toStdString())));
      scenario.map = "place";
    } else {
      scenario.desktop.mapFile = "none";
    }
    const std::string file = folder.filePath(QStringLiteral("crowd.yaml")).toStdString();
    QVERIFY(!base::hasErrors(base::writeFileAtomically(file, sim2d::writeScenario(scenario))));
  }

  static void look(MainWindow& window) {
    editor::MapView& view = window.workspace().view();
    for (const double factor : {4.0, 100.0, 0.001, 3.0}) {
      view.zoomBy(factor, view.viewport()->rect().center());
      view.viewport()->repaint();
    }
    window.actions().zoomFit->trigger();
    QTest::qWait(200);
    QVERIFY(!view.grab().isNull());
  }

  static void edit(MainWindow& window) {
    editor::ScenarioDocument& document = window.workspace().document();
    const sim2d::Scenario before = document.scenario();
    window.actions().selectAll->trigger();
    window.actions().duplicate->trigger();
    QCOMPARE(document.scenario().humans.size(), 2 * before.humans.size());
    QTest::qWait(50);
    document.undoStack().undo();
    window.actions().selectAll->trigger();
    window.actions().remove->trigger();
    QVERIFY(document.scenario().humans.empty() && document.scenario().goals.empty());
    document.undoStack().undo();
    QVERIFY(document.scenario() == before);
  }

  static void run(MainWindow& window) {
    editor::SimulationRunner& runner = window.workspace().runner();
    QTest::keyClick(&window.workspace().view(), Qt::Key_Space);
    const auto shows = [&window] {
      return window.workspace().scene().frameLayer().frame() != nullptr;
    };
    const auto says = [&window] { return window.docks().panel<editor::IssuesPanel>().hasErrors(); };
    QTRY_VERIFY_WITH_TIMEOUT(shows() || says(), 60000);
    runner.reset();
    QTRY_VERIFY(!shows());
  }
};

QTEST_MAIN(ExtremesTest)
#include "tst_Extremes.moc"
