#include <QSignalSpy>
#include <QtTest>

#include "editor/document/EditCommands.h"
#include "editor/document/EntityModel.h"
#include "editor/panels/ScenarioPanel.h"
#include "editor/tools/SelectionActions.h"

using namespace editor;

namespace {

constexpr int kPeople = 300;

sim2d::Scenario crowd() {
  sim2d::Scenario scenario;
  sim2d::GlobalGoal goal;
  goal.key = {EntityKind::Goal, 1};
  goal.id = 1;
  scenario.goals = {goal};
  for (int i = 0; i < kPeople; ++i) {
    sim2d::Human human;
    human.key = {EntityKind::Human, i + 2};
    human.id = i + 1;
    human.name = "p" + std::to_string(i + 1);
    const int row = i / 20;
    human.initPose.position = Vec2(0.8 * (i % 20), 0.8 * row);
    human.goals = {1};
    scenario.humans.push_back(human);
  }
  return scenario;
}

}  // namespace

/// Commands on hundreds of things: what follows the document is told once, not once per thing.
class ManyAtOnceTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    const auto count = [this] { ++rows_; };
    const auto* list = panel_.findChild<EntityModel*>();
    connect(list, &EntityModel::dataChanged, this, count);
    connect(list, &EntityModel::rowsInserted, this, count);
    connect(list, &EntityModel::rowsRemoved, this, count);
    connect(list, &EntityModel::layoutChanged, this, count);
    connect(list, &EntityModel::modelReset, this, [this] { rows_ += 1000; });
  }
  void init() {
    document_.load(crowd());
    selectAll(document_);
    QCOMPARE(document_.selection().size(), std::size_t{kPeople + 1});
  }

  void command_hundredsSelected_isToldOnce_data() {
    QTest::addColumn<int>("command");
    QTest::addColumn<int>("rowSignals");  // of the list, at most
    QTest::newRow("nudge") << 0 << 2;
    QTest::newRow("rotate") << 1 << 2;
    QTest::newRow("align") << 2 << 2;
    QTest::newRow("switch off") << 3 << 2;
    QTest::newRow("duplicate") << 4 << 6;
    QTest::newRow("delete") << 5 << 6;
  }
  void command_hundredsSelected_isToldOnce() {
    QFETCH(int, command);
    QFETCH(int, rowSignals);
    const sim2d::Scenario before = document_.scenario();
    QSignalSpy stepFinished(&document_, &ScenarioDocument::stepFinished);
    QSignalSpy selection(&document_, &ScenarioDocument::selectionChanged);
    rows_ = 0;
    give(command);
    QCOMPARE(stepFinished.count(), 1);
    QVERIFY2(selection.count() <= 1, QByteArray::number(selection.count()));
    QVERIFY2(rows_ <= rowSignals, QByteArray::number(rows_));
    const sim2d::Scenario after = document_.scenario();
    for (const bool back : {true, false}) {
      stepFinished.clear();
      selection.clear();
      rows_ = 0;
      back ? document_.undoStack().undo() : document_.undoStack().redo();
      QVERIFY(document_.scenario() == (back ? before : after));
      QCOMPARE(stepFinished.count(), 1);
      QVERIFY2(selection.count() <= 1, QByteArray::number(selection.count()));
      QVERIFY2(rows_ <= rowSignals, QByteArray::number(rows_));
      QCOMPARE(model().rowCount(model().index(0, 0)),
               static_cast<int>(document_.scenario().humans.size()));
    }
  }

  void delete_someOfMany_selectionKeepsTheRest() {
    QSignalSpy selection(&document_, &ScenarioDocument::selectionChanged);
    std::vector<EntityId> odd;
    for (int i = 0; i < kPeople; i += 2) {
      odd.push_back({EntityKind::Human, i + 2});
    }
    pushRemove(document_, odd);
    QCOMPARE(selection.count(), 1);
    QCOMPARE(document_.selection().size(), std::size_t{kPeople / 2 + 1});
    for (const EntityId id : document_.selection()) {
      QVERIFY(document_.contains(id));
    }
    document_.undoStack().undo();
    QCOMPARE(model().idOf(model().index(4, 0, model().index(0, 0))),
             (EntityId{EntityKind::Human, 6}));
  }

  void anotherScenario_groupsOfTheListStayOpen() {
    const QModelIndex goals = panel_.tree().model()->index(1, 0);
    panel_.tree().expand(goals);
    const QPersistentModelIndex kept(goals);
    document_.load(crowd());
    QVERIFY(kept.isValid());
    QVERIFY(panel_.tree().isExpanded(kept));
    QCOMPARE(model().rowCount(model().index(0, 0)), kPeople);
    document_.clear();
    QCOMPARE(model().rowCount(model().index(0, 0)), 0);
  }

  void switchOn_everybody_keepsTheOrder() {
    pushListed(document_, document_.entities(EntityKind::Human), false);
    pushListed(document_, document_.entities(EntityKind::Human), true);
    QVERIFY(document_.scenario() == crowd());
  }

 private:
  ScenarioDocument document_;
  ScenarioPanel panel_{document_, Theme::light()};
  int rows_ = 0;  // signals about rows of the list

  const EntityModel& model() { return *panel_.findChild<EntityModel*>(); }
  void give(int command) {
    switch (command) {
      case 0:
        pushMove(document_, document_.selection(), Vec2(0.1, 0.0));
        break;
      case 1:
        rotateSelection(document_, 0.3);
        break;
      case 2:
        alignSelection(document_, Align::Left);
        break;
      case 3:
        pushListed(document_, {{EntityKind::Human, 2}, {EntityKind::Human, 5}}, false);
        break;
      case 4:
        duplicateSelection(document_);
        break;
      default:
        pushRemove(document_, document_.selection());
    }
  }
};

QTEST_MAIN(ManyAtOnceTest)
#include "tst_ManyAtOnce.moc"
