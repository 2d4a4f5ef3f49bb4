#include "app/bridge/agents/CallerScenario.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/bridge/agents/AgentMessages.h"

namespace bridge {
namespace {

using hunav_msgs::Agent;
using hunav_msgs::AgentBehavior;
using sim2d::Human;
using sim2d::Scenario;

constexpr double kSameGoal = 1e-3;  // [m]

bool isPositive(float value) {
  return std::isfinite(value) && value > 0.0F;
}

/// The id of the global goal there, which is added when there is none.
int goalAt(const sim2d::Vec2& place, Scenario& scenario) {
  int last = 0;
  for (const sim2d::GlobalGoal& goal : scenario.goals) {
    if ((goal.position - place).norm() < kSameGoal) {
      return goal.id;
    }
    last = std::max(last, goal.id);
  }
  sim2d::GlobalGoal& added = scenario.goals.emplace_back();
  added.key = {base::EntityKind::Goal, scenario.nextKey()};
  added.id = last + 1;
  added.position = place;
  return added.id;
}

void takeGoals(const Agent& agent, Scenario& scenario, Human& human) {
  std::vector<int> goals;
  for (const geometry_msgs::Pose& goal : agent.goals) {
    const sim2d::Vec2 place(goal.position.x, goal.position.y);
    if (place.allFinite() && place.norm() <= base::kFarthest) {
      goals.push_back(goalAt(place, scenario));
    }
  }
  if (goals.empty()) {
    return;  // Isaac's wrapper sends none
  }
  human.goals = std::move(goals);
  human.ours.wait.clear();
  human.cyclicGoals = agent.cyclicGoals;
  if (isPositive(agent.goalRadius)) {
    human.goalRadius = double{agent.goalRadius};
  }
}

void takeFactors(const AgentBehavior& from, sim2d::Behavior& to) {
  if (!isPositive(from.goalForceFactor) || !isPositive(from.obstacleForceFactor) ||
      !isPositive(from.socialForceFactor)) {
    return;
  }
  to.configuration = sim2d::Configuration::Custom;  // drawn already, by the caller's loader
  to.goalForceFactor = double{from.goalForceFactor};
  to.obstacleForceFactor = double{from.obstacleForceFactor};
  to.socialForceFactor = double{from.socialForceFactor};
  to.otherForceFactor = double{from.otherForceFactor};
}

void takeBehavior(const AgentBehavior& from, sim2d::Behavior& to) {
  const bool isKnown =
      from.type >= AgentBehavior::kBehRegular && from.type <= AgentBehavior::kBehThreatening;
  to.type =
      isKnown ? static_cast<sim2d::BehaviorType>(from.type) : sim2d::BehaviorType::Regular;
  to.once = from.once;
  if (isPositive(from.duration)) {
    to.duration = double{from.duration};
  }
  if (isPositive(from.vel)) {
    to.vel = double{from.vel};
  }
  if (isPositive(from.dist)) {
    to.dist = double{from.dist};
  }
}

/// A name that nobody has.
std::string nameFor(const Agent& agent, const Scenario& scenario) {
  const auto isFree = [&](const std::string& name) { return scenario.human(name) == nullptr; };
  std::string name = agent.name;
  if (name.empty() || !isFree(name)) {
    name = "agent" + std::to_string(agent.id);
  }
  while (!isFree(name)) {
    name += "_";
  }
  return name;
}

Human& addStranger(const Agent& agent, Scenario& scenario) {
  Human human;
  human.initPose = personOf(agent).pose;
  human.key = {base::EntityKind::Human, scenario.nextKey()};
  human.id = agent.id;
  human.name = nameFor(agent, scenario);
  takeBehavior(agent.behavior, human.behavior);
  scenario.humans.push_back(std::move(human));
  return scenario.humans.back();
}

}  // namespace

Scenario scenarioFor(const Scenario& served, const hunav_msgs::Agents& agents,
                     base::Diagnostics& remarks) {
  Scenario scenario = served;
  for (sim2d::Robot& robot : scenario.robots) {
    robot.listed = false;
  }
  scenario.desktop.variation = {};
  for (const Agent& agent : agents.agents) {
    if (agent.id < 0 || !faultOf(agent).empty()) {
      continue;
    }
    const auto found = std::find_if(scenario.humans.begin(), scenario.humans.end(),
                                    [&](const Human& human) { return human.id == agent.id; });
    const bool isStranger = found == scenario.humans.end();
    Human& human = isStranger ? addStranger(agent, scenario) : *found;
    human.listed = true;
    if (isStranger) {
      remarks.push_back(base::problem(base::Severity::Warning, "ros2.stranger",
                                      {agent.name, std::to_string(agent.id)}));
    }
    human.groupId = agent.groupId;
    if (isPositive(agent.desiredVelocity)) {
      human.maxVel = double{agent.desiredVelocity};
    }
    if (isPositive(agent.radius)) {
      human.radius = double{agent.radius};
    }
    takeGoals(agent, scenario, human);
    takeFactors(agent.behavior, human.behavior);
  }
  return scenario;
}

}  // namespace bridge
