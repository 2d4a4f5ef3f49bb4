#include <cmath>

#include <QtTest>

#include "tests/bt/FakeWorld.h"

using base::NodeStatus;
using sim2d::Motion;

namespace {

FakeWorld pairOfPeople() {
  FakeWorld world;
  world.addPerson(1, 0.0, 0.0, 0.0);
  world.addPerson(2, 3.0, 0.0, base::kPi);
  world.addRobot(2.0, 0.0, base::kPi);
  world.goals = {{1, base::Vec2(1.0, 0.0)}, {2, base::Vec2(0.0, 2.0)}};
  return world;
}

}  // namespace

/// Each known fault of the original: our way by default, its way on demand.
class HumanQuirksTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void q01_randomChance_takesAgentId() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<RandomChanceCondition agent_id='{id}' probability='0.5'/>"));
    QVERIFY(bench.loadDiagnostics().empty());
    int successes = 0;
    for (int i = 0; i < 400; ++i) {
      successes += bench.step() == NodeStatus::Success ? 1 : 0;
    }
    QVERIFY(successes > 150 && successes < 250);
  }

  void q02_scaredNav_withSafeDistance_flees() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<ScaredNav agent_id='1' runaway_vel='1.2' safe_distance='4'/>"));
    bench.step();
    QVERIFY((bench.intent().target.position - base::Vec2(-2.0, 0.0)).norm() < 1e-12);
    QCOMPARE(bench.intent().speed, 1.2);
  }

  void q02_scaredNav_withForceFactor_isPushed() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    bench.control().goals = {{2, base::Vec2(0.0, 2.0), 0.3}};
    QVERIFY(bench.load("<ScaredNav agent_id='1' runaway_vel='0.6' scary_force_factor='20'/>"));
    bench.step();
    QCOMPARE(bench.intent().target.id, 2);
    QCOMPARE(bench.intent().speed, 0.6);
    // 20 * 0.2 / (2 - 0.35), away from the robot
    QVERIFY((bench.intent().extraForce - base::Vec2(-2.4242424242424243, 0.0)).norm() < 1e-9);
  }

  void q03_approachAgent_takesDistanceAndSpeed() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(
        bench.load("<ApproachAgent agent_id='1' target_agent_id='2' closest_dist='0.5' "
                   "max_vel='1.0' duration='5'/>"));
    QVERIFY(bench.loadDiagnostics().empty());
    bench.step();
    bench.step();
    QVERIFY(std::fabs(bench.intent().speed - 3.0 / 3.5) < 1e-12);
  }

  void q04_updateGoal_withoutGoals_fails() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<UpdateGoal agent_id='1'/>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
  }

  void q05_reactions_keepTheGoals() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    const std::vector<sim2d::GoalItem> own = {{1, base::Vec2(0.1, 0.0), 0.3},
                                              {2, base::Vec2(0.0, 2.0), 0.3}};
    bench.control().goals = own;
    QVERIFY(bench.load("<ApproachRobot agent_id='1' closest_dist='0.5' max_vel='1.8'/>"));
    for (int i = 0; i < 30; ++i) {
      bench.step();
    }
    QVERIFY(bench.control().goals == own);
  }

  void q06_lookStep_isSymmetricAndLimitedByTime() {
    FakeWorld world = pairOfPeople();
    world.at(0).pose.heading = 1.0;
    TreeBench bench(world);
    QVERIFY(bench.load("<SurprisedNav agent_id='1'/>"));
    bench.step();
    QVERIFY(std::fabs(world.at(0).pose.heading - (1.0 - 0.1 * base::kPi)) < 1e-12);
  }

  void q06_original_overshootsToTheRight() {
    FakeWorld world = pairOfPeople();
    world.quirks.set(6);
    world.at(0).pose.heading = 0.1;
    TreeBench bench(world);
    QVERIFY(bench.load("<SurprisedNav agent_id='1'/>"));
    bench.step();
    QVERIFY(std::fabs(world.at(0).pose.heading - (0.1 - 0.2 * base::kPi)) < 1e-12);
    bench.step();
    QVERIFY(std::fabs(world.at(0).pose.heading) < 1e-12);
  }

  void q07_blockAgent_standsInFront() {
    FakeWorld world = pairOfPeople();
    world.at(1).pose.heading = 0.5 * base::kPi;
    TreeBench bench(world);
    QVERIFY(bench.load("<BlockAgent agent_id='1' target_agent_id='2' front_dist='1'/>"));
    bench.step();
    bench.step();
    QVERIFY((bench.intent().target.position - base::Vec2(3.0, 1.0)).norm() < 1e-9);
    world.quirks.set(7);
    bench.step();
    QVERIFY((bench.intent().target.position - base::Vec2(4.0, 0.0)).norm() < 1e-9);
  }

  void q09_setGoal_inTheFirstTick_replacesTheScenariosGoals() {
    FakeWorld world = pairOfPeople();
    world.at(0).constants.goalRadius = 0.25;
    TreeBench bench(world);
    bench.control().goals = {{2, world.goals[2], 0.25}, {1, world.goals[1], 0.25}};
    QVERIFY(
        bench.load("<Sequence><SetGoal agent_id='{id}' goal_id='1'/>"
                   "<SetGoal agent_id='{id}' goal_id='2'/></Sequence>"));
    bench.step();
    QCOMPARE(bench.control().goals.size(), std::size_t(2));
    QCOMPARE(bench.control().goals[0].id, 1);
    QCOMPARE(bench.control().goals[1].id, 2);
    QCOMPARE(bench.control().goals[0].radius, 0.25);
    bench.step();  // both are in the list
    QCOMPARE(bench.control().goals.size(), std::size_t(2));
  }

  void q09_original_appendsWithSmallRadius() {
    FakeWorld world = pairOfPeople();
    world.quirks.set(9);
    TreeBench bench(world);
    bench.control().goals = {{1, world.goals[1], 0.3}};
    QVERIFY(bench.load("<SetGoal agent_id='{id}' goal_id='1'/>"));
    bench.step();
    QCOMPARE(bench.control().goals.size(), std::size_t(2));
    QCOMPARE(bench.control().goals[1].radius, 0.1);
  }

  void q10_timers_countSimulatedTime() {
    FakeWorld world = pairOfPeople();
    world.stepLength = 0.05;
    TreeBench bench(world);
    QVERIFY(bench.load("<StopAndWaitTimerAction agent_id='1' wait_duration='1.0'/>"));
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 21);
  }

  void q11_stopAndWait_halted_givesFreedomBack() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<StopAndWaitTimerAction agent_id='1' wait_duration='1.0'/>"));
    bench.step();
    QVERIFY(bench.control().frozen);
    bench.halt();
    QVERIFY(!bench.control().frozen);
    world.quirks.set(11);
    bench.step();
    bench.halt();
    QVERIFY(bench.control().frozen);
  }

  void q11_stopAndWait_insideStop_leavesThePersonStopped() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    bench.control().frozen = true;
    QVERIFY(bench.load("<StopAndWaitTimerAction agent_id='1' wait_duration='0.2'/>"));
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 3);
    QVERIFY(bench.control().frozen);
  }

  void q12_goTo_usesItsTolerance() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<GoTo agent_id='1' goal_id='1' tolerance='0.9'/>"));
    bench.step();
    QCOMPARE(bench.step(), NodeStatus::Success);  // 1.0 m away
  }

  void q12_original_ignoresIt() {
    FakeWorld world = pairOfPeople();
    world.quirks.set(12);
    TreeBench bench(world);
    QVERIFY(bench.load("<GoTo agent_id='1' goal_id='1' tolerance='0.9'/>"));
    bench.step();
    QCOMPARE(bench.step(), NodeStatus::Running);
  }

  void q13_approachAgent_near_doesNotStopForGood() {
    FakeWorld world = pairOfPeople();
    world.at(0).pose.position = base::Vec2(2.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<ApproachAgent agent_id='1' target_agent_id='2'/>"));
    bench.step();
    bench.step();
    QVERIFY(!bench.control().frozen);
    world.quirks.set(13);
    bench.step();
    QVERIFY(bench.control().frozen);
  }

  void q14_q16_conversation_movesTheMembersInsteadOfTheirTrees() {
    FakeWorld world = pairOfPeople();
    world.goals[5] = base::Vec2(1.5, 3.0);
    TreeBench bench(world);
    bench.control(1).goals = {{1, world.goals[1], 0.3}};
    QVERIFY(
        bench.load("<ConversationFormation main_agent_id='{id}' goal_id='5' "
                   "conversation_duration='1' non_main_agent_ids='2' time_step='{dt}'/>"));
    QVERIFY(bench.load("<RegularNav agent_id='{id}' time_step='{dt}'/>", 1));
    bench.step();
    bench.step();
    QVERIFY(!bench.intent(1).targetIsGoal);
    QVERIFY((bench.intent(1).target.position - base::Vec2(2.2, 3.0)).norm() < 1e-9);
    QVERIFY(bench.intent(1).active);
    QCOMPARE(bench.control(1).goals.front().id, 1);
    QVERIFY(bench.stepsUntil(NodeStatus::Success) > 0);
  }

  void q16_laterCaptor_overridesAnEarlierTree() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    bench.control(0).goals = {{1, world.goals[1], 0.3}};
    QVERIFY(bench.load("<RegularNav agent_id='{id}' time_step='{dt}'/>"));
    QVERIFY(
        bench.load("<ConversationFormation main_agent_id='{id}' goal_id='2' "
                   "non_main_agent_ids='1' time_step='{dt}'/>",
                   1));
    bench.step();
    QVERIFY(bench.intent(0).targetIsGoal);
    bench.step();
    QVERIFY(!bench.intent(0).targetIsGoal);
  }

  void q15_conversation_secondRun_lastsAsLong() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(
        bench.load("<ConversationFormation main_agent_id='{id}' goal_id='2' "
                   "conversation_duration='1' non_main_agent_ids='2' time_step='{dt}'/>"));
    QVERIFY(bench.stepsUntil(NodeStatus::Success) > 0);
    QVERIFY(bench.stepsUntil(NodeStatus::Success) >= 11);
  }

  void q17_groupWalk_restoresGroups() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    bench.control(0).goals = {{2, world.goals[2], 0.3}};
    bench.control(1).goals = {{1, world.goals[1], 0.3}};
    bench.control(1).group = 7;
    QVERIFY(
        bench.load("<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2' "
                   "duration='0.2'/>"));
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench.control(0).group, -1);
    QCOMPARE(bench.control(1).group, 7);
    QCOMPARE(bench.control(1).goals.front().id, 1);
    world.quirks.set(17);
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench.control(1).group, -1);
  }

  void q18_followAgent_withoutMaxVel_keepsItsOwnSpeed_data() {
    QTest::addColumn<QByteArray>("maxVel");
    QTest::addColumn<double>("own");
    QTest::addColumn<bool>("isOriginal");
    QTest::addColumn<double>("far");   // [m/s]
    QTest::addColumn<double>("near");  // at half of the closest distance
    QTest::newRow("none") << QByteArray() << 2.0 << false << 2.0 << 0.5;
    QTest::newRow("negative") << QByteArray("max_vel='-1'") << 2.0 << false << 2.0 << 0.5;
    QTest::newRow("given") << QByteArray("max_vel='0.8'") << 2.0 << false << 0.8 << 0.2;
    QTest::newRow("slower than given") << QByteArray("max_vel='3'") << 0.6 << false << 0.6 << 0.6;
    QTest::newRow("original") << QByteArray() << 2.0 << true << 2.0 << 0.375;
  }
  void q18_followAgent_withoutMaxVel_keepsItsOwnSpeed() {
    QFETCH(QByteArray, maxVel);
    QFETCH(double, own);
    QFETCH(bool, isOriginal);
    QFETCH(double, far);
    QFETCH(double, near);
    FakeWorld world = pairOfPeople();
    world.at(0).constants.desiredSpeed = own;
    if (isOriginal) {
      world.quirks.set(18);
    }
    TreeBench bench(world);
    QVERIFY(bench.load("<FollowAgent agent_id='1' target_agent_id='2' closest_dist='1.5' " +
                       maxVel.toStdString() + "/>"));
    QVERIFY(bench.loadDiagnostics().empty());
    bench.step();
    bench.step();
    QCOMPARE(bench.intent().speed, far);
    world.at(0).pose.position = base::Vec2(2.25, 0.0);
    bench.step();
    QCOMPARE(bench.intent().speed, near);
  }

  void q18_followAgent_original_ignoresMaxVelFarAway() {
    FakeWorld world = pairOfPeople();
    world.quirks.set(18);
    TreeBench bench(world);
    QVERIFY(bench.load("<FollowAgent agent_id='1' target_agent_id='2' max_vel='0.5'/>"));
    bench.step();
    bench.step();
    QCOMPARE(bench.intent().speed, 1.0);
  }

  void q19_oldWords_areNotHeard_data() {
    QTest::addColumn<int>("silence");  // steps between the words and the listener
    QTest::addColumn<bool>("isOriginal");
    QTest::addColumn<bool>("isHeard");
    QTest::newRow("held for a second") << 9 << false << true;
    QTest::newRow("older") << 11 << false << false;
    QTest::newRow("original") << 50 << true << true;
  }
  void q19_oldWords_areNotHeard() {
    QFETCH(int, silence);
    QFETCH(bool, isOriginal);
    QFETCH(bool, isHeard);
    FakeWorld world = pairOfPeople();
    if (isOriginal) {
      world.quirks.set(19);
    }
    TreeBench bench(world);
    bench.society().speech.say(1, 1, "Hello");
    world.present = 1 + silence;
    bench.society().speech.beginStep();
    QVERIFY(bench.load("<IsSpeaking agent_id='{id}' target_id='2' duration='1.0'/>"));
    bench.step();
    QCOMPARE(bench.step() == NodeStatus::Success, isHeard);
  }

  void q20_timeDelay_waitsInEveryRound() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<TimeDelay delay='0.2'><AlwaysSuccess/></TimeDelay>"));
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 3);
    world.quirks.set(20);
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench.stepsUntil(NodeStatus::Success), 1);
  }

  void q21_unknownAgent_failsWithOneWarning() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<FollowAgent agent_id='{id}' target_agent_id='9'/>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QCOMPARE(bench.pendingDiagnostics().size(), std::size_t(1));
    QVERIFY(!bench.isFaulty());
  }

  void q22_unknownGoal_failsWithOneWarning_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("GoTo") << QByteArray("<GoTo agent_id='1' goal_id='99'/>");
    QTest::newRow("LookAtPoint") << QByteArray("<LookAtPoint agent_id='1' goal_id='99'/>");
    QTest::newRow("SetGoal") << QByteArray("<SetGoal agent_id='1' goal_id='99'/>");
    QTest::newRow("IsAtPosition") << QByteArray("<IsAtPosition agent_id='1' goal_id='99'/>");
    QTest::newRow("Conversation") << QByteArray(
        "<ConversationFormation main_agent_id='1' non_main_agent_ids='2' goal_id='99'/>");
  }
  void q22_unknownGoal_failsWithOneWarning() {
    QFETCH(QByteArray, body);
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load(body.toStdString()));
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QCOMPARE(bench.pendingDiagnostics().size(), std::size_t(1));
  }

  void q23_findNearestAgent_saysNothing() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<FindNearestAgent agent_id='{id}' target_agent_id='{nearest}'/>"));
    QCOMPARE(bench.step(), NodeStatus::Success);
    QVERIFY(bench.entry("nearest") == "2");
    world.at(1).isPresent = false;
    QCOMPARE(bench.step(), NodeStatus::Failure);
    QVERIFY(bench.pendingDiagnostics().empty());
    QVERIFY(bench.events().empty());
  }

  void q24_waitingNodes_standStill() {
    FakeWorld world = pairOfPeople();
    world.at(0).velocity = base::Vec2(1.0, 0.0);
    TreeBench bench(world);
    QVERIFY(bench.load("<IsSpeaking agent_id='{id}' target_id='2' duration='1.0'/>"));
    bench.step();
    bench.step();
    QCOMPARE(bench.intent().motion, Motion::Stand);
  }

  /// The chance counts per tick: of ten ticks in a row at p = 0.1 one at least succeeds in 65 %.
  void q25_randomChance_isDrawnInEachTick() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(bench.load("<RandomChanceCondition agent_id='{id}' probability='0.1'/>"));
    int lucky = 0;
    constexpr int kRounds = 1000;
    for (int round = 0; round < kRounds; ++round) {
      bool isLucky = false;
      for (int tick = 0; tick < 10; ++tick) {
        isLucky = bench.step() == NodeStatus::Success || isLucky;
      }
      lucky += isLucky ? 1 : 0;
    }
    const double share = static_cast<double>(lucky) / kRounds;
    QVERIFY2(std::fabs(share - 0.6513215599) < 0.05, qPrintable(QString::number(share)));
  }

  void q26_timeExpired_keepsItsSumOverRounds() {
    FakeWorld world = pairOfPeople();
    TreeBench bench(world);
    QVERIFY(
        bench.load("<Sequence><IsRobotVisible agent_id='{id}' distance='3'/>"
                   "<TimeExpiredCondition seconds='0.2' ts='{dt}' only_once='true'/></Sequence>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
    world.robots[0].pose.position.x() = 50.0;
    bench.step();
    bench.step();
    world.robots[0].pose.position.x() = 2.0;
    QCOMPARE(bench.step(), NodeStatus::Success);
  }

  void q27_lookers_nearestFirst() {
    FakeWorld world = pairOfPeople();
    world.addPerson(3, 2.0, 0.0, base::kPi);
    TreeBench bench(world);
    QVERIFY(bench.load("<IsAnyoneLookingAtMe agent_id='{id}' observer_id='{o}'/>"));
    QVERIFY(bench.stepsUntil(NodeStatus::Success) > 0);
    QVERIFY(bench.entry("o") == "3");
  }

  void q29_impassive_takesTheRobotAsObstacle() {
    FakeWorld world = pairOfPeople();
    world.at(0).constants.behavior = sim2d::BehaviorType::Impassive;
    TreeBench bench(world);
    bench.control().goals = {{2, world.goals[2], 0.3}};
    QVERIFY(bench.load("<RegularNav agent_id='{id}'/>"));
    bench.step();
    QCOMPARE(bench.intent().robot, sim2d::RobotTreatment::Obstacle);
    world.quirks.set(29);
    bench.step();
    QCOMPARE(bench.intent().robot, sim2d::RobotTreatment::Pedestrian);
  }

  void q34_wall_hidesTheRobot() {
    FakeWorld world = pairOfPeople();
    world.isDark = true;
    TreeBench bench(world);
    QVERIFY(bench.load("<IsRobotVisible agent_id='{id}' distance='5'/>"));
    QCOMPARE(bench.step(), NodeStatus::Failure);
  }
};

QTEST_APPLESS_MAIN(HumanQuirksTest)
#include "tst_HumanQuirks.moc"
