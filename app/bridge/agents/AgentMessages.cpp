#include "app/bridge/agents/AgentMessages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "sim2d/base/Math.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace bridge {
namespace {

constexpr double kFarthest = 1e6;  // [m]

bool isUsable(double value, double most) {
  return std::isfinite(value) && std::fabs(value) <= most;
}

}  // namespace

std::string invalidReason(const hunav_msgs::Agent& agent) {
  const geometry_msgs::Twist& v = agent.velocity;
  if (!isUsable(agent.position.position.x, kFarthest) ||
      !isUsable(agent.position.position.y, kFarthest)) {
    return "position is not finite or beyond 1e6 m";
  }
  if (!isUsable(agent.yaw, 1e5)) {
    return "yaw is not finite or beyond 1e5 rad";
  }
  if (!isUsable(v.linear.x, sim2d::kMaxPlausibleSpeed) ||
      !isUsable(v.linear.y, sim2d::kMaxPlausibleSpeed)) {
    return "velocity is not finite or above 1000 m/s";
  }
  return {};
}

sim2d::CoupledPerson personOf(const hunav_msgs::Agent& agent) {
  sim2d::CoupledPerson person;
  person.id = agent.id;
  person.pose = {{agent.position.position.x, agent.position.position.y}, double{agent.yaw}};
  person.velocity = {agent.velocity.linear.x, agent.velocity.linear.y};
  person.omega = std::isfinite(agent.velocity.angular.z) ? agent.velocity.angular.z : 0.0;
  for (const geometry_msgs::Point& point : agent.closestObs) {
    if (isUsable(point.x, kFarthest) && isUsable(point.y, kFarthest)) {
      person.obstacles.emplace_back(point.x, point.y);
    }
  }
  return person;
}

std::optional<sim2d::CoupledRobot> robotOf(const hunav_msgs::Agent& robot) {
  if (robot.type == 0 && robot.name.empty()) {
    return std::nullopt;
  }
  constexpr double kLargestRadius = 100.0;  // [m]
  const sim2d::CoupledPerson body = personOf(robot);
  sim2d::CoupledRobot known;
  known.name = robot.name;
  known.pose = body.pose;
  known.velocity = body.velocity;
  known.omega = body.omega;
  if (robot.radius > 0.0F && double{robot.radius} <= kLargestRadius) {
    known.radius = double{robot.radius};
  }
  return known;
}

void setBehavior(const sim2d::ResolvedHuman& person, hunav_msgs::AgentBehavior& to) {
  to.type = static_cast<std::uint8_t>(person.behavior);
  to.duration = static_cast<float>(person.reactionDuration);
  to.once = person.reactionOnce;
  to.vel = static_cast<float>(person.reactionSpeed);
  to.dist = static_cast<float>(person.noticeDistance);
  to.socialForceFactor = static_cast<float>(person.socialFactor);
  to.goalForceFactor = static_cast<float>(person.goalFactor);
  to.obstacleForceFactor = static_cast<float>(person.obstacleFactor);
  to.otherForceFactor = static_cast<float>(person.otherFactor);
}

hunav_msgs::Agent responseFor(const hunav_msgs::Agent& asked, const sim2d::CoupledWorld& world,
                              int human) {
  const sim2d::ResolvedHuman& person = world.view().constants(human);
  const sim2d::Pose2 pose = world.view().pose(human);
  const sim2d::Vec2 velocity = world.view().velocity(human);
  hunav_msgs::Agent response = asked;
  response.type = hunav_msgs::Agent::kPerson;
  response.position.position.x = pose.position.x();
  response.position.position.y = pose.position.y();
  response.position.orientation = quaternionOf(pose.heading);
  response.yaw = static_cast<float>(pose.heading);
  response.linearVel = static_cast<float>(velocity.norm());
  response.angularVel = static_cast<float>(world.omega(human));
  response.velocity = {};
  response.velocity.linear.x = velocity.x();
  response.velocity.linear.y = velocity.y();
  response.velocity.angular.z = world.omega(human);
  response.desiredVelocity = static_cast<float>(person.desiredSpeed);
  response.radius = static_cast<float>(person.radius);
  response.goalRadius = static_cast<float>(person.goalRadius);
  response.cyclicGoals = person.cyclicGoals;
  setBehavior(person, response.behavior);
  response.behavior.state = world.isActive(human) ? hunav_msgs::AgentBehavior::kBehActive1
                                                  : hunav_msgs::AgentBehavior::kBehNoActive;
  response.closestObs.clear();
  const std::vector<sim2d::GoalItem>& goals = world.control(human).goals;
  if (!goals.empty()) {
    response.goals.clear();
  }
  for (const sim2d::GoalItem& goal : goals) {
    response.goals.push_back({{goal.position.x(), goal.position.y(), 0.0}, {}});
  }
  return response;
}

