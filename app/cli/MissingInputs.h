#pragma once

#include <string>

#include "app/run/MetricsSetup.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// What the selected metrics need and the recording of another program does not hold: one warning
/// for each missing thing, with the keys of the metrics that lack it. Nothing for a run of ours.
base::Diagnostics missingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                const MetricsSetup& setup, const std::string& source);

}  // namespace app
