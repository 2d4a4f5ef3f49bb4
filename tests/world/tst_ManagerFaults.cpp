#include <cmath>
#include <limits>

#include <QtTest>

#include "sim2d/trace/Recording.h"
#include "sim2d/world/Runner.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Scenario walk() {
  Scenario scenario;
  addGoal(scenario, 1, 10.0, 0.0);
  addPerson(scenario, 1, Vec2::Zero(), {1});
  return scenario;
}

}  // namespace

/// Faults of the original's manager of people, by number, one test each: the order of people, what
/// a reset forgets, robots, the states that are told. d01 and d10 are faults of the forces as well
/// (tst_KnownFaults), d06 is about files (tst_HumanTreeBehavior); d09, reading without a lock,
/// cannot occur: people decide on a frozen state.
class ManagerFaultsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void d02_stepOfTenSeconds_isRefused() {
    for (const double dt : {10.0, std::numeric_limits<double>::infinity()}) {
      Scenario scenario = walk();
      scenario.desktop.dt = dt;
      QVERIFY(!create(scenario));
    }
  }

  void d03_robotAsAnObstacle_isOneInEveryStep() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2::Zero());
    Robot robot;
    robot.name = "robot1";
    robot.start.position = Vec2(1.35, 0.0);
    scenario.robots.push_back(robot);
    const auto world = make(scenario, [](const WorldView&, Intents& intents) {
      intents.of(0).robot = RobotTreatment::Obstacle;
    });
    advance(*world, 20, [](const Frame& frame) {
      QVERIFY(frame.forces.social[0].isZero(0.0));
      QVERIFY(frame.forces.obstacle[0].x() < 0.0);
    });
  }

  void d04_unknownId_isNobody() {
    int found = 0;
    std::size_t people = 0;
    const auto world = make(walk(), [&](const WorldView& view, Intents& /*intents*/) {
      found = view.indexOf(99);
      people = static_cast<std::size_t>(view.humanCount());
    });
    advance(*world, 2);
    QCOMPARE(found, -1);
    QCOMPARE(people, std::size_t{1});
    QCOMPARE(world->frame().humans.size(), std::size_t{1});
  }

  void d05_secondRun_knowsNothingOfTheFirst() {
    Scenario scenario = walk();
    addGoal(scenario, 2, -3.0, 2.0);
    scenario.humans[0].goals = {1, 2};
    scenario.humans[0].cyclicGoals = true;
    addPerson(scenario, 2, Vec2(4.0, 0.5), {2, 1}, 1.0).cyclicGoals = true;
    addDoor(scenario, Vec2(6.0, -1.0), Vec2(6.0, 1.0), false, {2.0, 5.0});
    addRobot(scenario, Vec2(2.0, -3.0), Vec2(9.0, 3.0));
    const std::shared_ptr<const Scenario> shared = std::make_shared<const Scenario>(scenario);
    std::vector<Frame> begins;
    std::vector<Trace> traces;
    for (int i = 0; i < 2; ++i) {
      WorldSetup setup;
      setup.scenario = shared;
      setup.behavior = std::make_unique<ScriptedBehavior>();
      base::Result<std::unique_ptr<World>> world = World::create(std::move(setup));
      QVERIFY(world);
      begins.push_back((*world)->frame());
      Recording recording;
      run(**world, {400, false}, recording);
      traces.push_back(recording.trace((*world)->header()));
    }
    QCOMPARE(begins[0].humans.x, (std::vector<double>{0.0, 4.0}));
    QVERIFY(begins[1].humans.x == begins[0].humans.x);
    QVERIFY(begins[1].humans.heading == begins[0].humans.heading);
    QVERIFY(traces[0].events.size() > 4);
    QCOMPARE(traces[1].events.size(), traces[0].events.size());
    QCOMPARE(traces[1].frames.back().humans.x, traces[0].frames.back().humans.x);
    QCOMPARE(traces[1].frames.back().robots.y, traces[0].frames.back().robots.y);
  }

  void d07_record_tellsAllOfAPerson() {
    Scenario scenario = walk();
    Human& human = scenario.humans[0];
    human.radius = 0.31;
    human.maxVel = 1.17;
    human.groupId = 3;
    human.goalRadius = 0.45;
    human.cyclicGoals = true;
    const auto world = make(scenario);
    const TraceHuman told = world->header().humans.at(0);
    QCOMPARE(told.radius, 0.31);
    QCOMPARE(told.desiredSpeed, 1.17);
    QCOMPARE(told.group, 3);
    QVERIFY(told.cyclicGoals);
    QCOMPARE(told.goals.size(), std::size_t{1});
    QCOMPARE(told.goals[0].radius, 0.45);
    QCOMPARE(told.goals[0].position.x(), 10.0);
    addWall(scenario,
            {Vec2(-1.0, 1.0), Vec2(1.0, 1.0)});  // and the nearest obstacle, in each frame
    const auto walled = make(scenario);
    advance(*walled, 1);
    QVERIFY(walled->frame().forces.obstacle[0].y() < 0.0);
    QCOMPARE(QString::fromStdString(walled->header().obstacles.back().name),
             QStringLiteral("wall1"));
  }

  void d08_frame_isTheStateAfterTheStep() {
    const auto world = make(walk());
    advance(*world, 1);
    QCOMPARE(world->frame().time, 0.05);
    // From rest, forces act for half of the first step: v = 4 * 1.5 * 0.025.
    QVERIFY(std::fabs(world->frame().humans.vx[0] - 0.15) < 1e-12);
    QVERIFY(std::fabs(world->frame().humans.x[0] - 0.0075) < 1e-12);
  }

  void d11_withoutRobot_peopleLiveFromTheFirstStep() {
    int decided = 0;
    const auto world = make(walk(), [&](const WorldView& view, Intents& /*intents*/) {
      decided += view.robotCount() == 0 && view.nearestRobot(0) == -1 ? 1 : 0;
    });
    advance(*world, 1);
    QCOMPARE(decided, 1);
    QVERIFY(world->frame().humans.vx[0] > 0.0);
  }

  void d12_robotAndPersonZero_feelEachOther() {
    Scenario scenario;
    addPerson(scenario, 0, Vec2::Zero());
    addRobot(scenario, Vec2(1.5, 0.0), Vec2(9.0, 0.0));
    const auto world = make(scenario);
    advance(*world, 1);
    QVERIFY(world->frame().forces.social[0].x() < 0.0);
    QVERIFY(world->header().robots[0].id < 0);
  }
};

QTEST_APPLESS_MAIN(ManagerFaultsTest)
#include "tst_ManagerFaults.moc"
