#pragma once

#include <string>

#include "app/run/ResultRow.h"
#include "app/studies/RunPool.h"
#include "sim2d/scenario/Scenario.h"

namespace app {

/// The scenario of a run as one file: options, `--set` values and seed are part of it, entities
/// that are switched off and goals that no agent uses are not. Running the file without options
/// repeats the run. Files that it refers to stay where they are; paths are relative to `path`, the
/// place of the new file, and its name becomes the name of the scenario. Errors: the scenario of
/// the run cannot be read, or an option is invalid.
base::Result<sim2d::Scenario> standaloneScenario(const RunRequest& request, const std::string& path,
                                                 const sim2d::ImageLoader& loader);

/// Executes the run of a scenario file that may not exist yet, in a process of its own. `path`:
/// where the file will be; its folder must exist. `request`: the run that it repeats, for the
/// options that are not part of a scenario. Error: no process could be started.
base::Result<ResultRow> runOfScenarioText(const std::string& text, const std::string& path,
                                          const RunRequest& request,
                                          const sim2d::ImageLoader& loader);

/// Whether two runs have the same end and metrics, bit for bit.
bool areEqualRuns(const ResultRow& a, const ResultRow& b);

}  // namespace app
