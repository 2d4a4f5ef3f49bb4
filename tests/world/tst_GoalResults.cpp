#include <algorithm>
#include <cmath>
#include <optional>

#include <QtTest>

#include "sim2d/trace/Frame.h"
#include "sim2d/world/RobotDrive.h"
#include "sim2d/world/Runner.h"
#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// Stands still, and ends goals at the times of its list, whatever the robot's position is.
class Announcer : public Planner {
 public:
  struct At {
    double time = 0.0;  // [s]
    bool hasSucceeded = true;
    std::size_t goals = 1;
  };
  explicit Announcer(std::vector<At> ends) : ends_(std::move(ends)) {}

  base::Result<BodyTwist> command(const Observation& observation) override {
    end_.reset();
    if (next_ < ends_.size() && observation.time >= ends_[next_].time - 1e-9) {
      const At& at = ends_[next_++];
      end_ = at.hasSucceeded
                 ? NavigationResult{true, {}, {}, 0, at.goals}
                 : NavigationResult{false, "planner NO_VALID_PATH (208)", "no way", 208, at.goals};
    }
    return BodyTwist();
  }
  bool decidesGoalEnd() const override { return true; }
  std::optional<NavigationResult> takeNavigationResult() override {
    return std::exchange(end_, std::nullopt);
  }

 private:
  std::vector<At> ends_;
  std::size_t next_ = 0;
  std::optional<NavigationResult> end_;
};

struct Announced {
  RunResult result;
  Trace trace;

  std::vector<std::string> texts(EventKind kind) const {
    std::vector<std::string> found;
    for (const auto& [step, event] : trace.events) {
      if (event.kind == kind && event.hasId && event.id == -1) {
        found.push_back(event.text);
      }
    }
    return found;
  }
  std::vector<double> times(EventKind kind) const {
    std::vector<double> found;
    for (const auto& [step, event] : trace.events) {
      if (event.kind == kind && event.hasId && event.id == -1) {
        found.push_back(static_cast<double>(step) * trace.header.dt);
      }
    }
    return found;
  }
  const RobotResult& robot() const { return result.robots.front(); }
};

/// `robot1` is driven by an Announcer; other robots by their own planners.
Announced announced(Scenario scenario, const std::vector<Announcer::At>& ends,
                    const std::function<StepInputs(const World&)>& inputs = {}) {
  auto registries = std::make_shared<Registries>(builtinRegistries());
  registries->planners.add("announcer", {},
                           [ends](const PlannerSetup&) -> base::Result<std::shared_ptr<Planner>> {
                             return std::shared_ptr<Planner>(std::make_shared<Announcer>(ends));
                           });
  scenario.robots[0].planner = "announcer";
  const StopRule rule = stopRuleOf(scenario);
  WorldSetup setup = setupOf(std::move(scenario), [](const WorldView& view, Intents& intents) {
    for (int human = 0; human < view.humanCount(); ++human) {
      intents.of(human).motion = Motion::Stand;
    }
  });
  setup.registries = std::move(registries);
  auto world = make(std::move(setup));
  Announced ran;
  Recording recording;
  ran.result =
      run(*world, rule, recording, {}, [&] { return inputs ? inputs(*world) : StepInputs(); });
  ran.trace = recording.trace(world->header());
  return ran;
}

/// A robot at the origin whose goal is so far ahead; its radius is the usual 0.2 m.
Scenario goalAt(double x) {
  Scenario scenario;
  addRobot(scenario, Vec2::Zero(), Vec2(x, 0.0));
  return scenario;
}

/// Goals 1, 2, 3 at 1, 2, 3 m.
Scenario threeGoals() {
  Scenario scenario;
  for (int id = 1; id <= 3; ++id) {
    addGoal(scenario, id, id, 0.0);
  }
  addRobot(scenario, Vec2::Zero(), Vec2::Zero());
  scenario.robots[0].goal = {};
  scenario.robots[0].goal.goals = {1, 2, 3};
  return scenario;
}

using Texts = std::vector<std::string>;
using Times = std::vector<double>;

}  // namespace

