#pragma once

#include <string>

#include "app/run/MetricsSetup.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// Inputs of the selected metrics that the recording of another program does not contain: one
/// warning for each missing input, with the keys of the metrics that need it. None for a run of
/// hunavsim.
base::Diagnostics missingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                const MetricsSetup& setup, const std::string& source);

}  // namespace app
