#include <optional>

#include <QtTest>

#include "tests/bt/FakeWorld.h"

using base::NodeStatus;
using sim2d::Motion;

namespace {

/// Person 1 at the origin looking along x, person 2 ahead looking back, person 3 to the left;
/// the robot between 1 and 2, facing 1. dt = 0.1 s.
FakeWorld scene() {
  FakeWorld world;
  world.addPerson(1, 0.0, 0.0, 0.0);
  world.addPerson(2, 3.0, 0.0, base::kPi);
  world.addPerson(3, 0.0, 4.0, 0.0);
  world.addRobot(2.0, 0.0, base::kPi);
  world.goals = {{1, base::Vec2(1.0, 0.0)}, {2, base::Vec2(0.0, 2.0)}, {3, base::Vec2(0.05, 0.0)}};
  return world;
}

QString letter(NodeStatus status) {
  switch (status) {
    case NodeStatus::Success:
      return QStringLiteral("S");
    case NodeStatus::Failure:
      return QStringLiteral("F");
    case NodeStatus::Running:
      return QStringLiteral("R");
    default:
      return QStringLiteral("-");
  }
}

void addRow(const char* body, const char* statuses) {
  QTest::newRow(body) << QByteArray(body) << QByteArray(statuses);
}

void rowsOfInstantNodes() {
  addRow("<IsRobotVisible agent_id='{id}' distance='2.0'/>", "SS");
  addRow("<IsRobotVisible agent_id='{id}' distance='1.9'/>", "FF");
  addRow("<IsRobotVisible agent_id='3' distance='5'/>", "S");
  addRow("<IsRobotClose agent_id='1' threshold='2.0'/>", "F");
  addRow("<IsRobotClose agent_id='1' threshold='2.01'/>", "S");
  addRow("<IsRobotClose agent_id='2'/>", "F");
  addRow("<IsRobotFacingAgent agent_id='1'/>", "S");
  addRow("<IsRobotFacingAgent agent_id='2'/>", "F");
  addRow("<IsAgentVisible observer_id='1' agent_id='2' distance='3' field_of_view='0.1'/>", "S");
  addRow("<IsAgentVisible observer_id='1' agent_id='3' distance='5' field_of_view='1.5'/>", "F");
  addRow("<IsAgentVisible observer_id='1' agent_id='3'/>", "S");
  addRow("<IsAgentClose observer_id='1' target_agent_id='2' threshold='3.0'/>", "F");
  addRow("<IsAgentClose observer_id='1' target_agent_id='2' threshold='3.1'/>", "S");
  addRow("<IsAtPosition agent_id='1' goal_id='3'/>", "S");
  addRow("<IsAtPosition agent_id='1' goal_id='1' tolerance='0.9'/>", "F");
  addRow("<IsAtPosition agent_id='1' target_x='0.0' target_y='0.1'/>", "S");
  addRow("<IsGoalReached agent_id='1'/>", "F");
  addRow("<TimeExpiredCondition seconds='0.3' ts='{dt}' only_once='false'/>", "FFSFFS");
  addRow("<TimeExpiredCondition seconds='0.3' ts='{dt}' only_once='true'/>", "FFSSSS");
  addRow("<RandomChanceCondition agent_id='{id}' probability='0.0'/>", "FFF");
  addRow("<RandomChanceCondition agent_id='{id}' probability='1.0'/>", "SSS");
  addRow("<UpdateGoal agent_id='1'/>", "F");
  addRow("<SetGoal agent_id='1' goal_id='2'/>", "S");
  addRow("<RegularNav agent_id='1' time_step='{dt}'/>", "S");
  addRow("<SurprisedNav agent_id='1' time_step='{dt}'/>", "S");
  addRow("<CuriousNav agent_id='1' time_step='{dt}' agent_vel='1.0' stop_distance='0.5'/>", "S");
  addRow("<ScaredNav agent_id='1' time_step='{dt}' runaway_vel='1.5'/>", "S");
  addRow("<ThreateningNav agent_id='1' time_step='{dt}' goal_dist='1.0'/>", "S");
  addRow("<FindNearestAgent agent_id='1' target_agent_id='{target}'/>", "S");
  addRow("<SaySomething agent_id='1' message='Hello'/>", "S");
  addRow("<SetGroupId agent_id='1' group_id='4'/>", "S");
  addRow("<StopMovement agent_id='1'/>", "S");
  addRow("<ResumeMovement agent_id='1'/>", "S");
}

/// RUNNING in the first tick, time over in step 1 + duration / dt.
void rowsOfStatefulNodes() {
  addRow("<StopAndWaitTimerAction agent_id='1' wait_duration='0.3'/>", "RRRSRRRS");
  addRow("<GoTo agent_id='1' goal_id='3' time_step='{dt}'/>", "RSRS");
  addRow(
      "<ApproachRobot agent_id='1' time_step='{dt}' closest_dist='1.5' max_vel='1.8' "
      "duration='0.3'/>",
      "RRRS");
  addRow(
      "<AvoidRobot agent_id='1' time_step='{dt}' safe_distance='3' runaway_vel='1' "
      "duration='0.2'/>",
      "RRS");
  addRow("<BlockRobot agent_id='1' time_step='{dt}' front_dist='1' duration='0.1'/>", "RSRS");
  addRow("<BlockRobot agent_id='1' time_step='{dt}' front_dist='1'/>", "RRRRR");
  addRow("<ApproachAgent agent_id='1' target_agent_id='2' time_step='{dt}' duration='0.2'/>",
         "RRS");
  addRow("<FollowAgent agent_id='1' target_agent_id='2' time_step='{dt}'/>", "RRRRR");
  addRow(
      "<BlockAgent agent_id='1' target_agent_id='2' time_step='{dt}' front_dist='1' "
      "duration='0.2'/>",
      "RRS");
  addRow(
      "<SetGroupWalk main_agent_id='1' non_main_agent_ids='2' time_step='{dt}' "
      "duration='0.2'/>",
      "RRS");
  addRow("<LookAtPoint agent_id='1' goal_id='1'/>", "RSRS");
  addRow("<LookAtPoint agent_id='1' goal_id='2'/>", "RRRRRS");  // 90 degrees at 18 degrees a step
  addRow("<LookAtAgent observer_id='1' target_id='3'/>", "RRRRRS");
  addRow("<LookAtRobot agent_id='3' yaw_tolerance='0.01'/>", "RRRRS");  // 63.4 degrees
  addRow("<IsLookingAtMe agent_id='1' time_step='{dt}' target_id='2'/>", "RS");
  addRow("<IsLookingAtMe agent_id='1' time_step='{dt}' target_id='3' duration='0.3'/>", "RRRF");
  addRow(
      "<IsLookingAtMe agent_id='1' time_step='{dt}' target_id='2' "
      "distance_threshold='2.9' duration='0'/>",
      "RFRF");
  addRow("<IsAnyoneLookingAtMe agent_id='1' time_step='{dt}' observer_id='{o}'/>", "RS");
  addRow(
      "<IsAnyoneLookingAtMe agent_id='3' time_step='{dt}' duration='0.2' "
      "observer_id='{o}'/>",
      "RRF");
  addRow("<IsAnyoneSpeaking agent_id='1' time_step='{dt}' duration='0.2' speaker_id='{s}'/>",
         "RRF");
  addRow("<IsSpeaking agent_id='1' time_step='{dt}' target_id='2' duration='0.2'/>", "RRF");
  addRow("<TimeDelay delay='0.3'><AlwaysSuccess/></TimeDelay>", "FFFSFFFS");
}

}  // namespace

class HumanNodesTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void manifests_ofNodesThatUseTheGoals_sayIt() {
    const bt::NodeLibrary nodes = bt::humanNodes();
    QStringList ids;
    for (const bt::NodeManifest& node : nodes.catalogue().all()) {
      if (node.usesGoals) {
        ids << QString::fromStdString(node.id);
      }
    }
    ids.sort();
    QCOMPARE(ids.join(QLatin1Char(' ')),
             QStringLiteral("PassOnSide RegularNav ScaredNav SetGoal SetGroupWalk UpdateGoal"));
  }
  void init() {
    world_ = scene();
    bench_.emplace(world_);
  }

  void status_ofEachTick_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::addColumn<QByteArray>("statuses");
    rowsOfInstantNodes();
    rowsOfStatefulNodes();
  }
  void status_ofEachTick() {
    QFETCH(QByteArray, body);
    QFETCH(QByteArray, statuses);
    QVERIFY(bench_->load(body.toStdString()));
    for (const base::Diagnostic& diagnostic : bench_->loadDiagnostics()) {
      QFAIL(diagnostic.text().c_str());
    }
    QString found;
    for (int i = 0; i < statuses.size(); ++i) {
      found += letter(bench_->step());
    }
    QVERIFY(!bench_->isFaulty());
    QCOMPARE(found, QString::fromUtf8(statuses));
  }

  void requiredPort_missing_faultsTheTree_data() {
    QTest::addColumn<QByteArray>("body");
    QTest::newRow("agent") << QByteArray("<RegularNav agent_id='{nobody}'/>");
    QTest::newRow("goal") << QByteArray("<GoTo agent_id='1' goal_id='{nothing}'/>");
    QTest::newRow("list") << QByteArray(
        "<SetGroupWalk main_agent_id='1' non_main_agent_ids='all'/>");
  }
  void requiredPort_missing_faultsTheTree() {
    QFETCH(QByteArray, body);
    QVERIFY(bench_->load(body.toStdString()));
    bench_->step();
    QVERIFY(bench_->isFaulty());
  }

  void robotNodes_withoutRobot_fail_data() {
    QTest::addColumn<QByteArray>("body");
    for (const char* body :
         {"<IsRobotVisible agent_id='1' distance='9'/>", "<IsRobotClose agent_id='1'/>",
          "<IsRobotFacingAgent agent_id='1'/>", "<SurprisedNav agent_id='1'/>",
          "<CuriousNav agent_id='1' agent_vel='1' stop_distance='1'/>",
          "<ScaredNav agent_id='1' runaway_vel='1'/>",
          "<ThreateningNav agent_id='1' goal_dist='1'/>",
          "<ApproachRobot agent_id='1' closest_dist='1' max_vel='1'/>",
          "<AvoidRobot agent_id='1' safe_distance='1' runaway_vel='1'/>",
          "<BlockRobot agent_id='1' front_dist='1'/>", "<LookAtRobot agent_id='1'/>"}) {
      QTest::newRow(body) << QByteArray(body);
    }
  }
  void robotNodes_withoutRobot_fail() {
    QFETCH(QByteArray, body);
    world_.robots.clear();
    QVERIFY(bench_->load(body.toStdString()));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QVERIFY(!bench_->isFaulty());
  }

  void regularNav_withGoal_walksToIt() {
    bench_->control().goals = {{2, base::Vec2(0.0, 2.0), 0.3}};
    QVERIFY(bench_->load("<RegularNav agent_id='{id}' time_step='{dt}'/>"));
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Walk);
    QVERIFY(bench_->intent().targetIsGoal);
    QCOMPARE(bench_->intent().target.id, 2);
    QCOMPARE(bench_->intent().speed, 1.0);
    QVERIFY(!bench_->intent().active);
    QCOMPARE(bench_->intent().robot, sim2d::RobotTreatment::Pedestrian);
  }

  void regularNav_withoutGoal_brakes() {
    QVERIFY(bench_->load("<RegularNav agent_id='{id}' time_step='{dt}'/>"));
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Brake);
  }

  void goTo_whileRunning_replacesGoalsAndRestoresThem() {
    const std::vector<sim2d::GoalItem> own = {{2, base::Vec2(0.0, 2.0), 0.3}};
    bench_->control().goals = own;
    QVERIFY(bench_->load("<GoTo agent_id='{id}' goal_id='1' time_step='{dt}'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Running);
    QCOMPARE(bench_->intent().motion, Motion::Stand);
    QCOMPARE(bench_->control().goals.front().id, 1);
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Walk);
    QVERIFY(!bench_->intent().targetIsGoal);
    QVERIFY(bench_->stepsUntil(NodeStatus::Success) > 0);
    QVERIFY(bench_->control().goals == own);
    QVERIFY((world_.at(0).pose.position - base::Vec2(1.0, 0.0)).norm() <= 0.2);
  }

  void goTo_halted_restoresGoals() {
    bench_->control().goals = {{2, base::Vec2(0.0, 2.0), 0.3}};
    QVERIFY(bench_->load("<GoTo agent_id='{id}' goal_id='1' time_step='{dt}'/>"));
    bench_->step();
    bench_->halt();
    QCOMPARE(bench_->control().goals.front().id, 2);
  }

  void approachRobot_farAndNear_slowsAndFaces() {
    QVERIFY(
        bench_->load("<ApproachRobot agent_id='1' time_step='{dt}' closest_dist='1.5' "
                     "max_vel='1.8'/>"));
    bench_->step();
    QVERIFY(bench_->intent().active);
    bench_->step();
    // 1.8 * 2 / (2 + 1.5)
    QVERIFY(std::fabs(bench_->intent().speed - 1.0285714285714285) < 1e-12);
    QCOMPARE(bench_->intent().robot, sim2d::RobotTreatment::Obstacle);
    QVERIFY(bench_->intent().active);
    world_.at(0).pose = {base::Vec2(1.0, 0.0), 0.5};
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Turn);
    QVERIFY(std::fabs(bench_->intent().heading) < 1e-12);
  }

  void avoidRobot_insideSafeDistance_walksStraightAway() {
    QVERIFY(bench_->load("<AvoidRobot agent_id='1' safe_distance='3' runaway_vel='1.4'/>"));
    bench_->step();
    bench_->step();
    QVERIFY((bench_->intent().target.position - base::Vec2(-1.0, 0.0)).norm() < 1e-12);
    QCOMPARE(bench_->intent().target.radius, 0.3);
    QCOMPARE(bench_->intent().speed, 1.4);
    world_.at(0).pose.position.x() = -1.5;
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Turn);
  }

  void blockRobot_farAndInPlace_walksThenFaces() {
    world_.at(0).pose.position = base::Vec2(-3.0, 0.0);
    QVERIFY(bench_->load("<BlockRobot agent_id='1' front_dist='1.0'/>"));
    bench_->step();
    bench_->step();
    // in front of a robot at (2, 0) that looks along -x
    QVERIFY((bench_->intent().target.position - base::Vec2(1.0, 0.0)).norm() < 1e-9);
    QCOMPARE(bench_->intent().speed, 2.5);
    world_.at(0).pose = {base::Vec2(0.9, 0.1), 1.0};
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Turn);
    world_.robots[0].velocity = base::Vec2(-0.5, 0.0);
    world_.at(0).pose = {base::Vec2(0.9, 0.1), 1.0};
    bench_->step();
    QCOMPARE(bench_->intent().motion, Motion::Stand);
  }

  void followAgent_byDistance_limitsSpeed() {
    QVERIFY(
        bench_->load("<FollowAgent agent_id='1' target_agent_id='2' closest_dist='1.5' "
                     "max_vel='0.8'/>"));
    bench_->step();
    bench_->step();
    QCOMPARE(bench_->intent().speed, 0.8);
    world_.at(0).pose.position = base::Vec2(2.25, 0.0);
    bench_->step();
    QVERIFY(std::fabs(bench_->intent().speed - 0.2) < 1e-12);  // 0.8 * (0.75 / 1.5)^2
  }

  void findNearestAgent_writesTheEntry() {
    QVERIFY(bench_->load("<FindNearestAgent agent_id='{id}' target_agent_id='{target}'/>"));
    bench_->step();
    QVERIFY(bench_->entry("target") == "2");
  }

  void speech_saidByOne_isHeardByAnother() {
    QVERIFY(
        bench_->load("<IsAnyoneSpeaking agent_id='{id}' time_step='{dt}' speaker_id='{who}'/>"));
    QVERIFY(
        bench_->load("<RunOnce><SaySomething agent_id='{id}' message='Follow me'/></RunOnce>", 1));
    QCOMPARE(bench_->step(), NodeStatus::Running);
    QCOMPARE(bench_->events().size(), std::size_t(1));
    QCOMPARE(bench_->events()[0].kind, sim2d::EventKind::Say);
    QVERIFY(bench_->events()[0].text == "Follow me");
    QCOMPARE(bench_->step(), NodeStatus::Success);
    QVERIFY(bench_->entry("who") == "2");
    QCOMPARE(bench_->events()[0].kind, sim2d::EventKind::Heard);
    QCOMPARE(bench_->events()[0].id, 1);
    QCOMPARE(bench_->events()[0].other, 2);
    // the node accepts the words once
    bench_->step();
    QCOMPARE(bench_->step(), NodeStatus::Running);
  }

  void updateGoal_cyclicAndOneWay_rotatesOrRemoves() {
    bench_->control().goals = {{3, base::Vec2(0.05, 0.0), 0.3}, {1, base::Vec2(1.0, 0.0), 0.3}};
    QVERIFY(bench_->load("<UpdateGoal agent_id='{id}'/>"));
    bench_->step();
    QCOMPARE(bench_->control().goals.size(), std::size_t(2));
    QCOMPARE(bench_->control().goals.front().id, 1);
    QCOMPARE(bench_->events().size(), std::size_t(1));  // it was reached
    QVERIFY(bench_->events()[0].text == "3");
    bench_->step();
    QVERIFY(bench_->events().empty());  // goal 1 was not
    world_.at(0).constants.cyclicGoals = false;
    bench_->control().goals.resize(1);
    bench_->step();
    QVERIFY(bench_->control().goals.empty());
    QCOMPARE(bench_->events().back().kind, sim2d::EventKind::Arrived);
  }

  void setGroupWalk_leadsTheMainPerson() {
    bench_->control(0).goals = {{2, base::Vec2(0.0, 2.0), 0.3}};
    bench_->control(1).group = 7;
    QVERIFY(
        bench_->load("<SetGroupWalk main_agent_id='{id}' non_main_agent_ids='2,3' "
                     "time_step='{dt}' duration='0.3'/>"));
    bench_->step();
    QCOMPARE(bench_->control(0).group, 1);
    QCOMPARE(bench_->control(1).group, 1);
    QCOMPARE(bench_->control(2).group, 1);
    QCOMPARE(bench_->control(2).goals.front().id, 2);
    QCOMPARE(bench_->events().size(), std::size_t(3));
    bench_->step();
    QCOMPARE(bench_->intent(0).motion, Motion::Walk);
    QCOMPARE(bench_->intent(1).motion, Motion::Stand);  // by their own trees
  }

  void conversation_ofThree_facesTheCentre() {
    world_.robots.clear();
    QVERIFY(
        bench_->load("<ConversationFormation main_agent_id='{id}' goal_id='2' "
                     "conversation_duration='1.0' non_main_agent_ids='2,3' time_step='{dt}'/>"));
    QVERIFY(bench_->stepsUntil(NodeStatus::Success) > 10);
    const base::Vec2 centre(0.0, 2.0);
    for (int i = 0; i < 3; ++i) {
      const base::Pose2 pose = world_.at(i).pose;
      QVERIFY(std::fabs((pose.position - centre).norm() - 0.9) < 0.11);
      const double heading = base::headingOf(centre - pose.position);
      QVERIFY(std::fabs(base::angleDiff(heading, pose.heading)) <= 0.01);
    }
  }

  void otherAgentsId_movesThatPerson() {
    QVERIFY(bench_->load("<LookAtPoint agent_id='3' goal_id='1'/>"));
    bench_->step();
    bench_->step();
    QCOMPARE(bench_->intent(2).motion, Motion::Turn);
    QCOMPARE(bench_->intent(0).motion, Motion::Stand);
  }

  void personWhoLeft_failsWithoutWarning() {
    world_.at(1).isPresent = false;
    QVERIFY(bench_->load("<IsAgentVisible observer_id='{id}' agent_id='2'/>"));
    QCOMPARE(bench_->step(), NodeStatus::Failure);
    QVERIFY(bench_->pendingDiagnostics().empty());
  }

  void allNodes_areDocumented() {
    const bt::NodeLibrary library = bt::humanNodes();
    int count = 0;
    for (const bt::NodeManifest& manifest : library.catalogue().all()) {
      count += manifest.origin == bt::NodeOrigin::HuNavSim ? 1 : 0;
      QVERIFY2(!manifest.description.empty(), manifest.id.c_str());
      QVERIFY2(!manifest.category.empty(), manifest.id.c_str());
      for (const bt::PortSpec& port : manifest.ports) {
        QVERIFY2(!port.help.empty(), (manifest.id + "." + port.key).c_str());
      }
    }
    QCOMPARE(count, 39);
  }

 private:
  FakeWorld world_;
  std::optional<TreeBench> bench_;
};

QTEST_APPLESS_MAIN(HumanNodesTest)
#include "tst_HumanNodes.moc"
