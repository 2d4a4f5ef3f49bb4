#include "app/studies/TuneSubject.h"

#include <algorithm>
#include <memory>
#include <utility>
#include <variant>

#include "app/run/ManifestFiles.h"
#include "app/run/Nav2Robots.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/nav2/params/DistroGuess.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/nav/nav2/params/ParameterPatch.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

constexpr char kControllerServer[] = "controller_server";
constexpr char kDesktopNode[] = "hunavsim_desktop";  // of scenario files

const Nav2Parameter* parameterOf(const Nav2ParameterList& list, const std::string& node,
                                 const std::string& name) {
  return base::findIf(list.parameters, [&](const Nav2Parameter& each) {
    return (node.empty() ? each.node + "." + each.name == name
                         : each.node == node && each.name == name);
  });
}

/// The plugins of a controller: its own, and the one that a rotation shim wraps, with the prefix of
/// their parameters.
std::vector<std::pair<std::string, std::string>> pluginsOf(
    const sim2d::nav2::NodeParameters& server, const std::string& controller) {
  std::vector<std::pair<std::string, std::string>> plugins;
  for (const char* key : {"primary_controller.plugin", "primary_controller", "plugin"}) {
    const sim2d::nav2::GivenParameter* const given = server.find(controller + "." + key);
    if (given != nullptr && given->value->isScalar()) {
      const bool isNested = base::endsWith(given->name, "primary_controller.plugin");
      plugins.emplace_back(given->value->text,
                           controller + (isNested ? ".primary_controller." : "."));
    }
  }
  return plugins;
}

/// Names of the controllers, as configured.
std::vector<std::string> controllersOf(const sim2d::nav2::NodeParameters& server) {
  std::vector<std::string> names;
  if (const auto* const given = server.find("controller_plugins")) {
    for (const base::YamlNode& item : given->value->items) {
      names.push_back(item.text);
    }
  }
  return names.empty() ? std::vector<std::string>{"FollowPath"} : names;
}

/// Old versions write "nav2_mppi_controller/MPPIController".
std::string withColons(std::string plugin) {
  const std::size_t slash = plugin.find('/');
  return slash == std::string::npos ? plugin : plugin.replace(slash, 1, "::");
}

/// The block of a robot in a scenario file; null: it has none.
const base::YamlNode* robotBlock(const base::YamlNode& root, const std::string& robot) {
  const base::YamlNode* node = &root;
  for (const std::string& key :
       {std::string(kDesktopNode), std::string("ros__parameters"), robot}) {
    node = node != nullptr && node->isMap() ? node->find(key) : nullptr;
  }
  return node;
}

/// The text with lines inserted before the first line of a block map, with its indentation.
/// Nothing: the map is empty, or a flow map.
std::optional<std::string> withFirstLine(const std::string& text, const base::YamlNode& map,
                                         const std::string& lines) {
  if (!map.isMap() || map.items.empty() || map.items.front().keyLine <= map.keyLine) {
    return std::nullopt;
  }
  std::size_t at = 0;
  for (int line = 1; line < map.items.front().keyLine; ++line) {
    at = text.find('\n', at) + 1;
  }
  const std::string indent(static_cast<std::size_t>(map.items.front().keyColumn - 1), ' ');
  std::string added;
  for (const std::string& line : base::split(lines, '\n')) {
    added += indent + line + "\n";
  }
  return text.substr(0, at) + added + text.substr(at);
}

/// The text of a scenario with a parameter of a robot's planner, checked by reading it again. A
/// layout that cannot be kept is written again.
std::optional<std::string> withPlannerParameter(const std::string& text, const std::string& robot,
                                                const std::string& name, const std::string& value) {
  constexpr char kParameters[] = "planner_parameters";
  base::Diagnostics problems;
  const base::YamlNode root = base::parseYaml(text, {}, problems);
  const base::YamlNode* const block = robotBlock(root, robot);
  const base::YamlNode* const given = block != nullptr ? block->find(kParameters) : nullptr;
  std::optional<std::string> changed;
  if (given != nullptr && given->isMap() && given->find(name) != nullptr) {
    changed = sim2d::nav2::withParameter(
        text, {kDesktopNode, robot + "." + kParameters + "." + name, value});
  } else if (given != nullptr) {
    changed = withFirstLine(text, *given, name + ": " + value);
  } else if (block != nullptr) {
    changed = withFirstLine(text, *block, std::string(kParameters) + ":\n  " + name + ": " + value);
  }
  sim2d::ScenarioReading reading = sim2d::readScenarioText(changed.value_or(text), {});
  sim2d::Robot* const read = base::findBy(reading.scenario.robots, &sim2d::Robot::name, robot);
  if (!reading.ok() || read == nullptr) {
    return std::nullopt;
  }
  const auto isIt = [&](const auto& each) { return each.first == name; };
  auto* const now = base::findIf(read->plannerParameters, isIt);
  if (changed && now != nullptr && now->second == value) {
    return changed;
  }
  if (now != nullptr) {
    now->second = value;
  } else {
    read->plannerParameters.emplace_back(name, value);
  }
  return sim2d::writeScenario(reading.scenario);
}

