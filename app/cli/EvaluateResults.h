#pragma once

#include <memory>
#include <string>

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateOptions.h"
#include "app/run/OutputFolder.h"
#include "metrics/Report.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// Opens the output folder. Null if it is not writable or files would be lost; see `problems`.
std::unique_ptr<OutputFolder> openEvaluation(const EvaluateOptions& options,
                                             const sim2d::TraceHeader& header,
                                             base::Diagnostics& problems);

/// The manifest of the evaluation.
std::string manifestOf(const EvaluateOptions& options, const Invocation& given,
                       base::Diagnostics& warnings);

/// The evaluated recording.
struct Measured {
  const sim2d::Trace& trace;
  const sim2d::RecordedPoints& points;  // from the source of the recording
};

/// Writes all result files.
base::Diagnostics writeEvaluation(const EvaluateOptions& options, const Measured& measured,
                                  const metrics::Evaluation& evaluation, OutputFolder& output,
                                  const Invocation& given);

}  // namespace app
