#include <cmath>

#include <QtTest>

#include "CanvasTester.h"
#include "editor/document/EditCommands.h"
#include "editor/tools/SelectionActions.h"

using namespace editor;

/// The tools by real mouse events on a window.
class ToolsTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start(small::scenario()); }

  void personAndGoal_placedWithTheMouse_canBeUndoneAndRedone() {
    document_.load(sim2d::Scenario());
    document_.setMap(small::room());
    use("Person");
    drag(Vec2(3.0, 3.0), Vec2(3.0, 4.0));
    use("Goal");
    click(Vec2(8.0, 6.0));
    const sim2d::Scenario placed = scenario();
    QCOMPARE(placed.humans.size(), std::size_t{1});
    QCOMPARE(placed.goals.size(), std::size_t{1});
    const sim2d::Human& person = placed.humans.front();
    QVERIFY((person.initPose.position - Vec2(3.0, 3.0)).norm() < 0.05);
    QVERIFY(std::abs(person.initPose.heading - 0.5 * base::kPi) < 0.05);
    QVERIFY((placed.goals.front().position - Vec2(8.0, 6.0)).norm() < 0.05);
    QCOMPARE(undoCount(), 2);
    checkUndoAndRedo(sim2d::Scenario(), 2);
  }

  void delete_undone_selectsAgain() {
    click(Vec2(2.0, 2.0));
    click(Vec2(4.0, 6.5), Qt::ShiftModifier);
    QCOMPARE(document_.selection(), (std::vector<EntityId>{person(1), person(2)}));
    key(Qt::Key_Delete);
    QVERIFY(document_.selection().empty());
    click(Vec2(7.5, 3.0));
    undo();
    QCOMPARE(document_.selection(), (std::vector<EntityId>{person(1), person(2)}));
    redo();
    QVERIFY(document_.selection().empty());
    undo();
    QCOMPARE(document_.selection(), (std::vector<EntityId>{person(1), person(2)}));
  }

  void placed_undoneAndRedone_isSelectedAgain() {
    use("Person");
    click(Vec2(9.0, 8.0));
    const std::vector<EntityId> placed = document_.selection();
    undo();
    QVERIFY(document_.selection().empty());
    redo();
    QCOMPARE(document_.selection(), placed);
  }

  void person_turnedToTheRightWithCtrl_hasNoMinusZero() {
    use("Person");
    drag(Vec2(2.5, 5.0), Vec2(3.5, 4.95), Qt::ControlModifier);
    const double heading = scenario().humans.back().initPose.heading;
    QCOMPARE(heading, 0.0);
    QVERIFY(!std::signbit(heading));
  }

  void escape_whilePlacing_leavesNothing() {
    use("Person");
    press(Vec2(9.0, 8.0));
    move(Vec2(9.5, 8.0));
    key(Qt::Key_Escape);
    release(Vec2(9.5, 8.0));
    checkUnchanged(small::scenario());
  }

  void escape_inAnIdleTool_goesBackToSelect() {
    use("Wall");
    click(Vec2(3.0, 7.5));
    key(Qt::Key_Escape);  // drops the corner
    QVERIFY(tools_.current() == tool("Wall"));
    key(Qt::Key_Escape);
    QVERIFY(tools_.isSelecting());
    QVERIFY(scenario() == small::scenario());
  }

  void select_nudgedByKeys_writesShortNumbers() {
    document_.setSelection({person(1)});
    for (int i = 0; i < 3; ++i) {
      key(Qt::Key_Right);
    }
    QCOMPARE(document_.human(person(1))->initPose.position.x(), 2.3);  // not 2.3000000000000003
    QCOMPARE(undoCount(), 1);
  }

  void select_click_selectsAndEmptyGroundClears() {
    click(Vec2(2.0, 2.0));
    QVERIFY(document_.selection() == std::vector<EntityId>{person(1)});
    click(Vec2(4.0, 6.5), Qt::ShiftModifier);
    QCOMPARE(document_.selection().size(), std::size_t{2});
    click(Vec2(11.0, 8.0));
    QVERIFY(document_.selection().empty());
  }

  void select_statusText_tellsOfTheHandlesThatAreThere() {
    const QString turn = QStringLiteral("turn");
    click(Vec2(2.0, 2.0));
    QVERIFY(tools_.current()->statusText().contains(turn));
    click(Vec2(8.6, 1.6));  // a round column
    QCOMPARE(document_.selection().size(), std::size_t{1});
    QVERIFY(!tools_.current()->statusText().contains(turn));
    QVERIFY(tools_.current()->statusText().contains(QStringLiteral("size")));
  }

  void select_drag_movesAllSelectedWithOneCommand() {
    document_.setSelection({person(1), person(2)});
    drag(Vec2(2.0, 2.0), Vec2(3.0, 2.5));
    const Vec2 ana = document_.human(person(1))->initPose.position;
    const Vec2 ben = document_.human(person(2))->initPose.position;
    QVERIFY((ana - Vec2(3.0, 2.5)).norm() < 0.05);
    QVERIFY((ben - ana - Vec2(2.0, 4.5)).norm() < 1e-9);
    QCOMPARE(undoCount(), 1);
    undo();
    QVERIFY(scenario() == small::scenario());
  }

  void goal_pickedUpAndToolLeft_staysWhereItWas() {
    use("Goal");
    click(Vec2(2.0, 7.0));
    move(Vec2(3.0, 7.5));
    use("Person");
    QVERIFY(scenario() == small::scenario());
    QVERIFY(scene_.movingIds().empty());
    QCOMPARE(undoCount(), 0);
  }

  void select_escapeWhileMoving_putsBack() {
    press(Vec2(2.0, 2.0));
    move(Vec2(3.0, 3.0));
    QVERIFY(positionOf(*scene_.shown(person(1)))->x() > 2.5);
    key(Qt::Key_Escape);
    release(Vec2(3.0, 3.0));
    QVERIFY(scenario() == small::scenario());
    QVERIFY(*scene_.shown(person(1)) == *document_.entity(person(1)));
  }

  void select_band_takesWhatLiesInside() {
    drag(Vec2(1.2, 1.4), Vec2(3.5, 4.2));
    QVERIFY((document_.selection() == std::vector<EntityId>{person(1), person(5)}));
  }

  void select_turnHandle_turns() {
    document_.setSelection({person(1)});
    const Vec2 centre = document_.human(person(1))->initPose.position;
    const double reach = 52.0 / view_.pixelsPerMetre();
    const Vec2 handle = Pose2{centre, 0.6}.ahead(reach);
    drag(handle, centre + Vec2(0.0, reach));
    QVERIFY(std::abs(document_.human(person(1))->initPose.heading - 0.5 * base::kPi) < 0.06);
    QVERIFY(document_.human(person(1))->initPose.position == centre);
    QCOMPARE(undoCount(), 1);
  }

  void select_keys_nudgeDuplicateRemove() {
    click(Vec2(2.0, 2.0));
    key(Qt::Key_Right);
    key(Qt::Key_Up, Qt::ShiftModifier);
    QVERIFY((document_.human(person(1))->initPose.position - Vec2(2.1, 3.0)).norm() < 1e-9);
    QCOMPARE(undoCount(), 1);
    key(Qt::Key_D, Qt::ControlModifier);
    QCOMPARE(scenario().humans.size(), std::size_t{7});
    key(Qt::Key_Delete);
    QVERIFY(document_.human(person(1)) != nullptr);
    QCOMPARE(scenario().humans.size(), std::size_t{6});
  }

  void select_robotGoal_isMovedAlone() {
    drag(Vec2(1.5, 1.0), Vec2(3.0, 8.0));
    const sim2d::Robot& robot = scenario().robots.front();
    QVERIFY(robot.start == small::scenario().robots.front().start);
    QVERIFY((*robot.goal.point - Vec2(3.0, 8.0)).norm() < 0.05);
  }

  void goal_clickOnOne_picksItUpAndDropsIt() {
    use("Goal");
    click(Vec2(2.0, 7.0));
    move(Vec2(3.0, 7.5));
    click(Vec2(3.5, 8.0));
    QCOMPARE(scenario().goals.size(), std::size_t{3});
    QVERIFY((scenario().goals[1].position - Vec2(3.5, 8.0)).norm() < 0.05);
    QCOMPARE(undoCount(), 1);
  }

  void route_goalsInOrder_areAssigned() {
    use("Route");
    click(Vec2(3.2, 3.8));
    click(Vec2(10.0, 1.5));
    click(Vec2(2.0, 7.0));
    QVERIFY(document_.human(person(5))->goals.empty());
    key(Qt::Key_Return);
    QVERIFY((document_.human(person(5))->goals == std::vector<int>{3, 2}));
    QCOMPARE(undoCount(), 1);
  }

  void route_clickThatDoesNothing_saysWhy() {
    document_.setSelection({});
    use("Route");
    click(Vec2(6.0, 8.0));
    QCOMPARE(tool("Route")->statusText(),
             QStringLiteral("Nothing is selected: click a person or robot first"));
    click(Vec2(3.2, 3.8));
    click(Vec2(6.0, 8.0));
    QVERIFY(tool("Route")->statusText().startsWith(QStringLiteral("No goal here")));
    key(Qt::Key_Backspace);
    QVERIFY(tool("Route")->statusText().startsWith(QStringLiteral("Click the goals")));
    click(Vec2(6.0, 8.0));
    document_.setSelection({});  // in a list
    QVERIFY(tool("Route")->statusText().startsWith(QStringLiteral("Click the person or robot")));
    click(Vec2(3.2, 3.8));
    click(Vec2(10.0, 1.5));
    QVERIFY(tool("Route")->statusText().startsWith(QStringLiteral("Route 3")));
    click(Vec2(10.0, 1.5));
    QCOMPARE(tool("Route")->statusText(),
             QStringLiteral("Goal 3 is already the last goal of the route"));
    key(Qt::Key_Return);
    QVERIFY((document_.human(person(5))->goals == std::vector<int>{3}));
  }

  void dock_placedMovedTurnedAndDeleted_isOneCommandEach() {
    document_.load(sim2d::Scenario());
    document_.setMap(small::room());
    use("Dock");
    drag(Vec2(3.0, 3.0), Vec2(3.0, 4.0));
    QCOMPARE(scenario().docks.size(), std::size_t{1});
    const sim2d::Dock placed = scenario().docks.front();
    QCOMPARE(placed.name, std::string("dock1"));
    QVERIFY((placed.pose.position - Vec2(3.0, 3.0)).norm() < 0.05);
    QVERIFY(std::abs(placed.pose.heading - 0.5 * base::kPi) < 0.05);
    QVERIFY(placed.kind == sim2d::DockKind::Charging);
    const sim2d::ScenarioReading saved =
        sim2d::readScenarioText(sim2d::writeScenario(scenario()), "dock.yaml");
    QVERIFY(!base::hasErrors(saved.diagnostics));
    QCOMPARE(saved.scenario.docks.size(), std::size_t{1});
    QVERIFY(saved.scenario.docks.front().pose == placed.pose);
    use("Select");
    drag(Vec2(3.0, 3.0), Vec2(5.0, 3.0));
    QVERIFY((scenario().docks.front().pose.position - Vec2(5.0, 3.0)).norm() < 0.05);
    key(Qt::Key_Delete);
    QVERIFY(scenario().docks.empty());
    QCOMPARE(undoCount(), 3);
    undo();
    undo();
    QVERIFY(scenario().docks.front() == placed);
  }

  void robot_startThenGoal_areTwoCommands() {
    document_.load(sim2d::Scenario());
    document_.setMap(small::room());
    use("Robot");
    drag(Vec2(3.0, 3.0), Vec2(4.0, 3.0));
    click(Vec2(9.0, 7.0));
    QCOMPARE(scenario().robots.size(), std::size_t{1});
    const sim2d::Robot& robot = scenario().robots.front();
    QVERIFY((robot.start.position - Vec2(3.0, 3.0)).norm() < 0.05);
    QVERIFY(std::abs(robot.start.heading) < 0.05);
    QVERIFY((*robot.goal.point - Vec2(9.0, 7.0)).norm() < 0.05);
    QCOMPARE(undoCount(), 2);
    const sim2d::ScenarioReading saved =
        sim2d::readScenarioText(sim2d::writeScenario(scenario()), "robot.yaml");
    QVERIFY(saved.ok());
    QCOMPARE(saved.scenario.robots.size(), std::size_t{1});
    QVERIFY(saved.scenario.robots.front().start == robot.start);
    QVERIFY(saved.scenario.robots.front().goal.point == robot.goal.point);
  }

  /// As people are: Ctrl holds it at 22.5 degrees, a click leaves it as the last one was turned.
  void robot_pressAndDrag_isPlacedAndTurnedAsPeopleAre() {
    document_.load(sim2d::Scenario());
    document_.setMap(small::room());
    use("Robot");
    const auto robot = [this](std::size_t index) { return scenario().robots.at(index).start; };
    drag(Vec2(3.0, 3.0), Vec2(4.0, 4.2), Qt::ControlModifier);  // at 50.2 degrees
    QVERIFY(isNear(robot(0).position, Vec2(3.0, 3.0)));
    QVERIFY(std::abs(robot(0).heading - base::kPi / 4.0) < 1e-9);
    key(Qt::Key_Escape);
    QVERIFY(!scenario().robots.at(0).goal.point);
    drag(Vec2(2.0, 2.0), Vec2(1.0, 2.0));  // moves the robot that is selected
    QCOMPARE(scenario().robots.size(), std::size_t{1});
    QVERIFY(std::abs(std::abs(robot(0).heading) - base::kPi) < 0.02);
    key(Qt::Key_Escape);
    click(Vec2(9.0, 3.0), Qt::ShiftModifier);
    QCOMPARE(scenario().robots.size(), std::size_t{2});
    QCOMPARE(robot(1).heading, robot(0).heading);
  }

  void middleButton_drag_pansAndKeepsTheDocument() {
    const Vec2 before = view_.worldAt(QPoint(100, 100));
    QTest::mousePress(window(), Qt::MiddleButton, {}, QPoint(400, 300));
    QMouseEvent event(QEvent::MouseMove, QPointF(460, 330), QPointF(460, 330), Qt::NoButton,
                      Qt::MiddleButton, {});
    QApplication::sendEvent(view_.viewport(), &event);
    QTest::mouseRelease(window(), Qt::MiddleButton, {}, QPoint(460, 330));
    QVERIFY((view_.worldAt(QPoint(160, 130)) - before).norm() * view_.pixelsPerMetre() < 2.0);
    QVERIFY(scenario() == small::scenario());
  }

  void actions_areExclusiveAndRestDuringARun() {
    use("Goal");
    QCOMPARE(tools_.current(), tool("Goal"));
    tools_.setEditingEnabled(false);
    QVERIFY(tools_.isSelecting());
    QVERIFY(!tools_.actions().actions().at(1)->isEnabled());
  }
};

QTEST_MAIN(ToolsTest)
#include "tst_Tools.moc"
