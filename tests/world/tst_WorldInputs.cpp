#include <limits>

#include <QtTest>

#include "sim2d/trace/Recording.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

Input naming(InputKind kind, const std::string& name) {
  Input input = inputOf(kind, 0);
  input.name = name;
  return input;
}

/// Two rooms with a closed door between them; a walker on either side and a robot.
Scenario twoRooms() {
  Scenario scenario;
  addRoom(scenario, {-5.0, -3.0}, {5.0, 3.0});
  addWall(scenario, {{0.0, -3.0}, {0.0, -1.0}});
  addWall(scenario, {{0.0, 1.0}, {0.0, 3.0}});
  addDoor(scenario, {0.0, -1.0}, {0.0, 1.0}, false, {});
  addGoal(scenario, 1, 3.0, 0.5);
  addGoal(scenario, 2, -3.0, 0.5);
  addPerson(scenario, 4, {-3.0, 0.0}, {2});
  addPerson(scenario, 7, {3.0, -2.0}, {1});
  addRobot(scenario, {3.0, 2.0}, {1.5, -2.0});
  return scenario;
}

/// A room with a wall 2 m thick and a robot.
Scenario thickWall() {
  Scenario scenario;
  addRoom(scenario, {-5.0, -3.0}, {5.0, 3.0});
  addWall(scenario, {{2.5, -3.0}, {2.5, -0.5}}, 2.0);
  addRobot(scenario, {-3.0, 2.0}, {-3.0, -2.0});
  return scenario;
}

}  // namespace

