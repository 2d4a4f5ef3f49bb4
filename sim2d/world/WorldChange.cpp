#include <tuple>
#include <utility>

#include "sim2d/world/WorldInside.h"

/// A world whose robots go on as those of another one.
namespace sim2d {
namespace {

/// What a planner is made of.
auto planning(const ResolvedRobot& robot) {
  return std::tie(robot.planner, robot.command, robot.plannerParameters, robot.plannerTexts,
                  robot.nav2Params, robot.nav2Tree, robot.nav2Distro, robot.nav2Values,
                  robot.nav2Topics, robot.maxVel, robot.maxAcc, robot.maxOmega, robot.maxAlpha,
                  robot.maxReverse, robot.goalRadius);
}

auto destination(const ResolvedRobot& robot) {
  return std::tie(robot.goals, robot.goalIds);
}

}  // namespace

void RunningWorld::goOnAs(World& world, std::uint64_t seed) {
  auto& other = dynamic_cast<RunningWorld&>(world);
  for (std::size_t robot = 0; robot < model_.robots.size(); ++robot) {
    const ResolvedRobot was = std::exchange(model_.robots[robot], other.model_.robots[robot]);
    const ResolvedRobot& is = model_.robots[robot];
    if (planning(was) != planning(is)) {
      robots_.takePlanner(robot, other.robots_);
    }
    if (destination(was) != destination(is)) {
      state_.robots[robot].goal = 0;
      state_.robots[robot].order.reset();
      state_.robots[robot].arrivedAt = state_.robots[robot].endedAt = -1.0;
      state_.robots[robot].goalEnds.clear();
    }
  }
  if (model_.stuckAfter != other.model_.stuckAfter) {
    model_.stuckAfter = other.model_.stuckAfter;
    progress_ = RobotProgress(model_);
  }
  if (model_.drawSeed != seed) {
    model_.drawSeed = seed;
    robots_.reseed(seed);
  }
}

}  // namespace sim2d
