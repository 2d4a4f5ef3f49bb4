#include <QtTest>

#include "app/python/CrowdEnvironment.h"
#include "app/run/Bundle.h"
#include "tests/bench/FastestOf.h"

namespace {

constexpr int kSteps = 4000;
constexpr int kRounds = 5;
constexpr double kSize = 12.0;  // side length of the area that the people cross [m]

/// People who walk between two opposite sides, and a robot that crosses them.
sim2d::Scenario crossing(int people) {
  sim2d::Scenario scenario;
  const int rows = people / 2;
  for (int i = 0; i < people; ++i) {
    const double y = kSize * (0.5 + i / 2) / rows - kSize / 2.0;
    const double side = i % 2 == 0 ? -kSize / 2.0 : kSize / 2.0;
    for (int end = 0; end < 2; ++end) {
      sim2d::GlobalGoal goal;
      goal.id = 2 * i + end + 1;
      goal.key = {base::EntityKind::Goal, goal.id};
      goal.position = {end == 0 ? -side : side, y};
      scenario.goals.push_back(goal);
    }
    sim2d::Human human;
    human.id = i + 1;
    human.key = {base::EntityKind::Human, human.id};
    human.name = "person" + std::to_string(human.id);
    human.initPose = {{side, y}, 0.0};
    human.goals = {2 * i + 1, 2 * i + 2};
    scenario.humans.push_back(human);
  }
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, 1};
  robot.name = "robot";
  robot.start = {{0.0, -kSize / 2.0}, 1.57};
  robot.goal.point = {0.0, kSize / 2.0};
  robot.planner = "teleop";
  scenario.robots = {robot};
  return scenario;
}

app::Bundle bundleOf(sim2d::Scenario scenario) {
  app::Bundle bundle;
  bundle.scenario = std::make_shared<sim2d::Scenario>(std::move(scenario));
  return bundle;
}

/// As many bytes per step as the environment writes.
double emptyLoop(std::size_t size) {
  std::vector<float> bytes(size);
  float next = 0.0F;
  const double taken = fastestOf(kRounds, [&] {
    for (int step = 0; step < kSteps; ++step) {
      for (float& byte : bytes) {
        byte = next;
        next += 1.0F;
      }
    }
  });
  return bytes.back() >= 0.0F ? taken : 0.0;
}

}  // namespace

/// Steps of the environment for reinforcement learning on one thread, with a lidar of 180 beams.
class EnvironmentBench : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void step_amongPeople_data() {
    QTest::addColumn<int>("people");
    QTest::newRow("10 people") << 10;
    QTest::newRow("30 people") << 30;
  }
  void step_amongPeople() {
    QFETCH(const int, people);
    python::EnvironmentOptions options;
    options.duration = 20.0;
    python::CrowdEnvironment environment(bundleOf(crossing(people)), options);
    QVERIFY(!base::hasErrors(environment.problems()));
    environment.reset(1);
    const float action[] = {0.3F, 0.1F};
    const double taken = fastestOf(kRounds, [&] {
      for (int step = 0; step < kSteps; ++step) {
        environment.step(action, 2);
      }
    });
    const python::Observations& seen = environment.observations();
    const double empty = emptyLoop(seen.state.size() + seen.people.size() + seen.lidar.size());
    qInfo("%.0f steps/s; an empty loop: %.0f steps/s", 1e3 * kSteps / taken, 1e3 * kSteps / empty);
    QTest::setBenchmarkResult(taken * 1e6 / kSteps, QTest::WalltimeNanoseconds);
  }
};

QTEST_APPLESS_MAIN(EnvironmentBench)
#include "bench_Environment.moc"
