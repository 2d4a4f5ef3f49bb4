#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "sim2d/nav/FootprintGap.h"
#include "sim2d/world/YieldModel.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

constexpr double kRobotRadius = 0.35;

Scenario byModel(const std::string& model) {
  Scenario scenario;
  scenario.desktop.model = model;
  return scenario;
}

/// Without a goal.
Robot& park(Scenario& scenario, const Vec2& place, double heading = 0.0) {
  Robot& robot = addRobot(scenario, place, Vec2::Zero());
  robot.goal.point.reset();
  robot.start.heading = heading;
  robot.radius = kRobotRadius;
  return robot;
}

StepInputs driving(double speed, int id = -1) {
  return {inputOf(InputKind::Robot, id, {speed, 0.0})};
}

/// Of a contact: who, and on which side of the robot.
std::string faultOf(const Event& event) {
  const std::size_t blank = event.text.find(' ');
  return blank == std::string::npos ? "" : event.text.substr(blank + 1);
}

double closingOf(const Event& event) {
  return base::parseDouble(event.text.substr(0, event.text.find(' '))).value_or(-1.0);
}

struct Met {
  std::vector<Event> contacts;  // of robots with people
  bool arrived = false;         // the first person
  int replans = 0;
  double leastGap = 1e9;  // [m], of the first person
};

using Inputs = std::function<StepInputs(const Frame&)>;

Met walk(World& world, double seconds, const Inputs& inputs = {}) {
  Met met;
  const Footprint disc{kRobotRadius, {}};
  const double radius = world.view().humanCount() > 0 ? world.view().constants(0).radius : 0.0;
  for (int i = 0; i < std::lround(seconds / 0.05); ++i) {
    if (!world.step(inputs ? inputs(world.frame()) : StepInputs{})) {
      break;
    }
    const Frame& frame = world.frame();
    for (const Event& event : frame.events) {
      if (event.kind == EventKind::Contact && event.id < 0 && event.hasOther) {
        met.contacts.push_back(event);
      }
      met.arrived = met.arrived || (event.kind == EventKind::Arrived && event.id == 1);
      met.replans += event.kind == EventKind::Replan && event.id == 1 ? 1 : 0;
    }
    if (frame.humans.size() > 0 && frame.robots.size() > 0) {
      met.leastGap = std::min(
          met.leastGap, gapToDisc(disc, {robotPosition(frame), 0.0}, positionOf(frame, 0), radius));
    }
  }
  return met;
}

QByteArray told(const Met& met) {
  QByteArray text = "arrived " + QByteArray::number(met.arrived) + ", least gap " +
                    QByteArray::number(met.leastGap) + ", contacts";
  for (const Event& event : met.contacts) {
    text += " [" + QByteArray::fromStdString(event.text) + "]";
  }
  return text;
}

/// A wall across x = 5 with openings of `width` about the given places.
void addWallWithDoors(Scenario& scenario, const std::vector<double>& doors, double width) {
  double from = -8.0;
  for (const double door : doors) {
    addWall(scenario, {Vec2(5.0, from), Vec2(5.0, door - width / 2.0)});
    from = door + width / 2.0;
  }
  addWall(scenario, {Vec2(5.0, from), Vec2(5.0, 10.0)});
}

}  // namespace