/// Goals of robots whose planners decide when they are over.
class GoalResultsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// The event is in the frame after the command: success in the step from 2 s on is seen at 2.05
  /// s.
  void success_nearTheGoal_isTheArrival() {
    const Announced ran = announced(goalAt(0.65), {{2.0}});
    QCOMPARE(ran.texts(EventKind::NavigationSucceeded), Texts{"0.65 m from the goal"});
    QCOMPARE(ran.times(EventKind::NavigationSucceeded).size(), std::size_t{1});
    QVERIFY(std::fabs(ran.times(EventKind::NavigationSucceeded).front() - 2.05) < 1e-9);
    QCOMPARE(ran.times(EventKind::Arrived), ran.times(EventKind::NavigationSucceeded));
    QCOMPARE(ran.texts(EventKind::Goal).size(), std::size_t{1});
    QCOMPARE(ran.result.reason, std::string("arrived"));
    QVERIFY(std::fabs(static_cast<double>(ran.result.steps) * 0.05 - 3.05) < 1e-9);  // plus 1 s
    QVERIFY(ran.robot().result == NavigationOutcome::Arrived && ran.robot().decidesGoalEnd);
    QVERIFY(std::fabs(ran.robot().goalResults.at(0).distance - 0.65) < 1e-12);
    QVERIFY(ran.robot().goalResults.at(0).isReached);
  }

  void success_beyondTheLimit_isNoArrival_data() {
    addColumns<double, bool>({"distance", "arrives"});
    QTest::newRow("at the limit") << 0.7 << true;  // 0.2 m and 0.5 m
    QTest::newRow("beyond") << 0.701 << false;
    QTest::newRow("far") << 8.0 << false;
  }
  void success_beyondTheLimit_isNoArrival() {
    QFETCH(double, distance);
    QFETCH(bool, arrives);
    const Announced ran = announced(goalAt(distance), {{1.0}});
    QCOMPARE(ran.texts(EventKind::NavigationSucceeded).size(), std::size_t{1});
    QCOMPARE(ran.texts(EventKind::Arrived).size(), std::size_t{arrives ? 1U : 0U});
    QCOMPARE(ran.texts(EventKind::Goal).size(), std::size_t{arrives ? 1U : 0U});
    QVERIFY(ran.robot().result ==
            (arrives ? NavigationOutcome::Arrived : NavigationOutcome::GoalMissed));
    const std::string missed =
        "goal_missed: robot1, " + QString::number(distance).toStdString() + " m from the goal";
    QCOMPARE(ran.result.reason, arrives ? std::string("arrived") : missed);
    QVERIFY(std::fabs(ran.robot().time - 1.05) < 1e-9);
  }

  /// Within its radius from the beginning.
  void goalRadius_aloneEndsNothing() {
    Scenario scenario = goalAt(0.1);
    scenario.desktop.duration = 3.0;
    const Announced ran = announced(scenario, {});
    QVERIFY(ran.texts(EventKind::Arrived).empty() && ran.texts(EventKind::Goal).empty());
    QVERIFY(ran.robot().result == NavigationOutcome::Timeout);
    QVERIFY(ran.robot().goalResults.empty());
  }

  void failure_endsTheRunWithItsReason() {
    const Announced ran = announced(goalAt(4.0), {{2.0, false}});
    QCOMPARE(ran.texts(EventKind::NavigationFailed),
             Texts{"planner NO_VALID_PATH (208), 4 m from the goal"});
    QVERIFY(ran.texts(EventKind::Arrived).empty());
    QCOMPARE(ran.result.reason,
             std::string("navigation_failed: robot1, planner NO_VALID_PATH (208)"));
    QVERIFY(ran.robot().result == NavigationOutcome::NavigationFailed);
    QVERIFY(std::fabs(ran.robot().time - 2.05) < 1e-9);
    QVERIFY(std::fabs(static_cast<double>(ran.result.steps) * 0.05 - 3.05) < 1e-9);
  }

  /// As with arrivals.
  void failure_withADuration_leavesItsLength() {
    Scenario scenario = goalAt(4.0);
    scenario.desktop.duration = 5.0;
    const Announced ran = announced(scenario, {{2.0, false}});
    QCOMPARE(ran.result.reason, std::string("duration"));
    QCOMPARE(ran.result.steps, std::int64_t{100});
    QVERIFY(ran.robot().result == NavigationOutcome::NavigationFailed);
  }

  /// Goals at 1, 2 and 3 m, of which the robot passes none: 1 m is too far from the first already.
  void severalGoals_oneGivenUp_goesOnToTheNext() {
    Scenario scenario = threeGoals();
    scenario.robots[0].goalRadius = 3.0;  // 3.5 m: all of them count as reached
    const Announced ran = announced(scenario, {{1.0}, {2.0, false}, {3.0}});
    QCOMPARE(ran.texts(EventKind::Goal), (Texts{"1", "3"}));
    QCOMPARE(ran.texts(EventKind::NavigationSucceeded),
             (Texts{"goal 1: 1 m from the goal", "goal 3: 3 m from the goal"}));
    QCOMPARE(ran.texts(EventKind::NavigationFailed),
             Texts{"goal 2: planner NO_VALID_PATH (208), 2 m from the goal"});
    QVERIFY(ran.texts(EventKind::Arrived).empty());
    QCOMPARE(ran.result.reason,
             std::string("navigation_failed: robot1, goal 2: planner NO_VALID_PATH (208)"));
    QVERIFY(ran.robot().result == NavigationOutcome::NavigationFailed);
    QVERIFY(std::fabs(ran.robot().time - 3.05) < 1e-9);
    QCOMPARE(ran.robot().goalResults.size(), std::size_t{3});
  }
  void severalGoals_allReached_isTheArrival() {
    Scenario scenario = threeGoals();
    scenario.robots[0].goalRadius = 3.0;
    const Announced ran = announced(scenario, {{1.0}, {2.0}, {3.0}});
    QCOMPARE(ran.texts(EventKind::Goal), (Texts{"1", "2", "3"}));
    QCOMPARE(ran.result.reason, std::string("arrived"));
    QVERIFY(std::fabs(ran.robot().time - 3.05) < 1e-9);
  }
  /// By one navigation; what is left is measured to its last goal.
  void route_isOverAsAWhole() {
    Scenario scenario = threeGoals();
    scenario.robots[0].goalRadius = 3.0;
    const Announced reached = announced(scenario, {{1.0, true, 3}});
    QCOMPARE(reached.texts(EventKind::Goal), (Texts{"1", "2", "3"}));
    QCOMPARE(reached.texts(EventKind::NavigationSucceeded), Texts{"goal 3: 3 m from the goal"});
    QVERIFY(reached.robot().result == NavigationOutcome::Arrived);
    const Announced failed = announced(scenario, {{1.0, false, 3}});
    QVERIFY(failed.texts(EventKind::Goal).empty());
    QVERIFY(failed.robot().result == NavigationOutcome::NavigationFailed);
    QVERIFY(std::fabs(failed.robot().time - 1.05) < 1e-9);
  }

  /// The run ends when each robot is over; the other one arrives at 1 m/s, about 3 m on.
  void twoRobots_theLastOneEndsTheRun() {
    Scenario scenario = goalAt(4.0);
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(3.0, 5.0));
    const Announced ran = announced(scenario, {{1.0, false}});
    QVERIFY(ran.result.robots.at(1).result == NavigationOutcome::Arrived);
    QVERIFY(!ran.result.robots.at(1).decidesGoalEnd);
    QVERIFY(std::fabs(static_cast<double>(ran.result.steps) * 0.05 - ran.result.robots.at(1).time -
                      1.0) < 1e-9);
    QCOMPARE(ran.result.reason,
             std::string("navigation_failed: robot1, planner NO_VALID_PATH (208)"));
  }

  /// A robot that is over counts as one that has arrived: the other one stands before a
  /// person in a corridor.
  void twoRobots_oneStuck_endTheRun() {
    Scenario scenario = goalAt(4.0);
    addRobot(scenario, Vec2(0.0, 5.0), Vec2(8.0, 5.0));
    addRoom(scenario, {-2.0, 4.2}, {12.0, 5.8});
    addPerson(scenario, 1, Vec2(4.0, 5.0));
    scenario.desktop.stuckAfter = 3.0;
    const Announced ran = announced(scenario, {{1.0, false}});
    QVERIFY2(ran.result.reason == "stuck: robot2", ran.result.reason.c_str());
    QVERIFY(ran.robot().result == NavigationOutcome::NavigationFailed);
  }

  /// More of them may come.
  void order_thatFails_isNotTheEnd() {
    Scenario scenario = goalAt(4.0);
    const auto order = [](const World& world) {
      return world.stepIndex() == 4 ? StepInputs{placing(InputKind::Goal, -1, {0.0, 2.0})}
                                    : StepInputs();
    };
    const Announced ran = announced(scenario, {{1.0, false}}, order);
    QCOMPARE(ran.texts(EventKind::NavigationFailed),
             Texts{"planner NO_VALID_PATH (208), 2 m from the goal"});
    QCOMPARE(ran.result.reason, std::string("duration"));
    QVERIFY(ran.robot().result == NavigationOutcome::Timeout);
    QVERIFY(ran.robot().goalResults.at(0).isExternal);
    const Announced reached = announced(scenario, {{1.0}}, order);  // 2 m: too far
    QVERIFY(reached.texts(EventKind::Arrived).empty());
    QCOMPARE(reached.result.reason, std::string("duration"));
  }

  /// Only touching between setting off and the end of the last goal ends a run.
  void contact_afterTheEnd_isNotTheEndOfItsWay() {
    Scenario scenario = goalAt(4.0);
    scenario.desktop.duration = 6.0;
    scenario.desktop.stopOnCollision = StopOnCollision::Any;
    addRobot(scenario, Vec2(3.0, 0.0), Vec2(0.0, 0.0));
    scenario.robots[1].listed = true;
    const auto drive = [](const World& /*world*/) {
      return StepInputs{inputOf(InputKind::Robot, -2, {-1.0, 0.0})};
    };
    const Announced ran = announced(scenario, {{0.5, false}}, drive);
    QVERIFY(ran.robot().result == NavigationOutcome::NavigationFailed);
    QVERIFY(std::fabs(ran.robot().time - 0.55) < 1e-9);
  }
};

QTEST_APPLESS_MAIN(GoalResultsTest)
#include "tst_GoalResults.moc"
