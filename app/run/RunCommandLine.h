#pragma once

#include <string>
#include <vector>

#include "app/run/RunSpec.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
class Validator;
}  // namespace CLI

namespace app {

/// For CLI::Option::check(): one of these words; else the nearest one is suggested.
CLI::Validator oneOf(const std::vector<std::string>& names);

/// Adds one option of a run, by its name.
void addRunOption(CLI::App& command, const char* name, RunSpec& spec);
/// Adds all options that the command `run` and the window have in common.
void addRunOptions(CLI::App& command, RunSpec& spec);
/// Adds the scenario and all options of the command `run` that determine the run.
void addRunArguments(CLI::App& command, RunSpec& spec);

/// The run that a command line describes, as a manifest keeps it, without the program's name.
/// Options that only write, show or pace the run are skipped. Error: it describes none.
base::Result<RunSpec> runSpecOfCommandLine(const std::vector<std::string>& words);
/// Names of the options that are skipped, with dashes: flags, and those with a value.
const std::vector<std::string>& skippedFlags();
const std::vector<std::string>& skippedOptions();

}  // namespace app
