#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "tests/agents/Caller.h"

using namespace agentstest;

/// The loop of the wrapper for Gazebo: in each step it sends places, velocities (differences of
/// places over the period), the robot and obstacle points, and puts the answer into its scene. What
/// comes of it is held against a run of the same scenario alone.
class CallerLoopTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void loop_tenPeopleTwentySeconds_isTheHeadlessRun_data();
  void loop_tenPeopleTwentySeconds_isTheHeadlessRun();
  void loop_ourModels_staysAway();
};

namespace {

/// Ten people between two walls who walk to and fro across each other's ways, some of whom react to
/// the robot that passes.
sim2d::Scenario busyHall() {
  sim2d::Scenario scenario;
  const sim2d::BehaviorType types[] = {
      sim2d::BehaviorType::Regular,  sim2d::BehaviorType::Regular, sim2d::BehaviorType::Impassive,
      sim2d::BehaviorType::Surprised, sim2d::BehaviorType::Scared,  sim2d::BehaviorType::Curious};
  for (int i = 0; i < 10; ++i) {
    const double y = -4.5 + i;
    const double side = i % 2 == 0 ? 1.0 : -1.0;
    const int there = addGoal(scenario, 9.0 * side, -0.9 * y);
    const int back = addGoal(scenario, -9.0 * side, y);
    sim2d::Human& human = addPerson(scenario, i + 1, -8.0 * side, y, {there, back});
    human.maxVel = 1.0 + 0.07 * i;
    human.behavior.type = types[i % 6];
    human.behavior.dist = 3.3;
    human.behavior.duration = 5.0;
    human.behavior.once = false;
    human.behavior.vel = 0.8;
  }
  for (const double y : {-7.0, 7.0}) {
    sim2d::Obstacle wall;
    wall.key = {base::EntityKind::Obstacle, scenario.nextKey()};
    wall.name = y > 0.0 ? "north" : "south";
    wall.kind = sim2d::ObstacleKind::Wall;
    wall.points = {{-12.0, y}, {12.0, y}};
    scenario.obstacles.push_back(wall);
  }
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, scenario.nextKey()};
  robot.name = "robot1";
  robot.start = {{-10.0, -5.8}, 0.0};
  robot.goal.point = sim2d::Vec2(10.0, -5.8);
  robot.radius = 0.35;
  scenario.robots.push_back(robot);
  return scenario;
}

/// As the wrapper fills it at first, from the loader's parameters.
Agent firstState(const sim2d::Scenario& scenario, const sim2d::Human& human) {
  const sim2d::ResolvedHuman person = sim2d::resolveHuman(scenario, human, 1);
  Agent agent = agentAt(human.id, human.initPose.position.x(), human.initPose.position.y());
  agent.desiredVelocity = static_cast<float>(person.desiredSpeed);
  agent.radius = static_cast<float>(person.radius);
  agent.goalRadius = static_cast<float>(person.goalRadius);
  agent.cyclicGoals = person.cyclicGoals;
  agent.behavior.type = static_cast<std::uint8_t>(person.behavior);
  agent.behavior.goalForceFactor = static_cast<float>(person.goalFactor);
  agent.behavior.obstacleForceFactor = static_cast<float>(person.obstacleFactor);
  agent.behavior.socialForceFactor = static_cast<float>(person.socialFactor);
  agent.behavior.otherForceFactor = static_cast<float>(person.otherFactor);
  for (const int goal : human.goals) {
    geometry_msgs::Pose& place = agent.goals.emplace_back();
    place.position.x = scenario.goal(goal)->position.x();
    place.position.y = scenario.goal(goal)->position.y();
  }
  return agent;
}

Agent robotOfFrame(const sim2d::Frame& frame) {
  const sim2d::RobotColumns& robots = frame.robots;
  Agent robot = robotAt(robots.x.at(0), robots.y.at(0));
  robot.yaw = static_cast<float>(robots.heading[0]);
  robot.velocity.linear.x = robots.vx[0];
  robot.velocity.linear.y = robots.vy[0];
  robot.velocity.angular.z = robots.omega[0];
  return robot;
}

void addObstacles(const sim2d::World& world, Agent& agent) {
  std::vector<sim2d::Obstacles::Point> points;
  const sim2d::Vec2 place(agent.position.position.x, agent.position.position.y);
  world.obstacles().boundaryPoints(place, points);
  agent.closestObs.clear();
  for (const sim2d::Obstacles::Point& point : points) {
    agent.closestObs.push_back({point.position.x(), point.position.y(), 0.0});
  }
}

