#pragma once

#include <string>

#include "app/cli/help/CommandTable.h"

namespace app {

/// The text of `hunavsim NAME --help`, in lines of at most 80 characters where words allow it:
/// usage, options by groups, examples, exit codes. For the program without a command also the list
/// of commands.
std::string helpText(const CommandInfo& command, const CommandTable& table);

/// "-o, --output DIR"; "SCENARIO" for a positional argument.
std::string optionHeading(const OptionInfo& option);

}  // namespace app
