#include <QComboBox>
#include <QtTest>

#include "CanvasTester.h"
#include "editor/document/EditCommands.h"
#include "editor/run/SimulationRunner.h"
#include "editor/tools/ToolManager.h"
#include "sim2d/map/Outlines.h"
#include "sim2d/world/World.h"

using namespace editor;

namespace {

/// Free above the diagonal, wall below: an edge in steps of one cell.
sim2d::OccupancyGrid stairs(const Pose2& origin) {
  constexpr int kSide = 40;
  std::vector<std::int8_t> cells(static_cast<std::size_t>(kSide) * kSide, 0);
  for (int row = 0; row < kSide; ++row) {
    for (int column = row + 1; column < kSide; ++column) {
      const int cell = row * kSide + column;
      cells[static_cast<std::size_t>(cell)] = 100;
    }
  }
  return {kSide, kSide, 0.1, origin, std::move(cells)};
}

}  // namespace

/// Walls, boxes, polygons, circles, doors and areas by real mouse and key events, and what a run
/// makes of them.
class ShapeToolsTest : public QObject, private CanvasTester {
  Q_OBJECT

 private Q_SLOTS:
  void init() { start({}); }

  void shape_dragged_isOneCommand_data() { addTools(); }

  void shape_dragged_isOneCommand() {
    QFETCH(QByteArray, name);
    use(name.constData());
    if (name == "Area") {
      key(Qt::Key_3);  // a waiting area
    }
    const Vec2 from(7.0, 2.0);
    const Vec2 to(9.0, 3.5);
    press(from);
    move(Vec2(8.0, 3.0));
    move(to);
    QVERIFY(scenario() == sim2d::Scenario());  // only a preview so far
    QCOMPARE(undoCount(), 0);
    release(to);
    QCOMPARE(undoCount(), 1);
    QCOMPARE(document_.selection().size(), std::size_t{1});
    const sim2d::Scenario made = scenario();
    const std::size_t count = made.obstacles.size() + made.doors.size() + made.areas.size();
    QCOMPARE(count, std::size_t{1});
    if (name == "Wall") {
      QVERIFY(made.obstacles[0].kind == sim2d::ObstacleKind::Wall);
      QVERIFY(isNear(made.obstacles[0].points[0], from) && isNear(made.obstacles[0].points[1], to));
      QCOMPARE(made.obstacles[0].name, std::string("wall1"));
    } else if (name == "Box") {
      QVERIFY(isNear(made.obstacles[0].pose.position, Vec2(8.0, 2.75)));
      QVERIFY(std::abs(made.obstacles[0].length - 2.0) < 0.05);
      QVERIFY(std::abs(made.obstacles[0].width - 1.5) < 0.05);
    } else if (name == "Circle") {
      QVERIFY(isNear(made.obstacles[0].pose.position, from));
      QVERIFY(std::abs(made.obstacles[0].radius - 2.5) < 0.05);
    } else if (name == "Door") {
      QVERIFY(isNear(made.doors[0].from, from) && isNear(made.doors[0].to, to));
    } else {  // polygon, area: a rectangle
      const std::vector<Vec2>& points =
          name == "Area" ? made.areas[0].points : made.obstacles[0].points;
      QCOMPARE(points.size(), std::size_t{4});
      QVERIFY(std::abs(sim2d::signedArea(points) - 3.0) < 0.15);
    }
    checkUndoAndRedo(sim2d::Scenario());
  }

  void shape_escapeOrRightButtonWhileDragging_leavesNothing_data() { addTools(); }
  void shape_escapeOrRightButtonWhileDragging_leavesNothing() {
    QFETCH(QByteArray, name);
    use(name.constData());
    press(Vec2(7.0, 2.0));
    move(Vec2(8.0, 3.0));
    move(Vec2(9.0, 3.5));
    key(Qt::Key_Escape);
    release(Vec2(9.0, 3.5));
    QVERIFY(scenario() == sim2d::Scenario());
    press(Vec2(7.0, 2.0));
    move(Vec2(9.0, 3.5));
    QTest::mouseClick(window(), Qt::RightButton, {}, at(Vec2(9.0, 3.5)));
    release(Vec2(9.0, 3.5));
    checkUnchanged(sim2d::Scenario());
    QVERIFY(!scene_.shown({EntityKind::Obstacle, -1}));
  }

