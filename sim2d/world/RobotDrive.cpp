#include "sim2d/world/RobotDrive.h"

#include <algorithm>

namespace sim2d {
namespace {

/// People and the other robots, people first.
void findBodies(const FrozenWorld& world, std::size_t self, std::vector<SeenBody>& bodies) {
  bodies.clear();
  for (std::size_t i = 0; i < world.state.present.size(); ++i) {
    if (world.state.present[i] != 0) {
      const ResolvedHuman& person = world.model.people[i].constants;
      bodies.push_back(
          {person.id, world.state.position(i), world.state.velocity(i), person.radius});
    }
  }
  for (std::size_t i = 0; i < world.state.robots.size(); ++i) {
    if (i != self) {
      const RobotState& other = world.state.robots[i];
      bodies.push_back({world.model.robots[i].id, other.pose.position, other.velocity,
                        reachOf(world.model.robots[i])});
    }
  }
}

bool drives(const ResolvedRobot& robot, const RobotState& state, double time) {
  return state.goal < robot.goals.size() && time >= robot.startTime - kTick;
}

double limited(double wanted, double now, double most, double mostChange) {
  return std::clamp(std::clamp(wanted, -most, most), now - mostChange, now + mostChange);
}

}  // namespace

const std::vector<base::Twist2>& RobotDrive::command(const FrozenWorld& world, WorldState& state) {
  commands_.assign(state.robots.size(), base::Twist2{});
  const double dt = world.model.dt;
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    const RobotState& now = state.robots[i];
    base::Twist2 wanted;
    if (const auto steered = steered_.find(i); steered != steered_.end()) {
      wanted = steered->second;
    } else if (drives(robot, now, state.time)) {
      Observation& observation = observation_;
      observation.pose = now.pose;
      observation.linear = now.linear;
      observation.angular = now.omega;
      observation.goal = robot.goals[now.goal];
      observation.goalRadius = robot.goalRadius;
      observation.bodyRadius = reachOf(robot);
      observation.time = state.time;
      observation.dt = dt;
      findBodies(world, i, observation.bodies);
      observation.obstacles = &world.obstacles;
      observation.navigation = &world.navigation;
      wanted = controllers_[i]->command(observation);
      if (controllers_[i]->takeReplanned()) {
        state.emit(EventKind::Replan, robot.id);
      }
    }
    commands_[i].linear = limited(wanted.linear, now.linear, robot.maxVel, robot.maxAcc * dt);
    commands_[i].angular = limited(wanted.angular, now.omega, robot.maxOmega, robot.maxAlpha * dt);
  }
  steered_.clear();
  return commands_;
}

void RobotDrive::afterMotion(const WorldModel& model, WorldState& state) {
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = model.robots[i];
    RobotState& now = state.robots[i];
    if (!drives(robot, now, state.time)) {
      continue;
    }
    if ((robot.goals[now.goal] - now.pose.position).norm() > robot.goalRadius) {
      continue;
    }
    const int goalId = robot.goalIds[now.goal];
    state.emit(EventKind::Goal, robot.id, goalId > 0 ? std::to_string(goalId) : "");
    ++now.goal;
    if (now.goal == robot.goals.size()) {
      now.arrivedAt = state.time;
      state.emit(EventKind::Arrived, robot.id);
    }
  }
}

std::vector<Vec2> RobotDrive::path(std::size_t robot, const WorldModel& model,
                                   const WorldState& state) const {
  const bool isOnTheWay = drives(model.robots[robot], state.robots[robot], state.time);
  return isOnTheWay ? controllers_[robot]->path() : std::vector<Vec2>{};
}

}  // namespace sim2d
