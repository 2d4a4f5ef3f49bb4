#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "sim2d/base/Result.h"

/// Parsing of a program's command line, without a shell; texts of programs in messages.
/// Thread-safe.
namespace sim2d {

/// Splits at blanks like a POSIX shell: '…' is literal; in "…" and outside quotes a backslash makes
/// the next character literal (in "…" only before ", \, $ and `). No expansions, no operators.
/// Errors: external.no-command, external.open-quote.
base::Result<std::vector<std::string>> splitCommandLine(const std::string& command);

/// Path of the executable: names with a slash are paths, others are searched in PATH. Error:
/// external.not-started.
base::Result<std::string> resolveExecutable(const std::string& name);

/// Text of another program, formatted for a message: on one line, control characters replaced by
/// '?', truncated to `most` bytes.
std::string printableText(std::string_view text, std::size_t most = 200);

}  // namespace sim2d
