#include <algorithm>
#include <cmath>

#include <QTemporaryDir>
#include <QtTest>

#include "bt/human/TreeBehavior.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/World.h"

using base::Vec2;
using sim2d::EventKind;

namespace {

const char* const kFirst = R"(<root BTCPP_format="4"><BehaviorTree ID="Agent1Tree">
<SequenceWithMemory name="Agent1">
 <GoTo name="first" agent_id="{id}" goal_id="1" time_step="{dt}"/>
 <IsRobotVisible agent_id="{id}" distance="10.0"/>
 <TimeDelay delay="2.0"><LookAtRobot name="look" agent_id="{id}"/></TimeDelay>
 <StopAndWaitTimerAction agent_id="{id}" wait_duration="1.5"/>
 <GoTo agent_id="{id}" goal_id="2" time_step="{dt}"/>
 <LookAtPoint agent_id="{id}" goal_id="3"/>
 <StopAndWaitTimerAction agent_id="{id}" wait_duration="3.0"/>
 <GoTo agent_id="{id}" goal_id="4" time_step="{dt}"/>
 <LookAtPoint agent_id="{id}" goal_id="5"/>
 <StopAndWaitTimerAction agent_id="{id}" wait_duration="5.0"/>
 <GoTo agent_id="{id}" goal_id="6" time_step="{dt}"/>
 <LookAtPoint agent_id="{id}" goal_id="7"/>
 <StopAndWaitTimerAction name="last" agent_id="{id}" wait_duration="3.0"/>
 <RetryUntilSuccessful num_attempts="100">
  <IsAtPosition agent_id="2" goal_id="8" tolerance="0.5"/>
 </RetryUntilSuccessful>
 <LookAtAgent name="greet" observer_id="{id}" target_id="2"/>
 <IsSpeaking agent_id="{id}" time_step="{dt}" target_id="2" duration="15.0" distance_threshold="5.0"/>
 <FollowAgent agent_id="{id}" target_agent_id="2" time_step="{dt}"/>
</SequenceWithMemory></BehaviorTree></root>)";

const char* const kSecond = R"(<root BTCPP_format="4"><BehaviorTree ID="Agent2Tree">
<SequenceWithMemory name="Agent2">
 <GoTo agent_id="{id}" goal_id="9" time_step="{dt}"/>
 <LookAtPoint agent_id="{id}" goal_id="10"/>
 <TimeDelay delay="2.0"><LookAtRobot agent_id="{id}"/></TimeDelay>
 <TimeDelay delay="1.0">
  <ApproachRobot agent_id="{id}" time_step="{dt}" closest_dist="1.2" max_vel="1.8" duration="8.0"/>
 </TimeDelay>
 <GoTo agent_id="{id}" goal_id="11" time_step="{dt}"/>
 <LookAtPoint agent_id="{id}" goal_id="12"/>
 <TimeDelay delay="3.0"><GoTo agent_id="{id}" goal_id="13" time_step="{dt}"/></TimeDelay>
 <LookAtPoint agent_id="{id}" goal_id="14"/>
 <TimeDelay delay="3.0"><LookAtAgent observer_id="{id}" target_id="1"/></TimeDelay>
 <RetryUntilSuccessful num_attempts="100">
  <IsLookingAtMe agent_id="{id}" time_step="{dt}" target_id="1" distance_threshold="15.0" angle_threshold="0.2" duration="30.0"/>
 </RetryUntilSuccessful>
 <ConversationFormation main_agent_id="{id}" goal_id="15" conversation_duration="6.0" non_main_agent_ids="1" time_step="{dt}"/>
 <RunOnce><SaySomething agent_id="{id}" message="Follow me"/></RunOnce>
 <GoTo name="leave" agent_id="{id}" goal_id="16" time_step="{dt}"/>
</SequenceWithMemory></BehaviorTree></root>)";

