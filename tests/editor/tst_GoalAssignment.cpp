#include <memory>

#include <QtTest>

#include "Drops.h"
#include "SmallScenario.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/behavior/GoalAssignment.h"
#include "tests/support/Widgets.h"

using editor::GoalAssignment;
using editor::ScenarioDocument;

namespace {

using Route = std::vector<int>;

QPoint middleOf(const QListWidget& list, int row) {
  return list.visualItemRect(list.item(row)).center();
}

void click(QListWidget& list, int row, Qt::KeyboardModifiers modifiers = {}) {
  QTest::mouseClick(list.viewport(), Qt::LeftButton, modifiers, middleOf(list, row));
}

void drag(QListWidget& from, int row, QListWidget& to, const QPoint& at) {
  dropRows(from, {from.model()->index(row, 0)}, to, at, Qt::CopyAction);
}

QString text(const Route& route) {
  QStringList words;
  for (const int goal : route) {
    words << QString::number(goal);
  }
  return words.join(QLatin1Char(' '));
}

}  // namespace

class GoalAssignmentTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<GoalAssignment> dialog_;

  const sim2d::Human& human(int index) const {
    return document_->scenario().humans[static_cast<std::size_t>(index)];
  }
  void press(const QString& name) const {
    auto* button = widgets::findIf<QPushButton>(*dialog_, [&](const QPushButton* each) {
      return each->accessibleName().startsWith(name) || each->text() == name;
    });
    QVERIFY2(button != nullptr, qPrintable(name));
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void open() {
    dialog_ = std::make_unique<GoalAssignment>(*document_, editor::Theme::light());
    dialog_->show();
    QVERIFY(QTest::qWaitForWindowExposed(dialog_.get()));
  }

 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    document_ = std::make_unique<ScenarioDocument>();
    document_->load(small::scenario());  // Ana 1 2, Ben 3, Chloe 2 1 3, Emma 1, Farid -, Greta 2
  }
  void cleanup() {
    dialog_.reset();
    document_.reset();
  }

  void people_nobodySelected_choosesTheFirstWithoutGoals() {
    open();
    QCOMPARE(dialog_->people().selectedItems().size(), 1);
    QCOMPARE(dialog_->people().currentItem()->text(), QStringLiteral("Farid"));
    QVERIFY(!dialog_->route().hint().isEmpty());
  }

  void goals_selectedOnTheMap_startTheRoute() {
    const editor::EntityId farid = human(4).key;
    const editor::EntityId third = document_->goalKey(3);
    const editor::EntityId first = document_->goalKey(1);
    document_->setSelection({farid, third, first});
    open();
    QCOMPARE(dialog_->goals().selectedGoals(), (Route{1, 3}));
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("3 1"));  // in order of selection
    press(QStringLiteral("Assign"));
    QCOMPARE(text(human(4).goals), QStringLiteral("3 1"));
    QCOMPARE(document_->selection(), std::vector<editor::EntityId>{farid});
  }

  void goals_selectedAlone_goToPeopleWithoutGoals() {
    document_->setSelection({document_->goalKey(2)});
    open();
    QCOMPARE(dialog_->people().selectedItems().size(), 1);
    QCOMPARE(dialog_->people().currentItem()->text(), QStringLiteral("Farid"));
    QCOMPARE(dialog_->goals().selectedGoals(), Route{2});
    press(QStringLiteral("Add"));
    press(QStringLiteral("Assign"));
    QCOMPARE(text(human(4).goals), QStringLiteral("2"));
  }

  void goals_selectedForPeopleWithARoute_areOnlyChosen() {
    document_->setSelection({human(0).key, document_->goalKey(3)});
    open();
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("1 2"));
    QCOMPARE(dialog_->goals().selectedGoals(), Route{3});
    press(QStringLiteral("Add"));
    press(QStringLiteral("Assign"));
    QCOMPARE(text(human(0).goals), QStringLiteral("1 2 3"));
  }

  void assign_changedPeople_areSelectedOnTheMap() {
    open();
    click(dialog_->people(), 0);
    click(dialog_->people(), 1, Qt::ControlModifier);
    click(dialog_->goals(), 1);
    press(QStringLiteral("Add"));
    press(QStringLiteral("Assign"));
    std::vector<editor::EntityId> changed;
    for (int i = 0; i < 6; ++i) {
      if (!(human(i) == small::scenario().humans[static_cast<std::size_t>(i)])) {
        changed.push_back(human(i).key);
      }
    }
    QVERIFY(!changed.empty());
    QCOMPARE(document_->selection(), changed);
  }

  void goals_addedToSeveralPeople_areOneUndoableStep() {
    open();
    click(dialog_->people(), 4);
    click(dialog_->people(), 0, Qt::ControlModifier);
    click(dialog_->goals(), 2);
    press(QStringLiteral("Add"));
    QCOMPARE(text(human(4).goals), QStringLiteral(""));  // not before Assign
    click(dialog_->people(), 1);
    click(dialog_->goals(), 0);
    QTest::mouseDClick(dialog_->goals().viewport(), Qt::LeftButton, {},
                       middleOf(dialog_->goals(), 0));
    press(QStringLiteral("Assign"));
    QCOMPARE(text(human(0).goals), QStringLiteral("1 2 3"));
    QCOMPARE(text(human(1).goals), QStringLiteral("3 1"));
    QCOMPARE(text(human(4).goals), QStringLiteral("3"));
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QVERIFY(document_->scenario() == small::scenario());
  }

  void goals_ofAFileOpenedTwice_areListedOnce() {
    QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("twice.yaml"));
    QVERIFY(!base::hasErrors(document_->save(path)));
    for (int i = 0; i < 2; ++i) {
      QVERIFY(!base::hasErrors(document_->open(path)));
      open();
      QCOMPARE(dialog_->goals().count(), static_cast<int>(small::scenario().goals.size()));
      QCOMPARE(dialog_->people().count(), static_cast<int>(small::scenario().humans.size()));
      dialog_.reset();
    }
  }

  void goal_twiceInARoute_isKept() {
    open();
    click(dialog_->people(), 1);
    click(dialog_->goals(), 2);
    QTest::keyClick(&dialog_->goals(), Qt::Key_Return);
    press(QStringLiteral("Assign"));
    QCOMPARE(text(human(1).goals), QStringLiteral("3 3"));
  }

  void route_dragged_changesItsOrder() {
    open();
    click(dialog_->people(), 2);
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("2 1 3"));
    const QRect first = dialog_->route().visualItemRect(dialog_->route().item(0));
    drag(dialog_->route(), 2, dialog_->route(), first.topLeft() + QPoint(40, 3));
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("3 2 1"));
    press(QStringLiteral("Assign"));
    QCOMPARE(text(human(2).goals), QStringLiteral("3 2 1"));
  }

  void goal_draggedOver_landsWhereItIsDropped() {
    open();
    click(dialog_->people(), 0);
    const QRect second = dialog_->route().visualItemRect(dialog_->route().item(1));
    drag(dialog_->goals(), 2, dialog_->route(), second.topLeft() + QPoint(40, 3));
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("1 3 2"));
    QCOMPARE(dialog_->goals().count(), 3);  // the goals stay where they were
  }

  void route_keys_moveAndRemove() {
    open();
    click(dialog_->people(), 2);
    click(dialog_->route(), 0);
    QTest::keyClick(&dialog_->route(), Qt::Key_Down, Qt::AltModifier);
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("1 2 3"));
    QTest::keyClick(&dialog_->route(), Qt::Key_Delete);  // goal 2 stays selected
    QCOMPARE(text(dialog_->route().goals()), QStringLiteral("1 3"));
    press(QStringLiteral("Clear"));
    QVERIFY(dialog_->route().goals().empty());
  }

  /// Qt comes back to the list when the drag out of it is over.
  void dialog_closed_isDeletedAfterADragOutOfIt_data() {
    QTest::addColumn<bool>("isDragged");
    QTest::newRow("no drag") << false;
    QTest::newRow("drag") << true;
  }
  void dialog_closed_isDeletedAfterADragOutOfIt() {
    QFETCH(bool, isDragged);
    QWidget window;
    window.show();
    editor::openGoalAssignment(*document_, editor::Theme::light(), &window);
    const QPointer<GoalAssignment> dialog = window.findChild<GoalAssignment*>();
    QVERIFY(QTest::qWaitForWindowExposed(dialog));
    auto drag = isDragged ? std::make_unique<QDrag>(&dialog->goals()) : nullptr;
    dialog->reject();
    QTest::qWait(100);
    QCOMPARE(!dialog.isNull(), isDragged);
    drag.reset();
    QTRY_VERIFY(!dialog);
  }

  void cancel_changesNothing() {
    open();
    click(dialog_->people(), 2);
    press(QStringLiteral("Clear"));
    QTest::keyClick(dialog_.get(), Qt::Key_Escape);
    QVERIFY(!dialog_->isVisible());
    QCOMPARE(document_->undoStack().count(), 0);
  }

  void repeat_clicked_isSetForAllThatAreChosen() {
    document_->setSelection({human(0).key, human(1).key});
    open();
    QTest::mouseClick(dialog_->findChild<QCheckBox*>(), Qt::LeftButton, {}, QPoint(8, 10));
    press(QStringLiteral("Assign"));
    QCOMPARE(human(0).cyclicGoals, std::optional(false));
    QCOMPARE(human(1).cyclicGoals, std::optional(false));
    QVERIFY(!human(2).cyclicGoals);
  }

  void waits_followTheirGoals() {
    sim2d::Human human =
        small::person(1, "Ana", {0, 0}, 0, sim2d::BehaviorType::Regular, {4, 5, 4});
    human.ours.wait = {1.0, 2.0, 3.0};
    editor::setGoals(human, {5, 4, 6, 4});
    QCOMPARE(human.ours.wait, (std::vector<double>{2.0, 1.0, 0.0, 3.0}));
  }
};

QTEST_MAIN(GoalAssignmentTest)
#include "tst_GoalAssignment.moc"