/// By every model but the original's, people walk round robots or wait for them, and do not run
/// into them.
class PeopleAndRobotsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  /// Reaction at full speed, then braking: v t + v² / (2 a) is the room.
  void closingSpeed_leavesRoomToStop() {
    for (const double speed : {0.1, 0.5, 1.0, 1.5, 2.0}) {
      const double room = speed * 0.3 + speed * speed / (2.0 * 1.5);
      QVERIFY(std::fabs(maxClosingSpeed(room) - speed) < 1e-9);
    }
    QCOMPARE(maxClosingSpeed(0.0), 0.0);
    QVERIFY(std::fabs(maxClosingSpeed(-0.05) + 0.1) < 1e-9);
    QCOMPARE(maxClosingSpeed(-1.0), -0.3);
  }

  void parkedRobot_onTheLine_isPassedWithRoom_data() { addModels(); }

  void parkedRobot_onTheLine_isPassedWithRoom() {
    QFETCH(QString, model);
    for (const double beside : {0.0, 0.2, -0.5}) {
      Scenario scenario = byModel(model.toStdString());
      addGoal(scenario, 1, 10.0, 0.0);
      addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
      park(scenario, Vec2(5.0, beside), 2.0);
      const auto world = make(scenario);
      const Met met = walk(*world, 12.0);
      QVERIFY2(met.arrived && met.contacts.empty() && met.leastGap >= 0.1, told(met));
    }
  }

  void parkedRobot_onTheGoal_isNotTouched_data() { addModels(); }

  void parkedRobot_onTheGoal_isNotTouched() {
    QFETCH(QString, model);
    Scenario scenario = byModel(model.toStdString());
    addGoal(scenario, 1, 5.1, 0.1);
    addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
    park(scenario, Vec2(5.0, 0.0));
    const auto world = make(scenario);
    const Met met = walk(*world, 20.0);
    QVERIFY2(met.contacts.empty() && met.leastGap > 0.02, told(met));
    QVERIFY2((positionOf(world->frame(), 0) - Vec2(5.0, 0.0)).norm() < 2.5, told(met));
  }

  void parkedRobot_longFootprint_isPassed_data() { addModels(); }

  void parkedRobot_longFootprint_isPassed() {
    QFETCH(QString, model);
    for (const double heading : {0.0, 0.7, 1.57, 2.5}) {
      Scenario scenario = byModel(model.toStdString());
      addGoal(scenario, 1, 10.0, 0.0);
      addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
      Robot& robot = park(scenario, Vec2(5.0, 0.3), heading);
      robot.footprintX = {-0.4, 1.6, 1.6, -0.4};
      robot.footprintY = {-0.3, -0.3, 0.3, 0.3};
      const auto world = make(scenario);
      const Met met = walk(*world, 14.0);
      QVERIFY2(met.arrived && met.contacts.empty(), told(met));
    }
  }

  void robotInDoorway_isWaitedFor_data() { addModels(); }

  /// The door is wide enough for one. The robot leaves after 12 s, and the person goes on.
  void robotInDoorway_isWaitedFor() {
    QFETCH(QString, model);
    Scenario scenario = byModel(model.toStdString());
    addWallWithDoors(scenario, {0.0}, 1.1);
    addGoal(scenario, 1, 9.0, 4.0);
    addPerson(scenario, 1, Vec2(1.0, 0.0), {1});
    park(scenario, Vec2(5.0, 0.0));
    const auto world = make(scenario);
    const Met waited = walk(*world, 12.0);
    QVERIFY2(!waited.arrived && waited.contacts.empty(), told(waited));
    QVERIFY((robotPosition(world->frame()) - Vec2(5.0, 0.0)).norm() < 1e-9);
    QVERIFY(positionOf(world->frame(), 0).x() < 4.9 && positionOf(world->frame(), 0).x() > 2.0);
    const Met gone = walk(*world, 16.0, [](const Frame& frame) {
      return robotPosition(frame).x() < 8.0 ? driving(0.8) : StepInputs{};
    });
    QVERIFY2(gone.arrived && gone.contacts.empty(), told(gone));
  }

  void robotInDoorway_otherWay_isTaken_data() { addModels(); }

  void robotInDoorway_otherWay_isTaken() {
    QFETCH(QString, model);
    Scenario scenario = byModel(model.toStdString());
    addWallWithDoors(scenario, {0.0, 6.0}, 1.1);
    addRoom(scenario, Vec2(-1.0, -8.0), Vec2(11.0, 10.0));
    addGoal(scenario, 1, 9.0, 0.0);
    addPerson(scenario, 1, Vec2(1.0, 0.0), {1});
    park(scenario, Vec2(5.0, 0.0));
    const auto world = make(scenario);
    double mostY = 0.0;
    const Met met = walk(*world, 30.0, [&](const Frame& frame) {
      mostY = std::max(mostY, positionOf(frame, 0).y());
      return StepInputs{};
    });
    QVERIFY2(met.arrived && met.contacts.empty(), told(met));
    QVERIFY(mostY > 5.4);
    QVERIFY2(met.replans >= 1 && met.replans <= 5, QByteArray::number(met.replans));
  }

  void robotComesThroughDoorway_isLetThrough_data() { addModels(); }

  /// A robot that stops before people is let through by somebody who wants to come the other way.
  void robotComesThroughDoorway_isLetThrough() {
    QFETCH(QString, model);
    Scenario scenario = byModel(model.toStdString());
    addWallWithDoors(scenario, {0.0}, 1.1);
    addGoal(scenario, 1, 9.0, 0.0);
    addPerson(scenario, 1, Vec2(1.0, 0.0), {1});
    addRobot(scenario, Vec2(6.0, 0.0), Vec2(0.0, -3.0)).start.heading = base::kPi;
    const auto world = make(scenario);
    const Met met = walk(*world, 40.0);
    QVERIFY2(met.arrived && met.contacts.empty(), told(met));
    QVERIFY(world->arrivedAt().has_value());
  }

  void crossingRobot_inView_isNotTouched_data() {
    QTest::addColumn<QString>("model");
    QTest::addColumn<double>("ahead");  // the robot is at the crossing before the person [s]
    for (const std::string& name : builtinRegistries().models.names()) {
      for (const int tenths : {-8, -4, 0, 4, 8}) {
        if (name != "sfm-hunav2") {
          QTest::addRow("%s %d", name.c_str(), tenths)
              << QString::fromStdString(name) << 0.1 * tenths;
        }
      }
    }
  }

  /// It does not look itself. The person walks at 1 m/s.
  void crossingRobot_inView_isNotTouched() {
    QFETCH(QString, model);
    QFETCH(double, ahead);
    Scenario scenario = byModel(model.toStdString());
    addGoal(scenario, 1, 10.0, 0.0);
    addPerson(scenario, 1, Vec2(0.0, 0.0), {1}).maxVel = 1.0;
    park(scenario, Vec2(5.0, -5.0 - 0.5 + ahead), base::kPi / 2.0);
    const auto world = make(scenario);
    const Met met = walk(*world, 16.0, [](const Frame&) { return driving(1.0); });
    QVERIFY2(met.arrived && met.contacts.empty(), told(met));
  }

  void headOn_inACorridor_isPassed_data() { addModels(); }

  /// A corridor of 2 m, in which the robot drives straight on at 1 m/s, half a metre off its
  /// middle.
  void headOn_inACorridor_isPassed() {
    QFETCH(QString, model);
    Scenario scenario = byModel(model.toStdString());
    addWall(scenario, {Vec2(-2.0, -1.1), Vec2(22.0, -1.1)});
    addWall(scenario, {Vec2(-2.0, 1.1), Vec2(22.0, 1.1)});
    addGoal(scenario, 1, 18.0, 0.0);
    addPerson(scenario, 1, Vec2(0.0, -0.4), {1}).radius = 0.3;
    park(scenario, Vec2(14.0, -0.5), base::kPi);
    const auto world = make(scenario);
    const Met met = walk(*world, 20.0, [](const Frame& frame) {
      return robotPosition(frame).x() > 0.0 ? driving(1.0) : StepInputs{};
    });
    QVERIFY2(met.arrived && met.contacts.empty(), told(met));
  }

  void crowd_pastAParkedRobot_doesNotTouchIt_data() { addModels(); }

  void crowd_pastAParkedRobot_doesNotTouchIt() {
    QFETCH(QString, model);
    Scenario scenario = byModel(model.toStdString());
    addWall(scenario, {Vec2(-8.0, -3.1), Vec2(24.0, -3.1)});
    addWall(scenario, {Vec2(-8.0, 3.1), Vec2(24.0, 3.1)});
    for (int i = 0; i < 20; ++i) {
      const int row = i / 4;
      const double y = -2.1 + 1.4 * (i % 4) + 0.1 * (row % 3);
      addGoal(scenario, i + 1, 20.0, y);
      addPerson(scenario, i + 1, Vec2(-6.0 + 1.3 * row, y), {i + 1}).radius = 0.3;
      scenario.humans.back().maxVel = 1.0 + 0.05 * (i % 7);
      scenario.humans.back().goalRadius = 1.0;
    }
    park(scenario, Vec2(6.0, 0.2));
    const auto world = make(scenario);
    const Met met = walk(*world, 40.0);
    QVERIFY2(met.contacts.empty(), told(met));
    for (std::size_t i = 0; i < world->frame().humans.size(); ++i) {
      QVERIFY2(world->frame().humans.x[i] > 15.0, QByteArray::number(world->frame().humans.x[i]));
    }
  }

  void fastRobot_fromBehindACorner_isAtFault_data() { addModels(); }

  /// At 5 m/s, behind a block until a moment before. Some of those who come to the corner in time
  /// to meet it cannot stop.
  void fastRobot_fromBehindACorner_isAtFault() {
    QFETCH(QString, model);
    int touched = 0;
    for (int tenths = 0; tenths < 30; ++tenths) {
      Scenario scenario = byModel(model.toStdString());
      addWall(scenario, {Vec2(3.0, -1.12), Vec2(4.9, -1.12)}, 1.4);
      addWall(scenario, {Vec2(4.4, -16.0), Vec2(4.4, -1.2)}, 1.0);
      addGoal(scenario, 1, 10.0, 0.0);
      addPerson(scenario, 1, Vec2(3.0, 0.0), {1}).maxVel = 1.0;
      Robot& robot = park(scenario, Vec2(5.27, -13.0 + 0.2 * tenths), base::kPi / 2.0);
      robot.maxVel = 5.0;
      robot.maxAcc = 100.0;
      const auto world = make(scenario);
      const Met met = walk(*world, 3.5, [](const Frame&) { return driving(5.0); });
      for (const Event& event : met.contacts) {
        QVERIFY2(faultOf(event).rfind("robot ", 0) == 0, told(met));
        ++touched;
      }
    }
    QVERIFY(touched > 0);
  }

  /// It catches up with somebody who does not look back.
  void robot_fromBehind_isAtFault() {
    Scenario scenario = byModel("sfm");
    addGoal(scenario, 1, 30.0, 0.0);
    addPerson(scenario, 1, Vec2(3.0, 0.0), {1}).maxVel = 0.5;
    scenario.humans.back().behavior.configuration = Configuration::Custom;
    scenario.humans.back().behavior.socialForceFactor = 0.0;
    park(scenario, Vec2(0.0, 0.0));
    const auto world = make(scenario);
    const Met met = walk(*world, 10.0, [](const Frame&) { return driving(1.0); });
    QVERIFY2(!met.contacts.empty(), told(met));
    QCOMPARE(faultOf(met.contacts[0]), std::string("robot ahead"));
    QVERIFY(std::fabs(closingOf(met.contacts[0]) - 0.5) < 0.1);  // 1 less 0.5
  }

  void blindPerson_intoARobot_isAtFault_data() {
    QTest::addColumn<double>("heading");  // of the robot; the person comes from -x
    QTest::addColumn<QString>("side");
    QTest::newRow("ahead") << base::kPi << QStringLiteral("ahead");
    QTest::newRow("left") << -base::kPi / 2.0 + 0.2 << QStringLiteral("right");
    QTest::newRow("right") << base::kPi / 2.0 << QStringLiteral("left");
    QTest::newRow("behind") << 0.1 << QStringLiteral("behind");
  }

  /// By the original's model, without social forces.
  void blindPerson_intoARobot_isAtFault() {
    QFETCH(double, heading);
    QFETCH(QString, side);
    Scenario scenario = byModel("sfm-hunav2");
    addGoal(scenario, 1, 8.0, 0.0);
    addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
    scenario.humans.back().behavior.configuration = Configuration::Custom;
    scenario.humans.back().behavior.socialForceFactor = 0.0;
    park(scenario, Vec2(4.0, 0.0), heading);
    const auto world = make(scenario);
    const Met met = walk(*world, 4.0);
    QVERIFY(!met.contacts.empty());
    QCOMPARE(faultOf(met.contacts[0]), "person " + side.toStdString());
    QVERIFY(std::fabs(closingOf(met.contacts[0]) - 1.5) < 0.05);
  }

  void twoRobots_fault_isOfTheFasterOne() {
    Scenario scenario;
    park(scenario, Vec2(0.0, 0.0));
    park(scenario, Vec2(3.0, 0.0), base::kPi);
    const auto world = make(scenario);
    const Met met = walk(*world, 6.0, [](const Frame&) {
      StepInputs inputs = driving(0.2, -1);
      inputs.push_back(driving(0.8, -2)[0]);
      return inputs;
    });
    QVERIFY(!met.contacts.empty());
    QCOMPARE(met.contacts[0].id, -1);
    QCOMPARE(met.contacts[0].other, -2);
    QCOMPARE(faultOf(met.contacts[0]), std::string("other ahead"));
  }

  /// The original's model and its quirks know nothing of all that: who walks straight at a robot
  /// touches it.
  void originalModel_walksAsBefore() {
    for (const bool isCompat : {false, true}) {
      Scenario scenario = byModel(isCompat ? "sfm" : "sfm-hunav2");
      addGoal(scenario, 1, 8.0, 0.0);
      addPerson(scenario, 1, Vec2(0.0, 0.0), {1});
      scenario.humans.back().behavior.configuration = Configuration::Custom;
      scenario.humans.back().behavior.socialForceFactor = 0.0;
      park(scenario, Vec2(4.0, 0.0));
      WorldSetup setup = setupOf(scenario);
      if (isCompat) {
        setup.compatibility = *Compatibility::parse("hunav2");
      }
      const auto world = make(std::move(setup));
      const Met met = walk(*world, 4.0);
      QVERIFY(!met.contacts.empty());
      QCOMPARE(faultOf(met.contacts[0]).empty(), isCompat);
    }
  }

 private:
  static void addModels() {
    QTest::addColumn<QString>("model");
    for (const std::string& name : builtinRegistries().models.names()) {
      if (name != "sfm-hunav2") {
        QTest::newRow(name.c_str()) << QString::fromStdString(name);
      }
    }
  }
};

QTEST_APPLESS_MAIN(PeopleAndRobotsTest)
#include "tst_PeopleAndRobots.moc"
