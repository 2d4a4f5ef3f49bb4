#include <algorithm>

#include "app/cli/help/CommandPages.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

const char* const kWrittenBy = "; written by `hunavsim list commands --format ";

/// Text in single quotes for a shell.
std::string quoted(const std::string& text) {
  std::string shown = "'";
  for (const char byte : text) {
    shown += byte == '\'' ? std::string("'\\''") : std::string(1, byte);
  }
  return shown + "'";
}

/// For a field of a specification of zsh's _arguments, whose fields end at colons and brackets.
std::string zshField(const std::string& text) {
  std::string shown;
  for (const char byte : text) {
    shown += byte == ':' || byte == '[' || byte == ']' ? "\\" : "";
    shown += byte;
  }
  return shown;
}

std::string namesOfCommands(const CommandTable& table) {
  std::vector<std::string> names;
  for (const CommandInfo& command : table) {
    if (!command.name.empty()) {
      names.push_back(command.name);
    }
  }
  return base::join(names, " ");
}

const OptionInfo* firstArgument(const CommandInfo& command) {
  const auto found = std::find_if(command.options.begin(), command.options.end(),
                                  [](const OptionInfo& each) { return each.isPositional; });
  return found == command.options.end() ? nullptr : &*found;
}

std::string bashWords(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::Choice:
      return "_hunavsim_words " + quoted(base::join(option.choices, " "));
    case ValueKind::File:
      return "_hunavsim_files -f";
    case ValueKind::Folder:
      return "_hunavsim_files -d";
    case ValueKind::Scenario:
      return "_hunavsim_scenarios";
    case ValueKind::None:
    case ValueKind::Text:
      break;
  }
  return "return";
}

/// "run:--planner) …", for each option with a value.
std::string bashValues(const CommandInfo& command) {
  std::string text;
  for (const OptionInfo& option : command.options) {
    if (!option.isPositional && option.kind != ValueKind::None) {
      std::vector<std::string> patterns;
      for (const std::string& name : option.names) {
        patterns.push_back(command.name + ":" + name);
      }
      text += "    " + base::join(patterns, "|") + ") " + bashWords(option) + "; return ;;\n";
    }
  }
  return text;
}

std::string longNames(const CommandInfo& command) {
  std::string text;
  for (const OptionInfo& option : command.options) {
    if (!option.isPositional) {
      text += (text.empty() ? "" : " ") + base::join(option.names, " ");
    }
  }
  return text;
}

/// What stands where no option is: the argument of the command.
std::string bashArgument(const CommandInfo& command, const std::string& commands) {
  const OptionInfo* const argument = firstArgument(command);
  std::string words = argument == nullptr ? "" : bashWords(*argument);
  if (command.name.empty()) {
    words = "_hunavsim_words " + quoted(commands) + "; _hunavsim_scenarios";
  } else if (command.name == "check") {
    words = "_hunavsim_scenarios";  // files, or names of scenarios
  }
  return words.empty() ? "" : "    " + quoted(command.name) + ") " + words + " ;;\n";
}

const char* const kBashHead = R"bash(_hunavsim_words() {
  COMPREPLY+=($(compgen -W "$1" -- "$cur"))
}
_hunavsim_files() {
  compopt -o filenames 2>/dev/null
  local IFS=$'\n'
  COMPREPLY+=($(compgen "$1" -- "$cur"))
}
_hunavsim_scenarios() {
  _hunavsim_words "$("$program" list scenarios 2>/dev/null | sed 's/ .*//')"
  _hunavsim_files -f
}
_hunavsim() {
  local program=${COMP_WORDS[0]} cur=${COMP_WORDS[COMP_CWORD]} command= word
  local previous=${COMP_WORDS[COMP_CWORD - 1]}
  COMPREPLY=()
)bash";

std::string zshAction(const OptionInfo& option) {
  switch (option.kind) {
    case ValueKind::Choice:
      return "(" + base::join(option.choices, " ") + ")";
    case ValueKind::File:
      return "_files";
    case ValueKind::Folder:
      return "_files -/";
    case ValueKind::Scenario:
      return "_hunavsim_scenarios";
    case ValueKind::None:
    case ValueKind::Text:
      break;
  }  // namespace app
  return " ";
}

std::string zshOption(const OptionInfo& option) {
  const bool hasValue = option.kind != ValueKind::None;
  const std::string value =
      hasValue ? ":" + zshField(option.value) + ":" + zshAction(option) : std::string();
  std::string text;
  if (option.isPositional) {
    return "      " + quoted((option.isRepeatable ? "*" : "1") + value) + " \\\n";
  }
  const std::string others = option.isRepeatable ? "*" : "(" + base::join(option.names, " ") + ")";
  for (const std::string& name : option.names) {
    const std::string argument =
        base::join({others, name, "[", zshField(option.help), "]", value}, "");
    text.append("      ").append(quoted(argument)).append(" \\\n");
  }
  return text;
}

std::string zshOptions(const CommandInfo& command) {
  std::string text = "    _arguments -s -S \\\n";
  for (const OptionInfo& option : command.options) {
    if (!option.isPositional || !command.name.empty()) {
      text += zshOption(option);
    }
  }
  return text + "      && return 0\n";
}

