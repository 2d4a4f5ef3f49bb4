#include "app/run/PlannerFiles.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "sim2d/base/Text.h"
#include "sim2d/nav/Planner.h"
#include "sim2d/nav/external/CommandLine.h"
#include "sim2d/nav/external/ExternalProcess.h"
#include "sim2d/scenario/ResolvedValues.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kFileParameter = "file";
constexpr const char* kFileKey = "planner_parameters.file";
constexpr const char* kReplayPlanner = "replay";

std::string plannerOf(const sim2d::Robot& robot) {
  return robot.planner.value_or(sim2d::ResolvedRobot{}.planner);
}

/// Empty if none is given.
std::string fileTextOf(const sim2d::Robot& robot) {
  for (const auto& [key, yaml] : robot.plannerParameters) {
    if (key == kFileParameter) {
      return base::scalarText(yaml);
    }
  }
  return {};
}

std::string relativeToScenario(const std::string& file, const std::string& scenarioPath) {
  return (fs::path(plannerFolderOf(scenarioPath)) / file).lexically_normal().string();
}

std::vector<std::string> filesOfCommand(const std::string& command) {
  const auto words = sim2d::splitCommandLine(command);
  if (sim2d::ExternalProcess::isSocket(command) || !words) {
    return {};
  }
  std::vector<std::string> files;
  if (const auto program = sim2d::resolveExecutable(words->front())) {
    files.push_back(*program);
  }
  std::error_code ignored;
  for (std::size_t i = 1; i < words->size(); ++i) {
    if (fs::is_regular_file((*words)[i], ignored)) {
      files.push_back((*words)[i]);
    }
  }
  return files;
}

/// An interpreter or a command that runs another program: "/usr/bin/python3.11".
bool isLauncher(const std::string& program) {
  constexpr std::string_view kNames[] = {
      "python", "pypy",    "sh",      "bash", "dash",    "zsh",    "perl",  "ruby",
      "node",   "java",    "lua",     "R",    "julia",   "env",    "nice",  "timeout",
      "stdbuf", "taskset", "setarch", "ros",  "Rscript", "octave", "nodejs"};
  std::string name = fs::path(program).filename().string();
  name.erase(name.find_last_not_of("0123456789.") + 1);  // version suffix
  return std::find(std::begin(kNames), std::end(kNames), name) != std::end(kNames);
}

}  // namespace

std::string plannerFolderOf(const std::string& scenarioPath) {
  return fs::path(scenarioPath).parent_path().string();
}

std::vector<ExternalCode> externalCodeOf(const sim2d::Scenario& scenario) {
  std::vector<ExternalCode> code;
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    const std::string planner = plannerOf(robot);
    const std::string command = robot.command.value_or("");
    const std::string file = fileTextOf(robot);
    if (planner == sim2d::kExternalPlanner && !base::trimmed(command).empty()) {
      code.push_back({robot.key, robot.name, kCommandKey, command});
    } else if (planner == sim2d::kLibraryPlanner && !file.empty()) {
      code.push_back({robot.key, robot.name, kFileKey, file});
    }
  });
  return code;
}

base::Diagnostics externalCodeProblems(const std::vector<ExternalCode>& code,
                                       base::Severity severity, const std::string& scenarioPath) {
  base::Diagnostics all;
  for (const ExternalCode& each : code) {
    base::Diagnostics problems = {base::problem(
        severity, "code.not-allowed",
        {each.robot, sim2d::printableText(each.words, each.words.size())}, scenarioPath)};
    problems.front().entity = each.entity;
    const std::string robot = "hunavsim_desktop.ros__parameters." + each.robot;
    sim2d::addKeyLocation(problems, scenarioPath,
                          {robot + "." + each.key, robot + ".planner", robot});
    base::append(all, problems);
  }
  return all;
}

std::vector<std::string> filesOf(const ExternalCode& code, const std::string& scenarioPath) {
  if (code.key == kCommandKey) {
    return filesOfCommand(code.words);
  }
  return {relativeToScenario(code.words, scenarioPath)};
}

std::optional<std::string> codeFileOf(const ExternalCode& code, const std::string& scenarioPath) {
  const std::vector<std::string> files = filesOf(code, scenarioPath);
  const auto found = std::find_if_not(files.begin(), files.end(), isLauncher);
  return found == files.end() ? std::nullopt : std::optional(*found);
}

std::vector<std::string> filesNamedBy(const sim2d::Robot& robot) {
  std::vector<std::string> names;
  for (const std::string& file : robot.nav2Params) {
    if (file.find(":=") == std::string::npos) {
      names.push_back(file);
    }
  }
  for (const std::string& file : {robot.nav2Tree.value_or(""), fileTextOf(robot)}) {
    if (!file.empty()) {
      names.push_back(file);
    }
  }
  return names;
}

std::vector<std::string> filesThatPlannersRead(const sim2d::Scenario& scenario,
                                               const std::string& scenarioPath) {
  std::vector<std::string> files;
  sim2d::forEachListed(scenario.robots, [&](const sim2d::Robot& robot) {
    const std::string file = fileTextOf(robot);
    const std::string planner = plannerOf(robot);
    const bool isReader = planner == kReplayPlanner || planner == sim2d::kOnnxPlanner;
    if (isReader && !file.empty()) {
      files.push_back(relativeToScenario(file, scenarioPath));
    }
  });
  return files;
}

}  // namespace app
