#include "sim2d/world/PersonGoals.h"

#include <algorithm>
#include <optional>

#include "sim2d/base/Text.h"

namespace sim2d {
namespace {

constexpr double kLeftDistance = 0.5;  // [m] outside the radius: the goal was left

/// Index of the next goal with this id after `last`, in the person's written goals.
std::optional<std::size_t> indexAfter(const std::vector<int>& goals, int id, std::size_t last,
                                      bool hasLast) {
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const std::size_t index = (i + (hasLast ? last + 1 : 0)) % goals.size();
    if (goals[index] == id) {
      return index;
    }
  }
  return std::nullopt;
}

}  // namespace

void PersonGoals::afterDecide(const WorldModel& model, WorldState& state, Intents& intents,
                              const WorldView& view) {
  for (const Event& event : intents.events()) {
    const int index = event.hasId ? view.indexOf(event.id) : -1;
    const auto human = static_cast<std::size_t>(index);
    if (index >= 0 && event.kind == EventKind::Goal) {
      recordReached(model, state, human, static_cast<int>(base::parseInt(event.text).value_or(0)));
    }
    if (index >= 0 && event.kind == EventKind::Arrived) {
      arrived_.push_back(human);
    }
  }
  for (std::size_t human = 0; human < people_.size(); ++human) {
    Intent& intent = intents.of(static_cast<int>(human));
    const bool waits = state.time < people_[human].waitingUntil - kTimeTolerance;
    if (state.present[human] != 0 && waits && intent.motion == Motion::Walk &&
        intent.targetIsGoal) {
      intent.motion = Motion::Stand;
    }
  }
}

void PersonGoals::afterMotion(const WorldModel& model, WorldState& state, const Intents& intents) {
  for (std::size_t human = 0; human < people_.size(); ++human) {
    const Intent& intent = intents.of(static_cast<int>(human));
    std::vector<GoalItem>& goals = state.controls[human].goals;
    if (state.present[human] == 0 || intent.motion != Motion::Walk || !intent.targetIsGoal ||
        goals.empty()) {
      continue;
    }
    Progress& progress = people_[human];
    const GoalItem front = goals.front();
    const double distance = (front.position - state.position(human)).norm();
    const bool stayed =
        progress.lastReached != nullptr && *progress.lastReached == front &&
        model.people[human].constants.cyclicGoals &&
        std::count(goals.begin(), goals.end(), front) == static_cast<std::ptrdiff_t>(goals.size());
    if (stayed) {  // a cyclic list with a single goal at the person's position
      if (distance > front.radius + kLeftDistance) {
        progress.lastReached = nullptr;
      }
      continue;
    }
    if (distance > front.radius) {
      continue;
    }
    goals.erase(goals.begin());
    if (model.people[human].constants.cyclicGoals) {
      goals.push_back(front);
    }
    reach(model, state, human, front);
  }
}

void PersonGoals::reach(const WorldModel& model, WorldState& state, std::size_t human,
                        const GoalItem& goal) {
  const int personId = model.people[human].constants.id;
  people_[human].lastReached = std::make_unique<GoalItem>(goal);
  state.emit(EventKind::Goal, personId, goal.id > 0 ? std::to_string(goal.id) : "");
  recordReached(model, state, human, goal.id);
  if (state.controls[human].goals.empty()) {
    state.emit(EventKind::Arrived, personId);
    arrived_.push_back(human);
  }
}

void PersonGoals::recordReached(const WorldModel& model, const WorldState& state, std::size_t human,
                                int goalId) {
  const Person& person = model.people[human];
  Progress& progress = people_[human];
  const std::optional<std::size_t> index =
      indexAfter(person.plan->written, goalId, progress.lastIndex, progress.hasReached);
  if (!index) {
    return;
  }
  progress.lastIndex = static_cast<std::uint32_t>(*index);
  progress.hasReached = true;
  if (*index < person.constants.wait.size()) {
    progress.waitingUntil = state.time + person.constants.wait[*index];
  }
}

}  // namespace sim2d
