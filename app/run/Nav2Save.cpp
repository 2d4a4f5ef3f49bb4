#include "app/run/Nav2Save.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "app/run/Nav2Robots.h"
#include "app/run/PlannerFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/nav/nav2/params/ParameterFile.h"
#include "sim2d/nav/nav2/params/ParameterPatch.h"

namespace app {

namespace {

/// The files that the robot reads, in their order.
bt::Nav2Loaded filesOf(const sim2d::Robot& robot, const std::string& scenarioPath) {
  return bt::loadNav2Parameters(
      {robot.nav2Params, robot.nav2Tree.value_or(""), robot.nav2Distro, robot.nav2Values},
      plannerFolderOf(scenarioPath), robot.name, shippedNav2Folders());
}

/// ROS 2 does not accept an integer for a double.
std::string typedValue(const Nav2Parameter& parameter) {
  const std::string& yaml = *parameter.given;
  const bool isInteger = yaml.find_first_not_of("+-0123456789") == std::string::npos;
  return parameter.type == "double" && isInteger ? yaml + ".0" : yaml;
}

/// Replaces the last file among the entries; without a file the shipped one was read.
void nameFile(std::vector<std::string>& entries, const std::string& entry) {
  const auto last = std::find_if(entries.rbegin(), entries.rend(), [](const std::string& each) {
    return !sim2d::nav2::parameterOverride(each);
  });
  if (last == entries.rend()) {
    entries.insert(entries.begin(), entry);
  } else {
    *last = entry;
  }
}

/// The values in effect, by path.
std::map<std::string, std::string> effectiveValues(const bt::Nav2Loaded& loaded) {
  std::map<std::string, std::string> values;
  for (const sim2d::nav2::EffectiveKey& key : loaded.parameters.notes.known) {
    values[key.path] = key.value;
  }
  return values;
}

/// Whether two values are equal as texts or as numbers: a file needs 1.0 for a double, the scenario
/// also accepts 1.
bool areEqual(const std::string& a, const std::string& b) {
  const std::optional<double> first = base::parseDouble(a);
  const std::optional<double> second = base::parseDouble(b);
  return a == b || (first && second && *first == *second);
}

/// Gives back the values that have no effect in the file.
void keepIneffective(const bt::Nav2Loaded& before, const Nav2ParameterList& list,
                     const std::string& scenarioPath, SavedNav2Parameters& saved) {
  const auto wanted = effectiveValues(before);
  const auto now = effectiveValues(filesOf(saved.robot, scenarioPath));
  for (const Nav2Parameter& parameter : list.parameters) {
    const std::string path = parameter.node + "." + parameter.name;
    const auto found = now.find(path);
    const bool isEffective = found != now.end() && areEqual(found->second, wanted.at(path));
    const bool isKept =
        std::find(saved.kept.begin(), saved.kept.end(), parameter.path) != saved.kept.end();
    if (parameter.given && !isKept && !isEffective) {
      saved.robot = withNav2Value(std::move(saved.robot), parameter, parameter.given);
      saved.kept.push_back(parameter.path);
    }
  }
}

}  // namespace

base::Result<SavedNav2Parameters> saveNav2Parameters(const sim2d::Robot& robot,
                                                     const std::string& scenarioPath,
                                                     const std::string& path,
                                                     const std::string& entry) {
  const bt::Nav2Loaded files = filesOf(robot, scenarioPath);
  if (files.paramsFiles.empty()) {
    return files.problems;
  }
  base::Result<std::string> text = base::readTextFile(files.paramsFiles.back());
  if (!text) {
    return text.diagnostics();
  }
  const Nav2ParameterList list = nav2ParameterListOf(robot, scenarioPath);
  SavedNav2Parameters saved{robot, {}};
  for (const Nav2Parameter& parameter : list.parameters) {
    if (!parameter.given) {
      continue;
    }
    if (auto patched = sim2d::nav2::withParameter(
            *text, {parameter.node, parameter.name, typedValue(parameter)}, robot.name)) {
      *text = *std::move(patched);
      saved.robot = withNav2Value(std::move(saved.robot), parameter, std::nullopt);
    } else {
      saved.kept.push_back(parameter.path);
    }
  }
  if (base::Diagnostics problems = base::writeFileAtomically(path, *text); !problems.empty()) {
    return problems;
  }
  nameFile(saved.robot.nav2Params, entry);
  keepIneffective(files, list, scenarioPath, saved);
  return saved;
}

}  // namespace app
