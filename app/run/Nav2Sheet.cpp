#include <algorithm>
#include <map>
#include <utility>

#include "app/run/Nav2Robots.h"
#include "app/run/PlannerFiles.h"
#include "sim2d/base/Text.h"

// Parameters of Nav2 as a form shows and changes them.
namespace app {

namespace {

using sim2d::nav2::KnownKey;

bt::Nav2Loaded sheetLoaded(const sim2d::Robot& robot, const std::string& scenarioPath) {
  const sim2d::Nav2Choice choice{robot.nav2Params, robot.nav2Tree.value_or(""), robot.nav2Distro,
                                 robot.nav2Values};
  return bt::loadNav2Parameters(choice, folderOfPlanners(scenarioPath), robot.name, shippedNav2());
}

std::string withoutNode(const KnownKey& key) {
  return key.path.substr(key.node.size() + 1);
}

bool names(const std::string& given, const Nav2Parameter& parameter) {
  return given == parameter.path || given == parameter.node + "." + parameter.name;
}

}  // namespace

Nav2Sheet nav2SheetOf(const sim2d::Robot& robot, const std::string& scenarioPath) {
  Nav2Sheet sheet;
  const bt::Nav2Loaded now = sheetLoaded(robot, scenarioPath);
  sheet.file = base::join(now.paramsFiles, ", ");
  sheet.problems = now.problems;
  sim2d::Robot plain = robot;
  plain.nav2Values.clear();
  std::map<std::string, std::string> filed;  // by path
  const bt::Nav2Loaded before = sheetLoaded(plain, scenarioPath);
  for (const KnownKey& key : before.parameters.notes.known) {
    if (key.isGiven) {
      filed.emplace(key.path, key.value);
    }
  }
  std::map<std::string, int> uses;  // of a name, by nodes
  for (const KnownKey& key : now.parameters.notes.known) {
    ++uses[withoutNode(key)];
  }
  for (const KnownKey& key : now.parameters.notes.known) {
    Nav2Parameter& parameter = sheet.parameters.emplace_back();
    parameter.node = key.node;
    parameter.name = withoutNode(key);
    parameter.path = uses[parameter.name] == 1 ? parameter.name : key.path;
    parameter.type = key.type;
    parameter.unit = key.unit;
    parameter.meaning = key.meaning;
    parameter.fallback = key.fallback;
    if (const auto found = filed.find(key.path); found != filed.end()) {
      parameter.filed = found->second;
    }
    for (const auto& [path, yaml] : robot.nav2Values) {
      parameter.given = names(path, parameter) ? std::optional(yaml) : parameter.given;
    }
  }
  return sheet;
}

sim2d::Robot withNav2Value(sim2d::Robot robot, const Nav2Parameter& parameter,
                           std::optional<std::string> yaml) {
  sim2d::ParameterTexts& values = robot.nav2Values;
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const auto& each) { return names(each.first, parameter); });
  if (!yaml) {
    values.erase(std::remove_if(values.begin(), values.end(),
                                [&](const auto& each) { return names(each.first, parameter); }),
                 values.end());
  } else if (found != values.end()) {
    found->second = *std::move(yaml);
  } else {
    values.emplace_back(parameter.path, *std::move(yaml));
  }
  return robot;
}

std::string nav2ValueProblem(const sim2d::Robot& robot, const std::string& scenarioPath,
                             const Nav2Parameter& parameter, const std::string& yaml) {
  const bt::Nav2Loaded before = sheetLoaded(robot, scenarioPath);
  const bt::Nav2Loaded after = sheetLoaded(withNav2Value(robot, parameter, yaml), scenarioPath);
  for (const base::Diagnostics* const found : {&after.wrongValues, &after.problems}) {
    const base::Diagnostics& old = found == &after.problems ? before.problems : before.wrongValues;
    for (const base::Diagnostic& problem : *found) {
      const bool isNew = std::none_of(old.begin(), old.end(), [&](const base::Diagnostic& each) {
        return each.code == problem.code && each.values == problem.values;
      });
      if (problem.severity == base::Severity::Error && isNew) {
        return problem.message;
      }
    }
  }
  return {};
}

}  // namespace app