  void shape_withoutSize_leavesNothing_data() { addTools(); }
  void shape_withoutSize_leavesNothing() {
    QFETCH(QByteArray, name);
    use(name.constData());
    doubleClick(Vec2(7.0, 2.0));
    rightClick(Vec2(8.0, 2.0));
    click(Vec2(7.0, 3.0));
    key(Qt::Key_Return);
    drag(Vec2(8.0, 4.0), Vec2(8.02, 4.01));
    key(Qt::Key_Escape);
    checkUnchanged(sim2d::Scenario());
  }

  void wall_cornersByClicks_endWithEnterDoubleClickOrRightButton() {
    use("Wall");
    click(Vec2(1.0, 1.0));
    click(Vec2(3.0, 1.0));
    click(Vec2(3.0, 3.0));
    key(Qt::Key_Return);
    click(Vec2(7.0, 1.0));
    doubleClick(Vec2(9.0, 2.0));
    click(Vec2(7.0, 4.0));
    click(Vec2(9.0, 5.0));
    rightClick(Vec2(10.0, 5.0));
    QCOMPARE(undoCount(), 3);
    const std::vector<sim2d::Obstacle>& walls = scenario().obstacles;
    QCOMPARE(walls[0].points.size(), std::size_t{3});
    QVERIFY(isNear(walls[0].points[2], Vec2(3.0, 3.0)));
    QCOMPARE(walls[1].points.size(), std::size_t{2});
    QVERIFY(isNear(walls[1].points[1], Vec2(9.0, 2.0)));
    QCOMPARE(walls[2].points.size(), std::size_t{2});
    QCOMPARE(walls[2].name, std::string("wall3"));
  }

  void wall_backspace_takesTheLastCornerBack() {
    use("Wall");
    click(Vec2(1.0, 1.0));
    click(Vec2(3.0, 1.0));
    click(Vec2(3.0, 3.0));
    key(Qt::Key_Backspace);
    key(Qt::Key_Return);
    QCOMPARE(scenario().obstacles.front().points.size(), std::size_t{2});
    click(Vec2(7.0, 1.0));
    key(Qt::Key_Backspace);
    key(Qt::Key_Return);
    QCOMPARE(undoCount(), 1);
  }

  void wall_firstCornerAgain_closesTheRoom() {
    use("Wall");
    for (const Vec2& corner : {Vec2(7.0, 1.0), Vec2(9.0, 1.0), Vec2(9.0, 3.0), Vec2(7.02, 1.02)}) {
      click(corner);
    }
    QCOMPARE(undoCount(), 1);
    const std::vector<Vec2>& points = scenario().obstacles.front().points;
    QCOMPARE(points.size(), std::size_t{4});
    QVERIFY(points.front() == points.back());
  }

  void wall_shift_runsInStepsOf15Degrees() {
    use("Wall");
    click(Vec2(7.0, 2.0));
    click(Vec2(9.0, 2.2), Qt::ShiftModifier);
    key(Qt::Key_Return);
    const std::vector<Vec2>& points = scenario().obstacles.front().points;
    QVERIFY(std::abs(points[1].y() - points[0].y()) < 1e-9);
    QVERIFY(std::abs(points[1].x() - 9.0) < 0.05);
  }

  void polygon_edgesThatCross_areRefusedUntilMended() {
    use("Polygon");
    for (const Vec2& corner : {Vec2(7.0, 1.0), Vec2(9.0, 3.0), Vec2(9.0, 1.0), Vec2(7.0, 3.2)}) {
      click(corner);
    }
    key(Qt::Key_Return);
    QCOMPARE(undoCount(), 0);
    QVERIFY(tools_.current()->statusText().contains(QStringLiteral("cross")));
    key(Qt::Key_Backspace);
    key(Qt::Key_Return);
    QCOMPARE(undoCount(), 1);
    QCOMPARE(scenario().obstacles.front().points.size(), std::size_t{3});
  }

  void polygon_clockwise_isStoredCounterClockwise() {
    use("Polygon");
    for (const Vec2& corner : {Vec2(7.0, 1.0), Vec2(7.0, 3.0), Vec2(9.0, 3.0), Vec2(9.0, 1.0)}) {
      click(corner);
    }
    click(Vec2(7.0, 1.0));
    QCOMPARE(undoCount(), 1);
    QCOMPARE(scenario().obstacles.front().points.size(), std::size_t{4});
    QVERIFY(sim2d::signedArea(scenario().obstacles.front().points) > 3.9);
  }

