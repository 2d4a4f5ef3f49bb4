#include "sim2d/world/StuckRobots.h"

#include "sim2d/map/PathPlanner.h"

namespace sim2d {
namespace {

constexpr double kStuckCheckInterval =
    0.1;  // [s]; planning a path costs more than a step of a few people

}  // namespace

StuckRobots::StuckRobots(const WorldModel& model) {
  if (model.stuckAfter > 0.0) {
    // The recovery is done by the robot's planner, so its distance is 0 here.
    robots_.resize(model.robots.size(),
                   {StuckDetector(model.stuckAfter - kTimeTolerance, 0.0), {}});
  }
}

void StuckRobots::update(const WorldModel& model, WorldState& state,
                         const NavigationMap& navigation, bool willDoorToggle) {
  if (robots_.empty() || state.time < nextCheck_ - kTimeTolerance) {
    return;
  }
  nextCheck_ = state.time + kStuckCheckInterval;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    const RobotState& now = state.robots[i];
    MonitoredRobot& watched = robots_[i];
    const std::optional<Vec2> current = currentGoal(robot, now);
    if (!current) {
      watched = {StuckDetector(model.stuckAfter - kTimeTolerance, 0.0),
                 {}};  // it may get another goal
      continue;
    }
    if (state.time < robot.startTime - kTimeTolerance) {
      continue;
    }
    const Vec2& place = now.pose.position;
    const Vec2& goal = *current;
    const std::vector<Vec2> way = navigation.plan(circumscribedRadius(robot), place, goal);
    if (way.empty() && willDoorToggle) {
      watched = {StuckDetector(model.stuckAfter - kTimeTolerance, 0.0), {}};
      continue;
    }
    // Without a path some planners drive up to the obstacle.
    watched.watch.update(state.time, place, goal,
                         way.empty() ? (goal - place).norm() : polylineLength(way));
    if (watched.watch.tries() == 0) {
      watched.since.reset();
    } else if (!watched.since) {
      watched.since = state.time;
      state.emit(EventKind::Stuck, robot.id);
    }
  }
}

std::optional<double> StuckRobots::stuckSince(std::size_t robot) const {
  return robots_.empty() ? std::nullopt : robots_[robot].since;
}

}  // namespace sim2d
