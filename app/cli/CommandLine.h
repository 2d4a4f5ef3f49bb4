#pragma once

#include "app/cli/CommandRegistry.h"

namespace app {

/// Reads the words and does what they say. `addWindow` adds what is done without a command.
int runProgram(int argc, char** argv, void (*addWindow)(CommandRegistry&));

}  // namespace app
