#include "app/window/Docks.h"
#include "app/window/MainWindow.h"
#include "app/window/files/FileCommands.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/MetricsDock.h"
#include "editor/panels/ScenarioPanel.h"
#include "sim2d/base/Text.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;

namespace {

QString utf8(const char* text) {
  return QString::fromUtf8(text);
}

}  // namespace

/// What notices and panels leave as it was: room, sizes, the keyboard, and work that is only here.
class WindowStaysTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() { end(); }

  /// All words of a notice are seen, however little room the canvas has.
  void notice_inASmallWindow_isNotCut() {
    QVERIFY(window_->open(demoOnMap("nowhere")));
    for (const QSize& size : {QSize(1280, 800), QSize(900, 600), QSize(1600, 900)}) {
      window_->resize(size);
      QCoreApplication::processEvents();
      int seen = 0;
      for (const QLabel* label : window_->notices().findChildren<QLabel*>()) {
        if (label->isVisible() && label->text().startsWith(utf8("Map file"))) {
          ++seen;
          QVERIFY(label->width() >= 200);
          QVERIFY(label->height() >= label->heightForWidth(label->width()));
        }
      }
      QCOMPARE(seen, 1);
      for (const QPushButton* button : window_->notices().findChildren<QPushButton*>()) {
        seen += button->isVisible() ? 1 : 0;
        QVERIFY(button->width() >= button->sizeHint().width());
      }
      QCOMPARE(seen, 3);  // the words and two buttons
      quiet::shoot(*window_, size.width() == 900 ? "notice-small" : "notice-wide");
    }
  }

  /// Else the next key would go to a field that happens to be near.
  void notice_buttonIsPressed_mapHasTheKeyboard() {
    QVERIFY(window_->open(demoOnMap("nowhere")));
    QPushButton* plane = nullptr;
    for (QPushButton* button : window_->notices().findChildren<QPushButton*>()) {
      plane = button->isVisible() && button->text() == utf8("Use open plane") ? button : plane;
    }
    QVERIFY(plane != nullptr);
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    QTest::mouseClick(plane, Qt::LeftButton);
    QVERIFY(!window_->notices().has(utf8("map")));
    QVERIFY(window_->workspace().view().hasFocus());
    document().undoStack().undo();
    auto* cross = window_->notices().findChildren<QToolButton*>().back();
    cross->setFocus();
    QTest::keyClick(cross, Qt::Key_Space);
    QVERIFY(!window_->notices().has(utf8("map")));
    QVERIFY(window_->workspace().view().hasFocus());
  }

  /// The map and what is under the pointer stay where they are while notices come and go.
  void notices_comeAndGo_theMapStays() {
    QVERIFY(window_->open(quiet::demoPath()));
    const editor::MapView& view = window_->workspace().view();
    const auto place = [&view] {
      const QPoint shown = view.mapFromScene(view.sceneRect().center());
      return QRect(view.viewport()->mapToGlobal(shown), view.viewport()->size());
    };
    QTest::qWait(200);  // until the map is fitted
    const QRect before = place();
    window_->notices().inform(utf8("a"), utf8("Something happened."), {});
    window_->notices().warn(utf8("b"), utf8("Something else happened."));
    QTest::qWait(200);
    QCOMPARE(place(), before);
    const app::NoticeBar& bar = window_->notices();
    QVERIFY(bar.isVisible());
    QCOMPARE(bar.width(), bar.parentWidget()->width());
    QVERIFY(bar.height() >= 80);
    quiet::shoot(*window_, "notices-over-the-map");
    window_->notices().drop(utf8("a"));
    window_->notices().drop(utf8("b"));
    QTest::qWait(200);
    QCOMPARE(place(), before);
    window_->notices().warn(utf8("c"), utf8("Something happened again."));
    QCoreApplication::processEvents();
    window_->workspace().view().fitAll(false);  // now the map is fitted below the notice
    const int top = view.mapFromScene(window_->workspace().scene().contentRect().topLeft()).y();
    QVERIFY2(top >= bar.height(), qPrintable(QStringLiteral("%1 %2").arg(top).arg(bar.height())));
    window_->notices().drop(utf8("c"));
    window_->workspace().view().fitAll(false);
    QCOMPARE(place(), before);
  }

  /// Beside the large tree they have their own row: the buttons of the tree stay in reach.
  void notice_besideTheLargeTree_coversNothing() {
    QVERIFY(window_->open(quiet::demoPath()));
    window_->docks().treeMaximized()->setChecked(true);
    window_->notices().warn(utf8("a"), utf8("Something happened."));
    QCoreApplication::processEvents();
    const app::NoticeBar& bar = window_->notices();
    QTRY_VERIFY(bar.isVisible() && bar.height() >= 40);
    const QWidget& tree = *bar.parentWidget();
    QVERIFY(tree.layout()->indexOf(&window_->notices()) == 0);
    window_->docks().treeMaximized()->setChecked(false);
    QTRY_VERIFY(bar.isVisible() && bar.parentWidget() != &tree);
    QCOMPARE(bar.pos(), QPoint(0, 0));
  }

  void notices_several_onlyTheCanvasGivesUpRoom() {
    QVERIFY(window_->open(quiet::demoPath()));
    for (const QSize& size : {QSize(1280, 800), QSize(900, 600)}) {
      window_->resize(size);
      QCoreApplication::processEvents();
      const std::vector<QSize> before = dockSizes();
      for (const char* id : {"a", "b", "c"}) {
        window_->notices().post(
            {utf8(id), true, utf8("Something that takes some words to say. ").repeated(4), {}});
        QCoreApplication::processEvents();
        QVERIFY(dockSizes() == before);
      }
      for (const char* id : {"a", "b", "c"}) {
        window_->notices().drop(utf8(id));
      }
      QCoreApplication::processEvents();
      QVERIFY(dockSizes() == before);
    }
  }

  /// The map comes first: no less than three fifths of the window, while editing and in a run.
  void map_byDefault_hasThreeFifthsOfTheWindow() {
    QVERIFY(window_->open(quiet::demoPath()));
    const QWidget& map = *window_->workspace().view().viewport();
    for (const QSize& size : {QSize(1280, 800), QSize(1920, 1080)}) {
      window_->resize(size);
      window_->workspace().runner().reset();
      QTRY_COMPARE(window_->size(), size);
      QTRY_VERIFY2(5 * map.width() * map.height() >= 3 * size.width() * size.height(),
                   qPrintable(QStringLiteral("%1 x %2").arg(map.width()).arg(map.height())));
      window_->workspace().runner().stepOnce();
      QTRY_VERIFY(window_->workspace().scene().isRunMode());
      QVERIFY(5 * map.width() * map.height() >= 3 * size.width() * size.height());
    }
  }

  void panels_byTheirKeys_openComeToTheFrontAndClose() {
    QVERIFY(window_->open(quiet::demoPath()));
    window_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    const auto press = [this](Qt::Key key, Qt::KeyboardModifier with = Qt::AltModifier) {
      QTest::keyClick(window_->windowHandle(), key, with);
      QCoreApplication::processEvents();
    };
    QDockWidget* issues = window_->docks().dock(utf8("issues"));
    QDockWidget* metrics = window_->docks().dock(utf8("metrics"));
    QVERIFY(issues->isHidden() && metrics->isHidden());
    press(Qt::Key_5);
    QVERIFY(!metrics->isHidden() && !metrics->visibleRegion().isEmpty());
    press(Qt::Key_4);
    QVERIFY(!issues->visibleRegion().isEmpty() && metrics->visibleRegion().isEmpty());
    press(Qt::Key_5);  // it is behind the issues
    QVERIFY(!metrics->visibleRegion().isEmpty() && issues->visibleRegion().isEmpty());
    press(Qt::Key_5);
    QVERIFY(metrics->isHidden() && !issues->visibleRegion().isEmpty());
    press(Qt::Key_F9, Qt::NoModifier);
    for (const QDockWidget* dock : window_->docks().all()) {
      QVERIFY2(dock->isHidden(), qPrintable(dock->windowTitle()));
    }
    press(Qt::Key_F9, Qt::NoModifier);
    QVERIFY(!issues->visibleRegion().isEmpty() && metrics->isHidden());
    QVERIFY(window_->docks().dock(utf8("scenario"))->isVisible());
    window_->actions().resetLayout->trigger();
    QVERIFY(issues->isHidden());
  }

  /// A panel that covered another one uncovers it.
  void panel_closed_leavesTheOneBeforeInFront() {
    QVERIFY(window_->open(quiet::demoPath()));
    const QDockWidget& properties = *window_->docks().dock(utf8("properties"));
    QTRY_VERIFY(!properties.visibleRegion().isEmpty());
    QAction& layers = *window_->docks().toggleOf(*window_->docks().dock(utf8("layers")));
    layers.trigger();
    QTRY_VERIFY(properties.visibleRegion().isEmpty());
    layers.trigger();
    QTRY_VERIFY(!properties.visibleRegion().isEmpty());
    QVERIFY(!layers.isIconVisibleInMenu());  // its menu entry shows a check mark instead
  }

  /// An icon would replace the check mark.
  void checkableCommands_inMenus_haveNoIcons() {
    const app::WindowActions& actions = window_->actions();
    for (const QAction* each : actions.overlays + actions.layers + actions.snapping) {
      QVERIFY2(!each->isIconVisibleInMenu(), qPrintable(each->text()));
    }
  }

  /// Closed panels say in the status bar how much there is in them.
  void panels_closed_areCountedInTheStatusBar() {
    QVERIFY(window_->open(quiet::demoPath()));
    QToolButton* issues = nullptr;
    for (auto* each : window_->statusBar()->findChildren<QToolButton*>()) {
      issues = each->text().startsWith(utf8("Issues")) ? each : issues;
    }
    QVERIFY(issues != nullptr);
    QVERIFY(issues->isVisible() && issues->icon().isNull());
    window_->docks().panel<editor::IssuesPanel>().setActionIssues(
        {base::error("run.failed", {"odd"}), base::warning("run.failed", {"even"})});
    QCOMPARE(issues->text(), utf8("Issues  2"));
    QVERIFY(!issues->icon().isNull());
    QTest::mouseClick(issues, Qt::LeftButton);
    QTRY_VERIFY(window_->docks().panel<editor::IssuesPanel>().isVisible());
  }

  /// A screen of 1920 x 1080 at 200 % has 960 x 540, of which the frame takes some.
  void smallScreen_timelineAndPanels_areAllInTheWindow() {
    QVERIFY(window_->open(quiet::demoPath()));
    const QSize small(960, 500);
    window_->resize(small);
    document().setSelection({document().entities(base::EntityKind::Human).front()});
    window_->workspace().runner().stepOnce();
    QTRY_VERIFY(window_->workspace().scene().isRunMode());
    QCoreApplication::processEvents();
    QCOMPARE(window_->size(), small);
    const auto* timeline = window_->findChild<editor::TimelineBar*>();
    const QRect bar(timeline->mapTo(window_.get(), QPoint()), timeline->size());
    QVERIFY(window_->rect().contains(bar));
    QVERIFY(bar.width() > 900);
    for (const QDockWidget* dock : window_->docks().all()) {
      QVERIFY2(dock->visibleRegion().isEmpty() || dock->geometry().bottom() < bar.top(),
               qPrintable(dock->windowTitle()));
    }
    const editor::MapView& view = window_->workspace().view();
    const QWidget& canvas = *view.viewport();
    QCOMPARE(canvas.visibleRegion().boundingRect(),
             canvas.rect());  // it does not go on below a panel
    const QDockWidget& below = *window_->docks().dock(QStringLiteral("metrics"));
    window_->docks().toggleOf(below)->trigger();
    QCoreApplication::processEvents();
    QVERIFY(below.geometry().bottom() < bar.top());
    QCOMPARE(window_->size(), small);
    const auto& metrics = window_->docks().panel<editor::MetricsDock>();
    QVERIFY(metrics.isVisible());
    QVERIFY2(metrics.table().tree().columnWidth(0) >= 100,
             qPrintable(QString::number(metrics.table().tree().columnWidth(0))));
    quiet::shoot(*window_, "small-screen");
  }

  void closeAndOpen_again_panelsKeepTheirSizes() {
    QVERIFY(window_->open(quiet::demoPath()));
    QCoreApplication::processEvents();
    const std::vector<QSize> before = dockSizes();
    for (int i = 0; i < 3; ++i) {
      window_->actions().close->trigger();
      QCoreApplication::processEvents();
      QVERIFY(window_->isOnStartPage());
      QVERIFY(!window_->docks().panel<editor::ScenarioPanel>().isVisible());
      QVERIFY(window_->open(quiet::demoPath()));
      QCoreApplication::processEvents();
      QVERIFY(dockSizes() == before);
    }
    window_->actions().fullScreen->trigger();
    QVERIFY(!window_->docks().panel<editor::ScenarioPanel>().isVisible());
    window_->actions().fullScreen->trigger();
    for (const char* name : {"tools", "timeline"}) {
      const auto* bar = window_->findChild<QToolBar*>(utf8(name));
      QVERIFY2(bar != nullptr && bar->isVisible(), name);
    }
    QVERIFY(window_->docks().panel<editor::ScenarioPanel>().isVisible());
  }

  void openMap_cannotBeRead_runGoesOnAndTheWordsEndWithTheNextMap() {
    QVERIFY(base::writeFileAtomically(at("notes.yaml").toStdString(), "milk: 2\n").empty());
    const QString cafe = QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe.yaml");
    editor::IssuesPanel& issues = window_->docks().panel<editor::IssuesPanel>();
    QVERIFY(window_->open(quiet::copyOfDemo(at("demo.yaml"))));
    editor::SimulationRunner& runner = window_->workspace().runner();
    runner.stepOnce();
    QTRY_VERIFY(runner.shownFrame() != nullptr);
    QVERIFY(!window_->files().replaceMap(at("notes.yaml")));
    QVERIFY(runner.state() != editor::SimulationRunner::State::Editing);
    QVERIFY(issues.hasErrors());
    QVERIFY(window_->files().replaceMap(cafe));
    QVERIFY(runner.state() == editor::SimulationRunner::State::Editing);
    QVERIFY(!issues.hasErrors());
    document().undoStack().setClean();
    QVERIFY(window_->open(demoOnMap("nowhere")));
    QVERIFY(!window_->files().replaceMap(at("notes.yaml")));
    QVERIFY(base::hasErrors(window_->files().problems()));
    window_->notices().choose(utf8("map"), 1);
    QVERIFY(!issues.hasErrors());
  }

  /// A scenario that was never saved is not "Saved".
  void newScenario_isNewUntilItIsEdited() {
    window_->files().newOpenPlane();
    QVERIFY(isSaid(utf8("New")) && !isSaid(utf8("Saved")));
    editor::pushAdd(document(), sim2d::GlobalGoal{});
    QVERIFY(isSaid(utf8("Not saved")));
    document().undoStack().undo();
    QVERIFY(isSaid(utf8("New")));
  }

  void anotherProgramRemovesTheFile_isNotSavedAndAskedBeforeItIsLeft() {
    const QString file = demoOnMap("nowhere");
    QVERIFY(window_->open(file));
    QVERIFY(isSaid(utf8("Saved")));
    QVERIFY(QFile::remove(file));
    window_->guard().checkFiles();
    QVERIFY(isSaid(utf8("Not saved")));
    QVERIFY(window_->isWindowModified());
    answerBox(QMessageBox::Cancel);
    window_->actions().close->trigger();
    QVERIFY2(boxText_.startsWith(utf8("demo.yaml was moved or deleted")), qPrintable(boxText_));
    QVERIFY(!window_->isOnStartPage());
    answerBox(QMessageBox::Cancel);
    QVERIFY(!window_->close());
    QVERIFY(window_->isVisible());
    answerBox(QMessageBox::Save);
    window_->actions().close->trigger();
    QVERIFY(window_->isOnStartPage());
    QVERIFY(QFile::exists(file));
    QVERIFY(window_->open(file));
    QVERIFY(QFile::remove(file));
    answerBox(QMessageBox::Discard);
    window_->actions().close->trigger();
    QVERIFY(!boxText_.isEmpty());
    QVERIFY(window_->isOnStartPage());
    QVERIFY(!QFile::exists(file));
  }

 private:
  /// Of those in front: the ones behind them lie outside the window.
  std::vector<QSize> dockSizes() const {
    std::vector<QSize> sizes;
    for (const QDockWidget* dock : window_->docks().all()) {
      if (dock->isVisible() && window_->rect().contains(dock->geometry().center())) {
        sizes.push_back(dock->size());
      }
    }
    return sizes;
  }
};

QTEST_MAIN(WindowStaysTest)
#include "tst_WindowStays.moc"
