#include <cmath>
#include <optional>

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
  void init() {
    world_ = pairOfPeople();
    bench_.emplace(world_);
  }

  void q01_randomChance_takesAgentId() {
    QVERIFY(bench_->load("<RandomChanceCondition agent_id='{id}' probability='0.5'/>"));
    QVERIFY(bench_->loadDiagnostics().empty());
    int successes = 0;
    for (int i = 0; i < 400; ++i) {
      successes += bench_->step() == NodeStatus::Success ? 1 : 0;
    }
    QVERIFY(successes > 150 && successes < 250);
  }

  void q02_scaredNav_withSafeDistance_flees() {
    QVERIFY(bench_->load("<ScaredNav agent_id='1' runaway_vel='1.2' safe_distance='4'/>"));
    bench_->step();
    QVERIFY((bench_->intent().target.position - base::Vec2(-2.0, 0.0)).norm() < 1e-12);
    QCOMPARE(bench_->intent().speed, 1.2);
  }

  void q02_scaredNav_withForceFactor_isPushed() {
    bench_->control().goals = {{2, base::Vec2(0.0, 2.0), 0.3}};
    QVERIFY(bench_->load("<ScaredNav agent_id='1' runaway_vel='0.6' scary_force_factor='20'/>"));
    bench_->step();
    QCOMPARE(bench_->intent().target.id, 2);
    QCOMPARE(bench_->intent().speed, 0.6);
    // 20 * 0.2 / (2 - 0.35), away from the robot
    QVERIFY((bench_->intent().extraForce - base::Vec2(-2.4242424242424243, 0.0)).norm() < 1e-9);
  }

  void q03_approachAgent_takesDistanceAndSpeed() {
    QVERIFY(
        bench_->load("<ApproachAgent agent_id='1' target_agent_id='2' closest_dist='0.5' "
                     "max_vel='1.0' duration='5'/>"));
    QVERIFY(bench_->loadDiagnostics().empty());
    bench_->step();
    bench_->step();
    QVERIFY(std::fabs(bench_->intent().speed - 3.0 / 3.5) < 1e-12);
  }

  void q04_updateGoal_withoutGoals_fails() {
    QVERIFY(bench_->load("<UpdateGoal agent_id='1'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
  }

  void q05_reactions_keepTheGoals() {
    const std::vector<sim2d::GoalItem> own = {{1, base::Vec2(0.1, 0.0), 0.3},
                                              {2, base::Vec2(0.0, 2.0), 0.3}};
    bench_->control().goals = own;
    QVERIFY(bench_->load("<ApproachRobot agent_id='1' closest_dist='0.5' max_vel='1.8'/>"));
    for (int i = 0; i < 30; ++i) {
      bench_->step();
    }
    QVERIFY(bench_->control().goals == own);
  }

  void q06_lookStep_isSymmetricAndLimitedByTime() {
    world_.at(0).pose.heading = 1.0;
    QVERIFY(bench_->load("<SurprisedNav agent_id='1'/>"));
    bench_->step();
    QVERIFY(std::fabs(world_.at(0).pose.heading - (1.0 - 0.1 * base::kPi)) < 1e-12);
  }

  void q06_original_overshootsToTheRight() {
    world_.quirks.set(6);
    world_.at(0).pose.heading = 0.1;
    QVERIFY(bench_->load("<SurprisedNav agent_id='1'/>"));
    bench_->step();
    QVERIFY(std::fabs(world_.at(0).pose.heading - (0.1 - 0.2 * base::kPi)) < 1e-12);
    bench_->step();
    QVERIFY(std::fabs(world_.at(0).pose.heading) < 1e-12);
  }

  void q07_blockAgent_standsInFront() {
    world_.at(1).pose.heading = 0.5 * base::kPi;
    QVERIFY(bench_->load("<BlockAgent agent_id='1' target_agent_id='2' front_dist='1'/>"));
    bench_->step();
    bench_->step();
    QVERIFY((bench_->intent().target.position - base::Vec2(3.0, 1.0)).norm() < 1e-9);
    world_.quirks.set(7);
    bench_->step();
    QVERIFY((bench_->intent().target.position - base::Vec2(4.0, 0.0)).norm() < 1e-9);
  }

  void q09_setGoal_inTheFirstTick_replacesTheScenariosGoals() {
    world_.at(0).constants.goalRadius = 0.25;
    bench_->control().goals = {{2, world_.goals[2], 0.25}, {1, world_.goals[1], 0.25}};
    QVERIFY(
        bench_->load("<Sequence><SetGoal agent_id='{id}' goal_id='1'/>"
                     "<SetGoal agent_id='{id}' goal_id='2'/></Sequence>"));
    bench_->step();
    QCOMPARE(bench_->control().goals.size(), std::size_t(2));
    QCOMPARE(bench_->control().goals[0].id, 1);
    QCOMPARE(bench_->control().goals[1].id, 2);
    QCOMPARE(bench_->control().goals[0].radius, 0.25);
    bench_->step();  // both are in the list
    QCOMPARE(bench_->control().goals.size(), std::size_t(2));
  }

  void q09_original_appendsWithSmallRadius() {
    world_.quirks.set(9);
    bench_->control().goals = {{1, world_.goals[1], 0.3}};
    QVERIFY(bench_->load("<SetGoal agent_id='{id}' goal_id='1'/>"));
    bench_->step();
    QCOMPARE(bench_->control().goals.size(), std::size_t(2));
    QCOMPARE(bench_->control().goals[1].radius, 0.1);
  }

  void q10_timers_countSimulatedTime() {
    world_.stepLength = 0.05;
    QVERIFY(bench_->load("<StopAndWaitTimerAction agent_id='1' wait_duration='1.0'/>"));
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 21);
  }

  void q11_stopAndWait_halted_givesFreedomBack() {
    QVERIFY(bench_->load("<StopAndWaitTimerAction agent_id='1' wait_duration='1.0'/>"));
    bench_->step();
    QVERIFY(bench_->control().frozen);
    bench_->halt();
    QVERIFY(!bench_->control().frozen);
    world_.quirks.set(11);
    bench_->step();
    bench_->halt();
    QVERIFY(bench_->control().frozen);
  }

  void q11_stopAndWait_insideStop_leavesThePersonStopped() {
    bench_->control().frozen = true;
    QVERIFY(bench_->load("<StopAndWaitTimerAction agent_id='1' wait_duration='0.2'/>"));
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 3);
    QVERIFY(bench_->control().frozen);
  }

  void q12_goTo_usesItsTolerance() {
    QVERIFY(bench_->load("<GoTo agent_id='1' goal_id='1' tolerance='0.9'/>"));
    bench_->step();
    QCOMPARE(bench_->step(), NodeStatus::Success);  // 1.0 m away
  }

  void q12_original_ignoresIt() {
    world_.quirks.set(12);
    QVERIFY(bench_->load("<GoTo agent_id='1' goal_id='1' tolerance='0.9'/>"));
    bench_->step();
    QCOMPARE(bench_->step(), NodeStatus::Running);
  }

  void q13_approachAgent_near_doesNotStopForGood() {
    world_.at(0).pose.position = base::Vec2(2.0, 0.0);
    QVERIFY(bench_->load("<ApproachAgent agent_id='1' target_agent_id='2'/>"));
    bench_->step();
    bench_->step();
    QVERIFY(!bench_->control().frozen);
    world_.quirks.set(13);
    bench_->step();
    QVERIFY(bench_->control().frozen);
  }

  void q14_q16_conversation_movesTheMembersInsteadOfTheirTrees() {
    world_.goals[5] = base::Vec2(1.5, 3.0);
    bench_->control(1).goals = {{1, world_.goals[1], 0.3}};
    QVERIFY(
        bench_->load("<ConversationFormation main_agent_id='{id}' goal_id='5' "
                     "conversation_duration='1' non_main_agent_ids='2' time_step='{dt}'/>"));
    QVERIFY(bench_->load("<RegularNav agent_id='{id}' time_step='{dt}'/>", 1));
    bench_->step();
    bench_->step();
    QVERIFY(!bench_->intent(1).targetIsGoal);
    QVERIFY((bench_->intent(1).target.position - base::Vec2(2.2, 3.0)).norm() < 1e-9);
    QVERIFY(bench_->intent(1).active);
    QCOMPARE(bench_->control(1).goals.front().id, 1);
    QVERIFY(bench_->stepsUntil(NodeStatus::Success) > 0);
  }

  void q16_laterCaptor_overridesAnEarlierTree() {
    bench_->control(0).goals = {{1, world_.goals[1], 0.3}};
    QVERIFY(bench_->load("<RegularNav agent_id='{id}' time_step='{dt}'/>"));
    QVERIFY(
        bench_->load("<ConversationFormation main_agent_id='{id}' goal_id='2' "
                     "non_main_agent_ids='1' time_step='{dt}'/>",
                     1));
    bench_->step();
    QVERIFY(bench_->intent(0).targetIsGoal);
    bench_->step();
    QVERIFY(!bench_->intent(0).targetIsGoal);
  }

  void q15_conversation_secondRun_lastsAsLong() {
    QVERIFY(
        bench_->load("<ConversationFormation main_agent_id='{id}' goal_id='2' "
                     "conversation_duration='1' non_main_agent_ids='2' time_step='{dt}'/>"));
    QVERIFY(bench_->stepsUntil(NodeStatus::Success) > 0);
    QVERIFY(bench_->stepsUntil(NodeStatus::Success) >= 11);
  }

  void q17_groupWalk_restoresGroups() {
    bench_->control(0).goals = {{2, world_.goals[2], 0.3}};
    bench_->control(1).goals = {{1, world_.goals[1], 0.3}};
    bench_->control(1).group = 7;
    QVERIFY(
        bench_->load("<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2' "
                     "duration='0.2'/>"));
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench_->control(0).group, -1);
    QCOMPARE(bench_->control(1).group, 7);
    QCOMPARE(bench_->control(1).goals.front().id, 1);
    world_.quirks.set(17);
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench_->control(1).group, -1);
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
    world_.at(0).constants.desiredSpeed = own;
    if (isOriginal) {
      world_.quirks.set(18);
    }
    QVERIFY(bench_->load("<FollowAgent agent_id='1' target_agent_id='2' closest_dist='1.5' " +
                         maxVel.toStdString() + "/>"));
    QVERIFY(bench_->loadDiagnostics().empty());
    bench_->step();
    bench_->step();
    QCOMPARE(bench_->intent().speed, far);
    world_.at(0).pose.position = base::Vec2(2.25, 0.0);
    bench_->step();
    QCOMPARE(bench_->intent().speed, near);
  }

  void q18_followAgent_original_ignoresMaxVelFarAway() {
    world_.quirks.set(18);
    QVERIFY(bench_->load("<FollowAgent agent_id='1' target_agent_id='2' max_vel='0.5'/>"));
    bench_->step();
    bench_->step();
    QCOMPARE(bench_->intent().speed, 1.0);
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
    if (isOriginal) {
      world_.quirks.set(19);
    }
    bench_->society().speech.say(1, 1, "Hello");
    world_.present = 1 + silence;
    bench_->society().speech.beginStep();
    QVERIFY(bench_->load("<IsSpeaking agent_id='{id}' target_id='2' duration='1.0'/>"));
    bench_->step();
    QCOMPARE(bench_->step() == NodeStatus::Success, isHeard);
  }

  void q20_timeDelay_waitsInEveryRound() {
    QVERIFY(bench_->load("<TimeDelay delay='0.2'><AlwaysSuccess/></TimeDelay>"));
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 3);
    world_.quirks.set(20);
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 3);
    QCOMPARE(bench_->stepsUntil(NodeStatus::Success), 1);
  }

  void q21_unknownAgent_failsWithOneWarning() {
    QVERIFY(bench_->load("<FollowAgent agent_id='{id}' target_agent_id='9'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->pendingDiagnostics().size(), std::size_t(1));
    QVERIFY(!bench_->isFaulty());
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
    QVERIFY(bench_->load(body.toStdString()));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QCOMPARE(bench_->pendingDiagnostics().size(), std::size_t(1));
  }

  void q23_findNearestAgent_saysNothing() {
    QVERIFY(bench_->load("<FindNearestAgent agent_id='{id}' target_agent_id='{nearest}'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Success);
    QVERIFY(bench_->entry("nearest") == "2");
    world_.at(1).isPresent = false;
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QVERIFY(bench_->pendingDiagnostics().empty());
    QVERIFY(bench_->events().empty());
  }

  void q24_waitingNodes_standStill() {
    world_.at(0).velocity = base::Vec2(1.0, 0.0);
    QVERIFY(bench_->load("<IsSpeaking agent_id='{id}' target_id='2' duration='1.0'/>"));
    bench_->step();
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Stand);
  }

  /// The chance counts per tick: of ten ticks in a row at p = 0.1 one at least succeeds in 65 %.
  void q25_randomChance_isDrawnInEachTick() {
    QVERIFY(bench_->load("<RandomChanceCondition agent_id='{id}' probability='0.1'/>"));
    int lucky = 0;
    constexpr int kRounds = 1000;
    for (int round = 0; round < kRounds; ++round) {
      bool isLucky = false;
      for (int tick = 0; tick < 10; ++tick) {
        isLucky = bench_->step() == NodeStatus::Success || isLucky;
      }
      lucky += isLucky ? 1 : 0;
    }
    const double share = static_cast<double>(lucky) / kRounds;
    QVERIFY2(std::fabs(share - 0.6513215599) < 0.05, qPrintable(QString::number(share)));
  }

  void q26_timeExpired_keepsItsSumOverRounds() {
    QVERIFY(bench_->load(
        "<Sequence><IsRobotVisible agent_id='{id}' distance='3'/>"
        "<TimeExpiredCondition seconds='0.2' ts='{dt}' only_once='true'/></Sequence>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    world_.robots[0].pose.position.x() = 50.0;
    bench_->step();
    bench_->step();
    world_.robots[0].pose.position.x() = 2.0;
    QCOMPARE(bench_->step(), NodeStatus::Success);
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
    world_.at(0).constants.behavior = sim2d::BehaviorType::Impassive;
    bench_->control().goals = {{2, world_.goals[2], 0.3}};
    QVERIFY(bench_->load("<RegularNav agent_id='{id}'/>"));
    bench_->step();
    QCOMPARE(bench_->intent().robot, sim2d::RobotTreatment::Obstacle);
    world_.quirks.set(29);
    bench_->step();
    QCOMPARE(bench_->intent().robot, sim2d::RobotTreatment::Pedestrian);
  }

  void q34_wall_hidesTheRobot() {
    world_.isDark = true;
    QVERIFY(bench_->load("<IsRobotVisible agent_id='{id}' distance='5'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
  }

 private:
  FakeWorld world_;
  std::optional<TreeBench> bench_;
};

QTEST_APPLESS_MAIN(HumanQuirksTest)
#include "tst_HumanQuirks.moc"
