#include "app/bridge/nodes/AgentServer.h"

#include <utility>

#include "app/bridge/agents/LoaderResponses.h"
#include "app/bridge/nodes/Node.h"

namespace bridge {
namespace {

const Qos kServices = Qos::keepLast(100);

class DdsAgentServer final : public AgentServer {
 public:
  DdsAgentServer(app::Bundle bundle, ServeSettings settings,
                 std::unique_ptr<Participant> participant, ReportCallback report)
      : settings_(std::move(settings)),
        noPeer_(settings_.domain),
        participant_(std::move(participant)),
        manager_(std::move(bundle)),
        report_(std::move(report)) {}

  /// Errors: DDS failures and scenario errors.
  base::Diagnostics start();
  void spin(Milliseconds atMost) override {
    participant_->spin(atMost);
    publishStep();
    reportWarnings();
    if (const auto diagnostic = noPeer_.check(*participant_)) {
      reportOnce(*diagnostic);
    }
  }
  std::uint64_t answered() const override { return answered_; }

 private:
  void createManagerNodes();
  void createLoaderNode();
  void publishStep();
  void publish(const StepMessages& topics);
  void reportOnce(const base::Diagnostic& diagnostic);
  void reportWarnings();
  template <class S, class Work>
  void answer(const std::string& name, Work work) {
    node_->serve<S>(name, kServices, [this, work](const typename S::Request& request) {
      publishStep();
      ++answered_;
      return work(request);
    });
  }
  const sim2d::Scenario& scenario() const { return *manager_.scenario(); }
  bool isEnabled(const char* parameter) const {
    const rcl_interfaces::ParameterValue* const value = node_->parameter(parameter);
    return value != nullptr && value->boolValue;
  }

  ServeSettings settings_;
  NoPeerCheck noPeer_;
  std::unique_ptr<Participant> participant_;
  AgentManager manager_;
  ReportCallback report_;
  base::DiagnosticFilter reported_;
  base::Diagnostics startProblems_;
  bool hasStarted_ = false;
  std::uint64_t answered_ = 0;
  std::unique_ptr<Node> node_, sayNode_, loaderNode_;
  TypedPublisher<tf2_msgs::TFMessage> transforms_;
  TypedPublisher<visualization_msgs::MarkerArray> forces_;
  TypedPublisher<hunav_msgs::Agents> humans_;
  TypedPublisher<hunav_msgs::Agent> robot_;
  std::optional<TypedPublisher<people_msgs::People>> people_;
  TypedPublisher<std_msgs::String> sayings_;
};

base::Diagnostics DdsAgentServer::start() {
  base::Diagnostics problems = manager_.prepare();
  if (base::hasErrors(problems)) {
    return problems;
  }
  if (settings_.actsAsLoader) {
    createLoaderNode();
  }
  createManagerNodes();
  participant_->publishGraph();
  hasStarted_ = true;
  base::append(problems, startProblems_);
  return problems;
}

void DdsAgentServer::createManagerNodes() {
  const auto isUsed = [](const char* name, bool value) { return parameter(name, value); };
  node_ = std::make_unique<Node>(
      *participant_, settings_.domain, settings_.nameSpace, "hunav_agent_manager",
      Node::Parameters{isUsed("publish_tf", settings_.publishesTransforms),
                       isUsed("publish_sfm_forces", settings_.publishesForces),
                       isUsed("use_sim_time", false)},
      [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
  sayNode_ = std::make_unique<Node>(
      *participant_, settings_.domain, settings_.nameSpace, "agent_say_node",
      Node::Parameters{isUsed("use_sim_time", false)},
      [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
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

void DdsAgentServer::createLoaderNode() {
  const long long seed = scenario().desktop.seed.value_or(1);
  Node::Parameters parameters = loaderParameters(scenario(), seed);
  parameters.push_back(parameter("use_sim_time", false));
  loaderNode_ = std::make_unique<Node>(
      *participant_, settings_.domain, "/", "hunav_loader", std::move(parameters),
      [this](const base::Diagnostic& diagnostic) { reportOnce(diagnostic); });
  loaderNode_->serve<hunav_msgs::GetParameters>(
      "/get_parameters", kServices,
      [this](const hunav_msgs::GetParameters::Request&) { return loaderSummary(scenario()); });
}

/// Called after the response is sent, because the caller waits for it. If another request arrives
/// first, the topics of the previous step are published before it is handled.
void DdsAgentServer::publishStep() {
  if (const std::optional<StepMessages> topics = manager_.takeTopics()) {
    publish(*topics);
  }
}

void DdsAgentServer::publish(const StepMessages& topics) {
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

void DdsAgentServer::reportOnce(const base::Diagnostic& diagnostic) {
  if (!reported_.isNew(problemKey(diagnostic))) {
    return;
  }
  if (!hasStarted_) {
    startProblems_.push_back(diagnostic);
    return;
  }
  report_(diagnostic);
  if (node_ != nullptr) {
    node_->log(diagnostic.severity == base::Severity::Error ? rcl_interfaces::Log::kError
                                                            : rcl_interfaces::Log::kWarn,
               diagnostic.message);
  }
}

void DdsAgentServer::reportWarnings() {
  for (const base::Diagnostic& diagnostic : manager_.takeWarnings()) {
    reportOnce(diagnostic);
  }
}

}  // namespace

base::Result<std::unique_ptr<AgentServer>> AgentServer::create(app::Bundle bundle,
                                                               const ServeSettings& settings,
                                                               ReportCallback report) {
  base::Result<std::unique_ptr<Participant>> participant = Participant::create(settings.domain);
  if (!participant) {
    return participant.diagnostics();
  }
  auto server = std::make_unique<DdsAgentServer>(std::move(bundle), settings,
                                                 *std::move(participant), std::move(report));
  base::Diagnostics problems = server->start();
  if (base::hasErrors(problems)) {
    return problems;
  }
  return {std::unique_ptr<AgentServer>(std::move(server)), std::move(problems)};
}

}  // namespace bridge
