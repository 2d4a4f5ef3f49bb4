#include "app/run/ExperimentCheck.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <set>
#include <string_view>
#include <utility>

#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

using base::YamlNode;

const sim2d::Robot* firstRobotOf(const sim2d::Scenario& scenario) {
  const auto& robots = scenario.robots;
  const auto found = std::find_if(robots.begin(), robots.end(),
                                  [](const sim2d::Robot& robot) { return robot.listed; });
  return found == robots.end() ? nullptr : &*found;
}

/// Whether one of the texts of a value is the map of a whole robot with this key.
bool isInMap(const ExperimentValue& value, const sim2d::Scenario& scenario, const char* key) {
  return std::any_of(value.texts.begin(), value.texts.end(), [&](const std::string& text) {
    sim2d::Scenario changed = scenario;
    const bool isTaken = !base::hasErrors(sim2d::setValue(changed, value.path, text));
    const sim2d::Robot* const robot = firstRobotOf(changed);
    return isTaken && robot != nullptr &&
           sim2d::fieldOf<sim2d::Robot>(key)->value(*robot) != base::ParameterValue();
  });
}

/// Whether a value sets what an option of all runs sets.
bool isSetBy(const RunOption& option, const ExperimentValue& value,
             const sim2d::Scenario& scenario) {
  if (option.setting != nullptr) {
    return value.path == option.setting;
  }
  const sim2d::Robot* const robot = firstRobotOf(scenario);
  return option.robotSetting != nullptr && robot != nullptr &&
         (value.path == robot->name + "." + option.robotSetting ||
          (value.path == robot->name && isInMap(value, scenario, option.robotSetting)));
}

/// Tries the values one after the other, and says what is wrong with them.
class ValueCheck {
 public:
  ValueCheck(const Experiment& experiment, std::vector<ExperimentTrial>& trials)
      : experiment_(experiment), trials_(trials) {}

  void check(std::size_t value, const YamlNode& node) {
    if (isToldTwice(experiment_.values[value], node)) {
      return;  // whatever they are
    }
    value_ = value;
    toldOfPath_.clear();
    tryTexts(node);
  }
  base::Diagnostics takeProblems() { return std::move(problems_); }

 private:
  bool isToldTwice(const ExperimentValue& value, const YamlNode& node) {
    const auto tell = [&](base::Diagnostic problem) {
      problems_.push_back(located(base::keyNode(node), std::move(problem)));
      return true;
    };
    if (value.path == "seed") {
      return tell(base::error("experiment.seed-as-value"));
    }
    for (const RunOption& option : kRunOptions) {
      const auto isSet = [&](const ExperimentTrial& trial) {
        return isSetBy(option, value, trial.scenario());
      };
      if (option.isGiven(experiment_.common) &&
          std::any_of(trials_.begin(), trials_.end(), isSet)) {
        return tell(base::error("experiment.told-twice", {value.path, option.key()}));
      }
    }
    return false;
  }

  /// Each text of a list at its place; of a range its ends and one step; of a draw both ends, and a
  /// number as it will be drawn.
  void tryTexts(const YamlNode& node) {
    const ExperimentValue& value = experiment_.values[value_];
    const YamlNode& list = node.isMap() ? node.items.front() : node;
    for (const std::size_t k : value.representativeTexts()) {
      const bool isLast = k + 1 == value.texts.size();
      const bool isWritten = !value.isRange || k == 0 || isLast;
      const std::size_t item = value.isRange && k != 0 ? 1 : k;  // [FROM, TO, STEP]
      tryText(value.texts[k], isWritten ? list.items[item] : list);
    }
    if (value.isDrawn() && value.texts.empty()) {
      tryDraws(list);
    }
  }

  void tryDraws(const YamlNode& list) {
    const std::size_t before = problems_.size();
    for (std::size_t k = list.items.size() == 2 ? 0 : 2; k < list.items.size(); ++k) {
      tryText(list.items[k].text, list.items[k]);
    }
    toldOfText_.clear();
    for (ExperimentTrial& trial : trials_) {
      if (problems_.size() == before) {
        tell(trial.outcomeOf(value_, trial.firstText(value_)), list);
      }
    }
  }

