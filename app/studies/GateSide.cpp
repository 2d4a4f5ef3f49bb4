#include "app/studies/GateSide.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/SystemError.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using SideKind = GateSide::Kind;

bool isFile(const std::string& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool isYaml(const fs::path& path) {
  return path.extension() == ".yaml" || path.extension() == ".yml";
}

/// Whether a YAML file has the node of a scenario.
base::Result<bool> isScenarioFile(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  base::Diagnostics problems;
  const base::YamlNode root = base::parseYaml(*text, path, problems);
  if (base::hasErrors(problems)) {
    return problems;
  }
  return root.find("hunav_loader") != nullptr || root.find("hunavsim_desktop") != nullptr;
}

base::Result<GateSide> sideOfFolder(GateSide side) {
  std::error_code error;
  base::Diagnostics problems;
  for (fs::directory_iterator at(side.text, error), end; !error && at != end; at.increment(error)) {
    if (!isYaml(at->path())) {
      continue;
    }
    const base::Result<bool> isScenario = isScenarioFile(at->path().string());
    base::append(problems, isScenario.diagnostics());
    if (isScenario && *isScenario) {
      side.scenarios.emplace_back(at->path().stem().string(), absolutePath(at->path().string()));
    }
  }
  if (error) {
    problems.push_back(
        base::error("file.cannot-read", {base::systemErrorMessage(error)}, side.text));
  } else if (side.scenarios.empty() && problems.empty()) {
    problems.push_back(base::error("gate.no-scenarios-in-folder", {}, side.text));
  }
  std::sort(side.scenarios.begin(), side.scenarios.end());
  side.kind = SideKind::Scenarios;
  return base::resultOf(std::move(side), std::move(problems));
}

base::Result<GateSide> sideOfFile(GateSide side) {
  const fs::path path(side.text);
  side.value = absolutePath(side.text);
  if (path.extension() == ".xml") {
    side.kind = SideKind::Nav2Tree;
  } else if (path.extension() == ".so") {
    side.kind = SideKind::Library;
  } else if (isYaml(path)) {
    const base::Result<bool> isScenario = isScenarioFile(side.text);
    if (!isScenario) {
      return isScenario.diagnostics();
    }
    side.kind = *isScenario ? SideKind::Scenarios : SideKind::Nav2Params;
    if (*isScenario) {
      side.scenarios.emplace_back(path.stem().string(), side.value);
    }
  } else {
    const base::Result<std::string> program = sim2d::resolveExecutable(side.value);
    if (!program) {
      return program.diagnostics();
    }
    side.kind = SideKind::Program;
    side.value = "\"" + side.value + "\"";
  }
  return side;
}

/// A command line with absolute paths of files; nullopt: its program does not exist.
std::optional<std::string> commandOf(const std::string& text) {
  const auto words = sim2d::splitCommandLine(text);
  if (!words || !sim2d::resolveExecutable(words->front())) {
    return std::nullopt;
  }
  std::vector<std::string> quoted;
  for (const std::string& word : *words) {
    std::string out = "\"";
    for (const char c : isFile(word) ? absolutePath(word) : word) {
      out +=
          c == '"' || c == '\\' || c == '$' || c == '`' ? std::string("\\") + c : std::string(1, c);
    }
    quoted.push_back(out + "\"");
  }
  return base::join(quoted, " ");
}

bool isShippedNav2File(const std::string& name) {
  const std::string path = pathIn(shippedResources("nav2_params"), name);
  return isFile(path) || isFile(path + ".yaml");
}

std::string firstRobotOf(const std::string& scenario) {
  const sim2d::ScenarioReading reading = sim2d::readScenario(scenario);
  const auto* const robot = base::findBy(reading.scenario.robots, &sim2d::Robot::listed, true);
  return robot != nullptr ? robot->name : "robot1";
}

/// As a YAML scalar with quotes.
std::string quotedYaml(const std::string& text) {
  return nlohmann::json(text).dump();
}

}  // namespace

