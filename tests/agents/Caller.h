#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/bridge/agents/AgentManager.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Find.h"

/// A caller of the agent manager as the wrappers are, and bundles without files.
namespace agentstest {

using namespace bridge;
using hunav_msgs::Agent;
using hunav_msgs::Agents;

inline app::Bundle bundleOf(sim2d::Scenario scenario, const std::string& compat = {}) {
  app::Bundle bundle;
  bundle.path = "test.yaml";
  bundle.scenario = std::make_shared<const sim2d::Scenario>(std::move(scenario));
  bundle.map = std::make_shared<const sim2d::OccupancyGrid>();
  if (!compat.empty()) {
    bundle.settings.compatibility = *sim2d::Compatibility::parse(compat);
  }
  return bundle;
}

inline int addGoal(sim2d::Scenario& scenario, double x, double y) {
  sim2d::GlobalGoal& goal = scenario.goals.emplace_back();
  goal.key = {base::EntityKind::Goal, scenario.nextKey()};
  goal.id = static_cast<int>(scenario.goals.size());
  goal.position = {x, y};
  return goal.id;
}

inline sim2d::Human& addPerson(sim2d::Scenario& scenario, int id, double x, double y,
                               std::vector<int> goals) {
  sim2d::Human human;
  human.key = {base::EntityKind::Human, scenario.nextKey()};
  human.id = id;
  human.name = "person" + std::to_string(id);
  human.initPose = {{x, y}, 0.0};
  human.goals = std::move(goals);
  human.radius = 0.4;
  human.maxVel = 1.5;
  human.goalRadius = 0.3;
  human.cyclicGoals = true;
  scenario.humans.push_back(human);
  return scenario.humans.back();
}

inline sim2d::Robot& addRobot(sim2d::Scenario& scenario, const sim2d::Vec2& start) {
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, scenario.nextKey()};
  robot.name = "robot1";
  robot.start = {start, 0.0};
  scenario.robots.push_back(robot);
  return scenario.robots.back();
}

/// One person at the origin who wants to (5, 0).
inline sim2d::Scenario oneWalker() {
  sim2d::Scenario scenario;
  const int goal = addGoal(scenario, 5.0, 0.0);
  addPerson(scenario, 1, 0.0, 0.0, {goal});
  return scenario;
}

inline Agent agentAt(int id, double x, double y) {
  Agent agent;
  agent.id = id;
  agent.type = Agent::kPerson;
  agent.name = "person" + std::to_string(id);
  agent.groupId = -1;
  agent.position.position = {x, y, 1.25};
  agent.desiredVelocity = 1.5F;
  agent.radius = 0.4F;
  agent.behavior.type = 1;
  return agent;
}

inline void setStamp(Agents& agents, double seconds) {
  const auto whole = static_cast<std::int32_t>(seconds);
  agents.header.stamp.sec = whole;
  agents.header.stamp.nanosec = static_cast<std::uint32_t>((seconds - whole) * 1e9 + 0.5);
}

inline hunav_msgs::ComputeAgents::Request requestOf(std::vector<Agent> agents, double seconds) {
  hunav_msgs::ComputeAgents::Request request;
  request.currentAgents.header.frameId = "map";
  setStamp(request.currentAgents, seconds);
  request.currentAgents.agents = std::move(agents);
  return request;
}

inline Agent robotAt(double x, double y) {
  Agent robot;
  robot.id = 77;
  robot.type = Agent::kRobot;
  robot.name = "robot";
  robot.groupId = -1;
  robot.position.position = {x, y, 0.0};
  robot.radius = 0.35F;
  return robot;
}

inline bool hasRemark(const base::Diagnostics& remarks, const std::string& code) {
  return base::findBy(remarks, &base::Diagnostic::code, code) != nullptr;
}

}  // namespace agentstest
