#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "sim2d/base/Text.h"
#include "sim2d/world/World.h"

/// Application of external inputs.
namespace sim2d {
namespace {

bool isUsable(const Input& input) {
  const auto isSmall = [](const Vec2& value, double most) {
    return value.allFinite() && value.cwiseAbs().maxCoeff() <= most;
  };
  return isSmall(input.pose.position, base::kMaxCoordinate) && std::isfinite(input.pose.heading) &&
         isSmall(input.velocity, kMaxPlausibleSpeed) &&
         isSmall(input.desiredVelocity, kMaxPlausibleSpeed) &&
         std::fabs(input.omega) <= kMaxPlausibleSpeed;
}

/// Assigns an id; `id` 0: the next free one. Ids increase, as those of people from sources do.
std::string assignId(int& id, int& lastId) {
  if (id != 0 && id <= lastId) {
    return "the id " + std::to_string(id) + " was already used";
  }
  if (id == 0) {
    if (lastId == std::numeric_limits<int>::max()) {
      return "no more ids are available";
    }
    id = lastId + 1;
  }
  lastId = id;
  return {};
}

}  // namespace

void World::take(const StepInputs& inputs) {
  velocityOverrides_.clear();
  acceptedInputs_.clear();
  refused_.clear();
  newcomers_.clear();
  if (inputs.empty()) {
    return;
  }
  for (Input input : inputs) {
    const std::string problem =
        isUsable(input) ? take(input) : "a number is not finite or too large";
    if (problem.empty()) {
      acceptedInputs_.push_back(std::move(input));
    } else {
      refused_.push_back(base::error("world.refused-input", {inputKindName(input.kind), problem}));
    }
  }
  updateNavigation();
  grid_.rebuild(state_.positions, state_.present);
  for (const std::size_t human : newcomers_) {
    behavior_->enter(static_cast<int>(human), view_);
  }
}

std::string World::take(Input& input) {
  if (input.kind == InputKind::Robot) {
    const auto robot = static_cast<std::size_t>(-1 - input.id);  // -1, -2 …
    if (robot >= model_.robots.size()) {
      return "there is no robot " + std::to_string(input.id);
    }
    robots_.steer(robot, {input.velocity.x(), input.omega, input.velocity.y()});
    return {};
  }
  if (input.kind == InputKind::Open || input.kind == InputKind::Close) {
    const bool open = input.kind == InputKind::Open;
    const auto door = std::find_if(model_.doors.begin(), model_.doors.end(),
                                   [&](const Door* each) { return each->name == input.name; });
    if (door == model_.doors.end()) {
      return "there is no door '" + input.name + "'";
    }
    const auto at = static_cast<std::size_t>(door - model_.doors.begin());
    if ((state_.doorOpen[at] != 0) != open) {
      setDoor(at, open);
    }
    return {};
  }
  if (input.kind == InputKind::Move && input.id < 0) {
    return teleportRobot(input);
  }
  if (input.kind == InputKind::Goal) {
    return setExternalGoal(input);
  }
  return input.kind == InputKind::Add ? spawnCopy(input) : applyToPerson(input);
}

/// Moves the place of the input to the nearest one where the robot fits. Returns the problem, or
/// empty.
std::string World::fitRobot(Input& input) const {
  const auto robot = static_cast<std::size_t>(-1 - input.id);  // -1, -2 …
  if (robot >= model_.robots.size()) {
    return "there is no robot " + std::to_string(input.id);
  }
  const std::optional<Vec2> free =
      navigation_->nearestFreePosition(robotRadii_[robot], input.pose.position);
  if (!free || (*free - input.pose.position).norm() > kMaxPlacementShift) {
    return "there is no free space for the robot within " + base::formatDouble(kMaxPlacementShift) +
           " m";
  }
  input.pose = {*free, base::wrapToPi(input.pose.heading)};
  return {};
}

/// Teleports a robot, at rest; its pose estimate becomes the true pose.
std::string World::teleportRobot(Input& input) {
  if (std::string refusal = fitRobot(input); !refusal.empty()) {
    return refusal;
  }
  const auto robot = static_cast<std::size_t>(-1 - input.id);
  RobotState& now = state_.robots[robot];
  now.pose = input.pose;
  now.velocity.setZero();
  now.linear = now.lateral = now.omega = 0.0;
  physics_.place(static_cast<int>(robot), now.pose);
  robots_.relocate(robot, now.pose);
  return {};
}

/// Ignores the heading, as goals have none.
std::string World::setExternalGoal(Input& input) {
  if (std::string refusal = fitRobot(input); !refusal.empty()) {
    return refusal;
  }
  const auto robot = static_cast<std::size_t>(-1 - input.id);
  const ResolvedRobot& constants = model_.robots[robot];
  RobotState& now = state_.robots[robot];
  const bool isThere = (input.pose.position - now.pose.position).norm() <= constants.goalRadius;
  if (now.arrivedAt >= 0.0 && isThere) {
    return {};  // repeated command: already there
  }
  now.externalGoal = input.pose.position;
  ++now.externalGoalCount;
  now.goal = constants.goals.size();
  now.arrivedAt = now.endTime = -1.0;
  return {};
}

std::string World::applyToPerson(const Input& input) {
  const int human = view_.indexOf(input.id);
  if (human < 0 || !view_.isPresent(human)) {
    return "there is no person " + std::to_string(input.id) + " in the world";
  }
  const auto at = static_cast<std::size_t>(human);
  if (input.kind == InputKind::Entry) {
    return setBlackboardEntry(human, input.name);
  }
  if (input.kind == InputKind::Stop || input.kind == InputKind::Resume) {
    state_.held[at] = input.kind == InputKind::Stop ? 1 : 0;
  } else if (input.kind == InputKind::Push) {
    velocityOverrides_.push_back({at, input.velocity, true});
  } else if (input.kind == InputKind::Set) {
    teleportPerson(at, input.pose, input.velocity);
    velocityOverrides_.push_back({at, input.desiredVelocity, false});
  } else {
    teleportPerson(at, input.pose, Vec2::Zero());
    motion_.forget(at);
  }
  return {};
}

/// `words` is "key=value".
std::string World::setBlackboardEntry(int human, const std::string& words) {
  const std::size_t equals = words.find('=');
  if (equals == std::string::npos || equals == 0) {
    return "an entry must be 'key=value', not '" + words + "'";
  }
  return behavior_->setBlackboardEntry(human, words.substr(0, equals), words.substr(equals + 1));
}

std::string World::spawnCopy(Input& input) {
  const auto like =
      std::find_if(model_.people.begin(), model_.people.end(),
                   [&](const Person& person) { return person.constants.name == input.name; });
  if (like == model_.people.end()) {
    return "there is no person '" + input.name + "' to copy";
  }
  const double radius = like->constants.radius;
  const std::optional<Vec2> free = navigation_->nearestFreePosition(radius, input.pose.position);
  if (!free || (*free - input.pose.position).norm() > kMaxPlacementShift) {
    return "there is no free space for the person within " +
           base::formatDouble(kMaxPlacementShift) + " m";
  }
  input.pose.position = *free;
  if (std::string refusal = assignId(input.id, model_.lastId); !refusal.empty()) {
    return refusal;
  }
  Person person = *like;
  if (person.copiedFrom < 0) {
    person.copiedFrom = static_cast<int>(like - model_.people.begin());
  }
  person.constants.id = input.id;
  person.constants.name += "_" + std::to_string(input.id);
  person.constants.start = {input.pose.position, base::wrapToPi(input.pose.heading)};
  person.constants.startTime = state_.time;
  model_.people.push_back(std::move(person));
  state_.append(model_.people.back());
  state_.present.back() = 1;
  newcomers_.push_back(model_.people.size() - 1);
  place({newcomers_.back()});
  return {};
}

/// Teleports a person; others see the body with `velocity`.
void World::teleportPerson(std::size_t human, const Pose2& pose, const Vec2& velocity) {
  const Vec2 inside = model_.ring.inside(pose.position);
  state_.positions[human] = inside;
  state_.heading[human] = base::wrapToPi(pose.heading);
  state_.velocities[human] = velocity;
  physics_.place(bodyOf(human), {inside, state_.heading[human]});
}

/// Replacement of robots by those of another world.
namespace {

/// The inputs of planner construction.
auto planningInputs(const ResolvedRobot& robot) {
  return std::tie(robot.planner, robot.command, robot.plannerParameters, robot.plannerTexts,
                  robot.nav2Params, robot.nav2Tree, robot.nav2Distro, robot.nav2Values,
                  robot.nav2Topics, robot.maxVel, robot.maxAcc, robot.maxOmega, robot.maxAlpha,
                  robot.maxReverse, robot.goalRadius);
}

auto goalList(const ResolvedRobot& robot) {
  return std::tie(robot.goals, robot.goalIds);
}

}  // namespace

void World::continueWith(World& other, std::uint64_t seed) {
  for (std::size_t robot = 0; robot < model_.robots.size(); ++robot) {
    const ResolvedRobot was = std::exchange(model_.robots[robot], other.model_.robots[robot]);
    const ResolvedRobot& is = model_.robots[robot];
    if (planningInputs(was) != planningInputs(is)) {
      robots_.replacePlanner(robot, other.robots_);
    }
    if (goalList(was) != goalList(is)) {
      state_.robots[robot].goal = 0;
      state_.robots[robot].externalGoal.reset();
      state_.robots[robot].arrivedAt = state_.robots[robot].endTime = -1.0;
      state_.robots[robot].goalResults.clear();
    }
  }
  if (model_.stuckAfter != other.model_.stuckAfter) {
    model_.stuckAfter = other.model_.stuckAfter;
    stuckRobots_ = StuckRobots(model_);
  }
  if (model_.drawSeed != seed) {
    model_.drawSeed = seed;
    robots_.reseed(seed);
  }
}

}  // namespace sim2d
