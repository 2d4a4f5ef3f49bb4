#include <algorithm>
#include <cmath>

#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

class WorldRobotTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void drive_openPlane_arrivesWithinItsLimits() {
    Scenario scenario;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(6.0, 3.0));
    const auto world = make(scenario);
    double before = 0.0;
    double omegaBefore = 0.0;
    const std::vector<Recorded> events = advance(*world, 300, [&](const Frame& frame) {
      const double speed = Vec2(frame.robots.vx[0], frame.robots.vy[0]).norm();
      QVERIFY(speed <= 1.0 + 1e-9);
      QVERIFY(std::fabs(speed - before) <= 1.0 * 0.05 + 1e-9);
      QVERIFY(std::fabs(frame.robots.omega[0]) <= 1.5 + 1e-9);
      QVERIFY(std::fabs(frame.robots.omega[0] - omegaBefore) <= 3.0 * 0.05 + 1e-9);
      before = speed;
      omegaBefore = frame.robots.omega[0];
    });
    const std::vector<Recorded> arrived = ofKind(events, EventKind::Arrived);
    QCOMPARE(arrived.size(), std::size_t{1});
    QCOMPARE(arrived[0].event.id, -1);
    QVERIFY(arrived[0].step < 200);
    QVERIFY(world->arrivedAt() &&
            std::fabs(*world->arrivedAt() - 0.05 * double(arrived[0].step)) < 1e-9);
    QVERIFY((robotPosition(world->frame()) - Vec2(6.0, 3.0)).norm() <= 0.3);
    QCOMPARE(before, 0.0);
  }

  void drive_roundAWall_arrives() {
    Scenario scenario;
    addWall(scenario, {Vec2(2.0, 3.0), Vec2(4.0, 3.0), Vec2(4.0, -3.0), Vec2(2.0, -3.0)});
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 600);
    QVERIFY(world->arrivedAt().has_value());
    QVERIFY(ofKind(events, EventKind::Contact).empty());
  }

  void drive_severalGoals_areReachedInOrder() {
    Scenario scenario;
    addGoal(scenario, 3, 3.0, 0.0);
    addGoal(scenario, 1, 3.0, 3.0);
    Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2::Zero());
    robot.goal.point.reset();
    robot.goal.goals = {3, 1};
    const auto world = make(scenario);
    QCOMPARE(world->frame().robots.goal[0], 3);
    const std::vector<Recorded> reached = ofKind(advance(*world, 400), EventKind::Goal);
    QCOMPARE(reached.size(), std::size_t{2});
    QVERIFY(reached[0].event.text == "3" && reached[1].event.text == "1");
  }

  void drive_goalBehind_turnsFirst() {
    Scenario scenario;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(-4.0, 0.0));
    const auto world = make(scenario);
    double mostX = 0.0;
    advance(*world, 300, [&](const Frame& frame) { mostX = std::max(mostX, frame.robots.x[0]); });
    QVERIFY(mostX < 0.3);
    QVERIFY(world->arrivedAt().has_value());
  }

  void drive_startTime_setsOffThen() {
    Scenario scenario;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(4.0, 0.0)).startTime = 2.0;
    const auto world = make(scenario);
    advance(*world, 40);
    QVERIFY(robotPosition(world->frame()) == Vec2::Zero());
    advance(*world, 1);
    QVERIFY(robotPosition(world->frame()).x() > 0.0);
  }

  void drive_personStandsAhead_stopsBeforeThem() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(5.0, 0.0));
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
    const auto world = make(
        scenario, [](const WorldView&, Intents& intents) { intents.of(0).motion = Motion::Stand; });
    const std::vector<Recorded> events = advance(*world, 400);
    const double gap = 5.0 - 0.4 - 0.35 - world->frame().robots.x[0];
    QVERIFY(gap > 0.45 && gap < 0.6);
    QVERIFY(std::fabs(world->frame().robots.vx[0]) < 0.02);
    QVERIFY(ofKind(events, EventKind::Contact).empty());
  }

  void drive_personBehindAWall_doesNotMatter() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(4.0, 1.0));
    addWall(scenario, {Vec2(-1.0, 0.5), Vec2(9.0, 0.5)}, 0.1);
    addRobot(scenario, Vec2(0.0, -0.2), Vec2(8.0, -0.2));
    const auto world = make(
        scenario, [](const WorldView&, Intents& intents) { intents.of(0).motion = Motion::Stand; });
    advance(*world, 220);
    QVERIFY(world->arrivedAt().has_value());
  }

  void drive_doorCloses_plansAnew() {
    Scenario scenario;
    addWall(scenario, {Vec2(4.0, -6.0), Vec2(4.0, -0.7)});
    addWall(scenario, {Vec2(4.0, 0.7), Vec2(4.0, 3.0)});
    addDoor(scenario, Vec2(4.0, -0.75), Vec2(4.0, 0.75), true, {1.0});
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 600);
    QVERIFY(world->arrivedAt().has_value());
    QCOMPARE(ofKind(events, EventKind::Replan).size(), std::size_t{1});
  }

  void stand_withoutGoal_neverArrives() {
    Scenario scenario;
    addRobot(scenario, Vec2(1.0, 1.0), Vec2::Zero()).goal.point.reset();
    const auto world = make(scenario);
    advance(*world, 50);
    QVERIFY(!world->arrivedAt().has_value());
    QVERIFY(robotPosition(world->frame()) == Vec2(1.0, 1.0));
  }

  void stand_pushedByPeople_holdsItsPlace() {
    Scenario scenario;
    scenario.desktop.model.emplace("sfm-hunav2");
    addGoal(scenario, 1, 3.0, 0.0);
    addPerson(scenario, 1, Vec2(-2.0, 0.0), {1}).ours.route = Route::Direct;
    addPerson(scenario, 2, Vec2(-3.0, 0.0), {1}).ours.route = Route::Direct;
    Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2::Zero());
    robot.goal.point.reset();
    const auto world = make(scenario);
    advance(*world, 200, [&](const Frame& frame) {
      QVERIFY(robotPosition(frame).norm() < 0.02);
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        const Vec2 person(frame.humans.x[i], frame.humans.y[i]);
        QVERIFY((person - robotPosition(frame)).norm() > 0.35 + 0.35 - 0.05);
      }
    });
  }

  void drive_pushedFromBehind_keepsToItsSpeed() {
    Scenario scenario;
    scenario.desktop.model.emplace("sfm-hunav2");  // who walks by another does not push
    addGoal(scenario, 1, 20.0, 0.0);
    addPerson(scenario, 1, Vec2(-1.0, 0.0), {1}).ours.route = Route::Direct;
    addPerson(scenario, 2, Vec2(-2.0, 0.0), {1}).ours.route = Route::Direct;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(20.0, 0.0)).maxVel = 0.4;
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 200);  // 10 s: 3.9 m alone
    QVERIFY(!ofKind(events, EventKind::Contact).empty());
    const double driven = world->frame().robots.x[0];
    const double pushed = 10.0 * ResolvedHuman().desiredSpeed;
    QVERIFY2(driven > 3.4 && driven < pushed, qPrintable(QString::number(driven)));
  }

  void create_startOnAPerson_isMovedAside() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(0.0, 0.0));
    addRobot(scenario, Vec2(0.2, 0.0), Vec2(5.0, 0.0));
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QCOMPARE(world.diagnostics().size(), std::size_t{1});
    QVERIFY(world.diagnostics()[0].message.find("(0.2, 0)") != std::string::npos);
    const Frame& frame = (*world)->frame();
    QVERIFY((robotPosition(frame) - positionOf(frame, 0)).norm() >= 0.35 + 0.35 - 0.011);
    QVERIFY((robotPosition(frame) - Vec2(0.2, 0.0)).norm() <= 1.0);
  }

  void create_unreachableGoal_isLeftOut() {
    Scenario scenario;
    addRoom(scenario, Vec2(6.0, -2.0), Vec2(10.0, 2.0));
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(8.0, 0.0));
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QCOMPARE(world.diagnostics().size(), std::size_t{1});
  }

  void twoRobots_idsFollowTheOrder() {
    Scenario scenario;
    addRobot(scenario, Vec2(0.0, 0.0), Vec2(4.0, 0.0));
    addRobot(scenario, Vec2(0.0, 2.0), Vec2(4.0, 2.0));
    const auto world = make(scenario);
    QVERIFY(world->frame().robots.id == (std::vector<int>{-1, -2}));
    advance(*world, 200);
    QVERIFY(world->arrivedAt().has_value());
    QCOMPARE(world->frame().robotPaths.size(), std::size_t{2});
  }
};

QTEST_APPLESS_MAIN(WorldRobotTest)
#include "tst_WorldRobot.moc"