struct FoundController {
  std::string plugin, prefix;
  const std::vector<TuningRange>* ranges = nullptr;
};

/// The first controller with listed parameters.
FoundController controllerIn(const sim2d::nav2::ParameterFile& file, const TuningList& list) {
  const sim2d::nav2::NodeParameters server = file.parametersOf(kControllerServer);
  FoundController found;
  for (const std::string& controller : controllersOf(server)) {
    for (const auto& [plugin, prefix] : pluginsOf(server, controller)) {
      const std::string name = withColons(plugin);
      found.plugin = found.plugin.empty() ? name : found.plugin;
      if (const auto* const ranges = TuningList::find(list.controllers, name)) {
        return {name, prefix, ranges};
      }
    }
  }
  return found;
}

}  // namespace

TunedValues TuneSubject::present() const {
  TunedValues values;
  for (const TunedParameter& parameter : parameters_) {
    values.push_back(parameter.present);
  }
  return values;
}

base::Result<TuneSubject> TuneSubject::open(const std::string& path, const TuningList& list,
                                            const std::vector<std::string>& scenarios,
                                            RunSpec spec) {
  TuneSubject subject;
  subject.path_ = absolutePath(path);
  subject.spec_ = std::move(spec);
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  subject.text_ = *text;
  subject.isNav2_ = sim2d::nav2::looksLikeNav2(*text);
  base::Diagnostics problems;
  for (const std::string& scenario : scenarios) {
    const sim2d::ScenarioReading reading = sim2d::readScenario(scenario);
    if (!subject.isNav2_ && reading.scenario.robots.empty()) {
      problems.push_back(base::error("tune.no-robot", {}, scenario));
    } else if (!subject.isNav2_) {
      subject.robots_[scenario] = reading.scenario.robots.front().name;
    }
  }
  base::append(problems, subject.isNav2_ ? subject.openNav2(list, scenarios.front())
                                         : subject.openPlanner(list));
  if (!base::hasErrors(problems) && subject.parameters_.empty()) {
    problems.push_back(base::error("tune.nothing-to-tune", {subject.controller_}, path));
  }
  return base::resultOf(std::move(subject), std::move(problems));
}

base::Diagnostics TuneSubject::openNav2(const TuningList& list, const std::string& scenario) {
  const auto file = sim2d::nav2::ParameterFile::parse(text_, path_);
  if (!file) {
    return file.diagnostics();
  }
  const FoundController controller = controllerIn(*file, list);
  controller_ = controller.plugin;
  if (controller.ranges == nullptr) {
    return {base::error("tune.unknown-controller", {controller_, list.file}, path_)};
  }
  sim2d::Robot robot;
  robot.planner = sim2d::kNav2Planner;
  robot.nav2Params = {path_};
  robot.nav2Distro =
      spec_.nav2Distro ? sim2d::nav2::distroFromName(*spec_.nav2Distro) : std::nullopt;
  const Nav2ParameterList known = nav2ParameterListOf(robot, scenario);
  base::Diagnostics problems = errorsOf(known.problems);
  for (const TuningRange& range : *controller.ranges) {
    const Nav2Parameter* found =
        parameterOf(known, kControllerServer, controller.prefix + range.name);
    found = found != nullptr ? found : parameterOf(known, "", range.name);
    const auto value = found != nullptr ? base::parseDouble(found->value()) : std::nullopt;
    if (!value) {
      continue;  // not declared in this version, or not a number
    }
    TunedParameter tuned = tunedParameter(range, *value, found->type == "int");
    tuned.node = found->node;
    tuned.name = found->name;
    tuned.present = found->value();
    tuned.fallback = base::parseDouble(found->fallback);
    parameters_.push_back(std::move(tuned));
    if (!textWith(parameters_.size() - 1, text_, parameters_.back().textAt(0.5))) {
      problems.push_back(base::warning("tune.not-writable", {parameters_.back().label()}, path_));
      parameters_.pop_back();
    }
  }
  return problems;
}

