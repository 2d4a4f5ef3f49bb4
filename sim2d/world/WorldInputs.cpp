#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "sim2d/base/Text.h"
#include "sim2d/world/Placement.h"
#include "sim2d/world/WorldInside.h"

/// What inputs from outside do to the world.
namespace sim2d {
namespace {

bool isUsable(const Input& input) {
  const auto isSmall = [](const Vec2& value, double most) {
    return value.allFinite() && value.cwiseAbs().maxCoeff() <= most;
  };
  return isSmall(input.pose.position, base::kFarthest) && std::isfinite(input.pose.heading) &&
         isSmall(input.velocity, kFastest) && isSmall(input.desiredVelocity, kFastest) &&
         std::fabs(input.omega) <= kFastest;
}

/// `id` 0: the next free one. Numbers rise, as those of people from sources do.
std::string takeId(int& id, int& lastId) {
  if (id != 0 && id <= lastId) {
    return "the id " + std::to_string(id) + " was given before";
  }
  if (id == 0) {
    if (lastId == std::numeric_limits<int>::max()) {
      return "no id is left";
    }
    id = lastId + 1;
  }
  lastId = id;
  return {};
}

}  // namespace

void RunningWorld::take(const StepInputs& inputs) {
  steerings_.clear();
  taken_.clear();
  refused_.clear();
  newcomers_.clear();
  if (inputs.empty()) {
    return;
  }
  for (Input input : inputs) {
    const std::string problem =
        isUsable(input) ? take(input) : "a number is not finite or too large";
    if (problem.empty()) {
      taken_.push_back(std::move(input));
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

std::string RunningWorld::take(Input& input) {
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
    return putRobot(input);
  }
  if (input.kind == InputKind::Goal) {
    return orderRobot(input);
  }
  return input.kind == InputKind::Add ? addCopy(input) : takeForPerson(input);
}

/// Moves the place to the nearest one where the robot of the input fits. What is wrong with it.
std::string RunningWorld::placeRobot(Input& input) const {
  const auto robot = static_cast<std::size_t>(-1 - input.id);  // -1, -2 …
  if (robot >= model_.robots.size()) {
    return "there is no robot " + std::to_string(input.id);
  }
  const std::optional<Vec2> free =
      navigation_->nearestFit(robotReaches_[robot], input.pose.position);
  if (!free || (*free - input.pose.position).norm() > kPlaceReach) {
    return "there is no room for it within " + base::formatDouble(kPlaceReach) + " m";
  }
  input.pose = {*free, base::wrapToPi(input.pose.heading)};
  return {};
}

/// Somewhere else, at rest; it takes itself to be there.
std::string RunningWorld::putRobot(Input& input) {
  if (std::string refusal = placeRobot(input); !refusal.empty()) {
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

/// Without the heading, as goals have none.
std::string RunningWorld::orderRobot(Input& input) {
  if (std::string refusal = placeRobot(input); !refusal.empty()) {
    return refusal;
  }
  const auto robot = static_cast<std::size_t>(-1 - input.id);
  const ResolvedRobot& constants = model_.robots[robot];
  RobotState& now = state_.robots[robot];
  const bool isThere = (input.pose.position - now.pose.position).norm() <= constants.goalRadius;
  if (now.arrivedAt >= 0.0 && isThere) {
    return {};  // said again: it has arrived
  }
  now.order = input.pose.position;
  ++now.orders;
  now.goal = constants.goals.size();
  now.arrivedAt = now.endedAt = -1.0;
  return {};
}

std::string RunningWorld::takeForPerson(const Input& input) {
  const int human = view_.indexOf(input.id);
  if (human < 0 || !view_.isPresent(human)) {
    return "there is no person " + std::to_string(input.id) + " in the world";
  }
  const auto at = static_cast<std::size_t>(human);
  if (input.kind == InputKind::Entry) {
    return setEntry(human, input.name);
  }
  if (input.kind == InputKind::Stop || input.kind == InputKind::Resume) {
    state_.held[at] = input.kind == InputKind::Stop ? 1 : 0;
  } else if (input.kind == InputKind::Push) {
    steerings_.push_back({at, input.velocity, true});
  } else if (input.kind == InputKind::Set) {
    put(at, input.pose, input.velocity);
    steerings_.push_back({at, input.desiredVelocity, false});
  } else {
    put(at, input.pose, Vec2::Zero());
    motion_.forget(at);
  }
  return {};
}

/// Of "key=value".
std::string RunningWorld::setEntry(int human, const std::string& words) {
  const std::size_t equals = words.find('=');
  if (equals == std::string::npos || equals == 0) {
    return "an entry is 'key=value', not '" + words + "'";
  }
  return behavior_->setEntry(human, words.substr(0, equals), words.substr(equals + 1));
}

std::string RunningWorld::addCopy(Input& input) {
  const auto like =
      std::find_if(model_.people.begin(), model_.people.end(),
                   [&](const Person& person) { return person.constants.name == input.name; });
  if (like == model_.people.end()) {
    return "there is no person '" + input.name + "' to copy";
  }
  const double radius = like->constants.radius;
  const std::optional<Vec2> free = navigation_->nearestFit(radius, input.pose.position);
  if (!free || (*free - input.pose.position).norm() > kPlaceReach) {
    return "there is no room for them within " + base::formatDouble(kPlaceReach) + " m";
  }
  input.pose.position = *free;
  if (std::string refusal = takeId(input.id, model_.lastId); !refusal.empty()) {
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

/// Somewhere else; the body has the velocity when others look.
void RunningWorld::put(std::size_t human, const Pose2& pose, const Vec2& velocity) {
  const Vec2 inside = model_.ring.inside(pose.position);
  state_.positions[human] = inside;
  state_.heading[human] = base::wrapToPi(pose.heading);
  state_.velocities[human] = velocity;
  physics_.place(bodyOf(human), {inside, state_.heading[human]});
}

}  // namespace sim2d
