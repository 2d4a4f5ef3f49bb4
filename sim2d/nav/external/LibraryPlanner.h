#pragma once

#include <memory>
#include <string>

#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/CodePermission.h"

namespace sim2d {

/// A planner in a shared library (hunavsim_planner.h). `file`: as dlopen takes it; without a slash
/// it is looked for in the system's folders of libraries. Errors, which name the robot:
/// library.not-allowed, .no-file, .not-loaded, .no-symbol (each one), .other-version, .refused; of
/// `command()`: library.failed, .no-number.
base::Result<std::shared_ptr<Planner>> makeLibraryPlanner(const PlannerSetup& setup,
                                                          const std::string& file,
                                                          CodePermission permission);

}  // namespace sim2d
