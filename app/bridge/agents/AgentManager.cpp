#include "app/bridge/agents/AgentManager.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/agents/CallerScenario.h"
#include "app/bridge/agents/DrawnScenario.h"

namespace bridge {
namespace {

using hunav_msgs::Agent;
using hunav_msgs::Agents;

constexpr double kLongestStep = 0.1;     // [s]; forces are stiff
constexpr double kLeap = 10.0;           // [s]; the clock was set
constexpr double kNanosecond = 1e-9;     // [s]
constexpr std::size_t kMostTold = 1000;  // causes

std::string nameOf(const Agent& agent) {
  return "'" + agent.name + "' (id " + std::to_string(agent.id) + ")";
}

/// The agents with another list of states, under the same header.
Agents withHeaderOf(const Agents& request) {
  Agents answer;
  answer.header = request.header;
  answer.agents.reserve(request.agents.size());
  return answer;
}

/// The same setup with people who have not entered yet.
sim2d::WorldSetup freshlyMade(const sim2d::WorldSetup& recipe) {
  sim2d::WorldSetup setup;
  setup.scenario = recipe.scenario;
  setup.map = recipe.map;
  setup.surroundings = recipe.surroundings;
  setup.registries = recipe.registries;
  setup.compatibility = recipe.compatibility;
  setup.threads = recipe.threads;
  setup.exact = recipe.exact;
  setup.behavior = bt::withFreshMinds(*recipe.behavior);
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
  base::Diagnostics errors = app::errorsOf(world.diagnostics());
  base::append(problems, errors);
  return problems;
}

base::Result<std::unique_ptr<sim2d::CoupledWorld>> AgentManager::makeWorld(const Agents& agents) {
  base::Diagnostics strangers;
  const auto scenario =
      std::make_shared<const sim2d::Scenario>(scenarioFor(*bundle_.scenario, agents, strangers));
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
      sim2d::CoupledWorld::create(freshlyMade(recipe_->setup));
  if (!world) {
    return world.diagnostics();
  }
  return {*std::move(world), std::move(strangers)};
}

/// Somebody new needs a tree, and with it a new world; the minds of all begin anew then.
bool AgentManager::needWorld(const Agents& agents) {
  const bool isComplete =
      world_ != nullptr &&
      std::all_of(agents.agents.begin(), agents.agents.end(), [&](const Agent& agent) {
        return agent.id < 0 || world_->knows(agent.id) || !faultOf(agent).empty();
      });
  if (isComplete) {
    return true;
  }
  if (cannotBe_ || agents.agents.empty()) {
    return world_ != nullptr;
  }
  base::Result<std::unique_ptr<sim2d::CoupledWorld>> made = makeWorld(agents);
  for (const base::Diagnostic& said : made.diagnostics()) {
    if (told_.size() < kMostTold && told_.insert(said.text()).second) {
      remarks_.push_back(said);
    }
  }
  if (!made) {
    cannotBe_ = true;
    tell(base::Severity::Error, "ros2.no-world");
    return world_ != nullptr;
  }
  if (world_ != nullptr) {
    tell(base::Severity::Warning, "ros2.minds-anew");
  }
  world_ = *std::move(made);
  lastAgents_.clear();
  ownClocks_.clear();
  return true;
}

std::vector<sim2d::CoupledPerson> AgentManager::usablePeople(const Agents& agents) {
  std::vector<sim2d::CoupledPerson> people;
  people.reserve(agents.agents.size());
  std::set<int> ids;
  for (const Agent& agent : agents.agents) {
    const std::string fault = faultOf(agent);
    if (!ids.insert(agent.id).second) {
      tell(base::Severity::Warning, "ros2.agent-twice", {nameOf(agent)});
    } else if (agent.id < 0) {
      tell(base::Severity::Warning, "ros2.agent-negative", {nameOf(agent)});
    } else if (fault.empty()) {
      if (world_->knows(agent.id)) {
        lastAgents_[agent.id] = agent;
      }
      people.push_back(personOf(agent));
    } else {
      tell(base::Severity::Warning, "ros2.bad-agent", {nameOf(agent), fault});
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
  const std::string fault = isThere ? faultOf(robot) : std::string();
  if (!fault.empty()) {
    tell(base::Severity::Warning, "ros2.bad-agent", {nameOf(robot), fault});
    return lastRobot_;
  }
  if (!isThere && lastRobot_) {
    tell(base::Severity::Warning, "ros2.robot-gone", {lastRobot_->name});
  }
  lastRobot_ = robotOf(robot);
  return lastRobot_;
}

bool AgentManager::take(const Agents& agents, const Agent& robot) {
  const sim2d::CoupledWorld* const before = world_.get();
  stepped_.reset();
  if (!needWorld(agents)) {
    return false;
  }
  world_->take(usablePeople(agents), usableRobot(robot));
  return world_.get() == before;
}

/// [s], and the stamp is the last one from here on.
double AgentManager::sinceLast(Stamped& stamped, std::int64_t now) {
  const double dt = static_cast<double>(now - stamped.last) * kNanosecond;
  const bool hadLast = std::exchange(stamped.hasLast, true);
  stamped.last = now;
  if (!hadLast) {
    return 0.0;
  }
  if (dt < 0.0) {
    tell(base::Severity::Warning, "ros2.time-back");
    return 0.0;
  }
  if (dt > kLeap) {
    tell(base::Severity::Warning, "ros2.time-leap");
    return 0.0;
  }
  return dt;
}

/// Of people in steps of their own: they are as far as all others now.
void AgentManager::restartClocks(const Agents& agents) {
  for (const Agent& agent : agents.agents) {
    if (world_->knows(agent.id)) {  // else they grow with whatever is asked
      ownClocks_[agent.id] = {nanosecondsOf(agents.header.stamp), true};
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
      tell(base::Severity::Warning, "ros2.step-failed", {world_->failure()});
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
  for (const base::Diagnostic& said : ofTrees) {
    if (told_.size() < kMostTold && told_.insert(said.text()).second) {
      remarks_.push_back(said);
    }
  }
}

Agent AgentManager::answerTo(const Agent& asked) const {
  const int human = world_ == nullptr ? -1 : world_->view().indexOf(asked.id);
  if (human < 0 || !world_->view().isPresent(human)) {
    return asked;
  }
  return answerFor(asked, *world_, human);
}

hunav_msgs::ComputeAgents::Response AgentManager::compute(
    const hunav_msgs::ComputeAgents::Request& request) {
  const Agents& agents = request.currentAgents;
  const bool goesOn = take(agents, request.robot);
  hunav_msgs::ComputeAgents::Response response;
  response.updatedAgents = withHeaderOf(agents);
  if (world_ != nullptr && !agents.agents.empty()) {
    const double dt = sinceLast(clock_, nanosecondsOf(agents.header.stamp));
    restartClocks(agents);
    if (goesOn) {
      step(dt, std::nullopt);
      stepped_ = {agents, request.robot};
    }
  }
  for (const Agent& agent : agents.agents) {
    response.updatedAgents.agents.push_back(answerTo(agent));
  }
  return response;
}

hunav_msgs::MoveAgent::Response AgentManager::moveOne(
    const hunav_msgs::MoveAgent::Request& request) {
  const Agents& agents = request.currentAgents;
  const bool goesOn = take(agents, request.robot);
  hunav_msgs::MoveAgent::Response response;
  response.updatedAgent.id = request.agentId;
  const auto asked = std::find_if(agents.agents.begin(), agents.agents.end(),
                                  [&](const Agent& agent) { return agent.id == request.agentId; });
  if (world_ != nullptr && !agents.agents.empty()) {
    const std::int64_t now = nanosecondsOf(agents.header.stamp);
    const double passed = sinceLast(clock_, now);
    if (!goesOn) {
      restartClocks(agents);
    } else if (asked != agents.agents.end()) {
      if (world_->knows(request.agentId)) {
        step(sinceLast(ownClocks_[request.agentId], now), request.agentId);
      }
      world_->pass(passed);
      stepped_ = {agents, request.robot};
    }
  }
  if (asked == agents.agents.end()) {
    tell(base::Severity::Warning, "ros2.unknown-agent", {std::to_string(request.agentId)});
    return response;
  }
  response.updatedAgent = answerTo(*asked);
  return response;
}

hunav_msgs::ComputeAgent::Response AgentManager::computeOne(
    const hunav_msgs::ComputeAgent::Request& request) {
  hunav_msgs::ComputeAgent::Response response;
  response.updatedAgent.id = request.id;
  const auto last = lastAgents_.find(request.id);
  if (world_ == nullptr || last == lastAgents_.end() || !world_->knows(request.id)) {
    tell(base::Severity::Warning, "ros2.unknown-agent", {std::to_string(request.id)});
    return response;
  }
  if (hunav2()) {
    step(lastDt_, request.id);
  }
  response.updatedAgent = answerTo(last->second);
  return response;
}

hunav_msgs::ResetAgents::Response AgentManager::reset(
    const hunav_msgs::ResetAgents::Request& request) {
  if (!hunav2()) {
    world_.reset();
    cannotBe_ = false;
    clock_ = {};
    ownClocks_.clear();
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

std::optional<StepTopics> AgentManager::takeTopics() {
  std::optional<hunav_msgs::ComputeAgents::Request> of = std::exchange(stepped_, std::nullopt);
  if (!of) {
    return std::nullopt;
  }
  return topicsOf(std::move(of->currentAgents), std::move(of->robot), *world_);
}

std::vector<std::string> AgentManager::takeSayings() {
  return std::exchange(sayings_, {});
}

base::Diagnostics AgentManager::takeRemarks() {
  return std::exchange(remarks_, {});
}

void AgentManager::tell(base::Severity severity, std::string_view code,
                        base::ProblemValues values) {
  base::Diagnostic remark = base::problem(severity, code, std::move(values), bundle_.path);
  if (told_.size() < kMostTold && told_.insert(remark.text()).second) {
    remarks_.push_back(std::move(remark));
  }
}

}  // namespace bridge
