#include <QtTest>

#include "tests/world/TestWorld.h"

using namespace testworld;

namespace {

/// A crowd that crosses itself.
Scenario crowd(int people) {
  Scenario scenario;
  addGoal(scenario, 1, 6.0, 0.3);
  addGoal(scenario, 2, -6.0, 0.1);
  for (int k = 0; k < people; ++k) {
    Human& human = addPerson(scenario, k + 1, Vec2(1.1 * (k % 6) - 3.0, 1.1 * (k / 6) - 3.0),
                             k % 2 == 0 ? std::vector<int>{1, 2} : std::vector<int>{2, 1});
    human.cyclicGoals = true;
    human.groupId = k % 5 == 0 ? 1 : -1;
  }
  return scenario;
}

std::vector<HumanColumns> waysOf(Scenario scenario, int steps) {
  std::vector<HumanColumns> ways;
  const std::unique_ptr<World> world = make(std::move(scenario));
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
  void step_robotFarAway_changesNobody_data();
  void step_robotFarAway_changesNobody();
};

void WorldFarRobotTest::step_robotFarAway_changesNobody_data() {
  QTest::addColumn<int>("people");
  QTest::addColumn<bool>("drives");
  QTest::newRow("few") << 5 << false;
  QTest::newRow("crowd") << 30 << false;
  QTest::newRow("just small") << 64 << false;
  QTest::newRow("just large") << 66 << false;
  QTest::newRow("few, it drives") << 5 << true;
  QTest::newRow("crowd, it drives") << 30 << true;
  QTest::newRow("just small, it drives") << 64 << true;
  QTest::newRow("just large, it drives") << 66 << true;
}

void WorldFarRobotTest::step_robotFarAway_changesNobody() {
  QFETCH(int, people);
  QFETCH(bool, drives);
  constexpr int kSteps = 200;
  const std::vector<HumanColumns> alone = waysOf(crowd(people), kSteps);
  Scenario scenario = crowd(people);
  Robot& robot = addRobot(scenario, Vec2(71.3, -40.9), Vec2(79.0, -44.0));
  if (!drives) {
    robot.goal = RobotGoal{};
  }
  const std::vector<HumanColumns> with = waysOf(std::move(scenario), kSteps);
  QCOMPARE(alone.size(), std::size_t{kSteps});
  QCOMPARE(with.size(), std::size_t{kSteps});
  for (std::size_t step = 0; step < alone.size(); ++step) {
    QVERIFY2(with[step] == alone[step], std::to_string(step + 1).c_str());
  }
}

QTEST_APPLESS_MAIN(WorldFarRobotTest)
#include "tst_WorldFarRobot.moc"
