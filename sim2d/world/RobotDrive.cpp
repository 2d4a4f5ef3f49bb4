#include "sim2d/world/RobotDrive.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "sim2d/nav/Motion.h"

namespace sim2d {
namespace {

/// People and the other robots, people first.
void findBodies(const FrozenWorld& world, std::size_t self, std::vector<TrackedBody>& bodies) {
  bodies.clear();
  for (std::size_t i = 0; i < world.state.present.size(); ++i) {
    if (world.state.present[i] != 0) {
      const ResolvedHuman& person = world.model.people[i].constants;
      bodies.push_back({person.id, BodyKind::Person, world.state.position(i),
                        world.state.velocity(i), world.state.heading[i], person.radius});
    }
  }
  for (std::size_t i = 0; i < world.state.robots.size(); ++i) {
    if (i != self) {
      const RobotState& other = world.state.robots[i];
      bodies.push_back({world.model.robots[i].id, BodyKind::Robot, other.pose.position,
                        other.velocity, other.pose.heading, reachOf(world.model.robots[i])});
    }
  }
}

bool drives(const ResolvedRobot& robot, const RobotState& state, double time) {
  return state.goal < robot.goals.size() && time >= robot.startTime - kTick;
}

}  // namespace

RobotDrive::RobotDrive(std::vector<std::shared_ptr<Planner>> planners,
                       const std::vector<ResolvedRobot>& robots)
    : planners_(std::move(planners)) {
  std::transform(robots.begin(), robots.end(), std::back_inserter(bodies_), bodyOf);
}

void RobotDrive::observe(const FrozenWorld& world, std::size_t robot) {
  const ResolvedRobot& constants = world.model.robots[robot];
  const RobotState& now = world.state.robots[robot];
  observation_.pose = now.pose;
  observation_.motion = {now.linear, now.omega, now.lateral};
  observation_.goal = constants.goals[now.goal];
  observation_.goalRadius = constants.goalRadius;
  observation_.time = world.state.time;
  observation_.dt = world.model.dt;
  findBodies(world, robot, observation_.bodies);
  observation_.obstacles = &world.obstacles;
  observation_.navigation = &world.navigation;
}

BodyTwist RobotDrive::ask(std::size_t robot, const std::string& name) {
  const base::Result<BodyTwist> wanted = planners_[robot]->command(observation_);
  if (wanted) {
    return *wanted;
  }
  failure_ = "robot '" + name + "': " + wanted.diagnostics().front().text();
  return {};
}

void RobotDrive::addSenses(std::size_t robot, bool isAsked) {
  if (senses_ == nullptr) {
    return;
  }
  RobotSenses& senses = (*senses_)[robot];
  senses.believed = observation_.pose;
  for (const TrackedBody& body : observation_.bodies) {
    senses.bodies.push_back(
        {body.id, body.kind == BodyKind::Robot, body.position, body.velocity, body.radius});
  }
  if (isAsked) {
    for (Candidate& way : planners_[robot]->candidates()) {
      senses.ways.push_back({std::move(way.points), way.cost, way.isChosen});
    }
  }
}

const std::vector<BodyTwist>& RobotDrive::command(const FrozenWorld& world, WorldState& state) {
  commands_.assign(state.robots.size(), BodyTwist{});
  const double dt = world.model.dt;
  senses_ =
      wantsSenses_ ? std::make_shared<std::vector<RobotSenses>>(state.robots.size()) : nullptr;
  for (std::size_t i = 0; i < state.robots.size(); ++i) {
    const ResolvedRobot& robot = world.model.robots[i];
    const RobotState& now = state.robots[i];
    BodyTwist wanted;
    if (const auto steered = steered_.find(i); steered != steered_.end()) {
      wanted = steered->second;
    } else if (drives(robot, now, state.time)) {
      observe(world, i);
      wanted = ask(i, robot.name);
      addSenses(i, true);
      if (planners_[i]->takeReplanned()) {
        state.emit(EventKind::Replan, robot.id);
      }
    }
    commands_[i] = reached(bodies_[i], {now.linear, now.omega, now.lateral}, wanted, dt);
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
  return isOnTheWay ? planners_[robot]->path() : std::vector<Vec2>{};
}

}  // namespace sim2d
