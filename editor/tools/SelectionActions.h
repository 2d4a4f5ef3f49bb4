#pragma once

#include "editor/document/ScenarioDocument.h"

namespace editor {

/// What menus and keys do with the selection; one command each.
void removeSelection(ScenarioDocument& document);
void duplicateSelection(ScenarioDocument& document);  // the copies are selected
void selectAll(ScenarioDocument& document);

}  // namespace editor
