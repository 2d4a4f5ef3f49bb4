#pragma once

#include <map>
#include <set>
#include <string>

#include "editor/document/Entity.h"

namespace editor {

/// Gives names and numbers that nothing in a scenario has, nor anything named before by the same
/// object.
class FreeNames {
 public:
  explicit FreeNames(const sim2d::Scenario& scenario);
  /// Name, and number of goals and people, where theirs are missing or taken.
  void give(Entity& value);
  std::string name(const std::string& stem);  // "agent1", "agent2" …
  bool isTaken(const std::string& name) const { return names_.count(name) > 0; }
  int nextGoal() const { return goals_.empty() ? 1 : *goals_.rbegin() + 1; }
  int nextHuman() const { return humans_.empty() ? 1 : *humans_.rbegin() + 1; }

 private:
  std::set<std::string> names_;
  std::map<std::string, int> next_;  // number to try for a stem; those below are taken
  std::set<int> goals_, humans_;
};

/// The name with the letters that files allow.
std::string allowedName(const Entity& entity);

}  // namespace editor
