#include <limits>

#include <QSignalSpy>
#include <QtTest>

#include "Hands.h"
#include "RunFiles.h"
#include "editor/canvas/FrameLayer.h"
#include "editor/canvas/RunOverlays.h"
#include "editor/document/EditCommands.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/runs/BranchDialog.h"
#include "editor/panels/runs/FuturesPanel.h"
#include "editor/panels/runs/RunsPanel.h"

using editor::FuturesPanel;
using editor::RunsPanel;
using editor::SimulationRunner;
using namespace outside;

/// Branches, comparisons and futures in the window, by mouse.
class RunsAndFuturesTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<app::MainWindow> window_;
  std::unique_ptr<Hands> hands_;

  SimulationRunner& runner() { return window_->workspace().runner(); }
  RunsPanel& runs() { return window_->docks().panel<RunsPanel>(); }
  FuturesPanel& futures() { return window_->docks().panel<FuturesPanel>(); }
  editor::TimelineBar& timeline() { return *window_->findChild<editor::TimelineBar*>(); }

  void runDemo(double seconds = 8.0) {
    QVERIFY(window_->open(quiet::demoPath()));
    auto settings =
        static_cast<const sim2d::ScenarioSettings&>(window_->workspace().document().scenario());
    settings.desktop.duration = seconds;
    editor::pushEdit(window_->workspace().document(), {settings}, text("Duration"));
    runner().setSpeed(std::numeric_limits<double>::infinity());
    runToTheEnd();
  }
  void runToTheEnd() {
    QSignalSpy finished(&runner(), &SimulationRunner::finished);
    window_->workspace().playback().playPause->trigger();  // Space belongs to what has the keys
    QVERIFY(finished.wait(60000));
  }
  void clickTimeline(double time) {
    QTest::mouseClick(&timeline(), Qt::LeftButton, {}, QPoint(qRound(timeline().xOf(time)), 17));
  }
  void forkAt(double time, const char* planner) {
    clickTimeline(time);
    quiet::answerDialog<editor::BranchDialog>([planner](editor::BranchDialog& dialog) {
      if (planner != nullptr) {
        dialog.findChildren<QComboBox*>().front()->setCurrentText(text(planner));
      }
      dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
    });
    QTest::mouseClick(&runs().branchButton(), Qt::LeftButton);
    const double there = time - 0.05;
    QTRY_VERIFY_WITH_TIMEOUT(runner().newestFrame() && runner().newestFrame()->time >= there,
                             30000);
  }
  QTreeWidgetItem& row(int index) { return *runs().list().topLevelItem(index); }
  void tick(int index) {
    QTreeWidget& list = runs().list();
    const QRect place = list.visualItemRect(&row(index));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, {}, QPoint(12, place.center().y()));
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    window_ = quiet::shownWindow();
    hands_ = std::make_unique<Hands>(*window_);
    futures().process().setProgram(text(HUNAVSIM_PROGRAM));
  }
  void cleanup() {
    hands_.reset();
    quiet::leave(window_);
  }

  void branch_byMouse_isComparedWithTheRunItLeft() {
    runDemo();
    window_->docks().show({text("scenario"), text("properties"), text("runs")});
    QVERIFY(!runs().branchButton().isEnabled());  // the end is no past
    forkAt(3.0, "dwa");
    QCOMPARE(runs().list().topLevelItemCount(), 2);
    QCOMPARE(row(1).text(2), text("robot1.planner = dwa"));
    runToTheEnd();
    QCOMPARE(runner().branch(), 1);
    clickTimeline(6.0);
    QCOMPARE(runs().ghosts().ghosts().size(), std::size_t{1});  // the run that it left
    QVERIFY(runs().ghosts().isDisplaced(runs().ghosts().ghosts().front(), -1));
    QTRY_VERIFY_WITH_TIMEOUT(runs().comparison().table().rowCount() > 10, 30000);
    QCOMPARE(runs().comparison().plot().lines(), std::size_t{2});
    QVERIFY(runs().comparison().divergences().startsWith(text("B diverges at 0:03.")));
    quiet::shoot(*window_, "runs_light");
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(runs().sideBySide() != nullptr && runs().sideBySide()->isVisible());
    QVERIFY(runs().ghosts().ghosts().empty());
    QTest::qWait(300);
    quiet::shoot(*window_, "runs_beside");
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(runs().sideBySide() == nullptr);
    tick(0);
    QTRY_VERIFY(runs().ghosts().ghosts().empty());
    QTRY_VERIFY(runs().comparison().divergences().isEmpty());
    window_->setTheme(editor::Theme::dark());
    tick(0);
    QTRY_COMPARE(runs().ghosts().ghosts().size(), std::size_t{1});
    QTRY_VERIFY_WITH_TIMEOUT(!runs().comparison().isBusy(), 30000);
    QTest::qWait(300);
    quiet::shoot(*window_, "runs_dark");
    window_->setTheme(editor::Theme::light());
  }

  void twoRuns_standBesideTheMap() {
    runDemo(4.0);
    window_->docks().show({text("runs")});
    forkAt(2.0, "dwa");
    runToTheEnd();
    forkAt(3.0, nullptr);
    runToTheEnd();
    QCOMPARE(runs().list().topLevelItemCount(), 3);
    clickTimeline(2.5);
    for (const int index : {0, 1}) {
      if (row(index).checkState(0) != Qt::Checked) {
        tick(index);
      }
    }
    QTRY_COMPARE(runs().ghosts().ghosts().size(), std::size_t{2});
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(runs().sideBySide() != nullptr);
    const auto& views = runs().sideBySide()->views();
    QCOMPARE(views.size(), std::size_t{2});
    for (const auto& view : views) {
      QTRY_VERIFY(view->isVisible() && view->height() > 60 && view->width() >= 240);
      QVERIFY(view->scene().isRunMode());
      QVERIFY(std::abs(view->scene().frameLayer().frame()->time - 2.5) < 0.11);
    }
    QVERIFY(views[0]->geometry().bottom() <= views[1]->geometry().top());
    QVERIFY(!views[0]->geometry().intersects(views[1]->geometry()));
    const editor::MapView& canvas = window_->workspace().view();
    for (const auto& view : views) {  // half as high, and yet nothing of the map is cut off
      const auto showsAll = [&canvas, &view = view->view()] {
        const auto seen = [](const editor::MapView& on) {
          return on.mapToScene(on.viewport()->rect()).boundingRect();
        };
        const double pixel = 2.0 / view.pixelsPerMetre();  // places are whole pixels
        return seen(view).adjusted(-pixel, -pixel, pixel, pixel).contains(seen(canvas));
      };
      QTRY_VERIFY(showsAll());
    }
    QTest::qWait(200);
    quiet::shoot(*window_, "runs_beside_two");
    tick(0);  // one of them is not wanted any more
    QTRY_COMPARE(runs().sideBySide()->views().size(), std::size_t{1});
  }

  /// What is missing for a comparison is said in its place; headings are not cut.
  void comparison_duringARun_saysToPause() {
    runDemo(4.0);
    window_->docks().show({text("runs")});
    forkAt(1.0, "dwa");
    const QHeaderView& head = *runs().list().header();
    QVERIFY(head.sectionSize(1) >= head.sectionSizeHint(1));
    QTRY_VERIFY_WITH_TIMEOUT(!runs().comparison().isBusy(), 30000);
    if (row(0).checkState(0) == Qt::Checked) {
      tick(0);
    }
    const auto isSaid = [this](const char* words) {
      for (const QLabel* label : runs().comparison().findChildren<QLabel*>()) {
        if (label->isVisible() && label->text().startsWith(text(words))) {
          return true;
        }
      }
      return false;
    };
    QTRY_VERIFY(isSaid("Branch from an earlier moment"));
    runner().setSpeed(0.1);
    window_->workspace().playback().playPause->trigger();
    QTRY_COMPARE(runner().state(), SimulationRunner::State::Running);
    tick(0);
    QTRY_VERIFY(isSaid("Pause the run to compare it."));
    window_->workspace().playback().playPause->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(runs().comparison().table().rowCount() > 10, 30000);
  }

  /// Branches cannot be started again, a run without branches can.
  void reset_withBranches_asksFirst() {
    runDemo(4.0);
    window_->docks().show({text("runs")});
    QAction& reset = *window_->workspace().playback().reset;
    forkAt(2.0, nullptr);
    QString asked;
    quiet::answerBox(QMessageBox::Cancel, asked);
    reset.trigger();
    QVERIFY2(asked.contains(text("2 runs")), qPrintable(asked));
    QCOMPARE(runner().branches().size(), std::size_t{2});
    quiet::answerBox(QMessageBox::Discard, asked);
    reset.trigger();
    QCOMPARE(runner().state(), SimulationRunner::State::Editing);
    QVERIFY(runner().branches().empty());
    const auto* hint = widgets::findIf<QLabel>(runs().comparison(), [](const QLabel* label) {
      return label->isVisible() && label->text().startsWith(text("Start a run"));
    });
    QVERIFY(hint != nullptr);
    runToTheEnd();
    reset.trigger();
    QCOMPARE(runner().state(), SimulationRunner::State::Editing);
  }

  /// A branch that is paused at its start is compared, also with several runs; a branch of a branch
  /// keeps the changes of that.
  void branchOfABranch_pausedAtItsStart_isCompared() {
    runDemo(4.0);
    window_->docks().show({text("runs")});
    forkAt(2.0, "dwa");
    QTRY_VERIFY_WITH_TIMEOUT(runs().comparison().table().rowCount() > 10, 30000);
    runToTheEnd();
    forkAt(3.0, nullptr);
    QCOMPARE(row(2).text(2), text("nothing, from ") + row(1).text(0));
    QVERIFY(row(0).checkState(0) == Qt::Checked && row(1).checkState(0) == Qt::Checked);
    const QTreeWidget& list = runs().list();
    QTRY_COMPARE(list.header()->length(), list.viewport()->width());  // no text is cut off
    QCOMPARE(runner().state(), SimulationRunner::State::Paused);
    const QTableWidget& table = runs().comparison().table();
    QTRY_VERIFY_WITH_TIMEOUT(table.rowCount() > 10 && table.columnCount() > 5, 30000);
  }

  /// Only the newest state of a run has what robots perceive: no view has it beside others.
  void runs_sideBySide_showTheSameOverlays() {
    runDemo(3.0);
    window_->docks().show({text("runs")});
    forkAt(1.0, "dwa");
    runToTheEnd();
    const auto canvasFrame = [this] { return window_->workspace().scene().frameLayer().frame(); };
    QTRY_VERIFY(canvasFrame() != nullptr && canvasFrame()->senses != nullptr);
    for (int index = 0; index < runs().list().topLevelItemCount(); ++index) {
      if (row(index).checkState(0) != Qt::Checked) {
        tick(index);
      }
    }
    QTRY_COMPARE(runs().ghosts().ghosts().size(), std::size_t{1});
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(runs().sideBySide() != nullptr);
    QVERIFY(canvasFrame()->senses == nullptr);
    for (const auto& view : runs().sideBySide()->views()) {
      QTRY_VERIFY(view->scene().frameLayer().frame() != nullptr);
      QVERIFY(view->scene().frameLayer().frame()->senses == nullptr);
    }
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(canvasFrame()->senses != nullptr);
  }

  /// Six seconds here, three recorded: distances up to the third second are compared, and what a
  /// run came to as a whole.
  void runs_ofDifferentLength_areComparedUpToTheCommonEnd() {
    const QTemporaryDir folder;
    const QString other = folder.filePath(text("short"));
    QCOMPARE(
        runProgram("run % -q -o % --duration 3 --planner dwa", {quiet::demoPath(), other}).exitCode,
        0);
    runDemo(6.0);
    window_->docks().show({text("scenario"), text("properties"), text("runs")});
    runs().addRecorded(other);
    QTRY_COMPARE(runs().list().topLevelItemCount(), 2);
    editor::CompareTable& compared = runs().comparison();
    QTRY_VERIFY_WITH_TIMEOUT(compared.table().rowCount() > 10, 30000);
    const QTableWidget& table = compared.table();
    const auto rowOf = [&table](const char* name) {
      for (int k = 0; k < table.rowCount(); ++k) {
        if (table.item(k, 0)->text() == text(name)) {
          return k;
        }
      }
      return -1;
    };
    QVERIFY2(compared.lengths().contains(text("Compared up to 3.0 s · A 6.0 s, B 3.0 s")),
             qPrintable(compared.lengths()));
    const int last = table.columnCount() - 1;
    const int length = rowOf("Path length [m]");
    const int duration = rowOf("Duration of the record [s]");
    QVERIFY(length >= 0 && duration >= 0);
    QCOMPARE(table.item(length, last)->text(), text("to 3.0 s"));
    QCOMPARE(table.item(duration, last)->text(), text("whole run"));
    QCOMPARE(table.item(duration, 1)->text().toDouble(), 6.0);
    // The way of A up to the third second, from its states.
    double way = 0.0;
    const auto recording = runner().recording();
    for (std::size_t k = 1; k < recording->size() && recording->timeOf(k) < 3.0 + 1e-6; ++k) {
      const auto& before = recording->frame(k - 1)->robots;
      const auto& now = recording->frame(k)->robots;
      way += std::hypot(now.x[0] - before.x[0], now.y[0] - before.y[0]);
    }
    QVERIFY2(std::fabs(table.item(length, 1)->text().toDouble() - way) < 0.006,
             qPrintable(table.item(length, 1)->text()));
    quiet::shoot(*window_, "runs_lengths");
    int width = 0;  // the names take all that the other columns leave
    for (int column = 0; column < table.columnCount(); ++column) {
      width += table.columnWidth(column);
    }
    QCOMPARE(width, table.viewport()->width());
    QVERIFY(compared.plot().unitText().startsWith(text("Curve: ")));
    const QRect before = compared.table().geometry();
    QTest::mouseClick(&compared.wholeRunsButton(), Qt::LeftButton);
    QCOMPARE(compared.table().geometry(), before);
    QCOMPARE(table.item(rowOf("Path length [m]"), last)->text(), text("whole run"));
    QVERIFY(table.item(rowOf("Path length [m]"), 1)->text().toDouble() > way + 0.1);
    QVERIFY(compared.lengths().contains(text("Different lengths")));
  }

  /// The longest displayed run is reached on the timeline; shorter ones are marked and faded.
  void runs_ofDifferentLength_areMarkedAfterTheirEnd_data() {
    QTest::addColumn<double>("here");
    QTest::newRow("this run is shorter") << 2.0;
    QTest::newRow("the other run is shorter") << 4.0;
  }
  void runs_ofDifferentLength_areMarkedAfterTheirEnd() {
    QFETCH(double, here);
    const bool isShorter = here < 3.0;
    const double late = isShorter ? 2.6 : 3.6;
    const QTemporaryDir folder;
    const QString other = folder.filePath(text("other"));
    QCOMPARE(
        runProgram("run % -q -o % --duration 3 --planner dwa", {quiet::demoPath(), other}).exitCode,
        0);
    runDemo(here);
    window_->docks().show({text("runs")});
    runs().addRecorded(other);
    QTRY_COMPARE(runs().list().topLevelItemCount(), 2);
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    const editor::SideView& view = *runs().sideBySide()->views().front();
    const auto titleOfCanvas = [this] {
      return widgets::findIf<QLabel>(*window_,
                                     [](const QLabel* each) {
                                       return each->isVisible() &&
                                              each->text().startsWith(text("A  "));
                                     })
          ->text();
    };
    clickTimeline(1.0);
    QVERIFY(!view.hasEnded());
    QVERIFY(!view.title().contains(text("ended")) && !titleOfCanvas().contains(text("ended")));
    clickTimeline(late);
    QVERIFY(std::abs(timeline().pointedTime() - late) < 0.11);
    QVERIFY(std::abs(view.scene().frameLayer().frame()->time - std::min(late, 3.0)) < 0.11);
    QCOMPARE(view.hasEnded(), !isShorter);
    const QString marked = isShorter ? titleOfCanvas() : view.title();
    const QString unmarked = isShorter ? view.title() : titleOfCanvas();
    QVERIFY2(marked.endsWith(isShorter ? text("ended at 2.0 s") : text("ended at 3.0 s")),
             qPrintable(marked));
    QVERIFY2(!unmarked.contains(text("ended")), qPrintable(unmarked));
    const double before = timeline().pointedTime();
    timeline().setFocus();
    QTest::keyClick(&timeline(), Qt::Key_Left);
    QVERIFY(timeline().pointedTime() < before && timeline().pointedTime() > before - 0.11);
    QTest::keyClick(&timeline(), Qt::Key_Home);
    QVERIFY(timeline().pointedTime() < 0.11);
    QVERIFY(!view.hasEnded() && !titleOfCanvas().contains(text("ended")));
  }

  /// Each view has a title and the overlays of the canvas, also those that read the run.
  void views_haveTitlesAndTheSameOverlays() {
    runDemo(6.0);
    window_->docks().show({text("runs")});
    forkAt(2.0, "dwa");
    runToTheEnd();
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(runs().sideBySide() != nullptr);
    const editor::SideView& view = *runs().sideBySide()->views().front();
    const auto titleOfCanvas = [this] {
      return widgets::findIf<QLabel>(*window_, [](const QLabel* each) {
        return each->isVisible() && each->text().startsWith(text("A  "));
      });
    };
    QVERIFY(titleOfCanvas() != nullptr);
    QVERIFY2(view.title().startsWith(text("B  ")), qPrintable(view.title()));
    QTRY_COMPARE(titleOfCanvas()->mapTo(window_.get(), QPoint()).y(),
                 view.mapTo(window_.get(), QPoint()).y());
    editor::MapScene& canvas = window_->workspace().view().mapScene();
    // The line above a view has the colour of its run, not that of the state.
    const auto lineOf = [](const editor::MapView& of) {
      return of.viewport()->grab().toImage().pixelColor(of.viewport()->width() / 2, 1);
    };
    const editor::Theme light = editor::Theme::light();
    QCOMPARE(lineOf(window_->workspace().view()), light.color(editor::Role::Accent));
    QCOMPARE(lineOf(view.view()), editor::ghostStyle(0, light).color);
    // Both show the same place, to the pixel.
    const auto shift = [this, &view] {
      const editor::MapView& left = window_->workspace().view();
      const QPointF by = view.view().sceneCentre() - left.sceneCentre();
      return std::max(std::abs(by.x()), std::abs(by.y())) * left.pixelsPerMetre();
    };
    QTRY_VERIFY2(shift() < 0.55, qPrintable(QString::number(shift())));
    editor::CanvasOptions options = canvas.options();
    options.contacts = options.thoughts = options.proxemics = true;
    canvas.setOptions(options);
    QVERIFY(view.scene().options().contacts && view.scene().options().proxemics);
    for (const int id : {1, 2, 3}) {
      QTRY_COMPARE(view.scene().overlays().thoughtOf(id).isEmpty(),
                   canvas.overlays().thoughtOf(id).isEmpty());
    }
    QVERIFY(!canvas.overlays().thoughtOf(1).isEmpty());
    const auto person = window_->workspace().document().entities(base::EntityKind::Human).front();
    window_->workspace().document().setSelection({person});
    QCOMPARE(view.scene().document().selection(), std::vector<editor::EntityId>{person});
    quiet::shoot(*window_, "runs_titles");
    QTest::mouseClick(&runs().sideBySideButton(), Qt::LeftButton);
    QVERIFY(titleOfCanvas() == nullptr);
  }

  void branches_switchedByDoubleClick_areBothThere() {
    runDemo(4.0);
    window_->docks().show({text("runs")});
    const editor::RecordingPtr first = runner().recording();
    forkAt(2.0, nullptr);
    QCOMPARE(row(1).text(2), text("nothing"));
    runToTheEnd();
    const QRect place = runs().list().visualItemRect(&row(0));
    const QPoint name(120, place.center().y());
    QTest::mouseClick(runs().list().viewport(), Qt::LeftButton, {}, name);
    QTest::mouseDClick(runs().list().viewport(), Qt::LeftButton, {}, name);
    QTRY_COMPARE(runner().branch(), 0);
    QCOMPARE(runner().recording(), first);
    QTRY_COMPARE_WITH_TIMEOUT(runs().comparison().divergences(), text("B is identical"), 30000);
  }

  void futures_fromTheMoment_areDrawnAndCounted() {
    runDemo();
    clickTimeline(3.0);
    app::RunSpec changes;
    changes.set = {"robot1.planner=dwa"};  // of a branch: what was changed counts
    QVERIFY(runner().branchFromShown(changes));
    QTRY_VERIFY(runner().newestFrame() && runner().newestFrame()->time > 2.99);
    runToTheEnd();
    window_->docks().show({text("scenario"), text("properties"), text("futures")});
    clickTimeline(4.0);
    const std::int64_t at = runner().shownFrame()->step;
    futures().count().setValue(20);
    QTest::mouseClick(&futures().button(), Qt::LeftButton);
    QVERIFY(futures().isRunning());
    QCOMPARE(futures().button().text(), text("Cancel"));
    QTRY_VERIFY_WITH_TIMEOUT(!futures().isRunning(), 60000);
    QCOMPARE(futures().futures().size(), std::size_t{20});
    QVERIFY2(futures().summary().contains(text("20 futures")), qPrintable(futures().summary()));
    const editor::FramePtr shown = runner().shownFrame();
    QCOMPARE(shown->step, at);
    for (const app::Future& future : futures().futures()) {
      QVERIFY(future.failure.empty());
      QVERIFY(future.ways.at(-1).front() == base::Vec2(shown->robots.x[0], shown->robots.y[0]));
      QVERIFY(std::fabs(future.times.back() - shown->time - 10.0) < 1e-6);
    }
    quiet::shoot(*window_, "futures_light");
    window_->setTheme(editor::Theme::dark());
    QTest::qWait(200);
    quiet::shoot(*window_, "futures_dark");
    window_->setTheme(editor::Theme::light());
    runner().reset();
    QVERIFY(futures().futures().empty());
  }

  void futures_cancelled_keepWhatCame() {
    runDemo(3.0);
    window_->docks().show({text("futures")});
    clickTimeline(1.0);
    futures().count().setValue(1000);
    QTest::mouseClick(&futures().button(), Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(!futures().futures().empty() || !futures().isRunning(), 60000);
    QVERIFY2(futures().isRunning(), qPrintable(futures().summary()));
    QTest::mouseClick(&futures().button(), Qt::LeftButton);
    QVERIFY(!futures().isRunning());
    QVERIFY(futures().summary().contains(text("of 1000 futures, cancelled")));
    QVERIFY(futures().futures().size() < 1000);
  }

  void futures_programThatIsNotThere_isTold() {
    runDemo(2.0);
    window_->docks().show({text("futures")});
    clickTimeline(1.0);
    futures().process().setProgram(text("/nowhere/hunavsim"));
    QTest::mouseClick(&futures().button(), Qt::LeftButton);
    QTRY_VERIFY(!futures().isRunning());
    QVERIFY(!futures().summary().isEmpty() && futures().futures().empty());
  }

  /// A recorded run goes on as one made here, and the document is not lost nor written over.
  void recordedRun_ofAnotherProgram_isToldForkedAndCompared() {
    const QTemporaryDir folder;
    const QString one = folder.filePath(text("one")), two = folder.filePath(text("two"));
    for (const QString& path : {one, two}) {
      const QString seed = path == one ? text("1") : text("7");
      QCOMPARE(runProgram("run % -q -o % --duration 5 --seed % --planner %",
                          {quiet::demoPath(), path, seed, path == one ? text("dwa") : text("orca")})
                   .exitCode,
               0);
    }
    QByteArray manifest = bytesOf(one + text("/manifest.json"));
    const int at = manifest.indexOf("\"version\": \"") + 12;
    manifest.replace(at, manifest.indexOf('"', at) - at, "0.0.1");
    writeText(one + text("/manifest.json"), manifest);
    QVERIFY(window_->open(one));
    const base::Diagnostics& said = window_->files().problems();
    QVERIFY(std::any_of(said.begin(), said.end(),
                        [](const auto& each) { return each.code == "trace.other-program"; }));
    window_->docks().show({text("runs")});
    runs().addRecorded(two);
    QTRY_COMPARE(runs().list().topLevelItemCount(), 2);
    clickTimeline(4.0);
    QTRY_COMPARE(runs().ghosts().ghosts().size(), std::size_t{1});
    QTRY_VERIFY_WITH_TIMEOUT(runs().comparison().table().rowCount() > 10, 30000);
    forkAt(2.0, nullptr);
    QVERIFY(!runner().isRecorded());
    QVERIFY(window_->windowTitle().contains(text("recorded run")));
    QVERIFY(!window_->actions().save->isEnabled());
    runner().reset();
    QVERIFY(!window_->workspace().isRecordedRun());
  }

  void run_ofAnotherScenario_isToldApart() {
    runDemo(1.0);
    window_->docks().show({text("runs")});
    const QTemporaryDir folder;
    const QString other = folder.filePath(text("other"));
    QCOMPARE(runProgram("run crossing_agents -q -o % --duration 1", {other}).exitCode, 0);
    runs().addRecorded(other);
    QTRY_COMPARE_WITH_TIMEOUT(runs().comparison().divergences(), text("B has another scenario"),
                              30000);
  }

  void run_ofAFolderThatIsNone_isTold() {
    runDemo(1.0);
    window_->docks().show({text("runs")});
    const QTemporaryDir folder;
    QSignalSpy found(&window_->docks().context(), &editor::PanelContext::problemsFound);
    runs().addRecorded(folder.path());
    QTRY_COMPARE(found.count(), 1);
    QCOMPARE(runs().list().topLevelItemCount(), 1);
  }

  void program_futures_tellsChances() {
    const QTemporaryDir folder;
    const QString run = folder.filePath(text("run"));
    QCOMPARE(runProgram("run % -q -o % --duration 4", {quiet::demoPath(), run}).exitCode, 0);
    const Finished told = runProgram("futures % --seeds 4 --horizon 3", {run + text("@2")});
    QVERIFY2(told.exitCode == 0, qPrintable(told.err));
    QVERIFY2(told.out.contains(text("95 % CI")), qPrintable(told.out));
    QVERIFY2(told.out.contains(text("/ 4")), qPrintable(told.out));
    const Finished json = runProgram("futures % --seeds 2 --json", {run + text("@2")});
    QCOMPARE(QJsonDocument::fromJson(json.out.toUtf8()).array().size(), 2);
    QCOMPARE(runProgram("futures % --seeds 0", {run + text("@2")}).exitCode, 64);
    QCOMPARE(runProgram("futures nowhere").exitCode, 64);
    QCOMPARE(runProgram("futures %", {run + text("@99")}).exitCode, 2);
  }
};

QTEST_MAIN(RunsAndFuturesTest)
#include "tst_RunsAndFutures.moc"
