#include "sim2d/world/GoalEnding.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/trace/Arrival.h"

namespace sim2d {
namespace {

constexpr double kMillimetres = 1000.0;

GoalEnd goalEndOf(const ResolvedRobot& robot, const NavigationEnd& end, const RobotState& now,
                  double time) {
  const std::size_t left = robot.goals.size() - std::min(now.goal, robot.goals.size());
  GoalEnd over;
  over.result = end;
  over.time = time;
  over.isOrder = now.order.has_value();
  Vec2 goal = now.order.value_or(now.pose.position);
  if (!over.isOrder && left > 0) {
    const std::size_t last = now.goal + std::clamp(end.goals, std::size_t{1}, left) - 1;
    goal = robot.goals[last];
    over.goal = std::max(robot.goalIds[last], 0);
    over.number = static_cast<int>(last) + 1;
    over.isOneOfMany = robot.goals.size() > 1;
  }
  over.distance = (goal - now.pose.position).norm();
  over.isReached =
      end.hasSucceeded && over.distance <= robot.goalRadius + kReachedBeyondRadius + kTick;
  return over;
}

/// The order is over; more of them may come.
void endOrder(const ResolvedRobot& robot, bool isReached, RobotState& now, WorldState& state) {
  now.order.reset();
  if (!isReached) {
    now.endedAt = state.time;
    return;
  }
  now.arrivedAt = state.time;
  state.emit(EventKind::Goal, robot.id);
  state.emit(EventKind::Arrived, robot.id, kAtOrder);
}

void endGoalsOfList(const ResolvedRobot& robot, const GoalEnd& over, RobotState& now,
                    WorldState& state) {
  const std::size_t end = static_cast<std::size_t>(over.number);
  for (; now.goal < end; ++now.goal) {
    if (over.isReached) {
      emitGoal(robot, now.goal, state);
    }
  }
  if (now.goal < robot.goals.size()) {
    return;
  }
  if (std::all_of(now.goalEnds.begin(), now.goalEnds.end(),
                  [](const GoalEnd& each) { return each.isReached || each.isOrder; })) {
    now.arrivedAt = state.time;
    state.emit(EventKind::Arrived, robot.id);
  } else {
    now.endedAt = state.time;
  }
}

std::string distanceText(const GoalEnd& end) {
  const double rounded = std::round(end.distance * kMillimetres) / kMillimetres;
  return base::formatDouble(rounded) + " m from the goal";
}

}  // namespace

std::string goalEndText(const GoalEnd& end) {
  const std::string reason = goalEndReason(end);
  return end.result.hasSucceeded ? reason : reason + ", " + distanceText(end);
}

std::string goalEndReason(const GoalEnd& end) {
  std::string text;
  if (end.isOneOfMany) {
    text = "goal " + std::to_string(end.goal > 0 ? end.goal : end.number) + ": ";
  }
  return text + (end.result.hasSucceeded ? distanceText(end) : end.result.reason);
}

void emitGoal(const ResolvedRobot& robot, std::size_t goal, WorldState& state) {
  const int id = robot.goalIds[goal];
  state.emit(EventKind::Goal, robot.id, id > 0 ? std::to_string(id) : "");
}

void endGoals(const ResolvedRobot& robot, const NavigationEnd& end, RobotState& now,
              WorldState& state) {
  if (!currentGoal(robot, now)) {
    return;
  }
  const GoalEnd over = goalEndOf(robot, end, now, state.time);
  now.goalEnds.push_back(over);
  state.emit(end.hasSucceeded ? EventKind::NavigationSucceeded : EventKind::NavigationFailed,
             robot.id, goalEndText(over));
  if (over.isOrder) {
    endOrder(robot, over.isReached, now, state);
  } else {
    endGoalsOfList(robot, over, now, state);
  }
}

}  // namespace sim2d
