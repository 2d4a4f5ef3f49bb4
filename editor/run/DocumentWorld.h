#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

/// A run of the document as it is now: copies of scenario, map and trees. GUI thread.
RunRequest runRequestOf(const ScenarioDocument& document);

}  // namespace editor
