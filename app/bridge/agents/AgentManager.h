#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/bridge/agents/AgentMessages.h"
#include "app/bridge/messages/hunav_msgs.h"
#include "app/run/Bundle.h"
#include "sim2d/world/CoupledWorld.h"

namespace bridge {

/// The loaded scenario adapted to the agents of a caller. The properties in the caller's first
/// request take precedence, as in HuNavSim: desired velocity, radius, group, goals, force factors.
/// The behavior trees come from the scenario, by agent id. An agent that is not in the scenario is
/// added with the properties in the message and the tree of its behavior, and is reported in
/// `remarks`. The result has no robots. Of the variation only reaction times apply; all other
/// values come from the caller.
sim2d::Scenario scenarioForCaller(const sim2d::Scenario& served, const hunav_msgs::Agents& agents,
                                  base::Diagnostics& remarks);

/// The scenario of a bundle with its key `variation` applied for its seed: starts, headings, speeds
/// and the order of goals are those of a run with that seed. Factors of reaction times have no key
/// and are drawn later (`onlyReactionTimes`). Start times are not used in the world of a caller.
/// Without variation the scenario is returned unchanged. Errors: no world can be created from it.
base::Result<std::shared_ptr<const sim2d::Scenario>> drawnScenario(const app::Bundle& bundle);

/// The variation without the values that requests contain and those that are already drawn.
sim2d::VariationSettings onlyReactionTimes(sim2d::VariationSettings variation);

/// HuNavSim's agent manager: computes the response to each service request; independent of DDS. The
/// caller provides clock, positions and obstacles; behavior trees and motion models follow the
/// loaded scenario. Every request is answered, with the received states where nothing better is
/// known. With compatibility `hunav2` and its models, the results equal those of the original's
/// call path, except that all agents move from the state at the beginning of the step.
///
/// - The first request with agents creates the behavior trees and returns the received states.
/// - dt is the difference of the stamps; 0 if time runs backwards or jumps by more than 10 s. Steps
/// above 0.1 s are divided, except with `hunav2`.
/// - `compute_agent` returns the state after the last step; with `hunav2` it ticks once more.
/// - `reset_agents` resets behavior trees, goals and clock; with `hunav2` only the positions.
class AgentManager {
 public:
  explicit AgentManager(app::Bundle bundle);

  /// Validates the scenario and does the slow preparations before the first request. With errors,
  /// no request can be served.
  base::Diagnostics prepare();
  /// The loaded scenario; after prepare() with its variation applied (drawnScenario).
  const std::shared_ptr<const sim2d::Scenario>& scenario() const { return bundle_.scenario; }

  hunav_msgs::ComputeAgents::Response compute(const hunav_msgs::ComputeAgents::Request& request);
  hunav_msgs::MoveAgent::Response moveOne(const hunav_msgs::MoveAgent::Request& request);
  hunav_msgs::ComputeAgent::Response computeOne(const hunav_msgs::ComputeAgent::Request& request);
  hunav_msgs::ResetAgents::Response reset(const hunav_msgs::ResetAgents::Request& request);

  /// The topics of the last compute or moveOne; nothing after the first one. They are created here,
  /// so that the response need not wait for them.
  std::optional<StepMessages> takeTopics();
  /// The utterances of the last step: "Agent 3 says: hello".
  std::vector<std::string> takeSayings();
  /// New warnings and errors, each cause once.
  base::Diagnostics takeWarnings();

 private:
  using LastStamp = std::optional<std::int64_t>;  // [ns]

  base::Result<std::unique_ptr<sim2d::CoupledWorld>> makeWorld(const hunav_msgs::Agents& agents);
  bool hunav2() const { return bundle_.settings.compatibility.hunav2(); }
  /// Applies the state of a request. True: the world existed before.
  bool take(const hunav_msgs::Agents& agents, const hunav_msgs::Agent& robot);
  bool ensureWorld(const hunav_msgs::Agents& agents);
  std::vector<sim2d::CoupledPerson> usablePeople(const hunav_msgs::Agents& agents);
  std::optional<sim2d::CoupledRobot> usableRobot(const hunav_msgs::Agent& robot);
  void restartClocks(const hunav_msgs::Agents& agents);
  double sinceLast(LastStamp& last, std::int64_t now);
  void step(double dt, std::optional<int> only);
  hunav_msgs::Agent responseTo(const hunav_msgs::Agent& asked) const;
  void warn(std::string_view code, base::ProblemValues values = {});
  void noteOnce(const base::Diagnostics& problems);

  app::Bundle bundle_;
  /// The setup of the world. A world with the same agents can be created from it without checking
  /// the scenario and its trees again.
  struct Recipe {
    std::shared_ptr<const sim2d::Scenario> of;
    sim2d::WorldSetup setup;  // its agents have not been spawned
  };
  std::optional<Recipe> recipe_;
  std::unique_ptr<sim2d::CoupledWorld> world_;   // null before the first request with agents
  bool hasWorldFailed_ = false;                  // creating the world failed; reported
  LastStamp clock_;                              // of steps of all agents
  std::map<int, LastStamp> agentClocks_;         // of agents that are stepped individually, by id
  double lastDt_ = 0.0;                          // [s]
  std::map<int, hunav_msgs::Agent> lastAgents_;  // last valid states, by id
  std::optional<sim2d::CoupledRobot> lastRobot_;
  std::optional<hunav_msgs::ComputeAgents::Request> stepped_;  // state before the last step
  std::vector<std::string> sayings_;
  base::Diagnostics warnings_;
  base::DiagnosticFilter reported_;
};

}  // namespace bridge