geometry_msgs::Quaternion quaternionOf(double yaw) {
  const base::SinCos half = base::sinCos(yaw / 2.0);
  geometry_msgs::Quaternion turn;
  turn.z = half.sin;
  turn.w = half.cos;
  return turn;
}

namespace {

using visualization_msgs::Marker;

constexpr double kNoForce = 1e-4;      // [m/s²]
constexpr double kArrowWidth = 0.1;    // [m]
constexpr double kTextHeight = 1.0;    // [m] above the person
constexpr double kTextSize = 0.5;      // [m]
constexpr std::int32_t kLifetime = 1;  // [s]

constexpr std::array<const char*, 7> kBehaviors = {"REGULAR", "REGULAR", "IMPASSIVE",  "SURPRISED",
                                                   "SCARED",  "CURIOUS", "THREATENING"};

tf2_msgs::TFMessage transformOf(const hunav_msgs::Agent& agent, const std_msgs::Header& header) {
  geometry_msgs::TransformStamped transform;
  transform.header = header;
  transform.childFrameId = agent.name;
  transform.transform.translation = {agent.position.position.x, agent.position.position.y,
                                     agent.position.position.z};
  transform.transform.rotation = quaternionOf(double{agent.yaw});
  tf2_msgs::TFMessage message;
  message.transforms.push_back(std::move(transform));
  return message;
}

Marker arrow(const hunav_msgs::Agent& agent, const std_msgs::Header& header, std::int32_t number,
             const sim2d::Vec2& force, const std_msgs::ColorRGBA& color) {
  const double size = force.norm();
  Marker marker;
  marker.header = header;
  marker.ns = agent.name + "/robot_forces";
  // Unsigned, so that the largest id wraps around.
  marker.id = static_cast<std::int32_t>(static_cast<std::uint32_t>(agent.id) +
                                        static_cast<std::uint32_t>(number));
  marker.type = Marker::kArrow;
  marker.action = size > kNoForce ? Marker::kAdd : Marker::kDelete;
  marker.pose.position = agent.position.position;
  marker.pose.position.z = 0.0;
  marker.pose.orientation = quaternionOf(base::atan2(force.y(), force.x()));
  marker.scale = {std::max(kNoForce, size), kArrowWidth, kArrowWidth};
  marker.color = color;
  marker.lifetime.sec = kLifetime;
  return marker;
}

Marker label(const hunav_msgs::Agent& agent, const std_msgs::Header& header, std::size_t behavior) {
  Marker marker;
  marker.header = header;
  marker.ns = agent.name + "/behavior";
  marker.id = agent.id;
  marker.type = Marker::kTextViewFacing;
  marker.action = Marker::kAdd;
  marker.pose.position = agent.position.position;
  marker.pose.position.z += kTextHeight;
  marker.scale.z = kTextSize;
  marker.color = {1.0F, 1.0F, 1.0F, 1.0F};
  marker.lifetime.sec = kLifetime;
  marker.text = agent.name + "/" + kBehaviors.at(std::min(behavior, kBehaviors.size() - 1));
  return marker;
}

void addForces(const hunav_msgs::Agent& agent, const std_msgs::Header& header,
               const sim2d::CoupledWorld& world, std::vector<Marker>& to) {
  const int human = world.view().indexOf(agent.id);
  const auto at = static_cast<std::size_t>(human);
  const sim2d::ForceColumns& all = world.forces();
  if (human < 0 || at >= all.goal.size()) {
    return;
  }
  const sim2d::Vec2 sum = all.goal[at] + all.social[at] + all.obstacle[at] + all.group[at];
  to.push_back(arrow(agent, header, 1, all.obstacle[at], {1.0F, 0.0F, 0.0F, 1.0F}));
  to.push_back(arrow(agent, header, 2, all.social[at], {0.0F, 0.0F, 1.0F, 1.0F}));
  to.push_back(arrow(agent, header, 3, all.goal[at], {0.0F, 1.0F, 0.0F, 1.0F}));
  to.push_back(arrow(agent, header, 4, sum, {1.0F, 1.0F, 1.0F, 1.0F}));
  to.push_back(
      label(agent, header, static_cast<std::size_t>(world.view().constants(human).behavior)));
}

people_msgs::Person personWithTags(const hunav_msgs::Agent& agent) {
  people_msgs::Person person;
  person.name = agent.name;
  const double yaw = double{agent.yaw};
  const double speed = double{agent.linearVel};
  const base::SinCos along = base::sinCos(std::isfinite(yaw) ? yaw : 0.0);
  person.position = {agent.position.position.x, agent.position.position.y, yaw};
  person.velocity = {speed * along.cos, speed * along.sin, double{agent.angularVel}};
  person.reliability = 1.0;
  person.tagnames = {"id", "group_id", "behavior"};
  person.tags = {std::to_string(agent.id), std::to_string(agent.groupId),
                 std::to_string(agent.behavior.type)};
  return person;
}

}  // namespace

