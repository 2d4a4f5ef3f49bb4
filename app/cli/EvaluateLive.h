#pragma once

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateOptions.h"

namespace app {

/// Records agents and a robot from a running ROS 2 system and evaluates them: one recording until
/// Ctrl-C, its time limit or hunav_stop_recording; or one per pair of service calls, each in its
/// own folder. A recording is kept even if it cannot be evaluated.
int evaluateLive(const EvaluateOptions& options, const Invocation& given);

}  // namespace app
