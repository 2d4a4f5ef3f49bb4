#pragma once

#include "app/cli/Commands.h"

namespace app {

/// Exit codes of the program.
enum ExitCode { kFine = 0, kRunFailed = 1, kBadInput = 2, kWrongCommandLine = 64 };

/// What is done when no command is named. Returns the exit code.
using OpenWindow = int (*)(int argc, char** argv, const RunOptions& run,
                           const WindowOptions& options);

/// Reads the words and does what they say.
int runProgram(int argc, char** argv, OpenWindow openWindow);

}  // namespace app
