#include <optional>

#include <QtTest>

#include "tests/bt/FakeWorld.h"

using base::NodeStatus;

/// Nodes that HuNavSim does not have.
class HumanOwnNodesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void init() {
    world_ = withOnePerson();
    bench_.emplace(world_);
  }

  void cooldown_afterARun_failsForItsTime() {
    QVERIFY(bench_->load("<Cooldown duration='0.3'><AlwaysSuccess/></Cooldown>"));
    QCOMPARE(bench_->step(), NodeStatus::Success);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Success);
  }

  void isTimeBetween_atTheEnds_includesTheFirst() {
    QVERIFY(bench_->load("<IsTimeBetween from='0.1' until='0.3'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Success);
    QCOMPARE(bench_->step(), NodeStatus::Success);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
  }

  void isCrowded_countsOthersWithinTheDistance() {
    FakeWorld world;
    for (int i = 0; i < 4; ++i) {
      world.addPerson(i, i, 0.0);
    }
    TreeBench bench(world);
    QVERIFY(
        bench.load("<Sequence><IsCrowded agent_id='{id}' distance='2' count='2'/>"
                   "<Inverter><IsCrowded agent_id='{id}' distance='2' count='3'/></Inverter>"
                   "</Sequence>"));
    QCOMPARE(bench.step(), NodeStatus::Success);
  }

  void isAgentGroupFormed_needsAllMembers() {
    FakeWorld world = withOnePerson();
    world.addPerson(2, 1.0, 0.0);
    world.addPerson(3, 3.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<IsAgentGroupFormed agent_id='{id}' distance='2'/>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
    bench.control(0).group = bench.control(1).group = 4;
    QCOMPARE(bench.step(), NodeStatus::Success);
    bench.control(2).group = 4;
    QCOMPARE(bench.step(), NodeStatus::Failure);
  }

  void waitForAgent_endsWhenTheyCome() {
    FakeWorld world = withOnePerson();
    world.addPerson(2, 5.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<WaitForAgent agent_id='{id}' target_agent_id='2' distance='2'/>"));
    bench.step();
    QCOMPARE(bench.step(), NodeStatus::Running);
    world.at(1).pose.position.x() = 1.5;
    QCOMPARE(bench.step(), NodeStatus::Success);
  }

  void fleeFrom_walksAwayUntilSafe() {
    FakeWorld world = withOnePerson();
    world.addPerson(2, 1.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<FleeFrom agent_id='{id}' target_agent_id='2' safe_distance='3'/>"));
    QVERIFY(bench.stepsUntil(NodeStatus::Success) > 5);
    QVERIFY(world.at(0).pose.position.x() <= -1.9);
  }

  void wanderInArea_staysInTheArea() {
    FakeWorld world;
    world.addPerson(1, 1.0, 1.0);
    sim2d::Area area;
    area.name = "hall";
    area.points = {base::Vec2(0.0, 0.0), base::Vec2(4.0, 0.0), base::Vec2(4.0, 3.0),
                   base::Vec2(0.0, 3.0)};
    world.settings.areas = {area};
    TreeBench bench(world);
    QVERIFY(bench.load("<WanderInArea agent_id='{id}' area='hall' duration='20'/>"));
    double length = 0.0;
    for (int i = 0; i < 200; ++i) {
      const base::Vec2 before = world.at(0).pose.position;
      QCOMPARE(bench.step(), NodeStatus::Running);
      const base::Vec2 now = world.at(0).pose.position;
      length += (now - before).norm();
      QVERIFY(now.x() >= 0.0 && now.x() <= 4.0 && now.y() >= 0.0 && now.y() <= 3.0);
    }
    QVERIFY(length > 15.0);
    QCOMPARE(bench.step(), NodeStatus::Success);
  }

  void wanderInArea_unknownArea_failsWithOneWarning() {
    FakeWorld world;
    world.addPerson(1, 1.0, 1.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<WanderInArea agent_id='{id}' area='nowhere'/>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QCOMPARE(bench.pendingDiagnostics().size(), std::size_t(1));
  }

  void goToNearestExit_choosesTheNearest() {
    for (const double x : {-9.0, 4.0}) {
      sim2d::Area area;
      area.name = x < 0.0 ? "far" : "near";
      area.kind = sim2d::AreaKind::Exit;
      area.points = {base::Vec2(x - 1.0, -1.0), base::Vec2(x + 1.0, -1.0), base::Vec2(x, 2.0)};
      world_.settings.areas.push_back(area);
    }
    QVERIFY(bench_->load("<GoToNearestExit agent_id='{id}'/>"));
    QVERIFY(bench_->stepsUntil(NodeStatus::Success) > 0);
    QVERIFY((world_.at(0).pose.position - base::Vec2(4.0, 0.0)).norm() <= 0.3);
    world_.settings.areas.clear();
    QCOMPARE(bench_->step(), NodeStatus::Failure);
  }

  void goToNearestExit_concaveArea_endsInsideIt() {
    FakeWorld world;
    world.addPerson(1, -3.0, 3.0);
    sim2d::Area area;  // a U; the mean of its corners lies between the arms
    area.name = "exit";
    area.kind = sim2d::AreaKind::Exit;
    for (const auto& [x, y] :
         {std::pair(0.0, 0.0), std::pair(6.0, 0.0), std::pair(6.0, 6.0), std::pair(4.0, 6.0),
          std::pair(4.0, 1.0), std::pair(1.0, 1.0), std::pair(1.0, 6.0), std::pair(0.0, 6.0)}) {
      area.points.emplace_back(x, y);
    }
    world.settings.areas = {area};
    TreeBench bench(world);
    QVERIFY(bench.load("<GoToNearestExit agent_id='{id}'/>"));
    QVERIFY(bench.stepsUntil(NodeStatus::Success) > 0);
    // at the height 3.25 the right arm is the wider one
    QVERIFY((world.at(0).pose.position - base::Vec2(5.0, 3.25)).norm() <= 0.3);
  }

  void isAgentGroupFormed_changesOfThisStep_countInTheNext() {
    FakeWorld world = withOnePerson();
    world.addPerson(2, 1.0, 0.0);
    TreeBench bench(world);
    bench.control(1).group = 4;
    QVERIFY(bench.load("<SetGroupId agent_id='{id}' group_id='4'/>"));
    QVERIFY(bench.load("<IsAgentGroupFormed agent_id='{id}'/>", 1));
    bench.step();
    QCOMPARE(bench.control(0).group, 4);
    QCOMPARE(bench.tree(1).statuses()[0], NodeStatus::Failure);
    bench.step();
    QCOMPARE(bench.tree(1).statuses()[0], NodeStatus::Success);
  }

  void waitForAgent_yetToCome_waits() {
    FakeWorld world = withOnePerson();
    world.addPerson(2, 1.0, 0.0);
    world.at(1).isPresent = false;
    TreeBench bench(world);
    QVERIFY(bench.load("<WaitForAgent agent_id='{id}' target_agent_id='2' distance='2'/>"));
    QCOMPARE(bench.step(), NodeStatus::Running);
    QCOMPARE(bench.step(), NodeStatus::Running);
    world.at(1).isPresent = true;
    QCOMPARE(bench.step(), NodeStatus::Success);
    QVERIFY(bench.pendingDiagnostics().empty());
  }

  void waitForAgent_unknownId_failsWithOneWarning() {
    QVERIFY(bench_->load("<WaitForAgent agent_id='{id}' target_agent_id='9'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->pendingDiagnostics().size(), std::size_t(1));
  }

  void useObject_staysForItsTime() {
    world_.goals[1] = base::Vec2(0.2, 0.0);
    QVERIFY(bench_->load("<UseObject agent_id='{id}' goal_id='1' duration='0.5'/>"));
    // start, arrived in the second step, half a second
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 7);
  }

 private:
  FakeWorld world_;
  std::optional<TreeBench> bench_;
};

QTEST_APPLESS_MAIN(HumanOwnNodesTest)
#include "tst_HumanOwnNodes.moc"
