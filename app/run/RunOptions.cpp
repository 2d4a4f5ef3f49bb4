#include "app/run/RunOptions.h"

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "app/run/ProgramRegistries.h"
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

/// The first that takes part; null: none does.
sim2d::Robot* firstRobot(sim2d::Scenario& scenario) {
  const auto found = std::find_if(scenario.robots.begin(), scenario.robots.end(),
                                  [](const sim2d::Robot& robot) { return robot.listed; });
  return found == scenario.robots.end() ? nullptr : &*found;
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

/// A file as the scenario would have to name it: relative ones begin there, not where the program
/// was started. Names of shipped files stay.
std::string fromHere(const std::string& file) {
  std::error_code none;
  return std::filesystem::exists(file, none) ? std::filesystem::absolute(file, none).string()
                                             : file;
}

const sim2d::Field<sim2d::DesktopSettings>& collisionField() {
  return *sim2d::fieldOf<sim2d::DesktopSettings>("stop_on_collision");
}

base::Diagnostics checkNames(const RunOptions& options) {
  base::Diagnostics wrong;
  const auto check = [&wrong](const char* option, const std::optional<std::string>& name,
                              const std::vector<std::string>& known) {
    if (name && std::find(known.begin(), known.end(), *name) == known.end()) {
      wrong.push_back(base::error("option.unknown-name", {option, *name, base::join(known, ", ")}));
    }
  };
  const sim2d::Registries registries = programRegistries();
  check("--stop-on-collision", options.stopOnCollision, collisionField().spec.choices);
  check("--model", options.model, registries.models.names());
  check("--planner", options.planner, registries.planners.names());
  check("--robot", options.robot, registries.robotTypes.names());
  check("--nav2-distro", options.nav2Distro,
        sim2d::fieldOf<sim2d::Robot>("nav2_distro")->spec.choices);
  return wrong;
}

/// What is wrong with the words of the command line (exit code 64).
base::Diagnostics checkOptions(const RunOptions& options) {
  base::Diagnostics wrong = checkNames(options);
  const auto want = [&wrong](bool isFine, const char* code, base::ProblemValues values = {}) {
    if (!isFine) {
      wrong.push_back(base::error(code, std::move(values)));
    }
  };
  const std::string start = options.robotStart.value_or("0 0 0");
  const std::string goal = options.robotGoal.value_or("0 0");
  const double duration = options.duration.value_or(1.0), dt = options.dt.value_or(0.05);
  want(parseNumbers(start, 3).has_value(), "option.robot-start", {start});
  want(parseNumbers(goal, 2).has_value(), "option.robot-goal", {goal});
  want(options.seed.value_or(0) >= 0, "option.seed");
  want(duration > 0.0 && duration <= 1e6, "option.duration");
  const double stuckAfter = options.stuckAfter.value_or(0.0);
  want(stuckAfter >= 0.0 && stuckAfter <= 1e6, "option.stuck-after");
  want(dt >= 0.001 && dt <= 0.1, "option.dt");
  want(options.recordEvery.value_or(1) >= 1, "option.record-every");
  want(options.threads >= 1 && options.threads <= 256, "option.threads");
  for (const std::string& pair : options.set) {
    const std::size_t equals = pair.find('=');
    want(equals != std::string::npos && equals != 0, "option.set", {pair});
  }
  return wrong;
}

/// Single values alone are put over the files of the scenario.
void takeNav2Params(const std::vector<std::string>& given, sim2d::Robot& robot) {
  const auto isSingle = [](const std::string& entry) {
    return sim2d::nav2::parameterOverride(entry).has_value();
  };
  if (!std::all_of(given.begin(), given.end(), isSingle)) {
    robot.nav2Params.clear();
  }
  for (const std::string& entry : given) {
    robot.nav2Params.push_back(isSingle(entry) ? entry : fromHere(entry));
  }
}

base::Diagnostics applyRobot(sim2d::Scenario& scenario, const RunOptions& options) {
  const bool hasNav2 =
      !options.nav2Params.empty() || options.nav2Tree || options.nav2Distro || options.nav2Body;
  if (!options.robotStart && !options.robotGoal && !options.robot && !options.planner && !hasNav2) {
    return {};
  }
  sim2d::Robot* const present = firstRobot(scenario);
  if (present == nullptr && !options.robotStart) {
    return {base::error("option.no-robot", {}, options.scenario)};
  }
  base::Diagnostics wrong = checkOptions(options);
  if (!wrong.empty()) {
    return wrong;
  }
  sim2d::Robot& robot = present != nullptr ? *present : addRobot(scenario);
  if (options.robotStart) {
    const std::vector<double> pose = *parseNumbers(*options.robotStart, 3);
    robot.start = {{pose[0], pose[1]}, base::wrapToPi(pose[2])};
  }
  if (options.robotGoal) {
    const std::vector<double> point = *parseNumbers(*options.robotGoal, 2);
    robot.goal = sim2d::RobotGoal{};
    robot.goal.point = sim2d::Vec2(point[0], point[1]);
  }
  if (options.robot) {
    robot.type = options.robot;
  }
  if (options.planner) {
    robot.planner = options.planner;
  }
  if (hasNav2 && robot.planner != sim2d::kNav2Planner) {
    return {base::error("option.nav2-without-planner")};
  }
  takeNav2Params(options.nav2Params, robot);
  robot.nav2Body = options.nav2Body ? std::optional(true) : robot.nav2Body;
  robot.nav2Tree = options.nav2Tree ? fromHere(*options.nav2Tree) : robot.nav2Tree;
  if (options.nav2Distro) {
    sim2d::fieldOf<sim2d::Robot>("nav2_distro")->assign(robot, *options.nav2Distro);
  }
  return {};
}

}  // namespace

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

