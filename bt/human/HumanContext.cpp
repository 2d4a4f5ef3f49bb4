#include "bt/human/HumanContext.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <utility>

#include "bt/tree/NodeCatalogue.h"
#include "sim2d/base/Text.h"

namespace bt {

using base::Vec2;
using sim2d::EventKind;
using sim2d::GoalItem;
using sim2d::Intent;

int HumanContext::indexById(LeafContext& leaf, int id) {
  const int human = id == idOf(self_) ? self_ : view_.indexOf(id);
  if (human == kNoAgent) {
    warn(leaf, "tree.runs-without-person", {id});
  }
  return human;
}

int HumanContext::indexAtPort(LeafContext& leaf, int port) {
  const int id = leaf.require<int>(port);  // 0 if missing
  return id != 0 || leaf.get<int>(port) ? indexById(leaf, id) : kNoAgent;
}

GroupNodeState& HumanContext::groupNodeState(const LeafContext& leaf) {
  for (auto& [node, groupNodeState] : agentState().groupNodeState) {
    if (node == leaf.node()) {
      return groupNodeState;
    }
  }
  return agentState().groupNodeState.emplace_front(leaf.node(), GroupNodeState{}).second;
}

void HumanContext::dropGroupNodeState(const LeafContext& leaf) {
  agentState().groupNodeState.remove_if(
      [&leaf](const auto& entry) { return entry.first == leaf.node(); });
}

std::optional<GoalItem> HumanContext::place(LeafContext& leaf, int goalPort) {
  GoalItem item;
  if (leaf.state(goalPort) == PortState::Missing && leaf.state(goalPort + 1) == PortState::Given) {
    item.position.x() = leaf.require<double>(goalPort + 1);
    item.position.y() = leaf.require<double>(goalPort + 2);
    return item;
  }
  const std::optional<int> id = leaf.get<int>(goalPort);
  if (!id) {
    leaf.require<int>(goalPort);
    return std::nullopt;
  }
  const std::optional<base::Vec2> position = view_.globalGoal(*id);
  if (!position) {
    warn(leaf, "tree.runs-without-goal", {*id});
    return std::nullopt;
  }
  item.id = *id;
  item.position = *position;
  return item;
}

void HumanContext::warn(const LeafContext& leaf, std::string_view code,
                        base::ProblemValues values) {
  base::Diagnostic trouble = base::withContext(view_.constants(self_).name + ": " + leaf.path(),
                                               base::warning(code, std::move(values)));
  if (society_.reportedWarnings.insert(trouble.message).second) {
    society_.pendingDiagnostics.push_back(std::move(trouble));
  }
}

bool HumanContext::move(int human, const Intent& intent, MotionOwner mover) {
  const MotionOwner rank = human == self_ ? mover : MotionOwner::Group;
  MotionOwner& present = society_.motionOwners[static_cast<std::size_t>(human)];
  if (rank <= present) {
    return false;
  }
  present = rank;
  const bool wasActive = intents_.of(human).active;
  intents_.of(human) = intent;
  // A node of the own tree that runs without moving keeps the active flag.
  intents_.of(human).active = intent.active || (wasActive && rank == MotionOwner::Own);
  return true;
}

void HumanContext::emit(EventKind kind, int human, std::string text, int other) {
  sim2d::Event event;
  event.kind = kind;
  event.id = idOf(human);
  event.text = std::move(text);
  if (other >= 0) {
    event.other = idOf(other);
    event.hasOther = true;
  }
  intents_.emit(std::move(event));
}

std::optional<std::vector<int>> parseIds(const std::string& text) {
  std::vector<int> ids;
  for (const std::string& part : base::split(text, ',')) {
    const std::string token = base::trimmed(part);
    if (token.empty()) {
      continue;
    }
    const std::optional<int> id = intFromText(token);
    if (!id) {
      return std::nullopt;
    }
    ids.push_back(*id);
  }
  return ids;
}

std::optional<std::vector<double>> parseWeights(std::string_view text) {
  std::vector<double> weights;
  double sum = 0.0;
  for (const std::string& token : base::split(text, ';')) {
    const std::optional<double> weight = base::parseDouble(base::trimmed(token));
    if (!weight || !(*weight >= 0.0)) {
      return std::nullopt;
    }
    weights.push_back(*weight);
    sum += *weight;
  }
  const bool isUsable = sum > 0.0 && std::isfinite(sum);
  return isUsable ? std::optional<std::vector<double>>(std::move(weights)) : std::nullopt;
}

bool isAgentPort(std::string_view name) {
  constexpr std::array<std::string_view, 6> kPorts = {"agent_id",      "target_agent_id",
                                                      "target_id",     "observer_id",
                                                      "main_agent_id", "non_main_agent_ids"};
  return std::find(kPorts.begin(), kPorts.end(), name) != kPorts.end();
}

NodeCatalogue humanManifests(std::string_view text) {
  static const std::string kCommonPorts = R"(
agent_id int needed suggest {id}|Id of the person.
target_agent_id int needed suggest 2|Id of the other person.
time_step seconds suggest {dt}|Time step in HuNavSim; this program uses the simulation's time step.
duration duration atMost 36000 default 0.0 suggest 5.0|Ends after this time; 0: unlimited.
goal_id int unless target_x target_y suggest 1|Id of the global goal.
target_x metres|x of a point, if no goal_id is given.
target_y metres|y of a point, if no goal_id is given.
non_main_agent_ids any|Ids of the other members, separated by commas.
)";
  return parseNodeCatalogue(kCommonPorts + std::string(text), NodeOrigin::HuNavSim);
}

