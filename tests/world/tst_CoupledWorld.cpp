#include <cmath>
#include <limits>

#include <QtTest>

#include "sim2d/world/CoupledWorld.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

std::unique_ptr<CoupledWorld> couple(Scenario scenario, const std::string& compat = {},
                                     ScriptedBehavior::Change change = {}) {
  WorldSetup setup = setupOf(std::move(scenario), std::move(change));
  if (!compat.empty()) {
    setup.compatibility = *Compatibility::parse(compat);
  }
  base::Result<std::unique_ptr<CoupledWorld>> world = CoupledWorld::create(std::move(setup));
  return world ? *std::move(world) : nullptr;
}

CoupledPerson stateOf(const CoupledWorld& world, int index) {
  CoupledPerson person;
  person.id = world.view().constants(index).id;
  person.pose = world.view().pose(index);
  person.velocity = world.view().velocity(index);
  person.omega = world.omega(index);
  return person;
}

CoupledPerson personAt(int id, const Vec2& place, const Vec2& velocity = Vec2::Zero()) {
  CoupledPerson person;
  person.id = id;
  person.pose.position = place;
  person.velocity = velocity;
  return person;
}

Scenario oneWalker() {
  Scenario scenario;
  addGoal(scenario, 1, 5.0, 0.0);
  addPerson(scenario, 1, Vec2::Zero(), {1});
  return scenario;
}

/// Ten people who cross each other's ways between two walls.
Scenario crossing() {
  Scenario scenario;
  for (int i = 0; i < 10; ++i) {
    const double y = -4.5 + i;
    addGoal(scenario, 2 * i + 1, i % 2 == 0 ? 9.0 : -9.0, -y);
    addGoal(scenario, 2 * i + 2, i % 2 == 0 ? -9.0 : 9.0, y);
    addPerson(scenario, i + 1, Vec2(i % 2 == 0 ? -8.0 : 8.0, y), {2 * i + 1, 2 * i + 2})
        .cyclicGoals = true;
  }
  addWall(scenario, {{-12.0, 7.0}, {12.0, 7.0}});
  addWall(scenario, {{12.0, -7.0}, {-12.0, -7.0}});
  return scenario;
}

}  // namespace

