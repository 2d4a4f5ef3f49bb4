#include <algorithm>
#include <cmath>

#include "sim2d/world/WorldInside.h"

/// What inputs from outside do to the world.
namespace sim2d {
namespace {

bool isUsable(const Input& input) {
  const auto isSmall = [](const Vec2& value, double most) {
    return value.allFinite() && value.cwiseAbs().maxCoeff() <= most;
  };
  return isSmall(input.pose.position, kFarthest) && std::isfinite(input.pose.heading) &&
         isSmall(input.velocity, kFastest) && isSmall(input.desiredVelocity, kFastest) &&
         std::fabs(input.omega) <= kFastest;
}

}  // namespace

void World::State::take(const StepInputs& inputs) {
  steerings_.clear();
  taken_.clear();
  refused.clear();
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
      refused.push_back(base::error("world.refused-input", {inputKindName(input.kind), problem}));
    }
  }
  updateNavigation();
  grid.rebuild(state.x, state.y, state.present);
  for (const int human : newcomers_) {
    behavior->enter(human, view);
  }
}

std::string World::State::take(Input& input) {
  if (input.kind == InputKind::Robot) {
    const auto robot = std::find_if(model.robots.begin(), model.robots.end(),
                                    [&](const ResolvedRobot& each) { return each.id == input.id; });
    if (robot == model.robots.end()) {
      return "there is no robot " + std::to_string(input.id);
    }
    robots.steer(static_cast<std::size_t>(robot - model.robots.begin()),
                 {input.velocity.x(), input.omega});
    return {};
  }
  if (input.kind == InputKind::Open || input.kind == InputKind::Close) {
    const bool open = input.kind == InputKind::Open;
    const auto door = std::find_if(model.doors.begin(), model.doors.end(),
                                   [&](const Door* each) { return each->name == input.name; });
    if (door == model.doors.end()) {
      return "there is no door '" + input.name + "'";
    }
    const auto at = static_cast<std::size_t>(door - model.doors.begin());
    if ((state.doorOpen[at] != 0) != open) {
      setDoor(at, open);
    }
    return {};
  }
  return input.kind == InputKind::Add ? addCopy(input) : takeForPerson(input);
}

std::string World::State::takeForPerson(const Input& input) {
  const int human = view.indexOf(input.id);
  if (human < 0 || !view.isPresent(human)) {
    return "there is no person " + std::to_string(input.id) + " in the world";
  }
  const auto at = static_cast<std::size_t>(human);
  if (input.kind == InputKind::Push) {
    steerings_.push_back({at, input.velocity, true});
  } else if (input.kind == InputKind::Set) {
    put(at, input.pose, input.velocity);
    steerings_.push_back({at, input.desiredVelocity, false});
  } else {
    put(at, input.pose, Vec2::Zero());
    motion.forget(human);
  }
  return {};
}

/// `id` 0: the next free one. Numbers rise, as those of people from sources do.
std::string World::State::addCopy(Input& input) {
  const auto like =
      std::find_if(model.people.begin(), model.people.end(),
                   [&](const Person& person) { return person.constants.name == input.name; });
  if (like == model.people.end()) {
    return "there is no person '" + input.name + "' to copy";
  }
  if (input.id != 0 && input.id < model.nextId) {
    return "the id " + std::to_string(input.id) + " was given before";
  }
  input.id = std::max(input.id, model.nextId);
  model.nextId = input.id + 1;
  Person person = *like;
  if (person.copiedFrom < 0) {
    person.copiedFrom = static_cast<int>(like - model.people.begin());
  }
  person.constants.id = input.id;
  person.constants.name += "_" + std::to_string(input.id);
  person.constants.start = {input.pose.position, base::wrapToPi(input.pose.heading)};
  person.constants.startTime = state.time;
  model.people.push_back(std::move(person));
  state.append(model.people.back());
  state.present.back() = 1;
  newcomers_.push_back(static_cast<int>(model.people.size()) - 1);
  place({newcomers_.back()});
  return {};
}

/// Somewhere else; the body has the velocity when others look.
void World::State::put(std::size_t human, const Pose2& pose, const Vec2& velocity) {
  const Vec2 inside = model.ring.inside(pose.position);
  state.x[human] = inside.x();
  state.y[human] = inside.y();
  state.heading[human] = base::wrapToPi(pose.heading);
  state.vx[human] = velocity.x();
  state.vy[human] = velocity.y();
  physics.place(bodyOf(human), {inside, state.heading[human]});
}

}  // namespace sim2d
