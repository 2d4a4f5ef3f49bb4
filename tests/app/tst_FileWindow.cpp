#include <QMessageBox>
#include <QMimeData>
#include <QTemporaryDir>
#include <QTimer>
#include <QtTest>

#include "app/window/DocumentGuard.h"
#include "app/window/ExportDialog.h"
#include "app/window/MainWindow.h"
#include "app/window/MapDialogs.h"
#include "app/window/TreeChoiceDialog.h"
#include "editor/document/EditCommands.h"
#include "editor/document/MapEdit.h"
#include "editor/document/TreeFiles.h"
#include "editor/panels/IssuesPanel.h"
#include "sim2d/base/Text.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;

/// Files and the window: what is asked, told and refused.
class FileWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { app::dressApplication(editor::Theme::light()); }
  void init() {
    folder_ = std::make_unique<QTemporaryDir>();
    window_ = std::make_unique<MainWindow>(quiet::setup());
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
  }
  void cleanup() {
    document().undoStack().setClean();
    window_.reset();
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
    QVERIFY(window_->notices().isTold(QStringLiteral("read-only")));
    QVERIFY(window_->docks().issues().hasErrors());
    QVERIFY(!window_->files().saveTo(file));
    QVERIFY(*base::readTextFile(file.toStdString()) == text);
    QVERIFY(window_->files().saveTo(at("whole.yaml")));
    QVERIFY(!window_->docks().issues().hasErrors());
    QVERIFY(!window_->notices().isTold(QStringLiteral("read-only")));
    shoot("damaged");
  }

  void leave_withUnsavedChanges_asksAndObeys() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    const std::string before = *base::readTextFile(file.toStdString());
    editor::pushRemove(document(), {document().entities(base::EntityKind::Human).front()});
    const sim2d::Scenario edited = document().scenario();
    answerBox(QMessageBox::Cancel);
    window_->actions().close->trigger();
    QVERIFY(boxText_.contains(QStringLiteral("demo.yaml")));
    QVERIFY(!window_->isOnStartPage());
    QVERIFY(document().scenario() == edited);
    answerBox(QMessageBox::Discard);
    window_->actions().close->trigger();
    QVERIFY(window_->isOnStartPage());
    QVERIFY(*base::readTextFile(file.toStdString()) == before);
  }

  void save_overComments_asksAndObeys() {
    const QString file = copyOfDemo();
    const std::string text = "# by hand\n" + *base::readTextFile(file.toStdString());
    QVERIFY(base::writeFileAtomically(file.toStdString(), text).empty());
    QVERIFY(window_->open(file));
    editor::pushRemove(document(), {document().entities(base::EntityKind::Human).front()});
    answerBox(QMessageBox::Cancel);
    window_->actions().save->trigger();
    QVERIFY(boxText_.contains(QStringLiteral("comment")));
    QVERIFY(boxText_.endsWith(QStringLiteral("Save anyway?")));
    QVERIFY(*base::readTextFile(file.toStdString()) == text);
    answerBox(QMessageBox::Save);
    window_->actions().save->trigger();
    QVERIFY(*base::readTextFile(file.toStdString()) != text);
    QVERIFY(!document().isDirty());
  }

  void saveAs_ontoAMap_isRefused_data() {
    QTest::addColumn<QString>("name");
    QTest::newRow("map in use") << QStringLiteral("cafe.yaml");
    QTest::newRow("its image") << QStringLiteral("cafe.image");
    QTest::newRow("a link to it") << QStringLiteral("link.yaml");
    QTest::newRow("another map") << QStringLiteral("other.yaml");
    QTest::newRow("a damaged map") << QStringLiteral("damaged.yaml");
    QTest::newRow("an image") << QStringLiteral("other.pgm");
  }
  void saveAs_ontoAMap_isRefused() {
    QFETCH(QString, name);
    const QString map = mapWithNeighbours();
    QVERIFY(window_->files().openNewFromMap(map));
    QVERIFY(window_->files().nameForSaving().endsWith(QStringLiteral("/cafe_agents.yaml")));
    const QString target = folder_->filePath(name);
    const std::string before = *base::readTextFile(target.toStdString());
    answerBox(QMessageBox::Ok);
    QVERIFY(!window_->files().saveUnder(target));
    QVERIFY2(boxText_.contains(name) && boxText_.contains(QStringLiteral("map")),
             qPrintable(boxText_));
    QVERIFY(*base::readTextFile(target.toStdString()) == before);
    QVERIFY(window_->files().saveUnder(at("cafe_agents.yaml")));
    QVERIFY(window_->files().saveUnder(at("cafe_agents.yaml")));  // over a scenario it may be
    editor::ScenarioDocument again;
    QVERIFY(!base::hasErrors(again.open(at("cafe_agents.yaml"))));
    QVERIFY(!again.map()->isEmpty());
  }

  void anotherProgramWrites_noticeOffersToReload() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    const std::size_t people = document().scenario().humans.size();
    sim2d::Scenario changed = document().scenario();
    changed.humans.pop_back();
    QVERIFY(base::writeFileAtomically(file.toStdString(), sim2d::writeScenario(changed)).empty());
    QTRY_VERIFY(window_->notices().isTold(QStringLiteral("changed")));
    shoot("changed");
    window_->notices().choose(QStringLiteral("changed"), 0);
    QCOMPARE(document().scenario().humans.size(), people - 1);
    QVERIFY(window_->notices().notices().empty());
  }

  void anotherProgramWrites_keepMine_isNotToldAgain() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    QVERIFY(base::writeFileAtomically(file.toStdString(), "something else").empty());
    window_->guard().watch().lookNow();
    QVERIFY(window_->notices().isTold(QStringLiteral("changed")));
    window_->notices().choose(QStringLiteral("changed"), 1);
    window_->guard().watch().lookNow();
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
    QTimer::singleShot(300, this, [&asked] {
      if (auto* dialog = qobject_cast<app::ImageMapDialog*>(QApplication::activeModalWidget())) {
        ++asked;
        dialog->setResolution(0.02);
        dialog->accept();
      }
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
    QVERIFY(window_->docks().issues().hasErrors());
    const QString broken = at("x__agent_1_bt.xml");
    QVERIFY(base::writeFileAtomically(broken.toStdString(), "<root><").empty());
    QVERIFY(!window_->files().dropFile(broken, {}));
  }

  void save_treeOfAChangedPerson_asksAndSavesWhatIsChosen() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    const editor::EntityId person = document().scenario().humanById(1)->key;
    document().undoStack().push(
        new editor::EditTree(document(), person, kTree, QStringLiteral("Tree")));
    QVERIFY(window_->files().saveTo(file));
    editor::pushChange<sim2d::Human>(
        document(), person, QStringLiteral("Type"),
        [](sim2d::Human& human) { human.behavior.type = sim2d::BehaviorType::Scared; });
    int asked = 0;
    QTimer::singleShot(0, this, [&asked] {
      auto* dialog = qobject_cast<app::TreeChoiceDialog*>(QApplication::activeModalWidget());
      if (dialog != nullptr) {
        ++asked;
        dialog->choose(0, editor::TreeAnswer::TakeReplacement);
        dialog->accept();
      }
    });
    QVERIFY(window_->files().save());
    QCOMPARE(asked, 1);
    QVERIFY(!document().tree(person));
    QVERIFY(!document().isDirty());
  }

  void options_mapAndTrees_countForTheFileBesideThem() {
    const QString file = copyOfDemo();
    QVERIFY(
        base::writeFileAtomically(at("trees/demo__agent_1_bt.xml").toStdString(), kTree).empty());
    app::RunOptions options;
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
    QVERIFY(window_->docks().issues().hasErrors());
  }

  void options_compat_isThatOfTheRuns() {
    app::RunOptions options;
    const sim2d::Compatibility hunav2 = *sim2d::Compatibility::parse("hunav2");
    window_->files().setOptions(options, hunav2);
    window_->workspace().setRunSettings({hunav2, 2, true});
    QVERIFY(window_->open(copyOfDemo()));
    QVERIFY(document().scenario().desktop.model == std::string("sfm-hunav2"));
    QVERIFY(document().scenario().desktop.route == sim2d::Route::Direct);
    const editor::RunRequest request = editor::runRequestOf(document(), {hunav2, 2, true});
    QVERIFY(bool(request.makeWorld()));
  }

  void treeDialog_differences_areShown() {
    const std::vector<editor::TreeQuestion> questions = questionsOfDemo();
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      app::dressApplication(theme);
      app::TreeChoiceDialog dialog(questions, theme);
      dialog.show();
      shootWidget(dialog, isDark ? "trees-short-dark" : "trees-short-light");
      dialog.showDifferences(true);
      dialog.choose(1, editor::TreeAnswer::TakeReplacement);
      shootWidget(dialog, isDark ? "trees-dark" : "trees-light");
      const editor::TreeAnswers answers = dialog.answers();
      QCOMPARE(answers.size(), questions.size());
      QVERIFY(answers.at(questions[0].human) == editor::TreeAnswer::KeepMine);
      QVERIFY(answers.at(questions[1].human) == editor::TreeAnswer::TakeReplacement);
    }
    app::dressApplication(editor::Theme::light());
  }

  void exportDialog_target_listsTheFilesAndWritesThem() {
    QVERIFY(window_->open(copyOfDemo()));
    const QString out = at("out");
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      app::dressApplication(theme);
      app::ExportDialog dialog(window_->files().exportSource(), out, theme);
      dialog.setTarget(QStringLiteral("webots"));
      dialog.show();
      shootWidget(dialog, isDark ? "export-dark" : "export-light");
      QCOMPARE(dialog.files().topLevelItemCount(), static_cast<int>(dialog.plan().files.size()));
      QVERIFY(dialog.plan().files.size() > 4);
      const std::string first = dialog.files().topLevelItem(0)->text(1).toStdString();
      QCOMPARE(first.c_str(), isDark ? "stays as it is" : "new");
      QVERIFY(window_->files().exportPlan(dialog.plan()));
    }
    app::dressApplication(editor::Theme::light());
    QVERIFY(QFile::exists(out + QStringLiteral("/scenarios/demo.yaml")));
    app::ExportDialog other(window_->files().exportSource(), out, editor::Theme::light());
    other.setTarget(QStringLiteral("isaac"));
    QVERIFY(other.files().topLevelItem(0)->text(1) == QStringLiteral("is replaced"));
  }

  void export_folder_isThatOfTheScenarioUnlessItWasExported() {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, at("settings"));
    app::WindowSetup setup = quiet::setup();
    setup.remembers = true;
    window_ = std::make_unique<MainWindow>(setup);
    window_->show();
    app::FileCommands& files = window_->files();
    const QString first = copyOfDemo();
    QVERIFY(window_->open(first));
    QCOMPARE(files.exportFolder(), at("export"));
    exportTo(first + QStringLiteral("/no"));  // a file is no folder
    QVERIFY(base::hasErrors(files.problems()));
    QCOMPARE(files.exportFolder(), at("export"));
    exportTo(at("elsewhere"));
    QVERIFY(!base::hasErrors(files.problems()));
    QCOMPARE(files.exportFolder(), at("elsewhere"));
    QVERIFY(QDir().mkpath(at("other")));
    QVERIFY(files.saveTo(at("other/other.yaml")));
    QCOMPARE(files.exportFolder(), at("other/export"));
    QVERIFY(window_->open(first));
    QCOMPARE(files.exportFolder(), at("elsewhere"));
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
      app::dressApplication(theme);
      app::ImageMapDialog dialog(*grid, image, theme);
      dialog.show();
      dialog.view().setPoints({{40.0, 20.0}, {360.0, 20.0}});
      dialog.setDistance(16.0);
      dialog.setFirstPoint(1.0, 2.0);
      shootWidget(dialog, isDark ? "image-dark" : "image-light");
      QVERIFY(std::abs(dialog.resolution() - 0.05) < 1e-9);
      const auto map = dialog.map();
      QVERIFY((map->origin().position - base::Vec2(1.0 - 2.0, 2.0 - 1.0)).norm() < 1e-9);
      QVERIFY(map->isWall(map->worldToCell({5.0, 2.0 - 0.05 * 0.5})) ||
              map->isWall(map->worldToCell({5.0, 1.9})));
    }
    app::dressApplication(editor::Theme::light());
  }

  void roomDialog_looks() {
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      app::dressApplication(theme);
      app::RoomDialog dialog(theme);
      dialog.show();
      shootWidget(dialog, isDark ? "room-dark" : "room-light");
      QVERIFY(dialog.hasWalls());
      QCOMPARE(dialog.size(), QSizeF(12.0, 9.0));
    }
    app::dressApplication(editor::Theme::light());
  }

  void notices_dark_looks() {
    window_->setTheme(editor::Theme::dark());
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    QVERIFY(base::writeFileAtomically(file.toStdString(), "something else").empty());
    window_->guard().watch().lookNow();
    window_->notices().tell({QStringLiteral("x"),
                             false,
                             QStringLiteral("The program ended unexpectedly. Unsaved changes to "
                                            "cafe.yaml were kept (2 min ago)."),
                             {{QStringLiteral("Restore"), {}}, {QStringLiteral("Discard"), {}}}});
    shoot("notices-dark");
    window_->setTheme(editor::Theme::light());
    shoot("notices-light");
  }

 private:
  static constexpr const char* kTree =
      "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mine\">\n  <BehaviorTree ID=\"Mine\">\n"
      "    <Sequence>\n      <GoTo agent_id=\"{id}\" goal_id=\"1\" time_step=\"{dt}\"/>\n"
      "      <RegularNav agent_id=\"{id}\" time_step=\"{dt}\"/>\n    </Sequence>\n"
      "  </BehaviorTree>\n</root>\n";

  editor::ScenarioDocument& document() { return window_->workspace().document(); }
  QString at(const char* name) const { return folder_->filePath(QString::fromUtf8(name)); }

  /// What the next message box is told; its text is kept.
  void answerBox(QMessageBox::StandardButton button) {
    boxText_.clear();
    QTimer::singleShot(100, this, [this, button] {
      if (auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget())) {
        boxText_ = box->text();
        box->button(button)->click();
      }
    });
  }

  void dropOnWindow(const QString& file) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file)});
    QDragEnterEvent enter(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &enter);
    QDropEvent drop(QPoint(600, 400), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(window_.get(), &drop);
  }

  void exportTo(const QString& target) {
    QTimer::singleShot(100, this, [&target] {
      if (auto* dialog = qobject_cast<app::ExportDialog*>(QApplication::activeModalWidget())) {
        dialog->setFolder(target);
        dialog->accept();
      }
    });
    window_->files().askExport();
  }

  /// The café as cafe.yaml with an image of an uncommon name, and other maps beside it.
  QString mapWithNeighbours() const {
    const QString source = QStringLiteral(SOURCE_DIR "/maps/corner_cafe/corner_cafe");
    QFile::copy(source + QStringLiteral(".pgm"), at("cafe.image"));
    QFile::copy(source + QStringLiteral(".pgm"), at("other.pgm"));
    const std::string yaml = *base::readTextFile((source + QStringLiteral(".yaml")).toStdString());
    std::string own = yaml;
    const std::string image = "corner_cafe.pgm";
    own.replace(own.find(image), image.size(), "cafe.image");
    const bool isWritten =
        base::writeFileAtomically(at("cafe.yaml").toStdString(), own).empty() &&
        base::writeFileAtomically(at("other.yaml").toStdString(), yaml).empty() &&
        base::writeFileAtomically(at("damaged.yaml").toStdString(), yaml + "x: [\n").empty();
    QFile::link(at("cafe.yaml"), at("link.yaml"));
    return isWritten ? at("cafe.yaml") : QString();
  }

  QString copyOfDemo() const {
    sim2d::ScenarioReading demo =
        sim2d::readScenario(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    demo.scenario.yamlBaseName = "demo";
    const base::Diagnostics problems = base::writeFileAtomically(
        at("demo.yaml").toStdString(), sim2d::writeScenario(demo.scenario));
    return problems.empty() ? at("demo.yaml") : QString();
  }

  static std::vector<editor::TreeQuestion> questionsOfDemo() {
    const sim2d::ScenarioReading demo =
        sim2d::readScenario(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    std::vector<editor::TreeQuestion> questions;
    for (const sim2d::Human& human : demo.scenario.humans) {
      editor::TreeQuestion question;
      question.human = human.key;
      question.name = human.name;
      question.path = "scenarios/demo__agent_" + std::to_string(human.id) + "_bt.xml";
      question.replacement = editor::generatedTree(demo.scenario, human);
      question.mine = question.replacement;
      const std::size_t at = question.mine.find("<SetGoal");
      if (at != std::string::npos) {
        question.mine.insert(at, "<SaySomething agent_id=\"{id}\" message=\"Good morning\"/>\n");
      }
      question.why = questions.empty() ? editor::TreeQuestion::Why::BehaviourChanged
                                       : editor::TreeQuestion::Why::ChangedOnDisk;
      questions.push_back(question);
    }
    return questions;
  }

  /// Pictures for people to look at, when a folder for them is named.
  void shoot(const char* name) { shootWidget(*window_, name); }
  static void shootWidget(QWidget& widget, const char* name) {
    const QByteArray folder = qgetenv("HUNAV_PICTURES");
    QCoreApplication::processEvents();
    if (!folder.isEmpty()) {
      QVERIFY(widget.grab().save(QString::fromLocal8Bit(folder) + QLatin1Char('/') +
                                 QString::fromUtf8(name) + QStringLiteral(".png")));
    }
  }

  QString boxText_;
  std::unique_ptr<QTemporaryDir> folder_;
  std::unique_ptr<MainWindow> window_;
};

QTEST_MAIN(FileWindowTest)
#include "tst_FileWindow.moc"
