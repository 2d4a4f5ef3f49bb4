#include <QAbstractItemModelTester>
#include <QtTest>

#include "Drops.h"
#include "SmallScenario.h"
#include "editor/document/EditCommands.h"
#include "editor/document/PeopleEdits.h"
#include "editor/look/AppStyle.h"
#include "editor/panels/ScenarioPanel.h"
#include "tests/support/Widgets.h"

using editor::EntityId;
using editor::EntityKind;
using editor::ScenarioDocument;
using editor::ScenarioPanel;

class ScenarioPanelTest : public QObject {
  Q_OBJECT

 private:
  std::unique_ptr<ScenarioDocument> document_;
  std::unique_ptr<ScenarioPanel> panel_;

  const sim2d::Scenario& scenario() const { return document_->scenario(); }
  QModelIndex rowOf(EntityId id) const {
    const auto* filter = static_cast<const editor::EntityFilter*>(panel_->tree().model());
    return filter->indexOf(id);
  }
  QRect placeOf(EntityId id) const { return panel_->tree().visualRect(rowOf(id)); }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const sim2d::Human& human : scenario().humans) {
      result.push_back(human.name);
    }
    return result;
  }
 private Q_SLOTS:
  void initTestCase() { editor::applyTheme(editor::Theme::light()); }
  void init() {
    document_ = std::make_unique<ScenarioDocument>();
    document_->load(small::scenario());
    panel_ = std::make_unique<ScenarioPanel>(*document_, editor::Theme::light());
    panel_->resize(260, 520);
    panel_->show();
    QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  }
  void cleanup() {
    panel_.reset();
    document_.reset();
  }

  void filter_typed_keepsWhatFits() {
    QTest::keyClicks(&panel_->filter(), QStringLiteral("curious"));
    QVERIFY(rowOf({EntityKind::Human, 3}).isValid());
    QVERIFY(!rowOf({EntityKind::Human, 1}).isValid());
    QTest::keyClick(&panel_->filter(), Qt::Key_A, Qt::ControlModifier);
    QTest::keyClick(&panel_->filter(), Qt::Key_Delete);
    QVERIFY(rowOf({EntityKind::Human, 1}).isValid());
  }

  void filter_typed_tellsHowManyOfAllAreSeen() {
    const auto count = [this] {
      const QAbstractItemModel& model = *panel_->tree().model();
      return model.index(0, editor::EntityModel::BehaviorColumn).data().toString();
    };
    QCOMPARE(count(), QStringLiteral("6"));
    panel_->filter().setText(QStringLiteral("scared"));
    QCOMPARE(count(), QStringLiteral("1 of 6"));
    panel_->filter().clear();
    QCOMPARE(count(), QStringLiteral("6"));
  }

  void filter_thatFindsNothing_saysSoAndIsClearedByALink() {
    const auto* nothing = panel_->findChild<editor::NoMatchesPlaceholder*>();
    QVERIFY(!nothing->isVisible() && panel_->tree().isVisible());
    panel_->filter().setText(QStringLiteral("zzz"));
    QVERIFY(nothing->isVisible() && !panel_->tree().isVisible());
    QCOMPARE(nothing->findChild<QLabel*>()->text(), QStringLiteral("No matches for 'zzz'"));
    nothing->findChild<QToolButton*>()->click();
    QVERIFY(panel_->filter().text().isEmpty());
    QVERIFY(!nothing->isVisible() && panel_->tree().isVisible());
  }

  void emptyText_isShownWithoutPeopleGoalsAndRobots() {
    const auto* empty = widgets::findIf<QLabel>(*panel_, [](const QLabel* each) {
      return each->text().startsWith(QStringLiteral("Nothing on the map yet"));
    });
    QVERIFY(empty != nullptr && !empty->isVisible());
    sim2d::Scenario withRobot = small::scenario();
    withRobot.humans.clear();
    withRobot.goals.clear();
    withRobot.areas.clear();
    withRobot.docks.clear();
    sim2d::Scenario bare = withRobot;
    bare.robots.clear();
    document_->load(bare);
    QVERIFY(empty->isVisible());
    QVERIFY(!withRobot.robots.empty());
    document_->load(withRobot);
    QVERIFY(!empty->isVisible());
  }

  void filter_groupThatComesBack_isOpen() {
    const EntityId curious = document_->scenario().humans[2].key;
    panel_->filter().setText(QStringLiteral("curious"));
    pushRemove(*document_, {curious});
    QVERIFY(panel_->findChild<editor::NoMatchesPlaceholder*>()->isVisible());
    document_->undoStack().undo();
    QVERIFY(!panel_->findChild<editor::NoMatchesPlaceholder*>()->isVisible());
    QVERIFY(panel_->tree().isExpanded(rowOf(curious).parent()));
  }

  void filter_thatHidesAll_knowsWhatCameMeanwhile() {
    using Mode = QAbstractItemModelTester::FailureReportingMode;
    const QAbstractItemModelTester whole(&panel_->model(), Mode::QtTest);
    const QAbstractItemModelTester seen(panel_->tree().model(), Mode::QtTest);
    const auto doubleAll = [this] {
      document_->setSelection(document_->entities(EntityKind::Human));
      document_->setSelection(
          pushDuplicate(*document_, document_->selection(), editor::Vec2(0.5, -0.5)));
    };
    panel_->filter().setText(QStringLiteral("zzz"));
    QCOMPARE(panel_->tree().model()->rowCount(), 0);
    doubleAll();
    panel_->filter().clear();
    doubleAll();
    QCOMPARE(scenario().humans.size(), std::size_t{24});
    QCOMPARE(panel_->tree().model()->rowCount(panel_->tree().model()->index(0, 0)), 24);
    panel_->filter().setText(QStringLiteral("scared"));
    QCOMPARE(panel_->tree().selectionModel()->selectedRows().size(), 2);
    document_->undoStack().undo();
    document_->undoStack().undo();
    QCOMPARE(panel_->tree().model()->rowCount(panel_->tree().model()->index(0, 0)), 1);
    panel_->filter().clear();
    QCOMPARE(panel_->tree().model()->rowCount(panel_->tree().model()->index(0, 0)), 6);
  }

  void menu_walkAlone_isForThoseInAGroup() {
    const EntityId ana{EntityKind::Human, 1};
    const EntityId ben{EntityKind::Human, 2};
    const auto entry = [&](const QString& text) {
      auto menu = std::make_shared<QMenu>();
      panel_->fillMenu(*menu, ana);
      for (QAction* action : menu->actions()) {
        if (action->text() == text) {
          return std::pair(menu, action);
        }
      }
      return std::pair(menu, static_cast<QAction*>(nullptr));
    };
    document_->setSelection({ana});
    QVERIFY(!entry(QStringLiteral("Walk alone")).second->isEnabled());
    QVERIFY(!entry(QStringLiteral("Walk as a group")).second->isEnabled());
    QVERIFY(entry(QStringLiteral("Walk alone"))
                .second->toolTip()
                .contains(QStringLiteral("in no group")));
    document_->setSelection({ana, ben});
    const auto group = entry(QStringLiteral("Walk as a group"));
    QVERIFY(group.second->isEnabled());
    group.second->trigger();
    const auto alone = entry(QStringLiteral("Walk alone"));
    QVERIFY(alone.second->isEnabled());
    alone.second->trigger();
    QVERIFY(editor::groupsOf(scenario()).empty());
  }

  void list_anyHeight_showsWholeRows() {
    for (const int height : {300, 311, 320}) {
      panel_->resize(260, height);
      QCOMPARE(panel_->tree().viewport()->height() % placeOf({EntityKind::Human, 1}).height(), 0);
    }
  }

  void name_typedInPlace_renamesAndUndoes() {
    QTreeView& tree = panel_->tree();
    const EntityId ben{EntityKind::Human, 2};
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, placeOf(ben).center());
    QTest::keyClick(&tree, Qt::Key_F2);
    auto* field = tree.findChild<QLineEdit*>();
    QVERIFY(field != nullptr);
    QTest::keyClicks(field, QStringLiteral("Bea"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(scenario().humans[1].name, std::string("Bea"));
    document_->undoStack().undo();
    QCOMPARE(scenario().humans[1].name, std::string("Ben"));
  }

  /// Where nobody has the keyboard the field of the one before stays open.
  void rename_whileAnotherIsBeingRenamed_takesThatFirst() {
    panel_->hide();
    panel_->rename({EntityKind::Human, 2});
    auto* first = panel_->tree().findChild<QLineEdit*>();
    QVERIFY(first != nullptr);
    first->setText(QStringLiteral("Bea"));
    static QString complaint;
    const QtMessageHandler before = qInstallMessageHandler(
        [](QtMsgType, const QMessageLogContext&, const QString& text) { complaint = text; });
    panel_->rename({EntityKind::Human, 3});
    qInstallMessageHandler(before);
    QCOMPARE(complaint, QString());
    QCOMPARE(scenario().humans[1].name, std::string("Bea"));
    QVERIFY(widgets::withText<QLineEdit>(panel_->tree(), QStringLiteral("Chloe")) != nullptr);
  }

  void row_dragged_reordersAndUndoes() {
    const QRect first = placeOf({EntityKind::Human, 1});
    dropRows(panel_->tree(), {rowOf({EntityKind::Human, 4})}, panel_->tree(),
             first.topLeft() + QPoint(40, 1), Qt::MoveAction);
    QCOMPARE(names(), (std::vector<std::string>{"Emma", "Ana", "Ben", "Chloe", "Farid", "Greta"}));
    QCOMPARE(document_->undoStack().count(), 1);
    document_->undoStack().undo();
    QVERIFY(scenario() == small::scenario());
  }

  void reorder_severalRows_keepTheirOrder() {
    editor::pushReorder(*document_, {{EntityKind::Human, 5}, {EntityKind::Human, 2}}, 4);
    QCOMPARE(names(), (std::vector<std::string>{"Ana", "Chloe", "Emma", "Ben", "Farid", "Greta"}));
    document_->undoStack().undo();
    editor::pushReorder(*document_, {{EntityKind::Human, 1}, {EntityKind::Human, 3}}, 99);
    QCOMPARE(names(), (std::vector<std::string>{"Ben", "Emma", "Farid", "Greta", "Ana", "Chloe"}));
    document_->undoStack().undo();
    QVERIFY(scenario() == small::scenario());
  }

  void eye_clicked_switchesOffAndOn() {
    const EntityId ben{EntityKind::Human, 2};
    QTreeView& tree = panel_->tree();
    const auto eye = [&] { return ScenarioPanel::eyeRect(placeOf(ben)).center(); };
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, eye());
    QCOMPARE(names().back(), std::string("Ben"));  // behind the others, as in the file
    QVERIFY(!scenario().humans.back().listed);
    tree.scrollTo(rowOf(ben));
    QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, eye());
    QVERIFY(scenario() == small::scenario());  // back at the place that the number has
    document_->undoStack().undo();
    document_->undoStack().undo();
    QVERIFY(scenario() == small::scenario());
  }

  void groups_madeNamedLeftDissolved_areUndoable() {
    const std::vector<EntityId> both = {{EntityKind::Human, 1}, {EntityKind::Human, 3}};
    const int group = editor::pushGroup(*document_, both);
    QCOMPARE(editor::groupsOf(scenario()).at(group), both);
    editor::pushGroupName(*document_, group, "family");
    QCOMPARE(editor::groupName(scenario(), group), QStringLiteral("family"));
    editor::pushJoinGroup(*document_, {both[0]}, -1);
    QCOMPARE(editor::groupsOf(scenario()).at(group).size(), std::size_t(1));
    editor::pushDissolveGroup(*document_, group);
    QVERIFY(editor::groupsOf(scenario()).empty());
    QVERIFY(scenario().desktop.groups.empty());
    while (document_->undoStack().canUndo()) {
      document_->undoStack().undo();
    }
    QVERIFY(scenario() == small::scenario());
    QVERIFY(editor::groupColor(1, editor::Theme::light()) !=
            editor::groupColor(2, editor::Theme::light()));
  }
};

QTEST_MAIN(ScenarioPanelTest)
#include "tst_ScenarioPanel.moc"
