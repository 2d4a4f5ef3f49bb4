#include "app/run/RunCommandLine.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

std::string wrongInteger(const std::string& text) {
  return base::parseInt(text) ? std::string() : "'" + text + "' is not a 64-bit integer";
}

/// The parser checks names that do not depend on what the program registers.
bool isCheckedByParser(const RunOption& option) {
  return option.names == metricProfiles;
}

void addOption(CLI::App& command, const RunOption& option, RunSpec& spec) {
  const std::string name = std::string("--") + option.name;
  std::visit(
      [&](auto member) {
        using Value = std::decay_t<decltype(spec.*member)>;
        if constexpr (std::is_same_v<Value, bool>) {
          command.add_flag(name, spec.*member, option.help);
        } else {
          CLI::Option* const added = command.add_option(name, spec.*member, option.help);
          if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
            added->allow_extra_args(false);
          } else if constexpr (std::is_same_v<Value, std::optional<long long>>) {
            added->check(wrongInteger);
          }
          if (isCheckedByParser(option)) {
            added->check(oneOf(option.choices()));
          }
        }
      },
      option.member);
}

}  // namespace

CLI::Validator oneOf(const std::vector<std::string>& names) {
  const auto problem = [names](const std::string& word) {
    const std::optional<std::string> meant = base::nearestName(word, names);
    return std::find(names.begin(), names.end(), word) != names.end()
               ? std::string()
               : "'" + word + "' is not one of " + base::join(names, ", ") +
                     (meant ? " (did you mean '" + *meant + "'?)" : std::string());
  };
  return {problem, "{" + base::join(names, ",") + "}"};
}

void addRunOption(CLI::App& command, const char* name, RunSpec& spec) {
  for (const RunOption& option : kRunOptions) {
    if (std::string(name) == option.name) {
      addOption(command, option, spec);
    }
  }
}

void addRunOptions(CLI::App& command, RunSpec& spec) {
  for (const RunOption& option : kRunOptions) {
    if ((option.use & RunOption::OfCommand) == 0) {
      addOption(command, option, spec);
    }
  }
}

void addRunArguments(CLI::App& command, RunSpec& spec) {
  command.add_option("scenario", spec.scenario, "Scenario file, or a name from list scenarios")
      ->transform(scenarioFile);
  for (const RunOption& option : kRunOptions) {
    addOption(command, option, spec);
  }
}

const std::vector<std::string>& skippedFlags() {
  static const std::vector<std::string> names = {"-q,--quiet", "--json",    "--force",
                                                 "--totals",   "--ros2",    "--network",
                                                 "--lockstep", "--stamped", "--ros2-send-goals"};
  return names;
}

const std::vector<std::string>& skippedOptions() {
  static const std::vector<std::string> names = {
      "-o,--output",       "--record", "--speed",     "--foxglove", "--foxglove-address",
      "--foxglove-origin", "--groot2", "--groot2-of", "--domain",   "--rmw",
      "--ros-distro"};
  return names;
}

base::Result<RunSpec> runSpecOfCommandLine(const std::vector<std::string>& words) {
  RunSpec spec;
  bool isSkipped = false;
  std::vector<std::string> skipped;
  CLI::App root;
  root.add_flag("-q,--quiet", isSkipped);
  CLI::App& command = *root.add_subcommand("run");
  root.require_subcommand(1);
  addRunArguments(command, spec);
  for (const std::string& name : skippedFlags()) {
    command.add_flag(name, isSkipped);
  }
  for (const std::string& name : skippedOptions()) {
    command.add_option(name, skipped)->allow_extra_args(false);
  }
  try {
    root.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::Error&) {
    return base::error("again.not-told");
  }
  return spec;
}

}  // namespace app
