#pragma once

#include <memory>
#include <string>

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateWords.h"
#include "app/run/OutputFolder.h"
#include "metrics/Report.h"
#include "sim2d/trace/RecordedPoints.h"
#include "sim2d/trace/Trace.h"

namespace app {

/// Null when it cannot be written to, or would lose something: told.
std::unique_ptr<OutputFolder> openEvaluation(const EvaluateOptions& options,
                                             const sim2d::TraceHeader& header,
                                             base::Diagnostics& problems);

/// What is known of the evaluation besides its results.
std::string manifestOf(const EvaluateOptions& options, const Invocation& given,
                       base::Diagnostics& warnings);

/// The record that was measured.
struct Measured {
  const sim2d::Trace& trace;
  const sim2d::RecordedPoints& points;  // from the source of the record
};

/// All files of the results.
base::Diagnostics writeEvaluation(const EvaluateOptions& options, const Measured& measured,
                                  const metrics::Evaluation& evaluation, OutputFolder& output,
                                  const Invocation& given);

}  // namespace app
