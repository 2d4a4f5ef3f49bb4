#include <algorithm>
#include <limits>
#include <set>

#include <QtTest>

#include "sim2d/scenario/ScenarioFile.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

struct CircleParameters {
  double speed = 0.5;  // [m/s]
  double turn = 0.2;   // [rad/s]
};

base::ParameterTable<CircleParameters> circleTable() {
  base::ParameterTable<CircleParameters> table;
  table.add(&CircleParameters::speed, "speed", "m/s", {0.0, 1.0}, "Along the circle.")
      .add(&CircleParameters::turn, "turn", "rad/s", base::kAnyNumber, "How fast it turns.");
  return table;
}

class Circle : public Planner {
 public:
  explicit Circle(const CircleParameters& parameters) : parameters_(parameters) {}
  base::Result<BodyTwist> command(const Observation& /*observation*/) override {
    return BodyTwist{parameters_.speed, parameters_.turn};
  }

 private:
  CircleParameters parameters_;
};

class Drift : public PedestrianModel {
 public:
  ForceTerms forces(const Situation& /*situation*/) const override { return {}; }
  Vec2 velocity(const Situation& /*situation*/, const ForceTerms& /*forces*/) const override {
    return {0.0, 0.25};
  }
  double range(double /*fastest*/, double /*ownSpeed*/) const override { return 0.0; }
};

std::shared_ptr<const Registries> ownRegistries() {
  auto own = std::make_shared<Registries>(builtinRegistries());
  own->planners.add("circle", circleTable().specs(),
                    [](const PlannerSetup& setup) -> base::Result<std::shared_ptr<Planner>> {
                      CircleParameters parameters;
                      circleTable().set(parameters, setup.parameters);
                      return std::shared_ptr<Planner>(std::make_shared<Circle>(parameters));
                    });
  own->models.add("drift", {},
                  [](const ResolvedHuman& /*person*/) { return std::make_unique<Drift>(); });
  return own;
}

Scenario driftingScenario() {
  Scenario scenario;
  scenario.desktop.model = "drift";
  addGoal(scenario, 1, 5.0, 0.0);
  addPerson(scenario, 1, {0.0, 0.0}, {1});
  Robot& robot = addRobot(scenario, {-5.0, 0.0}, {-9.0, 0.0});
  robot.planner = "circle";
  robot.plannerParameters = {{"turn", "0.4"}};
  return scenario;
}

base::Result<std::unique_ptr<World>> worldOf(const Scenario& scenario,
                                             std::shared_ptr<const Registries> registries) {
  WorldSetup setup = setupOf(scenario);
  setup.registries = std::move(registries);
  return World::create(std::move(setup));
}

/// A planner that always wants the same of its robot.
class Wish : public Planner {
 public:
  explicit Wish(const BodyTwist& twist) : twist_(twist) {}
  base::Result<BodyTwist> command(const Observation& /*observation*/) override { return twist_; }

 private:
  BodyTwist twist_;
};

/// A planner that is an error from its second call on.
class GivesUp : public Planner {
 public:
  base::Result<BodyTwist> command(const Observation& /*observation*/) override {
    if (++calls_ == 1) {
      return BodyTwist{};
    }
    return base::error("external.complaint", {"tired"});
  }

 private:
  int calls_ = 0;
};

std::unique_ptr<World> worldOfPlanner(const char* type, const std::shared_ptr<Planner>& planner) {
  auto own = std::make_shared<Registries>(builtinRegistries());
  own->planners.add("wish", {}, [planner](const PlannerSetup& /*setup*/) {
    return base::Result<std::shared_ptr<Planner>>(planner);
  });
  Scenario scenario;
  Robot& robot = addRobot(scenario, {0.0, 0.0}, {50.0, 0.0});
  robot.type = type;
  robot.planner = "wish";
  robot.maxVel = 0.5;
  base::Result<std::unique_ptr<World>> world = worldOf(scenario, own);
  return world ? *std::move(world) : nullptr;
}

std::unique_ptr<World> worldOfWish(const char* type, const BodyTwist& wish) {
  return worldOfPlanner(type, std::make_shared<Wish>(wish));
}

}  // namespace

