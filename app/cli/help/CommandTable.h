#pragma once

#include <string>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): as the library is called
class App;
}  // namespace CLI

namespace app {

/// A command line that the help, the manual page and the manual show.
struct CommandExample {
  std::string line;        // "hunavsim run corner_cafe_agents"
  std::string purpose;     // what it does, without a full stop
  std::string needs = {};  // what it needs besides the program ("ROS 2"); empty: nothing
};

/// What the value of an option is, for completion.
enum class ValueKind { None, Text, Choice, File, Folder, Scenario };

/// An option or a positional argument as the help, the manual page and completions show it.
struct OptionInfo {
  std::vector<std::string> names;  // "-o", "--output"; the placeholder of a positional argument
  std::string value;               // "FILE", "none|people|any"; empty for a flag
  std::vector<std::string> choices;
  std::string group;  // the heading below which it is listed
  std::string help;
  bool isPositional = false;
  bool isRequired = false;
  bool isRepeatable = false;
  ValueKind kind = ValueKind::None;
};

/// A command with its options in the order of the help: the most common first.
struct CommandInfo {
  std::string name;   // empty: the program without a command
  std::string group;  // the heading below which it is listed
  std::string help;
  std::vector<OptionInfo> options;
  std::vector<CommandExample> examples;

  /// "hunavsim run [OPTIONS] [SCENARIO]".
  std::string usage() const;
};

/// Describes a command of the parser. Groups, order and placeholders come from OptionLayout.cpp.
CommandInfo describeCommand(const CLI::App& command, bool isRoot,
                            std::vector<CommandExample> examples);

/// The whole command line: the program without a command first, then the commands in the order of
/// the help.
using CommandTable = std::vector<CommandInfo>;

/// The headings of things, in order and without duplicates.
template <class Thing>
std::vector<std::string> groupsOf(const std::vector<Thing>& things) {
  std::vector<std::string> groups;
  for (const Thing& each : things) {
    bool isKnown = each.group.empty();
    for (const std::string& group : groups) {
      isKnown = isKnown || group == each.group;
    }
    if (!isKnown) {
      groups.push_back(each.group);
    }
  }
  return groups;
}

/// The exit codes of all commands, with their meanings.
struct ExitCodeText {
  const char* code;
  const char* meaning;
};
inline constexpr ExitCodeText kExitCodes[] = {
    {"0", "success, also with warnings"},
    {"1",
     "a run failed or was interrupted; partial results are kept (gate: the candidate is worse)"},
    {"2", "invalid input, or the output cannot be written"},
    {"3", "gate: undecided within the largest number of seeds"},
    {"64", "wrong command line"},
};

}  // namespace app
