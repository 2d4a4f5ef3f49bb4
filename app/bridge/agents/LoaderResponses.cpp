#include "app/bridge/agents/LoaderResponses.h"

#include <algorithm>
#include <string>
#include <utility>

#include "app/bridge/agents/AgentMessages.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioCheck.h"

namespace bridge {
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