base::Result<RunSettings> runSettingsOf(const RunOptions& options) {
  base::Diagnostics wrong = checkOptions(options);
  const base::Result<sim2d::Compatibility> compatibility =
      options.compat.empty() ? base::Result<sim2d::Compatibility>(sim2d::Compatibility())
                             : sim2d::Compatibility::parse(options.compat);
  base::append(wrong, compatibility.diagnostics());
  if (base::hasErrors(wrong)) {
    return wrong;
  }
  const sim2d::CodeUse code = options.allowCode ? sim2d::CodeUse::Allowed : sim2d::CodeUse::Refused;
  return {RunSettings{*compatibility, options.threads, options.exact, options.strict, code},
          std::move(wrong)};
}

base::Diagnostics applyOptions(sim2d::Scenario& scenario, const RunOptions& options,
                               const sim2d::Compatibility& compatibility) {
  base::Diagnostics problems;
  if (firstRobot(scenario) == nullptr && options.robotStart) {
    applyRobot(scenario, options);  // so that --set finds it; what is wrong is told below
  }
  if (sim2d::Robot* const robot = firstRobot(scenario); robot != nullptr && options.planner) {
    robot->planner = options.planner;  // `nav2.…` is of robots that it drives
  }
  for (const std::string& pair : options.set) {
    const std::size_t equals = pair.find('=');
    base::append(problems,
                 sim2d::setValue(scenario, pair.substr(0, equals), pair.substr(equals + 1)));
  }
  sim2d::DesktopSettings& desktop = scenario.desktop;
  if (compatibility.hunav2()) {
    desktop.route = sim2d::Route::Direct;
    desktop.model = "sfm-hunav2";
  }
  desktop.seed = options.seed ? options.seed : desktop.seed;
  desktop.duration = options.duration ? options.duration : desktop.duration;
  desktop.stuckAfter = options.stuckAfter ? options.stuckAfter : desktop.stuckAfter;
  if (options.stopOnCollision) {
    collisionField().assign(desktop, *options.stopOnCollision);
  }
  desktop.dt = options.dt ? options.dt : desktop.dt;
  desktop.model = options.model ? options.model : desktop.model;
  desktop.recordEvery = options.recordEvery ? options.recordEvery : desktop.recordEvery;
  base::append(problems, applyRobot(scenario, options));
  return problems;
}

}  // namespace app
