#include <cmath>

#include "app/window/MainWindow.h"
#include "app/window/StartPage.h"
#include "app/window/WindowCommand.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/properties/PropertyPanel.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;

class MainWindowTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<MainWindow> window_;

  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  editor::MapView& view() { return window_->workspace().view(); }
  QPoint inWindow(const base::Vec2& world) {
    return view().viewport()->mapTo(window_.get(), view().viewportFrom(world));
  }
  /// Real mouse events of the window system, as a user makes them.
  void drag(const base::Vec2& from, const base::Vec2& to) {
    QWindow* handle = window_->windowHandle();
    QTest::mouseMove(handle, inWindow(from));
    QTest::mousePress(handle, Qt::LeftButton, {}, inWindow(from));
    QTest::mouseMove(handle, inWindow(0.5 * (from + to)));
    QTest::mouseMove(handle, inWindow(to));
    QTest::mouseRelease(handle, Qt::LeftButton, {}, inWindow(to));
    QCoreApplication::processEvents();
  }
  void chooseTool(const QString& icon) {
    for (QAction* action : window_->workspace().tools().actions().actions()) {
      if (action->data().toString() == icon) {
        action->trigger();
        return;
      }
    }
    QFAIL("no such tool");
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { window_ = quiet::shownWindow(); }
  void cleanup() { quiet::leave(window_); }

  void start_showsTheStartPage() {
    QVERIFY(window_->isOnStartPage());
    QCOMPARE(window_->windowTitle(), QStringLiteral("HuNavSim Desktop"));
    window_->actions().newOpenPlane->trigger();
    QVERIFY(!window_->isOnStartPage());
    QVERIFY(view().isVisible());
  }

  void start_sizeWithoutMemory_isNoLargerThanTheScreen() {
    const MainWindow window(quiet::setup());
    const QSize screen = window.screen()->availableGeometry().size();
    QVERIFY(window.width() <= std::max(screen.width(), window.minimumWidth()));
    QVERIFY(window.height() <= std::max(screen.height(), window.minimumHeight()));
    QVERIFY(window.width() <= 1280 && window.height() <= 800);
  }

  void tool_chosen_hearsItsKeys() {
    window_->actions().newOpenPlane->trigger();
    auto* filter = window_->findChild<QLineEdit*>();
    QVERIFY(filter != nullptr);
    filter->setFocus();
    chooseTool(QStringLiteral("tool-area"));
    QVERIFY(view().hasFocus());
  }

  void status_ground_tellsUnknownFromFree() {
    window_->actions().newOpenPlane->trigger();
    std::vector<std::int8_t> cells(100, 0);
    std::fill(cells.begin(), cells.begin() + 50, std::int8_t{-1});  // the lower half
    document().setMap(
        std::make_shared<sim2d::OccupancyGrid>(10, 10, 1.0, base::Pose2{}, std::move(cells)));
    QTest::qWait(50);
    const auto says = [this](const QString& word) {
      return widgets::withText<QLabel>(*window_->statusBar(), word) != nullptr;
    };
    Q_EMIT view().cursorMoved(base::Vec2(5.0, 2.0));
    QVERIFY(says(QStringLiteral("5.00, 2.00 m · unknown")));
    Q_EMIT view().cursorMoved(base::Vec2(5.0, 8.0));
    QVERIFY(says(QStringLiteral("5.00, 8.00 m · free")));
  }

  void mouse_personAndGoal_placedAssignedSavedReopened() {
    window_->actions().newOpenPlane->trigger();
    QTest::qWait(50);
    const base::Vec2 start(1.0, 0.5);
    chooseTool(QStringLiteral("tool-person"));
    drag(start, base::Vec2(1.0, 2.0));
    QCOMPARE(document().scenario().humans.size(), std::size_t(1));
    const sim2d::Human& placed = document().scenario().humans.front();
    QVERIFY((placed.initPose.position - start).norm() < 0.05);
    QVERIFY(std::abs(placed.initPose.heading - base::kPi / 2.0) < 0.05);
    chooseTool(QStringLiteral("tool-goal"));
    drag(base::Vec2(3.0, 1.0), base::Vec2(3.0, 1.0));
    QCOMPARE(document().scenario().goals.size(), std::size_t(1));
    const int goal = document().scenario().goals.front().id;
    const editor::EntityId person = document().scenario().humans.front().key;
    if (document().scenario().humans.front().goals.empty()) {
      editor::pushRoute(document(), {person}, {goal});
    }
    QCOMPARE(document().scenario().humans.front().goals, std::vector<int>{goal});
    const sim2d::Scenario whole = document().scenario();

    while (document().undoStack().canUndo()) {
      window_->actions().undo->trigger();
    }
    QVERIFY(document().scenario().humans.empty());
    QVERIFY(document().scenario().goals.empty());
    while (document().undoStack().canRedo()) {
      window_->actions().redo->trigger();
    }
    QVERIFY(document().scenario() == whole);

    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("made.yaml"));
    QVERIFY(window_->isWindowModified());
    QVERIFY(window_->files().saveTo(file));
    QVERIFY(!window_->isWindowModified());
    QVERIFY(window_->windowTitle().startsWith(QStringLiteral("made.yaml")));
    const sim2d::Scenario saved = sim2d::withoutDefaults(document().scenario());
    window_->actions().newOpenPlane->trigger();
    QVERIFY(document().scenario().humans.empty());
    QVERIFY(window_->open(file));
    QVERIFY(sim2d::withoutDefaults(document().scenario()) == saved);
  }

  void keys_deleteAndDuplicate_areUndoable() {
    QVERIFY(window_->open(quiet::demoPath()));
    const std::size_t people = document().scenario().humans.size();
    document().setSelection({document().scenario().humans.front().key});
    window_->actions().duplicate->trigger();
    QCOMPARE(document().scenario().humans.size(), people + 1);
    window_->actions().remove->trigger();
    QCOMPARE(document().scenario().humans.size(), people);
    window_->actions().copy->trigger();
    document().undoStack().undo();
    document().undoStack().undo();
    QCOMPARE(document().scenario().humans.size(), people);
    QVERIFY(!document().isDirty());
  }

  void keys_f2OnTheMap_renamesInTheList() {
    QVERIFY(window_->open(quiet::demoPath()));
    QVERIFY(!window_->actions().rename->isEnabled());
    document().setSelection({document().entities(base::EntityKind::Human).front()});
    view().setFocus();
    QTest::keyClick(view().window()->windowHandle(), Qt::Key_F2);
    QWidget* const field = QApplication::focusWidget();
    QVERIFY(qobject_cast<QLineEdit*>(field) != nullptr);
    QTest::keyClicks(field, QStringLiteral("Zoe"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(document().scenario().humans.front().name, std::string("Zoe"));
    document().undoStack().undo();
  }

  void open_brokenFile_tellsInTheIssues() {
    QTemporaryDir folder;
    const QString file = folder.filePath(QStringLiteral("broken.yaml"));
    QFile broken(file);
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("hunav_loader:\n  ros__parameters:\n    agents: [a\n");
    broken.close();
    QVERIFY(!window_->open(file));
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().isVisible());
  }

  void theme_switched_changesAtOnce() {
    QVERIFY(window_->open(quiet::demoPath()));
    const QColor before = QApplication::palette().color(QPalette::Window);
    window_->actions().switchTheme->trigger();
    QVERIFY(window_->workspace().theme().isDark());
    QVERIFY(QApplication::palette().color(QPalette::Window) != before);
    window_->actions().switchTheme->trigger();
    QCOMPARE(QApplication::palette().color(QPalette::Window), before);
  }

  void space_onTheMap_runsAndPauses() {
    QVERIFY(window_->open(quiet::demoPath()));
    editor::MapView& view = window_->workspace().view();
    const auto state = [this] { return window_->workspace().runner().state(); };
    view.setFocus();
    QTest::keyClick(&view, Qt::Key_Space);
    QCOMPARE(state(), editor::SimulationRunner::State::Running);
    const auto steps = [this] {
      const sim2d::Frame* frame = window_->workspace().scene().frameLayer().frame();
      return frame == nullptr ? 0 : static_cast<int>(frame->step);
    };
    QTRY_VERIFY_WITH_TIMEOUT(steps() > 10, 20000);
    QTest::keyClick(&view, Qt::Key_Space);
    QCOMPARE(state(), editor::SimulationRunner::State::Paused);
    window_->workspace().runner().reset();
  }

  void words_ofAllActions_areTheSameAfterEditingAndClosing() {
    const auto words = [this] {
      QStringList all;
      for (const QAction* action : window_->workspace().tools().actions().actions()) {
        all << action->text() << action->toolTip();
      }
      const app::WindowActions& actions = window_->actions();
      for (const QAction* action : {actions.newFromMap, actions.open, actions.save, actions.close,
                                    actions.assignGoals, actions.remove, actions.duplicate}) {
        all << action->text() << action->toolTip() << action->statusTip();
      }
      return all;
    };
    const QStringList before = words();
    QVERIFY(window_->open(quiet::demoPath()));
    QCOMPARE(words(), before);
    document().setSelection({document().scenario().humans.front().key});
    window_->actions().duplicate->trigger();
    QCOMPARE(words(), before);
    document().undoStack().undo();
    window_->actions().close->trigger();
    QVERIFY(window_->isOnStartPage());
    QCOMPARE(words(), before);
  }

  void shortcuts_areUnique() {
    QMap<QString, QString> owners;
    QList<QAction*> actions = window_->findChildren<QAction*>();
    actions += window_->workspace().tools().actions().actions();
    actions += window_->workspace().playback().all();
    QSet<QAction*> seen;
    for (QAction* action : actions) {
      const QString keys = action->shortcut().toString();
      if (keys.isEmpty() || seen.contains(action)) {
        continue;
      }
      seen.insert(action);
      QVERIFY2(!owners.contains(keys), qPrintable(keys + action->text() + owners[keys]));
      owners[keys] = action->text();
    }
    QVERIFY(owners.size() > 20);
  }

  void docks_chosenByName_areTheOnlyOnes() {
    QVERIFY(window_->open(quiet::demoPath()));
    window_->docks().show({QStringLiteral("properties")});
    QVERIFY(window_->docks().dock(QStringLiteral("Properties"))->isVisible());
    QVERIFY(!window_->docks().dock(QStringLiteral("scenario"))->isVisible());
    QVERIFY(window_->docks().dock(QStringLiteral("nothing")) == nullptr);
    window_->actions().resetLayout->trigger();
    QVERIFY(window_->docks().dock(QStringLiteral("scenario"))->isVisible());
  }

  void screenshot_ofARun_isAPictureOfTheSize() {
    QVERIFY(window_->open(quiet::demoPath()));
    QTemporaryDir folder;
    app::WindowOptions options;
    options.screenshot = folder.filePath(QStringLiteral("run.png")).toStdString();
    options.at = 0.5;
    const base::Diagnostics problems = app::takeScreenshot(*window_, options);
    QVERIFY2(problems.empty(), problems.empty() ? "" : problems.front().text().c_str());
    const QImage picture(QString::fromStdString(options.screenshot));
    QCOMPARE(picture.size(), QSize(1280, 800));
    QVERIFY(std::abs(window_->workspace().runner().shownFrame()->time - 0.5) < 1e-9);
  }

  void size_fromText_needsTwoNumbers() {
    QCOMPARE(*app::sizeFromText("1280x800"), QSize(1280, 800));
    QVERIFY(!app::sizeFromText("1280"));
    QVERIFY(!app::sizeFromText("1280x"));
    QVERIFY(!app::sizeFromText("12x8000000"));
  }

  void ago_isSaidInWords() {
    const QDateTime now(QDate(2024, 5, 17), QTime(12, 0));
    QCOMPARE(app::relativeTimeText(now.addSecs(-130), now), QStringLiteral("2 min ago"));
    QCOMPARE(app::relativeTimeText(now.addDays(-1), now), QStringLiteral("Yesterday"));
    QCOMPARE(app::relativeTimeText(now.addDays(-40), now), QStringLiteral("7 Apr"));
  }
};

QTEST_MAIN(MainWindowTest)
#include "tst_MainWindow.moc"
