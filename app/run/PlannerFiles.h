#pragma once

#include <optional>
#include <string>
#include <vector>

#include "sim2d/scenario/Scenario.h"

/// Programs, libraries and files that the planners of a scenario's robots name. Those that take
/// part; nothing is started here.
namespace app {

/// Code of others that a robot would start.
struct ForeignCode {
  base::EntityId entity;
  std::string robot;  // its name
  std::string key;    // below the robot's: where it is named
  std::string words;  // as written there: a command, or the file of a library

  friend bool operator==(const ForeignCode& a, const ForeignCode& b) {
    return a.robot == b.robot && a.key == b.key && a.words == b.words;
  }
};
std::vector<ForeignCode> foreignCodeOf(const sim2d::Scenario& scenario);
/// A problem each, at its place in the scenario's file.
base::Diagnostics tellForeignCode(const std::vector<ForeignCode>& code, base::Severity severity,
                                  const std::string& scenarioPath);

/// Where the code lies, as far as files tell: the program, arguments of it that are files (a
/// script), or the library.
std::vector<std::string> filesOf(const ForeignCode& code, const std::string& scenarioPath);
/// The one of them that holds the code: the library, the program, or the script where the program
/// is a usual interpreter. Other arguments may be files that the code itself writes. Nothing: who
/// knows.
std::optional<std::string> codeFileOf(const ForeignCode& code, const std::string& scenarioPath);
/// What planners read: recorded velocities.
std::vector<std::string> filesThatPlannersRead(const sim2d::Scenario& scenario,
                                               const std::string& scenarioPath);
/// Where relative files of planners begin.
std::string folderOfPlanners(const std::string& scenarioPath);

}  // namespace app
