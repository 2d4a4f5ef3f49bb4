#pragma once

#include <map>
#include <optional>
#include <vector>

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// The routes of all people while they are planned, apart from the document until `push`.
class RoutePlan {
 public:
  explicit RoutePlan(const ScenarioDocument& document);

  const std::vector<EntityId>& people() const { return people_; }  // in file order
  const std::vector<int>& route(EntityId person) const { return rounds_.at(person).goals; }
  /// What all of them have; nothing when they differ.
  std::optional<std::vector<int>> commonRoute(const std::vector<EntityId>& people) const;
  std::optional<bool> commonRepeat(const std::vector<EntityId>& people) const;

  void setRoute(const std::vector<EntityId>& people, const std::vector<int>& goals);
  /// To the end of each route; a goal may stand in a route more than once.
  void append(const std::vector<EntityId>& people, const std::vector<int>& goals);
  void setRepeat(const std::vector<EntityId>& people, bool repeat);

  /// All of it as one command; waiting times stay with their goals.
  void push(ScenarioDocument& document) const;

 private:
  struct Round {
    std::vector<int> goals;
    bool repeat = true;
  };
  template <class T>
  std::optional<T> common(const std::vector<EntityId>& people, T Round::*part) const;

  std::vector<EntityId> people_;
  std::map<EntityId, Round> rounds_;
};

/// Other goals for a person: each goal that stays keeps its waiting time.
void setGoals(sim2d::Human& human, const std::vector<int>& goals);

}  // namespace editor
