#include "sim2d/world/CoupledWorld.h"

#include <algorithm>
#include <utility>

namespace sim2d {
namespace {

constexpr double kInfiniteMass = 1e12;     // [kg]; effectively infinite mass in impacts
constexpr double kMaxWallDistance = 50.0;  // [m]; wall forces vanish at this distance

Obstacles::Point pointAt(const Vec2& place, const Vec2& seenFrom) {
  Obstacles::Point point;
  point.position = place;
  point.distance = (place - seenFrom).norm();
  return point;
}

}  // namespace

base::Result<std::unique_ptr<CoupledWorld>> CoupledWorld::create(WorldSetup setup) {
  base::Result<std::unique_ptr<WorldParts>> parts = buildWorld(setup);
  if (!parts) {
    return parts.diagnostics();
  }
  return {std::unique_ptr<CoupledWorld>(
              new CoupledWorld(std::move(**parts), std::move(setup.behavior))),
          parts.diagnostics()};
}

CoupledWorld::CoupledWorld(WorldParts parts, std::unique_ptr<HumanBehavior> humanBehavior)
    : WorldBase(parts, std::move(humanBehavior)) {
  model_.robots.clear();
  model_.obstaclePoints = ObstaclePoints::Boundary;  // external points are given for both
  model_.ring = PeriodicCorridor{};
  const std::size_t count = model_.people.size();
  motion_.resize(count);
  goals_.resize(count);
  walls_.resize(count);
  entered_.resize(count, 0);
  motion_.setExternalWalls(&walls_);
}

void CoupledWorld::take(const std::vector<CoupledPerson>& people,
                        const std::optional<CoupledRobot>& robot) {
  std::fill(state_.present.begin(), state_.present.end(), char{0});
  takeRobot(robot);
  std::vector<std::size_t> newcomers;
  for (const CoupledPerson& person : people) {
    const int index = view_.indexOf(person.id);
    if (index < 0) {
      continue;
    }
    const std::size_t human = at(index);
    if (entered_[human] == 0) {
      entered_[human] = 1;
      newcomers.push_back(human);
    }
    put(human, person);
  }
  grid_.rebuild(state_.positions, state_.present);
  intents_.reset();
  for (const std::size_t human : newcomers) {
    const Person& person = model_.people[human];
    state_.active[human] = 0;
    state_.controls[human] = HumanControl{person.plan->goals, false, person.constants.groupId};
    motion_.enter(human);
    goals_.enter(human);
    behavior_->enter(static_cast<int>(human), view_);
  }
}

void CoupledWorld::put(std::size_t human, const CoupledPerson& person) {
  state_.present[human] = 1;
  state_.positions[human] = person.pose.position;
  state_.heading[human] = base::wrapToPi(person.pose.heading);
  state_.velocities[human] = person.velocity;
  state_.omega[human] = person.omega;
  walls_[human].clear();
  for (const Vec2& place : person.obstacles) {
    const Obstacles::Point point = pointAt(place, person.pose.position);
    if (point.distance < kMaxWallDistance) {  // rays without a hit end far away
      walls_[human].push_back(point);
    }
  }
}

void CoupledWorld::takeRobot(const std::optional<CoupledRobot>& robot) {
  if (!robot) {
    model_.robots.clear();
    state_.robots.clear();
    return;
  }
  if (model_.robots.empty()) {
    ResolvedRobot constants;
    constants.name = robot->name;
    constants.radius = robot->radius;
    model_.robots.push_back(std::move(constants));
    state_.robots.emplace_back();
  }
  RobotState& state = state_.robots.front();
  state.pose = {robot->pose.position, base::wrapToPi(robot->pose.heading)};
  state.velocity = robot->velocity;
  state.omega = robot->omega;
  state.linear = robot->velocity.dot(base::directionOf(state.pose.heading));
}

bool CoupledWorld::step(double dt, std::optional<int> only) {
  failure_.clear();
  state_.events.clear();
  view_.only.reset();
  if (only) {
    view_.only = view_.indexOf(*only);
  }
  model_.dt = dt;
  headingsBefore_ = state_.heading;
  grid_.rebuild(state_.positions, state_.present);
  intents_.reset();
  behavior_->decide(view_, intents_);
  goals_.afterDecide(model_, state_, intents_, view_);
  motion_.chooseDirections(frozen_, intents_, state_);
  motion_.compute(frozen_, intents_, state_, forces_);
  if (!isSound()) {
    return false;
  }
  moves_ = motion_.wanted();
  if (!model_.peoplePass) {
    keepBodiesApart(dt);
  }
  for (std::size_t human = 0; human < state_.present.size(); ++human) {
    if (moves(human)) {
      move(human, dt);
    }
  }
  ++state_.step;
  state_.time += only ? 0.0 : dt;
  goals_.afterMotion(model_, state_, intents_);
  goals_.takeArrived();
  return true;
}

bool CoupledWorld::isSound() {
  if (motion_.isSound()) {
    return true;
  }
  for (std::size_t human = 0; human < state_.present.size(); ++human) {
    if (moves(human) && !sim2d::isSound(motion_.wanted()[human])) {
      failure_ = "the velocity of '" + model_.people[human].constants.name +
                 "' is not finite or above 1000 m/s";
      return false;
    }
  }
  return true;
}

/// The robot's motion is not changed, since the other simulator owns it.
void CoupledWorld::keepBodiesApart(double dt) {
  const std::size_t people = state_.present.size();
  discs_.assign(people + state_.robots.size(), MovingDisc{});
  pairs_.clear();
  double reach = 0.0;  // two radii, plus the distance two people can cover towards each other
  for (std::size_t human = 0; human < people; ++human) {
    const ResolvedHuman& person = model_.people[human].constants;
    discs_[human] = {state_.position(human), moves_[human], person.radius, person.mass, nullptr};
    if (state_.present[human] != 0) {
      reach = std::max(reach, 2.0 * (person.radius + moves_[human].norm() * dt));
    }
  }
  for (std::size_t robot = 0; robot < state_.robots.size(); ++robot) {
    discs_[people + robot] = {state_.robots[robot].pose.position, state_.robots[robot].velocity,
                              model_.robots[robot].radius, kInfiniteMass, nullptr};
  }
  for (std::size_t human = 0; human < people; ++human) {
    if (state_.present[human] == 0) {
      continue;
    }
    grid_.forEachNear(state_.position(human), reach, [&](int other) {
      if (other > static_cast<int>(human)) {
        pairs_.push_back({static_cast<int>(human), other});
      }
    });
    for (std::size_t robot = 0; robot < state_.robots.size(); ++robot) {
      pairs_.push_back({static_cast<int>(human), static_cast<int>(people + robot)});
    }
  }
  keepApart(discs_, pairs_, dt);
  for (std::size_t human = 0; human < people; ++human) {
    moves_[human] = discs_[human].velocity;
  }
}

void CoupledWorld::move(std::size_t human, double dt) {
  const Vec2& velocity = moves_[human];
  const Intent& intent = intents_.of(static_cast<int>(human));
  const double before = headingsBefore_[human];
  state_.positions[human] += velocity * dt;
  state_.velocities[human] = velocity;
  if (isWalking(intent.motion)) {
    state_.heading[human] = turnedHeading(state_.heading[human], velocity, dt);
  }
  state_.omega[human] = base::angleDiff(state_.heading[human], before) / dt;
  state_.active[human] = intent.active ? 1 : 0;
  for (Obstacles::Point& point : walls_[human]) {
    point.distance = (point.position - state_.positions[human]).norm();
  }
}

}  // namespace sim2d
