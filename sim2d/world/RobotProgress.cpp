#include "sim2d/world/RobotProgress.h"

#include "sim2d/map/PathPlanner.h"

namespace sim2d {
namespace {

constexpr double kBetweenWays = 0.1;  // [s]; a way costs more than a step of a few people

}  // namespace

RobotProgress::RobotProgress(const WorldModel& model) {
  if (model.stuckAfter > 0.0) {
    // It is the robot's planner that makes it move off: here it need not move to be watched on.
    robots_.resize(model.robots.size(), {StuckWatch(model.stuckAfter - kTick, 0.0), {}});
  }
}

void RobotProgress::update(const WorldModel& model, WorldState& state,
                           const NavigationMap& navigation, bool willDoorToggle) {
  if (robots_.empty() || state.time < nextLook_ - kTick) {
    return;
  }
  nextLook_ = state.time + kBetweenWays;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    const RobotState& now = state.robots[i];
    Watched& watched = robots_[i];
    const std::optional<Vec2> current = currentGoal(robot, now);
    if (!current) {
      watched = {StuckWatch(model.stuckAfter - kTick, 0.0), {}};  // it may get another one
      continue;
    }
    if (state.time < robot.startTime - kTick) {
      continue;
    }
    const Vec2& place = now.pose.position;
    const Vec2& goal = *current;
    const std::vector<Vec2> way = navigation.plan(reachOf(robot), place, goal);
    if (way.empty() && willDoorToggle) {
      watched = {StuckWatch(model.stuckAfter - kTick, 0.0), {}};
      continue;
    }
    // Without a way some planners drive up to what is in it.
    watched.watch.update(state.time, place, goal,
                         way.empty() ? (goal - place).norm() : lengthOfWay(way));
    if (watched.watch.tries() == 0) {
      watched.since.reset();
    } else if (!watched.since) {
      watched.since = state.time;
      state.emit(EventKind::Stuck, robot.id);
    }
  }
}

std::optional<double> RobotProgress::stuckSince(std::size_t robot) const {
  return robots_.empty() ? std::nullopt : robots_[robot].since;
}

}  // namespace sim2d
