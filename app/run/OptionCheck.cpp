#include "app/run/OptionCheck.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/run/PlannerFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"

namespace app {

namespace {

bool isPlannerKey(const std::string& path) {
  constexpr const char* kKeys[] = {"planner", "command", "planner_parameters", "nav2_params",
                                   "nav2_tree"};
  const std::vector<std::string> keys = base::split(path, '.');
  return keys.front() == "nav2" || std::find_first_of(keys.begin(), keys.end(), std::begin(kKeys),
                                                      std::end(kKeys)) != keys.end();
}

/// Whether a text sets a planner, its parameters or its files. The check of values suffices for
/// numbers.
bool concernsPlanner(const std::string& path, const std::string& text) {
  if (base::parseDouble(text)) {
    return false;
  }
  base::Diagnostics ignored;  // reported by the check of values
  const base::YamlNode node = base::parseYaml(text, {}, ignored);
  return isPlannerKey(path) ||
         (node.isMap() && std::any_of(node.items.begin(), node.items.end(),
                                      [](const auto& item) { return isPlannerKey(item.key); }));
}

bool isAmong(const base::Diagnostics& problems, const base::Diagnostic& problem) {
  return std::any_of(problems.begin(), problems.end(), [&](const base::Diagnostic& other) {
    return other.code == problem.code && other.values == problem.values;
  });
}

}  // namespace

OptionCheck::OptionCheck(const Experiment& experiment) : experiment_(experiment) {
  for (std::size_t k = 0; k < experiment.values.size(); ++k) {
    const ExperimentValue& value = experiment.values[k];
    for (const std::size_t text : value.representativeTexts()) {
      if (concernsPlanner(value.path, value.texts[text])) {
        options_.push_back({k, text});
      }
    }
  }
}

base::Diagnostics OptionCheck::errorsIn(std::size_t scenario, const base::Diagnostics& usual,
                                        BundleReader& reader) {
  const std::size_t runs = experiment_.runCount() / experiment_.scenarios.size();
  const RunSpec first = experiment_.specOf(scenario * runs);
  const std::string folder = plannerFolderOf(first.scenario);
  base::Diagnostics found;
  for (Option& option : options_) {
    const ExperimentValue& value = experiment_.values[option.value];
    RunSpec spec = first;
    spec.set[option.value] = value.path + "=" + value.texts[option.text];
    if (option.isWrong || option.folders.count(folder) != 0 || spec.set == first.set) {
      continue;
    }
    const Verdict verdict = check(reader.readToCheck(spec));
    base::Diagnostics errors = errorsOf(verdict.wrongOptions);
    base::append(errors, errorsOf(verdict.problems));
    const auto own = std::find_if_not(errors.begin(), errors.end(),
                                      [&](const auto& error) { return isAmong(usual, error); });
    option.isWrong = own != errors.end();
    if (option.isWrong) {
      found.push_back(atOption(option, spec.scenario, *own));
    } else if (errors.empty()) {  // the scenario's own errors may conceal others
      option.folders.insert(folder);
    }
  }
  return found;
}

/// The message keeps the place that the problem had in another file than the scenario.
base::Diagnostic OptionCheck::atOption(const Option& option, const std::string& scenarioPath,
                                       base::Diagnostic problem) const {
  if (!problem.file.empty() && problem.file != scenarioPath) {
    std::string where = problem.file;
    if (problem.line > 0) {
      where += ":" + std::to_string(problem.line);
    }
    problem = base::withContext(where, std::move(problem));
  }
  problem.file = experiment_.path;
  problem.line = problem.column = 0;
  base::Diagnostics ignored;  // it has been read before
  const base::YamlNode root = base::parseYaml(experiment_.text, {}, ignored);
  const base::YamlNode* const values = root.find("values");
  const ExperimentValue& value = experiment_.values[option.value];
  const base::YamlNode* const node = values != nullptr ? values->find(value.path) : nullptr;
  return node != nullptr ? located(nodeOfText(value, option.text, *node), std::move(problem))
                         : problem;
}

}  // namespace app