sim2d::Scenario scenarioOf() {
  sim2d::Scenario scenario;
  const std::vector<Vec2> points = {{-4.5, -3.0},    {-3.0, -1.7},  {-2.57, 0.0},  {-7.56, -1.524},
                                    {-7.88, -2.524}, {-7.56, 8.76}, {-7.87, 8.96}, {-2.35, 5.1},
                                    {0.22, -5.51},   {3.91, -4.51}, {2.0, 3.5},    {3.0, 3.5},
                                    {-2.35, 5.1},    {-2.57, 7.64}, {-6.0, 5.6},   {-2.48, -14.95}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    scenario.goals.push_back({{}, static_cast<int>(i) + 1, points[i], {}});
  }
  const std::vector<Vec2> starts = {{-6.487, -9.952}, {-5.809, -10.012}};
  for (int id = 1; id <= 2; ++id) {
    sim2d::Human human;
    human.id = id;
    human.name = "agent" + std::to_string(id);
    human.initPose = {starts[static_cast<std::size_t>(id - 1)], 0.0};
    human.goals = {1, 2, 3};
    human.maxVel = 1.5;
    human.radius = 0.4;
    human.goalRadius = 0.3;
    scenario.humans.push_back(human);
  }
  sim2d::Robot robot;
  robot.name = "robot1";
  robot.start = {Vec2(-0.5, -3.5), 0.0};
  scenario.robots = {robot};
  return scenario;
}

double distanceOf(const sim2d::Frame& frame, std::size_t row, const Vec2& point) {
  return (Vec2(frame.humans.x[row], frame.humans.y[row]) - point).norm();
}

}  // namespace

/// The two workers of the HuNavSim 2.0 paper in the running world, without walls.
class HumanWarehouseTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void twoWorkers_meetTalkAndLeaveTogether() {
    QTemporaryDir folder;
    bt::TreeFiles files;
    for (const auto& [name, text] : {std::pair("agent1", kFirst), std::pair("agent2", kSecond)}) {
      files[name] = folder.path().toStdString() + "/" + name + ".xml";
      QVERIFY(base::writeFileAtomically(files[name], text).empty());
    }
    sim2d::WorldSetup setup;
    const auto scenario = std::make_shared<const sim2d::Scenario>(scenarioOf());
    setup.scenario = scenario;
    base::Diagnostics found;
    setup.behavior = bt::makeTreeBehavior(*scenario, files, found);
    QVERIFY(setup.behavior != nullptr);
    QVERIFY(found.empty());
    auto made = sim2d::World::create(std::move(setup));
    QVERIFY(made);
    sim2d::World& world = **made;

    double spokenAt = -1.0;
    double followedAt = -1.0;
    double leftAt = -1.0;
    double approachEnd = -1.0;
    while (world.time() < 180.0 && leftAt < 0.0) {
      QVERIFY2(world.step(), world.failure().c_str());
      const sim2d::Frame& frame = world.frame();
      for (const sim2d::Event& event : frame.events) {
        if (event.kind == EventKind::Say) {
          spokenAt = frame.time;
          // in their places on the circle when the talk ends
          QVERIFY(std::fabs(distanceOf(frame, 0, Vec2(-6.0, 5.6)) - 0.7) < 0.15);
          QVERIFY(std::fabs(distanceOf(frame, 1, Vec2(-6.0, 5.6)) - 0.7) < 0.15);
        } else if (event.kind == EventKind::Action && event.text == "FollowAgent") {
          followedAt = frame.time;
        } else if (event.kind == EventKind::ActionEnd && event.text == "ApproachRobot SUCCESS") {
          approachEnd = frame.time;
          QVERIFY(distanceOf(frame, 1, Vec2(-0.5, -3.5)) >= 1.1);
        } else if (event.kind == EventKind::ActionEnd && event.text == "greet SUCCESS") {
          QVERIFY(distanceOf(frame, 1, Vec2(-2.35, 5.1)) <= 0.6);
        } else if (event.kind == EventKind::ActionEnd && event.text == "leave SUCCESS") {
          leftAt = frame.time;
        }
      }
    }
    QVERIFY(approachEnd > 0.0);
    QVERIFY(spokenAt > 0.0);
    QVERIFY(followedAt > spokenAt);
    QVERIFY(leftAt > followedAt);
    const sim2d::Frame& last = world.frame();
    const double apart =
        (Vec2(last.humans.x[0], last.humans.y[0]) - Vec2(last.humans.x[1], last.humans.y[1]))
            .norm();
    QVERIFY2(apart > 0.7 && apart < 2.5, std::to_string(apart).c_str());
    base::Diagnostics troubles;
    world.behavior().takeDiagnostics(troubles);
    QVERIFY(troubles.empty());
  }
};

QTEST_APPLESS_MAIN(HumanWarehouseTest)
#include "tst_HumanWarehouse.moc"
