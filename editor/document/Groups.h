#pragma once

#include <map>
#include <vector>

#include "editor/document/ScenarioDocument.h"
#include "editor/look/Theme.h"

namespace editor {

/// By behaviour, or that of a tree of one's own.
inline Look lookOfPerson(const ScenarioDocument& document, const sim2d::Human& human) {
  return document.tree(human.key)
             ? Look::CustomTree
             : lookOf(human.behavior.type.value_or(sim2d::BehaviorType::Regular));
}

bool isInGroup(const sim2d::Human& human);
/// Members of each group, in file order; people with -1 are in none.
std::map<int, std::vector<EntityId>> groupsOf(const sim2d::Scenario& scenario);
/// "family", or "Group 3" when nobody named it.
QString groupName(const sim2d::Scenario& scenario, int group);
/// The same for a group in each list, and for none of two neighbours.
QColor groupColor(int group, const Theme& theme);

/// A new group of these people, also when they were in others. One command; its number.
int pushGroup(ScenarioDocument& document, const std::vector<EntityId>& people);
/// Into that group, -1 = alone. One command.
void pushJoin(ScenarioDocument& document, const std::vector<EntityId>& people, int group);
/// Nobody is in it any more, and its name goes. One command.
void pushDissolve(ScenarioDocument& document, int group);
/// An empty name takes it away. One command.
void pushGroupName(ScenarioDocument& document, int group, const std::string& name);

}  // namespace editor
