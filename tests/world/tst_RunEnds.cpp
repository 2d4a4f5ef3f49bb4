#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/trace/Frame.h"
#include "sim2d/world/Runner.h"
#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// People who have goals walk, the others stand still.
void standStill(const WorldView& view, Intents& intents) {
  for (int human = 0; human < view.humanCount(); ++human) {
    if (intents.control(human).goals.empty()) {
      intents.of(human).motion = Motion::Stand;
    }
  }
}

struct Ran {
  RunResult result;
  Trace trace;
  const RobotResult& robot(std::size_t k = 0) const { return result.robots[k]; }
};

/// The inputs of each step, by the number of the last one.
using InputsAt = std::function<StepInputs(std::int64_t step)>;

Ran ranWith(const Scenario& scenario, const StopRule& rule, const InputsAt& inputsAt,
            const ScriptedBehavior::Change& change = standStill) {
  const auto world = make(scenario, change);
  Recording recording;
  Ran ran;
  ran.result = run(*world, rule, recording, {}, [&] { return inputsAt(world->stepIndex()); });
  ran.trace = recording.trace(world->header());
  return ran;
}

/// By the rule of the scenario; robots in `driven` go ahead at full speed, whatever is there.
Ran ranWith(const Scenario& scenario, const std::vector<int>& driven = {}) {
  StepInputs ahead;
  for (const int id : driven) {
    ahead.push_back(inputOf(InputKind::Robot, id, {1.0, 0.0}));
  }
  return ranWith(scenario, stopRuleOf(scenario), [&](std::int64_t) { return ahead; });
}

/// With one input after so many steps.
InputsAt once(std::int64_t after, const Input& input) {
  return [=](std::int64_t step) { return step == after ? StepInputs{input} : StepInputs(); };
}

std::vector<double> timesOf(const Trace& trace, EventKind kind, int id = -1) {
  std::vector<double> times;
  for (const auto& [step, event] : trace.events) {
    if (event.kind == kind && event.id == id) {
      times.push_back(static_cast<double>(step) * trace.header.dt);
    }
  }
  return times;
}

bool isAbout(double value, double expected, double slack) {
  return std::fabs(value - expected) <= slack;
}

/// A robot at the origin that is to go to x, seven seconds at the most.
Scenario driveTo(double x) {
  Scenario scenario;
  addRobot(scenario, Vec2::Zero(), Vec2(x, 0.0));
  scenario.desktop.duration = 7.0;
  return scenario;
}

/// A robot in a corridor 1.6 m wide in which somebody stands; it is stuck after 3 s.
Scenario blockedCorridor(double duration = 60.0) {
  Scenario scenario = driveTo(8.0);
  scenario.desktop.duration = duration;
  scenario.desktop.stuckAfter = 3.0;
  addRoom(scenario, Vec2(-2.0, -0.8), Vec2(12.0, 0.8));
  addPerson(scenario, 1, Vec2(4.0, 0.0));
  return scenario;
}

}  // namespace

