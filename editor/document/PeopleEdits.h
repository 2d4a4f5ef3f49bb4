#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace editor {

/// Adds the missing keys of a person's reaction with their effective values, because HuNavSim
/// requires these keys. Randomly sampled values remain unset.
void addMissingReactionKeys(const sim2d::Scenario& scenario, sim2d::Human& human);
/// Returns true if the values of the person are sampled (configuration normal or uniform).
bool isDrawn(const sim2d::Human& human);
/// The behaviour with the values that a run with that seed samples; its configuration is custom.
/// Unchanged if nothing is sampled.
sim2d::Behavior frozenBehavior(const sim2d::Scenario& scenario, const sim2d::Human& human,
                               long long seed);

/// By behaviour, or Look::CustomTree for a custom tree, also of a recorded run that is shown.
inline Look lookOfPerson(const ScenarioDocument& document, const sim2d::Human& human) {
  return document.hasCustomTree(human)
             ? Look::CustomTree
             : lookOf(human.behavior.type.value_or(sim2d::BehaviorType::Regular));
}

bool isInGroup(const sim2d::Human& human);
/// Members of each group in file order. People with group -1 are in none.
std::map<int, std::vector<EntityId>> groupsOf(const sim2d::Scenario& scenario);
/// "family", or "Group 3" if the group has no name.
QString groupName(const sim2d::Scenario& scenario, int group);
/// The colour of a group, the same in each list; neighbouring numbers get different colours.
QColor groupColor(int group, const Theme& theme);

/// Puts these people into a new group, also if they are in other groups. One command. Returns the
/// number of the group.
int pushGroup(ScenarioDocument& document, const std::vector<EntityId>& people);
/// Moves people to that group, -1 = no group. One command.
void pushJoinGroup(ScenarioDocument& document, const std::vector<EntityId>& people, int group);
/// Removes all members and the name of the group. One command.
void pushDissolveGroup(ScenarioDocument& document, int group);
/// Sets the name; an empty name removes it. One command.
void pushGroupName(ScenarioDocument& document, int group, const std::string& name);

/// The routes of all people during planning, separate from the document until `push`.
class RoutePlan {
 public:
  explicit RoutePlan(const ScenarioDocument& document);

  const std::vector<EntityId>& people() const { return people_; }  // In file order.
  const std::vector<int>& route(EntityId person) const { return plannedRoutes_.at(person).goals; }
  /// The common value of all of them; none if they differ.
  std::optional<std::vector<int>> commonRoute(const std::vector<EntityId>& people) const {
    return common(people, &PlannedRoute::goals);
  }
  std::optional<bool> commonRepeat(const std::vector<EntityId>& people) const {
    return common(people, &PlannedRoute::repeat);
  }

  void setRoute(const std::vector<EntityId>& people, const std::vector<int>& goals) {
    for (const EntityId person : people) {
      plannedRoutes_.at(person).goals = goals;
    }
  }
  /// Appends goals to each route. A goal may occur more than once.
  void append(const std::vector<EntityId>& people, const std::vector<int>& goals);
  void setRepeat(const std::vector<EntityId>& people, bool repeat) {
    for (const EntityId person : people) {
      plannedRoutes_.at(person).repeat = repeat;
    }
  }

  /// Pushes all routes as one command. Waiting times stay with their goals. Returns the people who
  /// have changed.
  std::vector<EntityId> push(ScenarioDocument& document) const;

 private:
  struct PlannedRoute {
    std::vector<int> goals;
    bool repeat = true;
  };
  template <class T>
  std::optional<T> common(const std::vector<EntityId>& people, T PlannedRoute::*part) const {
    const bool same = std::all_of(people.begin(), people.end(), [&](EntityId person) {
      return plannedRoutes_.at(person).*part == plannedRoutes_.at(people.front()).*part;
    });
    return same && !people.empty() ? std::optional<T>(plannedRoutes_.at(people.front()).*part)
                                   : std::nullopt;
  }

  std::vector<EntityId> people_;
  std::map<EntityId, PlannedRoute> plannedRoutes_;
};

/// Replaces the goals of a person. Each goal that stays keeps its waiting time.
void setGoals(sim2d::Human& human, const std::vector<int>& goals);

}  // namespace editor
