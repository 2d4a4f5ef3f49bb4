#include <QtTest>

#include "tests/support/Columns.h"
#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// A crowd that crosses itself.
Scenario crowd(int people) {
  Scenario scenario;
  addGoal(scenario, 1, 6.0, 0.3);
  addGoal(scenario, 2, -6.0, 0.1);
  for (int k = 0; k < people; ++k) {
    const int row = k / 6;
    Human& human = addPerson(scenario, k + 1, Vec2(1.1 * (k % 6) - 3.0, 1.1 * row - 3.0),
                             k % 2 == 0 ? std::vector<int>{1, 2} : std::vector<int>{2, 1});
    human.cyclicGoals = true;
    human.groupId = k % 5 == 0 ? 1 : -1;
  }
  return scenario;
}

std::vector<HumanColumns> waysOf(Scenario scenario, int steps) {
  std::vector<HumanColumns> ways;
  const auto world = make(std::move(scenario));
  if (world) {
    advance(*world, steps, [&ways](const Frame& frame) { ways.push_back(frame.humans); });
  }
  return ways;
}

}  // namespace

/// A robot beyond all forces and out of sight is as good as none, to the last digit.
class WorldFarRobotTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void step_robotFarAway_changesNobody_data() {
    addColumns<int, bool, bool>({"people", "drives", "polygon"});
    for (const bool drives : {false, true}) {
      for (const bool polygon : {false, true}) {
        const std::string kind =
            std::string(drives ? ", it drives" : "") + (polygon ? ", polygon" : "");
        QTest::newRow(("few" + kind).c_str()) << 5 << drives << polygon;
        QTest::newRow(("crowd" + kind).c_str()) << 30 << drives << polygon;
        QTest::newRow(("just small" + kind).c_str()) << 64 << drives << polygon;
        QTest::newRow(("just large" + kind).c_str()) << 66 << drives << polygon;
      }
    }
  }

  void step_robotFarAway_changesNobody() {
    QFETCH(int, people);
    QFETCH(bool, drives);
    QFETCH(bool, polygon);
    constexpr int kSteps = 200;
    const std::vector<HumanColumns> alone = waysOf(crowd(people), kSteps);
    Scenario scenario = crowd(people);
    Robot& robot = addRobot(scenario, Vec2(71.3, -40.9), Vec2(79.0, -44.0));
    if (!drives) {
      robot.goal = RobotGoal{};
    }
    if (polygon) {
      robot.footprintX = {-0.4, 0.4, 0.4, 0.0, -0.4};
      robot.footprintY = {-0.2, -0.2, 0.2, 0.1, 0.2};
    }
    const std::vector<HumanColumns> with = waysOf(std::move(scenario), kSteps);
    QCOMPARE(alone.size(), std::size_t{kSteps});
    QCOMPARE(with.size(), std::size_t{kSteps});
    for (std::size_t step = 0; step < alone.size(); ++step) {
      QVERIFY2(with[step] == alone[step], std::to_string(step + 1).c_str());
    }
  }

  /// Until something is near, the shape does not count.
  void polygonAlone_movesAsTheDiscAroundIt() {
    std::vector<RobotColumns> ways[2];
    for (const bool polygon : {false, true}) {
      Scenario scenario = crowd(5);
      Robot& robot = addRobot(scenario, Vec2(71.3, -40.9), Vec2(79.0, -44.0));
      robot.radius = 0.5;
      if (polygon) {
        robot.footprintX = {-0.4, 0.4, 0.4, -0.4};
        robot.footprintY = {-0.3, -0.3, 0.3, 0.3};
      }
      const auto world = make(std::move(scenario));
      advance(*world, 300,
              [&](const Frame& frame) { ways[polygon ? 1 : 0].push_back(frame.robots); });
      QVERIFY(world->arrivedAt().has_value());
    }
    QVERIFY(ways[0] == ways[1]);
  }
};

QTEST_APPLESS_MAIN(WorldFarRobotTest)
#include "tst_WorldFarRobot.moc"
