#pragma once

#include <functional>
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
class AgentServer {
 public:
  using ReportCallback = std::function<void(const base::Diagnostic&)>;

  /// `report` is called once for each distinct problem.
  static base::Result<std::unique_ptr<AgentServer>> create(app::Bundle bundle,
                                                           const ServeSettings& settings,
                                                           ReportCallback report);
  virtual ~AgentServer() = default;
  /// Answers pending requests; waits at most `atMost` for the first one.
  virtual void spin(Milliseconds atMost) = 0;
  virtual std::uint64_t answered() const = 0;  // number of requests answered
};

}  // namespace bridge
