#pragma once

#include <string>
#include <vector>

#include "app/run/Batch.h"
#include "app/run/Bundle.h"
#include "metrics/PlanningTime.h"
#include "sim2d/trace/Trace.h"
#include "sim2d/world/Runner.h"

namespace app {

/// manifest.json of a run: what it came from, what it was set to, how it ended.
std::string runManifest(const Bundle& bundle, const sim2d::TraceHeader& header,
                        const sim2d::RunResult& result, const metrics::PlanningTime& planning,
                        const std::vector<std::string>& commandLine);

/// manifest.json of a batch; nothing of it depends on the number of jobs or the clock.
std::string batchManifest(const Experiment& experiment, const BatchRows& rows);

/// Makes the folder; an error if it cannot be made or written to.
base::Diagnostics checkWritableFolder(const std::string& folder);

}  // namespace app
