#pragma once

#include "app/cli/CommandRegistry.h"
#include "app/run/BatchFolder.h"

namespace app {

/// Prints the final report of `batch` and `merge`; returns the exit code. `problems`: write errors.
int reportBatch(const BatchFolder& folder, const base::Diagnostics& problems,
                const Invocation& given);

}  // namespace app
