#pragma once

#include <map>
#include <set>
#include <string>

#include "editor/document/Entity.h"

namespace editor {

/// Generates names and numbers that are not used in a scenario and that the same object has not
/// generated before.
class UniqueNames {
 public:
  explicit UniqueNames(const sim2d::Scenario& scenario);
  /// Assigns a name, and a number to goals and people, where it is missing or taken.
  void assignTo(Entity& value);
  std::string name(const std::string& stem);  // "agent1", "agent2" …
  bool isTaken(const std::string& name) const { return names_.count(name) > 0; }
  int nextGoal() const { return goals_.empty() ? 1 : *goals_.rbegin() + 1; }
  int nextHuman() const { return humans_.empty() ? 1 : *humans_.rbegin() + 1; }

 private:
  std::set<std::string> names_;
  std::map<std::string, int> next_;  // The next number to try for a stem; lower ones are taken.
  std::set<int> goals_, humans_;
};

/// The name reduced to the characters that files allow.
std::string sanitizedName(const Entity& entity);

}  // namespace editor
