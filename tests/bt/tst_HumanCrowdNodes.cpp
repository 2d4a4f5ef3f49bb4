#include <cmath>
#include <optional>

#include <QtTest>

#include "tests/bt/FakeWorld.h"

using base::NodeStatus;
using base::Vec2;

namespace {

/// Which of the children a, b, c with durations of 1, 2, 3 steps after the start ran in each of
/// the next rounds.
std::vector<int> choices(const std::string& weights, int personId, int rounds) {
  FakeWorld world;
  world.addPerson(personId, 0.0, 0.0);
  TreeBench bench(world);
  const std::string port = weights.empty() ? "" : " weights='" + weights + "'";
  if (!bench.load("<ProbabilityChoice" + port +
                  ">"
                  "<StopAndWaitTimerAction agent_id='{id}' wait_duration='0.1'/>"
                  "<StopAndWaitTimerAction agent_id='{id}' wait_duration='0.2'/>"
                  "<StopAndWaitTimerAction agent_id='{id}' wait_duration='0.3'/>"
                  "</ProbabilityChoice>")) {
    return {};
  }
  std::vector<int> chosen;
  chosen.reserve(static_cast<std::size_t>(rounds));
  for (int i = 0; i < rounds; ++i) {
    chosen.push_back(bench.stepsUntil(NodeStatus::Success, 5) - 2);
  }
  return chosen;
}

double share(const std::vector<int>& chosen, int child) {
  const auto count = std::count(chosen.begin(), chosen.end(), child);
  return static_cast<double>(count) / static_cast<double>(chosen.size());
}

Vec2 positionOf(FakeWorld& world, int human) {
  return world.at(human).pose.position;
}

}  // namespace

