#include "app/cli/help/CommandPages.h"

#include "app/cli/help/HelpText.h"
#include "app/cli/help/ReferencePages.h"
#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  for (std::size_t at = text.find(what); at != std::string::npos;
       at = text.find(what, at + with.size())) {
    text.replace(at, what.size(), with);
  }
  return text;
}

std::string markdownOptions(const CommandInfo& command) {
  std::string text;
  for (const std::string& group : groupsOf(command.options)) {
    text += "\n**" + group + "**\n\n| option | meaning |\n|---|---|\n";
    for (const OptionInfo& option : command.options) {
      if (option.group == group) {
        text += "| `" + markdownCell(optionHeading(option)) + "` | " + markdownCell(option.help) +
                " |\n";
      }
    }
  }
  return text;
}

std::string markdownExamples(const CommandInfo& command) {
  std::string text;
  for (const CommandExample& example : command.examples) {
    const bool runsAnywhere = example.needs.empty();
    text += "\n" + example.purpose + (runsAnywhere ? "" : " (needs " + example.needs + ")") +
            ":\n\n```" + (runsAnywhere ? "console\n$ " : "sh\n") + example.line + "\n```\n";
  }
  return text;
}

/// For the text of a manual page: no line may begin with a control character.
std::string roff(const std::string& text) {
  std::string shown = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  shown = replaced(replaced(shown, "…", "..."), "×", "x");
  shown = replaced(replaced(shown, "–", "\\-"), "'", "\\(aq");
  return !shown.empty() && shown.front() == '.' ? "\\&" + shown : shown;
}

std::string manOptions(const CommandInfo& command) {
  std::string text;
  for (const std::string& group : groupsOf(command.options)) {
    text += ".PP\n\\fI" + roff(group) + "\\fR\n";
    for (const OptionInfo& option : command.options) {
      if (option.group == group) {
        text += ".TP\n\\fB" + roff(optionHeading(option)) + "\\fR\n" + roff(option.help) + "\n";
      }
    }
  }
  return text;
}

std::string manExamples(const CommandInfo& command) {
  std::string text = command.examples.empty() ? "" : ".PP\n\\fIExamples\\fR\n";
  for (const CommandExample& example : command.examples) {
    const std::string needs = example.needs.empty() ? "" : " (needs " + example.needs + ")";
    text += ".TP\n" + roff(example.purpose + needs) + "\n.nf\n" + roff(example.line) + "\n.fi\n";
  }
  return text;
}

std::string manCommand(const CommandInfo& command) {
  return ".SS " + roff(command.name) + "\n\\fB" + roff(command.usage()) + "\\fR\n.PP\n" +
         roff(command.help) + ".\n" + manOptions(command) + manExamples(command);
}

}  // namespace

std::string commandsMarkdown(const CommandTable& table) {
  std::string text;
  for (const CommandInfo& command : table) {
    const std::string name = command.name.empty() ? "The window" : command.name;
    text += (text.empty() ? "" : "\n") + ("## " + name) + "\n\n" + markdownCell(command.help) +
            ".\n\n```text\n" + command.usage() + "\n```\n" + markdownOptions(command) +
            markdownExamples(command);
  }
  return text;
}

std::string manPage(const CommandTable& table) {
  const CommandInfo& root = table.front();
  std::string text = ".TH HUNAVSIM 1 \"\" \"hunavsim " + programVersion() +
                     "\" \"User Commands\"\n.SH NAME\nhunavsim \\- " +
                     roff(root.help.substr(root.help.find(": ") + 2)) + "\n.SH SYNOPSIS\n\\fB" +
                     roff(root.usage()) +
                     "\\fR\n.br\n\\fBhunavsim COMMAND\\fR [OPTIONS] ...\n.SH DESCRIPTION\n"
                     "Without a command, hunavsim opens its window.\n.SH OPTIONS OF THE WINDOW\n" +
                     manOptions(root) + manExamples(root) + ".SH COMMANDS\n";
  for (const CommandInfo& command : table) {
    text += command.name.empty() ? "" : manCommand(command);
  }
  text += ".SH EXIT STATUS\n";
  for (const ExitCodeText& each : kExitCodes) {
    text += std::string(".TP\n\\fB") + each.code + "\\fR\n" + roff(each.meaning) + "\n";
  }
  return text +
         ".SH FILES\n.TP\n\\fI/usr/share/hunavsim/maps\\fR\nshipped scenarios\n"
         ".TP\n\\fI/usr/share/hunavsim/manual\\fR\nthe manual\n";
}

}  // namespace app
