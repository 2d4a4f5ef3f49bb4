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
  std::string space = "/";         // namespace of the manager's node
  bool actsAsLoader = false;       // also hunav_loader: the scenario as parameters
  bool actsAsGenerator = false;    // also get_agents, which the world generator of a wrapper has
  bool publishesForces = true;
  bool publishesTransforms = true;
};

/// HuNavSim's nodes `hunav_agent_manager` and `agent_say_node`, in the place of the original, and
/// `hunav_loader` if wanted. One thread.
class AgentServer {
 public:
  using Tell = std::function<void(const base::Diagnostic&)>;

  /// `tell`: each problem as it is met, once.
  static base::Result<std::unique_ptr<AgentServer>> create(app::Bundle bundle,
                                                           const ServeSettings& settings,
                                                           Tell tell);
  virtual ~AgentServer() = default;
  /// Answers what has come, or comes within this time.
  virtual void spin(Milliseconds atMost) = 0;
  virtual std::uint64_t answered() const = 0;  // requests so far
};

}  // namespace bridge
