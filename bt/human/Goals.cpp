#include "bt/human/Goals.h"

#include <algorithm>

namespace bt {

using sim2d::GoalItem;

namespace {

constexpr double kSmallRadius = 0.1;  // [m]

}  // namespace

bool isGoalReached(HumanContext& context, int human) {
  const std::vector<GoalItem>& goals = context.control(human).goals;
  if (goals.empty()) {
    return false;
  }
  const double distance = (goals.front().position - context.view().pose(human).position).norm();
  return distance <= goals.front().radius + kGoalTolerance;
}

bool advanceGoal(HumanContext& context, int human) {
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

void addGoal(HumanContext& context, int human, GoalItem goal) {
  std::vector<GoalItem>& goals = context.control(human).goals;
  const double radius = context.view().constants(human).goalRadius;
  const bool isOriginal = context.isOriginal(9);
  goal.radius = radius > 0.0 && !isOriginal ? radius : kSmallRadius;
  const bool isFirst = human == context.self() && context.mind().isFirstTick;
  if (isFirst && !isOriginal && !context.mind().hasOwnGoals) {
    goals.clear();
    context.mind().hasOwnGoals = true;
  }
  const auto isThisPoint = [&goal](const GoalItem& other) {
    return other.id == goal.id && other.position == goal.position;
  };
  const bool isNew = std::none_of(goals.begin(), goals.end(), isThisPoint);
  if (isNew || isFirst || isOriginal) {
    goals.push_back(goal);
  }
}

SavedPerson savePerson(HumanContext& context, int human) {
  const sim2d::HumanControl& control = context.control(human);
  return {human, context.mindOf(human).visit, control.goals, control.group};
}

bool isStillThere(const HumanContext& context, const SavedPerson& saved) {
  return context.mindOf(saved.human).visit == saved.visit;
}

void restoreGoals(HumanContext& context, const SavedPerson& saved) {
  if (isStillThere(context, saved)) {
    context.control(saved.human).goals = saved.goals;
  }
}

void setGroup(HumanContext& context, int human, int group) {
  int& present = context.control(human).group;
  if (present != group) {
    present = group;
    context.emit(sim2d::EventKind::Group, human, std::to_string(group));
  }
}

}  // namespace bt
