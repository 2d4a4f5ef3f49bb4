#pragma once

#include "editor/document/ScenarioDocument.h"

/// The edits behind the fixes; each pushes one command at most.
namespace editor {

/// A person's or robot's start, a robot's own goal point, or a goal (for the widest who visit it).
void moveToFreePlace(ScenarioDocument& document, EntityId id, bool robotGoal, const QString& text);
/// 1, 2, 3 … in the order of the list, those that are switched off last.
void renumberPeople(ScenarioDocument& document, const QString& text);
/// 1, 2, 3 … in the order of the numbers; routes follow.
void renumberGoals(ScenarioDocument& document, const QString& text);
/// Takes a goal out of the route of a person or robot.
void dropGoal(ScenarioDocument& document, EntityId id, int goal, const QString& text);
/// A name that is allowed and free.
void giveFreeName(ScenarioDocument& document, EntityId id, const QString& text);
/// A robot in a free place near the people, its goal on their other side.
void addRobot(ScenarioDocument& document);

}  // namespace editor