base::Diagnostics TuneSubject::openPlanner(const TuningList& list) {
  const sim2d::ScenarioReading reading = sim2d::readScenario(path_);
  if (base::hasErrors(reading.diagnostics)) {
    return reading.diagnostics;
  }
  if (reading.scenario.robots.empty()) {
    return {base::error("tune.no-robot", {}, path_)};
  }
  const sim2d::Robot& robot = reading.scenario.robots.front();
  robot_ = robot.name;
  controller_ = spec_.planner.value_or(robot.planner.value_or("pursuit"));
  const std::vector<TuningRange>* const ranges = TuningList::find(list.planners, controller_);
  const std::shared_ptr<const sim2d::Registries> registries = sharedRegistries();
  const auto* const planner = registries->planners.find(controller_);
  if (ranges == nullptr || planner == nullptr) {
    return {base::error("tune.unknown-planner", {controller_, list.file}, path_)};
  }
  spec_.planner = controller_;
  for (const auto& given : robot.plannerParameters) {
    fixed_.push_back(given);
  }
  base::Diagnostics problems;
  for (const TuningRange& range : *ranges) {
    const auto* const spec =
        base::findBy(planner->parameters, &base::ParameterSpec::key, range.name);
    const auto* const given =
        base::findIf(fixed_, [&](const auto& each) { return each.first == range.name; });
    const double* const fallback = spec != nullptr ? std::get_if<double>(&spec->fallback) : nullptr;
    const auto value = given != nullptr      ? base::parseDouble(given->second)
                       : fallback != nullptr ? std::optional(*fallback)
                                             : std::nullopt;
    if (!value) {
      problems.push_back(
          base::error("tune.unknown-parameter", {range.name, controller_}, list.file));
      continue;
    }
    TunedParameter tuned = tunedParameter(range, *value, false);
    tuned.name = range.name;
    tuned.present = given != nullptr ? given->second : base::formatDouble(*value);
    tuned.fallback = fallback != nullptr ? std::optional(*fallback) : std::nullopt;
    parameters_.push_back(std::move(tuned));
  }
  return problems;
}

RunRequest TuneSubject::request(const std::string& scenario, long long seed,
                                const TunedValues& values) const {
  RunRequest request;
  request.scenario = scenario;
  request.seed = seed;
  request.spec = spec_;
  if (isNav2_) {
    request.spec.planner = sim2d::kNav2Planner;
    request.spec.nav2Params.insert(request.spec.nav2Params.begin(), path_);
  }
  const auto robot = robots_.find(scenario);
  const std::string prefix =
      (robot != robots_.end() ? robot->second : robot_) + ".planner_parameters.";
  if (!isNav2_) {
    for (const auto& [name, value] : fixed_) {
      request.spec.set.push_back(base::join({prefix, name, "=", value}, ""));
    }
  }
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    const TunedParameter& parameter = parameters_[k];
    if (!isNav2_) {
      request.spec.set.push_back(base::join({prefix, parameter.name, "=", values[k]}, ""));
    } else if (values[k] != parameter.present) {
      std::string& added = request.spec.nav2Params.emplace_back(parameter.node);
      added.append(":").append(parameter.name).append(":=").append(values[k]);
    }
  }
  return request;
}

std::optional<std::string> TuneSubject::textWith(std::size_t parameter, const std::string& text,
                                                 const std::string& value) const {
  const TunedParameter& tuned = parameters_[parameter];
  if (isNav2_) {
    return sim2d::nav2::withParameter(text, {tuned.node, tuned.name, value});
  }
  return withPlannerParameter(text, robot_, tuned.name, value);
}

std::optional<std::string> TuneSubject::textWith(const TunedValues& values) const {
  std::optional<std::string> text = text_;
  for (std::size_t k = 0; k < values.size() && text; ++k) {
    if (values[k] != parameters_[k].present) {
      text = textWith(k, *text, values[k]);
    }
  }
  return text;
}

}  // namespace app
