#include "editor/document/Places.h"

#include <algorithm>

#include "editor/document/EditCommands.h"

namespace editor {

Places::Places(const sim2d::Scenario& scenario) {
  const auto count = [this](EntityKind kind, const auto& list) {
    for (const auto& value : list) {
      ++countOf(kind, value.listed);
    }
  };
  count(EntityKind::Human, scenario.humans);
  count(EntityKind::Robot, scenario.robots);
  count(EntityKind::Obstacle, scenario.obstacles);
  count(EntityKind::Door, scenario.doors);
  count(EntityKind::Area, scenario.areas);
  for (const sim2d::Human& human : scenario.humans) {
    if (human.listed) {
      people_.push_back(human.id);
    }
  }
  countOf(EntityKind::Goal, true) = static_cast<int>(scenario.goals.size());
}

int Places::ofNew(const Entity& value) {
  const auto* human = std::get_if<sim2d::Human>(&value);
  if (human != nullptr && human->listed) {
    people_.push_back(human->id);
  }
  return place(kindOf(value), isListed(value));
}

int Places::ofSwitched(const Entity& value) {
  --countOf(kindOf(value), !isListed(value));
  const int last = place(kindOf(value), isListed(value));
  const auto* human = std::get_if<sim2d::Human>(&value);
  return human == nullptr ? last : placeOfPerson(human->id, human->listed).value_or(last);
}

std::optional<int> Places::placeOfPerson(int number, bool listed) {
  if (!listed) {
    people_.erase(std::remove(people_.begin(), people_.end(), number), people_.end());
    return std::nullopt;
  }
  const auto next =
      std::find_if(people_.begin(), people_.end(), [number](int each) { return each > number; });
  const auto index = static_cast<int>(next - people_.begin());
  people_.insert(next, number);
  return index;
}

int Places::place(EntityKind kind, bool listed) {
  const int before = countOf(kind, true) + (listed ? 0 : countOf(kind, false));
  ++countOf(kind, listed);
  return before;
}

}  // namespace editor
