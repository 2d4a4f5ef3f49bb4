#include <algorithm>
#include <cmath>

#include <QtTest>

#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Scenario walk(double distance = 10.0) {
  Scenario scenario;
  addGoal(scenario, 1, distance, 0.0);
  addPerson(scenario, 1, Vec2::Zero(), {1});
  return scenario;
}

}  // namespace

class WorldTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_asTheOriginal_hasItsReferenceValues() {
    Scenario scenario = walk();
    scenario.desktop.model = "sfm-hunav2";
    const auto world = make(scenario);
    advance(*world, 1);
    QCOMPARE(world->frame().humans.x[0], 0.015);
    QCOMPARE(world->frame().humans.vx[0], 0.3);
    QCOMPARE(world->frame().humans.y[0], 0.0);
    QCOMPARE(world->frame().humans.heading[0], 0.0);
    QCOMPARE(world->frame().humans.omega[0], 0.0);
    advance(*world, 19);
    QCOMPARE(world->time(), 1.0);
    QVERIFY(std::fabs(world->frame().humans.x[0] - 1.203459) < 1e-6);
    QVERIFY(std::fabs(world->frame().humans.vx[0] - 1.482706) < 1e-6);
    const std::vector<Recorded> events = advance(*world, 180);
    const std::vector<Recorded> reached = ofKind(events, EventKind::Goal);
    QCOMPARE(reached.size(), std::size_t{1});
    QCOMPARE(reached[0].step, std::int64_t{134});  // 6.70 s
    QVERIFY(reached[0].event.text == "1");
    QCOMPARE(ofKind(events, EventKind::Arrived).size(), std::size_t{1});
  }

  void step_walkToGoal_followsTheClosedForm_data() {
    addColumns<QString, double>({"model", "dt"});
    for (const char* model : {"sfm", "das"}) {
      for (const double dt : {0.1, 0.05, 0.02, 0.01}) {
        QTest::addRow("%s, %g s", model, dt) << QString::fromUtf8(model) << dt;
      }
    }
  }

  /// x = v0 (t - 1/k) once the start is over, k = k_g / tau = 4 per s, whatever the step of time.
  void step_walkToGoal_followsTheClosedForm() {
    QFETCH(QString, model);
    QFETCH(double, dt);
    Scenario scenario = walk();
    scenario.desktop.model = model.toStdString();
    scenario.desktop.dt = dt;
    const auto world = make(scenario);
    advance(*world, static_cast<int>(std::lround(5.0 / dt)));
    const double off = world->frame().humans.x[0] - 1.5 * (5.0 - 0.25);
    QVERIFY2(std::fabs(off) <= 0.05, qPrintable(QString::number(off)));
    QVERIFY(std::fabs(off) <= 1.5 * dt / 2.0 + 1e-9);
    QVERIFY(std::fabs(world->frame().humans.vx[0] - 1.5) < 1e-6);
  }

  /// From the speed v0 somebody without a goal needs v0 tau = 0.75 m.
  void step_goalAway_brakesOverTheSameLength() {
    for (const double dt : {0.1, 0.05, 0.02}) {
      Scenario scenario = walk(50.0);
      scenario.desktop.dt = dt;
      const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
        intents.of(0).motion = view.time() > 4.0 ? Motion::Brake : Motion::Walk;
      });
      double before = 0.0;
      advance(*world, static_cast<int>(std::lround(10.0 / dt)), [&](const Frame& frame) {
        before = frame.time < 4.0 + 1.5 * dt ? frame.humans.x[0] : before;
      });
      const double length = world->frame().humans.x[0] - before;
      QVERIFY2(std::fabs(length - 0.75) <= 0.05, qPrintable(QString::number(length)));
      QCOMPARE(speedOf(world->frame(), 0), 0.0);
    }
  }

  void step_noGoal_brakesExponentiallyAndStands() {
    const auto world = make(walk());
    advance(*world, 136);  // the last of them brakes for the first time
    double speed = speedOf(world->frame(), 0);
    for (int i = 0; i < 60; ++i) {
      QVERIFY(world->step());
      const double expected = speed * (1.0 - 2.0 * 0.05);
      speed = speedOf(world->frame(), 0);
      QVERIFY(std::fabs(speed - expected) < 1e-9);
    }
    advance(*world, 60);
    QCOMPARE(speedOf(world->frame(), 0), 0.0);
  }

  void step_standAndTurn_keepTheirPlace() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(1.1, 2.3));
    const auto world = make(scenario, [](const WorldView&, Intents& intents) {
      intents.of(0).motion = Motion::Turn;
      intents.of(0).heading = -2.0;
      intents.of(0).turnRate = 1.0;
    });
    advance(*world, 10);
    QVERIFY(std::fabs(world->frame().humans.heading[0] + 0.5) < 1e-12);
    QVERIFY(std::fabs(world->frame().humans.omega[0] + 1.0) < 1e-9);
    advance(*world, 50);
    QVERIFY(std::fabs(world->frame().humans.heading[0] + 2.0) < 1e-12);
    QCOMPARE(world->frame().humans.omega[0], 0.0);
    QVERIFY(positionOf(world->frame(), 0) == Vec2(1.1, 2.3));
  }

  void step_turnedAway_headingIsLimited() {
    Scenario scenario = walk();
    scenario.humans[0].initPose.heading = base::kPi / 2.0;
    const auto world = make(scenario);
    double before = base::kPi / 2.0;
    advance(*world, 30, [&](const Frame& frame) {
      const double turn = base::angleDiff(frame.humans.heading[0], before);
      QVERIFY(std::fabs(turn) <= base::kPi * 0.05 + 1e-12);
      QVERIFY(std::fabs(frame.humans.omega[0] - turn / 0.05) < 1e-9);
      before = frame.humans.heading[0];
    });
    QCOMPARE(before, 0.0);
  }

  void frame_forces_sumIsWhatMovesThePerson() {
    Scenario scenario = walk();
    addGoal(scenario, 2, -10.0, 1.0);
    addPerson(scenario, 2, Vec2(6.0, 0.8), {2});
    addPerson(scenario, 5, Vec2(2.0, -2.0));
    const auto world = make(scenario);
    QVERIFY(world->frame().forces.goal.empty());
    Vec2 before = Vec2::Zero();
    advance(*world, 100, [&](const Frame& frame) {
      const Vec2 velocity(frame.humans.vx[0], frame.humans.vy[0]);
      const double time = frame.step == 1 ? 0.025 : 0.05;  // velocities are of the middle of steps
      Vec2 expected = before + time * (frame.forces.goal[0] + frame.forces.social[0] +
                                       frame.forces.obstacle[0] + frame.forces.group[0]);
      if (expected.norm() > 1.5) {
        expected *= 1.5 / expected.norm();
      }
      const bool isInContact = (positionOf(frame, 0) - positionOf(frame, 1)).norm() < 0.9;
      QVERIFY(isInContact || (velocity - expected).norm() < 1e-9);
      before = velocity;
    });
  }

  void frame_columns_areTheStateOfThePeople() {
    Scenario scenario = walk();
    addPerson(scenario, 7, Vec2(3.0, 3.0)).groupId = 4;
    addPerson(scenario, 4, Vec2(-3.0, 3.0));
    const auto world =
        make(scenario, [](const WorldView&, Intents& intents) { intents.of(1).active = true; });
    const Frame& frame = world->frame();
    QVERIFY(frame.humans.id == (std::vector<int>{1, 4, 7}));
    QVERIFY(frame.humans.group == (std::vector<int>{-1, -1, 4}));
    QVERIFY(frame.humans.goal == (std::vector<int>{1, kNoGoal, kNoGoal}));
    QCOMPARE(frame.events.size(), std::size_t{3});  // all enter
    advance(*world, 1);
    QVERIFY(world->frame().humans.state == (std::vector<std::uint8_t>{0, 1, 0}));
  }

  void goals_oneWayList_areVisitedInOrder() {
    Scenario scenario = walk(2.0);
    addGoal(scenario, 2, 2.0, 3.0);
    addGoal(scenario, 3, 0.0, 3.0);
    scenario.humans[0].goals = {1, 2, 3};
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 300);
    const std::vector<Recorded> reached = ofKind(events, EventKind::Goal);
    QCOMPARE(reached.size(), std::size_t{3});
    QVERIFY(reached[0].event.text == "1" && reached[1].event.text == "2" &&
            reached[2].event.text == "3");
    QCOMPARE(ofKind(events, EventKind::Arrived).size(), std::size_t{1});
    QCOMPARE(world->frame().humans.goal[0], kNoGoal);
  }

  void goals_cyclicList_comesRound() {
    Scenario scenario = walk(2.0);
    addGoal(scenario, 2, 0.0, 0.0);
    scenario.humans[0].goals = {1, 2};
    scenario.humans[0].cyclicGoals = true;
    const auto world = make(scenario);
    const std::vector<Recorded> reached = ofKind(advance(*world, 400), EventKind::Goal);
    QVERIFY(reached.size() > 5);
    for (std::size_t i = 0; i < reached.size(); ++i) {
      QVERIFY(reached[i].event.text == (i % 2 == 0 ? "1" : "2"));
    }
  }

  void goals_cyclicListOfOne_isReachedOnce() {
    Scenario scenario = walk(2.0);
    scenario.humans[0].cyclicGoals = true;
    const auto world = make(scenario);
    QCOMPARE(ofKind(advance(*world, 200), EventKind::Goal).size(), std::size_t{1});
  }

  void goals_takenOffByTheBehavior_countForWaits() {
    Scenario scenario = walk(2.0);
    addGoal(scenario, 2, 4.0, 0.0);
    scenario.humans[0].goals = {1, 2};
    scenario.humans[0].ours.wait = {3.0, 0.0};
    bool isTaken = false;
    const auto world = make(scenario, [&](const WorldView& view, Intents& intents) {
      std::vector<GoalItem>& goals = intents.control(0).goals;
      if (!isTaken && (goals.front().position - view.pose(0).position).norm() < 0.4) {
        goals.erase(goals.begin());
        Event event;
        event.kind = EventKind::Goal;
        event.id = 1;
        event.text = "1";
        intents.emit(event);
        isTaken = true;
      }
    });
    const std::vector<Recorded> reached = ofKind(advance(*world, 200), EventKind::Goal);
    QCOMPARE(reached.size(), std::size_t{2});
    QVERIFY(reached[1].step - reached[0].step > 60 + 20);
  }

  void wait_atAGoal_standsSoLong() {
    Scenario scenario = walk(2.0);
    addGoal(scenario, 2, 4.0, 0.0);
    scenario.humans[0].goals = {1, 2};
    scenario.humans[0].ours.wait = {2.0, 0.0};
    const auto world = make(scenario);
    std::int64_t reached = 0;
    std::int64_t firstMove = 0;
    advance(*world, 200, [&](const Frame& frame) {
      for (const Event& event : frame.events) {
        reached = event.kind == EventKind::Goal && event.text == "1" ? frame.step : reached;
      }
      if (reached > 0 && frame.step > reached && firstMove == 0 && speedOf(frame, 0) > 0.0) {
        firstMove = frame.step;
      }
    });
    QCOMPARE(firstMove - reached, std::int64_t{41});  // 40 steps of rest
  }

  void startTime_later_entersThen() {
    Scenario scenario = walk();
    addPerson(scenario, 2, Vec2(0.0, 3.0), {1}).ours.startTime = 1.0;
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 40, [](const Frame& frame) {
      QCOMPARE(frame.humans.size(), std::size_t{frame.step < 20 ? 1U : 2U});
      if (frame.step == 20) {
        QVERIFY(positionOf(frame, 1) == Vec2(0.0, 3.0));
      }
    });
    const std::vector<Recorded> entered = ofKind(events, EventKind::Enter);
    QCOMPARE(entered.size(), std::size_t{1});
    QCOMPARE(entered[0].step, std::int64_t{20});
    QCOMPARE(entered[0].event.id, 2);
  }

  void atEnd_leave_isGone() {
    Scenario scenario = walk(2.0);
    scenario.humans[0].ours.atEnd = AtEnd::Leave;
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 100);
    QCOMPARE(ofKind(events, EventKind::Leave).size(), std::size_t{1});
    QCOMPARE(ofKind(events, EventKind::Leave)[0].step, ofKind(events, EventKind::Arrived)[0].step);
    QCOMPARE(world->frame().humans.size(), std::size_t{0});
  }

  void atEnd_restart_comesAgainWithFreshGoals() {
    Scenario scenario = walk(2.0);
    scenario.humans[0].ours.atEnd = AtEnd::Restart;
    const auto world = make(scenario);
    const std::vector<Recorded> events = advance(*world, 200);
    const std::size_t rounds = ofKind(events, EventKind::Arrived).size();
    QVERIFY(rounds >= 3);
    QCOMPARE(ofKind(events, EventKind::Enter).size(), rounds);
    const auto& behavior = static_cast<const ScriptedBehavior&>(world->behavior());
    QCOMPARE(behavior.entered.size(), rounds + 1);
  }

  void sink_lastGoalInside_leaves() {
    Scenario scenario = walk(2.0);
    Area area;
    area.name = "gate";
    area.kind = AreaKind::Sink;
    area.points = {Vec2(1.0, -1.0), Vec2(3.0, -1.0), Vec2(3.0, 1.0), Vec2(1.0, 1.0)};
    scenario.areas.push_back(area);
    const auto world = make(scenario);
    QCOMPARE(ofKind(advance(*world, 100), EventKind::Leave).size(), std::size_t{1});
  }

  void source_arrivals_followTheirRateAndCount() {
    Scenario scenario = walk(40.0);
    Area area;
    area.name = "entry";
    area.kind = AreaKind::Source;
    area.points = {Vec2(-4.0, -4.0), Vec2(-2.0, -4.0), Vec2(-2.0, 4.0), Vec2(-4.0, 4.0)};
    area.like = "person1";
    area.rate = 0.5;
    area.count = 12;
    scenario.areas.push_back(area);
    const auto world = make(scenario);
    const std::vector<Recorded> entered = ofKind(advance(*world, 1200), EventKind::Enter);
    QCOMPARE(entered.size(), std::size_t{12});
    QVERIFY(entered.back().step > 200 && entered.back().step < 1000);  // 24 s on average
    for (std::size_t i = 0; i < entered.size(); ++i) {
      QCOMPARE(entered[i].event.id, static_cast<int>(i) + 2);
    }
    const TraceHeader header = world->header();
    QCOMPARE(header.humans.size(), std::size_t{13});
    QVERIFY(header.humans[1].name == "entry_1");
    QVERIFY(header.humans[12].goals.size() == 1);
  }

  void frozen_person_standsStill() {
    const auto world = make(walk(), [](const WorldView& view, Intents& intents) {
      intents.control(0).frozen = view.step() > 20 && view.step() <= 40;
    });
    advance(*world, 20);
    const Vec2 place = positionOf(world->frame(), 0);
    advance(*world, 20);
    QVERIFY(positionOf(world->frame(), 0) == place);
    advance(*world, 20);
    QVERIFY(positionOf(world->frame(), 0).x() > place.x() + 0.5);
  }

  void extraForce_ofABehavior_isAmongTheForces() {
    const auto world = make(walk(), [](const WorldView&, Intents& intents) {
      intents.of(0).extraForce = Vec2(0.0, 2.0);
    });
    advance(*world, 1);
    QVERIFY(world->frame().forces.social[0] == Vec2(0.0, 2.0));
    QVERIFY(std::fabs(world->frame().humans.vy[0] - 0.05) < 1e-12);  // in half a step
  }

  void diverged_velocity_stopsTheRunAndNamesThePerson() {
    const auto world = make(walk(), [](const WorldView& view, Intents& intents) {
      intents.of(0).speed = view.step() > 5 ? 1e6 : 1.0;
    });
    advance(*world, 100);
    QCOMPARE(world->stepIndex(), std::int64_t{5});
    QCOMPARE(world->frame().step, std::int64_t{5});
    QVERIFY(world->failure().find("person1") != std::string::npos);
    QVERIFY(!world->step());
  }

  void create_impossibleScenarios_areErrors_data() {
    addColumns<int, QString>({"fault", "word"});
    QTest::newRow("dt") << 0 << "dt";
    QTest::newRow("model") << 1 << "did you mean 'sfm'";
    QTest::newRow("id twice") << 2 << "is also used by";
    QTest::newRow("negative id") << 3 << "id must be";
    QTest::newRow("not finite") << 4 << "not finite";
    QTest::newRow("planner") << 5 << "did you mean 'pursuit'";
    QTest::newRow("planner parameter") << 6 << "no parameter 'lookahaed'";
    QTest::newRow("robot type") << 7 << "unknown type";
    QTest::newRow("start in a wall") << 8 << "no free space";
    QTest::newRow("goal unknown") << 9 << "global_goals";
    QTest::newRow("dt of zero") << 10 << "dt";
    QTest::newRow("dt of ten seconds") << 11 << "dt";
  }

  void create_impossibleScenarios_areErrors() {
    QFETCH(int, fault);
    QFETCH(QString, word);
    Scenario scenario = walk();
    Robot& robot = addRobot(scenario, Vec2(0.0, 5.0), Vec2(5.0, 5.0));
    if (fault == 0) {
      scenario.desktop.dt = 0.2;
    } else if (fault == 1) {
      scenario.humans[0].ours.model = "sfn";
    } else if (fault == 2) {
      addPerson(scenario, 1, Vec2(0.0, 2.0)).name = "twin";
    } else if (fault == 3) {
      scenario.humans[0].id = -3;
    } else if (fault == 4) {
      scenario.humans[0].initPose.position.x() = std::nan("");
    } else if (fault == 5) {
      robot.planner = "persuit";
    } else if (fault == 6) {
      robot.plannerParameters = {{"lookahaed", "0.5"}};
    } else if (fault == 7) {
      robot.type = "tank";
    } else if (fault == 8) {
      addWall(scenario, {Vec2(-6.0, 0.0), Vec2(6.0, 0.0)}, 6.0);
    } else if (fault == 9) {
      scenario.humans[0].goals = {8};
    } else if (fault == 10) {
      scenario.desktop.dt = 0.0;
    } else if (fault == 11) {
      scenario.desktop.dt = 10.0;
    }
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(!world);
    bool isTold = false;
    for (const base::Diagnostic& diagnostic : world.diagnostics()) {
      isTold = isTold || diagnostic.message.find(word.toStdString()) != std::string::npos;
    }
    QVERIFY(isTold);
  }

  void create_nobody_runsWithoutPeople() {
    const auto world = make(Scenario{});
    advance(*world, 10);
    QCOMPARE(world->stepIndex(), std::int64_t{10});
    QCOMPARE(world->frame().humans.size(), std::size_t{0});
    QVERIFY(world->frame().events.empty());
  }

  void create_robotInAClosedCorridor_warns() {
    Scenario scenario = walk();
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(5.0, 5.0));
    scenario.desktop.wrapX = {0.0, 10.0};
    const base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QCOMPARE(world.diagnostics().size(), std::size_t{1});
  }

  void header_afterCreation_holdsTheResolvedNumbers() {
    Scenario scenario = walk();
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(5.0, 5.0));
    addDoor(scenario, Vec2(20.0, 0.0), Vec2(21.0, 0.0), false, {3.0});
    addWall(scenario, {Vec2(30.0, 0.0), Vec2(31.0, 0.0)});
    const auto world = make(scenario);
    const TraceHeader header = world->header();
    QCOMPARE(header.humans.size(), std::size_t{1});
    QCOMPARE(header.humans[0].desiredSpeed, 1.5);
    QCOMPARE(header.humans[0].goals[0].radius, 0.3);
    QCOMPARE(header.robots[0].id, -1);
    QCOMPARE(header.obstacles.size(), std::size_t{3});
    QVERIFY(header.obstacles[0].name == "map" && header.obstacles[1].name == "wall1");
    QVERIFY(header.obstacles[2].isDoor && !header.obstacles[2].open);
    QVERIFY(header.obstacles[2].toggles == std::vector<double>{3.0});
  }
};

QTEST_APPLESS_MAIN(WorldTest)
#include "tst_World.moc"
