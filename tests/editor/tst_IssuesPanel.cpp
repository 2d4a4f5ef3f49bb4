#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/ScenarioPanel.h"
#include "tests/editor/SmallScenario.h"
#include "tests/support/Widgets.h"

using editor::IssuesPanel;
using editor::ScenarioDocument;

namespace {

sim2d::Scenario personWithUnknownGoal() {
  sim2d::Scenario scenario;
  scenario.humans.push_back(
      small::person(1, "Ana", {0.0, 0.0}, 0.0, sim2d::BehaviorType::Regular, {7}));
  return scenario;
}

void clickRow(QTableView& table, int row) {
  const QRect place = table.visualRect(table.model()->index(row, 0));
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place.center());
}

}  // namespace

class IssuesPanelTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<IssuesPanel> panel_;

  /// Shown in this width [px]; 0: not shown.
  void open(int width = 0, const std::optional<sim2d::Scenario>& scenario = {}) {
    if (scenario) {
      document_->load(*scenario);
    }
    panel_ = std::make_unique<IssuesPanel>(*document_, editor::Theme::light());
    if (width > 0) {
      panel_->resize(width, 200);
      panel_->show();
      QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    }
  }
  void openUnknownGoal(int width = 0) {
    open(width, personWithUnknownGoal());
    document_->checkNow();
    QTRY_VERIFY(panel_->hasErrors());
  }
  const sim2d::Human& ana() const { return document_->scenario().humans.front(); }

 private Q_SLOTS:
  void init() { document_ = std::make_unique<ScenarioDocument>(); }
  void cleanup() { panel_.reset(); }

  void sentence_keysAndNames_stayAsWritten_data() {
    QTest::addColumn<QString>("message");
    QTest::addColumn<QString>("shown");
    const char* const kRows[][2] = {
        {"agents: no agents are listed", "agents: no agents are listed"},
        {"yaml_base_name names another file", "yaml_base_name names another file"},
        {"hunavsim_desktop.dt: 2 must be at most 0.1",
         "hunavsim_desktop.dt: 2 must be at most 0.1"},
        {"anna.goals: goal 7 is not defined", "anna.goals: goal 7 is not defined"},
        {"no node hunav_loader", "No node hunav_loader"},
        {"goal 3 is duplicated", "Goal 3 is duplicated"},
        {"", ""}};
    for (const auto& row : kRows) {
      QTest::newRow(row[0]) << QString::fromUtf8(row[0]) << QString::fromUtf8(row[1]);
    }
  }
  void sentence_keysAndNames_stayAsWritten() {
    QFETCH(QString, message);
    QFETCH(QString, shown);
    QCOMPARE(editor::issueSentence(base::error("run.failed", {message.toStdString()})), shown);
  }

  /// The form has labels, the file keys.
  void sentence_ofAKey_hasTheLabelOfTheForm() {
    open(0, personWithUnknownGoal());
    base::Diagnostic found = base::withContext(
        "Ana", base::warning("scenario.implausible", {"max_vel", 99.0, 0.0, 4.0, "m/s"}));
    found.entity = ana().key;
    QCOMPARE(editor::issueSentence(found),
             QStringLiteral("Ana: Top speed (max_vel) 99 is implausible: usual values are 0 to 4 "
                            "m/s"));
    base::Diagnostic named = base::withContext(
        "max_vel ", base::warning("scenario.implausible", {"max_vel", 99.0, 0.0, 4.0, "m/s"}));
    named.entity = ana().key;  // the name of a person is no key
    QVERIFY(editor::issueSentence(named).startsWith(QStringLiteral("max_vel : Top speed")));
    found.entity = {};  // of a kind without a form
    QVERIFY(editor::issueSentence(found).contains(QStringLiteral("Ana: max_vel 99")));
  }

  /// The check and whoever meets the problem next have different words for it.
  void issues_sameProblemInOtherWords_isToldOnce_data() {
    QTest::addColumn<QByteArray>("code");
    QTest::addColumn<QByteArray>("goal");
    QTest::addColumn<bool>("isSame");
    const auto row = [](const char* name, const char* code, const char* goal, bool isSame) {
      QTest::newRow(name) << QByteArray(code) << QByteArray(goal) << isSame;
    };
    row("goal that a tree sets", "tree.no-goal", "7", true);
    row("another goal of a tree", "tree.no-goal", "8", false);
    row("another problem", "world.goal-out-of-reach", "7", false);
  }
  void issues_sameProblemInOtherWords_isToldOnce() {
    QFETCH(QByteArray, code);
    QFETCH(QByteArray, goal);
    QFETCH(bool, isSame);
    openUnknownGoal();
    const int before = panel_->table().model()->rowCount();
    base::Diagnostic again = base::warning(code.constData(), {goal.toStdString()});
    again.entity = ana().key;
    panel_->setActionIssues({again});
    QCOMPARE(panel_->table().model()->rowCount(), before + (isSame ? 0 : 1));
    again.entity = {};  // of nobody that is known
    panel_->setActionIssues({again});
    QCOMPARE(panel_->table().model()->rowCount(), before + (isSame ? 0 : 1));
  }

  void issues_mended_doNotComeBackInOtherWords() {
    openUnknownGoal();
    const base::EntityId person = ana().key;
    base::Diagnostic echo = base::warning("tree.no-goal", {"7"});
    echo.entity = person;
    panel_->setActionIssues({echo});
    editor::pushChange<sim2d::Human>(*document_, person, QString(),
                                     [](sim2d::Human& human) { human.goals.clear(); });
    document_->checkNow();
    QTRY_VERIFY(!panel_->hasErrors());
    const IssuesPanel fresh(*document_, editor::Theme::light());
    QCOMPARE(panel_->table().model()->rowCount(), fresh.table().model()->rowCount());
  }

  /// Why a run was refused may be fixed by any edit, also by undoing the one that caused it.
  void issues_ofAnAction_endWithTheNextEdit() {
    open();
    const base::EntityId person = editor::pushAdd(*document_, sim2d::Human());
    const auto isShown = [this] {
      const QAbstractItemModel& rows = *panel_->table().model();
      bool found = false;
      for (int row = 0; row < rows.rowCount(); ++row) {
        found = found || rows.index(row, 0).data().toString() == QStringLiteral("Odd");
      }
      return found;
    };
    const base::Diagnostics refused{base::error("run.failed", {"odd"})};
    panel_->setActionIssues(refused);
    QVERIFY(isShown());
    editor::pushChange<sim2d::Human>(*document_, person, QString(),
                                     [](sim2d::Human& human) { human.radius = 0.4; });
    QVERIFY(!isShown());
    panel_->setActionIssues(refused);
    document_->undoStack().undo();
    QVERIFY(!isShown());
    panel_->setRecorded(true);  // its edits are reverted
    panel_->setActionIssues(refused);
    document_->undoStack().redo();
    QVERIFY(isShown());
  }

  /// Asked for, its map is an error; found missing, a warning: one problem all the same.
  void issues_sameWordsWithAnotherSeverity_areToldOnce() {
    open();
    panel_->setActionIssues({base::error("map.not-found", {"m", ""}, "a.yaml", 3),
                             base::warning("map.not-found", {"m", ""}, "a.yaml", 3),
                             base::warning("map.not-found", {"m", ""}, "b.yaml", 3)});
    QCOMPARE(panel_->table().model()->rowCount(), 2 + static_cast<int>(document_->issues().size()));
  }

  void hints_areFoldedToTheirNumber() {
    open(600);
    const auto hint = [](const char* says) {
      return base::problem(base::Severity::Info, "run.failed", {says});
    };
    panel_->setActionIssues({hint("one"), base::warning("run.failed", {"odd"}), hint("two")});
    const QAbstractItemModel& rows = *panel_->table().model();
    QCOMPARE(panel_->count(), 1);
    QCOMPARE(rows.rowCount(), 2);
    QCOMPARE(rows.index(0, 0).data().toString(), QStringLiteral("Odd"));
    QCOMPARE(rows.index(1, 0).data().toString(), QStringLiteral("2 hints"));
    clickRow(panel_->table(), 1);
    QCOMPARE(rows.rowCount(), 4);
    QCOMPARE(rows.index(2, 0).data().toString(), QStringLiteral("One"));
    QCOMPARE(rows.index(3, 0).data().toString(), QStringLiteral("Two"));
    QSignalSpy wanted(panel_.get(), &IssuesPanel::fileRequested);
    panel_->setActionIssues(
        {base::problem(base::Severity::Info, "run.failed", {"here"}, "a.yaml", 4)});
    QCOMPARE(rows.rowCount(), 2);  // it stays open
    clickRow(panel_->table(), 1);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().at(1).toInt(), 4);
    clickRow(panel_->table(), 0);
    QCOMPARE(rows.rowCount(), 1);
  }

  /// A new scenario is not greeted with a warning; a file without people has one.
  void newScenario_withoutPeople_isNoProblem() {
    open(600);
    document_->checkNow();
    QTest::qWait(50);
    QCOMPARE(panel_->count(), 0);
    const auto isShown = [this](const QString& words) {
      const QList<QLabel*> labels = panel_->findChildren<QLabel*>();
      return std::any_of(labels.begin(), labels.end(), [&words](const QLabel* label) {
        return label->isVisible() && label->text().startsWith(words);
      });
    };
    QTRY_VERIFY(isShown(QStringLiteral("No issues. Press P")));
    const QTemporaryDir folder;
    QVERIFY(!base::hasErrors(document_->save(folder.filePath(QStringLiteral("empty.yaml")))));
    document_->checkNow();
    QTRY_COMPARE(panel_->count(), 1);
  }

  void live_unknownGoal_isToldAndSelectsThePerson() {
    openUnknownGoal(600);
    QSignalSpy wanted(panel_.get(), &IssuesPanel::entityRequested);
    clickRow(panel_->table(), 0);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(document_->selection().size(), std::size_t(1));
    QCOMPARE(document_->selection().front(), ana().key);
  }

  void live_mended_becomesCalm() {
    openUnknownGoal();
    sim2d::GlobalGoal goal;
    goal.id = 7;
    goal.position = base::Vec2(4.0, 0.0);
    editor::pushAdd(*document_, goal);
    document_->checkNow();
    QTRY_VERIFY(!panel_->hasErrors());
  }

  void fixLink_clicked_mendsAndIsUndone() {
    openUnknownGoal(700);
    const QModelIndex link = panel_->table().model()->index(0, 2);
    QCOMPARE(link.data().toString(), QStringLiteral("Remove goal 7 from the route"));
    QTest::mouseClick(panel_->table().viewport(), Qt::LeftButton, {},
                      panel_->table().visualRect(link).center());
    QVERIFY(ana().goals.empty());
    QTRY_VERIFY(!panel_->hasErrors());  // the check goes on beside
    document_->undoStack().undo();
    QCOMPARE(ana().goals, std::vector<int>{7});
  }

  void sentence_longerThanItsRow_goesOnInAnotherLine() {
    open(420);
    const QString words = QStringLiteral(
        "The map has more pixels than can be shown at once, so that its finest "
        "walls are only seen from near");
    panel_->setActionIssues({base::warning("run.failed", {"short"}),
                             base::warning("run.failed", {words.toStdString()})});
    QTRY_VERIFY(panel_->table().rowHeight(1) >= 40);
    QVERIFY(panel_->table().rowHeight(0) < 30);
    const QModelIndex cell = panel_->table().model()->index(1, 0);
    QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(words));
    QVERIFY(panel_->table().visualRect(cell).width() > 380);  // nothing else is in the row
    panel_->resize(1600, 200);
    QTRY_VERIFY(panel_->table().rowHeight(1) < 30);
  }

  void missingGoals_linkAsksForTheDialog() {
    sim2d::Scenario scenario = personWithUnknownGoal();
    scenario.humans.front().goals.clear();
    open(700, scenario);
    document_->checkNow();
    QTRY_VERIFY(panel_->count() > 0);
    QSignalSpy wanted(panel_.get(), &IssuesPanel::goalsRequested);
    const QRect place = panel_->table().visualRect(panel_->table().model()->index(0, 2));
    QTest::mouseClick(panel_->table().viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(document_->selection(), std::vector<editor::EntityId>{ana().key});
  }

  void file_shownAtTheLine() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("a.yaml"));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("one\ntwo\nthree\n");
    file.close();
    editor::TextViewer viewer(editor::Theme::light());
    QCOMPARE(viewer.showFile(path, 2), QString());
    QVERIFY(viewer.isVisible());
    QCOMPARE(viewer.text().textCursor().block().text(), QStringLiteral("two"));
    QVERIFY(viewer.text().isReadOnly());
    auto* outside = widgets::findIf<QPushButton>(viewer, [](const QPushButton* button) {
      return button->text().startsWith(QStringLiteral("Open with"));
    });
    QTest::mouseClick(outside, Qt::LeftButton);  // there is no desktop here
    const QString words = QStringLiteral("No application is available to open %1").arg(path);
    QVERIFY(widgets::withText<QLabel>(viewer, words) != nullptr);
    QVERIFY(viewer.showFile(folder.filePath(QStringLiteral("no.yaml")), 1)
                .contains(QStringLiteral("no.yaml")));
  }

  void action_withoutEntity_pointsToTheFile() {
    open(600);
    panel_->setActionIssues({base::warning("run.failed", {"odd"}, "a.yaml", 3, 1),
                             base::error("run.failed", {"bad key"}, "/tmp/a.yaml", 12, 7)});
    QCOMPARE(panel_->count(), 2);
    const QAbstractItemModel* model = panel_->table().model();
    QCOMPARE(model->index(0, 0).data().toString(), QStringLiteral("Bad key"));    // errors first
    QCOMPARE(model->index(0, 2).data().toString(), QStringLiteral("a.yaml:12"));  // at the end
    QSignalSpy wanted(panel_.get(), &IssuesPanel::fileRequested);
    clickRow(panel_->table(), 0);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().at(1).toInt(), 12);
    panel_->setActionIssues({});
    QCOMPARE(panel_->count(), 0);
  }

  void scenarioTree_selection_goesBothWays() {
    ScenarioDocument document;
    document.load(personWithUnknownGoal());
    editor::ScenarioPanel panel(document, editor::Theme::light());
    panel.resize(260, 400);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const editor::EntityId ana = document.scenario().humans.front().key;
    document.setSelection({ana});
    const QModelIndexList rows = panel.tree().selectionModel()->selectedRows();
    QCOMPARE(rows.size(), 1);
    QCOMPARE(rows.front().data().toString(), QStringLiteral("Ana"));
    document.setSelection({});
    QVERIFY(panel.tree().selectionModel()->selectedRows().isEmpty());
    const QRect place = panel.tree().visualRect(rows.front());
    QTest::mouseClick(panel.tree().viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(document.selection(), std::vector<editor::EntityId>{ana});
  }
};

QTEST_MAIN(IssuesPanelTest)
#include "tst_IssuesPanel.moc"
