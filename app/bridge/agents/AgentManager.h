#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "app/bridge/agents/StepTopics.h"
#include "app/bridge/messages/HunavServices.h"
#include "app/run/Bundle.h"
#include "sim2d/world/CoupledWorld.h"

namespace bridge {

/// What HuNavSim's agent manager answers, from a request to its response; it knows nothing of DDS.
/// Clock, places and obstacles are the caller's; people decide and move as a scenario of ours says.
/// Each request is answered whatever is in it, with the states that came where nothing better is
/// known. With the compatibility `hunav2` and its models the numbers are those of the original's
/// call path, but that all people move from the state at the beginning of the step.
///
/// - The first request with agents makes their minds and answers with the states that came.
/// - dt is the difference of the stamps; 0 when time runs backwards or leaps by more than 10 s.
///   Steps above 0.1 s are cut into such, not with `hunav2`.
/// - `compute_agent` answers the state after the last step; with `hunav2` it ticks once more.
/// - `reset_agents` begins anew: minds, goals, clock; with `hunav2` it takes the places alone.
class AgentManager {
 public:
  explicit AgentManager(app::Bundle bundle);

  /// Everything wrong with the scenario; with errors among it nobody can be served. Works out what
  /// takes time before the first request.
  base::Diagnostics prepare();
  /// The scenario that is served; from prepare() on with its variation drawn (drawnScenario).
  const std::shared_ptr<const sim2d::Scenario>& scenario() const { return bundle_.scenario; }

  hunav_msgs::ComputeAgents::Response compute(const hunav_msgs::ComputeAgents::Request& request);
  hunav_msgs::MoveAgent::Response moveOne(const hunav_msgs::MoveAgent::Request& request);
  hunav_msgs::ComputeAgent::Response computeOne(const hunav_msgs::ComputeAgent::Request& request);
  hunav_msgs::ResetAgents::Response reset(const hunav_msgs::ResetAgents::Request& request);

  /// Of the last compute or moveOne; nothing in the first. Made here, so an answer need not wait
  /// for them.
  std::optional<StepTopics> takeTopics();
  /// "Agent 3 says: hello", of the last step.
  std::vector<std::string> takeSayings();
  /// What is worth telling, each cause once.
  base::Diagnostics takeRemarks();

 private:
  struct Stamped {
    std::int64_t last = 0;  // [ns]
    bool hasLast = false;
  };

  base::Result<std::unique_ptr<sim2d::CoupledWorld>> makeWorld(const hunav_msgs::Agents& agents);
  bool hunav2() const { return bundle_.settings.compatibility.hunav2(); }
  /// Takes the state; true: the world was there before.
  bool take(const hunav_msgs::Agents& agents, const hunav_msgs::Agent& robot);
  bool needWorld(const hunav_msgs::Agents& agents);
  std::vector<sim2d::CoupledPerson> usablePeople(const hunav_msgs::Agents& agents);
  std::optional<sim2d::CoupledRobot> usableRobot(const hunav_msgs::Agent& robot);
  void restartClocks(const hunav_msgs::Agents& agents);
  double sinceLast(Stamped& stamped, std::int64_t now);
  void step(double dt, std::optional<int> only);
  hunav_msgs::Agent answerTo(const hunav_msgs::Agent& asked) const;
  void tell(base::Severity severity, std::string_view code, base::ProblemValues values = {});

  app::Bundle bundle_;
  /// The setup of the world, so that a world of the same people can be created without checking the
  /// scenario and its trees again.
  struct Recipe {
    std::shared_ptr<const sim2d::Scenario> of;
    sim2d::WorldSetup setup;  // its people have not entered
  };
  std::optional<Recipe> recipe_;
  std::unique_ptr<sim2d::CoupledWorld> world_;   // null: before the first request with agents
  bool cannotBe_ = false;                        // the world; told
  Stamped clock_;                                // of steps of everybody
  std::map<int, Stamped> ownClocks_;             // of people in steps of their own, by id
  double lastDt_ = 0.0;                          // [s]
  std::map<int, hunav_msgs::Agent> lastAgents_;  // as they came last and could be used, by id
  std::optional<sim2d::CoupledRobot> lastRobot_;
  std::optional<hunav_msgs::ComputeAgents::Request> stepped_;  // the state before the last step
  std::vector<std::string> sayings_;
  base::Diagnostics remarks_;
  std::set<std::string> told_;
};

}  // namespace bridge