  void box_shift_isASquare() {
    use("Box");
    drag(Vec2(7.0, 1.0), Vec2(9.0, 2.0), Qt::ShiftModifier);
    QVERIFY(std::abs(scenario().obstacles.front().length - 2.0) < 0.05);
    QCOMPARE(scenario().obstacles.front().width, scenario().obstacles.front().length);
  }

  void snap_nearACorner_takesItAndCanBeSwitchedOff() {
    use("Wall");
    drag(Vec2(7.0, 2.0), Vec2(9.0, 2.0));
    const Vec2 end = scenario().obstacles.front().points.back();
    const Vec2 near = end + Vec2(4.0, 3.0) / view_.pixelsPerMetre();
    drag(near, Vec2(9.0, 4.0));
    QVERIFY(scenario().obstacles[1].points.front() == end);
    CanvasOptions options = scene_.options();
    options.snapToPoints = false;
    scene_.setOptions(options);
    drag(near, Vec2(10.0, 4.0));
    QVERIFY(!isNear(scenario().obstacles[2].points.front(), end, 0.04));
  }

  void snap_grid_takesHalfMetres() {
    CanvasOptions options = scene_.options();
    options.snapToGrid = true;
    scene_.setOptions(options);
    use("Box");
    drag(Vec2(7.1, 1.2), Vec2(8.8, 2.6));
    const sim2d::Obstacle& box = scenario().obstacles.front();
    QVERIFY(isNear(box.pose.position, Vec2(8.0, 1.75), 1e-9));
    QVERIFY(std::abs(box.length - 2.0) < 1e-9 && std::abs(box.width - 1.5) < 1e-9);
  }

  void area_kinds_areChosenByKeys() {
    use("Area");
    const std::vector<std::pair<Qt::Key, sim2d::AreaKind>> kinds = {
        {Qt::Key_2, sim2d::AreaKind::Sink},
        {Qt::Key_3, sim2d::AreaKind::Wait},
        {Qt::Key_4, sim2d::AreaKind::Exit},
        {Qt::Key_5, sim2d::AreaKind::Speed}};
    double y = 1.0;
    for (const auto& [digit, kind] : kinds) {
      key(digit);
      drag(Vec2(7.0, y), Vec2(9.0, y + 1.0));
      QVERIFY(scenario().areas.back().kind == kind);
      QVERIFY(!scenario().areas.back().like);
      y += 1.4;
    }
    QCOMPARE(scenario().areas[0].name, std::string("sink1"));
    QCOMPARE(undoCount(), 4);
  }

  void source_withoutPeople_bringsAPattern() {
    use("Area");
    key(Qt::Key_1);
    drag(Vec2(7.0, 1.0), Vec2(9.0, 3.0));
    QCOMPARE(undoCount(), 1);
    const sim2d::Area& source = scenario().areas.front();
    QVERIFY(source.kind == sim2d::AreaKind::Source);
    QVERIFY(source.rate && *source.rate > 0.0);
    const sim2d::Human* pattern = scenario().human(source.like.value_or(std::string()));
    QVERIFY(pattern != nullptr && !pattern->listed);
    use("Person");
    click(Vec2(3.0, 3.0));
    QCOMPARE(scenario().humans.front().id, 1);  // those who walk themselves count from 1
    QCOMPARE(scenario().humans.front().name, std::string("agent1"));
    undo();
    undo();
    QVERIFY(scenario() == sim2d::Scenario());
  }

  void source_withSelectedPerson_isLikeThem() {
    start(small::scenario());
    document_.setSelection({person(2)});
    use("Area");
    key(Qt::Key_1);
    drag(Vec2(7.0, 1.0), Vec2(8.0, 2.0));
    QCOMPARE(*scenario().areas.back().like, std::string("Ben"));
  }

  void optionsBar_isThereForToolsWithOptions() {
    ToolOptionsBar bar(tools_, view_);
    QVERIFY(bar.isHidden());
    use("Area");
    QVERIFY(!bar.isHidden());
    auto* kind = bar.findChild<QComboBox*>();
    QVERIFY(kind != nullptr);
    key(Qt::Key_4);
    QCOMPARE(kind->currentIndex(), 3);
    use("Select");
    QVERIFY(bar.isHidden());
  }