const char* const kZshHead = R"zsh(_hunavsim_scenarios() {
  local -a names
  names=(${(f)"$(${hunavsim_program:-hunavsim} list scenarios 2>/dev/null | sed 's/ .*//')"})
  compadd -a names
  _files
}
_hunavsim_commands() {
  local -a commands
  commands=(
)zsh";

/// The condition under which an option of a command is offered.
std::string fishCondition(const CommandInfo& command) {
  return command.name.empty() ? "__fish_use_subcommand"
                              : "__fish_seen_subcommand_from " + command.name;
}

std::string fishOption(const OptionInfo& option, const std::string& condition) {
  std::string text = "complete -c hunavsim -n " + quoted(condition);
  for (const std::string& name : option.names) {
    text += base::startsWith(name, "--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
  }
  text += " -d " + quoted(option.help);
  switch (option.kind) {
    case ValueKind::Choice:
      return text + " -x -a " + quoted(base::join(option.choices, " ")) + "\n";
    case ValueKind::File:
      return text + " -r -F\n";
    case ValueKind::Folder:
      return text + " -x -a '(__fish_complete_directories)'\n";
    case ValueKind::Scenario:
    case ValueKind::Text:
      return text + " -x\n";
    case ValueKind::None:
      break;
  }
  return text + "\n";
}

std::string fishArgument(const CommandInfo& command) {
  const OptionInfo* const argument = firstArgument(command);
  const std::string begin = "complete -c hunavsim -n " + quoted(fishCondition(command));
  if (argument == nullptr) {
    return "";
  }
  if (argument->kind == ValueKind::Choice) {
    return begin + " -f -a " + quoted(base::join(argument->choices, " ")) + "\n";
  }
  const bool hasScenarios = argument->kind == ValueKind::Scenario || command.name == "check";
  return hasScenarios ? begin + " -a '(__hunavsim_scenarios)'\n" : "";
}

}  // namespace

std::string bashCompletion(const CommandTable& table) {
  const std::string commands = namesOfCommands(table);
  std::string values;
  std::string options;
  std::string arguments;
  for (const CommandInfo& command : table) {
    values += bashValues(command);
    options += "      " + quoted(command.name) + ") _hunavsim_words " + quoted(longNames(command)) +
               " ;;\n";
    arguments += bashArgument(command, commands);
  }
  return std::string("# Completion of hunavsim for bash") + kWrittenBy + "bash`.\n" + kBashHead +
         "  for word in \"${COMP_WORDS[@]:1:COMP_CWORD - 1}\"; do\n    case \" " + commands +
         " \" in\n      *\" $word \"*) command=$word; break ;;\n    esac\n  done\n"
         "  case \"$command:$previous\" in\n" +
         values + "  esac\n  if [[ $cur == -* ]]; then\n    case $command in\n" + options +
         "    esac\n    return\n  fi\n  case $command in\n" + arguments +
         "  esac\n}\ncomplete -F _hunavsim hunavsim\n";
}

std::string zshCompletion(const CommandTable& table) {
  std::string text = std::string("#compdef hunavsim\n# Completion of hunavsim for zsh") +
                     kWrittenBy + "zsh`.\n" + kZshHead;
  std::string cases;
  for (const CommandInfo& command : table) {
    if (command.name.empty()) {
      continue;
    }
    text += "    " + quoted(command.name + ":" + zshField(command.help)) + "\n";
    cases += "  " + command.name + ")\n" + zshOptions(command) + "    ;;\n";
  }
  return text +
         "  )\n  _describe -t commands command commands\n}\n_hunavsim() {\n"
         "  local hunavsim_program=$words[1]\n"
         "  if (( CURRENT == 2 )) && [[ $words[2] != -* ]]; then\n"
         "    _hunavsim_commands\n    _hunavsim_scenarios\n    return\n  fi\n"
         "  local command=$words[2]\n  if [[ -n $command && $command != -* ]]; then\n"
         "    shift words\n    (( CURRENT-- ))\n  fi\n  case $command in\n" +
         cases + "  *)\n" + zshOptions(table.front()) +
         "    _hunavsim_scenarios ;;\n  esac\n}\n_hunavsim \"$@\"\n";
}

std::string fishCompletion(const CommandTable& table) {
  std::string text = std::string("# Completion of hunavsim for fish") + kWrittenBy +
                     "fish`.\nfunction __hunavsim_scenarios\n"
                     "  hunavsim list scenarios 2>/dev/null | string replace -r ' .*' ''\nend\n";
  for (const CommandInfo& command : table) {
    if (!command.name.empty()) {
      text += "complete -c hunavsim -n __fish_use_subcommand -a " + command.name + " -d " +
              quoted(command.help) + "\n";
    }
    text += fishArgument(command);
    for (const OptionInfo& option : command.options) {
      if (!option.isPositional) {
        text += fishOption(option, fishCondition(command));
      }
    }
  }
  return text;
}

}  // namespace app
