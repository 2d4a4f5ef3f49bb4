#include "app/cli/help/CommandTable.h"

#include <algorithm>

#include <CLI/CLI.hpp>

#include "app/cli/help/OptionLayout.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

constexpr std::size_t kMostShownChoices = 6;  // more would not fit into the column of options

/// Words in the braces of a validator's description, as oneOf() of RunSpec.h writes them.
std::vector<std::string> choicesOfParser(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}', begin);
  return begin == std::string::npos || end == std::string::npos
             ? std::vector<std::string>()
             : base::split(type.substr(begin + 1, end - begin - 1), ',');
}

/// Options of a run that are checked after parsing have their choices in kRunOptions. `--robot` of
/// `evaluate` is a body, not a type.
std::vector<std::string> choicesOf(const CLI::Option& option, const std::string& command) {
  std::vector<std::string> choices = choicesOfParser(option);
  for (const RunOption& each : kRunOptions) {
    if (choices.empty() && command != "evaluate" && option.check_lname(each.name)) {
      choices = each.choices();
    }
  }
  return choices;
}

std::string placeholderOfType(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  const bool isNumber = type.compare(0, 3, "INT") == 0 || type.compare(0, 4, "UINT") == 0;
  return isNumber ? "N" : type.compare(0, 5, "FLOAT") == 0 ? "NUMBER" : "TEXT";
}

ValueKind valueKindOf(const OptionInfo& option) {
  const auto begins = [&option](const char* with) { return base::startsWith(option.value, with); };
  if (option.value.empty()) {
    return ValueKind::None;
  }
  if (!option.choices.empty()) {
    return ValueKind::Choice;
  }
  if (begins("SCENARIO")) {
    return ValueKind::Scenario;
  }
  if (begins("DIR") || option.value == "RUN") {
    return ValueKind::Folder;
  }
  const bool isFile =
      begins("FILE") || begins("RUN|") || option.value == "EXPERIMENT" || option.value == "SOURCE";
  return isFile ? ValueKind::File : ValueKind::Text;
}

/// The long name if there is one; for positional arguments their name.
std::string mainName(const CLI::Option& option) {
  return option.get_positional()       ? option.get_name(true)
         : option.get_lnames().empty() ? "-" + option.get_snames().front()
                                       : "--" + option.get_lnames().front();
}

void setNames(OptionInfo& info, const CLI::Option& option) {
  for (const std::string& name : option.get_snames()) {
    info.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    info.names.push_back("--" + name);
  }
  if (info.names.empty()) {
    info.isPositional = true;
    info.names.push_back(info.value);
  }
}

OptionInfo describeOption(const CLI::Option& option, const std::string& command) {
  OptionInfo info;
  const OptionLayout* const layout = optionLayout(command, mainName(option));
  info.group = layout != nullptr ? layout->group : "Options";
  info.help = option.get_description();
  info.isRequired = option.get_required();
  if (option.get_items_expected_max() > 0) {
    info.choices = choicesOf(option, command);
    info.isRepeatable = option.get_items_expected_max() > 1;
    info.value = layout != nullptr && layout->value != nullptr ? layout->value
                 : info.choices.empty()                        ? placeholderOfType(option)
                 : info.choices.size() <= kMostShownChoices    ? base::join(info.choices, "|")
                                                               : "NAME";
  }
  setNames(info, option);
  info.kind = valueKindOf(info);
  return info;
}

}  // namespace

std::string CommandInfo::usage() const {
  std::string text = name.empty() ? "hunavsim" : "hunavsim " + name;
  text += " [OPTIONS]";
  for (const OptionInfo& option : options) {
    if (option.isPositional) {
      const std::string shown = option.value + (option.isRepeatable ? "…" : "");
      text += option.isRequired ? " " + shown : " [" + shown + "]";
    }
  }
  return text;
}

CommandInfo describeCommand(const CLI::App& command, bool isRoot,
                            std::vector<CommandExample> examples) {
  CommandInfo info;
  info.name = isRoot ? std::string() : command.get_name();
  info.group = isRoot ? std::string() : groupOfCommand(info.name);
  info.help = command.get_description();
  info.examples = std::move(examples);
  std::vector<const CLI::Option*> options = command.get_options();
  const auto rank = [&info](const CLI::Option* option) {
    return rankOf(optionLayout(info.name, mainName(*option)));
  };
  std::stable_sort(options.begin(), options.end(),
                   [&rank](const auto* a, const auto* b) { return rank(a) < rank(b); });
  for (const CLI::Option* option : options) {
    info.options.push_back(describeOption(*option, info.name));
  }
  return info;
}

}  // namespace app
