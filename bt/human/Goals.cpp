#include "bt/human/Goals.h"

#include <algorithm>
#include <tuple>

namespace bt {

using base::Vec2;
using sim2d::GoalItem;

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
