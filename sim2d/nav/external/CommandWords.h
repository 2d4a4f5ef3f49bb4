#pragma once

#include <string>
#include <vector>

#include "sim2d/base/Result.h"

/// The command of a program, without a shell. Thread: any.
namespace sim2d {

/// Cut at blanks, as a POSIX shell does it: '…' is taken as it stands, in "…" and outside a
/// backslash takes the next character as it stands (in "…" only before ", \, $ and `). Nothing is
/// expanded, no operator means anything. Errors: external.no-command, external.open-quote.
base::Result<std::vector<std::string>> commandWords(const std::string& command);

/// The file that is meant by a program's name: names with a slash are paths, others are looked for
/// in PATH. Error: external.not-started.
base::Result<std::string> programFile(const std::string& name);

}  // namespace sim2d
