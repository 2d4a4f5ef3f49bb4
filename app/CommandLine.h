#pragma once

namespace app {

/// Exit codes of the program.
enum ExitCode { kFine = 0, kRunFailed = 1, kBadInput = 2, kWrongCommandLine = 64 };

/// Reads the words and does what they say.
int runProgram(int argc, char** argv);

}  // namespace app
