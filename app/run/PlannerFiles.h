#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/scenario/Scenario.h"

/// Programs, libraries and files that the planners of a scenario's listed robots name. Starts
/// nothing.
namespace app {

constexpr const char* kCommandKey = "command";  // ExternalCode::key of a program

/// External code that a robot would start.
struct ExternalCode {
  base::EntityId entity;
  std::string robot;  // its name
  std::string key;    // below the robot's key: where the code is named
  std::string words;  // as written there: a command, or a library file

  friend bool operator==(const ExternalCode& a, const ExternalCode& b) {
    return a.robot == b.robot && a.key == b.key && a.words == b.words;
  }
};
std::vector<ExternalCode> externalCodeOf(const sim2d::Scenario& scenario);
/// One problem each, located in the scenario file.
base::Diagnostics externalCodeProblems(const std::vector<ExternalCode>& code,
                                       base::Severity severity, const std::string& scenarioPath);

/// The files of the code, as far as known: the program and arguments that are files (a script), or
/// the library.
std::vector<std::string> filesOf(const ExternalCode& code, const std::string& scenarioPath);
/// The file that contains the code: the library, the program, or the script if the program is a
/// common interpreter. Other arguments may be files that the code itself writes. nullopt if
/// unknown.
std::optional<std::string> codeFileOf(const ExternalCode& code, const std::string& scenarioPath);
/// Files that planners read: recorded velocities, learned policies.
std::vector<std::string> filesThatPlannersRead(const sim2d::Scenario& scenario,
                                               const std::string& scenarioPath);
/// The file names of a robot as written in the scenario: parameter files, trees, `file`.
std::vector<std::string> filesNamedBy(const sim2d::Robot& robot);
/// The folder that relative paths of planners refer to.
std::string plannerFolderOf(const std::string& scenarioPath);

}  // namespace app
