#pragma once

#include <string>
#include <vector>

#include "app/run/Bundle.h"
#include "app/run/Experiment.h"
#include "app/run/PlannerFiles.h"

namespace app {

/// Code of others that runs in a scenario would start: with the first values, which it has, and
/// with each other value beside them.
std::vector<ForeignCode> foreignCodeOf(const Experiment& experiment, const sim2d::Scenario& first);

/// Files that the runs of one scenario read, or start as code of others: with the first values, and
/// with each other value beside them. `scenario`: its number; `first`: its first run; `files`: what
/// that was read from.
std::vector<std::string> filesOf(const Experiment& experiment, std::size_t scenario,
                                 const Bundle& first, KnownFiles& files);

}  // namespace app