StepMessages topicsOf(hunav_msgs::Agents agents, hunav_msgs::Agent robot,
                      const sim2d::CoupledWorld& world) {
  StepMessages topics;
  const std_msgs::Header& header = agents.header;
  if (robotOf(robot) && !robot.name.empty()) {
    topics.transforms.push_back(transformOf(robot, header));
  }
  topics.people.header = header;
  for (const hunav_msgs::Agent& agent : agents.agents) {
    if (!agent.name.empty() && invalidReason(agent).empty()) {
      topics.transforms.push_back(transformOf(agent, header));
    }
    addForces(agent, header, world, topics.forces.markers);
    topics.people.people.push_back(personWithTags(agent));
  }
  topics.humans = std::move(agents);
  topics.robot = std::move(robot);
  return topics;
}

namespace {

using rcl_interfaces::Parameter;
using rcl_interfaces::ParameterType;
using rcl_interfaces::ParameterValue;
using sim2d::Human;
using sim2d::ResolvedHuman;
using sim2d::Scenario;

constexpr int kNoSkin = -1;

template <class T>
Parameter parameterOf(std::string name, std::uint8_t type, T ParameterValue::*member, T value) {
  Parameter made;
  made.name = std::move(name);
  made.value.type = type;
  made.value.*member = std::move(value);
  return made;
}

void addPerson(const Scenario& scenario, const Human& human, long long seed,
               std::vector<Parameter>& to) {
  const ResolvedHuman person = sim2d::resolveHuman(scenario, human, seed);
  const std::string of = human.name + ".";
  const std::string behavior = of + "behavior.";
  const auto integer = [](int value) { return static_cast<std::int64_t>(value); };
  to.push_back(parameter(of + "id", integer(person.id)));
  to.push_back(parameter(of + "skin", integer(human.skin.value_or(kNoSkin))));
  to.push_back(parameter(behavior + "type", std::string(sim2d::behaviorName(person.behavior))));
  to.push_back(
      parameter(behavior + "configuration", integer(static_cast<int>(person.configuration))));
  to.push_back(parameter(behavior + "duration", person.reactionDuration));
  to.push_back(parameter(behavior + "once", person.reactionOnce));
  to.push_back(parameter(behavior + "vel", person.reactionSpeed));
  to.push_back(parameter(behavior + "dist", person.noticeDistance));
  to.push_back(parameter(behavior + "social_force_factor", person.socialFactor));
  to.push_back(parameter(behavior + "goal_force_factor", person.goalFactor));
  to.push_back(parameter(behavior + "obstacle_force_factor", person.obstacleFactor));
  to.push_back(parameter(behavior + "other_force_factor", person.otherFactor));
  to.push_back(parameter(of + "group_id", integer(person.groupId)));
  to.push_back(parameter(of + "max_vel", person.desiredSpeed));
  to.push_back(parameter(of + "radius", person.radius));
  to.push_back(parameter(of + "init_pose.x", human.initPose.position.x()));
  to.push_back(parameter(of + "init_pose.y", human.initPose.position.y()));
  to.push_back(parameter(of + "init_pose.z", human.initZ.value_or(0.0)));
  to.push_back(parameter(of + "init_pose.h", human.initPose.heading));
  to.push_back(parameter(of + "goal_radius", person.goalRadius));
  to.push_back(parameter(of + "cyclic_goals", person.cyclicGoals));
  to.push_back(parameterOf(of + "goals", ParameterType::kParameterIntegerArray,
                           &ParameterValue::integerArrayValue,
                           std::vector<std::int64_t>(human.goals.begin(), human.goals.end())));
}

hunav_msgs::Agent agentOf(const Scenario& scenario, const Human& human, long long seed) {
  const ResolvedHuman person = sim2d::resolveHuman(scenario, human, seed);
  hunav_msgs::Agent agent;
  agent.id = person.id;
  agent.type = hunav_msgs::Agent::kPerson;
  agent.skin = static_cast<std::uint8_t>(std::max(0, human.skin.value_or(0)));
  agent.name = person.name;
  agent.groupId = static_cast<std::int8_t>(person.groupId);
  agent.position.position = {human.initPose.position.x(), human.initPose.position.y(),
                             human.initZ.value_or(0.0)};
  agent.position.orientation = quaternionOf(human.initPose.heading);
  agent.yaw = static_cast<float>(human.initPose.heading);
  agent.desiredVelocity = static_cast<float>(person.desiredSpeed);
  agent.radius = static_cast<float>(person.radius);
  agent.cyclicGoals = person.cyclicGoals;
  agent.goalRadius = static_cast<float>(person.goalRadius);
  setBehavior(person, agent.behavior);
  agent.behavior.configuration = static_cast<std::uint8_t>(person.configuration);
  for (const int id : human.goals) {
    if (const sim2d::GlobalGoal* const goal = scenario.goal(id)) {
      agent.goals.push_back({{goal->position.x(), goal->position.y(), 0.0}, {}});
    }
  }
  return agent;
}

}  // namespace

