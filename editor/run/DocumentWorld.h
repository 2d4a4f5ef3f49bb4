#pragma once

#include "app/run/RunOptions.h"
#include "editor/document/ScenarioDocument.h"
#include "editor/run/SimulationRunner.h"

namespace editor {

using app::RunSettings;

/// A run of the document as it is now: copies of scenario, map and trees. GUI thread. What a check
/// refuses does not run.
RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings = {});

}  // namespace editor
