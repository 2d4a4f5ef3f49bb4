#pragma once

#include <algorithm>
#include <cstdint>
#include <forward_list>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "bt/engine/NodeLibrary.h"
#include "sim2d/world/HumanBehavior.h"

namespace bt {

/// Index of a person in the world; a node port contains the id.
struct AgentIndex {
  int index;
  AgentIndex(int i) : index(i) {}         // NOLINT: implicit conversion intended
  operator int() const { return index; }  // NOLINT: implicit conversion intended
};

/// An utterance. Audible to others from the next step.
struct Utterance {
  std::int64_t serial = 0;  // from 1, chronological
  std::int64_t step = 0;
  int speaker = 0;  // person index
  std::string text;
};

/// The last utterance of each person; its size is bounded by the number of people.
class SpeechBus {
 public:
  /// Makes the utterances of the previous step audible.
  void beginStep() {
    std::vector<Utterance> said;
    said.swap(fresh_);
    for (Utterance& words : said) {
      forget(words.speaker);
      audible_.insert(audible_.begin(), std::move(words));
    }
  }
  void say(std::int64_t step, int speaker, std::string text) {
    fresh_.push_back({++count_, step, speaker, std::move(text)});
  }
  /// Call when a person enters the world.
  void forget(int speaker) {
    const auto isTheirs = [speaker](const Utterance& words) { return words.speaker == speaker; };
    audible_.erase(std::remove_if(audible_.begin(), audible_.end(), isTheirs), audible_.end());
    fresh_.erase(std::remove_if(fresh_.begin(), fresh_.end(), isTheirs), fresh_.end());
  }
  /// Audible utterances, latest first.
  const std::vector<Utterance>& audibleUtterances() const { return audible_; }

 private:
  std::vector<Utterance> audible_;
  std::vector<Utterance> fresh_;
  std::int64_t count_ = 0;
};

/// The interface of the leaves of people's trees to the program that runs them.

/// Who moves a person in this step, in ascending priority. Of equal priorities the first wins.
enum class MotionOwner : unsigned char { None, Own, Group };

/// Goals and group of a person before a node changed them.
struct SavedAgent {
  int human = -1;
  int visit = 0;  // AgentState::visit of that person at that time
  std::vector<sim2d::GoalItem> goals;
  int group = -1;
};

/// Position of one member of a formation.
struct FormationSpot {
  int human = -1;
  base::Vec2 position = base::Vec2::Zero();  // [m]
};

/// Data about other people that a node keeps while it runs; too large for its tree memory.
struct GroupNodeState {
  std::vector<SavedAgent> saved;
  std::vector<FormationSpot> spots;
  base::Vec2 centre = base::Vec2::Zero();  // centre of the formation [m]
};

/// A person's place in a queue at a point.
struct QueuePlace {
  int human = -1;
  base::Vec2 head = base::Vec2::Zero();  // start of the queue [m]
  std::int64_t number = 0;               // step in which the person joined; 0: not yet
  int node = -1;                         // tree node that holds the place
};

/// State of one person besides the tree.
struct AgentState {
  int visit = 0;  // how often the person has entered the world
  bool isFirstTick = true;
  bool hasOwnGoals = false;  // the tree has replaced the scenario's goals
  std::forward_list<std::pair<int, GroupNodeState>> groupNodeState;  // by tree node
  std::unique_ptr<QueuePlace> queue;
};

/// State of all people of a run that persists between steps.
struct CrowdState {
  std::vector<AgentState> agentStates;
  std::vector<int> groups;  // at the start of this step
  SpeechBus speech;
  std::vector<MotionOwner> motionOwners;   // in this step
  std::vector<char> changedGoals;          // in this step a tree removed a goal from the list
  std::set<std::string> reportedWarnings;  // warnings already issued
  base::Diagnostics pendingDiagnostics;    // not yet taken
};

/// One person's tick. Leaves read the frozen view and write intents. People are addressed by index.
class HumanContext {
 public:
  HumanContext(CrowdState& society, const sim2d::WorldView& view, sim2d::Intents& intents, int self)
      : society_(society), view_(view), intents_(intents), self_(self) {}

  const sim2d::WorldView& view() const { return view_; }
  sim2d::Intents& intents() { return intents_; }
  sim2d::HumanControl& control(int human) { return intents_.control(human); }
  int self() const { return self_; }  // person whose tree is ticked
  AgentState& agentState() { return society_.agentStates[static_cast<std::size_t>(self_)]; }
  const AgentState& agentStateOf(int human) const {
    return society_.agentStates[static_cast<std::size_t>(human)];
  }
  SpeechBus& speech() { return society_.speech; }
  bool hasQuirk(int quirk) const { return view_.compatibility().has(quirk); }
  int idOf(int human) const { return view_.constants(human).id; }