/// What ends runs, and what is told of each robot then.
class RunEndsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void arrived_isTheTimeOfTheEvent() {
    Scenario scenario = driveTo(3.0);
    scenario.desktop.duration.reset();
    const Ran ran = ranWith(scenario);
    QCOMPARE(ran.result.reason, std::string("arrived"));
    QVERIFY(ran.robot().result == NavigationOutcome::Arrived);
    QCOMPARE(ran.robot().name, std::string("robot1"));
    QCOMPARE(timesOf(ran.trace, EventKind::Arrived), std::vector<double>{ran.robot().time});
  }

  /// Sent to (0, 2) on its way to (9, 0), it arrives there, and the run continues: more orders may
  /// come. It has not arrived at its goal.
  void arrivedAtAnOrder_isNotTheEnd() {
    for (const bool hasGoal : {true, false}) {
      Scenario scenario = driveTo(9.0);
      scenario.desktop.duration.reset();
      if (!hasGoal) {
        scenario.robots[0].goal.point.reset();
      }
      StopRule rule = stopRuleOf(scenario);
      rule.maximumSteps = 200;
      const Ran ran = ranWith(scenario, rule, once(4, placing(InputKind::Goal, -1, {0.0, 2.0})));
      QCOMPARE(ran.result.reason, std::string("duration"));
      QVERIFY(ran.robot().result ==
              (hasGoal ? std::optional(NavigationOutcome::Timeout) : std::nullopt));
      QCOMPARE(timesOf(ran.trace, EventKind::Arrived).size(), std::size_t{1});
      for (const auto& [step, event] : ran.trace.events) {
        QVERIFY(event.kind != EventKind::Arrived || event.text == kOrderText);
        QVERIFY(event.kind != EventKind::Goal || event.text.empty());
      }
    }
  }

  /// It has arrived at its goal when it is sent somewhere else: that stays its result.
  void orderAfterTheGoal_leavesTheResult() {
    const Scenario scenario = driveTo(2.0);
    const Ran ran = ranWith(scenario, stopRuleOf(scenario),
                            once(80, placing(InputKind::Goal, -1, {2.0, 30.0})));
    QVERIFY(ran.robot().result == NavigationOutcome::Arrived);
    QCOMPARE(timesOf(ran.trace, EventKind::Arrived), std::vector<double>{ran.robot().time});
    QVERIFY(ran.robot().time < 4.0);
  }

  void duration_onTheWay_isATimeout() {
    const Ran ran = ranWith(driveTo(30.0));
    QCOMPARE(ran.result.reason, std::string("duration"));
    QVERIFY(ran.result.status == RunStatus::Finished);
    QVERIFY(ran.robot().result == NavigationOutcome::Timeout);
    QCOMPARE(ran.robot().time, 7.0);
  }

  void noGoal_hasNoResult() {
    Scenario scenario = driveTo(1.0);
    scenario.robots[0].goal.point.reset();
    QVERIFY(!ranWith(scenario).robot().result);
  }

  void failedAndInterrupted_areToldOfWhoIsOnTheWay() {
    Scenario scenario = driveTo(30.0);
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(1.0, 5.0));
    addPerson(scenario, 1, Vec2(0.0, -5.0));
    for (const bool fails : {true, false}) {
      const auto world = make(scenario, [fails](const WorldView& view, Intents& intents) {
        intents.of(0).motion = Motion::Walk;
        intents.of(0).speed = fails && view.step() > 100 ? std::nan("") : 0.0;
      });
      Recording recording;
      const RunResult result = run(*world, stopRuleOf(scenario), recording,
                                   [](const Frame& frame) { return frame.step == 120; });
      QVERIFY(result.status == (fails ? RunStatus::Failed : RunStatus::Interrupted));
      QVERIFY(result.robots[0].result ==
              (fails ? NavigationOutcome::Failed : NavigationOutcome::Interrupted));
      QVERIFY(result.robots[1].result == NavigationOutcome::Arrived);
    }
  }

  /// From rest at 1 m/s²: 1 m/s after 0.5 m and 1 s; the discs of 0.35 m and 0.4 m meet when it has
  /// driven 2.25 m, at 2.75 s. A wall 0.2 m thick about x = 3 is met after 2.55 m, at 3.05 s.
  void collision_endsTheRun_data() {
    addColumns<int, bool>({"rule", "isWall"});
    QTest::addColumn<double>("end");  // [s]
    QTest::newRow("people, a person") << 1 << false << 2.75;
    QTest::newRow("any, a person") << 2 << false << 2.75;
    QTest::newRow("none, a person") << 0 << false << 7.0;
    QTest::newRow("people, a wall") << 1 << true << 7.0;
    QTest::newRow("any, a wall") << 2 << true << 3.05;
  }
  void collision_endsTheRun() {
    QFETCH(int, rule);
    QFETCH(bool, isWall);
    QFETCH(double, end);
    Scenario scenario = driveTo(6.0);
    scenario.desktop.stopOnCollision = static_cast<StopOnCollision>(rule);
    if (isWall) {
      addWall(scenario, {Vec2(3.0, -2.0), Vec2(3.0, 2.0)});
    } else {
      addPerson(scenario, 1, Vec2(3.0, 0.0));
    }
    const Ran ran = ranWith(scenario, {-1});
    const std::vector<double> contacts = timesOf(ran.trace, EventKind::Contact);
    QVERIFY(!contacts.empty());
    QVERIFY2(isAbout(contacts.front(), isWall ? 3.05 : 2.75, 0.1),
             qPrintable(QString::number(contacts.front())));
    const bool isEnd = end < 7.0;
    QVERIFY(ran.result.status == RunStatus::Finished);
    QVERIFY(ran.robot().result ==
            (isEnd ? NavigationOutcome::Collision : NavigationOutcome::Timeout));
    QCOMPARE(ran.robot().time, isEnd ? contacts.front() : 7.0);
    QCOMPARE(ran.result.reason, std::string(!isEnd   ? "duration"
                                            : isWall ? "collision: robot1 with an obstacle"
                                                     : "collision: robot1 with person1"));
    QCOMPARE(ran.trace.frames.back().time, ran.robot().time);
    QCOMPARE(ran.trace.events.back().second.text, ran.result.reason);
  }

  /// People walk into a robot that is parked at its goal, or that has not set off yet.
  void collision_ofAParkedRobot_endsNothing_data() {
    QTest::addColumn<double>("goal");
    QTest::addColumn<double>("startTime");  // [s]
    QTest::newRow("arrived") << 0.5 << 0.0;
    QTest::newRow("not set off") << 30.0 << 6.9;
  }
  void collision_ofAParkedRobot_endsNothing() {
    QFETCH(double, goal);
    QFETCH(double, startTime);
    Scenario scenario = driveTo(goal);
    scenario.robots[0].startTime = startTime;
    scenario.desktop.stopOnCollision = StopOnCollision::Any;
    scenario.desktop.model.emplace("sfm-hunav2");  // others do not push robots
    addGoal(scenario, 1, -3.0, 0.0);
    for (int id = 1; id <= 3; ++id) {  // the ones behind push
      addPerson(scenario, id, Vec2(4.0 + id, 0.0), {1}).ours.route = Route::Direct;
    }
    const Ran ran = ranWith(scenario);
    QVERIFY(!timesOf(ran.trace, EventKind::Contact).empty());
    QCOMPARE(ran.result.reason, std::string("duration"));
    QVERIFY(ran.robot().result ==
            (goal < 1.0 ? NavigationOutcome::Arrived : NavigationOutcome::Timeout));
    QVERIFY(goal > 1.0 || ran.robot().time < timesOf(ran.trace, EventKind::Contact).front());
  }

  /// A robot that has nowhere to go is an obstacle for the others.
  void collision_withAStandingRobot_isOfWhoDrives() {
    Scenario scenario = driveTo(6.0);
    addRobot(scenario, Vec2(3.0, 0.0), Vec2::Zero()).goal.point.reset();
    scenario.desktop.stopOnCollision = StopOnCollision::Any;
    const Ran ran = ranWith(scenario, {-1});
    QCOMPARE(ran.result.reason, std::string("collision: robot1 with robot2"));
    QVERIFY(ran.robot(0).result == NavigationOutcome::Collision);
    QVERIFY(!ran.robot(1).result);
    QVERIFY(isAbout(ran.robot(0).time, 2.8, 0.1));  // 2.3 m
    scenario.desktop.model.emplace("sfm-hunav2");   // others do not push robots
    addGoal(scenario, 1, 6.0, 3.0);
    for (int id = 1; id <= 3; ++id) {  // they push the second one
      addPerson(scenario, id, Vec2(2.0 - id, 3.0), {1}).ours.route = Route::Direct;
    }
    scenario.robots[0].start.position = Vec2(0.0, -6.0);
    scenario.robots[0].goal.point = Vec2(30.0, -6.0);
    scenario.robots[1].start.position = Vec2(3.0, 3.0);
    const Ran pushed = ranWith(scenario);
    QVERIFY(!timesOf(pushed.trace, EventKind::Contact, -2).empty());
    QCOMPARE(pushed.result.reason, std::string("duration"));
  }

  /// Two robots drive at each other, a third one is on its way far off.
  void collision_ofTwoRobots_isOneOfBoth() {
    Scenario scenario = driveTo(6.0);
    addRobot(scenario, Vec2(4.0, 0.0), Vec2(-2.0, 0.0)).start.heading = base::kPi;
    addRobot(scenario, Vec2(0.0, 9.0), Vec2(30.0, 9.0));
    for (const StopOnCollision rule : {StopOnCollision::People, StopOnCollision::Any}) {
      scenario.desktop.stopOnCollision = rule;
      const Ran ran = ranWith(scenario, {-1, -2});
      const bool isEnd = rule == StopOnCollision::Any;
      QCOMPARE(ran.result.reason,
               std::string(isEnd ? "collision: robot1 with robot2" : "duration"));
      QVERIFY(ran.robot(0).result ==
              (isEnd ? NavigationOutcome::Collision : NavigationOutcome::Timeout));
      QVERIFY(ran.robot(1).result == ran.robot(0).result);
      QVERIFY(ran.robot(2).result ==
              (isEnd ? NavigationOutcome::Interrupted : NavigationOutcome::Timeout));
    }
  }

  /// Somebody stands in a corridor 1.6 m wide: the robot waits before them for good. From when it
  /// has come as near as 0.1 m to its place it has 3 s.
  void stuck_beforeAPerson_endsTheRun() {
    Scenario scenario = blockedCorridor();
    scenario.desktop.stuckAfter.reset();
    QCOMPARE(ranWith(scenario).result.reason, std::string("duration"));
    scenario.desktop.stuckAfter = 3.0;
    const Ran ran = ranWith(scenario);
    QCOMPARE(ran.result.reason, std::string("stuck: robot1"));
    QVERIFY(ran.result.status == RunStatus::Finished);
    QVERIFY(ran.robot().result == NavigationOutcome::Stuck);
    QCOMPARE(timesOf(ran.trace, EventKind::Stuck), std::vector<double>{ran.robot().time});
    const std::vector<Frame>& frames = ran.trace.frames;
    QCOMPARE(frames.back().time, ran.robot().time);
    const auto before = [&frames](double seconds) {
      return frames[frames.size() - 1 - static_cast<std::size_t>(std::lround(seconds / 0.05))];
    };
    const double end = frames.back().robots.x[0];
    QVERIFY(end - before(2.9).robots.x[0] <= 0.1);  // no progress for so long
    QVERIFY(end - before(5.0).robots.x[0] > 0.1);   // and not told too late
  }

  /// The second robot arrives meanwhile; the third, without a goal, does not matter.
  void stuck_oneOfSeveral_waitsForTheOthers() {
    Scenario scenario = blockedCorridor();
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(20.0, 5.0));
    addRobot(scenario, Vec2(0.0, 9.0), Vec2(0.0, 9.0)).goal.point.reset();
    const Ran ran = ranWith(scenario);
    QCOMPARE(ran.result.reason, std::string("stuck: robot1"));
    QVERIFY(ran.robot(0).result == NavigationOutcome::Stuck);
    QVERIFY(ran.robot(1).result == NavigationOutcome::Arrived);
    QVERIFY(!ran.robot(2).result);
    QCOMPARE(ran.trace.frames.back().time, ran.robot(1).time);
    QVERIFY(ran.robot(0).time < ran.robot(1).time);
  }

  /// The second robot stands where it was sent: more orders may come.
  void stuck_besideOneAtAnOrder_isNotTheEnd() {
    Scenario scenario = blockedCorridor(20.0);
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(20.0, 5.0));
    const Ran ran =
        ranWith(scenario, stopRuleOf(scenario), once(4, placing(InputKind::Goal, -2, {3.0, 5.0})));
    QCOMPARE(ran.result.reason, std::string("duration"));
    QVERIFY(ran.robot(0).result == NavigationOutcome::Stuck);
    QVERIFY(ran.robot(1).result == NavigationOutcome::Timeout);
    QCOMPARE(timesOf(ran.trace, EventKind::Arrived, -2).size(), std::size_t{1});
  }

  /// A person in the way goes on after 9 s: the robot was stuck, frees itself and arrives.
  void stuck_thatFreesItself_arrives() {
    Scenario scenario = blockedCorridor();
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(30.0, 5.0));
    const Ran ran =
        ranWith(scenario, stopRuleOf(scenario), once(180, placing(InputKind::Move, 1, {11.0, 0.0})),
                [](const WorldView&, Intents& intents) { intents.of(0).motion = Motion::Stand; });
    QCOMPARE(timesOf(ran.trace, EventKind::Stuck).size(), std::size_t{1});
    QVERIFY(timesOf(ran.trace, EventKind::Stuck).front() < 9.0);
    QVERIFY(ran.robot(0).result == NavigationOutcome::Arrived);
    QVERIFY(ran.robot(1).result == NavigationOutcome::Arrived);
    QCOMPARE(ran.result.reason, std::string("duration"));
  }

  /// Behind a door that opens by itself at 12 s; and before it sets off at 8 s.
  void waiting_isNotStuck() {
    Scenario scenario = driveTo(8.0);
    scenario.desktop.duration = 60.0;
    scenario.desktop.stuckAfter = 3.0;
    addRoom(scenario, Vec2(-2.0, -3.0), Vec2(12.0, 3.0));
    addWall(scenario, {Vec2(4.0, -3.0), Vec2(4.0, -0.7)});
    addWall(scenario, {Vec2(4.0, 0.7), Vec2(4.0, 3.0)});
    addDoor(scenario, Vec2(4.0, -0.75), Vec2(4.0, 0.75), true, {1.0, 12.0});
    const Ran door = ranWith(scenario);
    QVERIFY(door.robot().result == NavigationOutcome::Arrived);
    QVERIFY(door.robot().time > 12.0);
    QVERIFY(timesOf(door.trace, EventKind::Stuck).empty());
    Scenario late = driveTo(2.0);
    late.desktop.duration = 20.0;
    late.desktop.stuckAfter = 3.0;
    late.robots[0].startTime = 8.0;
    QVERIFY(ranWith(late).robot().result == NavigationOutcome::Arrived);
  }

  /// Looking for stuck robots moves nothing.
  void stuckAfter_leavesTheTraceAlone() {
    Scenario scenario = driveTo(6.0);
    addWall(scenario, {Vec2(3.0, -2.0), Vec2(3.0, 1.0)});
    const Ran usual = ranWith(scenario);
    scenario.desktop.stuckAfter = 60.0;
    const Ran watched = ranWith(scenario);
    QVERIFY(trajectoryCsv(usual.trace) == trajectoryCsv(watched.trace));
    QVERIFY(eventsCsv(usual.trace) == eventsCsv(watched.trace));
  }
};

QTEST_APPLESS_MAIN(RunEndsTest)
#include "tst_RunEnds.moc"
