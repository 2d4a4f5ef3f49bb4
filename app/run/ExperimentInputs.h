#pragma once

#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/Experiment.h"
#include "app/run/PlannerFiles.h"

namespace app {

/// Code of others that runs in a scenario would start, whatever values of the experiment name it.
/// `first`: the scenario with the first values.
std::vector<ForeignCode> foreignCodeOf(const Experiment& experiment, const sim2d::Scenario& first);

/// Files that a run reads or, as code of others, starts.
std::vector<std::string> inputFilesOf(const Bundle& bundle);

}  // namespace app
