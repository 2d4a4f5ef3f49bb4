#include <QtTest>

#include "sim2d/world/Runner.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// What a planner was made of, and how it was asked.
struct Asked {
  PlannerSetup setup;
  int calls = 0;
  Vec2 goal = Vec2::Zero();
};

/// Is told to stop when it is asked for the third time.
class Waits : public Planner {
 public:
  Waits(Asked& asked, bool needsGoal) : asked_(asked), needsGoal_(needsGoal) {}
  base::Result<BodyTwist> command(const Observation& observation) override {
    asked_.goal = observation.goal;
    if (++asked_.calls > 2) {
      throw base::Stopped();
    }
    return BodyTwist{0.1, 0.0};
  }
  bool needsGoal() const override { return needsGoal_; }

 private:
  Asked& asked_;
  bool needsGoal_;
};

class LastFrame : public FrameSink {
 public:
  void append(const Frame& frame) override { last = frame; }
  Frame last;
};

/// With planner `waits`, which has a number and a text.
std::unique_ptr<World> waitingWorld(Asked& asked, Scenario scenario, bool needsGoal = true) {
  auto own = std::make_shared<Registries>(builtinRegistries());
  base::ParameterSpec number;
  number.key = "number";
  base::ParameterSpec text;
  text.key = "text";
  text.type = base::ParameterType::Text;
  own->planners.add("waits", {number, text}, [&asked, needsGoal](const PlannerSetup& setup) {
    asked.setup = setup;
    return base::Result<std::shared_ptr<Planner>>(std::make_shared<Waits>(asked, needsGoal));
  });
  scenario.robots.front().planner = "waits";
  WorldSetup setup = setupOf(scenario);
  setup.registries = own;
  setup.folder = "/somewhere";
  setup.code = ExternalCodePolicy::Skipped;
  return make(std::move(setup));
}

}  // namespace

/// Robots whose planners are elsewhere: in another program, in a file, in somebody's hand.
class ExternalRobotCommandsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void create_planner_getsNumbersAndTexts() {
    Scenario scenario;
    Robot& robot = addRobot(scenario, {0.0, 0.0}, {5.0, 0.0});
    robot.command = "python3 x.py";
    robot.plannerParameters = {{"number", "0.50"}, {"text", "\"007\""}};
    Asked asked;
    QVERIFY(waitingWorld(asked, scenario));
    using Numbers = std::vector<std::pair<std::string, double>>;
    using Texts = std::vector<std::pair<std::string, std::string>>;
    QVERIFY(asked.setup.parameters == (Numbers{{"number", 0.5}}));
    QVERIFY(asked.setup.texts == (Texts{{"text", "007"}}));
    QCOMPARE(asked.setup.command, std::string("python3 x.py"));
    QCOMPARE(asked.setup.folder, std::string("/somewhere"));
    QVERIFY(asked.setup.code == ExternalCodePolicy::Skipped);
    QCOMPARE(fileParameter(asked.setup, "text"), std::string("/somewhere/007"));
    scenario.robots.front().plannerParameters = {{"txt", "a"}};
    QVERIFY_EXCEPTION_THROWN(waitingWorld(asked, scenario), std::runtime_error);
  }

  /// What was there before the step that was waited for is the end of the run.
  void run_plannerIsToldToStop_isInterrupted() {
    Scenario scenario;
    addRobot(scenario, {0.0, 0.0}, {5.0, 0.0});
    Asked asked;
    const std::unique_ptr<World> world = waitingWorld(asked, scenario);
    QVERIFY(world);
    LastFrame sink;
    const RunResult result = run(*world, {100, true}, sink);
    QVERIFY(result.status == RunStatus::Interrupted);
    QCOMPARE(result.reason, std::string("interrupted"));
    QCOMPARE(result.steps, std::int64_t{2});
    QCOMPARE(sink.last.step, std::int64_t{2});
    QVERIFY(sink.last.events.back().kind == EventKind::Stop);
    QCOMPARE(sink.last.events.back().text, std::string("interrupted"));
  }

  void step_plannerWithoutGoal_isAskedIfItWants() {
    for (const bool needsGoal : {true, false}) {
      Scenario scenario;
      Robot& robot = addRobot(scenario, {2.0, 1.0}, {5.0, 0.0});
      robot.goal = RobotGoal{};
      Asked asked;
      const std::unique_ptr<World> world = waitingWorld(asked, scenario, needsGoal);
      QVERIFY(world);
      QVERIFY(world->step());
      QCOMPARE(asked.calls, needsGoal ? 0 : 1);
      QVERIFY(needsGoal || asked.goal == Vec2(2.0, 1.0));  // where it stands
    }
  }

  /// 1 m/s² from standing: 0.5 m/s after 0.5 s. Half a second after the word it brakes as fast.
  void step_teleop_keepsTheNewestWord() {
    Scenario scenario;
    Robot& robot = addRobot(scenario, {0.0, 0.0}, {5.0, 0.0});
    robot.goal = RobotGoal{};
    robot.planner = "teleop";
    const auto world = make(scenario);
    advance(*world, 10);
    QCOMPARE(world->frame().robots.x[0], 0.0);  // nobody has said anything
    QVERIFY(world->step({inputOf(InputKind::Robot, -1, {1.0, 0.0})}));
    advance(*world, 9);  // 0.5 s
    QVERIFY(std::fabs(world->frame().robots.vx[0] - 0.5) < 1e-9);
    advance(*world, 12);
    QVERIFY(std::fabs(world->frame().robots.vx[0]) < 1e-9);
    QVERIFY(world->frame().robots.x[0] > 0.25);
    QCOMPARE(world->refused().size(), std::size_t{0});
  }

  void step_inputToPlanner_actsOnce() {
    Scenario scenario;
    Robot& robot = addRobot(scenario, {0.0, 0.0}, {5.0, 0.0});
    robot.goal = RobotGoal{};  // pursuit stands
    const auto world = make(scenario);
    QVERIFY(world->step({inputOf(InputKind::Robot, -1, {1.0, 0.0})}));
    QVERIFY(std::fabs(world->frame().robots.vx[0] - 0.05) < 1e-9);
    QVERIFY(world->step());
    QVERIFY(std::fabs(world->frame().robots.vx[0]) < 1e-9);
  }
};

QTEST_APPLESS_MAIN(ExternalRobotCommandsTest)
#include "tst_ExternalRobotCommands.moc"