/// Planners and models that a world is handed, and the parameters that they declare.
class RegistriesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void create_ownPlannerAndModel_moveRobotAndPeople() {
    const base::Result<std::unique_ptr<World>> world = worldOf(driftingScenario(), ownRegistries());
    QVERIFY(world);
    advance(**world, 40);
    QVERIFY((positionOf((*world)->frame(), 0) - Vec2(0.0, 0.5)).norm() < 1e-9);
    const RobotColumns& robots = (*world)->frame().robots;
    QCOMPARE(Vec2(robots.vx[0], robots.vy[0]).norm(), 0.5);
    QCOMPARE(robots.omega[0], 0.4);
  }

  /// Four seconds at 0.3 m/s with 1 m/s²: 1.2 m less 0.3²/2.
  void step_omnidirectional_goesSideways() {
    const auto world = worldOfWish("pepper", {0.0, 0.0, 0.3});
    QVERIFY(world);
    advance(*world, 80);
    const Pose2 pose = world->view().robotPose(0);
    const double acceleration = robotOfType("pepper").maxAcc;
    QVERIFY(std::fabs(pose.position.y() - (1.2 - 0.3 * 0.3 / 2.0 / acceleration)) < 0.02);
    QVERIFY(std::fabs(pose.position.x()) < 1e-6);
  }

  void step_differential_doesNotGoSideways() {
    const auto world = worldOfWish("tiago", {0.0, 0.0, 0.3});
    QVERIFY(world);
    advance(*world, 80);
    QVERIFY(world->view().robotPose(0).position.norm() < 1e-9);
  }

  /// Half of the tightest circle takes pi R / v.
  void step_ackermann_turnsNoTighterThanItsSteering() {
    const auto world = worldOfWish("ackermann_car", {0.5, 10.0});
    QVERIFY(world);
    double highest = 0.0;
    for (int i = 0; i < 120; ++i) {
      QVERIFY(world->step());
      highest = std::max(highest, world->view().robotPose(0).position.y());
    }
    QVERIFY(std::fabs(highest - 2.0 * 0.65) < 0.05);
    const auto standing = worldOfWish("ackermann_car", {0.0, 10.0});
    QVERIFY(standing);
    advance(*standing, 40);
    QVERIFY(std::fabs(standing->view().robotPose(0).heading) < 1e-9);
  }

  void step_plannerGivesUp_endsTheRunWithItsWords() {
    const auto world = worldOfPlanner("generic", std::make_shared<GivesUp>());
    QVERIFY(world);
    QVERIFY(world->step());
    QVERIFY(!world->step());
    const QString failure = QString::fromStdString(world->failure());
    QVERIFY2(failure.contains(QStringLiteral("robot1")), qPrintable(failure));
    QVERIFY2(failure.contains(QStringLiteral("tired")), qPrintable(failure));
    QVERIFY(!world->step());  // and it stays ended
  }

  void step_commandThatIsNoNumber_endsTheRun() {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    constexpr double kNoEnd = std::numeric_limits<double>::infinity();
    for (const BodyTwist& wish : {BodyTwist{kNone, 0.0}, BodyTwist{0.0, -kNoEnd}}) {
      const auto world = worldOfWish("generic", wish);
      QVERIFY(world);
      QVERIFY(!world->step());
      QCOMPARE(QString::fromStdString(world->failure()),
               QStringLiteral("robot 'robot1': the command of its planner is not finite"));
    }
  }

  void create_worldsOfDifferentRegistries_liveSideBySide() {
    const base::Result<std::unique_ptr<World>> own = worldOf(driftingScenario(), ownRegistries());
    QVERIFY(own);
    const base::Result<std::unique_ptr<World>> program = worldOf(driftingScenario(), nullptr);
    QVERIFY(!program);
    QCOMPARE(program.diagnostics().size(), std::size_t{2});
    Scenario usual = driftingScenario();
    usual.desktop.model = std::nullopt;
    usual.robots[0].planner = std::nullopt;
    usual.robots[0].plannerParameters.clear();
    const base::Result<std::unique_ptr<World>> beside = worldOf(usual, nullptr);
    const base::Result<std::unique_ptr<World>> alone = worldOf(usual, ownRegistries());
    QVERIFY(beside && alone);
    for (int i = 0; i < 100; ++i) {
      QVERIFY((*own)->step() && (*beside)->step() && (*alone)->step());
    }
    QVERIFY((*beside)->frame().humans == (*alone)->frame().humans);
    QVERIFY((*beside)->frame().robots == (*alone)->frame().robots);
  }

  void table_oneRow_isInSpecsValuesAndCheck() {
    struct Counted {
      double things = 3.0;
    };
    base::ParameterTable<Counted> counted;
    counted.addCount(&Counted::things, "things", {1.0, 9.0}, "How many.");
    QCOMPARE(counted.specs()[0].form.decimals, 0);
    QVERIFY(std::get<double>(counted.specs()[0].fallback) == 3.0);
    const KnownNames names = knownNames(*ownRegistries());
    const std::vector<base::ParameterSpec>& specs = names.plannerParameters.at("circle");
    QCOMPARE(specs.size(), std::size_t{2});
    QCOMPARE(specs[0].key, std::string("speed"));
    QCOMPARE(std::get<double>(specs[0].fallback), 0.5);
    CircleParameters values;
    circleTable().set(values, {{"speed", 0.75}, {"other", 3.0}});
    QCOMPARE(values.speed, 0.75);
    QCOMPARE(values.turn, 0.2);

    Scenario scenario = driftingScenario();
    scenario.robots[0].plannerParameters = {{"speed", "1.5"}, {"trun", "1.0"}, {"turn", "no"}};
    std::vector<std::string> told;
    for (const base::Diagnostic& each :
         checkScenario(scenario, makeSurroundings(scenario, {}), "circle.yaml", names)) {
      if (each.message.find("planner_parameters") != std::string::npos) {
        told.push_back(each.message);
      }
    }
    QVERIFY((told == std::vector<std::string>{
                         "robot1.planner_parameters.speed: '1.5' is not a number from 0 to 1 m/s",
                         "robot1.planner_parameters.trun: unknown parameter of 'circle' (did you "
                         "mean 'turn'?)",
                         "robot1.planner_parameters.turn: 'no' is not a number"}));
  }

  void modelParameters_setByPath_countInTheRunAndAreChecked() {
    Scenario scenario = driftingScenario();
    scenario.desktop.model = "orca";
    scenario.robots.clear();
    QVERIFY(setValue(scenario, "model_parameters.orca.horizon", "3").empty());
    QVERIFY(setValue(scenario, "model_parameters.das.time_gap", "0.9").empty());
    const base::Result<std::unique_ptr<World>> world = worldOf(scenario, nullptr);
    QVERIFY(world);
    const auto parameters = (*world)->header().humans.front().parameters;
    QVERIFY(std::find(parameters.begin(), parameters.end(),
                      std::make_pair(std::string("model_parameters.horizon"), 3.0)) !=
            parameters.end());

    QVERIFY(setValue(scenario, "model_parameters.orca.range", "-1").empty());
    QVERIFY(setValue(scenario, "model_parameters.orca.horizn", "1").empty());
    std::vector<std::string> told;
    for (const base::Diagnostic& each :
         checkScenario(scenario, makeSurroundings(scenario, {}), "orca.yaml",
                       knownNames(builtinRegistries()))) {
      if (each.message.find("model_parameters") != std::string::npos) {
        told.push_back(each.message);
      }
    }
    QVERIFY((told == std::vector<std::string>{
                         "model_parameters.orca.range: '-1' is not a number from 0.001 to 1e+06 m",
                         "model_parameters.orca.horizn: unknown parameter of 'orca' (did you mean "
                         "'horizon'?)"}));
    const base::Result<std::unique_ptr<World>> refused = worldOf(scenario, nullptr);
    QVERIFY(!refused);
    QCOMPARE(refused.diagnostics().front().code, std::string_view("world.unknown-model-parameter"));
  }

  void specs_ofTheProgram_areDescribed() {
    const Registries all = builtinRegistries();
    const auto check = [](const std::string& owner, const std::vector<base::ParameterSpec>& specs) {
      std::set<std::string> keys;
      for (const base::ParameterSpec& spec : specs) {
        const double* const number = std::get_if<double>(&spec.fallback);
        const bool hasDefault = spec.type == base::ParameterType::Text
                                    ? std::holds_alternative<std::string>(spec.fallback)
                                    : number != nullptr && spec.range.contains(*number);
        const bool isDescribed = !spec.help.empty() && hasDefault && keys.insert(spec.key).second;
        QVERIFY2(isDescribed, (owner + "." + spec.key).c_str());
      }
    };
    for (const auto& planner : all.planners.entries()) {
      check(planner.name, planner.parameters);
    }
    for (const auto& model : all.models.entries()) {
      QVERIFY(!model.parameters.empty());
      check(model.name, model.parameters);
    }
    QVERIFY(all.planners.find("pursuit")->parameters.size() >= 3);
    QVERIFY(all.planners.find("persuit") == nullptr);
  }

  void create_sharedSurroundings_giveTheSameWorld() {
    Scenario scenario;
    addRoom(scenario, {-5.0, -3.0}, {5.0, 3.0});
    addWall(scenario, {{0.0, -3.0}, {0.0, -1.0}});
    addWall(scenario, {{0.0, 1.0}, {0.0, 3.0}});
    addDoor(scenario, {0.0, -1.0}, {0.0, 1.0}, true, {1.0, 4.0});
    addGoal(scenario, 1, 3.0, 0.5);
    addGoal(scenario, 2, -3.0, 0.5);
    addPerson(scenario, 4, {-3.0, 0.0}, {1, 2});
    addPerson(scenario, 7, {3.0, -2.0}, {2, 1});
    addRobot(scenario, {3.0, 2.0}, {-1.5, -2.0});
    const auto shared = std::make_shared<const Surroundings>(makeSurroundings(scenario, {}));
    std::vector<std::unique_ptr<World>> worlds;
    for (int i = 0; i < 3; ++i) {
      WorldSetup setup = setupOf(scenario);
      setup.surroundings = i < 2 ? shared : nullptr;
      worlds.push_back(make(std::move(setup)));
    }
    advance(*worlds[0], 90);  // the others find what it has planned, and doors that it has not
    advance(*worlds[1], 200);
    advance(*worlds[2], 200);
    advance(*worlds[0], 110);
    for (const std::unique_ptr<World>& world : worlds) {
      QVERIFY(world->frame().humans == worlds[2]->frame().humans);
      QVERIFY(world->frame().robots == worlds[2]->frame().robots);
    }
  }
};

QTEST_APPLESS_MAIN(RegistriesTest)
#include "tst_Registries.moc"