/// People in the world of another simulator.
class CoupledWorldTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  // k_g v0 / tau = 2 · 1.5 / 0.5 = 6 m/s²; the original's step of 0.05 s leads to v 0.3, x 0.015.
  void step_fromRest_isTheGoalForceByHand() {
    const std::unique_ptr<CoupledWorld> world = couple(oneWalker(), "hunav2");
    QVERIFY(world);
    world->take({personAt(1, Vec2::Zero())}, std::nullopt);
    QVERIFY(world->step(0.05));
    QCOMPARE(world->forces().goal.at(0).x(), 6.0);
    QCOMPARE(world->view().velocity(0).x(), 0.3);
    QCOMPARE(world->view().pose(0).position.x(), 0.015);
    QCOMPARE(world->view().pose(0).position.y(), 0.0);
    QCOMPARE(world->time(), 0.05);
  }

  // 10 exp(-(1 - 0.4) / 0.2) = 0.497871 m/s² away from the point 1 m ahead.
  void step_pointOnTheWay_isTheObstacleForceByHand() {
    const std::unique_ptr<CoupledWorld> world = couple(oneWalker(), "hunav2");
    CoupledPerson person = personAt(1, Vec2::Zero());
    person.obstacles = {Vec2(1.0, 0.0), Vec2(1e4, 1e4)};
    world->take({person}, std::nullopt);
    QVERIFY(world->step(0.05));
    QVERIFY(std::fabs(world->forces().obstacle.at(0).x() + 0.497871) < 1e-6);
    person.obstacles = {Vec2(0.3, 0.4), Vec2(-0.6, 0.0)};
    world->take({person}, std::nullopt);
    QVERIFY(world->step(0.05));
    QVERIFY((world->forces().obstacle.at(0) - Vec2(0.039610, -4.852245)).norm() < 1e-6);
  }

  void take_otherPlaces_count() {
    const std::unique_ptr<CoupledWorld> world = couple(oneWalker(), "hunav2");
    world->take({personAt(1, Vec2::Zero())}, std::nullopt);
    QVERIFY(world->step(0.05));
    world->take({personAt(1, Vec2(2.0, 0.0), Vec2(0.5, 0.2))}, std::nullopt);
    QVERIFY(world->step(0.05));
    QVERIFY((world->forces().goal.at(0) - Vec2(4.0, -0.8)).norm() < 0.02 * 4.0);
    QCOMPARE(world->view().pose(0).position.x(),
             2.0 + 0.05 * (0.5 + 0.05 * world->forces().goal.at(0).x()));
  }

  void step_largeDt_movesThatFar() {
    const std::unique_ptr<CoupledWorld> world = couple(oneWalker(), "hunav2");
    world->take({personAt(1, Vec2::Zero())}, std::nullopt);
    QVERIFY(world->step(2.0));  // 12 m/s, held at 1.5
    QCOMPARE(world->view().pose(0).position.x(), 3.0);
  }

  void step_stateGivenBack_isTheHeadlessRun_data() {
    QTest::addColumn<double>("dt");
    QTest::newRow("0.05 s") << 0.05;
    QTest::newRow("0.01 s") << 0.01;
  }

  /// 20 s of the caller's loop: it asks our own world for obstacle points, gives back the states
  /// that it got, and ends where a run alone ends.
  void step_stateGivenBack_isTheHeadlessRun() {
    QFETCH(const double, dt);
    Scenario scenario = crossing();
    scenario.desktop.dt = dt;
    WorldSetup setup = setupOf(scenario);
    setup.compatibility = *Compatibility::parse("hunav2");
    auto alone = make(std::move(setup));
    const std::unique_ptr<CoupledWorld> coupled = couple(scenario, "hunav2");
    std::vector<CoupledPerson> states;
    for (int i = 0; i < 10; ++i) {
      states.push_back(
          personAt(i + 1, scenario.humans[static_cast<std::size_t>(i)].initPose.position));
    }
    const int steps = static_cast<int>(std::lround(20.0 / dt));
    for (int k = 0; k < steps; ++k) {
      for (CoupledPerson& state : states) {
        std::vector<Obstacles::Point> points;
        alone->obstacles().boundaryPoints(state.pose.position, points);
        state.obstacles.clear();
        for (const Obstacles::Point& point : points) {
          state.obstacles.push_back(point.position);
        }
      }
      coupled->take(states, std::nullopt);
      QVERIFY(coupled->step(dt));
      QVERIFY(alone->step());
      for (int i = 0; i < 10; ++i) {
        states[static_cast<std::size_t>(i)] = stateOf(*coupled, i);
      }
    }
    const Frame& frame = alone->frame();
    QVERIFY(std::fabs(frame.humans.x.at(0) + 8.0) > 1.0);  // they did walk
    for (std::size_t i = 0; i < 10; ++i) {
      const Pose2& pose = states[i].pose;
      QVERIFY(std::hypot(pose.position.x() - frame.humans.x[i],
                         pose.position.y() - frame.humans.y[i]) < 1e-6);
      QVERIFY(std::fabs(base::angleDiff(pose.heading, frame.humans.heading[i])) < 1e-6);
    }
  }

  void step_onlyOne_othersRest() {
    Scenario scenario = oneWalker();
    addPerson(scenario, 2, Vec2(0.0, 9.0), {1});
    const std::unique_ptr<CoupledWorld> world = couple(scenario, "hunav2");
    world->take({personAt(1, Vec2::Zero()), personAt(2, Vec2(0.0, 9.0))}, std::nullopt);
    QVERIFY(world->step(0.05, 2));
    QCOMPARE(world->view().pose(0).position.x(), 0.0);
    QVERIFY(world->view().velocity(1).norm() > 0.29);
    QCOMPARE(world->time(), 0.0);
    world->pass(0.05);
    QCOMPARE(world->time(), 0.05);
  }

  // At rest 1 m apart: (-0.287163, 0) m/s² with k_s 5.
  void take_robot_comesAndVanishes() {
    const std::unique_ptr<CoupledWorld> world = couple(oneWalker(), "hunav2");
    CoupledRobot robot;
    robot.pose.position = Vec2(1.0, 0.0);
    const std::vector<CoupledPerson> people = {personAt(1, Vec2::Zero())};
    for (const bool isThere : {false, true, false, true}) {
      world->take(people, isThere ? std::optional<CoupledRobot>(robot) : std::nullopt);
      QCOMPARE(world->view().robotCount(), isThere ? 1 : 0);
      QVERIFY(world->step(0.05));
      const double expected = isThere ? -0.287163 : 0.0;
      QVERIFY(std::fabs(world->forces().social.at(0).x() - expected) < 1e-6);
    }
  }

  void take_somebodyLater_entersThen() {
    Scenario scenario = oneWalker();
    addPerson(scenario, 2, Vec2(0.0, 9.0), {1});
    const std::unique_ptr<CoupledWorld> world = couple(scenario);
    const auto& entered = dynamic_cast<ScriptedBehavior&>(world->behavior()).entered;
    world->take({personAt(1, Vec2::Zero())}, std::nullopt);
    QCOMPARE(entered, std::vector<int>{1});
    QVERIFY(!world->view().isPresent(1));
    world->take({personAt(2, Vec2(0.0, 9.0)), personAt(1, Vec2::Zero())}, std::nullopt);
    world->take({personAt(2, Vec2(0.0, 9.0)), personAt(1, Vec2::Zero())}, std::nullopt);
    QCOMPARE(entered, (std::vector<int>{1, 2}));
  }

  void take_unknownId_isLeftOut() {
    const std::unique_ptr<CoupledWorld> world = couple(oneWalker());
    QVERIFY(world->contains(1));
    QVERIFY(!world->contains(7));
    world->take({personAt(7, Vec2::Zero())}, std::nullopt);
    QVERIFY(world->step(0.05));
    QCOMPARE(world->view().humanCount(), 1);
    QVERIFY(!world->view().isPresent(0));
  }

  void step_infiniteVelocity_failsAndMovesNobody() {
    const std::unique_ptr<CoupledWorld> world =
        couple(oneWalker(), {}, [](const WorldView&, Intents& intents) {
          intents.of(0).speed = std::numeric_limits<double>::infinity();
        });
    world->take({personAt(1, Vec2(1.0, 0.0))}, std::nullopt);
    QVERIFY(!world->step(0.05));
    QVERIFY(!world->failure().empty());
    QCOMPARE(world->view().pose(0).position.x(), 1.0);
  }
};

QTEST_APPLESS_MAIN(CoupledWorldTest)
#include "tst_CoupledWorld.moc"