Parameter parameter(std::string name, bool value) {
  return parameterOf(std::move(name), ParameterType::kParameterBool, &ParameterValue::boolValue,
                     value);
}

Parameter parameter(std::string name, std::int64_t value) {
  return parameterOf(std::move(name), ParameterType::kParameterInteger,
                     &ParameterValue::integerValue, value);
}

Parameter parameter(std::string name, double value) {
  return parameterOf(std::move(name), ParameterType::kParameterDouble, &ParameterValue::doubleValue,
                     value);
}

Parameter parameter(std::string name, std::string value) {
  return parameterOf(std::move(name), ParameterType::kParameterString, &ParameterValue::stringValue,
                     std::move(value));
}

std::vector<Parameter> loaderParameters(const Scenario& scenario, long long seed) {
  std::vector<Parameter> all;
  all.push_back(parameter("map", sim2d::mapBaseName(scenario.map.value_or(""))));
  all.push_back(parameter("simulator", scenario.simulator.value_or("Gazebo")));
  all.push_back(parameter("yaml_base_name", scenario.yamlBaseName.value_or("")));
  all.push_back(parameter("publish_people", scenario.publishPeople.value_or(true)));
  std::vector<std::string> names;
  sim2d::forEachListed(scenario.humans, [&](const Human& human) { names.push_back(human.name); });
  all.push_back(parameterOf("agents", ParameterType::kParameterStringArray,
                            &ParameterValue::stringArrayValue, std::move(names)));
  for (const sim2d::GlobalGoal& goal : scenario.goals) {
    const std::string of = "global_goals." + std::to_string(goal.id);
    all.push_back(parameter(of + ".x", goal.position.x()));
    all.push_back(parameter(of + ".y", goal.position.y()));
  }
  sim2d::forEachListed(scenario.humans,
                       [&](const Human& human) { addPerson(scenario, human, seed, all); });
  return all;
}

hunav_msgs::GetParameters::Response loaderSummary(const Scenario& scenario) {
  hunav_msgs::GetParameters::Response summary;
  summary.publishPeople = scenario.publishPeople.value_or(true);
  summary.map = sim2d::mapBaseName(scenario.map.value_or(""));
  summary.simulator = scenario.simulator.value_or("Gazebo");
  summary.yamlBaseName = scenario.yamlBaseName.value_or("");
  for (int id = 1; const sim2d::GlobalGoal* const goal = scenario.goal(id); ++id) {
    summary.goalIds.push_back(id);
    summary.goalXCoords.push_back(goal->position.x());
    summary.goalYCoords.push_back(goal->position.y());
  }
  return summary;
}

hunav_msgs::GetAgents::Response agentsAtStart(const Scenario& scenario, long long seed) {
  hunav_msgs::GetAgents::Response response;
  response.agents.header.frameId = "map";
  sim2d::forEachListed(scenario.humans, [&](const Human& human) {
    response.agents.agents.push_back(agentOf(scenario, human, seed));
  });
  return response;
}

}  // namespace bridge