base::Result<GateSide> gateSideOf(const std::string& text) {
  GateSide side;
  side.text = side.value = text;
  std::error_code ignored;
  if (fs::is_directory(text, ignored)) {
    return sideOfFolder(std::move(side));
  }
  if (isFile(text)) {
    return sideOfFile(std::move(side));
  }
  const RunOption::Names planners = knownPlanners();
  const std::string shipped = scenarioFile(text);
  if (std::find(planners.begin(), planners.end(), text) != planners.end()) {
    side.kind = SideKind::Planner;
  } else if (sim2d::nav2::parameterOverride(text) || isShippedNav2File(text)) {
    side.kind = SideKind::Nav2Params;
  } else if (shipped != text) {
    side.kind = SideKind::Scenarios;
    side.scenarios.emplace_back(text, shipped);
  } else if (const std::optional<std::string> command = commandOf(text)) {
    side.kind = SideKind::Program;
    side.value = *command;
  } else if (text.find('=') != std::string::npos && text.front() != '=') {
    side.kind = SideKind::Value;
  } else {
    return base::error("gate.unknown-side", {text, base::nearestName(text, planners)});
  }
  return side;
}

namespace {

/// The scenarios of both sides by name.
base::Result<std::vector<GateScenario>> matchedScenarios(const GateSide& base,
                                                         const GateSide& candidate) {
  if (base.scenarios.size() == 1 && candidate.scenarios.size() == 1) {
    return std::vector<GateScenario>{{base.scenarios.front().first, base.scenarios.front().second,
                                      candidate.scenarios.front().second}};
  }
  std::vector<GateScenario> found;
  base::Diagnostics problems;
  const auto require = [&problems](const GateSide& in, const std::string& name) {
    const auto* const path =
        base::findBy(in.scenarios, &std::pair<std::string, std::string>::first, name);
    if (path == nullptr) {
      problems.push_back(base::error("gate.unmatched", {name}, in.text));
    }
    return path;
  };
  for (const auto& [name, path] : base.scenarios) {
    if (const auto* const other = require(candidate, name)) {
      found.push_back({name, path, other->second});
    }
  }
  for (const auto& [name, path] : candidate.scenarios) {
    require(base, name);
  }
  return base::resultOf(std::move(found), std::move(problems));
}

base::Result<std::vector<GateScenario>> selectedScenarios(std::vector<GateScenario> all,
                                                          const std::vector<std::string>& named) {
  std::vector<GateScenario> found;
  std::vector<std::string> names;
  base::Diagnostics problems;
  names.reserve(all.size());
  for (const GateScenario& each : all) {
    names.push_back(each.name);
  }
  for (const std::string& name : named) {
    if (const auto* const scenario = base::findBy(all, &GateScenario::name, name)) {
      found.push_back(*scenario);
    } else {
      problems.push_back(
          base::error("gate.unknown-scenario", {name, base::nearestName(name, names)}));
    }
  }
  return base::resultOf(named.empty() ? std::move(all) : std::move(found), std::move(problems));
}

}  // namespace

base::Result<std::vector<GateScenario>> gateScenarios(const GateSide& base,
                                                      const GateSide& candidate,
                                                      const std::vector<std::string>& named) {
  const bool hasBase = base.kind == SideKind::Scenarios;
  if (hasBase != (candidate.kind == SideKind::Scenarios)) {
    return base::error("gate.mixed", {hasBase ? candidate.text : base.text});
  }
  if (hasBase) {
    base::Result<std::vector<GateScenario>> all = matchedScenarios(base, candidate);
    return all ? selectedScenarios(*std::move(all), named) : all;
  }
  if (named.empty()) {
    return base::error("gate.no-scenarios");
  }
  const base::Result<std::vector<std::string>> paths = scenarioFiles(named);
  if (!paths) {
    return paths.diagnostics();
  }
  std::vector<GateScenario> found;
  for (const std::string& path : *paths) {
    found.push_back({fs::path(path).stem().string(), path, path});
  }
  return found;
}

RunSpec specOfSide(const GateSide& side, RunSpec common, const std::string& scenario) {
  switch (side.kind) {
    case SideKind::Planner:
      common.planner = side.value;
      break;
    case SideKind::Nav2Params:
      common.planner = common.planner.value_or("nav2");
      common.nav2Params.push_back(side.value);
      break;
    case SideKind::Nav2Tree:
      common.planner = common.planner.value_or("nav2");
      common.nav2Tree = side.value;
      break;
    case SideKind::Program:
      common.planner = sim2d::kExternalPlanner;
      common.set.push_back(firstRobotOf(scenario) + ".command=" + quotedYaml(side.value));
      break;
    case SideKind::Library:
      common.planner = sim2d::kLibraryPlanner;
      common.set.push_back(firstRobotOf(scenario) +
                           ".planner_parameters.file=" + quotedYaml(side.value));
      break;
    case SideKind::Value:
      common.set.push_back(side.value);
      break;
    case SideKind::Scenarios:
      break;
  }
  return common;
}

}  // namespace app
