#include "app/bridge/nodes/AgentServer.h"

#include <utility>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/nodes/Node.h"

namespace bridge {
namespace {

const Qos kServices = Qos::keepLast(100);

}  // namespace

/// Problems are also logged by the node.
AgentServer::AgentServer(app::Bundle bundle, ServeSettings settings,
                         std::unique_ptr<Participant> participant, ReportCallback report)
    : NodeProgram(std::move(participant), settings.domain,
                  [this, report = std::move(report)](const base::Diagnostic& diagnostic) {
                    report(diagnostic);
                    if (node_ != nullptr) {
                      node_->log(diagnostic.severity == base::Severity::Error
                                     ? rcl_interfaces::Log::kError
                                     : rcl_interfaces::Log::kWarn,
                                 diagnostic.message);
                    }
                  }),
      settings_(std::move(settings)),
      manager_(std::move(bundle)) {}

void AgentServer::spin(Milliseconds atMost) {
  participant_->spin(atMost);
  publishStep();
  for (const base::Diagnostic& diagnostic : manager_.takeWarnings()) {
    reportOnce(diagnostic);
  }
  reportMissingPeers();
}

template <class S, class Work>
void AgentServer::answer(const std::string& name, Work work) {
  node_->serve<S>(name, kServices, [this, work](const typename S::Request& request) {
    publishStep();
    ++answered_;
    return work(request);
  });
}

bool AgentServer::isEnabled(const char* parameter) const {
  const rcl_interfaces::ParameterValue* const value = node_->parameter(parameter);
  return value != nullptr && value->boolValue;
}

base::Diagnostics AgentServer::start() {
  base::Diagnostics problems = manager_.prepare();
  if (base::hasErrors(problems)) {
    return problems;
  }
  if (settings_.actsAsLoader) {
    createLoaderNode();
  }
  createManagerNodes();
  base::append(problems, finishStart());
  return problems;
}

void AgentServer::createManagerNodes() {
  const auto isUsed = [](const char* name, bool value) { return parameter(name, value); };
  node_ = makeNode(
      settings_.nameSpace, "hunav_agent_manager",
      {isUsed("publish_tf", settings_.publishesTransforms),
       isUsed("publish_sfm_forces", settings_.publishesForces), isUsed("use_sim_time", false)});
  sayNode_ = makeNode(settings_.nameSpace, "agent_say_node", {isUsed("use_sim_time", false)});
  transforms_ = node_->publisher<tf2_msgs::TFMessage>("/tf", Qos::transforms());
  forces_ = node_->publisher<visualization_msgs::MarkerArray>("sfm_forces", Qos::keepLast(5));
  humans_ = node_->publisher<hunav_msgs::Agents>("human_states", Qos::keepLast(1));
  robot_ = node_->publisher<hunav_msgs::Agent>("robot_states", Qos::keepLast(1));
  if (scenario().publishPeople.value_or(true)) {
    people_ = node_->publisher<people_msgs::People>("people", Qos::keepLast(1));
  }
  sayings_ = sayNode_->publisher<std_msgs::String>("agent_say", Qos::keepLast(10));
  answer<hunav_msgs::ComputeAgents>(
      "compute_agents", [this](const auto& request) { return manager_.compute(request); });
  answer<hunav_msgs::ComputeAgent>(
      "compute_agent", [this](const auto& request) { return manager_.computeOne(request); });
  answer<hunav_msgs::MoveAgent>("move_agent",
                                [this](const auto& request) { return manager_.moveOne(request); });
  answer<hunav_msgs::ResetAgents>("reset_agents",
                                  [this](const auto& request) { return manager_.reset(request); });
  if (settings_.actsAsGenerator) {
    const long long seed = scenario().desktop.seed.value_or(1);
    answer<hunav_msgs::GetAgents>(
        "get_agents", [this, seed](const auto&) { return agentsAtStart(scenario(), seed); });
  }
}

void AgentServer::createLoaderNode() {
  const long long seed = scenario().desktop.seed.value_or(1);
  Node::Parameters parameters = loaderParameters(scenario(), seed);
  parameters.push_back(parameter("use_sim_time", false));
  loaderNode_ = makeNode("/", "hunav_loader", std::move(parameters));
  loaderNode_->serve<hunav_msgs::GetParameters>(
      "/get_parameters", kServices,
      [this](const hunav_msgs::GetParameters::Request&) { return loaderSummary(scenario()); });
}

/// Called after the response is sent, because the caller waits for it. If another request arrives
/// first, the topics of the previous step are published before it is handled.
void AgentServer::publishStep() {
  if (const std::optional<StepMessages> topics = manager_.takeTopics()) {
    publish(*topics);
  }
}

void AgentServer::publish(const StepMessages& topics) {
  if (isEnabled("publish_tf")) {
    for (const tf2_msgs::TFMessage& transform : topics.transforms) {
      transforms_.publish(transform);
    }
  }
  if (isEnabled("publish_sfm_forces")) {
    forces_.publish(topics.forces);
  }
  humans_.publish(topics.humans);
  robot_.publish(topics.robot);
  if (people_) {
    people_->publish(topics.people);
  }
  for (std::string& words : manager_.takeSayings()) {
    sayings_.publish({std::move(words)});
  }
}

base::Result<std::unique_ptr<AgentServer>> AgentServer::create(app::Bundle bundle,
                                                               const ServeSettings& settings,
                                                               ReportCallback report) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  std::unique_ptr<AgentServer> server(
      new AgentServer(std::move(bundle), settings, *std::move(participant), std::move(report)));
  base::Diagnostics problems = server->start();
  return base::resultOf(std::move(server), std::move(problems));
}

}  // namespace bridge
