#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/agents/AgentManager.h"
#include "sim2d/base/Find.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/CoupledWorld.h"

namespace bridge {
namespace {

using hunav_msgs::Agent;
using hunav_msgs::AgentBehavior;
using sim2d::Human;
using sim2d::Scenario;

constexpr double kSameGoal = 1e-3;     // [m]
constexpr double kMostSpeed = 100.0;   // [m/s], as for scenario keys
constexpr double kMostRadius = 100.0;  // [m]
constexpr double kMostFactor = 1e4;    // of forces; usually 2 to 20
constexpr double kMostDuration = 1e6;  // [s]

/// Reads the properties of an agent from a message, limited to values that a world accepts: one
/// extreme value would stop the steps of all agents. A value that is 0 or not finite means unset.
class MessageReader {
 public:
  MessageReader(const Agent& agent, base::Diagnostics& remarks)
      : agent_(agent), remarks_(remarks) {}

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

/// The id of the global goal at this position; adds one if there is none.
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

void takeGoals(const Agent& agent, const MessageReader& reader, Scenario& scenario, Human& human) {
  std::vector<int> goals;
  for (const geometry_msgs::Pose& goal : agent.goals) {
    const sim2d::Vec2 place(goal.position.x, goal.position.y);
    if (place.allFinite() && place.norm() <= base::kMaxCoordinate) {
      goals.push_back(goalAt(place, scenario));
    }
  }
  if (goals.empty()) {
    return;  // the Isaac wrapper sends none
  }
  human.goals = std::move(goals);
  human.ours.wait.clear();
  human.cyclicGoals = agent.cyclicGoals;
  reader.take("goal_radius", agent.goalRadius, kMostRadius, human.goalRadius);
}

void takeFactors(const AgentBehavior& from, const MessageReader& reader, sim2d::Behavior& to) {
  const auto goal = reader.positive("goal_force_factor", from.goalForceFactor, kMostFactor);
  const auto obstacle =
      reader.positive("obstacle_force_factor", from.obstacleForceFactor, kMostFactor);
  const auto social = reader.positive("social_force_factor", from.socialForceFactor, kMostFactor);
  if (!goal || !obstacle || !social) {
    return;
  }
  to.configuration = sim2d::Configuration::Custom;  // already drawn by the caller's loader
  to.goalForceFactor = goal;
  to.obstacleForceFactor = obstacle;
  to.socialForceFactor = social;
  if (std::fabs(from.otherForceFactor) <= kMostFactor) {  // 0 and negative values are valid
    to.otherForceFactor = double{from.otherForceFactor};
  }
}

void takeBehavior(const AgentBehavior& from, const MessageReader& reader, sim2d::Behavior& to) {
  const bool isKnown =
      from.type >= AgentBehavior::kBehRegular && from.type <= AgentBehavior::kBehThreatening;
  to.type = isKnown ? static_cast<sim2d::BehaviorType>(from.type) : sim2d::BehaviorType::Regular;
  to.once = from.once;
  reader.take("duration", from.duration, kMostDuration, to.duration);
  reader.take("vel", from.vel, kMostSpeed, to.vel);
  reader.take("dist", from.dist, base::kMaxCoordinate, to.dist);
}

/// A unique name.
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

Human& addUnknownAgent(const Agent& agent, const MessageReader& reader, Scenario& scenario) {
  Human human;
  human.initPose = personOf(agent).pose;
  human.key = {base::EntityKind::Human, scenario.nextKey()};
  human.id = agent.id;
  human.name = nameFor(agent, scenario);
  takeBehavior(agent.behavior, reader, human.behavior);
  scenario.humans.push_back(std::move(human));
  return scenario.humans.back();
}

}  // namespace

Scenario scenarioForCaller(const Scenario& served, const hunav_msgs::Agents& agents,
                           base::Diagnostics& remarks) {
  Scenario scenario = served;
  for (sim2d::Robot& robot : scenario.robots) {
    robot.listed = false;
  }
  scenario.desktop.variation = onlyReactionTimes(std::move(scenario.desktop.variation));
  for (const Agent& agent : agents.agents) {
    if (agent.id < 0 || !invalidReason(agent).empty()) {
      continue;
    }
    Human* const found = base::findBy(scenario.humans, &Human::id, agent.id);
    const bool isUnknown = found == nullptr;
    const MessageReader reader(agent, remarks);
    Human& human = isUnknown ? addUnknownAgent(agent, reader, scenario) : *found;
    human.listed = true;
    if (isUnknown) {
      remarks.push_back(base::problem(base::Severity::Warning, "ros2.stranger",
                                      {agent.name, std::to_string(agent.id)}));
    }
    human.groupId = agent.groupId;
    reader.take("desired_velocity", agent.desiredVelocity, kMostSpeed, human.maxVel);
    reader.take("radius", agent.radius, kMostRadius, human.radius);
    takeGoals(agent, reader, scenario, human);
    takeFactors(agent.behavior, reader, human.behavior);
  }
  return scenario;
}

namespace {

using sim2d::VariationQuantity;

bool isDrawn(const sim2d::VariationSettings& variation, VariationQuantity quantity) {
  return sim2d::spreadOf(variation, quantity).kind != sim2d::SpreadKind::None;
}

/// The agents of the scenario, in a world without robots. No planner has to be started, and the
/// agents are the same as with robots.
base::Result<std::unique_ptr<sim2d::CoupledWorld>> worldWithoutRobots(app::Bundle bundle) {
  auto people = std::make_shared<Scenario>(*bundle.scenario);
  for (sim2d::Robot& robot : people->robots) {
    robot.listed = false;
  }
  bundle.scenario = std::move(people);
  bundle.remarks.clear();
  app::Verdict verdict = app::check(bundle, app::CheckDepth::Setup);
  if (!verdict.setup) {
    return app::errorsOf(verdict.problems);
  }
  return sim2d::CoupledWorld::create(std::move(*verdict.setup));
}

void applyDraws(const sim2d::VariationSettings& variation, long long seed,
                const sim2d::ResolvedHuman& drawn, Human& human) {
  if (isDrawn(variation, VariationQuantity::Start)) {
    human.initPose.position = drawn.start.position;
  }
  if (isDrawn(variation, VariationQuantity::Heading)) {
    human.initPose.heading = drawn.start.heading;
  }
  if (isDrawn(variation, VariationQuantity::Speed)) {
    human.maxVel = drawn.desiredSpeed;
  }
  sim2d::FirstGoal first = sim2d::firstGoalOf(variation, human, seed);
  human.goals = std::move(first.goals);
  human.ours.wait = std::move(first.wait);
}

}  // namespace

sim2d::VariationSettings onlyReactionTimes(sim2d::VariationSettings variation) {
  for (std::size_t i = 0; i < sim2d::kVariedCount; ++i) {
    if (static_cast<VariationQuantity>(i) != VariationQuantity::ReactionTime) {
      variation.spreads.at(i) = {};
      variation.spreads.at(i).kind = sim2d::SpreadKind::None;
    }
  }
  return variation;
}

base::Result<std::shared_ptr<const Scenario>> drawnScenario(const app::Bundle& bundle) {
  const sim2d::VariationSettings& variation = bundle.scenario->desktop.variation;
  if (!sim2d::isVaried(variation)) {
    return bundle.scenario;
  }
  const auto world = worldWithoutRobots(bundle);
  if (!world) {
    return world.diagnostics();
  }
  auto drawn = std::make_shared<Scenario>(*bundle.scenario);
  const sim2d::WorldView& view = (*world)->view();
  for (Human& human : drawn->humans) {
    const int index = view.indexOf(human.id);
    if (human.listed && index >= 0) {
      applyDraws(variation, drawn->desktop.seed.value_or(1), view.constants(index), human);
    }
  }
  drawn->desktop.variation = onlyReactionTimes(variation);
  return std::shared_ptr<const Scenario>(std::move(drawn));
}

}  // namespace bridge
