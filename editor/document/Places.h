#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "editor/document/Entity.h"

namespace editor {

/// Where things land in their lists, one after the other: those that are switched off stand behind
/// the others, as in the file. People who are switched on come back before those of higher numbers.
class Places {
 public:
  explicit Places(const sim2d::Scenario& scenario);
  int ofNew(const Entity& value);
  /// Of one that has been switched on or off, in a list without it.
  int ofSwitched(const Entity& value);

 private:
  int& countOf(EntityKind kind, bool listed) { return counts_[{kind, listed}]; }
  int place(EntityKind kind, bool listed);

  std::optional<int> placeOfPerson(int number, bool listed);

  std::map<std::pair<EntityKind, bool>, int> counts_;
  std::vector<int> people_;  // numbers of those who take part, in their order
};

}  // namespace editor
