#include <algorithm>
#include <cmath>
#include <limits>

#include <QtTest>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/messages/Codec.h"
#include "sim2d/scenario/Variation.h"
#include "tests/agents/Caller.h"

using namespace agentstest;

namespace {

constexpr double kDt = 0.05;

struct Loop {  // of one caller
  AgentManager manager;
  std::vector<Agent> agents;
  double time = 100.0;

  Loop(sim2d::Scenario scenario, const std::string& compat, std::vector<Agent> first)
      : manager(bundleOf(std::move(scenario), compat)), agents(std::move(first)) {}
  hunav_msgs::ComputeAgents::Response call(double dt, const Agent& robot = {}) {
    time += dt;
    hunav_msgs::ComputeAgents::Request request = requestOf(agents, time);
    request.robot = robot;
    hunav_msgs::ComputeAgents::Response response = manager.compute(request);
    agents = response.updatedAgents.agents;
    return response;
  }
};

double xOf(const Agent& agent) {
  return agent.position.position.x;
}

}  // namespace

/// Requests and responses of the agent manager, with numbers by hand.
class AgentManagerTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void prepare_soundScenario_hasNoErrors() {
    AgentManager manager(bundleOf(oneWalker()));
    QVERIFY(!base::hasErrors(manager.prepare()));
    AgentManager nobody(bundleOf(sim2d::Scenario()));
    nobody.prepare();  // people may come with the requests
    AgentManager broken(bundleOf([] {
      sim2d::Scenario scenario = oneWalker();
      scenario.humans[0].goals = {99};
      return scenario;
    }()));
    QVERIFY(base::hasErrors(broken.prepare()));
  }

  void compute_first_answersTheStatesThatCame() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.5, -2.0)});
    loop.agents[0].yaw = 0.25F;
    loop.agents[0].velocity.linear.x = 0.75;
    const Agents answer = loop.call(0.0).updatedAgents;
    QCOMPARE(answer.header.frameId, std::string("map"));
    QCOMPARE(answer.header.stamp.sec, 100);
    QCOMPARE(answer.agents.size(), std::size_t{1});
    QCOMPARE(xOf(answer.agents[0]), 0.5);
    QCOMPARE(answer.agents[0].position.position.y, -2.0);
    QCOMPARE(answer.agents[0].yaw, 0.25F);
    QCOMPARE(answer.agents[0].velocity.linear.x, 0.75);
    QVERIFY(!loop.manager.takeTopics());
    QVERIFY(loop.manager.takeWarnings().empty());
  }

  // F = k_g v0 / tau = 6 m/s²: v = 0.3 m/s, x = 0.015 m after 0.05 s.
  void compute_second_isTheStepByHand() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    const Agent moved = loop.call(kDt).updatedAgents.agents.at(0);
    QVERIFY(std::fabs(xOf(moved) - 0.015) < 1e-9);
    QVERIFY(std::fabs(moved.velocity.linear.x - 0.3) < 1e-9);
    QCOMPARE(moved.linearVel, 0.3F);
    QCOMPARE(moved.yaw, 0.0F);
  }

  void compute_answer_tellsWhatWrappersRead() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 1.0)});
    loop.agents[0].skin = 4;
    loop.agents[0].yaw = 1.0F;
    loop.agents[0].closestObs = {{3.0, 3.0, 0.0}};
    loop.call(0.0);
    const Agent moved = loop.call(kDt).updatedAgents.agents.at(0);
    QCOMPARE(moved.id, 1);
    QCOMPARE(moved.name, std::string("person1"));
    QCOMPARE(moved.type, Agent::kPerson);
    QCOMPARE(moved.skin, std::uint8_t{4});
    QCOMPARE(int{moved.groupId}, -1);
    QCOMPARE(moved.position.position.z,
             1.25);  // as it came: Webots and Isaac write it to the scene
    QCOMPARE(moved.goals.at(0).position.x, 5.0);
    QCOMPARE(moved.goals[0].orientation.w, 1.0);
    QVERIFY(moved.closestObs.empty());
    QCOMPARE(moved.behavior.type, std::uint8_t{1});
    QCOMPARE(moved.behavior.state, std::uint8_t{0});
    QCOMPARE(moved.behavior.goalForceFactor, 2.0F);
    QCOMPARE(moved.behavior.socialForceFactor, 5.0F);
    QCOMPARE(moved.behavior.obstacleForceFactor, 10.0F);
    const geometry_msgs::Quaternion& q = moved.position.orientation;
    QVERIFY(std::fabs(2.0 * std::atan2(q.z, q.w) - double{moved.yaw}) < 1e-6);
  }

  void compute_topics_areTheRequest() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0, robotAt(3.0, 3.0));
    loop.agents[0].yaw = 0.5F;
    loop.agents[0].linearVel = 2.0F;  // printed in `people` alone
    loop.agents[0].angularVel = 0.25F;
    hunav_msgs::ComputeAgents::Request request = requestOf(loop.agents, 100.05);
    request.robot = robotAt(3.0, 3.0);
    loop.manager.compute(request);
    const std::optional<StepMessages> topics = loop.manager.takeTopics();
    QVERIFY(topics);
    QVERIFY(!loop.manager.takeTopics());
    QCOMPARE(encode(topics->humans), encode(request.currentAgents));
    QCOMPARE(encode(topics->robot), encode(request.robot));
    QCOMPARE(topics->transforms.size(), std::size_t{2});
    const geometry_msgs::TransformStamped& robot = topics->transforms[0].transforms.at(0);
    const geometry_msgs::TransformStamped& person = topics->transforms[1].transforms.at(0);
    QCOMPARE(robot.childFrameId, std::string("robot"));
    QCOMPARE(robot.header.frameId, std::string("map"));
    QCOMPARE(robot.transform.translation.x, 3.0);
    QCOMPARE(person.childFrameId, std::string("person1"));
    QCOMPARE(person.header.stamp.nanosec, 50000000U);
    QVERIFY(std::fabs(person.transform.rotation.z - std::sin(0.25)) < 1e-7);
    const people_msgs::Person& seen = topics->people.people.at(0);
    QCOMPARE(seen.position.z, 0.5);
    QVERIFY(std::fabs(seen.velocity.x - 2.0 * std::cos(0.5)) < 1e-9);
    QVERIFY(std::fabs(seen.velocity.y - 2.0 * std::sin(0.5)) < 1e-9);
    QCOMPARE(seen.velocity.z, 0.25);
    QCOMPARE(seen.reliability, 1.0);
    QCOMPARE(seen.tagnames, (std::vector<std::string>{"id", "group_id", "behavior"}));
    QCOMPARE(seen.tags, (std::vector<std::string>{"1", "-1", "1"}));
  }

  // The wall 1 m ahead pushes with 0.497871 m/s², the goal pulls with 6.
  void compute_forces_areMarkersByHand() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.agents[0].closestObs = {{1.0, 0.0, 0.0}};
    loop.call(kDt);
    const std::optional<StepMessages> topics = loop.manager.takeTopics();
    QVERIFY(topics);
    using visualization_msgs::Marker;
    const std::vector<Marker>& markers = topics->forces.markers;
    QCOMPARE(markers.size(), std::size_t{5});
    const std::vector<double> sizes = {0.497871, 1e-4, 6.0, 6.0 - 0.497871};
    for (std::size_t i = 0; i < 4; ++i) {
      QCOMPARE(markers[i].ns, std::string("person1/robot_forces"));
      QCOMPARE(markers[i].id, static_cast<int>(i) + 2);
      QVERIFY(std::fabs(markers[i].scale.x - sizes[i]) < 1e-6);
      QCOMPARE(markers[i].scale.y, 0.1);
      QCOMPARE(markers[i].lifetime.sec, 1);
      QCOMPARE(markers[i].pose.position.z, 0.0);
      QCOMPARE(markers[i].action, i == 1 ? Marker::kDelete : Marker::kAdd);
    }
    QVERIFY(std::fabs(std::fabs(markers[0].pose.orientation.z) - 1.0) < 1e-9);  // backwards
    QCOMPARE(markers[0].color.r, 1.0F);
    QCOMPARE(markers[1].color.b, 1.0F);
    QCOMPARE(markers[2].color.g, 1.0F);
    QCOMPARE(markers[4].text, std::string("person1/REGULAR"));
    QCOMPARE(markers[4].ns, std::string("person1/behavior"));
    QCOMPARE(markers[4].scale.z, 0.5);
  }

  // Fortress sends its first requests before the people and the robot are in its world.
  void compute_noAgentsFirst_beginsWithTheFirstOnes() {
    AgentManager manager(bundleOf(oneWalker(), "hunav2"));
    QVERIFY(manager.compute(requestOf({}, 1.0)).updatedAgents.agents.empty());
    QVERIFY(manager.compute(requestOf({}, 1.05)).updatedAgents.agents.empty());
    QCOMPARE(xOf(manager.compute(requestOf({agentAt(1, 0.0, 0.0)}, 1.1)).updatedAgents.agents[0]),
             0.0);
    QVERIFY(!manager.takeTopics());
    QVERIFY(xOf(manager.compute(requestOf({agentAt(1, 0.0, 0.0)}, 1.15)).updatedAgents.agents[0]) >
            0.014);
    QVERIFY(manager.takeWarnings().empty());
  }

  void compute_timeStandsRunsBackOrLeaps_nobodyMoves() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    loop.manager.takeTopics();
    for (const double dt : {0.0, -50.0, 20.0}) {
      const double before = xOf(loop.agents[0]);
      loop.call(dt);
      QCOMPARE(xOf(loop.agents[0]), before);
      QVERIFY(loop.manager.takeTopics());  // the state is published all the same
      const base::Diagnostics remarks = loop.manager.takeWarnings();
      QCOMPARE(remarks.size(), std::size_t{dt == 0.0 ? 0U : 1U});
      QVERIFY(dt >= 0.0 || hasRemark(remarks, "ros2.time-back"));
      QVERIFY(dt <= 0.0 || hasRemark(remarks, "ros2.time-leap"));
      loop.call(kDt);
      QVERIFY(xOf(loop.agents[0]) > before);
    }
    loop.call(-1.0);
    QVERIFY(loop.manager.takeWarnings().empty());  // told once
  }

  /// Without a cut the model of ours would go straight on for a second, whoever stands there.
  void compute_stepOfASecond_isCut() {
    sim2d::Scenario scenario = oneWalker();
    Loop whole(scenario, {}, {agentAt(1, 0.0, 0.0)});
    Loop cut(scenario, {}, {agentAt(1, 0.0, 0.0)});
    whole.call(0.0);
    cut.call(0.0);
    whole.call(1.0);
    for (int i = 0; i < 10; ++i) {
      cut.call(0.1);
    }
    QVERIFY(xOf(whole.agents[0]) > 0.5);
    QVERIFY(std::fabs(xOf(whole.agents[0]) - xOf(cut.agents[0])) < 1e-6);
  }

  void compute_badNumbers_keepTheStateBefore_data() {
    QTest::addColumn<int>("what");
    QTest::newRow("x is NaN") << 0;
    QTest::newRow("y is infinite") << 1;
    QTest::newRow("yaw is NaN") << 2;
    QTest::newRow("velocity is too large") << 3;
    QTest::newRow("a point is NaN") << 4;
  }

  void compute_badNumbers_keepTheStateBefore() {
    QFETCH(const int, what);
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int i = 0; i < 3; ++i) {
      std::vector<Agent> sent = {agentAt(1, 0.015, 0.0)};
      sent[0].velocity.linear.x = what == 3 ? 1e9 : 0.3;
      sent[0].position.position.x = what == 0 ? nan : sent[0].position.position.x;
      sent[0].position.position.y = what == 1 ? HUGE_VAL : 0.0;
      sent[0].yaw = what == 2 ? std::nanf("") : 0.0F;
      sent[0].closestObs = {{what == 4 ? nan : 1e4, 0.0, 0.0}};
      loop.agents = sent;
      const Agent answer = loop.call(kDt).updatedAgents.agents.at(0);
      QVERIFY(invalidReason(answer).empty());
      QVERIFY(xOf(answer) > 0.0 && xOf(answer) < 1.0);
      QCOMPARE(hasRemark(loop.manager.takeWarnings(), "ros2.bad-agent"), i == 0 && what != 4);
    }
  }

  void compute_robotComesAndGoes_isToldOnce() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt, robotAt(1.0, 0.0));
    QVERIFY(loop.manager.takeWarnings().empty());
    loop.call(kDt);
    QVERIFY(hasRemark(loop.manager.takeWarnings(), "ros2.robot-gone"));
    loop.call(kDt, robotAt(1.0, 0.0));
    Agent bad = robotAt(1.0, 0.0);
    bad.position.position.x = std::numeric_limits<double>::quiet_NaN();
    loop.call(kDt, bad);
    QVERIFY(hasRemark(loop.manager.takeWarnings(), "ros2.bad-agent"));
    loop.call(kDt);
    QVERIFY(loop.manager.takeWarnings().empty());
  }

  void compute_stranger_getsATree() {
    Agent stranger = agentAt(9, 0.0, 4.0);
    stranger.goals = {{{5.0, 4.0, 0.0}, {}}};
    stranger.goalRadius = 0.3F;
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0), stranger});
    loop.call(0.0);
    QVERIFY(hasRemark(loop.manager.takeWarnings(), "ros2.stranger"));
    loop.call(kDt);
    QVERIFY(std::fabs(loop.agents[1].velocity.linear.x - 0.3) < 0.02);
    QCOMPARE(loop.agents[1].id, 9);
  }

  void compute_strangerLater_isServedToo() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    loop.agents.push_back(agentAt(3, 0.0, 9.0));
    loop.call(kDt);
    const base::Diagnostics remarks = loop.manager.takeWarnings();
    QVERIFY(hasRemark(remarks, "ros2.stranger"));
    QVERIFY(hasRemark(remarks, "ros2.minds-anew"));
    QCOMPARE(loop.agents.size(), std::size_t{2});
    const double before = xOf(loop.agents[0]);
    loop.call(kDt);
    QVERIFY(xOf(loop.agents[0]) > before);
    QVERIFY(loop.manager.takeWarnings().empty());
  }

  void compute_idTwiceOrNegative_isTold() {
    Loop loop(oneWalker(), {}, {agentAt(1, 0.0, 0.0), agentAt(1, 2.0, 0.0), agentAt(-4, 3.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    QCOMPARE(loop.agents.size(), std::size_t{3});
    QCOMPARE(xOf(loop.agents[2]), 3.0);
    const base::Diagnostics remarks = loop.manager.takeWarnings();
    QVERIFY(hasRemark(remarks, "ros2.agent-twice"));
    QVERIFY(hasRemark(remarks, "ros2.agent-negative"));
  }

  void compute_wildValuesOfOne_leaveOthersMoving_data() {
    QTest::addColumn<int>("field");
    QTest::newRow("desired velocity") << 0;
    QTest::newRow("radius") << 1;
    QTest::newRow("social factor") << 2;
    QTest::newRow("goal factor") << 3;
  }

  /// Of the whole step nobody would move if one velocity were not finite.
  void compute_wildValuesOfOne_leaveOthersMoving() {
    QFETCH(const int, field);
    Agent wild = agentAt(2, 0.0, 6.0);
    wild.goals = {{{5.0, 6.0, 0.0}, {}}};
    wild.behavior.socialForceFactor = 5.0F;
    wild.behavior.goalForceFactor = 2.0F;
    wild.behavior.obstacleForceFactor = 10.0F;
    float* const fields[] = {&wild.desiredVelocity, &wild.radius, &wild.behavior.socialForceFactor,
                             &wild.behavior.goalForceFactor};
    *fields[field] = 1e30F;
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0), wild});
    loop.call(0.0);
    QVERIFY(hasRemark(loop.manager.takeWarnings(), "ros2.too-large"));
    loop.call(kDt);
    QVERIFY(loop.manager.takeWarnings().empty());
    QVERIFY(std::fabs(xOf(loop.agents[0]) - 0.015) < 1e-4);  // the step by hand, of the other
  }

  void compute_manyStrangers_areToldUpToALimit() {
    std::vector<Agent> strangers;
    for (int id = 10; id < 1510; ++id) {
      strangers.push_back(agentAt(id, 2.0 * (id % 40), 2.0 * (id / 40)));
    }
    Loop loop(oneWalker(), "hunav2", strangers);
    loop.call(0.0);
    QCOMPARE(loop.manager.takeWarnings().size(), std::size_t{1000});
  }

  void compute_greatestId_isServed() {
    const Agent last = agentAt(std::numeric_limits<std::int32_t>::max(), 0.0, 5.0);
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0), last});
    loop.call(0.0);
    loop.call(kDt);
    const std::optional<StepMessages> topics = loop.manager.takeTopics();
    QVERIFY(topics);
    QCOMPARE(topics->forces.markers.size(), std::size_t{10});
  }

  void compute_goalsOfTheFirstRequest_count() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.agents[0].goals = {{{-5.0, 0.0, 0.0}, {}}};
    loop.call(0.0);
    loop.agents[0].goals[0].position.x = 7.0;  // from here on ours count
    loop.call(kDt);
    QVERIFY(xOf(loop.agents[0]) < 0.0);
    QCOMPARE(loop.agents[0].goals.at(0).position.x, -5.0);
  }

  void compute_goalsRunOut_theLastOnesStay() {
    sim2d::Scenario scenario = oneWalker();
    scenario.humans[0].cyclicGoals = false;
    Loop loop(scenario, "hunav2", {agentAt(1, 4.0, 0.0)});
    loop.call(0.0);
    for (int i = 0; i < 100; ++i) {
      loop.call(kDt);
      QVERIFY(!loop.agents[0].goals.empty());
    }
    QVERIFY(std::fabs(loop.agents[0].velocity.linear.x) < 0.01);
  }

  void move_onlyOne_movesWithItsOwnClock() {
    sim2d::Scenario scenario = oneWalker();
    addPerson(scenario, 2, 0.0, 9.0, {1});
    AgentManager manager(bundleOf(scenario, "hunav2"));
    hunav_msgs::MoveAgent::Request request;
    request.currentAgents =
        requestOf({agentAt(1, 0.0, 0.0), agentAt(2, 0.0, 9.0)}, 5.0).currentAgents;
    request.agentId = 1;
    QCOMPARE(xOf(manager.moveOne(request).updatedAgent), 0.0);
    QVERIFY(!manager.takeTopics());
    setStamp(request.currentAgents, 5.05);
    const Agent first = manager.moveOne(request).updatedAgent;
    QVERIFY(std::fabs(xOf(first) - 0.015) < 1e-4);
    QVERIFY(manager.takeTopics());
    request.agentId = 2;  // under the same stamp
    const Agent second = manager.moveOne(request).updatedAgent;
    QCOMPARE(second.id, 2);
    QVERIFY(std::hypot(second.velocity.linear.x, second.velocity.linear.y) > 0.29);
    request.agentId = 8;
    const Agent nobody = manager.moveOne(request).updatedAgent;
    QCOMPARE(nobody.id, 8);
    QCOMPARE(nobody.name, std::string());
    QVERIFY(hasRemark(manager.takeWarnings(), "ros2.unknown-agent"));
  }

  void computeOne_answersTheLastStep() {
    Loop loop(oneWalker(), {}, {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    for (int i = 0; i < 2; ++i) {
      QCOMPARE(xOf(loop.manager.computeOne({1}).updatedAgent), xOf(loop.agents[0]));
    }
  }

  void computeOne_unknown_isEmpty() {
    AgentManager manager(bundleOf(oneWalker()));
    const Agent answer = manager.computeOne({6}).updatedAgent;
    QCOMPARE(answer.id, 6);
    QCOMPARE(answer.radius, 0.0F);
    QVERIFY(hasRemark(manager.takeWarnings(), "ros2.unknown-agent"));
  }

  void computeOne_hunav2_ticksOnceMore() {
    Loop loop(oneWalker(), "hunav2", {agentAt(1, 0.0, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    const double more = xOf(loop.manager.computeOne({1}).updatedAgent);
    QVERIFY(more > xOf(loop.agents[0]) + 0.015);
  }

  void reset_beginsAnew() {
    sim2d::Scenario scenario = oneWalker();
    const int back = addGoal(scenario, -5.0, 0.0);
    scenario.humans[0].goals = {1, back};
    Loop loop(scenario, {}, {agentAt(1, 4.9, 0.0)});
    loop.call(0.0);
    for (int i = 0; i < 20; ++i) {
      loop.call(kDt);
    }
    QCOMPARE(loop.agents[0].goals.at(0).position.x, -5.0);  // the first one was reached
    hunav_msgs::ResetAgents::Request request;
    request.currentAgents = requestOf({agentAt(1, 0.0, 0.0)}, 1.0).currentAgents;
    QVERIFY(loop.manager.reset(request).ok);
    loop.agents = {agentAt(1, 0.0, 0.0)};
    loop.time = 1.0;
    loop.call(kDt);
    QCOMPARE(loop.agents[0].goals.at(0).position.x, 5.0);
    QVERIFY(xOf(loop.agents[0]) > 0.0);
    QVERIFY(loop.manager.takeWarnings().empty());
  }

  void reset_goesOnAsAFreshManager_data() {
    QTest::addColumn<QString>("scenario");
    QTest::addColumn<bool>("otherGoals");
    for (const char* name : {"corner_cafe/corner_cafe", "reactions/reaction_scared"}) {
      QTest::newRow(name) << QString::fromLatin1(name) << false;
      QTest::addRow("%s, other goals", name) << QString::fromLatin1(name) << true;
    }
  }

  /// Byte for byte, whatever the people did before; a reset does not check the scenario again.
  void reset_goesOnAsAFreshManager() {
    QFETCH(const QString, scenario);
    QFETCH(const bool, otherGoals);
    app::RunSpec options;
    options.scenario = std::string(SOURCE_DIR "/maps/") + scenario.toStdString() + "_agents.yaml";
    const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
    AgentManager used(bundle), fresh(bundle);
    QVERIFY(!base::hasErrors(used.prepare()) && !base::hasErrors(fresh.prepare()));
    const Agents start = agentsAtStart(*bundle.scenario, 1).agents;
    Agent robot = robotAt(3.0, 3.0);
    const auto walk = [&robot](AgentManager& manager, Agents agents, double from) {
      std::string all;
      for (int k = 0; k < 60; ++k) {
        setStamp(agents, from + kDt * k);
        hunav_msgs::ComputeAgents::Request request;
        request.currentAgents = agents;
        request.robot = robot;
        agents = manager.compute(request).updatedAgents;
        Agents unstamped = agents;
        unstamped.header.stamp = {};
        all += encode(unstamped);
      }
      return all;
    };
    Agents before = start;
    if (otherGoals) {
      std::reverse(before.agents.front().goals.begin(), before.agents.front().goals.end());
    }
    const std::string first = walk(used, before, 100.0);
    hunav_msgs::ResetAgents::Request reset;
    reset.currentAgents = start;
    setStamp(reset.currentAgents, 200.0);
    reset.robot = robot;
    QVERIFY(used.reset(reset).ok);
    const std::string again = walk(used, start, 200.0);
    QVERIFY(fresh.reset(reset).ok);
    QVERIFY(again == walk(fresh, start, 200.0));
    QVERIFY(otherGoals || again.size() == first.size());
  }

  /// The fastest of many resets, compared with the fastest of those that must check the scenario
  /// because other people are requested.
  void reset_ofTheSamePeople_checksNothingAgain() {
    app::RunSpec options;
    options.scenario = SOURCE_DIR "/maps/corner_cafe/corner_cafe_agents.yaml";
    const app::Bundle bundle = app::readBundle(options, *app::runSettingsOf(options), {});
    AgentManager manager(bundle);
    QVERIFY(!base::hasErrors(manager.prepare()));
    hunav_msgs::ResetAgents::Request request;
    request.currentAgents = agentsAtStart(*bundle.scenario, 1).agents;
    double same = 1e9, other = 1e9;  // [ns]
    const auto reset = [&] {
      QElapsedTimer timer;
      timer.start();
      manager.reset(request);
      return static_cast<double>(timer.nsecsElapsed());
    };
    for (int k = 0; k < 20; ++k) {
      request.currentAgents.agents.front().desiredVelocity = 1.0F + 0.01F * static_cast<float>(k);
      other = std::min(other, reset());
      same = std::min(same, reset());
    }
    QVERIFY2(same < other / 4.0, QByteArray::number(same) + " of " + QByteArray::number(other));
  }

  void reset_hunav2_takesPlacesAlone() {
    sim2d::Scenario scenario = oneWalker();
    const int back = addGoal(scenario, -5.0, 0.0);
    scenario.humans[0].goals = {1, back};
    Loop loop(scenario, "hunav2", {agentAt(1, 4.9, 0.0)});
    loop.call(0.0);
    loop.call(kDt);
    loop.call(kDt);
    hunav_msgs::ResetAgents::Request request;
    request.currentAgents = requestOf({agentAt(1, 0.0, 0.0)}, loop.time).currentAgents;
    QVERIFY(loop.manager.reset(request).ok);
    loop.agents = {agentAt(1, 0.0, 0.0)};
    loop.call(kDt);
    QCOMPARE(loop.agents[0].goals.at(0).position.x, -5.0);
  }

  void variation_isDrawnAsInARun_data() {
    QTest::addColumn<int>("seed");
    for (const int seed : {1, 2, 77}) {
      QTest::newRow(std::to_string(seed).c_str()) << seed;
    }
  }

  /// The answer of `get_agents`, compared with the world of a run with the same seed, which also
  /// has a robot.
  void variation_isDrawnAsInARun() {
    QFETCH(const int, seed);
    sim2d::Scenario scenario;
    const std::vector<int> goals = {addGoal(scenario, 5.0, 0.0), addGoal(scenario, 0.0, 5.0),
                                    addGoal(scenario, -5.0, 0.0)};
    for (int id = 1; id <= 6; ++id) {
      addPerson(scenario, id, 1.2 * id, 0.5 * id, goals).groupId = id < 3 ? 4 : -1;
    }
    addRobot(scenario, {3.0, 2.0});
    scenario.desktop.seed = seed;
    scenario.desktop.variation.preset = sim2d::VariationPreset::Strong;
    const app::Bundle bundle = bundleOf(scenario);
    const app::Verdict run = app::check(bundle);
    QVERIFY(run.world != nullptr);
    AgentManager manager(bundle);
    QVERIFY(!base::hasErrors(manager.prepare()));
    const Agents agents = agentsAtStart(*manager.scenario(), seed).agents;
    const std::vector<rcl_interfaces::Parameter> parameters =
        loaderParameters(*manager.scenario(), seed);
    QCOMPARE(agents.agents.size(), std::size_t{6});
    int moved = 0;
    for (const Agent& agent : agents.agents) {
      const sim2d::WorldView& view = run.world->view();
      const sim2d::ResolvedHuman& person = view.constants(view.indexOf(agent.id));
      QCOMPARE(xOf(agent), person.start.position.x());
      QCOMPARE(agent.position.position.y, person.start.position.y());
      QCOMPARE(agent.yaw, static_cast<float>(person.start.heading));
      QCOMPARE(agent.desiredVelocity, static_cast<float>(person.desiredSpeed));
      QVERIFY(agent.desiredVelocity != 1.5F);
      moved += xOf(agent) != 1.2 * agent.id ? 1 : 0;
      const std::vector<int> order =
          sim2d::firstGoalOf(scenario.desktop.variation, scenario.humans[0], seed).goals;
      QVERIFY(agent.id >= 3 ||
              agent.goals.at(0).position.x == scenario.goal(order.front())->position.x());
      const auto speed = std::find_if(
          parameters.begin(), parameters.end(),
          [&](const auto& parameter) { return parameter.name == agent.name + ".max_vel"; });
      QVERIFY(speed != parameters.end());
      QCOMPARE(speed->value.doubleValue, person.desiredSpeed);
    }
    QVERIFY(moved >= 4);  // of six; for some of them there may be no room
  }

  // F = k_g v0 / (r tau) = 6 m/s² / r: v = 0.3 m/s / r after 0.05 s, r the factor of the person.
  void variation_reactionTime_countsInSteps() {
    sim2d::Scenario scenario = oneWalker();
    scenario.desktop.seed = 5;
    sim2d::VariationSettings& variation = scenario.desktop.variation;
    variation.of(sim2d::VariationQuantity::ReactionTime).kind = sim2d::SpreadKind::Uniform;
    variation.of(sim2d::VariationQuantity::ReactionTime).halfWidth = 0.4;
    sim2d::ResolvedHuman drawn;
    sim2d::PersonVariation(variation, 5, 1, -1).apply(drawn);
    QVERIFY(std::fabs(drawn.reactionTime - 1.0) > 0.05);
    Loop loop(scenario, "hunav2", {agentAt(1, 0.0, 0.0)});
    QVERIFY(!base::hasErrors(loop.manager.prepare()));
    loop.call(0.0);
    const Agent moved = loop.call(kDt).updatedAgents.agents.at(0);
    QVERIFY(std::fabs(moved.velocity.linear.x - 0.3 / drawn.reactionTime) < 1e-9);
  }

  void everyAnswer_canBeEncoded() {
    Loop loop(oneWalker(), {}, {agentAt(1, 0.0, 0.0), agentAt(5, 1.0, 1.0)});
    loop.call(0.0);
    const std::string bytes = encode(loop.call(kDt));
    const auto read = decode<hunav_msgs::ComputeAgents::Response>(bytes);
    QVERIFY(read);
    QCOMPARE(encode(*read), bytes);
  }
};

QTEST_APPLESS_MAIN(AgentManagerTest)
#include "tst_AgentManager.moc"
