#include "app/bridge/agents/AgentManager.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <utility>

#include "sim2d/base/Find.h"

namespace bridge {
namespace {

using hunav_msgs::Agent;
using hunav_msgs::Agents;

constexpr double kLongestStep = 0.1;  // [s]; the forces are stiff
constexpr double kLeap = 10.0;        // [s]; the clock was set
constexpr double kNanosecond = 1e-9;  // [s]

std::string nameOf(const Agent& agent) {
  return "'" + agent.name + "' (id " + std::to_string(agent.id) + ")";
}

/// An empty list of agents with the header of the request.
Agents withHeaderOf(const Agents& request) {
  Agents answer;
  answer.header = request.header;
  answer.agents.reserve(request.agents.size());
  return answer;
}

/// A copy of the setup whose agents have not been spawned.
sim2d::WorldSetup withNewAgents(const sim2d::WorldSetup& recipe) {
  sim2d::WorldSetup setup;
  setup.scenario = recipe.scenario;
  setup.map = recipe.map;
  setup.surroundings = recipe.surroundings;
  setup.registries = recipe.registries;
  setup.compatibility = recipe.compatibility;
  setup.threads = recipe.threads;
  setup.exact = recipe.exact;
  setup.behavior = bt::withInitialState(*recipe.behavior);
  setup.code = recipe.code;
  setup.folder = recipe.folder;
  setup.stop = recipe.stop;
  return setup;
}

}  // namespace

AgentManager::AgentManager(app::Bundle bundle) : bundle_(std::move(bundle)) {}

base::Diagnostics AgentManager::prepare() {
  base::Diagnostics problems = app::check(bundle_, app::CheckDepth::Meaning).problems;
  if (base::hasErrors(problems)) {
    return problems;
  }
  const auto drawn = drawnScenario(bundle_);
  if (!drawn) {
    base::append(problems, app::errorsOf(drawn.diagnostics()));
    return problems;
  }
  bundle_.scenario = *drawn;
  const auto world = makeWorld({});
  base::append(problems, app::errorsOf(world.diagnostics()));
  return problems;
}

base::Result<std::unique_ptr<sim2d::CoupledWorld>> AgentManager::makeWorld(const Agents& agents) {
  base::Diagnostics strangers;
  const auto scenario = std::make_shared<const sim2d::Scenario>(
      scenarioForCaller(*bundle_.scenario, agents, strangers));
  if (!recipe_ || !(*recipe_->of == *scenario)) {
    app::Bundle bundle = bundle_;
    bundle.scenario = scenario;
    bundle.remarks.clear();
    app::Verdict verdict = app::check(bundle, app::CheckDepth::Setup);
    if (!verdict.setup) {
      return app::errorsOf(verdict.problems);
    }
    recipe_ = Recipe{scenario, std::move(*verdict.setup)};
  }
  base::Result<std::unique_ptr<sim2d::CoupledWorld>> world =
      sim2d::CoupledWorld::create(withNewAgents(recipe_->setup));
  if (!world) {
    return world.diagnostics();
  }
  return {*std::move(world), std::move(strangers)};
}

/// A new agent needs a behavior tree and therefore a new world, which restarts all trees.
bool AgentManager::ensureWorld(const Agents& agents) {
  const bool isComplete =
      world_ != nullptr &&
      std::all_of(agents.agents.begin(), agents.agents.end(), [&](const Agent& agent) {
        return agent.id < 0 || world_->contains(agent.id) || !invalidReason(agent).empty();
      });
  if (isComplete) {
    return true;
  }
  if (hasWorldFailed_ || agents.agents.empty()) {
    return world_ != nullptr;
  }
  base::Result<std::unique_ptr<sim2d::CoupledWorld>> made = makeWorld(agents);
  noteOnce(made.diagnostics());
  if (!made) {
    hasWorldFailed_ = true;
    noteOnce({base::error("ros2.no-world", {}, bundle_.path)});
    return world_ != nullptr;
  }
  if (world_ != nullptr) {
    warn("ros2.minds-anew");
  }
  world_ = *std::move(made);
  lastAgents_.clear();
  agentClocks_.clear();
  return true;
}

std::vector<sim2d::CoupledPerson> AgentManager::usablePeople(const Agents& agents) {
  std::vector<sim2d::CoupledPerson> people;
  people.reserve(agents.agents.size());
  std::set<int> ids;
  for (const Agent& agent : agents.agents) {
    const std::string fault = invalidReason(agent);
    if (!ids.insert(agent.id).second) {
      warn("ros2.agent-twice", {nameOf(agent)});
    } else if (agent.id < 0) {
      warn("ros2.agent-negative", {nameOf(agent)});
    } else if (fault.empty()) {
      if (world_->contains(agent.id)) {
        lastAgents_[agent.id] = agent;
      }
      people.push_back(personOf(agent));
    } else {
      warn("ros2.bad-agent", {nameOf(agent), fault});
      const auto before = lastAgents_.find(agent.id);
      if (before != lastAgents_.end()) {
        people.push_back(personOf(before->second));
      }
    }
  }
  return people;
}

std::optional<sim2d::CoupledRobot> AgentManager::usableRobot(const Agent& robot) {
  const bool isThere = robotOf(robot).has_value();
  const std::string fault = isThere ? invalidReason(robot) : std::string();
  if (!fault.empty()) {
    warn("ros2.bad-agent", {nameOf(robot), fault});
    return lastRobot_;
  }
  if (!isThere && lastRobot_) {
    warn("ros2.robot-gone", {lastRobot_->name});
  }
  lastRobot_ = robotOf(robot);
  return lastRobot_;
}

bool AgentManager::take(const Agents& agents, const Agent& robot) {
  const sim2d::CoupledWorld* const before = world_.get();
  stepped_.reset();
  if (!ensureWorld(agents)) {
    return false;
  }
  world_->take(usablePeople(agents), usableRobot(robot));
  return world_.get() == before;
}

/// Returns the time since the last stamp [s] and stores `now` as the last stamp.
double AgentManager::sinceLast(LastStamp& last, std::int64_t now) {
  const LastStamp before = std::exchange(last, now);
  const double dt = static_cast<double>(now - before.value_or(now)) * kNanosecond;
  if (dt < 0.0) {
    warn("ros2.time-back");
  } else if (dt > kLeap) {
    warn("ros2.time-leap");
  } else {
    return dt;
  }
  return 0.0;
}

/// Sets the clocks of individually stepped agents to the time of all agents.
void AgentManager::restartClocks(const Agents& agents) {
  for (const Agent& agent : agents.agents) {
    if (world_->contains(agent.id)) {  // limits the map to known agents
      agentClocks_[agent.id] = nanosecondsOf(agents.header.stamp);
    }
  }
}

void AgentManager::step(double dt, std::optional<int> only) {
  if (dt <= 0.0) {
    return;
  }
  lastDt_ = dt;
  const int parts = hunav2() ? 1 : static_cast<int>(std::ceil(dt / kLongestStep - 1e-9));
  for (int part = 0; part < std::max(1, parts); ++part) {
    if (!world_->step(dt / std::max(1, parts), only)) {
      warn("ros2.step-failed", {world_->failure()});
      break;
    }
    for (const sim2d::Event& event : world_->events()) {
      if (event.kind == sim2d::EventKind::Say) {
        sayings_.push_back("Agent " + std::to_string(event.id) + " says: " + event.text);
      }
    }
  }
  base::Diagnostics ofTrees;
  world_->behavior().takeDiagnostics(ofTrees);
  noteOnce(ofTrees);
}

Agent AgentManager::responseTo(const Agent& asked) const {
  const int human = world_ == nullptr ? -1 : world_->view().indexOf(asked.id);
  if (human < 0 || !world_->view().isPresent(human)) {
    return asked;
  }
  return responseFor(asked, *world_, human);
}

hunav_msgs::ComputeAgents::Response AgentManager::compute(
    const hunav_msgs::ComputeAgents::Request& request) {
  const Agents& agents = request.currentAgents;
  const bool hasWorld = take(agents, request.robot);
  hunav_msgs::ComputeAgents::Response response;
  response.updatedAgents = withHeaderOf(agents);
  if (world_ != nullptr && !agents.agents.empty()) {
    const double dt = sinceLast(clock_, nanosecondsOf(agents.header.stamp));
    restartClocks(agents);
    if (hasWorld) {
      step(dt, std::nullopt);
      stepped_ = {agents, request.robot};
    }
  }
  for (const Agent& agent : agents.agents) {
    response.updatedAgents.agents.push_back(responseTo(agent));
  }
  return response;
}

hunav_msgs::MoveAgent::Response AgentManager::moveOne(
    const hunav_msgs::MoveAgent::Request& request) {
  const Agents& agents = request.currentAgents;
  const bool hasWorld = take(agents, request.robot);
  hunav_msgs::MoveAgent::Response response;
  response.updatedAgent.id = request.agentId;
  const Agent* const asked = base::findBy(agents.agents, &Agent::id, request.agentId);
  if (world_ != nullptr && !agents.agents.empty()) {
    const std::int64_t now = nanosecondsOf(agents.header.stamp);
    const double passed = sinceLast(clock_, now);
    if (!hasWorld) {
      restartClocks(agents);
    } else if (asked != nullptr) {
      if (world_->contains(request.agentId)) {
        step(sinceLast(agentClocks_[request.agentId], now), request.agentId);
      }
      world_->pass(passed);
      stepped_ = {agents, request.robot};
    }
  }
  if (asked == nullptr) {
    warn("ros2.unknown-agent", {std::to_string(request.agentId)});
    return response;
  }
  response.updatedAgent = responseTo(*asked);
  return response;
}

hunav_msgs::ComputeAgent::Response AgentManager::computeOne(
    const hunav_msgs::ComputeAgent::Request& request) {
  hunav_msgs::ComputeAgent::Response response;
  response.updatedAgent.id = request.id;
  const auto last = lastAgents_.find(request.id);
  if (world_ == nullptr || last == lastAgents_.end() || !world_->contains(request.id)) {
    warn("ros2.unknown-agent", {std::to_string(request.id)});
    return response;
  }
  if (hunav2()) {
    step(lastDt_, request.id);
  }
  response.updatedAgent = responseTo(last->second);
  return response;
}

hunav_msgs::ResetAgents::Response AgentManager::reset(
    const hunav_msgs::ResetAgents::Request& request) {
  if (!hunav2()) {
    world_.reset();
    hasWorldFailed_ = false;
    clock_.reset();
    agentClocks_.clear();
    lastAgents_.clear();
    lastRobot_.reset();
    lastDt_ = 0.0;
  }
  take(request.currentAgents, request.robot);
  if (!hunav2() && world_ != nullptr) {
    sinceLast(clock_, nanosecondsOf(request.currentAgents.header.stamp));
    restartClocks(request.currentAgents);
  }
  hunav_msgs::ResetAgents::Response response;
  response.ok = true;
  return response;
}

std::optional<StepMessages> AgentManager::takeTopics() {
  std::optional<hunav_msgs::ComputeAgents::Request> of = std::exchange(stepped_, std::nullopt);
  if (!of) {
    return std::nullopt;
  }
  return topicsOf(std::move(of->currentAgents), std::move(of->robot), *world_);
}

std::vector<std::string> AgentManager::takeSayings() {
  return std::exchange(sayings_, {});
}

base::Diagnostics AgentManager::takeWarnings() {
  return std::exchange(warnings_, {});
}

void AgentManager::warn(std::string_view code, base::ProblemValues values) {
  noteOnce({base::warning(code, std::move(values), bundle_.path)});
}

void AgentManager::noteOnce(const base::Diagnostics& problems) {
  std::copy_if(problems.begin(), problems.end(), std::back_inserter(warnings_),
               [this](const base::Diagnostic& each) { return reported_.isNew(each.text()); });
}

}  // namespace bridge
