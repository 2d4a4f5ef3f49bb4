#include "app/bridge/agents/CallerScenario.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/agents/DrawnScenario.h"

namespace bridge {
namespace {

using hunav_msgs::Agent;
using hunav_msgs::AgentBehavior;
using sim2d::Human;
using sim2d::Scenario;

constexpr double kSameGoal = 1e-3;     // [m]
constexpr double kMostSpeed = 100.0;   // [m/s], as of the keys of files
constexpr double kMostRadius = 100.0;  // [m]
constexpr double kMostFactor = 1e4;    // of forces; usual ones are 2 to 20
constexpr double kMostDuration = 1e6;  // [s]

/// What a message tells of an agent, as far as a world can be made of it: one wild value would stop
/// the steps of everybody. What is 0 or not finite is not told at all.
class Told {
 public:
  Told(const Agent& agent, base::Diagnostics& remarks) : agent_(agent), remarks_(remarks) {}

  std::optional<double> positive(const char* field, float value, double most) const {
    if (!std::isfinite(value) || value <= 0.0F) {
      return std::nullopt;
    }
    if (double{value} > most) {
      remarks_.push_back(
          base::problem(base::Severity::Warning, "ros2.too-large",
                        {agent_.name, std::to_string(agent_.id), field, double{value}, most}));
      return std::nullopt;
    }
    return double{value};
  }
  template <class T>
  void take(const char* field, float value, double most, T& to) const {
    if (const std::optional<double> usable = positive(field, value, most)) {
      to = *usable;
    }
  }

 private:
  const Agent& agent_;
  base::Diagnostics& remarks_;
};

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

void takeGoals(const Agent& agent, const Told& told, Scenario& scenario, Human& human) {
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
  told.take("goal_radius", agent.goalRadius, kMostRadius, human.goalRadius);
}

void takeFactors(const AgentBehavior& from, const Told& told, sim2d::Behavior& to) {
  const auto goal = told.positive("goal_force_factor", from.goalForceFactor, kMostFactor);
  const auto obstacle =
      told.positive("obstacle_force_factor", from.obstacleForceFactor, kMostFactor);
  const auto social = told.positive("social_force_factor", from.socialForceFactor, kMostFactor);
  if (!goal || !obstacle || !social) {
    return;
  }
  to.configuration = sim2d::Configuration::Custom;  // drawn already, by the caller's loader
  to.goalForceFactor = goal;
  to.obstacleForceFactor = obstacle;
  to.socialForceFactor = social;
  if (std::fabs(from.otherForceFactor) <= kMostFactor) {  // 0 and less are known too
    to.otherForceFactor = double{from.otherForceFactor};
  }
}

void takeBehavior(const AgentBehavior& from, const Told& told, sim2d::Behavior& to) {
  const bool isKnown =
      from.type >= AgentBehavior::kBehRegular && from.type <= AgentBehavior::kBehThreatening;
  to.type = isKnown ? static_cast<sim2d::BehaviorType>(from.type) : sim2d::BehaviorType::Regular;
  to.once = from.once;
  told.take("duration", from.duration, kMostDuration, to.duration);
  told.take("vel", from.vel, kMostSpeed, to.vel);
  told.take("dist", from.dist, base::kFarthest, to.dist);
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

Human& addStranger(const Agent& agent, const Told& told, Scenario& scenario) {
  Human human;
  human.initPose = personOf(agent).pose;
  human.key = {base::EntityKind::Human, scenario.nextKey()};
  human.id = agent.id;
  human.name = nameFor(agent, scenario);
  takeBehavior(agent.behavior, told, human.behavior);
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
  scenario.desktop.variation = reactionTimesAlone(std::move(scenario.desktop.variation));
  for (const Agent& agent : agents.agents) {
    if (agent.id < 0 || !faultOf(agent).empty()) {
      continue;
    }
    const auto found = std::find_if(scenario.humans.begin(), scenario.humans.end(),
                                    [&](const Human& human) { return human.id == agent.id; });
    const bool isStranger = found == scenario.humans.end();
    const Told told(agent, remarks);
    Human& human = isStranger ? addStranger(agent, told, scenario) : *found;
    human.listed = true;
    if (isStranger) {
      remarks.push_back(base::problem(base::Severity::Warning, "ros2.stranger",
                                      {agent.name, std::to_string(agent.id)}));
    }
    human.groupId = agent.groupId;
    told.take("desired_velocity", agent.desiredVelocity, kMostSpeed, human.maxVel);
    told.take("radius", agent.radius, kMostRadius, human.radius);
    takeGoals(agent, told, scenario, human);
    takeFactors(agent.behavior, told, human.behavior);
  }
  return scenario;
}

}  // namespace bridge
