#pragma once

#include <string>

namespace app {

/// Where and how the help shows an option.
struct OptionLayout {
  const char* name;     // "--seed"; the name of a positional argument
  const char* group;    // the heading below which it is listed
  const char* value;    // the placeholder of its value; null: from its type or its choices
  const char* command;  // null: of every command; "": of the program without a command
};

/// The row of an option; null: it has none, and is listed below "Options".
const OptionLayout* optionLayout(const std::string& command, const std::string& option);
/// Its place in the help: smaller is earlier. Options without a row come last.
std::size_t rankOf(const OptionLayout* layout);

/// The heading below which the help lists a command.
std::string groupOfCommand(const std::string& command);
/// Its place in the help. Commands that OptionLayout.cpp does not list come last.
std::size_t rankOfCommand(const std::string& command);

}  // namespace app
