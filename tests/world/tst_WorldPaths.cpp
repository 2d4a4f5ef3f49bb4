#include <algorithm>
#include <cmath>

#include <QtTest>

#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Scenario withShape(const std::string& shape) {
  Scenario scenario;
  addGoal(scenario, 1, 8.0, 0.0);
  addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
  if (shape == "corridor") {
    addWall(scenario, {Vec2(-1.0, 0.8), Vec2(9.0, 0.8)});
    addWall(scenario, {Vec2(-1.0, -0.8), Vec2(9.0, -0.8)});
  } else if (shape == "corner") {
    scenario.goals[0].position = Vec2(6.0, 6.0);
    addWall(scenario, {Vec2(-1.0, 1.0), Vec2(5.0, 1.0), Vec2(5.0, 8.0)});
    addWall(scenario, {Vec2(-1.0, -1.0), Vec2(7.0, -1.0), Vec2(7.0, 8.0)});
  } else if (shape == "gap") {
    addWall(scenario, {Vec2(4.0, -6.0), Vec2(4.0, 1.0)});
    addWall(scenario, {Vec2(4.0, 2.1), Vec2(4.0, 6.0)});
  } else if (shape == "pocket") {
    addWall(scenario, {Vec2(2.0, 3.0), Vec2(4.0, 3.0), Vec2(4.0, -3.0), Vec2(2.0, -3.0)});
  }
  return scenario;
}

}  // namespace

class WorldPathsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void walk_roundObstacles_reachesTheGoal_data() {
    addColumns<QString, int>({"shape", "steps"});
    QTest::newRow("corridor") << "corridor" << 140;
    QTest::newRow("corner") << "corner" << 220;
    QTest::newRow("gap in a wall") << "gap" << 180;
    QTest::newRow("pocket") << "pocket" << 300;
  }

  void walk_roundObstacles_reachesTheGoal() {
    QFETCH(QString, shape);
    QFETCH(int, steps);
    const auto world = make(withShape(shape.toStdString()));
    const std::vector<Recorded> events = advance(*world, steps);
    const std::vector<Recorded> reached = ofKind(events, EventKind::Goal);
    QCOMPARE(reached.size(), std::size_t{1});
    QCOMPARE(reached[0].event.id, 1);
    QVERIFY(reached[0].event.text == "1");
    QVERIFY(ofKind(events, EventKind::Stuck).empty());
  }

  void walk_straightIntoAPocket_staysThere() {
    Scenario scenario = withShape("pocket");
    scenario.desktop.route = Route::Direct;
    const auto world = make(scenario);
    QVERIFY(ofKind(advance(*world, 400), EventKind::Goal).empty());
    const Vec2 place = positionOf(world->frame(), 0);
    QVERIFY(std::fabs(place.x() - (3.9 - 0.4 - 0.102)) < 0.005);  // equilibrium at the wall
  }

  void walk_unreachableGoal_isLeftOutWithAWarning() {
    Scenario scenario = withShape("open");
    addRoom(scenario, Vec2(6.0, -2.0), Vec2(10.0, 2.0));
    addGoal(scenario, 2, 0.0, 3.0);
    scenario.humans[0].goals = {1, 2};
    base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QCOMPARE(world.diagnostics().size(), std::size_t{1});
    QVERIFY(world.diagnostics()[0].message.find("no path to goal 1") != std::string::npos);
    const std::vector<Recorded> reached = ofKind(advance(**world, 200), EventKind::Goal);
    QCOMPARE(reached.size(), std::size_t{1});
    QVERIFY(reached[0].event.text == "2");
  }

  void walk_noWayAtAll_isStuck() {
    Scenario scenario = withShape("open");
    addRoom(scenario, Vec2(6.0, -2.0), Vec2(10.0, 2.0));
    scenario.humans[0].goals.clear();
    const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
      intents.of(0).motion = Motion::Walk;
      intents.of(0).speed = 1.0;
      intents.of(0).target.position = Vec2(8.0, 0.0);
      QVERIFY(!view.isReachable(0, Vec2(8.0, 0.0)));
      QVERIFY(view.isReachable(0, Vec2(0.0, 5.0)));
    });
    const std::vector<Recorded> events = advance(*world, 200);
    QVERIFY(!ofKind(events, EventKind::Stuck).empty());
    QVERIFY(speedOf(world->frame(), 0) == 0.0);
  }

  void walk_behindAMovingTarget_isNotStuck() {
    Scenario scenario = withShape("open");
    scenario.humans[0].goals.clear();
    const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
      intents.of(0).motion = Motion::Walk;
      intents.of(0).speed = 1.0;
      intents.of(0).target.position = view.pose(0).position + Vec2(1.5, 0.0);
    });
    const std::vector<Recorded> events = advance(*world, 300);
    QVERIFY(ofKind(events, EventKind::Stuck).empty());
    QVERIFY(ofKind(events, EventKind::Replan).empty());
    QVERIFY(positionOf(world->frame(), 0).x() > 14.0);
  }

  void walk_blockedWhileTheTargetMoves_isStuck() {
    Scenario scenario = withShape("corridor");
    scenario.desktop.model.emplace("sfm-hunav2");  // others wait before robots
    scenario.humans[0].goals.clear();
    Robot& robot = addRobot(scenario, Vec2(3.0, 0.0), Vec2::Zero());
    robot.goal.point.reset();
    robot.radius = 0.6;
    robot.mass = 1e6;
    const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
      intents.of(0).motion = Motion::Walk;
      intents.of(0).speed = 1.0;
      intents.of(0).target.position = Vec2(5.0 + 0.2 * view.time(), 0.0);
    });
    QVERIFY(!ofKind(advance(*world, 240), EventKind::Stuck).empty());
  }

  void create_startInAWall_isMovedAndBothPointsAreNamed() {
    Scenario scenario = withShape("open");
    addWall(scenario, {Vec2(0.0, -3.0), Vec2(0.0, 3.0)}, 0.3);
    base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QCOMPARE(world.diagnostics().size(), std::size_t{1});
    const Vec2 start = positionOf((*world)->frame(), 0);
    QVERIFY(std::fabs(start.x()) >= 0.5 && start.norm() <= 1.0);
    QVERIFY(world.diagnostics()[0].message.find("(0, 0)") != std::string::npos);
    QVERIFY(world.diagnostics()[0].message.find("is used") != std::string::npos);
  }

  void create_goalInAWall_isMoved() {
    Scenario scenario = withShape("open");
    addWall(scenario, {Vec2(8.0, -3.0), Vec2(8.0, 3.0)}, 0.3);
    base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QVERIFY((*world)->header().humans[0].goals[0].position != Vec2(8.0, 0.0));
    QCOMPARE(ofKind(advance(**world, 200), EventKind::Goal).size(), std::size_t{1});
  }

  void door_opens_letsThePersonThrough() {
    Scenario scenario = withShape("open");
    addWall(scenario, {Vec2(4.0, -6.0), Vec2(4.0, -0.7)});
    addWall(scenario, {Vec2(4.0, 0.7), Vec2(4.0, 6.0)});
    addWall(scenario, {Vec2(4.0, 6.0), Vec2(-3.0, 6.0), Vec2(-3.0, -6.0), Vec2(4.0, -6.0)});
    addDoor(scenario, Vec2(4.0, -0.75), Vec2(4.0, 0.75), false, {5.0});
    scenario.humans[0].goals.clear();
    const auto world = make(scenario, [](const WorldView&, Intents& intents) {
      intents.of(0).motion = Motion::Walk;
      intents.of(0).speed = 1.2;
      intents.of(0).target.position = Vec2(8.0, 0.0);
    });
    double mostBefore = -10.0;
    advance(*world, 400, [&](const Frame& frame) {
      if (frame.time <= 5.0) {
        mostBefore = std::max(mostBefore, frame.humans.x[0]);
      }
    });
    QVERIFY(mostBefore < 3.6);
    QVERIFY((positionOf(world->frame(), 0) - Vec2(8.0, 0.0)).norm() < 0.8);
  }

  void door_closes_makesThemPlanAnew() {
    Scenario scenario = withShape("open");
    addWall(scenario, {Vec2(4.0, -6.0), Vec2(4.0, -0.7)});
    addWall(scenario, {Vec2(4.0, 0.7), Vec2(4.0, 3.0)});  // a way round at the upper end
    addDoor(scenario, Vec2(4.0, -0.75), Vec2(4.0, 0.75), true, {1.0});
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 400);
    QCOMPARE(ofKind(events, EventKind::Goal).size(), std::size_t{1});
    QVERIFY(ofKind(events, EventKind::Replan).size() >= 1);
    QVERIFY(ofKind(events, EventKind::Goal)[0].step > 160);
  }

  /// As when the map is edited beside a run, which takes a door and people of new radii afterwards.
  void step_workOnTheMapIsStopped_isTheSameRun() {
    std::vector<std::string> events;
    for (const bool isStopped : {false, true}) {
      Scenario scenario = withShape("gap");
      addDoor(scenario, Vec2(4.0, 1.0), Vec2(4.0, 2.1), false, {1.0});
      const auto stop = std::make_shared<base::StopFlag>();
      WorldSetup setup = setupOf(scenario);
      setup.surroundings =
          std::make_shared<const Surroundings>(makeSurroundings(scenario, OccupancyGrid(), stop));
      auto world = make(std::move(setup));
      if (isStopped) {
        stop->stop();
      }
      std::string told;
      for (const Recorded& event : advance(*world, 200)) {
        told += std::to_string(event.step) + " ";
      }
      events.push_back(told);
    }
    QVERIFY(!events[0].empty());
    QVERIFY(events[0] == events[1]);
  }

  void door_toggles_areEventsAtTheirTimes() {
    Scenario scenario = withShape("open");
    addDoor(scenario, Vec2(14.0, -0.75), Vec2(14.0, 0.75), false, {2.0, 1.0});
    const auto world = make(scenario);
    QCOMPARE(int{world->frame().doorOpen[0]}, 0);
    const std::vector<Recorded> doors = ofKind(advance(*world, 50), EventKind::Door);
    QCOMPARE(doors.size(), std::size_t{2});
    QCOMPARE(doors[0].step, std::int64_t{20});
    QVERIFY(doors[0].event.text == "door1 open" && !doors[0].event.hasId);
    QCOMPARE(doors[1].step, std::int64_t{40});
    QVERIFY(doors[1].event.text == "door1 closed");
  }

  void view_nearAndVisible_answerFromTheFrozenState() {
    Scenario scenario;
    addPerson(scenario, 3, Vec2(0.0, 0.0));
    addPerson(scenario, 9, Vec2(2.0, 0.0));
    addPerson(scenario, 5, Vec2(0.0, 1.0));
    addPerson(scenario, 7, Vec2(0.0, -1.0));
    addPerson(scenario, 8, Vec2(30.0, 0.0));
    const auto world = make(scenario);
    const WorldView& view = world->view();
    QCOMPARE(view.indexOf(5), 1);
    QCOMPARE(view.indexOf(4), -1);
    std::vector<int> found;
    view.near(0, 5.0, found);
    QVERIFY(found == (std::vector<int>{1, 2, 4}));  // 5 and 7 at one distance: by id
    QVERIFY(view.isVisible(Vec2(0.0, 0.0), Vec2(2.0, 0.0)));
    QVERIFY(view.constants(4).name == "person9");
    QCOMPARE(view.nearestRobot(0), -1);
  }

  void view_quirk34_seesThroughWalls() {
    Scenario scenario = withShape("pocket");
    WorldSetup setup = setupOf(scenario);
    setup.compatibility = *Compatibility::parse("Q-34");
    auto world = make(std::move(setup));
    QVERIFY(world->view().isVisible(Vec2(0.0, 0.0), Vec2(8.0, 0.0)));
  }
};

QTEST_APPLESS_MAIN(WorldPathsTest)
#include "tst_WorldPaths.moc"