/// The scene takes places and headings from the answer; velocities are differences.
void putIntoScene(const Agent& answer, double period, Agent& agent) {
  const geometry_msgs::Point before = agent.position.position;
  agent.position = answer.position;
  agent.yaw = answer.yaw;
  agent.velocity.linear.x = (answer.position.position.x - before.x) / period;
  agent.velocity.linear.y = (answer.position.position.y - before.y) / period;
  agent.goals = answer.goals;
  agent.behavior.state = answer.behavior.state;
}

struct Difference {
  double place = 0.0;    // [m], the largest of all steps and people
  double heading = 0.0;  // [rad]
  double walked = 0.0;   // [m], the least of all people from their starts
  int active = 0;        // states of reaction
};

Difference differenceOfLoop(const sim2d::Scenario& scenario, const std::string& compat, double dt,
                            double seconds) {
  app::Verdict verdict = app::check(bundleOf(scenario, compat));
  Difference difference;
  if (verdict.world == nullptr) {
    difference.place = 1e9;
    return difference;
  }
  sim2d::World& alone = *verdict.world;
  AgentManager manager(bundleOf(scenario, compat));
  std::vector<Agent> agents;
  for (const sim2d::Human& human : scenario.humans) {
    agents.push_back(firstState(scenario, human));
  }
  const int steps = static_cast<int>(std::lround(seconds / dt));
  std::vector<double> walked(agents.size(), 0.0);
  for (int k = 0; k <= steps; ++k) {
    for (Agent& agent : agents) {
      addObstacles(alone, agent);
    }
    hunav_msgs::ComputeAgents::Request request = requestOf(agents, 50.0 + k * dt);
    request.robot = robotOfFrame(alone.frame());
    const Agents answer = manager.compute(request).updatedAgents;
    if (k > 0) {
      alone.step();
    }
    for (std::size_t i = 0; i < agents.size(); ++i) {
      putIntoScene(answer.agents[i], dt, agents[i]);
      const sim2d::HumanColumns& humans = alone.frame().humans;
      const geometry_msgs::Point& place = agents[i].position.position;
      difference.place = std::max(
          difference.place, std::hypot(place.x - humans.x[i], place.y - humans.y[i]));
      difference.heading =
          std::max(difference.heading,
                   std::fabs(base::angleDiff(double{agents[i].yaw}, humans.heading[i])));
      difference.active += answer.agents[i].behavior.state == humans.state[i] ? humans.state[i] : -1;
      const sim2d::Vec2& start = scenario.humans[i].initPose.position;
      walked[i] = std::max(walked[i], std::hypot(place.x - start.x(), place.y - start.y()));
    }
  }
  difference.walked = *std::min_element(walked.begin(), walked.end());
  return difference;
}

}  // namespace

void CallerLoopTest::loop_tenPeopleTwentySeconds_isTheHeadlessRun_data() {
  QTest::addColumn<double>("dt");
  QTest::newRow("0.05 s") << 0.05;
  QTest::newRow("0.01 s") << 0.01;
}

// Only what messages carry as float32 differs: yaw, speeds, radii, factors (2^-24 of each).
void CallerLoopTest::loop_tenPeopleTwentySeconds_isTheHeadlessRun() {
  QFETCH(const double, dt);
  sim2d::Scenario scenario = busyHall();
  scenario.desktop.dt = dt;
  const Difference difference = differenceOfLoop(scenario, "hunav2", dt, 20.0);
  qInfo("largest difference %.3g m, %.3g rad; least way %.1f m; %d states of reaction",
        difference.place, difference.heading, difference.walked, difference.active);
  QVERIFY(difference.place < 1e-4);
  QVERIFY(difference.heading < 1e-3);
  QVERIFY(difference.walked > 2.0);
  QVERIFY(difference.active > 0);
}

/// With the models of ours nobody walks into anybody.
void CallerLoopTest::loop_ourModels_staysAway() {
  const sim2d::Scenario scenario = busyHall();
  AgentManager manager(bundleOf(scenario));
  std::vector<Agent> agents;
  for (const sim2d::Human& human : scenario.humans) {
    agents.push_back(firstState(scenario, human));
  }
  double nearest = 1e9;
  for (int k = 0; k <= 400; ++k) {
    const Agents answer = manager.compute(requestOf(agents, 50.0 + k * 0.05)).updatedAgents;
    for (std::size_t i = 0; i < agents.size(); ++i) {
      putIntoScene(answer.agents[i], 0.05, agents[i]);
      for (std::size_t j = 0; j < i; ++j) {
        const geometry_msgs::Point& a = agents[i].position.position;
        const geometry_msgs::Point& b = agents[j].position.position;
        nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
      }
    }
  }
  QVERIFY2(nearest > 0.8 - 1e-3, qPrintable(QString::number(nearest)));  // two radii of 0.4 m
  QVERIFY(manager.takeRemarks().empty());
}

QTEST_APPLESS_MAIN(CallerLoopTest)
#include "tst_CallerLoop.moc"