namespace {

constexpr double kSmallRadius = 0.1;  // [m]

}  // namespace

bool isGoalReached(HumanContext& context, AgentIndex human) {
  const std::vector<GoalItem>& goals = context.control(human).goals;
  if (goals.empty()) {
    return false;
  }
  const double distance = (goals.front().position - context.view().pose(human).position).norm();
  return distance <= goals.front().radius + kGoalTolerance;
}

bool advanceGoal(HumanContext& context, AgentIndex human) {
  std::vector<GoalItem>& goals = context.control(human).goals;
  if (goals.empty()) {
    return false;
  }
  const bool isReached = isGoalReached(context, human);
  const GoalItem goal = goals.front();
  goals.erase(goals.begin());
  if (context.view().constants(human).cyclicGoals) {
    goals.push_back(goal);
  }
  context.noteGoalChange(human);
  if (isReached) {
    context.emit(sim2d::EventKind::Goal, human, goal.id == 0 ? "" : std::to_string(goal.id));
    if (goals.empty()) {
      context.emit(sim2d::EventKind::Arrived, human, {});
    }
  }
  return true;
}

void addGoal(HumanContext& context, AgentIndex human, GoalItem goal) {
  std::vector<GoalItem>& goals = context.control(human).goals;
  const double radius = context.view().constants(human).goalRadius;
  const bool hasQuirk = context.hasQuirk(9);
  goal.radius = radius > 0.0 && !hasQuirk ? radius : kSmallRadius;
  const bool isFirst = human == context.self() && context.agentState().isFirstTick;
  if (isFirst && !hasQuirk && !context.agentState().hasOwnGoals) {
    goals.clear();
    context.agentState().hasOwnGoals = true;
  }
  const auto isThisPoint = [&goal](const GoalItem& other) {
    return other.id == goal.id && other.position == goal.position;
  };
  const bool isNew = std::none_of(goals.begin(), goals.end(), isThisPoint);
  if (isNew || isFirst || hasQuirk) {
    goals.push_back(goal);
  }
}

SavedAgent saveAgent(HumanContext& context, int human) {
  const sim2d::HumanControl& control = context.control(human);
  return {human, context.agentStateOf(human).visit, control.goals, control.group};
}

bool isStillThere(const HumanContext& context, const SavedAgent& saved) {
  return context.agentStateOf(saved.human).visit == saved.visit;
}

void restoreGoals(HumanContext& context, const SavedAgent& saved) {
  if (isStillThere(context, saved)) {
    context.control(saved.human).goals = saved.goals;
  }
}

void restoreAllGoals(LeafContext& leaf) {
  HumanContext& context = humanOf(leaf);
  for (const SavedAgent& saved : context.groupNodeState(leaf).saved) {
    restoreGoals(context, saved);
  }
  context.dropGroupNodeState(leaf);
}

void setGroup(HumanContext& context, AgentIndex human, int group) {
  int& present = context.control(human).group;
  if (present != group) {
    present = group;
    context.emit(sim2d::EventKind::Group, human, std::to_string(group));
  }
}

template <>
std::optional<Members> argument(LeafContext& leaf, int othersPort) {
  HumanContext& context = humanOf(leaf);
  const std::optional<int> main = context.person(leaf, 0);
  const std::string text = leaf.text(othersPort).value_or("");
  const std::optional<std::vector<int>> ids = parseIds(text);
  if (!ids) {
    leaf.fault("non_main_agent_ids is not a list of ids: '" + text + "'");
    return std::nullopt;
  }
  if (!main) {
    return std::nullopt;
  }
  Members members = {*main};
  for (const int id : *ids) {
    const std::optional<int> member = context.agentById(leaf, id);
    if (!member) {
      return std::nullopt;
    }
    if (std::find(members.begin(), members.end(), *member) == members.end()) {
      members.push_back(*member);
    }
  }
  return members;
}

std::vector<FormationSpot> assignCirclePositions(const sim2d::WorldView& view,
                                                 const Members& members, const Vec2& centre) {
  struct Pairing {
    double distance;
    std::size_t member, place;
  };
  const std::size_t count = members.size();
  const double radius = 0.5 + 0.2 * static_cast<double>(count - 1);
  const double first = view.pose(members.front()).heading;
  std::vector<Vec2> places;
  std::vector<Pairing> pairings;
  for (std::size_t k = 0; k < count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    places.emplace_back(centre + radius * base::directionOf(first + 2.0 * base::kPi * share));
    for (std::size_t m = 0; m < count; ++m) {
      pairings.push_back({(places[k] - view.pose(members[m]).position).norm(), m, k});
    }
  }
  std::sort(pairings.begin(), pairings.end(), [](const Pairing& a, const Pairing& b) {
    return std::tie(a.distance, a.member, a.place) < std::tie(b.distance, b.member, b.place);
  });
  std::vector<FormationSpot> spots(count);
  std::vector<char> isTaken(count, 0);
  for (const Pairing& pairing : pairings) {
    FormationSpot& spot = spots[pairing.member];
    if (spot.human < 0 && !isTaken[pairing.place]) {
      spot = {members[pairing.member], places[pairing.place]};
      isTaken[pairing.place] = 1;
    }
  }
  return spots;
}

}  // namespace bt
