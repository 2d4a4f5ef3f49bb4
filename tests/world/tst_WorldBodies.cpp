#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/base/Rng.h"
#include "sim2d/base/Text.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

void makeBlind(Human& human) {  // no social force: runs into people
  human.behavior.configuration = Configuration::Custom;
  human.behavior.socialForceFactor = 0.0;
  human.behavior.obstacleForceFactor = 0.0;
  human.behavior.goalForceFactor = 2.0;
}

/// Distance from the point to the walls of the room (-6..6)^2 of thickness 0.2; negative in them.
double roomLeft(const Vec2& point) {
  return 5.9 - point.cwiseAbs().maxCoeff();
}

}  // namespace

class WorldBodiesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void people_exactlyHeadOn_passWithoutStopping() {
    Scenario scenario;
    addGoal(scenario, 1, 8.0, 0.0);
    addGoal(scenario, 2, -8.0, 0.0);
    addPerson(scenario, 1, Vec2(-4.0, 0.0), {1});
    addPerson(scenario, 2, Vec2(4.0, 0.0), {2}, base::kPi);
    const auto world = make(scenario);
    double least = 1e9;
    double slowest = 1e9;
    const std::vector<Recorded> events = advance(*world, 300, [&](const Frame& frame) {
      least = std::min(least, (positionOf(frame, 0) - positionOf(frame, 1)).norm());
      const bool isOnTheWay = frame.step > 20 && positionOf(frame, 0).x() < 6.0;
      slowest = isOnTheWay ? std::min(slowest, speedOf(frame, 0)) : slowest;
    });
    QVERIFY2(least >= 0.8, qPrintable(QString::number(least)));
    QVERIFY(slowest > 0.2);
    QCOMPARE(ofKind(events, EventKind::Goal).size(), std::size_t{2});
  }

  void people_inARoomCrossing_neverOverlap() {
    Scenario scenario;
    addRoom(scenario, Vec2(-6.0, -6.0), Vec2(6.0, 6.0));
    for (int i = 0; i < 12; ++i) {
      addGoal(scenario, i + 1, 4.5 * std::cos(i * base::kPi / 6.0),
              4.5 * std::sin(i * base::kPi / 6.0));
    }
    for (int i = 0; i < 36; ++i) {
      const int row = i / 6;
      const Vec2 start(-5.0 + 2.0 * (i % 6), -5.0 + 2.0 * row);
      addPerson(scenario, i, start, {(i * 5) % 12 + 1, (i * 7 + 6) % 12 + 1}).cyclicGoals = true;
    }
    const auto world = make(scenario);
    double deepest = 0.0;
    double leastRoom = 1e9;
    advance(*world, 600, [&](const Frame& frame) {
      deepest = std::max(deepest, deepestOverlap(frame, 0.4));
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        leastRoom = std::min(leastRoom, roomLeft(positionOf(frame, i)));
      }
    });
    QVERIFY(deepest <= 0.05);
    QVERIFY(leastRoom >= 0.4 - 0.05);
  }

  void people_walkingAtRandom_stayOutOfWalls() {
    Scenario scenario;
    addRoom(scenario, Vec2(-6.0, -6.0), Vec2(6.0, 6.0));
    addWall(scenario, {Vec2(-3.0, 0.0), Vec2(3.0, 0.0), Vec2(3.0, 3.0)}, 0.1);
    for (int i = 0; i < 25; ++i) {
      const int row = i / 5;
      makeBlind(addPerson(scenario, i, Vec2(-4.4 + 2.2 * (i % 5), -5.0 + 2.45 * row)));
      scenario.humans.back().maxVel = 2.0;
      scenario.humans.back().ours.route = Route::Direct;
    }
    const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
      for (int human = 0; human < view.humanCount(); ++human) {
        const auto second = static_cast<std::uint64_t>(view.step() / 20);
        const base::AgentRng rng(view.seed(), human, second);
        Intent& intent = intents.of(human);
        intent.motion = Motion::Walk;
        intent.speed = 2.0;
        intent.target.position = Vec2(rng.uniform(-20.0, 20.0, base::DrawPurpose::Test, 0),
                                      rng.uniform(-20.0, 20.0, base::DrawPurpose::Test, 1));
      }
    });
    double leastRoom = 1e9;
    double deepest = 0.0;
    int crossings = 0;
    std::vector<Vec2> before;
    advance(*world, 1200, [&](const Frame& frame) {
      deepest = std::max(deepest, deepestOverlap(frame, 0.4));
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        const Vec2 place = positionOf(frame, i);
        leastRoom = std::min(leastRoom, roomLeft(place));
        if (before.size() > i && std::fabs(place.x()) < 2.8 &&
            (before[i].y() > 0.0) != (place.y() > 0.0)) {
          ++crossings;
        }
      }
      before.clear();
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        before.push_back(positionOf(frame, i));
      }
    });
    QVERIFY(leastRoom >= 0.4 - 0.05);
    QVERIFY(deepest <= 0.05);
    QCOMPARE(crossings, 0);
  }

  void people_startingInEachOther_arePushedApart() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(0.0, 0.0));
    addPerson(scenario, 2, Vec2(0.1, 0.0));
    addPerson(scenario, 3, Vec2(0.1, 0.0));
    base::Result<std::unique_ptr<World>> world = create(scenario);
    QVERIFY(world);
    QVERIFY(world.diagnostics().size() >= 2);
    advance(**world, 60);
    QVERIFY(deepestOverlap((*world)->frame(), 0.4) <= 0.05);
  }

  void people_pressedIntoACorner_doNotOverlap() {
    Scenario scenario;
    addRoom(scenario, Vec2(-6.0, -6.0), Vec2(6.0, 6.0));
    addGoal(scenario, 1, 5.4, 5.4);
    for (int i = 0; i < 20; ++i) {
      const int row = i / 5;
      makeBlind(addPerson(scenario, i, Vec2(-5.0 + 2.0 * (i % 5), -4.0 + 2.0 * row), {1}));
      scenario.humans.back().goalRadius = 0.05;
    }
    const auto world = make(scenario);
    double deepest = 0.0;
    double leastRoom = 1e9;
    advance(*world, 500, [&](const Frame& frame) {
      deepest = std::max(deepest, deepestOverlap(frame, 0.4));
      for (std::size_t i = 0; i < frame.humans.size(); ++i) {
        leastRoom = std::min(leastRoom, roomLeft(positionOf(frame, i)));
      }
    });
    QVERIFY(deepest <= 0.05);
    QVERIFY(leastRoom >= 0.4 - 0.05);
  }

  void contact_walkIntoAStandingPerson_isOneEventWithClosingSpeed() {
    Scenario scenario;
    addGoal(scenario, 1, 6.0, 0.0);
    makeBlind(addPerson(scenario, 5, Vec2(0.0, 0.0), {1}));
    addPerson(scenario, 2, Vec2(3.0, 0.0));
    const auto world = make(
        scenario, [](const WorldView&, Intents& intents) { intents.of(0).motion = Motion::Stand; });
    const std::vector<Recorded> contacts = ofKind(advance(*world, 80), EventKind::Contact);
    QCOMPARE(contacts.size(), std::size_t{1});
    QCOMPARE(contacts[0].event.id, 2);
    QCOMPARE(contacts[0].event.other, 5);
    const std::optional<double> speed = base::parseDouble(contacts[0].event.text);
    QVERIFY(speed && std::fabs(*speed - 1.5) < 0.05);
  }

  void contact_walkIntoAWall_namesTheObstacle() {
    Scenario scenario;
    addWall(scenario, {Vec2(3.0, -2.0), Vec2(3.0, 2.0)});
    addGoal(scenario, 1, 6.0, 0.0);
    makeBlind(addPerson(scenario, 1, Vec2(0.0, 0.0), {1}));
    scenario.humans[0].ours.route = Route::Direct;
    const auto world = make(scenario);
    const std::vector<Recorded> contacts = ofKind(advance(*world, 200), EventKind::Contact);
    QCOMPARE(contacts.size(), std::size_t{1});
    QVERIFY(!contacts[0].event.hasOther);
    QVERIFY(contacts[0].event.text.find(" wall1") != std::string::npos);
    QVERIFY(std::fabs(world->frame().humans.x[0] - 2.5) < 0.01);
  }

  void contact_partedAndAgain_isASecondEvent() {
    Scenario scenario;
    addWall(scenario, {Vec2(3.0, -2.0), Vec2(3.0, 2.0)});
    makeBlind(addPerson(scenario, 1, Vec2(1.0, 0.0)));
    const auto world = make(scenario, [](const WorldView& view, Intents& intents) {
      Intent& intent = intents.of(0);
      intent.motion = Motion::Walk;
      intent.speed = 1.0;
      const bool isForth = view.step() % 100 < 60;
      intent.target.position = Vec2(isForth ? 2.8 : 0.0, 0.0);
      intent.target.radius = 0.05;
    });
    const std::vector<Recorded> contacts = ofKind(advance(*world, 160), EventKind::Contact);
    QCOMPARE(contacts.size(), std::size_t{2});
  }

  void robot_drivesIntoAPerson_doesNotOverlap() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(2.0, 0.05));
    Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2(6.0, 0.0));
    robot.plannerParameters = {{"slow_distance", "0.0"}, {"stop_distance", "0.0"}};
    robot.maxVel = 1.5;
    const auto world = make(
        scenario, [](const WorldView&, Intents& intents) { intents.of(0).motion = Motion::Stand; });
    double least = 1e9;
    const std::vector<Recorded> events = advance(*world, 200, [&](const Frame& frame) {
      least = std::min(least, (positionOf(frame, 0) - robotPosition(frame)).norm());
    });
    QVERIFY(least >= 0.75 - 0.02);
    const std::vector<Recorded> contacts = ofKind(events, EventKind::Contact);
    QVERIFY(!contacts.empty());
    QCOMPARE(contacts[0].event.id, -1);
    QCOMPARE(contacts[0].event.other, 1);
  }

  void robot_polygonIntoAWall_staysOutside() {
    Scenario scenario;
    addWall(scenario, {Vec2(3.0, -4.0), Vec2(3.0, 4.0)});
    Robot& robot = addRobot(scenario, Vec2(0.0, 0.0), Vec2(2.2, 1.0));
    robot.footprintX = {-0.4, 0.4, 0.4, 0.0, -0.4};
    robot.footprintY = {-0.2, -0.2, 0.2, 0.1, 0.2};  // not convex
    const auto world = make(scenario);
    double mostX = 0.0;
    advance(*world, 200, [&](const Frame& frame) {
      const Pose2 pose{robotPosition(frame), frame.robots.heading[0]};
      for (const Vec2& corner : {Vec2(0.4, -0.2), Vec2(0.4, 0.2)}) {
        mostX = std::max(mostX, pose.toWorld(corner).x());
      }
    });
    QVERIFY(mostX <= 2.9 + 0.03);
    QVERIFY(world->arrivedAt().has_value());
  }

  void social_behindAWall_isNotFelt() {
    Scenario scenario;
    addWall(scenario, {Vec2(1.0, -3.0), Vec2(1.0, 3.0)});
    addPerson(scenario, 1, Vec2(0.0, 0.0));
    addPerson(scenario, 2, Vec2(2.0, 0.0));
    addPerson(scenario, 3, Vec2(-1.5, 0.0));
    const auto world = make(scenario);
    advance(*world, 1);
    QVERIFY(world->frame().forces.social[1].isZero(0.0));
    QVERIFY(world->frame().forces.social[0].x() > 0.0);
    QVERIFY(!world->view().isVisible(Vec2(0.0, 0.0), Vec2(2.0, 0.0)));
  }

  void robot_asObstacle_pushesByItsNearestPoint() {
    Scenario scenario;
    addPerson(scenario, 1, Vec2(0.0, 0.0));
    Robot robot;
    robot.name = "robot1";
    robot.start.position = Vec2(1.35, 0.0);  // disc of 0.35: 1 m away
    scenario.robots.push_back(robot);
    const auto world = make(scenario, [](const WorldView&, Intents& intents) {
      intents.of(0).robot = RobotTreatment::Obstacle;
    });
    advance(*world, 1);
    QVERIFY(world->frame().forces.social[0].isZero(0.0));
    QVERIFY(std::fabs(world->frame().forces.obstacle[0].x() + 0.497871) < 1e-6);
    QVERIFY(!world->arrivedAt().has_value());
  }
};

QTEST_APPLESS_MAIN(WorldBodiesTest)
#include "tst_WorldBodies.moc"
