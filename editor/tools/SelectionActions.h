#pragma once

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// What menus and keys do with the selection; one command each.
void removeSelection(ScenarioDocument& document);
void duplicateSelection(ScenarioDocument& document);  // the copies are selected
void selectAll(ScenarioDocument& document);

enum class Align { Left, CentreX, Right, Top, CentreY, Bottom };
enum class Distribute { Across, Up };  // equal gaps between outlines

/// Each is one command about the selection; nothing happens when there is too little of it.
void alignSelection(ScenarioDocument& document, Align how);
void distributeSelection(ScenarioDocument& document, Distribute how);
/// Turned about the middle of all of them [rad].
void rotateSelection(ScenarioDocument& document, double angle);

}  // namespace editor
