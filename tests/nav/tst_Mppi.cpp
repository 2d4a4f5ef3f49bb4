#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <variant>
#include <vector>

#include <QtTest>

#include "sim2d/nav/mppi/MppiPlanner.h"
#include "tests/nav/MppiWorld.h"
#include "tests/nav/PlannerFunctions.h"

using namespace sim2d;

namespace {

using mppitest::box;
using mppitest::discRobot;
using mppitest::Human;
using mppitest::Outcome;
using mppitest::World;

std::shared_ptr<Planner> planner(const RobotBody& body, std::uint64_t seed = 1) {
  return mppitest::plannerOf(addMppi, body, seed);
}

/// A room of 10 m x 6 m with a wall across that leaves 1.4 m at the top.
World room() {
  return World({box(-1.0, -1.0, 11.0, -0.9), box(-1.0, 5.9, 11.0, 6.0), box(-1.0, -0.9, -0.9, 5.9),
                box(10.9, -0.9, 11.0, 5.9), box(4.8, -0.9, 5.2, 4.5)},
               {Vec2(1.0, 1.0), Vec2(9.0, 1.0)});
}

World openPlane() {
  return World({}, {Vec2(-5.0, -5.0), Vec2(5.0, 5.0)});
}

Human straight(const Vec2& from, const Vec2& to, double speed) {
  Human human;
  human.position = from;
  human.way = {from + 100.0 * (to - from)};
  human.speed = speed;
  human.velocity = speed * (to - from).normalized();
  human.reacts = false;
  return human;
}

}  // namespace

class MppiTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void command_roomWithWall_drivesRound_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<double>("longest");
    // The shortest way is about 12 m, at most 1 m/s.
    QTest::newRow("differential") << 0 << 20.0;
    QTest::newRow("omnidirectional") << 1 << 20.0;
    QTest::newRow("ackermann") << 2 << 22.0;
  }

  void command_roomWithWall_drivesRound() {
    QFETCH(int, kind);
    QFETCH(double, longest);
    const RobotBody body = discRobot(static_cast<Kinematics>(kind));
    World world = room();
    const auto mppi = planner(body);
    const Outcome outcome =
        world.run(*mppi, body, {Vec2(1.0, 1.0), 0.0}, Vec2(9.0, 1.0), {}, longest);
    qInfo("%.2f s, walls %.3f m", outcome.time, outcome.leastWallGap);
    QVERIFY(outcome.arrived);
    QVERIFY(outcome.leastWallGap > 0.0);
  }

  /// 1.0 m x 0.5 m through 1.0 m: its corners lie 0.56 m from its middle.
  void command_longRobotThroughDoor_staysClear() {
    RobotBody body = discRobot(Kinematics::Differential);
    body.footprint.corners = {Vec2(-0.5, -0.25), Vec2(0.5, -0.25), Vec2(0.5, 0.25),
                              Vec2(-0.5, 0.25)};
    World world({box(4.8, -6.0, 5.2, -0.5), box(4.8, 0.5, 5.2, 6.0)},
                {Vec2(0.0, -2.0), Vec2(10.0, 2.0)});
    const auto mppi = planner(body);
    const Outcome outcome =
        world.run(*mppi, body, {Vec2(2.0, -1.5), 0.5}, Vec2(8.0, 1.0), {}, 20.0);
    qInfo("%.2f s, walls %.3f m", outcome.time, outcome.leastWallGap);
    QVERIFY(outcome.arrived);
    QVERIFY(outcome.leastWallGap > 0.0);
  }

  void command_goalBehind_turnsRound_data() {
    QTest::addColumn<int>("kind");
    QTest::newRow("differential") << 0;
    QTest::newRow("omnidirectional") << 1;
    QTest::newRow("ackermann") << 2;
  }

  void command_goalBehind_turnsRound() {
    QFETCH(int, kind);
    const RobotBody body = discRobot(static_cast<Kinematics>(kind));
    World world = openPlane();
    const auto mppi = planner(body);
    const Outcome outcome =
        world.run(*mppi, body, {Vec2(0.0, 0.0), 0.0}, Vec2(-4.0, 0.0), {}, 14.0);
    qInfo("%.2f s", outcome.time);
    QVERIFY(outcome.arrived);
  }

  void command_goalAside_doesNotCircle() {
    const RobotBody body = discRobot(Kinematics::Differential);
    World world = openPlane();
    const auto mppi = planner(body);
    const Outcome outcome = world.run(*mppi, body, {Vec2(0.0, 0.0), 0.0}, Vec2(0.0, 0.6), {}, 6.0);
    qInfo("%.2f s", outcome.time);
    QVERIFY(outcome.arrived);
  }

  void command_peopleWhoDoNotLook_noContact_data() {
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("scene");
    for (int kind = 0; kind < 3; ++kind) {
      for (int scene = 0; scene < 3; ++scene) {
        QTest::addRow("%s scene %d", kinematicsName(static_cast<Kinematics>(kind)), scene)
            << kind << scene;
      }
    }
  }

  void command_peopleWhoDoNotLook_noContact() {
    QFETCH(int, kind);
    QFETCH(int, scene);
    const std::vector<std::vector<Human>> scenes = {
        {straight(Vec2(8.0, 0.0), Vec2(0.0, 0.0), 1.2)},
        {straight(Vec2(4.0, -4.0), Vec2(4.0, 4.0), 1.0),
         straight(Vec2(6.0, 5.0), Vec2(6.0, 0.0), 1.1)},
        {straight(Vec2(9.0, 1.0), Vec2(0.0, 0.8), 1.0),
         straight(Vec2(9.0, -1.0), Vec2(0.0, -0.8), 1.3),
         straight(Vec2(3.0, 0.1), Vec2(3.0, 0.1001), 0.0)}};
    const RobotBody body = discRobot(static_cast<Kinematics>(kind));
    World world = openPlane();
    const auto mppi = planner(body);
    const Outcome outcome = world.run(*mppi, body, {Vec2(0.0, 0.0), 0.0}, Vec2(8.0, 0.0),
                                      scenes[static_cast<std::size_t>(scene)], 25.0);
    qInfo("%.2f s, people %.3f m", outcome.time, outcome.leastGap);
    QVERIFY(outcome.arrived);
    QVERIFY(outcome.leastGap > 0.0);
  }

  void command_noWay_stands() {
    const RobotBody body = discRobot(Kinematics::Differential);
    World world({box(4.0, 4.0, 6.0, 4.2), box(4.0, 5.8, 6.0, 6.0), box(4.0, 4.2, 4.2, 5.8),
                 box(5.8, 4.2, 6.0, 5.8)},
                {Vec2(0.0, 0.0), Vec2(10.0, 10.0)});
    const auto mppi = planner(body);
    const Observation observation =
        world.observe({Vec2(1.0, 1.0), 0.0}, {}, Vec2(5.0, 5.0), {}, 0.0);
    if (observation.navigation->plan(0.3, Vec2(1.0, 1.0), Vec2(5.0, 5.0)).empty()) {
      QVERIFY(*mppi->command(observation) == BodyTwist{});
      QVERIFY(mppi->candidates().empty());
    } else {
      QFAIL("the goal is meant to be shut in");
    }
  }

  void command_sameObservations_equalBits() {
    const RobotBody body = discRobot(Kinematics::Differential);
    std::vector<Vec2> ways[2];
    for (std::vector<Vec2>& way : ways) {
      World world = openPlane();
      const auto mppi = planner(body);
      way = world
                .run(*mppi, body, {Vec2(0.0, 0.0), 0.3}, Vec2(8.0, 0.0),
                     {straight(Vec2(5.0, 0.2), Vec2(0.0, 0.0), 1.0)}, 2.0)
                .way;
    }
    QVERIFY(ways[0] == ways[1]);
  }

  void command_otherSeed_differs() {
    const RobotBody body = discRobot(Kinematics::Differential);
    World world = openPlane();
    const Observation observation = world.observe({}, {}, Vec2(5.0, 1.0), {}, 0.0);
    const BodyTwist first = *planner(body, 1)->command(observation);
    const BodyTwist second = *planner(body, 2)->command(observation);
    const BodyTwist high = *planner(body, 1ULL << 40U)->command(observation);
    QVERIFY(first != second);
    QVERIFY(first != high);
  }

  void command_everyInstructionSet_equalBits() {
    const RobotBody body = discRobot(Kinematics::Omnidirectional);
    PlannerSetup setup;
    setup.body = body;
    std::vector<Vec2> first;
    for (const MppiSimdLevel path :
         {MppiSimdLevel::Sse2, MppiSimdLevel::Avx2, MppiSimdLevel::Avx512}) {
      if (!isMppiSimdLevelSupported(path)) {
        continue;
      }
      World world = openPlane();
      MppiPlanner mppi(setup, {}, SocialMppiParameters{}, path);
      const std::vector<Vec2> way = world
                                        .run(mppi, body, {Vec2(0.0, 0.0), 0.3}, Vec2(8.0, 0.0),
                                             {straight(Vec2(5.0, 0.2), Vec2(0.0, 0.0), 1.0)}, 1.0)
                                        .way;
      first = first.empty() ? way : first;
      QVERIFY(way == first);
    }
    qInfo("ends at %.17g %.17g", first.back().x(), first.back().y());
  }

  void candidates_afterCall_showASampleAndTheChosen() {
    const RobotBody body = discRobot(Kinematics::Differential);
    World world = openPlane();
    const auto mppi = planner(body);
    const Human human = straight(Vec2(1.2, 0.0), Vec2(1.2, 0.001), 0.0);
    const Pose2 pose{Vec2(0.5, -0.2), 0.1};
    QVERIFY(mppi->candidates().empty());
    const auto command = mppi->command(world.observe(pose, {}, Vec2(5.0, 0.0), {human}, 0.0));
    QVERIFY(static_cast<bool>(command));
    const std::vector<Candidate> shown = mppi->candidates();
    QCOMPARE(static_cast<int>(shown.size()), 41);
    int chosen = 0;
    for (const Candidate& candidate : shown) {
      QVERIFY(candidate.points.front() == pose.position);
      chosen += candidate.isChosen ? 1 : 0;
    }
    QCOMPARE(chosen, 1);
    QVERIFY(std::isfinite(shown.back().cost));
    QVERIFY(mppi->path() == shown.back().points);
  }

  void specs_everyParameter_isDescribed() {
    PlannerRegistry registry;
    addMppi(registry);
    for (const base::ParameterSpec& spec : registry.find("mppi")->parameters) {
      QVERIFY2(!spec.help.empty(), spec.key.c_str());
      QVERIFY2(spec.range.contains(std::get<double>(spec.fallback)), spec.key.c_str());
    }
  }
};

QTEST_GUILESS_MAIN(MppiTest)
#include "tst_Mppi.moc"
