#pragma once

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// Commands on the selection for menus and keys; each pushes one undo command.
void duplicateSelection(ScenarioDocument& document);  // Selects the copies.
void selectAll(ScenarioDocument& document);

enum class Align { Left, CentreX, Right, Top, CentreY, Bottom };
enum class Distribute { Across, Up };  // Equal gaps between the outlines.

/// Each pushes one command, or none if too few entities are selected.
void alignSelection(ScenarioDocument& document, Align how);
void distributeSelection(ScenarioDocument& document, Distribute how);
/// Rotates the selection about its common centre [rad].
void rotateSelection(ScenarioDocument& document, double angle);

/// Copies the selection as text: a scenario in YAML with the selected entities and the goals of
/// their routes, which can be pasted into another window or a text editor. Custom trees are stored
/// in a separate format.
std::unique_ptr<QMimeData> copiedSelection(const ScenarioDocument& document);
bool canPaste(const QMimeData* data);
/// Adds the copied entities, translated by `delta`, and selects them: one command. Taken names and
/// numbers are replaced by unused ones, and routes and sources are updated. A goal that was not
/// itself selected and already exists in the document stays shared. Returns false without a
/// scenario, or if it is empty.
bool paste(ScenarioDocument& document, const QMimeData& data, const Vec2& delta);
/// As `paste`, with the centre of the copied entities at `centre`; none: at their copied position.
/// If entities of the same kind are already there, all are moved on in steps of 0.5 m to the right
/// and down until they are free, so that a copy never hides its original.
bool pasteAt(ScenarioDocument& document, const QMimeData& data, const std::optional<Vec2>& centre);

}  // namespace editor