  void run_wallAndObstacles_keepPeopleOff() {
    addWalker(Vec2(7.0, 2.5), Vec2(11.0, 2.5));
    use("Wall");
    drag(Vec2(9.0, 1.5), Vec2(9.0, 3.5));
    use("Circle");
    drag(Vec2(7.8, 3.2), Vec2(7.8, 3.5));
    use("Box");
    drag(Vec2(9.8, 2.2), Vec2(10.4, 2.8));
    use("Polygon");
    drag(Vec2(7.8, 1.0), Vec2(8.3, 1.4));
    QCOMPARE(scenario().obstacles.size(), std::size_t{4});
    const sim2d::Surroundings around = sim2d::makeSurroundings(scenario(), *document_.map());
    const std::unique_ptr<sim2d::World> run = world();
    QVERIFY(run != nullptr);
    bool wentRound = false;
    for (int step = 0; step < 400; ++step) {
      QVERIFY(run->step());
      const Vec2 at(run->frame().humans.x[0], run->frame().humans.y[0]);
      QVERIFY(around.obstacles.clearance(at) > 0.0);
      wentRound = wentRound || (std::abs(at.x() - 9.0) < 0.3 && std::abs(at.y() - 2.5) > 1.0);
    }
    QVERIFY(wentRound);
    QVERIFY(isNear(Vec2(run->frame().humans.x[0], run->frame().humans.y[0]), Vec2(11.0, 2.5), 0.5));
  }

  void run_doorDrawnAndClosed_shutsTheGap() {
    addWalker(Vec2(3.0, 4.5), Vec2(10.0, 4.5));
    use("Door");
    drag(Vec2(6.0, 3.45), Vec2(6.0, 5.55));
    const EntityId door = document_.selection().front();
    const auto furthest = [this](int steps) {
      const std::unique_ptr<sim2d::World> run = world();
      double x = 0.0;
      for (int step = 0; run != nullptr && step < steps && run->step(); ++step) {
        x = std::max(x, run->frame().humans.x[0]);
      }
      return x;
    };
    QVERIFY(furthest(300) > 9.0);
    pushChange<sim2d::Door>(document_, door, QStringLiteral("Close later"),
                            [](sim2d::Door& value) { value.toggles = {0.5}; });
    QVERIFY(furthest(300) < 6.0);
    pushChange<sim2d::Door>(document_, door, QStringLiteral("Open later"), [](sim2d::Door& value) {
      value.open = false;
      value.toggles = {5.0};
    });
    QVERIFY(furthest(80) < 6.0);
    QVERIFY(furthest(400) > 9.0);
  }

  void run_sourceAndSink_letPeopleInAndOut() {
    addWalker(Vec2(8.0, 2.0), Vec2(10.5, 7.5));
    use("Area");
    key(Qt::Key_1);
    drag(Vec2(7.0, 1.0), Vec2(9.0, 3.0));
    key(Qt::Key_2);
    drag(Vec2(9.5, 6.5), Vec2(11.5, 8.5));
    const std::unique_ptr<sim2d::World> run = world();
    QVERIFY(run != nullptr);
    int entered = 0;
    int left = 0;
    for (int step = 0; step < 600; ++step) {
      QVERIFY(run->step());
      for (const sim2d::Event& event : run->frame().events) {
        entered += event.kind == sim2d::EventKind::Enter ? 1 : 0;
        left += event.kind == sim2d::EventKind::Leave ? 1 : 0;
      }
    }
    QVERIFY2(entered > 5, qPrintable(QString::number(entered)));  // 30 s at 0.5 a second
    QVERIFY2(left > 2, qPrintable(QString::number(left)));
  }