  /// The group at the start of the step, regardless of later changes by nodes.
  int groupOf(int human) const { return society_.groups[static_cast<std::size_t>(human)]; }

  /// The person with this id. Empty, with one warning, if no person has the id; empty also for
  /// people who are not in the world.
  std::optional<int> agentById(LeafContext& leaf, int id) {
    return toOptional(ifPresent(indexById(leaf, id)));
  }
  /// The same for an input port; a missing port makes the tree faulty.
  std::optional<int> person(LeafContext& leaf, int port) {
    return toOptional(ifPresent(indexAtPort(leaf, port)));
  }
  /// The same, but including people who are not in the world.
  std::optional<int> agentEvenIfAbsent(LeafContext& leaf, int port) {
    return toOptional(indexAtPort(leaf, port));
  }
  /// A global goal given by its port, otherwise by the two following ports as coordinates (older
  /// files). Empty, with one warning, for an unknown goal. Does not set the radius.
  std::optional<sim2d::GoalItem> place(LeafContext& leaf, int goalPort);
  /// Issues a warning once per run.
  void warn(const LeafContext& leaf, std::string_view code, base::ProblemValues values);

  /// Sets the person's motion for this step. Returns false if another mover has priority: motion
  /// from another person's tree or from a group node takes precedence.
  bool move(int human, const sim2d::Intent& intent, MotionOwner mover = MotionOwner::Own);
  /// Sets column `state` for a person who acts socially without being moved.
  void setActive(int human) { intents_.of(human).active = true; }
  void noteGoalChange(int human) { society_.changedGoals[static_cast<std::size_t>(human)] = 1; }

  /// Created empty; kept until dropGroupNodeState().
  GroupNodeState& groupNodeState(const LeafContext& leaf);
  void dropGroupNodeState(const LeafContext& leaf);

  /// `other`: the second person of the event; -1: none.
  void emit(sim2d::EventKind kind, int human, std::string text, int other = -1);

 private:
  // Plain indices, because nearly every leaf calls these and returning an optional is slower.
  static constexpr int kNoAgent = -1;
  int indexById(LeafContext& leaf, int id);
  int indexAtPort(LeafContext& leaf, int port);
  int ifPresent(int human) const {
    return human != kNoAgent && view_.isPresent(human) ? human : kNoAgent;
  }
  static std::optional<int> toOptional(int human) {
    return human != kNoAgent ? std::optional<int>(human) : std::nullopt;
  }