/// ProbabilityChoice, WaitInQueue, YieldToRobot, PassOnSide.
class HumanCrowdNodesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = withOnePerson();
    bench_.emplace(world_);
  }

  void probabilityChoice_weights_giveTheShares() {
    const std::vector<int> chosen = choices("3;1;1", 1, 3000);
    QVERIFY(std::fabs(share(chosen, 0) - 0.6) < 0.04);
    QVERIFY(std::fabs(share(chosen, 1) - 0.2) < 0.04);
    QVERIFY(std::fabs(share(chosen, 2) - 0.2) < 0.04);
  }

  void probabilityChoice_withoutWeights_allAlike() {
    const std::vector<int> chosen = choices("", 1, 3000);
    for (int child = 0; child < 3; ++child) {
      QVERIFY(std::fabs(share(chosen, child) - 1.0 / 3.0) < 0.04);
    }
  }

  void probabilityChoice_zeroWeight_isNeverTaken() {
    QCOMPARE(share(choices("0;1;0", 1, 200), 1), 1.0);
  }

  void probabilityChoice_sameSeed_samePersonSameChoices() {
    QVERIFY(choices("1;1;1", 1, 50) == choices("1;1;1", 1, 50));
    QVERIFY(choices("1;1;1", 1, 50) != choices("1;1;1", 2, 50));
  }

  void probabilityChoice_restartedInOneTick_drawsAnew() {
    // A waiting child that was running fails and is tried again at once: half of the new draws are
    // the other child, which ends in that tick.
    QVERIFY(
        bench_->load("<RetryUntilSuccessful num_attempts='-1'><ProbabilityChoice>"
                     "<ForceFailure><StopAndWaitTimerAction agent_id='{id}' wait_duration='0.1'/>"
                     "</ForceFailure><AlwaysSuccess/></ProbabilityChoice></RetryUntilSuccessful>"));
    int atOnce = 0;
    int restarts = 0;
    bool wasRunning = false;
    for (int i = 0; i < 400; ++i) {
      const bool ended = bench_->step() == NodeStatus::Success;
      atOnce += wasRunning && ended ? 1 : 0;
      restarts += wasRunning ? 1 : 0;
      wasRunning = !ended;
    }
    QVERIFY(atOnce > restarts / 4 && atOnce < restarts * 3 / 4);
  }

  void probabilityChoice_halted_drawsAnew() {
    QVERIFY(
        bench_->load("<ProbabilityChoice weights='1;1'>"
                     "<StopAndWaitTimerAction agent_id='{id}' wait_duration='9' name='a'/>"
                     "<StopAndWaitTimerAction agent_id='{id}' wait_duration='9' name='b'/>"
                     "</ProbabilityChoice>"));
    int first = 0;
    for (int i = 0; i < 100; ++i) {
      QCOMPARE(bench_->step(), NodeStatus::Running);
      const NodeStatus a = bench_->tree().statuses()[1];
      QCOMPARE(bench_->step(), NodeStatus::Running);
      QVERIFY(bench_->tree().statuses()[1] == a);
      first += a == NodeStatus::Running ? 1 : 0;
      bench_->halt();
    }
    QVERIFY(first > 25 && first < 75);
  }

  void probabilityChoice_badWeights_stopTheTree_data() {
    QTest::addColumn<QByteArray>("weights");
    QTest::newRow("too few") << QByteArray("1");
    QTest::newRow("too many") << QByteArray("1;1;1");
    QTest::newRow("negative") << QByteArray("1;-1");
    QTest::newRow("word") << QByteArray("1;often");
    QTest::newRow("gap") << QByteArray("1;;1");
    QTest::newRow("none") << QByteArray("0;0");
    QTest::newRow("infinite") << QByteArray("inf;1");
    QTest::newRow("sum") << QByteArray("1e308;1e308");
  }
  void probabilityChoice_badWeights_stopTheTree() {
    QFETCH(QByteArray, weights);
    QVERIFY(bench_->load("<ProbabilityChoice weights='" + weights.toStdString() +
                         "'><AlwaysSuccess/><AlwaysSuccess/></ProbabilityChoice>"));
    bench_->step();
    QVERIFY(bench_->isFaulty());
    QVERIFY(bench_->tree().fault()->message.find("weights") != std::string::npos);
  }

  void waitInQueue_threePeople_areServedInTurn() {
    FakeWorld world;
    world.goals[1] = Vec2(0.0, 0.0);
    world.addPerson(1, 6.0, 0.0);
    world.addPerson(2, 2.0, 0.0);
    world.addPerson(3, 4.0, 0.5);
    TreeBench bench(world);
    const std::string queue =
        "<Sequence><RunOnce><WaitInQueue agent_id='{id}' goal_id='1' spacing='1' duration='3'/>"
        "</RunOnce><GoTo agent_id='{id}' goal_id='2' time_step='{dt}'/></Sequence>";
    world.goals[2] = Vec2(0.0, 20.0);
    for (int human = 0; human < 3; ++human) {
      QVERIFY(bench.load(queue, human));
    }
    std::vector<int> left;
    double closest = 100.0;
    for (int i = 0; i < 300 && left.size() < 3; ++i) {
      bench.step();
      for (int human = 0; human < 3; ++human) {
        const bool isServed =
            bench.tree(static_cast<std::size_t>(human)).statuses()[2] == NodeStatus::Success;
        if (isServed) {
          left.push_back(world.at(human).constants.id);
        }
      }
      const bool bothWait =
          bench.society().agentStates[0].queue && bench.society().agentStates[2].queue;
      if (bothWait) {
        closest = std::min(closest, (positionOf(world, 0) - positionOf(world, 2)).norm());
      }
    }
    QVERIFY((left == std::vector<int>{2, 3, 1}));
    QVERIFY2(closest > 0.7, qPrintable(QString::number(closest)));
  }

  void waitInQueue_stands_behindThePersonBefore() {
    FakeWorld world;
    world.goals[1] = Vec2(0.0, 0.0);
    world.addPerson(1, 1.0, 0.0);
    world.addPerson(2, 5.0, 0.0);
    TreeBench bench(world);
    for (int human = 0; human < 2; ++human) {
      QVERIFY(bench.load("<WaitInQueue agent_id='{id}' goal_id='1' spacing='1' duration='100'/>",
                         human));
    }
    for (int i = 0; i < 100; ++i) {
      bench.step();
    }
    const double gap = (positionOf(world, 0) - positionOf(world, 1)).norm();
    QVERIFY2(std::fabs(gap - 1.0) < 0.25, qPrintable(QString::number(gap)));
    QVERIFY(bench.intent(1).motion == sim2d::Motion::Turn);
    QVERIFY(std::fabs(std::fabs(world.at(1).pose.heading) - base::kPi) < 0.1);  // to the head
  }

  void waitInQueue_impatient_fails() {
    FakeWorld world;
    world.goals[1] = Vec2(0.0, 0.0);
    world.addPerson(1, 0.1, 0.0);
    world.addPerson(2, 1.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<WaitInQueue agent_id='{id}' goal_id='1' patience='2'/>", 1));
    QVERIFY(bench.load("<WaitInQueue agent_id='{id}' goal_id='1' duration='50'/>", 0));
    QCOMPARE(bench.stepsUntil(NodeStatus::Failure), 21);
    QVERIFY(!bench.society().agentStates[1].queue);
  }

  void waitInQueue_halted_freesThePlace() {
    FakeWorld world;
    world.goals[1] = Vec2(0.0, 0.0);
    world.addPerson(1, 0.1, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<WaitInQueue agent_id='{id}' goal_id='1'/>"));
    QCOMPARE(bench.step(), NodeStatus::Running);
    QVERIFY(bench.society().agentStates[0].queue);
    bench.halt();
    QVERIFY(!bench.society().agentStates[0].queue);
  }

  void waitInQueue_twoInOneTree_eachFreesItsOwnPlaceOnly() {
    FakeWorld world;
    world.goals = {{1, Vec2(0.0, 0.0)}, {2, Vec2(3.0, 0.0)}};
    world.addPerson(1, 0.1, 0.0);
    TreeBench bench(world);
    // the second node takes the person's place over; the first fails and must not free it
    QVERIFY(
        bench.load("<ParallelAll max_failures='2'><WaitInQueue agent_id='{id}' goal_id='1'/>"
                   "<WaitInQueue agent_id='{id}' goal_id='2' duration='0.3'/></ParallelAll>"));
    QCOMPARE(bench.step(), NodeStatus::Running);
    QCOMPARE(bench.step(), NodeStatus::Running);
    QCOMPARE(bench.tree().statuses()[1], NodeStatus::Failure);
    QVERIFY(bench.society().agentStates[0].queue);
    QVERIFY(bench.society().agentStates[0].queue->head == Vec2(3.0, 0.0));
    QVERIFY(bench.stepsUntil(NodeStatus::Success, 100) > 0);
    QVERIFY(!bench.society().agentStates[0].queue);
  }

  void waitInQueue_unknownGoal_failsWithOneWarning() {
    QVERIFY(bench_->load("<WaitInQueue agent_id='{id}' goal_id='9'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->pendingDiagnostics().size(), std::size_t(1));
  }

  void yieldToRobot_comes_standsUntilItHasPassed() {
    FakeWorld world;
    world.addPerson(1, 0.0, 0.0, 1.0);
    world.addRobot(2.5, 0.5);
    world.robots[0].velocity = Vec2(-1.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<YieldToRobot agent_id='{id}'/>"));
    int steps = 0;
    for (NodeStatus status = NodeStatus::Running; status == NodeStatus::Running && steps < 100;
         ++steps) {
      status = bench.step();
      QVERIFY(status == NodeStatus::Running || world.robots[0].pose.position.x() <= 0.0);
      world.robots[0].pose.position += world.stepLength * world.robots[0].velocity;
    }
    QVERIFY2(steps >= 26 && steps <= 28, qPrintable(QString::number(steps)));
    QVERIFY(positionOf(world, 0).norm() < 1e-12);
    QCOMPARE(bench.step(), NodeStatus::Failure);  // moves away: nothing to yield to
  }

  void yieldToRobot_robotWaitsAsWell_goesOnAfterItsPatience() {
    world_.addRobot(2.0, 0.0);
    world_.robots[0].velocity = Vec2(-1.0, 0.0);
    QVERIFY(bench_->load("<YieldToRobot agent_id='{id}' patience='1'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Running);
    QCOMPARE(bench_->step(), NodeStatus::Running);
    QVERIFY(bench_->intent().motion == sim2d::Motion::Turn && bench_->intent().active);
    world_.robots[0].velocity = Vec2::Zero();
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 11);
  }

  void yieldToRobot_noRobotOrFar_fails() {
    QVERIFY(bench_->load("<YieldToRobot agent_id='{id}' distance='3'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    world_.addRobot(3.5, 0.0);
    world_.robots[0].velocity = Vec2(-1.0, 0.0);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    world_.robots[0].pose.position.x() = 2.5;
    QCOMPARE(bench_->step(), NodeStatus::Running);
    world_.at(0).isPresent = false;
    QCOMPARE(bench_->step(), NodeStatus::Failure);
  }

  void yieldToRobot_halted_startsAfresh() {
    world_.addRobot(2.0, 0.0);
    world_.robots[0].velocity = Vec2(-1.0, 0.0);
    QVERIFY(bench_->load("<YieldToRobot agent_id='{id}'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Running);
    bench_->halt();
    world_.robots[0].velocity = Vec2(1.0, 0.0);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
  }

  void passOnSide_robotAhead_leavesItOnTheOtherSide_data() {
    QTest::addColumn<QByteArray>("side");
    QTest::addColumn<double>("sign");
    QTest::newRow("right") << QByteArray("right") << -1.0;
    QTest::newRow("left") << QByteArray("left") << 1.0;
  }
  void passOnSide_robotAhead_leavesItOnTheOtherSide() {
    QFETCH(QByteArray, side);
    QFETCH(double, sign);
    world_.addRobot(3.5, 0.0);
    bench_->control().goals = {{1, Vec2(8.0, 0.0), 0.3}};
    QVERIFY(bench_->load("<PassOnSide agent_id='{id}' side='" + side.toStdString() +
                         "' clearance='0.8'/>"));
    double closest = 100.0;
    int steps = 0;
    for (NodeStatus status = NodeStatus::Running; status == NodeStatus::Running && steps < 200;
         ++steps) {
      status = bench_->step();
      closest = std::min(closest, (positionOf(world_, 0) - Vec2(3.5, 0.0)).norm());
    }
    QVERIFY(steps > 20 && steps < 80);
    QVERIFY(positionOf(world_, 0).y() * sign > 0.5);
    QVERIFY2(closest > 0.5, qPrintable(QString::number(closest)));
    QCOMPARE(bench_->step(), NodeStatus::Failure);  // it is behind now
  }

  void passOnSide_noRobotOrBadSide_fails() {
    FakeWorld world = withOnePerson();
    TreeBench bench(world);
    QVERIFY(bench.load("<PassOnSide agent_id='{id}'/>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
    world.addRobot(2.0, 0.0);
    QCOMPARE(bench.step(), NodeStatus::Running);
    bench.halt();
    world.robots[0].pose.position = Vec2(-2.0, 0.0);
    QCOMPARE(bench.step(), NodeStatus::Failure);
    TreeBench other(world);
    world.robots[0].pose.position = Vec2(2.0, 0.0);
    QVERIFY(other.load("<PassOnSide agent_id='{id}' side='above'/>"));
    QCOMPARE(other.step(), NodeStatus::Failure);
    QCOMPARE(other.pendingDiagnostics().size(), std::size_t(1));
  }

 private:
  FakeWorld world_;
  std::optional<TreeBench> bench_;
};

QTEST_APPLESS_MAIN(HumanCrowdNodesTest)
#include "tst_HumanCrowdNodes.moc"
