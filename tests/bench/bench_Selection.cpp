#include <QElapsedTimer>
#include <QtTest>

#include "app/window/MainWindow.h"
#include "editor/canvas/RouteModel.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"

using app::MainWindow;

namespace {

constexpr int kPeople = 2000;
constexpr int kInRow = 50;
constexpr double kGap = 0.8;  // [m]

sim2d::Scenario crowd() {
  sim2d::Scenario scenario;
  sim2d::GlobalGoal goal;
  goal.key = {base::EntityKind::Goal, 1};
  goal.id = 1;
  goal.position = {0.5, 0.5};
  scenario.goals = {goal};
  for (int i = 0; i < kPeople; ++i) {
    sim2d::Human human;
    human.key = {base::EntityKind::Human, i + 2};
    human.id = i + 1;
    human.name = "p" + std::to_string(i + 1);
    human.initPose.position = {1.0 + kGap * (i % kInRow), 1.0 + kGap * (i / kInRow)};
    human.behavior.type = static_cast<sim2d::BehaviorType>(i % 6 + 1);
    human.goals = {1};
    scenario.humans.push_back(human);
  }
  return scenario;
}

}  // namespace

/// The commands of the window on a crowd that is selected as a whole: until the window has
/// followed, with its first picture after it.
class SelectionBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void commands_2000selected() {
    editor::applyTheme(editor::Theme::light());
    app::WindowSetup setup;
    setup.followsSystem = false;
    setup.storesSettings = false;
    MainWindow window(setup);
    window.resize(1280, 800);
    window.show();
    QVERIFY(QTest::qWaitForWindowExposed(&window));
    window.actions().newOpenPlane->trigger();
    editor::ScenarioDocument& document = window.workspace().document();
    document.load(crowd());
    window.actions().zoomFit->trigger();
    window.workspace().scene().routes().finish();
    QTest::qWait(500);

    QCOMPARE(document.scenario().humans.size(), std::size_t{kPeople});

    const app::WindowActions& actions = window.actions();
    time("select all", [&] { actions.selectAll->trigger(); });
    time("nudge", [&] { press(window, Qt::Key_Right); });
    time("nudge again", [&] { press(window, Qt::Key_Right); });
    time("rotate", [&] { press(window, Qt::Key_BracketLeft); });
    time("align", [&] { arrangeBy(window, QStringLiteral("Align left")); });
    time("undo of align", [&] { actions.undo->trigger(); });
    time("redo of align", [&] { actions.redo->trigger(); });
    time("duplicate", [&] { actions.duplicate->trigger(); });
    time("undo of duplicate", [&] { actions.undo->trigger(); });
    time("redo of duplicate", [&] { actions.redo->trigger(); });
    actions.undo->trigger();
    actions.selectAll->trigger();
    time("copy", [&] { actions.copy->trigger(); });
    time("paste", [&] { actions.paste->trigger(); });
    time("cut", [&] { actions.cut->trigger(); });
    actions.undo->trigger();
    actions.undo->trigger();
    actions.selectAll->trigger();
    time("switch off", [&] { editor::pushListed(document, document.selection(), false); });
    time("undo of switch off", [&] { actions.undo->trigger(); });
    time("route", [&] { editor::pushRoute(document, document.selection(), {1, 1}); });
    time("delete", [&] { actions.remove->trigger(); });
    time("undo of delete", [&] { actions.undo->trigger(); });
    time("redo of delete", [&] { actions.redo->trigger(); });
    while (document.undoStack().canUndo()) {
      document.undoStack().undo();
    }
    QCOMPARE(document.scenario().humans.size(), std::size_t{kPeople});
    QTest::setBenchmarkResult(worst_, QTest::WalltimeMilliseconds);
  }

 private:
  static void press(MainWindow& window, Qt::Key key) {
    window.workspace().view().setFocus();
    QTest::keyClick(&window.workspace().view(), key);
  }
  static void arrangeBy(MainWindow& window, const QString& words) {
    QMenu menu;
    window.actions().fillArrangeMenu(menu);
    for (QAction* action : menu.actions()) {
      if (action->text().remove(QLatin1Char('&')) == words) {
        action->trigger();
        return;
      }
    }
    QFAIL(qPrintable(words));
  }
  template <class Work>
  void time(const char* what, Work&& work) {
    QElapsedTimer clock;
    clock.start();
    work();
    const double done = 1e-6 * double(clock.nsecsElapsed());
    QCoreApplication::processEvents();
    const double seen = 1e-6 * double(clock.nsecsElapsed());
    qInfo("%-20s %8.1f ms, seen after %8.1f ms", what, done, seen);
    worst_ = std::max(worst_, seen);
    QTest::qWait(400);  // the check and the ways have followed
  }

  double worst_ = 0.0;
};

QTEST_MAIN(SelectionBench)
#include "bench_Selection.moc"