  void tryText(const std::string& text, const YamlNode& item) {
    toldOfText_.clear();
    for (ExperimentTrial& trial : trials_) {
      tell(trial.outcomeOf(value_, text), item);
    }
  }

  /// What many scenarios or people say of a text once, and of a path once whatever its texts.
  void tell(const ExperimentTrial::Outcome& outcome, const YamlNode& item) {
    for (const base::Diagnostic& problem : outcome.own) {
      const bool isOfPath = problem.code == "set.unknown-path" || problem.code == "set.nobody" ||
                            problem.code == "set.no-nav2";
      tellOnce(problem, item, isOfPath ? toldOfPath_ : toldOfText_);
    }
    for (const base::Diagnostic& problem : outcome.beside) {
      tellOnce(problem, item, toldOfText_);
    }
  }

  void tellOnce(const base::Diagnostic& problem, const YamlNode& item, std::set<ProblemKey>& told) {
    ProblemKey key{problem.code, problem.values};
    if (experiment_.values[value_].path.rfind("*.", 0) == 0) {  // the same of each person
      auto& values = key.second;
      values.erase(std::remove_if(values.begin(), values.end(),
                                  [](const auto& each) { return each.first == "where"; }),
                   values.end());
    }
    if (told.insert(std::move(key)).second) {
      problems_.push_back(located(item, problem));
    }
  }

  const Experiment& experiment_;
  std::vector<ExperimentTrial>& trials_;
  std::size_t value_ = 0;
  std::set<ProblemKey> toldOfText_, toldOfPath_;
  base::Diagnostics problems_;
};

void warnOfSeeds(const Experiment& experiment, const std::vector<ExperimentTrial>& trials,
                 const YamlNode& seeds, base::Diagnostics& warnings) {
  const bool anyDrawn = std::any_of(experiment.values.begin(), experiment.values.end(),
                                    [](const ExperimentValue& value) { return value.isDrawn(); });
  if (experiment.seeds.size() < 2 || anyDrawn) {
    return;
  }
  for (const ExperimentTrial& trial : trials) {
    if (!trial.dependsOnSeed()) {
      warnings.push_back(located(
          seeds, base::warning("experiment.seeds-alike", {experiment.scenarios[trial.number()]})));
    }
  }
}

/// Runs that would be made twice, and are no more evidence than once.
void warnOfTwice(const YamlNode& list, base::Diagnostics& warnings) {
  std::set<std::string> seen;
  for (std::size_t k = 0; list.isList() && k < list.items.size(); ++k) {
    const YamlNode& item = list.items[k];
    if (item.isScalar() && !seen.insert(item.text).second) {
      warnings.push_back(located(item, base::warning("experiment.twice", {item.text})));
    }
  }
}

}  // namespace

base::Diagnostics invalidValues(const Experiment& experiment, std::vector<ExperimentTrial>& trials,
                                const YamlNode& values) {
  ValueCheck check(experiment, trials);
  for (const YamlNode& node : values.items) {
    const auto& all = experiment.values;
    const auto found = std::find_if(all.begin(), all.end(), [&node](const ExperimentValue& value) {
      return value.path == node.key;
    });
    if (found != all.end()) {
      check.check(static_cast<std::size_t>(found - all.begin()), node);
    }
  }
  return check.takeProblems();
}

base::Diagnostics runsAlike(const Experiment& experiment,
                            const std::vector<ExperimentTrial>& trials, const YamlNode& root) {
  base::Diagnostics warnings;
  if (const YamlNode* const seeds = root.find("seeds")) {
    warnOfSeeds(experiment, trials, *seeds, warnings);
  }
  for (const char* key : {"scenarios", "seeds"}) {
    if (const YamlNode* const list = root.find(key)) {
      warnOfTwice(*list, warnings);
    }
  }
  if (const YamlNode* const values = root.find("values")) {
    for (const YamlNode& list : values->items) {
      warnOfTwice(list, warnings);
    }
  }
  return warnings;
}

}  // namespace app
