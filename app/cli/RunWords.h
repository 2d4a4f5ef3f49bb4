#pragma once

#include <string>
#include <vector>

#include "app/run/RunOptions.h"
#include "sim2d/base/Result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
}  // namespace CLI

namespace app {

/// Options and arguments of `run`.
void addRunWords(CLI::App& command, RunOptions& options);

/// The words of a run that was made before, without the name of the program. Error: they are none.
base::Result<RunOptions> readRunWords(const std::vector<std::string>& words);

}  // namespace app
