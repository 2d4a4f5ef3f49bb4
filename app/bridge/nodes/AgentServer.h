#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/bridge/agents/AgentManager.h"
#include "app/bridge/nodes/Node.h"

namespace bridge {

struct ServeSettings {
  DomainSettings domain;
  std::string nameSpace = "/";   // namespace of the manager node
  bool actsAsLoader = false;     // also run hunav_loader: the scenario as parameters
  bool actsAsGenerator = false;  // also serve get_agents, as a wrapper's world generator does
  bool publishesForces = true;
  bool publishesTransforms = true;
};

/// Replacement of HuNavSim's nodes `hunav_agent_manager` and `agent_say_node` and, optionally, of
/// `hunav_loader`. Single-threaded.
class AgentServer : public NodeProgram {
 public:
  /// `report` is called once for each distinct problem.
  static base::Result<std::unique_ptr<AgentServer>> create(app::Bundle bundle,
                                                           const ServeSettings& settings,
                                                           ReportCallback report);
  /// Answers pending requests; waits at most `atMost` for the first one.
  void spin(Milliseconds atMost);
  std::uint64_t answered() const { return answered_; }  // number of requests answered

 private:
  AgentServer(app::Bundle bundle, ServeSettings settings, std::unique_ptr<Participant> participant,
              ReportCallback report);
  base::Diagnostics start();  // errors: DDS failures and scenario errors
  void createManagerNodes();
  void createLoaderNode();
  void publishStep();
  void publish(const StepMessages& topics);
  template <class S, class Work>
  void answer(const std::string& name, Work work);
  const sim2d::Scenario& scenario() const { return *manager_.scenario(); }
  bool isEnabled(const char* parameter) const;

  ServeSettings settings_;
  AgentManager manager_;
  std::uint64_t answered_ = 0;
  std::unique_ptr<Node> node_, sayNode_, loaderNode_;
  TypedPublisher<tf2_msgs::TFMessage> transforms_;
  TypedPublisher<visualization_msgs::MarkerArray> forces_;
  TypedPublisher<hunav_msgs::Agents> humans_;
  TypedPublisher<hunav_msgs::Agent> robot_;
  std::optional<TypedPublisher<people_msgs::People>> people_;
  TypedPublisher<std_msgs::String> sayings_;
};

}  // namespace bridge
