#pragma once

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateWords.h"
#include "app/run/OutputFolder.h"

namespace app {

/// Reads the source and all that goes with it, measures it, writes the results and tells them. Ends
/// the command (CommandEnd) with what is wrong.
void evaluateSource(const EvaluateOptions& options, const Invocation& given);

/// The same of a bag that was made in the staging folder of this output.
void evaluateRecording(const EvaluateOptions& options, OutputFolder& output,
                       const Invocation& given);

}  // namespace app
