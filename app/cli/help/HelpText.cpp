#include "app/cli/help/HelpText.h"

#include <vector>

#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr std::size_t kHelpWidth = 80;   // [characters]
constexpr std::size_t kHelpColumn = 26;  // where the descriptions begin

/// The number of characters, not bytes, of UTF-8.
std::size_t lengthOf(const std::string& text) {
  std::size_t length = 0;
  for (const char byte : text) {
    length += (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U ? 1U : 0U;
  }
  return length;
}

/// The text in lines of at most `width` characters, broken at blanks.
std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
  std::vector<std::string> lines;
  for (const std::string& word : base::split(text, ' ')) {
    if (lines.empty() || lengthOf(lines.back()) + 1 + lengthOf(word) > width) {
      lines.push_back(word);
    } else {
      lines.back() += " " + word;
    }
  }
  return lines;
}

/// A heading with its description beside or below it.
std::string entryText(const std::string& heading, const std::string& help) {
  std::string text = "  " + heading;
  std::size_t column = lengthOf(text);
  if (column + 2 > kHelpColumn) {
    text += "\n";
    column = 0;
  }
  for (const std::string& line : wrapped(help, kHelpWidth - kHelpColumn)) {
    text += std::string(kHelpColumn - column, ' ') + line + "\n";
    column = 0;
  }
  return help.empty() ? text + "\n" : text;
}

std::string optionsText(const CommandInfo& command) {
  std::string text;
  for (const std::string& group : groupsOf(command.options)) {
    text += "\n" + group + ":\n";
    for (const OptionInfo& option : command.options) {
      if (option.group == group) {
        text += entryText(optionHeading(option), option.help);
      }
    }
  }
  return text;
}

std::string commandsText(const CommandTable& table) {
  std::string text;
  for (const std::string& group : groupsOf(table)) {
    text += "\n" + group + ":\n";
    for (const CommandInfo& command : table) {
      if (command.group == group) {
        text += entryText(command.name, command.help);
      }
    }
  }
  return text;
}

std::string examplesText(const CommandInfo& command) {
  std::string text = command.examples.empty() ? "" : "\nExamples:\n";
  for (const CommandExample& example : command.examples) {
    const std::string needs = example.needs.empty() ? "" : " (needs " + example.needs + ")";
    text += "  # " + example.purpose + needs + "\n  " + example.line + "\n";
  }
  return text;
}

std::string exitCodesText() {
  std::string text = "\nExit codes:\n";
  for (const ExitCodeText& each : kExitCodes) {
    text += entryText(each.code, each.meaning);
  }
  return text;
}

}  // namespace

std::string optionHeading(const OptionInfo& option) {
  const std::string more = option.isPositional && option.isRepeatable ? "…" : "";
  const std::string value = option.isPositional || option.value.empty() ? "" : " " + option.value;
  return base::join(option.names, ", ") + value + more;
}

std::string helpText(const CommandInfo& command, const CommandTable& table) {
  const bool isRoot = command.name.empty();
  std::string text = command.help + "\n\nUsage: " + command.usage() + "\n";
  if (isRoot) {
    text +=
        "       hunavsim COMMAND [OPTIONS] …  (hunavsim COMMAND --help)\n" + commandsText(table);
  }
  text += optionsText(command) + examplesText(command) + exitCodesText();
  return text + (isRoot ? "\nManual: man hunavsim, or Help in the window\n" : "");
}

}  // namespace app
