#include "app/window/MainWindow.h"
#include "app/window/files/FileDialogs.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PersonTree.h"
#include "editor/look/AppStyle.h"
#include "sim2d/base/Text.h"
#include "tests/app/QuietWindow.h"

using app::MainWindow;

/// Saving, exporting and leaving: what the window asks, tells and refuses.
class SaveWindowTest : public QObject, protected quiet::InFolder {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() { begin(); }
  void cleanup() { end(); }

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
    QVERIFY(window_->files().suggestedPath().endsWith(QStringLiteral("/cafe_agents.yaml")));
    const QString target = folder_->filePath(name);
    const std::string before = *base::readTextFile(target.toStdString());
    answerBox(QMessageBox::Ok);
    QVERIFY(!window_->files().saveAsPath(target));
    QVERIFY2(boxText_.contains(name) && boxText_.contains(QStringLiteral("map")),
             qPrintable(boxText_));
    QVERIFY(*base::readTextFile(target.toStdString()) == before);
    QVERIFY(window_->files().saveAsPath(at("cafe_agents.yaml")));
    QVERIFY(window_->files().saveAsPath(at("cafe_agents.yaml")));  // over a scenario it may be
    editor::ScenarioDocument again;
    QVERIFY(!base::hasErrors(again.open(at("cafe_agents.yaml"))));
    QVERIFY(!again.map()->isEmpty());
  }

  void save_treeOfAChangedPerson_asksAndSavesWhatIsChosen() {
    const QString file = copyOfDemo();
    QVERIFY(window_->open(file));
    const editor::EntityId person = document().scenario().humanById(1)->key;
    editor::pushTrees(document(), {{person, kTree}}, QStringLiteral("Tree"));
    QVERIFY(window_->files().saveTo(file));
    editor::pushChange<sim2d::Human>(
        document(), person, QStringLiteral("Type"),
        [](sim2d::Human& human) { human.behavior.type = sim2d::BehaviorType::Scared; });
    int asked = 0;
    quiet::answerDialog<app::TreeChoiceDialog>([&asked](app::TreeChoiceDialog& dialog) {
      ++asked;
      dialog.choose(0, true);
      dialog.accept();
    });
    QVERIFY(window_->files().save());
    QCOMPARE(asked, 1);
    QVERIFY(!document().tree(person));
    QVERIFY(!document().isDirty());
    QCOMPARE(window_->statusBar()->currentMessage(),
             QStringLiteral("Saved ") + QFileInfo(file).fileName());
  }

  void treeDialog_differences_areShown() {
    const std::vector<editor::TreeConflict> questions = questionsOfDemo();
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      editor::applyTheme(theme);
      app::TreeChoiceDialog dialog(questions, theme);
      dialog.show();
      quiet::shoot(dialog, isDark ? "trees-short-dark" : "trees-short-light");
      dialog.showDifferences(true);
      dialog.choose(1, true);
      quiet::shoot(dialog, isDark ? "trees-dark" : "trees-light");
      QVERIFY(dialog.replaced() == editor::TreeReplacements{questions[1].human});
    }
    editor::applyTheme(editor::Theme::light());
  }

  void exportDialog_target_listsTheFilesAndWritesThem() {
    QVERIFY(window_->open(copyOfDemo()));
    const QString out = at("out");
    for (const bool isDark : {false, true}) {
      const editor::Theme theme = isDark ? editor::Theme::dark() : editor::Theme::light();
      editor::applyTheme(theme);
      app::ExportDialog dialog(window_->files().exportSource(), out, theme);
      quiet::setTarget(dialog, "webots");
      const auto& list = *dialog.findChild<QTreeWidget*>();
      dialog.show();
      quiet::shoot(dialog, isDark ? "export-dark" : "export-light");
      QCOMPARE(list.topLevelItemCount(), static_cast<int>(dialog.plan().files.size()));
      QVERIFY(dialog.plan().files.size() > 4);
      const std::string first = list.topLevelItem(0)->text(1).toStdString();
      QCOMPARE(first.c_str(), isDark ? "unchanged" : "new");
      QVERIFY(window_->files().exportPlan(dialog.plan()));
    }
    editor::applyTheme(editor::Theme::light());
    QVERIFY(QFile::exists(out + QStringLiteral("/scenarios/demo.yaml")));
    app::ExportDialog other(window_->files().exportSource(), out, editor::Theme::light());
    quiet::setTarget(other, "isaac");
    QVERIFY(other.findChild<QTreeWidget*>()->topLevelItem(0)->text(1) ==
            QStringLiteral("replaced"));
  }

  void export_folder_isThatOfTheScenarioUnlessItWasExported() {
    QSettings::setPath(QSettings::NativeFormat, QSettings::UserScope, at("settings"));
    app::WindowSetup setup = quiet::setup();
    setup.storesSettings = true;
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

 private:
  void exportTo(const QString& target) {
    quiet::answerDialog<app::ExportDialog>([&target](app::ExportDialog& dialog) {
      quiet::part<QLineEdit>(dialog, "Folder").setText(target);
      dialog.accept();
    });
    window_->files().askExport();
  }

  static std::vector<editor::TreeConflict> questionsOfDemo() {
    const sim2d::ScenarioReading demo =
        sim2d::readScenario(SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml");
    std::vector<editor::TreeConflict> questions;
    for (const sim2d::Human& human : demo.scenario.humans) {
      editor::TreeConflict question;
      question.human = human.key;
      question.name = human.name;
      question.path = "scenarios/demo__agent_" + std::to_string(human.id) + "_bt.xml";
      question.replacement = editor::generatedTree(demo.scenario, human);
      question.mine = question.replacement;
      const std::size_t at = question.mine.find("<SetGoal");
      if (at != std::string::npos) {
        question.mine.insert(at, "<SaySomething agent_id=\"{id}\" message=\"Good morning\"/>\n");
      }
      question.why = questions.empty() ? editor::TreeConflict::Why::BehaviourChanged
                                       : editor::TreeConflict::Why::ChangedOnDisk;
      questions.push_back(question);
    }
    return questions;
  }
};

QTEST_MAIN(SaveWindowTest)
#include "tst_SaveWindow.moc"
