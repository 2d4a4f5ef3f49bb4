#include "app/run/RunSpec.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

#include <CLI/CLI.hpp>

#include "app/run/DataPaths.h"
#include "app/run/Nav2Robots.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"

namespace app {

namespace {

bool isTaken(const sim2d::Scenario& scenario, const std::string& name) {
  const auto has = [&name](const auto& entities) {
    return std::any_of(entities.begin(), entities.end(),
                       [&name](const auto& entity) { return entity.name == name; });
  };
  return has(scenario.humans) || has(scenario.robots) || has(scenario.obstacles) ||
         has(scenario.doors) || has(scenario.areas) || has(scenario.docks);
}

/// The first listed robot; null: there is none.
sim2d::Robot* firstRobot(sim2d::Scenario& scenario) {
  return base::findBy(scenario.robots, &sim2d::Robot::listed, true);
}

sim2d::Robot& addRobot(sim2d::Scenario& scenario) {
  sim2d::Robot robot;
  robot.key = {base::EntityKind::Robot, scenario.nextKey()};
  robot.name = "robot1";
  for (int number = 2; isTaken(scenario, robot.name); ++number) {
    robot.name = "robot" + std::to_string(number);
  }
  return *scenario.robots.insert(scenario.robots.begin(), robot);
}

/// The absolute path of a file that exists relative to the working directory; other names, such as
/// those of shipped files, are unchanged.
std::string absoluteIfExists(const std::string& file) {
  std::error_code none;
  return std::filesystem::exists(file, none) ? std::filesystem::absolute(file, none).string()
                                             : file;
}

const sim2d::Field<sim2d::DesktopSettings>* settingOf(const RunOption& option) {
  return option.setting != nullptr ? sim2d::fieldOf<sim2d::DesktopSettings>(option.setting)
                                   : nullptr;
}

/// The value that an option has, as a field takes it; monostate: it is not given.
base::ParameterValue valueOf(const RunOption& option, const RunSpec& spec) {
  if (!option.isGiven(spec)) {
    return {};
  }
  return std::visit(
      [&spec](auto member) -> base::ParameterValue {
        using Value = std::decay_t<decltype(spec.*member)>;
        if constexpr (std::is_same_v<Value, std::optional<double>> ||
                      std::is_same_v<Value, std::optional<std::string>>) {
          return *(spec.*member);
        } else if constexpr (std::is_same_v<Value, std::optional<int>> ||
                             std::is_same_v<Value, std::optional<long long>>) {
          return static_cast<long long>(*(spec.*member));
        } else if constexpr (std::is_same_v<Value, int>) {
          return static_cast<long long>(spec.*member);
        } else if constexpr (std::is_same_v<Value, std::string>) {
          return spec.*member;
        } else {
          return {};  // a flag or a list sets no single field
        }
      },
      option.member);
}

base::Diagnostics wrongNames(const RunSpec& spec) {
  base::Diagnostics wrong;
  for (const RunOption& option : kRunOptions) {
    const RunOption::Names known = option.choices();
    const base::ParameterValue value = valueOf(option, spec);
    const auto* const name = std::get_if<std::string>(&value);
    if (name != nullptr && !known.empty() &&
        std::find(known.begin(), known.end(), *name) == known.end()) {
      wrong.push_back(base::error("option.unknown-name",
                                  {std::string("--") + option.name, *name,
                                   base::nearestName(*name, known), base::join(known, ", ")}));
    }
  }
  return wrong;
}

base::Diagnostics valuesOutOfRange(const RunSpec& spec) {
  base::Diagnostics wrong;
  for (const RunOption& option : kRunOptions) {
    const base::ParameterValue value = valueOf(option, spec);
    const auto* const number = std::get_if<double>(&value);
    const auto* const integer = std::get_if<long long>(&value);
    const bool isWrong =
        (number != nullptr && !option.rangeOfValue().contains(*number)) ||
        (integer != nullptr && !option.rangeOfValue().contains(static_cast<double>(*integer)));
    if (isWrong) {
      wrong.push_back(base::error(option.problem));
    }
  }
  return wrong;
}

/// Errors: invalid options (exit code 64).
base::Diagnostics checkOptions(const RunSpec& spec) {
  base::Diagnostics wrong = wrongNames(spec);
  base::append(wrong, valuesOutOfRange(spec));
  const auto require = [&wrong](bool isFine, const char* code, const std::string& text) {
    if (!isFine) {
      wrong.push_back(base::error(code, {text}));
    }
  };
  const std::string start = spec.robotStart.value_or("0 0 0");
  const std::string goal = spec.robotGoal.value_or("0 0");
  require(parseNumbers(start, 3).has_value(), "option.robot-start", start);
  require(parseNumbers(goal, 2).has_value(), "option.robot-goal", goal);
  for (const std::string& pair : spec.set) {
    const std::size_t equals = pair.find('=');
    require(equals != std::string::npos && equals != 0, "option.set", pair);
  }
  return wrong;
}

/// Single values alone are added to the files of the scenario; files replace them.
void applyNav2Params(const std::vector<std::string>& given, sim2d::Robot& robot) {
  const auto isSingle = [](const std::string& entry) {
    return sim2d::nav2::parameterOverride(entry).has_value();
  };
  if (!std::all_of(given.begin(), given.end(), isSingle)) {
    robot.nav2Params.clear();
  }
  for (const std::string& entry : given) {
    robot.nav2Params.push_back(isSingle(entry) ? entry : absoluteIfExists(entry));
  }
}

base::Diagnostics applyRobot(sim2d::Scenario& scenario, const RunSpec& spec) {
  const bool hasNav2 =
      !spec.nav2Params.empty() || spec.nav2Tree || spec.nav2Distro || spec.nav2Body;
  if (!spec.robotStart && !spec.robotGoal && !spec.robot && !spec.planner && !hasNav2) {
    return {};
  }
  sim2d::Robot* const present = firstRobot(scenario);
  if (present == nullptr && !spec.robotStart) {
    return {base::error("option.no-robot", {}, spec.scenario)};
  }
  base::Diagnostics wrong = checkOptions(spec);
  if (!wrong.empty()) {
    return wrong;
  }
  sim2d::Robot& robot = present != nullptr ? *present : addRobot(scenario);
  if (spec.robotStart) {
    const std::vector<double> pose = *parseNumbers(*spec.robotStart, 3);
    robot.start = {{pose[0], pose[1]}, base::wrapToPi(pose[2])};
  }
  if (spec.robotGoal) {
    const std::vector<double> point = *parseNumbers(*spec.robotGoal, 2);
    robot.goal = sim2d::RobotGoal{};
    robot.goal.point = sim2d::Vec2(point[0], point[1]);
  }
  for (const RunOption& option : kRunOptions) {
    if (option.robotSetting != nullptr && option.isGiven(spec)) {
      sim2d::fieldOf<sim2d::Robot>(option.robotSetting)->assign(robot, valueOf(option, spec));
    }
  }
  if (hasNav2 && robot.planner != sim2d::kNav2Planner) {
    return {base::error("option.nav2-without-planner")};
  }
  applyNav2Params(spec.nav2Params, robot);
  robot.nav2Body = spec.nav2Body ? std::optional(true) : robot.nav2Body;
  robot.nav2Tree = spec.nav2Tree ? absoluteIfExists(*spec.nav2Tree) : robot.nav2Tree;
  return {};
}

}  // namespace

RunOption::Names knownModels() {
  return builtinRegistries().models.names();
}
RunOption::Names knownRobotTypes() {
  return builtinRegistries().robotTypes.names();
}
RunOption::Names knownPlanners() {
  return builtinRegistries().planners.names();
}
RunOption::Names knownDistros() {
  return sim2d::fieldOf<sim2d::Robot>("nav2_distro")->spec.choices;
}
RunOption::Names metricProfiles() {
  return {"corrected", "hunav2"};
}

std::string RunOption::key() const {
  std::string key = name;
  std::replace(key.begin(), key.end(), '-', '_');
  return key;
}

base::Range RunOption::rangeOfValue() const {
  const auto* const field = settingOf(*this);
  return field != nullptr ? field->spec.range : range;
}

RunOption::Names RunOption::choices() const {
  const auto* const field = settingOf(*this);
  return names != nullptr ? names() : field != nullptr ? field->spec.choices : Names();
}

bool RunOption::isGiven(const RunSpec& spec) const {
  static const RunSpec none;
  return std::visit([&spec](auto of) { return spec.*of != none.*of; }, member);
}

std::vector<std::string> RunOption::texts(const RunSpec& spec) const {
  if (const auto* const list = std::get_if<std::vector<std::string> RunSpec::*>(&member)) {
    return spec.**list;
  }
  const base::ParameterValue value = valueOf(*this, spec);
  if (const auto* const text = std::get_if<std::string>(&value)) {
    return {*text};
  }
  if (const auto* const number = std::get_if<double>(&value)) {
    return {base::formatDouble(*number)};
  }
  const auto* const integer = std::get_if<long long>(&value);
  return integer != nullptr ? std::vector{std::to_string(*integer)} : std::vector<std::string>();
}

std::vector<std::string> commandLineOf(const RunSpec& spec, unsigned use) {
  std::vector<std::string> words = {"run"};
  if (!spec.scenario.empty()) {
    words.push_back(spec.scenario);
  }
  for (const RunOption& option : kRunOptions) {
    if (!option.isGiven(spec) || (use != RunOption::Always && (option.use & use) == 0)) {
      continue;
    }
    const std::string name = std::string("--") + option.name;
    if (std::holds_alternative<bool RunSpec::*>(option.member)) {
      words.push_back(name);
    }
    for (const std::string& text : option.texts(spec)) {
      words.insert(words.end(), {name, text});
    }
  }
  return words;
}

std::optional<std::vector<double>> parseNumbers(const std::string& text, std::size_t count) {
  std::string spaced = text;
  std::replace(spaced.begin(), spaced.end(), ',', ' ');
  std::istringstream words(spaced);
  std::vector<double> values;
  for (std::string word; words >> word;) {
    const std::optional<double> value = base::parseDouble(word);
    if (!value || !(*value >= -1e6 && *value <= 1e6)) {
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values.size() == count ? std::make_optional(values) : std::nullopt;
}

base::Result<RunSettings> runSettingsOf(const RunSpec& spec) {
  base::Diagnostics wrong = checkOptions(spec);
  const base::Result<sim2d::Compatibility> compatibility =
      spec.compat.empty() ? base::Result<sim2d::Compatibility>(sim2d::Compatibility())
                          : sim2d::Compatibility::parse(spec.compat);
  base::append(wrong, compatibility.diagnostics());
  if (base::hasErrors(wrong)) {
    return wrong;
  }
  const sim2d::ExternalCodePolicy code =
      spec.allowCode ? sim2d::ExternalCodePolicy::Allowed : sim2d::ExternalCodePolicy::Refused;
  return {RunSettings{*compatibility, spec.threads, spec.exact, spec.strict, code},
          std::move(wrong)};
}

base::Diagnostics applyOptions(sim2d::Scenario& scenario, const RunSpec& spec,
                               const sim2d::Compatibility& compatibility) {
  base::Diagnostics problems;
  if (firstRobot(scenario) == nullptr && spec.robotStart) {
    applyRobot(scenario, spec);  // so that --set finds it; its problems are reported below
  }
  if (sim2d::Robot* const robot = firstRobot(scenario); robot != nullptr && spec.planner) {
    robot->planner = spec.planner;  // paths `nav2.…` need a robot that Nav2 drives
  }
  for (const std::string& pair : spec.set) {
    const std::size_t equals = pair.find('=');
    base::append(problems,
                 sim2d::setValue(scenario, pair.substr(0, equals), pair.substr(equals + 1)));
  }
  sim2d::DesktopSettings& desktop = scenario.desktop;
  if (compatibility.hunav2()) {
    desktop.route = sim2d::Route::Direct;
    desktop.model = "sfm-hunav2";
  }
  for (const RunOption& option : kRunOptions) {
    if (const auto* const field = settingOf(option); field != nullptr && option.isGiven(spec)) {
      field->assign(desktop, valueOf(option, spec));
    }
  }
  base::append(problems, applyRobot(scenario, spec));
  return problems;
}

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
  command
      .add_option("scenario", spec.scenario,
                  "Scenario file, or the name of a shipped scenario (hunavsim list scenarios)")
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