/// A world that somebody outside acts on.
class WorldInputsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_robotCommand_replacesThePlannersForThatStep() {
    Scenario scenario;
    addRobot(scenario, {0.0, 0.0}, {9.0, 0.0});
    const auto world = make(scenario);
    Input back = inputOf(InputKind::Robot, -1);
    back.velocity.x() = -9.0;
    back.omega = 0.4;
    for (int i = 0; i < 40; ++i) {
      QVERIFY(world->step({back}));
    }
    const RobotColumns robots = world->frame().robots;
    QCOMPARE(Vec2(robots.vx[0], robots.vy[0]).norm(), 1.0);  // the robot's own limit
    QCOMPARE(robots.omega[0], 0.4);
    QVERIFY(robots.x[0] < -1.0);
    advance(*world, 40);
    QVERIFY(world->frame().robots.x[0] > robots.x[0]);
    QVERIFY(world->frame().inputs.empty());
  }

  void step_doorOpened_letsPeopleThrough() {
    Scenario scenario = twoRooms();
    scenario.humans[0].goals = {2, 1};
    scenario.doors[0].open = true;
    const auto world = make(scenario);
    QVERIFY(world->step({naming(InputKind::Close, "door1")}));
    QCOMPARE(world->frame().doorOpen.front(), char{0});
    QVERIFY(ofKind(advance(*world, 200), EventKind::Arrived).size() < 2);
    QVERIFY(world->step({naming(InputKind::Open, "door1"), naming(InputKind::Open, "door1")}));
    const auto isDoor = [](const Event& event) { return event.kind == EventKind::Door; };
    const std::vector<Event>& events = world->frame().events;
    QCOMPARE(std::count_if(events.begin(), events.end(), isDoor), std::ptrdiff_t{1});
    advance(*world, 300);
    QVERIFY(positionOf(world->frame(), 0).x() > 2.0);
  }

  void step_personMoved_goesOnFromThere() {
    const auto world = make(twoRooms());
    advance(*world, 20);
    QVERIFY(world->step({placing(InputKind::Move, 7, {2.0, -2.5})}));
    QVERIFY((positionOf(world->frame(), 1) - Vec2(2.0, -2.5)).norm() < 0.1);
    const auto reached = ofKind(advance(*world, 200), EventKind::Goal);
    QVERIFY(std::any_of(reached.begin(), reached.end(),
                        [](const Recorded& recorded) { return recorded.event.id == 7; }));
  }

  void step_robotMoved_standsThereAndGoesOn() {
    Scenario scenario;
    addRobot(scenario, {0.0, 0.0}, {9.0, 0.0});
    scenario.robots[0].odometryNoise.alpha1 = 0.02;
    scenario.robots[0].odometryNoise.alpha3 = 0.02;
    const auto world = make(scenario);
    world->publishSensors(true);
    advance(*world, 40);
    const RobotColumns before = world->frame().robots;
    QVERIFY(before.x[0] > 0.5);
    Input move = placing(InputKind::Move, -1, {4.0, 3.0});
    move.pose.heading = 1.0;
    QVERIFY(world->step({move}));
    const Frame& frame = world->frame();
    const base::Pose2 there = {{frame.robots.x[0], frame.robots.y[0]}, frame.robots.heading[0]};
    QVERIFY((there.position - Vec2(4.0, 3.0)).norm() < 0.01);  // it has begun to drive
    QVERIFY(std::fabs(there.heading - 1.0) < 0.1);
    QVERIFY(Vec2(frame.robots.vx[0], frame.robots.vy[0]).norm() < 0.1);
    QCOMPARE(frame.inputs.size(), std::size_t{1});
    const base::Pose2 believed = frame.senses->front().believed;  // in the step that led here
    QVERIFY((believed.position - Vec2(4.0, 3.0)).norm() < 1e-9);
    QVERIFY(std::fabs(believed.heading - 1.0) < 1e-9);
    advance(*world, 200);  // 5.8 m at 1 m/s; where it arrives is as far off as it believes
    const RobotColumns& after = world->frame().robots;
    QVERIFY2(
        (Vec2(after.x[0], after.y[0]) - Vec2(9.0, 0.0)).norm() < 2.0,
        qPrintable(QString::number(after.x[0]) + QLatin1Char(32) + QString::number(after.y[0])));
  }

  void step_robotMovedIntoAWall_isRefused() {
    const auto world = make(thickWall());
    for (const Input& move :
         {placing(InputKind::Move, -1, {2.5, -1.8}), placing(InputKind::Move, -2, {0.0, 0.0})}) {
      QVERIFY(world->step({move}));
      QCOMPARE(world->refused().size(), std::size_t{1});
      QVERIFY(world->frame().inputs.empty());
    }
    QVERIFY(std::fabs(world->frame().robots.x[0] + 3.0) < 0.1);
  }

  void step_robotOrdered_givesUpItsGoals() {
    Scenario scenario;
    addRobot(scenario, {0.0, 0.0}, {9.0, 0.0});
    const auto world = make(scenario);
    advance(*world, 20);
    QVERIFY(world->frame().robots.x[0] > 0.1);
    QVERIFY(world->step({placing(InputKind::Goal, -1, {-2.0, 3.0})}));
    QCOMPARE(world->frame().inputs.size(), std::size_t{1});
    const std::vector<Recorded> events = advance(*world, 160);
    QCOMPARE(ofKind(events, EventKind::Goal).size(), std::size_t{1});
    QCOMPARE(ofKind(events, EventKind::Goal).front().event.text, std::string());
    QCOMPARE(ofKind(events, EventKind::Arrived).size(), std::size_t{1});
    QVERIFY(world->arrivedAt().has_value());
    const Vec2 place(world->frame().robots.x[0], world->frame().robots.y[0]);
    QVERIFY((place - Vec2(-2.0, 3.0)).norm() < 0.5);
    QCOMPARE(world->header().robots[0].goals.size(), std::size_t{1});  // those of the scenario
    QVERIFY(world->header().robots[0].goals[0].position == Vec2(9.0, 0.0));
  }

  void step_robotOrderedAfterItsGoal_goesThere() {
    Scenario scenario;
    addRobot(scenario, {0.0, 0.0}, {1.0, 0.0});
    const auto world = make(scenario);
    advance(*world, 80);
    QVERIFY(world->arrivedAt().has_value());
    QVERIFY(world->step({placing(InputKind::Goal, -1, {4.0, 0.0})}));
    QVERIFY(!world->arrivedAt().has_value());
    QVERIFY(world->step({placing(InputKind::Goal, -1, {1.0, 2.0})}));  // the newest counts
    const std::vector<Recorded> events = advance(*world, 120);
    QCOMPARE(ofKind(events, EventKind::Arrived).size(), std::size_t{1});
    const Vec2 place(world->frame().robots.x[0], world->frame().robots.y[0]);
    QVERIFY((place - Vec2(1.0, 2.0)).norm() < 0.5);
    const std::optional<double> arrived = world->arrivedAt();
    QVERIFY(world->step({placing(InputKind::Goal, -1, {1.0, 2.0})}));  // said again
    QVERIFY(ofKind(advance(*world, 10), EventKind::Arrived).empty());
    QVERIFY(arrived.has_value() && world->arrivedAt() == arrived);
  }

  void step_robotWithoutGoalOrdered_arrives() {
    Scenario scenario;
    addRobot(scenario, {0.0, 0.0}, {0.0, 0.0}).goal = RobotGoal{};
    const auto world = make(scenario);
    advance(*world, 10);
    QCOMPARE(world->frame().robots.x[0], 0.0);
    QVERIFY(!world->robotStatuses()[0].hasGoal && !world->arrivedAt());
    QVERIFY(world->step({placing(InputKind::Goal, -1, {2.0, 0.0})}));
    QVERIFY(world->robotStatuses()[0].hasGoal);
    const std::vector<Recorded> arrived = ofKind(advance(*world, 100), EventKind::Arrived);
    QCOMPARE(arrived.size(), std::size_t{1});
    QCOMPARE(arrived[0].event.text, std::string("order"));
    QVERIFY(world->robotStatuses()[0].arrived.has_value());
  }

  void step_robotOrderedWhereItCannotBe_isRefused() {
    const auto world = make(thickWall());
    for (const Input& order :
         {placing(InputKind::Goal, -1, {2.5, -1.8}), placing(InputKind::Goal, -2, {0.0, 0.0}),
          placing(InputKind::Goal, 4, {0.0, 0.0}), placing(InputKind::Goal, -1, {1e12, 0.0})}) {
      QVERIFY(world->step({order}));
      QCOMPARE(world->refused().size(), std::size_t{1});
      QVERIFY(world->frame().inputs.empty());
    }
    QCOMPARE(ofKind(advance(*world, 160), EventKind::Arrived).size(), std::size_t{1});
    QVERIFY(world->frame().robots.y[0] < -1.0);  // at its own goal
  }

  void step_personAdded_isACopyWithAnIdOfItsOwn() {
    const auto world = make(twoRooms());
    advance(*world, 5);
    Input add = placing(InputKind::Add, 0, {1.0, -2.0});
    add.name = "person7";
    QVERIFY(world->step({add}));
    const Frame& frame = world->frame();
    QCOMPARE(frame.humans.id.back(), 8);
    QCOMPARE(frame.inputs.front().id, 8);
    QCOMPARE(frame.events.front().kind, EventKind::Enter);
    QCOMPARE(world->view().constants(2).name, std::string("person7_8"));
    QCOMPARE(world->view().copiedFrom(2), 1);
    add.name = "person7_8";
    add.pose.position = {1.0, 0.0};
    QVERIFY(world->step({add}));
    QCOMPARE(world->view().copiedFrom(3), 1);
    advance(*world, 300);
    QVERIFY((positionOf(world->frame(), 2) - Vec2(3.0, 0.5)).norm() < 1.5);
    QCOMPARE(world->header().humans.size(), std::size_t{4});
  }

  void step_personAddedAfterTheLastId_isRefused() {
    Scenario scenario;
    addPerson(scenario, std::numeric_limits<int>::max(), {0.0, 0.0}, {});
    const auto world = make(scenario);
    Input add = placing(InputKind::Add, 0, {2.0, 0.0});
    add.name = "person" + std::to_string(std::numeric_limits<int>::max());
    QVERIFY(world->step({add}));
    QCOMPARE(world->refused().size(), std::size_t{1});
    QCOMPARE(world->frame().humans.id.size(), std::size_t{1});
  }

  /// A wall from x = 1.5 to 3.5: who is added 0.2 m inside stands before it, in its middle nobody.
  void step_personAddedInAWall_standsBesideIt() {
    Scenario scenario;
    addRoom(scenario, {-5.0, -3.0}, {5.0, 3.0});
    addWall(scenario, {{2.5, -3.0}, {2.5, -0.5}}, 2.0);
    addGoal(scenario, 1, -3.0, 0.5);
    addPerson(scenario, 7, {-3.0, 0.0}, {1});
    const auto world = make(scenario);
    Input add = placing(InputKind::Add, 0, {1.7, -2.0});
    add.name = "person7";
    QVERIFY(world->step({add}));
    const Input taken = world->frame().inputs.front();
    QVERIFY(taken.pose.position.x() < 1.3 && taken.pose.position.x() > 0.7);
    // As it was taken it is repeated.
    const auto again = make(scenario);
    QVERIFY(again->step({taken}));
    QCOMPARE(again->frame().inputs.front().pose.position, taken.pose.position);
    QCOMPARE(positionOf(again->frame(), 1), positionOf(world->frame(), 1));
    add.pose.position = {2.5, -1.8};
    QVERIFY(world->step({add}));
    QCOMPARE(world->refused().size(), std::size_t{1});
  }

  void step_personSet_movesAsTold() {
    const auto world = make(twoRooms());
    Input set = placing(InputKind::Set, 4, {-4.0, -2.0});
    set.velocity = {1.0, 0.0};
    set.desiredVelocity = {0.0, 2.0};
    QVERIFY(world->step({set}));
    QVERIFY((positionOf(world->frame(), 0) - Vec2(-4.0, -1.9)).norm() < 1e-12);
    QCOMPARE(world->frame().humans.vy[0], 2.0);
    advance(*world, 100);
    QVERIFY((positionOf(world->frame(), 0) - Vec2(-3.0, 0.5)).norm() < 0.5);  // again by itself
  }

  void step_personPushed_leavesTheWay() {
    const auto pushed = make(twoRooms());
    const auto other = make(twoRooms());
    const Input push = inputOf(InputKind::Push, 7, {0.0, 1.0});
    QVERIFY(pushed->step({push}));
    QVERIFY(other->step());
    QCOMPARE(positionOf(pushed->frame(), 1).y() - positionOf(other->frame(), 1).y(), 0.05);
    QCOMPARE(positionOf(pushed->frame(), 0), positionOf(other->frame(), 0));
  }

  /// The push is the velocity of one step; from then on the person slows down by the own model.
  void step_personPushed_slowsDownByItself() {
    Scenario scenario;
    addPerson(scenario, 3, {0.0, 0.0}, {});
    const auto world = make(scenario);
    QVERIFY(world->step({inputOf(InputKind::Stop, 3)}));  // brakes instead of standing fixed
    const Input push = inputOf(InputKind::Push, 3, {2.0, 0.0});
    QVERIFY(world->step({push}));
    QVERIFY(std::fabs(world->frame().humans.vx[0] - 2.0) < 1e-9);
    double before = 2.0;
    for (int k = 0; k < 20; ++k) {
      QVERIFY(world->step());
      QVERIFY(world->frame().humans.vx[0] < before);
      before = world->frame().humans.vx[0];
    }
  }

  void step_personStopped_staysUntilResumed() {
    const auto world = make(twoRooms());
    advance(*world, 20);
    QVERIFY(std::hypot(world->frame().humans.vx[1], world->frame().humans.vy[1]) > 0.3);
    QVERIFY(world->step({inputOf(InputKind::Stop, 7)}));
    advance(*world, 100);
    const Vec2 there = positionOf(world->frame(), 1);
    QVERIFY(std::hypot(world->frame().humans.vx[1], world->frame().humans.vy[1]) < 0.1);
    advance(*world, 40);
    QVERIFY((positionOf(world->frame(), 1) - there).norm() < 0.2);
    QVERIFY(world->step({inputOf(InputKind::Resume, 7)}));
    const auto reached = ofKind(advance(*world, 200), EventKind::Goal);
    QVERIFY(std::any_of(reached.begin(), reached.end(),
                        [](const Recorded& recorded) { return recorded.event.id == 7; }));
  }

  void step_entryWithoutTrees_isRefused() {
    const auto world = make(twoRooms());
    Input entry = naming(InputKind::Entry, "speed=2");
    entry.id = 7;
    Input noValue = naming(InputKind::Entry, "speed");
    noValue.id = 7;
    QVERIFY(world->step({entry, noValue}));
    QCOMPARE(world->refused().size(), std::size_t{2});
    QVERIFY(world->frame().inputs.empty());
  }

  void step_impossibleInputs_areRefusedAndNotRecorded() {
    const auto world = make(twoRooms());
    Input nowhere = placing(InputKind::Move, 4, {std::nan(""), 0.0});
    Input again = placing(InputKind::Add, 7, {-1.0, 0.0});
    again.name = "person4";
    const StepInputs inputs = {nowhere,
                               again,
                               placing(InputKind::Move, 5, {0.0, 0.0}),
                               inputOf(InputKind::Robot, -2),
                               naming(InputKind::Open, "gate"),
                               naming(InputKind::Add, "nobody")};
    QVERIFY(world->step(inputs));
    QCOMPARE(world->refused().size(), inputs.size());
    QVERIFY(world->frame().inputs.empty());
    const auto other = make(twoRooms());
    QVERIFY(other->step());
    QVERIFY(world->frame().humans == other->frame().humans);
    QVERIFY(world->step());
    QVERIFY(world->refused().empty());
  }

  void step_recordedInputs_giveTheSameBytes() {
    std::map<std::int64_t, StepInputs> script;
    Input add = placing(InputKind::Add, 0, {-2.0, -2.0});
    add.name = "person4";
    const Input push = inputOf(InputKind::Push, 7, {-0.3, 1.0 / 3.0});
    Input drive = inputOf(InputKind::Robot, -1, {0.7, 0.0});
    drive.omega = -0.9;
    script[1] = {add};
    script[10] = {push, drive, naming(InputKind::Open, "door1")};
    script[30] = {inputOf(InputKind::Stop, 7)};
    script[50] = {inputOf(InputKind::Resume, 7)};
    script[60] = {placing(InputKind::Move, 8, {2.0, 1.0 / 7.0}), naming(InputKind::Close, "door1")};
    script[90] = {placing(InputKind::Set, 4, {-1.0, -2.0}),
                  placing(InputKind::Move, -1, {2.0, 1.0 / 3.0})};
    script[100] = {placing(InputKind::Goal, -1, {4.0, 1.0 / 3.0})};
    const auto record = [](const std::map<std::int64_t, StepInputs>& inputs, std::string& rows) {
      const auto world = make(twoRooms());
      Recording recording;
      recording.append(world->frame());
      for (std::int64_t step = 1; step <= 200; ++step) {
        const auto now = inputs.find(step);
        world->step(now != inputs.end() ? now->second : StepInputs{});
        for (const Input& input : world->frame().inputs) {
          appendInputRow(rows, step, input);
        }
        recording.append(world->frame());
      }
      const Trace trace = recording.trace(world->header());
      return trajectoryCsv(trace) + eventsCsv(trace) + traceJson(trace.header);
    };
    std::string rows = inputsHeader();
    const std::string first = record(script, rows);
    const base::Result<RecordedInputs> read = parseInputs(rows, "inputs.csv");
    QVERIFY(read);
    QCOMPARE(read->size(), std::size_t{11});
    std::map<std::int64_t, StepInputs> replayed;
    for (const auto& [step, input] : *read) {
      replayed[step].push_back(input);
    }
    std::string again = inputsHeader();
    QVERIFY(record(replayed, again) == first);
    QCOMPARE(QString::fromStdString(again), QString::fromStdString(rows));
    std::string none;
    QVERIFY(record({}, none) != first);
  }
};

QTEST_APPLESS_MAIN(WorldInputsTest)
#include "tst_WorldInputs.moc"
