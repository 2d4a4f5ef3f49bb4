#pragma once

#include <string>

#include "sim2d/scenario/ScenarioFile.h"

namespace sim2d {

/// For an editor, when readScenario gives nothing because the syntax breaks: the same diagnostics,
/// and what stands before that place. Never to be run or written over the file.
ScenarioReading readBeginning(const std::string& path);

}  // namespace sim2d
