#pragma once

#include <string>

#include "app/cli/help/CommandTable.h"

/// The command line as files that packages install: all are written from the table of commands.

namespace app {

/// The command reference of the manual. Code blocks with the language `console` can be executed
/// anywhere; those with `sh` need what is named above them.
std::string commandsMarkdown(const CommandTable& table);

/// The manual page hunavsim(1), in the macros of man(7). The date is left out, so that equal
/// programs write equal pages.
std::string manPage(const CommandTable& table);

/// Completion scripts. All complete commands, options, choices, files and the names of scenarios,
/// which they get from `hunavsim list scenarios`.
std::string bashCompletion(const CommandTable& table);
std::string zshCompletion(const CommandTable& table);
std::string fishCompletion(const CommandTable& table);

}  // namespace app
