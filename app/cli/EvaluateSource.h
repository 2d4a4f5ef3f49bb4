#pragma once

#include <string>

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateOptions.h"
#include "app/run/MetricsSetup.h"
#include "app/run/OutputFolder.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// Reads the source with its additional inputs, evaluates it, writes and prints the results. Throws
/// CommandEnd on errors.
void evaluateSource(const EvaluateOptions& options, const Invocation& given);

/// Evaluates a bag that was recorded in the staging folder of `output`.
void evaluateRecording(const EvaluateOptions& options, OutputFolder& output,
                       const Invocation& given);

/// Inputs of the selected metrics that a third-party recording does not contain: one warning for
/// each missing input, with the keys of the metrics that need it. Empty for a run of hunavsim.
base::Diagnostics missingInputs(const sim2d::Trace& trace, const sim2d::RecordedPoints& points,
                                const MetricsSetup& setup, const std::string& source);

}  // namespace app
