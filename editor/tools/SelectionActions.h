#pragma once

#include <QMimeData>

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// What menus and keys do with the selection; one command each.
void duplicateSelection(ScenarioDocument& document);  // the copies are selected
void selectAll(ScenarioDocument& document);

enum class Align { Left, CentreX, Right, Top, CentreY, Bottom };
enum class Distribute { Across, Up };  // equal gaps between outlines

/// Each is one command about the selection; nothing happens when there is too little of it.
void alignSelection(ScenarioDocument& document, Align how);
void distributeSelection(ScenarioDocument& document, Distribute how);
/// Turned about the middle of all of them [rad].
void rotateSelection(ScenarioDocument& document, double angle);

/// Copies go as text: a scenario in YAML with what was selected and the goals of the routes, so
/// that they can be pasted into another window, or read. Trees of one's own go beside it.
std::unique_ptr<QMimeData> copiedSelection(const ScenarioDocument& document);
bool canPaste(const QMimeData* data);
/// Adds what was copied, shifted by `delta`, and selects it: one command. Names and numbers that
/// are taken become free ones, routes and sources follow. A goal that was not selected itself and
/// is in the document already stays shared. False: no scenario, or an empty one.
bool paste(ScenarioDocument& document, const QMimeData& data, const Vec2& delta);

}  // namespace editor
