#include <algorithm>

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTextBlock>
#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/panels/IssuesPanel.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/panels/TextViewer.h"

using editor::IssuesPanel;
using editor::ScenarioDocument;

namespace {

QPushButton* outsideButton(const editor::TextViewer& viewer) {
  const QList<QPushButton*> buttons = viewer.findChildren<QPushButton*>();
  const auto found = std::find_if(buttons.begin(), buttons.end(), [](const QPushButton* button) {
    return button->text().startsWith(QStringLiteral("Open with"));
  });
  return found == buttons.end() ? nullptr : *found;
}

bool saysThat(const QWidget& widget, const QString& text) {
  const QList<QLabel*> labels = widget.findChildren<QLabel*>();
  return std::any_of(labels.begin(), labels.end(),
                     [&](const QLabel* label) { return label->text() == text; });
}

sim2d::Scenario personWithUnknownGoal() {
  sim2d::Scenario scenario;
  sim2d::Human human;
  human.key = {base::EntityKind::Human, 1};
  human.name = "Ana";
  human.id = 1;
  human.behavior.type = sim2d::BehaviorType::Regular;
  human.goals = {7};
  scenario.humans.push_back(human);
  return scenario;
}

void clickRow(QTableView& table, int row) {
  const QRect place = table.visualRect(table.model()->index(row, 0));
  QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, place.center());
}

}  // namespace

class IssuesPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
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
    ScenarioDocument document;
    document.load(personWithUnknownGoal());
    IssuesPanel panel(document, editor::Theme::light());
    document.checkNow();
    QTRY_VERIFY(panel.hasErrors());
    const int before = panel.table().model()->rowCount();
    base::Diagnostic again = base::warning(code.constData(), {goal.toStdString()});
    again.entity = document.scenario().humans.front().key;
    panel.setActionIssues({again});
    QCOMPARE(panel.table().model()->rowCount(), before + (isSame ? 0 : 1));
    again.entity = {};  // of nobody that is known
    panel.setActionIssues({again});
    QCOMPARE(panel.table().model()->rowCount(), before + (isSame ? 0 : 1));
  }

  void issues_mended_doNotComeBackInOtherWords() {
    ScenarioDocument document;
    document.load(personWithUnknownGoal());
    IssuesPanel panel(document, editor::Theme::light());
    document.checkNow();
    QTRY_VERIFY(panel.hasErrors());
    const base::EntityId ana = document.scenario().humans.front().key;
    base::Diagnostic echo = base::warning("tree.no-goal", {"7"});
    echo.entity = ana;
    panel.setActionIssues({echo});
    editor::pushChange<sim2d::Human>(document, ana, QString(),
                                     [](sim2d::Human& human) { human.goals.clear(); });
    document.checkNow();
    QTRY_VERIFY(!panel.hasErrors());
    const IssuesPanel fresh(document, editor::Theme::light());
    QCOMPARE(panel.table().model()->rowCount(), fresh.table().model()->rowCount());
  }

  /// Asked for, its map is an error; found missing, a warning: one problem all the same.
  void issues_sameWordsWithAnotherSeverity_areToldOnce() {
    ScenarioDocument document;
    IssuesPanel panel(document, editor::Theme::light());
    panel.setActionIssues({base::error("map.not-found", {"m", ""}, "a.yaml", 3),
                           base::warning("map.not-found", {"m", ""}, "a.yaml", 3),
                           base::warning("map.not-found", {"m", ""}, "b.yaml", 3)});
    QCOMPARE(panel.table().model()->rowCount(), 2 + static_cast<int>(document.issues().size()));
  }

  void hints_areFoldedToTheirNumber() {
    ScenarioDocument document;
    IssuesPanel panel(document, editor::Theme::light());
    const auto hint = [](const char* says) {
      return base::problem(base::Severity::Info, "run.failed", {says});
    };
    panel.resize(600, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    panel.setActionIssues({hint("one"), base::warning("run.failed", {"odd"}), hint("two")});
    const QAbstractItemModel& rows = *panel.table().model();
    QCOMPARE(panel.count(), 1);
    QCOMPARE(rows.rowCount(), 2);
    QCOMPARE(rows.index(0, 0).data().toString(), QStringLiteral("Odd"));
    QCOMPARE(rows.index(1, 0).data().toString(), QStringLiteral("2 hints"));
    clickRow(panel.table(), 1);
    QCOMPARE(rows.rowCount(), 4);
    QCOMPARE(rows.index(2, 0).data().toString(), QStringLiteral("One"));
    QCOMPARE(rows.index(3, 0).data().toString(), QStringLiteral("Two"));
    QSignalSpy wanted(&panel, &IssuesPanel::fileRequested);
    panel.setActionIssues(
        {base::problem(base::Severity::Info, "run.failed", {"here"}, "a.yaml", 4)});
    QCOMPARE(rows.rowCount(), 2);  // it stays open
    clickRow(panel.table(), 1);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().at(1).toInt(), 4);
    clickRow(panel.table(), 0);
    QCOMPARE(rows.rowCount(), 1);
  }

  void live_unknownGoal_isToldAndSelectsThePerson() {
    ScenarioDocument document;
    document.load(personWithUnknownGoal());
    IssuesPanel panel(document, editor::Theme::light());
    panel.resize(600, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    document.checkNow();
    QTRY_VERIFY(panel.count() > 0);
    QVERIFY(panel.hasErrors());
    QSignalSpy wanted(&panel, &IssuesPanel::entityRequested);
    clickRow(panel.table(), 0);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(document.selection().size(), std::size_t(1));
    QCOMPARE(document.selection().front(), document.scenario().humans.front().key);
  }

  void live_mended_becomesCalm() {
    ScenarioDocument document;
    document.load(personWithUnknownGoal());
    IssuesPanel panel(document, editor::Theme::light());
    document.checkNow();
    QTRY_VERIFY(panel.hasErrors());
    sim2d::GlobalGoal goal;
    goal.id = 7;
    goal.position = base::Vec2(4.0, 0.0);
    editor::pushAdd(document, goal);
    document.checkNow();
    QTRY_VERIFY(!panel.hasErrors());
  }

  void fixLink_clicked_mendsAndIsUndone() {
    ScenarioDocument document;
    document.load(personWithUnknownGoal());
    IssuesPanel panel(document, editor::Theme::light());
    panel.resize(700, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    document.checkNow();
    QTRY_VERIFY(panel.hasErrors());
    const QModelIndex link = panel.table().model()->index(0, 2);
    QCOMPARE(link.data().toString(), QStringLiteral("Remove goal 7 from the route"));
    QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {},
                      panel.table().visualRect(link).center());
    QVERIFY(document.scenario().humans.front().goals.empty());
    QTRY_VERIFY(!panel.hasErrors());  // the check goes on beside
    document.undoStack().undo();
    QCOMPARE(document.scenario().humans.front().goals, std::vector<int>{7});
  }

  void sentence_longerThanItsRow_goesOnInAnotherLine() {
    ScenarioDocument document;
    IssuesPanel panel(document, editor::Theme::light());
    panel.resize(420, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    const QString words = QStringLiteral(
        "The map has more pixels than can be shown at once, so that its finest "
        "walls are only seen from near");
    panel.setActionIssues({base::warning("run.failed", {"short"}),
                           base::warning("run.failed", {words.toStdString()})});
    QTRY_VERIFY(panel.table().rowHeight(1) >= 40);
    QVERIFY(panel.table().rowHeight(0) < 30);
    const QModelIndex cell = panel.table().model()->index(1, 0);
    QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(words));
    QVERIFY(panel.table().visualRect(cell).width() > 380);  // nothing else is in the row
    panel.resize(1600, 200);
    QTRY_VERIFY(panel.table().rowHeight(1) < 30);
  }

  void missingGoals_linkAsksForTheDialog() {
    ScenarioDocument document;
    sim2d::Scenario scenario = personWithUnknownGoal();
    scenario.humans.front().goals.clear();
    document.load(scenario);
    IssuesPanel panel(document, editor::Theme::light());
    panel.resize(700, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    document.checkNow();
    QTRY_VERIFY(panel.count() > 0);
    QSignalSpy wanted(&panel, &IssuesPanel::goalsRequested);
    const QRect place = panel.table().visualRect(panel.table().model()->index(0, 2));
    QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, place.center());
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(document.selection(),
             std::vector<editor::EntityId>{document.scenario().humans.front().key});
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
    QTest::mouseClick(outsideButton(viewer), Qt::LeftButton);  // there is no desktop here
    QVERIFY(saysThat(viewer, QStringLiteral("No application is available to open %1").arg(path)));
    QVERIFY(viewer.showFile(folder.filePath(QStringLiteral("no.yaml")), 1)
                .contains(QStringLiteral("no.yaml")));
  }

  void action_withoutEntity_pointsToTheFile() {
    ScenarioDocument document;
    IssuesPanel panel(document, editor::Theme::dark());
    panel.resize(600, 200);
    panel.show();
    QVERIFY(QTest::qWaitForWindowExposed(&panel));
    panel.setActionIssues({base::warning("run.failed", {"odd"}, "a.yaml", 3, 1),
                           base::error("run.failed", {"bad key"}, "/tmp/a.yaml", 12, 7)});
    QCOMPARE(panel.count(), 2);
    const QAbstractItemModel* model = panel.table().model();
    QCOMPARE(model->index(0, 0).data().toString(), QStringLiteral("Bad key"));    // errors first
    QCOMPARE(model->index(0, 2).data().toString(), QStringLiteral("a.yaml:12"));  // at the end
    QSignalSpy wanted(&panel, &IssuesPanel::fileRequested);
    clickRow(panel.table(), 0);
    QCOMPARE(wanted.count(), 1);
    QCOMPARE(wanted.front().at(1).toInt(), 12);
    panel.setActionIssues({});
    QCOMPARE(panel.count(), 0);
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
