#pragma once

#include "app/cli/CommandRegistry.h"
#include "app/cli/EvaluateWords.h"

namespace app {

/// Listens to a running system of ROS 2 and measures what it tells of people and a robot: one
/// recording, from now until Ctrl-C, the end of its time or hunav_stop_recording; or as many as the
/// services begin and end, each in a folder of its own. What was recorded stays even where it
/// cannot be measured.
int evaluateLive(const EvaluateOptions& options, const Invocation& given);

}  // namespace app