  void nearestOnWalls_ofTheRoom_data() {
    QTest::addColumn<QPointF>("from");
    QTest::addColumn<bool>("isFound");
    QTest::addColumn<QPointF>("expected");
    QTest::newRow("edge from the free side") << QPointF(5.83, 2.0) << true << QPointF(5.9, 2.0);
    QTest::newRow("edge from within") << QPointF(5.95, 2.0) << true << QPointF(5.9, 2.0);
    QTest::newRow("corner") << QPointF(5.86, 3.55) << true << QPointF(5.9, 3.5);
    QTest::newRow("corner before a nearer edge")
        << QPointF(5.89, 3.42) << true << QPointF(5.9, 3.5);
    QTest::newRow("corner of the room") << QPointF(0.25, 0.25) << true << QPointF(0.2, 0.2);
    QTest::newRow("nothing near") << QPointF(3.0, 3.0) << false << QPointF();
    QTest::newRow("too far") << QPointF(5.75, 2.0) << false << QPointF();
    QTest::newRow("off the map") << QPointF(-40.0, 90.0) << false << QPointF();
  }
  void nearestOnWalls_ofTheRoom() {
    QFETCH(QPointF, from);
    QFETCH(bool, isFound);
    QFETCH(QPointF, expected);
    const auto found = nearestOnWalls(*small::room(), {from.x(), from.y()}, 0.1);
    QCOMPARE(found.has_value(), isFound);
    QVERIFY(!isFound || isNear(*found, {expected.x(), expected.y()}, 1e-9));
  }

  void nearestOnWalls_slantedWall_hasNoCorners() {
    const Pose2 origin{Vec2(3.0, -2.0), 0.5};
    const sim2d::OccupancyGrid grid = stairs(origin);
    const auto found = nearestOnWalls(grid, grid.cornerToWorld(10.9, 10.5), 0.3);
    QVERIFY(found && isNear(*found, grid.cornerToWorld(11.0, 10.5), 1e-9));
  }

  void nearestOnWalls_openPlane_isNone() {
    QVERIFY(!nearestOnWalls(sim2d::OccupancyGrid(), {0.0, 0.0}, 5.0));
  }

  void door_drawnNearTheGap_liesOnItsCorners() {
    start(small::scenario());
    use("Door");
    drag({5.84, 3.46}, {5.86, 5.54});
    QCOMPARE(undoCount(), 1);
    const sim2d::Door& door = scenario().doors.back();
    QVERIFY(isNear(door.from, {5.9, 3.5}, 1e-9));
    QVERIFY(isNear(door.to, {5.9, 5.5}, 1e-9));
  }

  void door_withAltOrSwitchedOff_liesWhereTheMouseIs() {
    start(small::scenario());
    use("Door");
    press({5.84, 3.46}, Qt::AltModifier);
    move({5.84, 4.5});
    release({5.84, 5.54}, Qt::AltModifier);
    CanvasOptions options;
    options.snapToWalls = false;
    scene_.setOptions(options);
    drag({5.84, 3.46}, {5.84, 5.54});
    QCOMPARE(undoCount(), 2);
    const std::vector<sim2d::Door>& doors = scenario().doors;
    for (std::size_t i = doors.size() - 2; i < doors.size(); ++i) {
      QVERIFY(isNear(doors[i].from, {5.84, 3.46}));
      QVERIFY(std::abs(doors[i].from.x() - 5.9) > 0.03);
    }
  }

  void personAndGoal_nearAWall_areNotPulledOntoIt() {
    start(small::scenario());
    CanvasOptions options;
    options.guides = false;  // the person would align with the goal
    scene_.setOptions(options);
    use("Goal");
    click({5.80, 2.0});
    use("Select");
    drag({2.0, 2.0}, {5.82, 1.0});
    const double goal = scenario().goals.back().position.x();
    const double person = scenario().humans.front().initPose.position.x();
    QVERIFY2(std::abs(goal - 5.80) < 0.03, qPrintable(QString::number(goal)));
    QVERIFY2(std::abs(person - 5.82) < 0.03, qPrintable(QString::number(person)));
  }

 private:
  static void addTools() {
    QTest::addColumn<QByteArray>("name");
    for (const char* name : {"Wall", "Box", "Polygon", "Circle", "Door", "Area"}) {
      QTest::newRow(name) << QByteArray(name);
    }
  }

  void addWalker(const Vec2& from, const Vec2& to) {
    sim2d::Scenario scenario;
    scenario.goals = {small::goal(11, 1, to)};
    scenario.humans = {small::person(1, "Ana", from, 0.0, sim2d::BehaviorType::Regular, {1})};
    scenario.humans.front().cyclicGoals = false;
    start(std::move(scenario));
  }

  std::unique_ptr<sim2d::World> world() {
    base::Result<std::unique_ptr<sim2d::World>> made = runRequestOf(document_).makeWorld();
    return made ? std::move(*made) : nullptr;
  }
};

QTEST_MAIN(ShapeToolsTest)
#include "tst_ShapeTools.moc"
