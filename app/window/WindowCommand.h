#pragma once

#include "app/cli/Commands.h"

namespace app {

/// Opens the window, on the scenario if one is given. Returns the exit code.
int windowCommand(int argc, char** argv, const RunOptions& run, const WindowOptions& options);

}  // namespace app
