#include <algorithm>
#include <cmath>

#include <QtTest>

#include "sim2d/base/Text.h"
#include "tests/agents/Caller.h"

using namespace agentstest;

namespace {

/// Ten people between two walls who walk to and fro across each other's ways, some of whom react to
/// the robot that passes.
sim2d::Scenario busyHall() {
  sim2d::Scenario scenario;
  const sim2d::BehaviorType types[] = {
      sim2d::BehaviorType::Regular,   sim2d::BehaviorType::Regular, sim2d::BehaviorType::Impassive,
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
  sim2d::Robot& robot = addRobot(scenario, {-10.0, -5.8});
  robot.goal.point = sim2d::Vec2(10.0, -5.8);
  robot.radius = 0.35;
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

/// How a wrapper goes about it (only what the manager can see).
struct Wrapper {
  double dt = 0.05;                 // [s]
  const char* frame = "map";        // of the header
  double seesObstacles = 1e9;       // [m]
  bool beginsWithoutRobot = false;  // a request with nobody in it, for want of a robot
  bool isReversed = false;          // people in the order of entities
  bool sendsGoals = true;           // those of the last answer
  bool keepsNames = true;           // else "Agent<index>"
  bool takesVelocities = false;     // of the answer, instead of differences of places
  bool hasRobotsHeadingInYawAlone = false;
};

const Wrapper kWrappers[] = {{},
                             {0.01},
                             {0.05, "map", 5.0, true, true},
                             {0.05, "world", 4.0, false, false, false, false, true},
                             {0.032, "map", 5.0, false, false, true, true, true, true}};
enum { Gazebo, GazeboFast, Fortress, Isaac, Webots };

void addObstacles(const sim2d::World& world, const Wrapper& wrapper, Agent& agent) {
  std::vector<sim2d::Obstacles::Point> points;
  const sim2d::Vec2 place(agent.position.position.x, agent.position.position.y);
  world.obstacles().boundaryPoints(place, points);
  agent.closestObs.clear();
  for (const sim2d::Obstacles::Point& point : points) {
    if ((point.position - place).norm() <= wrapper.seesObstacles) {
      agent.closestObs.push_back({point.position.x(), point.position.y(), 0.0});
    }
  }
  if (!wrapper.sendsGoals) {  // Isaac: rays that hit nothing
    agent.closestObs.push_back({1e4, 1e4, 1e4});
  }
}

/// The scene takes places and headings from the answer; velocities are differences, or the
/// answer's.
void putIntoScene(const Agent& answer, const Wrapper& wrapper, Agent& agent) {
  const geometry_msgs::Point before = agent.position.position;
  agent.position = answer.position;
  agent.yaw = answer.yaw;
  if (wrapper.takesVelocities) {
    agent.velocity = answer.velocity;
  } else {
    agent.velocity.linear.x = (answer.position.position.x - before.x) / wrapper.dt;
    agent.velocity.linear.y = (answer.position.position.y - before.y) / wrapper.dt;
  }
  if (wrapper.sendsGoals) {
    agent.goals = answer.goals;
  }
  agent.behavior.state = answer.behavior.state;
}

/// Ten people in the scene of a wrapper, which calls the manager.
class Scene {
 public:
  Scene(const sim2d::Scenario& scenario, const std::string& compat, const Wrapper& wrapper)
      : wrapper_(wrapper), manager_(bundleOf(scenario, compat)) {
    for (const sim2d::Human& human : scenario.humans) {
      Agent& agent = people_.emplace_back(firstState(scenario, human));
      if (!wrapper.keepsNames) {
        agent.name = "Agent" + std::to_string(people_.size());
      }
      if (!wrapper.sendsGoals) {
        agent.goals.clear();
      }
    }
    if (wrapper.isReversed) {
      std::reverse(people_.begin(), people_.end());
    }
  }

  /// `surroundings`: of the obstacles.
  void call(const sim2d::World& surroundings, Agent robot) {
    if (wrapper_.beginsWithoutRobot && number_ == 0) {
      manager_.compute(requestOf({}, 50.0 - wrapper_.dt));
    }
    for (Agent& agent : people_) {
      addObstacles(surroundings, wrapper_, agent);
    }
    auto request = requestOf(people_, 50.0 + number_++ * wrapper_.dt);
    request.currentAgents.header.frameId = wrapper_.frame;
    if (wrapper_.hasRobotsHeadingInYawAlone) {
      robot.position.orientation = {};
    }
    request.robot = std::move(robot);
    const Agents answer = manager_.compute(request).updatedAgents;
    for (std::size_t i = 0; i < people_.size(); ++i) {
      putIntoScene(answer.agents.at(i), wrapper_, people_[i]);
    }
  }
  const Agent& person(int id) const {
    return *std::find_if(people_.begin(), people_.end(),
                         [id](const Agent& agent) { return agent.id == id; });
  }
  AgentManager& manager() { return manager_; }

 private:
  Wrapper wrapper_;
  AgentManager manager_;
  std::vector<Agent> people_;
  int number_ = 0;  // of the request
};

struct Difference {
  double place = 0.0;    // [m], the largest of all steps and people
  double heading = 0.0;  // [rad]
  double walked = 0.0;   // [m], the least of all people from their starts
  int active = 0;        // states of reaction
  int otherStates = 0;
};

Difference differenceOfLoop(const sim2d::Scenario& scenario, const Wrapper& wrapper,
                            double seconds) {
  app::Verdict verdict = app::check(bundleOf(scenario, "hunav2"));
  Difference difference;
  if (verdict.world == nullptr) {
    difference.place = 1e9;
    return difference;
  }
  sim2d::World& alone = *verdict.world;
  Scene scene(scenario, "hunav2", wrapper);
  const int steps = static_cast<int>(std::lround(seconds / wrapper.dt));
  std::vector<double> walked(scenario.humans.size(), 0.0);
  for (int k = 0; k <= steps; ++k) {
    scene.call(alone, robotOfFrame(alone.frame()));
    if (k > 0) {
      alone.step();
    }
    const sim2d::HumanColumns& humans = alone.frame().humans;
    for (std::size_t i = 0; i < humans.size(); ++i) {
      const Agent& agent = scene.person(humans.id[i]);
      const geometry_msgs::Point& place = agent.position.position;
      difference.place =
          std::max(difference.place, std::hypot(place.x - humans.x[i], place.y - humans.y[i]));
      difference.heading = std::max(
          difference.heading, std::fabs(base::angleDiff(double{agent.yaw}, humans.heading[i])));
      difference.active += humans.state[i] != 0 ? 1 : 0;
      difference.otherStates += agent.behavior.state == humans.state[i] ? 0 : 1;
      const sim2d::Vec2& start = scenario.humans[i].initPose.position;
      walked[i] = std::max(walked[i], std::hypot(place.x - start.x(), place.y - start.y()));
    }
  }
  difference.walked = *std::min_element(walked.begin(), walked.end());
  return difference;
}

}  // namespace

/// The loops of HuNavSim's wrappers: in each step they send places, velocities, the robot and
/// obstacle points, each in its own way, and put the answer into their scene. What comes of five
/// minutes with ten people is held against a run of the same scenario alone.
class CallerLoopTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void loop_tenPeopleFiveMinutes_isTheHeadlessRun_data() {
    QTest::addColumn<int>("number");
    QTest::newRow("Gazebo Classic, 0.05 s") << int{Gazebo};
    QTest::newRow("Gazebo Classic, 0.01 s") << int{GazeboFast};
    QTest::newRow("Gazebo Fortress") << int{Fortress};
    QTest::newRow("Isaac Sim") << int{Isaac};
    QTest::newRow("Webots, its overseer") << int{Webots};
  }

  // Only what messages carry as float32 differs: yaw, speeds, radii, factors (2^-24 of each).
  void loop_tenPeopleFiveMinutes_isTheHeadlessRun() {
    QFETCH(const int, number);
    const Wrapper& wrapper = kWrappers[number];
    sim2d::Scenario scenario = busyHall();
    scenario.desktop.dt = wrapper.dt;
    const Difference difference = differenceOfLoop(scenario, wrapper, 300.0);
    qInfo("largest difference %.3g m, %.3g rad; least way %.1f m; %d states of reaction",
          difference.place, difference.heading, difference.walked, difference.active);
    QVERIFY(difference.place < 2e-4);
    QVERIFY(difference.heading < 1e-3);
    QVERIFY(difference.walked > 2.0);
    QVERIFY(difference.active > 0);
    QCOMPARE(difference.otherStates, 0);
  }

  /// The controller of each person asks by `compute_agent` after each step. In HuNavSim that lets
  /// the tree of the person take another step; by our rules who asks moves nobody.
  void webots_asksForEachPerson_nobodyIsMovedByIt() {
    sim2d::Scenario scenario = busyHall();
    scenario.desktop.dt = kWrappers[Webots].dt;
    const app::Verdict verdict = app::check(bundleOf(scenario));
    QVERIFY(verdict.world);
    Scene asking(scenario, "", kWrappers[Webots]);
    Scene silent(scenario, "", kWrappers[Webots]);
    const int steps = static_cast<int>(std::lround(300.0 / kWrappers[Webots].dt));
    double walked = 0.0;
    for (int k = 0; k <= steps; ++k) {
      const double x =
          -10.0 + 0.5 * kWrappers[Webots].dt * (k % 1200);  // the robot, of its own simulator
      for (Scene* scene : {&asking, &silent}) {
        scene->call(*verdict.world, robotAt(x, -5.8));
      }
      for (const sim2d::Human& human : scenario.humans) {
        const Agent answer = asking.manager().computeOne({human.id}).updatedAgent;
        const Agent& placed = asking.person(human.id);
        QCOMPARE(answer.position.position.x, placed.position.position.x);
        QCOMPARE(answer.behavior.state, placed.behavior.state);
        QCOMPARE(placed.position.position.x, silent.person(human.id).position.position.x);
        QCOMPARE(placed.position.position.y, silent.person(human.id).position.position.y);
        walked = std::max(walked, std::fabs(placed.position.position.x));
      }
    }
    QVERIFY(walked > 5.0);
  }

  /// With the models of ours nobody walks into anybody.
  void loop_ourModels_staysAway() {
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
        putIntoScene(answer.agents[i], kWrappers[Gazebo], agents[i]);
        for (std::size_t j = 0; j < i; ++j) {
          const geometry_msgs::Point& a = agents[i].position.position;
          const geometry_msgs::Point& b = agents[j].position.position;
          nearest = std::min(nearest, std::hypot(a.x - b.x, a.y - b.y));
        }
      }
    }
    QVERIFY2(nearest > 0.8 - 1e-3, qPrintable(QString::number(nearest)));  // two radii of 0.4 m
    QVERIFY(manager.takeWarnings().empty());
  }
};

QTEST_APPLESS_MAIN(CallerLoopTest)
#include "tst_CallerLoop.moc"
