#include <QtTest>

#include "CanvasTester.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/SelectionActions.h"
#include "sim2d/map/Outlines.h"

using namespace editor;

/// Handles, corners, turning, arranging and the clipboard.
class ShapeEditingTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    sim2d::Scenario scenario = small::scenario();
    scenario.areas.front().points = {{7.0, 4.6}, {9.0, 4.6}, {9.0, 5.8}, {7.0, 5.8}};
    scenario.humans = {scenario.humans[0], scenario.humans[1]};
    start(std::move(scenario));
  }

  void vertex_dragged_movesOneCorner() {
    document_.setSelection({kRoom});
    const std::vector<Vec2> before = value<sim2d::Area>(kRoom).points;
    drag(before[2], Vec2(9.6, 6.2));
    const std::vector<Vec2> after = value<sim2d::Area>(kRoom).points;
    QVERIFY(isNear(after[2], Vec2(9.6, 6.2)));
    QVERIFY(after[0] == before[0] && after[1] == before[1] && after[3] == before[3]);
    QCOMPARE(undoCount(), 1);
    undo();
    QVERIFY(value<sim2d::Area>(kRoom).points == before);
  }

  void vertex_shift_keepsToAnglesOfItsNeighbour() {
    document_.setSelection({kDoor});
    const sim2d::Door before = value<sim2d::Door>(kDoor);
    drag(before.to, Vec2(6.5, 4.55), Qt::ShiftModifier);
    const Vec2 way = value<sim2d::Door>(kDoor).to - before.from;
    QVERIFY(std::abs(way.x() - way.y()) < 1e-9);  // 45 degrees
  }

  void vertex_doubleClick_removesTheCornerButNotTheLastThree() {
    document_.setSelection({kRoom});
    doubleClick(value<sim2d::Area>(kRoom).points[1]);
    QCOMPARE(value<sim2d::Area>(kRoom).points.size(), std::size_t{3});
    doubleClick(value<sim2d::Area>(kRoom).points[0]);
    QCOMPARE(value<sim2d::Area>(kRoom).points.size(), std::size_t{3});
    QCOMPARE(undoCount(), 1);
  }

  void edge_doubleClick_addsACorner() {
    document_.setSelection({kRoom});
    doubleClick(Vec2(8.5, 4.6));
    const std::vector<Vec2> points = value<sim2d::Area>(kRoom).points;
    QCOMPARE(points.size(), std::size_t{5});
    QVERIFY(isNear(points[1], Vec2(8.5, 4.6)));
    QCOMPARE(undoCount(), 1);
  }

  void circle_cornerDragged_changesTheRadius() {
    document_.setSelection({kColumn});
    drag(Vec2(9.0, 2.0), Vec2(9.4, 2.4));
    QVERIFY(std::abs(value<sim2d::Obstacle>(kColumn).radius - 0.8) < 0.03);
    QVERIFY(isNear(value<sim2d::Obstacle>(kColumn).pose.position, Vec2(8.6, 1.6), 1e-9));
  }

  void box_cornerDragged_keepsTheOppositeOne() {
    document_.setSelection({kTable});
    const Vec2 opposite = handleOf(kTable, Handle::Kind::Size, 2).position;
    const Vec2 corner = handleOf(kTable, Handle::Kind::Size, 0).position;
    drag(corner, corner + Vec2(0.3, 0.3));
    QVERIFY(isNear(handleOf(kTable, Handle::Kind::Size, 2).position, opposite, 1e-6));
    QVERIFY(isNear(handleOf(kTable, Handle::Kind::Size, 0).position, corner + Vec2(0.3, 0.3)));
  }

  void door_endDragged_movesIt() {
    document_.setSelection({kDoor});
    drag(Vec2(6.0, 5.0), Vec2(6.0, 5.3));
    QVERIFY(isNear(value<sim2d::Door>(kDoor).to, Vec2(6.0, 5.3)));
    QVERIFY(value<sim2d::Door>(kDoor).from == Vec2(6.0, 4.0));
  }

  void turnHandle_ofAnArea_turnsItAboutItsMiddle() {
    document_.setSelection({kRoom});
    const Vec2 handle = handleOf(kRoom, Handle::Kind::Turn).position;
    const Vec2 centre(8.0, 5.2);
    QVERIFY(isNear(Vec2(handle.x(), centre.y()), centre));
    drag(handle, centre - Vec2((handle - centre).norm(), 0.0));  // a quarter to the left
    const std::vector<Vec2> points = value<sim2d::Area>(kRoom).points;
    QVERIFY(isNear(points[0], Vec2(8.6, 4.2), 0.05));
    QVERIFY(isNear(points[2], Vec2(7.4, 6.2), 0.05));
    QVERIFY(std::abs(sim2d::signedArea(points) - 2.4) < 1e-9);
    QCOMPARE(undoCount(), 1);
  }

  void turnHandle_shift_turnsInStepsOf15Degrees() {
    document_.setSelection({kTable});
    const Vec2 centre = value<sim2d::Obstacle>(kTable).pose.position;
    const Vec2 handle = handleOf(kTable, Handle::Kind::Turn).position;
    drag(handle, Pose2{centre, 0.5}.ahead((handle - centre).norm()), Qt::ShiftModifier);
    QCOMPARE(undoCount(), 1);
    QVERIFY(std::abs(value<sim2d::Obstacle>(kTable).pose.heading - base::kPi / 6.0) < 1e-9);
  }

  void brackets_turnTheSelectionTogether() {
    document_.setSelection({person(1), person(2)});
    const Vec2 middle = 0.5 * (document_.human(person(1))->initPose.position +
                               document_.human(person(2))->initPose.position);
    const double heading = document_.human(person(1))->initPose.heading;
    key(Qt::Key_BracketLeft);
    const Vec2 after = 0.5 * (document_.human(person(1))->initPose.position +
                              document_.human(person(2))->initPose.position);
    QVERIFY(isNear(after, middle, 1e-9));
    QVERIFY(std::abs(document_.human(person(1))->initPose.heading - heading - base::kPi / 12.0) <
            1e-9);
    key(Qt::Key_BracketRight);
    QVERIFY(isNear(document_.human(person(1))->initPose.position, Vec2(2.0, 2.0), 1e-9));
  }

  void rotated_byAQuarter_mapsPlacesAndHeadings() {
    const double quarter = 0.5 * base::kPi;
    const auto door =
        std::get<sim2d::Door>(rotated(*document_.entity(kDoor), Vec2::Zero(), quarter));
    QVERIFY(isNear(door.from, Vec2(-4.0, 6.0), 1e-9) && isNear(door.to, Vec2(-5.0, 6.0), 1e-9));
    const auto human =
        std::get<sim2d::Human>(rotated(*document_.entity(person(1)), Vec2::Zero(), quarter));
    QVERIFY(isNear(human.initPose.position, Vec2(-2.0, 2.0), 1e-9));
    QVERIFY(std::abs(human.initPose.heading - 0.6 - quarter) < 1e-9);
  }

  void align_left_movesOutlinesToOneLine() {
    document_.setSelection({kColumn, kRoom, person(1)});
    alignSelection(document_, Align::Left);
    QVERIFY(std::abs(value<sim2d::Obstacle>(kColumn).pose.position.x() - 2.4) < 1e-9);
    QVERIFY(std::abs(value<sim2d::Area>(kRoom).points[0].x() - 2.0) < 1e-9);
    QVERIFY(isNear(document_.human(person(1))->initPose.position, Vec2(2.0, 2.0), 1e-9));
    QCOMPARE(undoCount(), 1);
  }

  void distribute_across_makesGapsEqual() {
    document_.setSelection({kColumn, kRoom, person(1)});
    const double before = extentOf(*document_.entity(kRoom))->high.x();
    distributeSelection(document_, Distribute::Across);
    const Extent room = *extentOf(*document_.entity(kRoom));
    const Extent column = *extentOf(*document_.entity(kColumn));
    // From 2.0 to 9.0: outlines of 0, 2.0 and 0.8 m leave two gaps of 2.1 m.
    QVERIFY(std::abs(before - 9.0) < 1e-9);
    QVERIFY(std::abs(room.low.x() - 4.1) < 1e-9);
    QVERIFY(std::abs(column.low.x() - 8.2) < 1e-9);
    QCOMPARE(undoCount(), 1);
  }

  void arrange_tooFewThings_changesNothing() {
    document_.setSelection({kColumn});
    alignSelection(document_, Align::Top);
    document_.setSelection({kColumn, kRoom});
    distributeSelection(document_, Distribute::Up);
    document_.setSelection({});
    rotateSelection(document_, 1.0);
    QCOMPARE(undoCount(), 0);
  }

  void nudge_shift_movesByAMetre() {
    document_.setSelection({kRoom});
    key(Qt::Key_Left, Qt::ShiftModifier);
    QVERIFY(isNear(value<sim2d::Area>(kRoom).points[0], Vec2(6.0, 4.6), 1e-9));
  }

  void clipboard_sameDocument_renumbersAndSharesGoals() {
    document_.setSelection({person(1), kDoor});
    const std::unique_ptr<QMimeData> data = copiedSelection(document_);
    QVERIFY(canPaste(data.get()));
    QVERIFY(paste(document_, *data, Vec2(0.5, -0.5)));
    QCOMPARE(undoCount(), 1);
    QCOMPARE(scenario().humans.size(), std::size_t{3});
    QCOMPARE(scenario().goals.size(), std::size_t{3});
    const sim2d::Human& copy = scenario().humans.back();
    QVERIFY(copy.name != "Ana" && copy.id != 1);
    QVERIFY(copy.goals == scenario().humans.front().goals);
    QVERIFY(isNear(copy.initPose.position, Vec2(2.5, 1.5), 1e-9));
    QVERIFY(isNear(scenario().doors.back().from, Vec2(6.5, 3.5), 1e-9));
    QCOMPARE(document_.selection().size(), std::size_t{2});
    const sim2d::Scenario pasted = scenario();
    undo();
    QCOMPARE(scenario().humans.size(), std::size_t{2});
    redo();
    QVERIFY(scenario() == pasted);
  }

  void clipboard_selectedGoals_areCopiedAndRoutesFollow() {
    const EntityId first = document_.goalKey(1);
    const EntityId second = document_.goalKey(2);
    document_.setSelection({person(1), first, second});
    QVERIFY(paste(document_, *copiedSelection(document_), Vec2(0.5, -0.5)));
    QCOMPARE(scenario().goals.size(), std::size_t{5});
    QVERIFY((scenario().humans.back().goals == std::vector<int>{4, 5}));
    QVERIFY(isNear(scenario().goal(4)->position, Vec2(10.0, 7.0), 1e-9));
  }

  void clipboard_otherWindow_bringsGoalsTreesAndSources() {
    sim2d::Area source;
    source.name = "gate";
    source.kind = sim2d::AreaKind::Source;
    source.points = {{1.0, 1.0}, {2.0, 1.0}, {2.0, 2.0}};
    source.like = "Ana";
    source.rate = 0.3;
    const EntityId gate = pushAdd(document_, source);
    pushTrees(document_, {{person(1), std::string("<root/>")}}, QStringLiteral("Tree"));
    document_.setSelection({person(1), gate});
    const std::unique_ptr<QMimeData> data = copiedSelection(document_);

    ScenarioDocument other;
    sim2d::Scenario scenario;
    scenario.humans = {small::person(1, "Ana", {5.0, 5.0}, 0.0, sim2d::BehaviorType::Scared, {})};
    scenario.goals = {small::goal(11, 1, {0.0, 0.0})};
    other.load(scenario);
    QVERIFY(paste(other, *data, Vec2(0.0, 0.0)));
    QCOMPARE(other.undoStack().count(), 1);
    QCOMPARE(other.scenario().humans.size(), std::size_t{2});
    const sim2d::Human& copy = other.scenario().humans.back();
    QVERIFY(copy.name != "Ana");
    QCOMPARE(copy.id, 2);
    QCOMPARE(*other.scenario().areas.front().like, copy.name);
    QCOMPARE(other.scenario().goals.size(), std::size_t{3});
    QCOMPARE(copy.goals.size(), std::size_t{2});
    QVERIFY(other.scenario().goal(copy.goals[0])->position == Vec2(9.5, 7.5));
    QCOMPARE(*other.tree(copy.key), std::string("<root/>"));
    other.undoStack().undo();
    QVERIFY(other.scenario() == scenario);
  }

  void clipboard_text_isAScenario() {
    document_.setSelection({person(1), person(2), kTable, kRoom});
    const QString text = copiedSelection(document_)->text();
    const sim2d::ScenarioReading reading = sim2d::readScenarioText(text.toStdString(), "copy.yaml");
    QVERIFY(reading.ok());
    QCOMPARE(reading.scenario.humans.size(), std::size_t{2});
    QCOMPARE(reading.scenario.obstacles.size(), std::size_t{1});
    QCOMPARE(reading.scenario.areas.size(), std::size_t{1});
  }

  void clipboard_nonsense_isRefused() {
    QMimeData data;
    QVERIFY(!canPaste(&data) && !canPaste(nullptr));
    QVERIFY(!paste(document_, data, Vec2::Zero()));
    data.setText(QStringLiteral("hunav_loader: [1, 2"));
    QVERIFY(!paste(document_, data, Vec2::Zero()));
    data.setText(QStringLiteral("hello"));
    QVERIFY(!paste(document_, data, Vec2::Zero()));
    QCOMPARE(undoCount(), 0);
  }

 private:
  static constexpr EntityId kRoom{base::EntityKind::Area, 41};
  static constexpr EntityId kDoor{base::EntityKind::Door, 51};
  static constexpr EntityId kTable{base::EntityKind::Obstacle, 31};
  static constexpr EntityId kColumn{base::EntityKind::Obstacle, 32};
  template <class T>
  T value(EntityId id) {
    return std::get<T>(*document_.entity(id));
  }
  Handle handleOf(EntityId id, Handle::Kind kind, int index = 0) {
    HandleSizes sizes;
    sizes.turnDistance = 24.0 / view_.pixelsPerMetre();
    for (const Handle& handle : handlesOf(*document_.entity(id), sizes)) {
      if (handle.kind == kind && handle.index == index) {
        return handle;
      }
    }
    return {};
  }
};
QTEST_MAIN(ShapeEditingTest)
#include "tst_ShapeEditing.moc"
