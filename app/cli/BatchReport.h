#pragma once

#include "app/cli/CommandRegistry.h"
#include "app/run/BatchFolder.h"

namespace app {

/// What `batch` and `merge` say at their end; the exit code. `troubles`: what could not be written.
int reportBatch(const BatchFolder& folder, const base::Diagnostics& troubles,
                const Invocation& given);

}  // namespace app
