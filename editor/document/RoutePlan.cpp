#include "editor/document/RoutePlan.h"

#include <algorithm>

#include "editor/document/EditCommands.h"

namespace editor {

void setGoals(sim2d::Human& human, const std::vector<int>& goals) {
  std::vector<double>& waits = human.ours.wait;
  if (waits.size() != human.goals.size()) {
    waits.clear();
  }
  if (!waits.empty()) {
    std::vector<int> before = human.goals;
    std::vector<double> kept;
    for (const int goal : goals) {
      const auto found = std::find(before.begin(), before.end(), goal);
      const bool known = goal > 0 && found != before.end();
      kept.push_back(known ? waits[static_cast<std::size_t>(found - before.begin())] : 0.0);
      if (known) {
        *found = 0;  // the next visit of the same goal has its own time
      }
    }
    waits = std::move(kept);
  }
  human.goals = goals;
}

RoutePlan::RoutePlan(const ScenarioDocument& document) {
  for (const sim2d::Human& human : document.scenario().humans) {
    people_.push_back(human.key);
    rounds_[human.key] = {human.goals, human.cyclicGoals.value_or(true)};
  }
}

std::optional<std::vector<int>> RoutePlan::commonRoute(const std::vector<EntityId>& people) const {
  return common(people, &Round::goals);
}

std::optional<bool> RoutePlan::commonRepeat(const std::vector<EntityId>& people) const {
  return common(people, &Round::repeat);
}

template <class T>
std::optional<T> RoutePlan::common(const std::vector<EntityId>& people, T Round::*part) const {
  const bool same = std::all_of(people.begin(), people.end(), [&](EntityId person) {
    return rounds_.at(person).*part == rounds_.at(people.front()).*part;
  });
  return same && !people.empty() ? std::optional<T>(rounds_.at(people.front()).*part)
                                 : std::nullopt;
}

void RoutePlan::setRoute(const std::vector<EntityId>& people, const std::vector<int>& goals) {
  for (const EntityId person : people) {
    rounds_.at(person).goals = goals;
  }
}

void RoutePlan::append(const std::vector<EntityId>& people, const std::vector<int>& goals) {
  for (const EntityId person : people) {
    std::vector<int>& route = rounds_.at(person).goals;
    route.insert(route.end(), goals.begin(), goals.end());
  }
}

void RoutePlan::setRepeat(const std::vector<EntityId>& people, bool repeat) {
  for (const EntityId person : people) {
    rounds_.at(person).repeat = repeat;
  }
}

void RoutePlan::push(ScenarioDocument& document) const {
  std::vector<Entity> edited;
  for (const EntityId person : people_) {
    const sim2d::Human* before = document.human(person);
    if (before == nullptr) {
      continue;
    }
    sim2d::Human after = *before;
    const Round& round = rounds_.at(person);
    if (round.goals != after.goals) {
      setGoals(after, round.goals);
    }
    if (round.repeat != after.cyclicGoals.value_or(true)) {
      after.cyclicGoals = round.repeat;
    }
    if (!(after == *before)) {
      edited.emplace_back(std::move(after));
    }
  }
  const QString text = edited.size() == 1
                           ? QObject::tr("Assign goals to %1").arg(displayName(edited.front()))
                           : QObject::tr("Assign goals to %1 people").arg(edited.size());
  pushEdit(document, std::move(edited), text);
}

}  // namespace editor
