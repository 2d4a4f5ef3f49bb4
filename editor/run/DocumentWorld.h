#pragma once

#include "editor/document/ScenarioDocument.h"
#include "editor/run/SimulationRunner.h"
#include "sim2d/world/Compatibility.h"

namespace editor {

/// How runs of the window are computed, beside what the scenario says.
struct RunSettings {
  sim2d::Compatibility compatibility;
  int threads = 1;
  bool exact = false;
};

/// A run of the document as it is now: copies of scenario, map and trees. GUI thread. A document
/// that was read in part does not run.
RunRequest runRequestOf(const ScenarioDocument& document, const RunSettings& settings = {});

}  // namespace editor