  CrowdState& society_;
  const sim2d::WorldView& view_;
  sim2d::Intents& intents_;
  int self_;
};

// Helpers shared by the nodes.
using base::NodeStatus;

inline HumanContext& humanOf(LeafContext& leaf) {
  return leaf.host<HumanContext>();
}

/// Status of a stateful action: SUCCESS after `duration` [s]; 0 or less means never.
inline NodeStatus successAfter(const LeafContext& leaf, std::int64_t startStep, double duration) {
  return duration > 0.0 && leaf.hasElapsed(startStep, duration) ? NodeStatus::Success
                                                                : NodeStatus::Running;
}

/// Status of a stateful condition that does not hold: RUNNING until `duration` [s], then FAILURE.
inline NodeStatus failureAfter(const LeafContext& leaf, std::int64_t startStep, double duration) {
  return leaf.hasElapsed(startStep, duration) ? NodeStatus::Failure : NodeStatus::Running;
}

/// Port parsing for people's nodes, and adapters that turn functions into leaves.

/// "2, 3": the leading number of each token, skipping empty tokens; empty if a token has no number.
std::optional<std::vector<int>> parseIds(const std::string& text);
/// "3;1;1": non-negative numbers with a finite, positive sum; empty otherwise.
std::optional<std::vector<double>> parseWeights(std::string_view text);
/// Whether the port takes one or more person ids.
bool isAgentPort(std::string_view name);

/// Manifests of HuNavSim's nodes and, marked `own`, of additional ones; see nodesOf(). Common ports
/// need no definition: agent_id, target_agent_id, time_step, duration of an action, goal_id
/// target_x target_y (a position) and non_main_agent_ids.
NodeCatalogue humanManifests(std::string_view text);

/// Reads a function argument from a port. Empty: the node fails. A missing port makes the tree
/// faulty.
template <class T>
std::optional<T> argument(LeafContext& leaf, int port) {
  return leaf.require<T>(port);
}
/// Replaces a port number: any person, index -1.
constexpr int kAnyAgent = -1;
template <>
inline std::optional<AgentIndex> argument(LeafContext& leaf, int port) {
  if (port == kAnyAgent) {
    return AgentIndex{-1};
  }
  const std::optional<int> index = humanOf(leaf).person(leaf, port);
  return index ? std::optional<AgentIndex>({*index}) : std::nullopt;
}
template <>
inline std::optional<sim2d::GoalItem> argument(LeafContext& leaf, int port) {
  return humanOf(leaf).place(leaf, port);
}

template <class Context>
Context& contextOf(LeafContext& leaf) {
  if constexpr (std::is_same_v<Context, HumanContext>) {
    return humanOf(leaf);
  } else if constexpr (std::is_same_v<Context, const sim2d::WorldView>) {
    return humanOf(leaf).view();
  } else {
    return leaf;
  }
}

template <class Context, class Result, class... Arguments, int... ports>
NodeStatus callWithPorts(LeafContext& leaf, Result (*function)(Context&, Arguments...),
                         std::integer_sequence<int, ports...>) {
  const std::tuple<std::optional<std::decay_t<Arguments>>...> arguments{
      argument<std::decay_t<Arguments>>(leaf, ports)...};
  const auto call = [&leaf, function](const auto&... given) {
    if (!(given && ...)) {
      return NodeStatus::Failure;
    }
    NodeStatus status = NodeStatus::Success;
    if constexpr (std::is_same_v<Result, bool>) {
      status = successIf(function(contextOf<Context>(leaf), *given...));
    } else if constexpr (std::is_same_v<Result, void>) {
      function(contextOf<Context>(leaf), *given...);
    } else {
      status = function(contextOf<Context>(leaf), *given...);
    }
    return status;
  };
  return std::apply(call, arguments);
}

/// A leaf that calls `function` with the values of these ports, read in this order. The function
/// also takes the HumanContext, its view or the LeafContext as its first parameter. It returns a
/// status, true for SUCCESS, or void (SUCCESS).
template <auto function, int... ports>
NodeStatus withPorts(LeafContext& leaf) {
  return callWithPorts(leaf, function, std::integer_sequence<int, ports...>());
}

/// Runs `step` in each tick while the person `human` of the memory is in the world.
template <class Memory, NodeStatus (*step)(LeafContext&, HumanContext&, Memory&)>
NodeStatus ifPresentThen(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  Memory& memory = leaf.memory<Memory>();
  return context.view().isPresent(memory.human) ? step(leaf, context, memory) : NodeStatus::Failure;
}

/// Sets the memory and returns RUNNING.
template <class Memory>
NodeStatus begin(LeafContext& leaf, const Memory& memory) {
  leaf.memory<Memory>() = memory;
  return NodeStatus::Running;
}

// Functions by which nodes change goals and groups of people

/// Tolerance added to a goal's radius [m].
constexpr double kGoalTolerance = 0.1;

/// Whether the front goal is within its radius + kGoalTolerance; false without goals.
bool isGoalReached(HumanContext& context, AgentIndex human);
/// Moves the front goal to the end of a cyclic list, or removes it from a one-way list. If the goal
/// was reached, emits the events `goal` and, for the last goal of a one-way list, `arrived`.
/// Returns false without goals.
bool advanceGoal(HumanContext& context, AgentIndex human);
/// Implements SetGoal. In the first tick of the person's own tree the new goals replace those of
/// the scenario; later goals are appended unless the list contains that point. The radius is the
/// person's.
void addGoal(HumanContext& context, AgentIndex human, sim2d::GoalItem goal);

/// The current goals and group.
SavedAgent saveAgent(HumanContext& context, int human);
/// Whether the person has not re-entered the world since; otherwise nothing is restored.
bool isStillThere(const HumanContext& context, const SavedAgent& saved);
void restoreGoals(HumanContext& context, const SavedAgent& saved);
/// Restores the goals of all people saved by the node and drops the saved data.
void restoreAllGoals(LeafContext& leaf);
/// Sets the group and emits the event `group` on a change.
void setGroup(HumanContext& context, AgentIndex human, int group);

/// The main person (port 0) and the others, in order, without duplicates. Empty if a person does
/// not exist or is absent (the node fails) or if the list is malformed (the tree is faulty).
using Members = std::vector<int>;
template <>
std::optional<Members> argument(LeafContext& leaf, int othersPort);

/// Positions on a circle of radius 0.5 m + 0.2 m for each member after the first, evenly spaced,
/// starting in the direction in which the first member looks. The closest pairs of person and
/// position are assigned first.
std::vector<FormationSpot> assignCirclePositions(const sim2d::WorldView& view,
                                                 const Members& members, const base::Vec2& centre);

}  // namespace bt
