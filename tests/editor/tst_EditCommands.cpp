#include <QSignalSpy>
#include <QtTest>

#include "SmallScenario.h"
#include "editor/document/EditCommands.h"

using namespace editor;

class EditCommandsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { document_.load(small::scenario()); }

  void pushAdd_personWithoutName_getsNameIdAndKey() {
    const EntityId id = pushAdd(document_, sim2d::Human());
    const sim2d::Human* human = document_.human(id);
    QVERIFY(human != nullptr);
    QVERIFY(human->name == "agent1");
    QCOMPARE(human->id, 7);
    QVERIFY(id.key > 51);
    document_.undoStack().undo();
    QVERIFY(document_.human(id) == nullptr);
    QVERIFY(document_.scenario() == small::scenario());
  }

  /// Each edit holds what it has changed: those of a long day would fill the memory.
  void push_veryManyEdits_theOldestAreKeptForGood() {
    constexpr int kEdits = 20005, kUndone = 20000;
    document_.undoStack().setClean();
    for (int k = 1; k <= kEdits; ++k) {
      pushChange<sim2d::Human>(
          document_, human(2), QStringLiteral("Edit %1").arg(k),
          [k](sim2d::Human& value) { value.initPose.position.x() = 0.001 * k; });
    }
    QCOMPARE(document_.undoStack().count(), kUndone);
    undoAll();
    QCOMPARE(document_.human(human(2))->initPose.position.x(), 0.001 * (kEdits - kUndone));
    QVERIFY(document_.isDirty());
  }

  void pushAdd_beforeThoseSwitchedOff_keepsTheOrderOfTheFile() {
    pushChange<sim2d::Human>(document_, human(2), QStringLiteral("Off"),
                             [](sim2d::Human& value) { value.listed = false; });
    QVERIFY(document_.scenario().humans.back().name == "Ben");
    const EntityId id = pushAdd(document_, sim2d::Human());
    QCOMPARE(document_.indexOf(id), 5);
    undoAll();
    QVERIFY(document_.scenario() == small::scenario());
  }

  void pushRemove_goal_takesItOutOfRoutesAndBack() {
    QSignalSpy spy(&document_, &ScenarioDocument::changed);
    pushRemove(document_, {goal(12)});
    QVERIFY(document_.human(human(1))->goals == std::vector<int>{1});
    QVERIFY((document_.human(human(3))->goals == std::vector<int>{1, 3}));
    QVERIFY(document_.human(human(6))->goals.empty());
    QCOMPARE(document_.undoStack().count(), 1);
    QCOMPARE(spy.count(), 4);
    document_.undoStack().undo();
    QVERIFY(document_.scenario() == small::scenario());
    QCOMPARE(document_.indexOf(goal(12)), 1);
  }

  void pushRename_person_isFollowedBySources() {
    sim2d::Area source;
    source.kind = sim2d::AreaKind::Source;
    source.name = "gate";
    source.like = "Ana";
    const EntityId area = pushAdd(document_, source);
    QVERIFY(pushRename(document_, human(1), "Anna"));
    QVERIFY(std::get<sim2d::Area>(*document_.entity(area)).like == std::string("Anna"));
    QVERIFY(!pushRename(document_, human(1), "Ben"));
    QVERIFY(!pushRename(document_, human(1), ""));
    document_.undoStack().undo();
    QVERIFY(std::get<sim2d::Area>(*document_.entity(area)).like == std::string("Ana"));
  }

  void pushGoalNumber_taken_isRefused() {
    QVERIFY(!pushGoalNumber(document_, goal(11), 2));
    QVERIFY(pushGoalNumber(document_, goal(11), 9));
    QVERIFY((document_.human(human(1))->goals == std::vector<int>{9, 2}));
    undoAll();
    QVERIFY(document_.scenario() == small::scenario());
  }

  void pushMove_nudges_mergeIntoOne() {
    for (int i = 0; i < 5; ++i) {
      pushMove(document_, {human(1), human(2)}, Vec2(0.1, 0.0), Merge::WithPrevious);
    }
    QCOMPARE(document_.undoStack().count(), 1);
    QVERIFY(std::abs(document_.human(human(1))->initPose.position.x() - 2.5) < 1e-9);
    document_.undoStack().undo();
    QVERIFY(document_.scenario() == small::scenario());
  }

  void pushEdit_backWhereItBegan_leavesNothing() {
    const auto setSpeed = [&](std::optional<double> speed) {
      pushChange<sim2d::Human>(
          document_, human(1), QStringLiteral("Speed"),
          [&](sim2d::Human& value) { value.maxVel = speed; }, Merge::WithPrevious);
    };
    setSpeed(1.1);
    setSpeed(1.2);
    QCOMPARE(document_.undoStack().count(), 1);
    setSpeed(std::nullopt);
    QCOMPARE(document_.undoStack().count(), 0);
    setSpeed(std::nullopt);  // no change: no command
    QCOMPARE(document_.undoStack().count(), 0);
  }

  void pushDuplicate_withOwnTree_copiesIt() {
    pushTrees(document_, {{human(1), std::string("<root/>")}}, QStringLiteral("Tree"));
    const std::vector<EntityId> copies = pushDuplicate(document_, {human(1)}, Vec2(1.0, 0.0));
    QCOMPARE(copies.size(), std::size_t{1});
    QVERIFY(document_.tree(copies.front()) == std::string("<root/>"));
    QVERIFY(document_.human(copies.front())->name == "Ana1");
    QCOMPARE(document_.undoStack().count(), 2);
    undoAll();
    QVERIFY(!document_.tree(human(1)));
    QVERIFY(document_.scenario() == small::scenario());
  }

  void pushReorder_person_movesInTheList() {
    pushReorder(document_, {human(5)}, 0);
    QVERIFY(document_.scenario().humans.front().name == "Farid");
    undoAll();
    QVERIFY(document_.scenario() == small::scenario());
  }

  void selection_ofRemovedEntity_isDropped() {
    document_.setSelection({human(1), goal(11)});
    pushRemove(document_, {human(1)});
    QVERIFY(document_.selection() == std::vector<EntityId>{goal(11)});
  }

  void pulled_boxCorner_keepsTheOppositeOne() {
    sim2d::Obstacle box;
    box.pose = {{1.0, 2.0}, 0.5};
    box.length = 2.0;
    box.width = 1.0;
    const std::vector<Handle> handles = handlesOf(box, {});
    const Vec2 opposite = handles[2].position;
    const Entity larger =
        withHandleMoved(box, handles[0], handles[0].position + Vec2(0.5, 0.7), true);
    QVERIFY((handlesOf(larger, {})[2].position - opposite).norm() < 1e-9);
    QVERIFY((handlesOf(larger, {})[0].position - handles[0].position - Vec2(0.5, 0.7)).norm() <
            1e-9);
  }

 private:
  static EntityId human(int key) { return {EntityKind::Human, key}; }
  static EntityId goal(int key) { return {EntityKind::Goal, key}; }

  void undoAll() {
    while (document_.undoStack().canUndo()) {
      document_.undoStack().undo();
    }
  }

  ScenarioDocument document_;
};

QTEST_MAIN(EditCommandsTest)
#include "tst_EditCommands.moc"
