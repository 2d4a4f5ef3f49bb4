#include "editor/document/Places.h"

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
  countOf(EntityKind::Goal, true) = static_cast<int>(scenario.goals.size());
}

int Places::ofNew(const Entity& value) {
  return place(kindOf(value), isListed(value));
}

int Places::ofSwitched(const Entity& value) {
  --countOf(kindOf(value), !isListed(value));
  return place(kindOf(value), isListed(value));
}

int Places::place(EntityKind kind, bool listed) {
  const int before = countOf(kind, true) + (listed ? 0 : countOf(kind, false));
  ++countOf(kind, listed);
  return before;
}

}  // namespace editor
