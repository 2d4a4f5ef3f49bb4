#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/bridge/dds/Participant.h"
#include "app/cli/help/CommandTable.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Result.h"

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
class Option;
}  // namespace CLI

namespace app {

class BatchFolder;

/// Exit codes of the program. `gate` uses ExitRunFailed for a worse candidate.
enum ExitCode {
  ExitFine = 0,
  ExitRunFailed = 1,
  ExitBadInput = 2,
  ExitUndecided = 3,  // of `gate`
  ExitWrongCommandLine = 64
};

/// The Qt libraries that a command needs: only the core, or also those for pictures, which need no
/// display.
enum class Drawing { None, Pictures };

/// Thrown by a command that ends before its last line.
struct CommandEnd {
  ExitCode code;
  base::Diagnostics problems{};  // why; with --json the standard output lists them
};
/// Prints the problems of `least` severity and above; the command ends with `code` when an error is
/// among them. Not after the command's own JSON.
void requireFine(const base::Diagnostics& problems, ExitCode code = ExitBadInput,
                 base::Severity least = base::Severity::Info);

/// The command line of the program and the options that all commands have.
struct Invocation {
  int argc = 0;
  char** argv = nullptr;
  bool quiet = false;  // no progress, no table
  bool json = false;   // machine-readable standard output
  std::vector<std::string> words() const { return {argv, argv + argc}; }
  /// The command line without the options that do not change the results of a study: --jobs,
  /// --resume, --force, --quiet, --json.
  std::vector<std::string> argumentsForResults() const;
};

/// Prints the final report of `batch` and `merge`; returns the exit code. `problems`: write errors.
int reportBatch(const BatchFolder& folder, const base::Diagnostics& problems,
                const Invocation& given);

/// The commands of the program. Each file of app/cli/commands adds its own; the options are those
/// of CLI11 and belong to the command.
class CommandRegistry {
 public:
  using Action = std::function<int(const Invocation&)>;  // returns an exit code

  explicit CommandRegistry(CLI::App& root);
  CLI::App& root() const { return root_; }
  std::vector<std::string> names() const;  // of the commands

  /// `drawing` is called after the options have been parsed.
  CLI::App& add(
      const std::string& name, const std::string& help, Action action,
      std::function<Drawing()> drawing = [] { return Drawing::None; });
  /// The same with options, which live as long as the registry.
  template <class Options>
  std::pair<CLI::App&, Options&> add(const std::string& name, const std::string& help,
                                     int (*work)(const Options&, const Invocation&),
                                     Drawing (*drawing)(const Options&) = nullptr) {
    const auto options = std::make_shared<Options>();
    const Action action = [=](const Invocation& given) { return work(*options, given); };
    return {add(name, help, action,
                [=] { return drawing != nullptr ? drawing(*options) : Drawing::None; }),
            *options};
  }
  /// Command lines for the help, the manual page and the manual. Those without `needs` are executed
  /// by a test in the order of the manual. `command` may be the root: the window.
  void addExamples(const CLI::App& command, std::vector<CommandExample> examples);
  /// All commands with their options: complete after addOutputOptions().
  CommandTable table() const;

  /// The action without a command. It creates its application itself.
  void setDefault(Action action) { default_ = std::move(action); }

  /// --quiet and --json behind the options of each command.
  void addOutputOptions();
  /// Notes whether --json is given, also in a command line that cannot be parsed.
  void noteJson(const std::vector<std::string>& words);
  bool wantsJson() const { return json_; }
  /// Runs the given command; returns its exit code or throws CommandEnd.
  int start(Invocation given) const;

 private:
  CommandInfo infoOf(const CLI::App& command) const;

  struct Command {
    Action action;
    std::function<Drawing()> drawing;
  };
  CLI::App& root_;
  std::map<std::string, Command> commands_;
  std::map<const CLI::App*, std::vector<CommandExample>> examples_;
  Action default_;
  bool quiet_ = false, json_ = false;
};

/// -o, --output for a folder. "-" is refused: it stands for the standard output, which takes one
/// file.
CLI::Option& addOutputFolder(CLI::App& command, std::string& folder, const std::string& help);
// Options that several commands have in common.
void addAllowCode(CLI::App& command, bool& allowed);
void addJobs(CLI::App& command, int& jobs);
void addTimeLimit(CLI::App& command, double& seconds);  // of one run, wall time; 0 = none
void addForce(CLI::App& command, bool& force);
void addMetricsOptions(CLI::App& command, MetricsOptions& options);

/// Parses the command line and runs the command. `addWindow` adds the action without a command.
int runProgram(int argc, char** argv, void (*addWindow)(CommandRegistry&));

/// Common options of all commands that use ROS 2.
struct Ros2Options {
  bool ros2 = false;
  std::optional<int> domain;
  std::optional<std::string> rmw, distro;
  bool network = false;
};

/// For check() of an option: "/" or "/lab".
CLI::Validator namespaceName();

void addRos2Options(CLI::App& command, Ros2Options& options, const std::string& help);

/// Options that are not given come from ROS_DOMAIN_ID, RMW_IMPLEMENTATION and ROS_DISTRO. Errors:
/// such a variable is invalid; this build has no ROS 2 support.
base::Result<bridge::DomainSettings> domainSettingsOf(const Ros2Options& options);

}  // namespace app
