#include "app/window/MainWindow.h"
#include "app/window/NoticeBar.h"
#include "app/window/StartPage.h"
#include "app/window/files/FileCommands.h"
#include "app/window/files/FileDialogs.h"
#include "app/window/study/StudyPanel.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/ScenarioPanel.h"
#include "sim2d/base/Text.h"
#include "tests/app/QuietWindow.h"
#include "tests/app/RunFiles.h"

using app::MainWindow;

/// Files that the window opens, gets and watches.
class FileWindowTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() {
    end();
    editor::applyTheme(editor::Theme::light());
  }

  void open_damagedFile_isShownWithANoticeAndRefusesToBeSaved() {
    const QString file = copyOfDemo();
    std::string text = *base::readTextFile(file.toStdString());
    text += "\n  broken: [1, 2\n";
    QVERIFY(base::writeFileAtomically(file.toStdString(), text).empty());
    QVERIFY(!window_->open(file));
    QVERIFY(!window_->isOnStartPage());
    QVERIFY(!document().scenario().humans.empty());
    QVERIFY(document().isReadOnly());
    QVERIFY(window_->notices().has(QStringLiteral("read-only")));
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
    QVERIFY(!window_->files().saveTo(file));
    QVERIFY(*base::readTextFile(file.toStdString()) == text);
    QVERIFY(window_->files().saveTo(at("whole.yaml")));
    QVERIFY(!window_->docks().panel<editor::IssuesPanel>().hasErrors());
    QVERIFY(!window_->notices().has(QStringLiteral("read-only")));
    quiet::shoot(*window_, "damaged");
  }

  void experiment_withoutADocument_opensItsFirstScenario() {
    const QString scenario = copyOfDemo();
    const QString file = at("two_planners.yaml");
    const std::string text = "hunavsim_experiment: 1\nscenarios: [" +
                             QFileInfo(scenario).fileName().toStdString() +
                             "]\nseeds: 2\nvalues:\n  robot1.planner: [pursuit, dwa]\n";
    QVERIFY(base::writeFileAtomically(file.toStdString(), text).empty());
    QVERIFY(window_->open(file));
    QVERIFY(!window_->isOnStartPage());
    QCOMPARE(document().path(), QFileInfo(scenario).absoluteFilePath());
    QVERIFY(!document().isReadOnly());
    const app::StudyPanel& panel = window_->docks().panel<app::StudyPanel>();
    QCOMPARE(panel.file(), file);
    QVERIFY(panel.isVisibleTo(window_.get()));
  }

  void experiment_besideADocument_leavesItOpen() {
    QVERIFY(window_->open(copyOfDemo()));
    const QString before = document().path();
    const QString file = at("one_seed.yaml");
    const std::string text = "hunavsim_experiment: 1\nscenarios: [crossing_agents]\nseeds: 1\n";
    QVERIFY(base::writeFileAtomically(file.toStdString(), text).empty());
    QVERIFY(window_->files().openFile(file));
    QCOMPARE(document().path(), before);
    QCOMPARE(window_->docks().panel<app::StudyPanel>().file(), file);
    QVERIFY(base::writeFileAtomically(file.toStdString(), text + "colour: red\n").empty());
    QVERIFY(!window_->files().openFile(file));
    QVERIFY(window_->files().problems().front().code == "experiment.unknown-key");
    QCOMPARE(document().path(), before);
  }

  void nav2File_isExplainedAndLeavesTheDocument() {
    QVERIFY(window_->open(copyOfDemo()));
    const QString before = document().path();
    const QString file = at("nav2_params.yaml");
    for (const char* text :
         {"controller_server:\n  ros__parameters:\n    controller_frequency: 20.0\n",
          "<root BTCPP_format=\"4\"><BehaviorTree ID=\"Main\"><ComputePathToPose goal=\"{goal}\" "
          "path=\"{path}\"/></BehaviorTree></root>"}) {
      QVERIFY(base::writeFileAtomically(file.toStdString(), text).empty());
      QVERIFY(!window_->files().openFile(file));
      QVERIFY(window_->files().problems().front().code == "document.nav2-file");
    }
    QCOMPARE(document().path(), before);
    QVERIFY(!document().isReadOnly());
  }

  void anotherProgramWrites_noticeOffersToReload() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    const std::size_t people = document().scenario().humans.size();
    sim2d::Scenario changed = document().scenario();
    changed.humans.pop_back();
    QVERIFY(base::writeFileAtomically(file.toStdString(), sim2d::writeScenario(changed)).empty());
    QTRY_VERIFY(window_->notices().has(QStringLiteral("changed")));
    quiet::shoot(*window_, "changed");
    window_->notices().choose(QStringLiteral("changed"), 0);
    QCOMPARE(document().scenario().humans.size(), people - 1);
    QVERIFY(window_->notices().notices().empty());
  }

  void anotherProgramWrites_keepMine_isNotToldAgain() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    QVERIFY(base::writeFileAtomically(file.toStdString(), "something else").empty());
    window_->guard().checkFiles();
    QVERIFY(window_->notices().has(QStringLiteral("changed")));
    window_->notices().choose(QStringLiteral("changed"), 1);
    window_->guard().checkFiles();
    QVERIFY(window_->notices().notices().empty());
  }

  void ownSaving_isNoChangeByAnother() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    editor::pushMove(document(), {document().scenario().humans.front().key}, {0.1, 0.0});
    QVERIFY(window_->files().saveTo(file));
    QTest::qWait(700);
    QVERIFY(window_->notices().notices().empty());
  }

  void drop_treeOnAPerson_isTheirTree() {
    QVERIFY(window_->open(copyOfDemo()));
    const sim2d::Human& human = document().scenario().humans.front();
    const QString tree = at("mine.xml");
    QVERIFY(base::writeFileAtomically(tree.toStdString(), kTree).empty());
    editor::MapView& view = window_->workspace().view();
    const QPoint place =
        view.viewport()->mapTo(window_.get(), view.viewportFrom(human.initPose.position));
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(tree)});
    QWidget* under = window_->childAt(place);  // as the system finds it
    QDragEnterEvent enter(under->mapFrom(window_.get(), place), Qt::CopyAction, &data,
                          Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(under, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
    QTRY_VERIFY(document().tree(human.key) == kTree);
    document().undoStack().undo();
    QVERIFY(!document().tree(human.key));
  }

  void drop_mapOrImage_isANewScenarioOnIt() {
    const QString map = mapWithNeighbours();
    dropOnWindow(map);
    QTRY_VERIFY(!window_->isOnStartPage());
    QCOMPARE(document().mapPath(), map);
    document().undoStack().setClean();
    int asked = 0;
    quiet::answerDialog<app::ImageMapDialog>([&asked](app::ImageMapDialog& dialog) {
      ++asked;
      quiet::setResolution(dialog, 0.02);
      dialog.accept();
    });
    dropOnWindow(at("other.pgm"));
    QTRY_COMPARE(asked, 1);
    QTRY_VERIFY(document().mapPath().isEmpty());
    QCOMPARE(document().map()->resolution(), 0.02);
  }

  void drop_treeBesideEverybody_goesByItsName() {
    QVERIFY(window_->open(copyOfDemo()));
    const QString tree = at("other__agent_1_bt.xml");
    QVERIFY(base::writeFileAtomically(tree.toStdString(), kTree).empty());
    QVERIFY(window_->files().dropFile(tree, {}));
    QVERIFY(document().tree(document().scenario().humanById(1)->key) == kTree);
    const QString nobody = at("nobody.xml");
    QVERIFY(base::writeFileAtomically(nobody.toStdString(), kTree).empty());
    QVERIFY(!window_->files().dropFile(nobody, {}));
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
    const QString broken = at("x__agent_1_bt.xml");
    QVERIFY(base::writeFileAtomically(broken.toStdString(), "<root><").empty());
    QVERIFY(!window_->files().dropFile(broken, {}));
  }

  void options_mapAndTrees_countForTheFileBesideThem() {
    const QString file = copyOfDemo();
    QVERIFY(
        base::writeFileAtomically(at("trees/demo__agent_1_bt.xml").toStdString(), kTree).empty());
    app::RunSpec options;
    options.scenario = file.toStdString();
    options.map = SOURCE_DIR "/maps/reactions/reactions.yaml";
    options.trees = at("trees").toStdString();
    window_->files().setOptions(options, {});
    QVERIFY(window_->open(file));
    QVERIFY(document().mapPath().endsWith(QStringLiteral("reactions.yaml")));
    QVERIFY(document().tree(document().scenario().humanById(1)->key) == kTree);
    options.map = "none";
    window_->files().setOptions(options, {});
    QVERIFY(window_->open(file));
    QVERIFY(document().map()->isEmpty());
    options.map = "/not/there.yaml";
    window_->files().setOptions(options, {});
    QVERIFY(!window_->open(file));
    QVERIFY(window_->docks().panel<editor::IssuesPanel>().hasErrors());
  }

  /// They are no change of the user, can be undone, and do not ask when the window is left.
  void options_ofTheCommandLine_doNotMarkTheScenarioAsChanged() {
    app::RunSpec options;
    const QString file = copyOfDemo();
    options.scenario = file.toStdString();
    options.planner = "dwa";
    window_->files().setOptions(options, {});
    QSignalSpy applied(&window_->files(), &app::FileCommands::optionsApplied);
    QVERIFY(window_->open(file));
    QCOMPARE(applied.count(), 1);
    QCOMPARE(document().scenario().robots.front().planner, std::optional<std::string>("dwa"));
    QVERIFY(!document().isDirty());
    QVERIFY(!window_->isWindowModified());
    QVERIFY(document().undoStack().canUndo());
    document().undoStack().undo();
    QVERIFY(document().scenario().robots.front().planner != std::optional<std::string>("dwa"));
    document().undoStack().redo();
    QVERIFY(!document().isDirty());
    editor::pushChange<editor::ScenarioSettings>(
        document(), editor::kSettingsId, QString(),
        [](editor::ScenarioSettings& settings) { settings.desktop.seed = 77; });
    QVERIFY(document().isDirty());
    document().undoStack().setClean();
  }

  void options_compat_isThatOfTheRuns() {
    app::RunSpec options;
    const sim2d::Compatibility hunav2 = *sim2d::Compatibility::parse("hunav2");
    window_->files().setOptions(options, hunav2);
    window_->workspace().setRunSettings({hunav2, 2, true});
    QVERIFY(window_->open(copyOfDemo()));
    QVERIFY(document().scenario().desktop.model == std::string("sfm-hunav2"));
    QVERIFY(document().scenario().desktop.route == sim2d::Route::Direct);
    const editor::RunRequest request = editor::runRequestOf(document(), {hunav2, 2, true});
    QVERIFY(bool(request.makeWorld()));
  }

  void newRoom_size_isAMapWithWallsThatIsSaved() {
    window_->files().newOnMap(editor::emptyRoom(6.0, 4.0));
    QVERIFY(!window_->isOnStartPage());
    QVERIFY(document().isDirty());
    const sim2d::OccupancyGrid& map = *document().map();
    QVERIFY(!map.isWall(map.worldToCell({0.02, 0.02})));
    QVERIFY(!map.isWall(map.worldToCell({5.98, 3.98})));
    QVERIFY(map.isWall(map.worldToCell({-0.02, 2.0})));
    QVERIFY(map.isWall(map.worldToCell({6.02, 2.0})));
    QVERIFY(window_->files().saveTo(at("room.yaml")));
    QVERIFY(QFile::exists(at("room_map.pgm")));
    editor::ScenarioDocument again;
    QVERIFY(!base::hasErrors(again.open(at("room.yaml"))));
    QVERIFY(*again.map() == map);
  }

  void imageMap_twoPoints_giveResolutionAndPlace() {
    QImage image(400, 200, QImage::Format_RGB32);
    image.fill(Qt::white);
    for (int x = 40; x < 360; ++x) {
      image.setPixel(x, 20, qRgb(0, 0, 0));
      image.setPixel(x, 180, qRgb(0, 0, 0));
    }
    const QString file = at("plan.png");
    QVERIFY(image.save(file));
    const auto grid = editor::gridOfImage(file, 0.05);
    QVERIFY(bool(grid));
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      editor::applyTheme(theme);
      app::ImageMapDialog dialog(*grid, image, theme);
      dialog.show();
      dialog.view().setPoints({{40.0, 20.0}, {360.0, 20.0}});
      quiet::part<QDoubleSpinBox>(dialog, "Distance 1 – 2").setValue(16.0);
      quiet::part<QDoubleSpinBox>(dialog, "X").setValue(1.0);
      quiet::part<QDoubleSpinBox>(dialog, "Y").setValue(2.0);
      quiet::shoot(dialog, isDark ? "image-dark" : "image-light");
      QVERIFY(std::abs(dialog.resolution() - 0.05) < 1e-9);
      const auto map = dialog.map();
      QVERIFY((map->origin().position - base::Vec2(1.0 - 2.0, 2.0 - 1.0)).norm() < 1e-9);
      QVERIFY(map->isWall(map->worldToCell({5.0, 2.0 - 0.05 * 0.5})) ||
              map->isWall(map->worldToCell({5.0, 1.9})));
    }
    editor::applyTheme(editor::Theme::light());
  }

  void recent_fileGoesAndComesBack_rowSaysSo() {
    restartRemembering();
    const QString file = copyOfDemo();
    QFile handle(file);
    QVERIFY(handle.open(QIODevice::ReadWrite));
    const QDateTime old = QDateTime::currentDateTime().addDays(-40);
    QVERIFY(handle.setFileTime(old, QFileDevice::FileModificationTime));
    handle.close();
    QVERIFY(window_->open(file));
    window_->actions().close->trigger();
    QCOMPARE(recentRow()->accessibleDescription(), QStringLiteral("just now"));  // it was opened
    QVERIFY(window_->open(file));
    QVERIFY(QFile::rename(file, at("moved.yaml")));
    document().clear();
    window_->actions().close->trigger();
    QVERIFY(!recentRow()->isEnabled());
    QCOMPARE(recentRow()->accessibleDescription(), QStringLiteral("File not found"));
    QVERIFY(QFile::rename(at("moved.yaml"), file));
    window_->actions().newOpenPlane->trigger();
    window_->actions().close->trigger();
    QVERIFY(recentRow()->isEnabled());
    QVERIFY(QFile::remove(file));
    recentRow()->click();  // gone since the page was shown
    QVERIFY(window_->notices().has(QStringLiteral("unread")));
    QVERIFY(!recentRow()->isEnabled());
  }

  void layout_ofTheLastSession_isBack() {
    restartRemembering();
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    QVERIFY(window_->docks().dock(QStringLiteral("events"))->isHidden());
    window_->docks().toggleOf(*window_->docks().dock(QStringLiteral("events")))->trigger();
    window_->docks().toggleOf(*window_->docks().dock(QStringLiteral("scenario")))->trigger();
    QVERIFY(window_->close());
    restartRemembering();
    QVERIFY(window_->open(file));
    QVERIFY(window_->docks().dock(QStringLiteral("scenario"))->isHidden());
    QVERIFY(window_->docks().dock(QStringLiteral("events"))->isVisible());
    QVERIFY(window_->docks().dock(QStringLiteral("properties"))->isVisible());
  }

  void theme_chosen_isBackNextTime() {
    restartRemembering();
    QVERIFY(window_->actions().systemTheme->isChecked());
    const bool wasDark = window_->workspace().theme().isDark();
    window_->actions().switchTheme->trigger();
    QVERIFY(window_->close());
    restartRemembering();
    QVERIFY(window_->workspace().theme().isDark() != wasDark);
    QVERIFY(!window_->actions().systemTheme->isChecked());
  }

  void theme_givenAtTheStart_isForOnce() {
    restartRemembering();
    const bool wasDark = window_->workspace().theme().isDark();
    window_->actions().switchTheme->trigger();
    QVERIFY(window_->close());
    restartRemembering(false);  // whose theme is that of the application
    editor::applyTheme(wasDark ? editor::Theme::dark() : editor::Theme::light());
    window_->setTheme(wasDark ? editor::Theme::dark() : editor::Theme::light());
    QVERIFY(window_->close());
    restartRemembering();
    QVERIFY(window_->workspace().theme().isDark() != wasDark);
    window_->actions().systemTheme->setChecked(true);
    QVERIFY(window_->close());
    restartRemembering();
    QVERIFY(window_->actions().systemTheme->isChecked());
  }

  void open_anotherScenario_listBeginsAtItsTop() {
    const QString folder = QStringLiteral(GENERATED_MAPS "/realism/");
    QVERIFY(window_->open(folder + QStringLiteral("realism_rimea_12_agents.yaml")));
    auto* tree = window_->docks().panel<editor::ScenarioPanel>().findChild<QTreeView*>();
    QVERIFY(tree != nullptr);
    QCoreApplication::processEvents();
    tree->expandAll();
    tree->scrollToBottom();
    QCoreApplication::processEvents();
    QVERIFY(tree->verticalScrollBar()->value() > 0);
    QVERIFY(window_->open(folder + QStringLiteral("realism_lanes_agents.yaml")));
    tree->expandAll();
    QCoreApplication::processEvents();
    QVERIFY(tree->verticalScrollBar()->maximum() > 0);
    QCOMPARE(tree->verticalScrollBar()->value(), 0);
  }

  void roomDialog_looks() {
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      editor::applyTheme(theme);
      app::RoomDialog dialog(theme);
      dialog.show();
      quiet::shoot(dialog, isDark ? "room-dark" : "room-light");
      QVERIFY(dialog.hasWalls());
      QCOMPARE(dialog.size(), QSizeF(12.0, 9.0));
    }
    editor::applyTheme(editor::Theme::light());
  }

  void notices_dark_looks() {
    window_->setTheme(editor::Theme::dark());
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    QVERIFY(base::writeFileAtomically(file.toStdString(), "something else").empty());
    window_->guard().checkFiles();
    window_->notices().post({QStringLiteral("x"),
                             false,
                             QStringLiteral("The program ended unexpectedly. Unsaved changes to "
                                            "cafe.yaml were kept (2 min ago)."),
                             {{QStringLiteral("Restore"), {}}, {QStringLiteral("Discard"), {}}}});
    quiet::shoot(*window_, "notices-dark");
    window_->setTheme(editor::Theme::light());
    quiet::shoot(*window_, "notices-light");
  }

  void layers_switched_areAsTheyWereNextTime() {
    restartRemembering();
    QVERIFY(window_->actions().lidar->isChecked());
    QVERIFY(!window_->actions().candidates->isChecked());
    window_->actions().lidar->trigger();
    window_->actions().candidates->trigger();
    restartRemembering();
    QVERIFY(!window_->actions().lidar->isChecked());
    QVERIFY(window_->actions().candidates->isChecked());
    const editor::CanvasOptions& options = window_->workspace().scene().options();
    QVERIFY(!options.lidar && options.candidates && options.names && !options.detections);
  }

  void trailsAndLoops_areRemembered() {
    restartRemembering();
    for (QAction* action : window_->workspace().scrub().trailLengths()) {
      if (action->text() == QStringLiteral("15 s")) {
        action->trigger();
      }
    }
    const QString folders[] = {at("runA"), at("runB")};
    for (const QString& folder : folders) {
      const outside::Finished run =
          outside::runProgram("run % -o % --duration 3 --quiet", {quiet::demoPath(), folder});
      QCOMPARE(run.exitCode, 0);
    }
    QVERIFY(window_->open(folders[0]));
    window_->workspace().runner().setLoop(editor::SimulationRunner::LoopRange{0.5, 1.25});
    window_->workspace().runner().reset();  // leaving it takes nothing away
    restartRemembering();
    QCOMPARE(window_->workspace().scene().options().trailSeconds, 15.0);
    for (const QAction* action : window_->workspace().scrub().trailLengths()) {
      QCOMPARE(action->isChecked(), action->text() == QStringLiteral("15 s"));
    }
    QVERIFY(window_->open(folders[1]));
    QVERIFY(!window_->workspace().runner().loop());
    QVERIFY(window_->open(folders[0]));
    const auto loop = window_->workspace().runner().loop();
    QVERIFY(loop && loop->from == 0.5 && loop->to == 1.25);
    window_->workspace().runner().setLoop({});
    restartRemembering();
    QVERIFY(window_->open(folders[0]));
    QVERIFY(!window_->workspace().runner().loop());
  }

 private:
  void restartRemembering(bool followsSystem = true) {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, at("settings"));
    app::WindowSetup setup = quiet::setup();
    setup.storesSettings = true;
    setup.followsSystem = followsSystem;
    quiet::leave(window_);
    window_ = quiet::shownWindow(setup);
  }

  /// The row of the only recent file; rows that are about to be deleted precede it.
  app::RecentRow* recentRow() const {
    const QList<app::RecentRow*> rows = window_->findChildren<app::RecentRow*>();
    return rows.isEmpty() ? nullptr : rows.back();
  }

  void dropOnWindow(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QDropEvent drop(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
  }
};

QTEST_MAIN(FileWindowTest)
#include "tst_FileWindow.moc"
