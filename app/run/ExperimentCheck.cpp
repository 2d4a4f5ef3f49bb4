#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "app/run/Bundle.h"
#include "app/run/Experiment.h"
#include "app/run/Nav2Robots.h"
#include "app/run/ValueKeys.h"
#include "sim2d/base/Find.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/Fields.h"
#include "sim2d/scenario/ScenarioCheck.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/World.h"

namespace app {

namespace {

using base::YamlNode;

std::string firstTextOf(const Experiment& experiment, const ExperimentValue& value,
                        std::size_t scenario) {
  return value.isDrawn() ? drawnText(value, experiment.scenarios[scenario],
                                     experiment.seeds.empty() ? 1 : experiment.seeds.front())
                         : value.texts.front();
}

using ProblemKey = std::pair<std::string_view, decltype(base::Diagnostic::values)>;

ProblemKey keyOf(const base::Diagnostic& problem) {
  return {problem.code, problem.values};
}

/// Whether setting one path may change the effect of the other: they concern the same entity, or
/// one of them concerns all people or robots.
bool meet(const std::string& first, const std::string& second) {
  const auto nameIn = [](const std::string& path) { return path.substr(0, path.find('.')); };
  const std::string one = nameIn(first), other = nameIn(second);
  return one == other || one == "*" || other == "*" || one == "nav2" || other == "nav2";
}

/// The values of an experiment in one of its scenarios, before anything runs: each in place of the
/// first one of its path, with the options of all runs and the first values of the other paths, as
/// one of the runs has it. No map is read and no world created.
class ExperimentTrial {
 public:
  /// `number`: of the scenario in the experiment; `written`: as in its file.
  ExperimentTrial(const Experiment& experiment, std::size_t number, sim2d::Scenario written)
      : experiment_(experiment),
        number_(number),
        names_(sim2d::knownNames(builtinRegistries())),
        brought_(experiment.values.size()) {
    // Problems of these are reported by the runs, at the scenario.
    const base::Diagnostics ofRuns = applyOptions(written, experiment.common, {});
    written_ = std::move(written);
    for (const base::Diagnostics& problems : {ofRuns, meaningErrors(written_)}) {
      for (const base::Diagnostic& problem : problems) {
        usual_.insert(keyOf(problem));
      }
    }
    putFirstTexts();
    dependsOnSeed_ = sim2d::dependsOnSeed(first_);
  }

  /// The problems of a text, without locations.
  struct Outcome {
    base::Diagnostics own;     // of setting the value
    base::Diagnostics beside;  // errors of the scenario with it
  };
  /// `value`: its number in the experiment.
  Outcome outcomeOf(std::size_t value, const std::string& text) {
    Outcome outcome;
    if (text == firstTexts_[value]) {
      outcome.own = own_[value];
      if (!base::hasErrors(outcome.own)) {
        outcome.beside = brought_[value];
      }
      return outcome;
    }
    sim2d::Scenario stage = stageBefore(value);
    outcome.own = put(stage, value, text);
    if (base::hasErrors(outcome.own)) {
      return outcome;
    }
    base::Diagnostics errors;
    const sim2d::Scenario tried = othersWith(value, text, std::move(stage), errors);
    base::append(errors, meaningErrors(tried));
    for (base::Diagnostic& problem : errors) {
      if (usual_.count(keyOf(problem)) == 0) {
        outcome.beside.push_back(std::move(problem));
      }
    }
    dependsOnSeed_ = dependsOnSeed_ || sim2d::dependsOnSeed(tried);
    return outcome;
  }
  /// The text of the value in the first run.
  const std::string& firstText(std::size_t value) const { return firstTexts_[value]; }
  /// Whether runs differ by their seeds with any text that has been tried.
  bool dependsOnSeed() const { return dependsOnSeed_; }
  std::size_t number() const { return number_; }
  const sim2d::Scenario& scenario() const { return written_; }

 private:
  base::Diagnostics put(sim2d::Scenario& scenario, std::size_t value,
                        const std::string& text) const {
    return sim2d::setValue(scenario, experiment_.values[value].path, text);
  }

  base::Diagnostics meaningErrors(const sim2d::Scenario& scenario) const {
    const std::string& path = experiment_.scenarioPaths[number_];
    base::Diagnostics found = sim2d::checkScenario(scenario, sim2d::Surroundings(), path, names_);
    base::append(found, wrongNav2Values(scenario, path));
    return errorsOf(found);
  }

  void putFirstTexts() {
    first_ = stage_ = written_;
    for (std::size_t k = 0; k < experiment_.values.size(); ++k) {
      firstTexts_.push_back(firstTextOf(experiment_, experiment_.values[k], number_));
      own_.push_back(put(first_, k, firstTexts_.back()));
      for (const base::Diagnostic& problem : errorsOf(own_.back())) {
        usual_.insert(keyOf(problem));  // reported for this value itself
      }
    }
    std::set<ProblemKey> errors;
    for (const base::Diagnostic& problem : meaningErrors(first_)) {
      if (usual_.count(keyOf(problem)) == 0) {
        errors.insert(keyOf(problem));
      }
    }
    if (!errors.empty()) {
      findWhatBrings(errors);
    }
  }

  /// `errors`: those of the first run with the texts of all paths. A problem that a later path
  /// corrects is not an error.
  void findWhatBrings(const std::set<ProblemKey>& errors) {
    sim2d::Scenario stage = written_;
    for (std::size_t k = 0; k < experiment_.values.size(); ++k) {
      if (base::hasErrors(put(stage, k, firstTexts_[k]))) {
        continue;  // nothing has changed
      }
      for (const base::Diagnostic& problem : meaningErrors(stage)) {
        if (errors.count(keyOf(problem)) != 0 && usual_.insert(keyOf(problem)).second) {
          brought_[k].push_back(problem);
        }
      }
    }
  }

  /// With the first texts of the paths before it. Fast as long as values are requested in order.
  const sim2d::Scenario& stageBefore(std::size_t value) {
    if (value < stageOf_) {
      stage_ = written_;
      stageOf_ = 0;
    }
    for (; stageOf_ < value; ++stageOf_) {
      if (!base::hasErrors(own_[stageOf_])) {
        put(stage_, stageOf_, firstTexts_[stageOf_]);
      }
    }
    return stage_;
  }

  /// The scenario with this text and the first ones of all other paths; `stage` already has it and
  /// those before. Of the later paths, only those that this one affects must be set again; all of
  /// them, if the text does not fit together with the first ones.
  sim2d::Scenario othersWith(std::size_t value, const std::string& text, sim2d::Scenario stage,
                             base::Diagnostics& errors) const {
    sim2d::Scenario tried = first_;
    const bool isMap =
        !text.empty() && text.front() == '{';  // would leave other keys of the first text
    const bool fits = !isMap && !base::hasErrors(put(tried, value, text));
    if (!fits) {
      tried = std::move(stage);
    }
    for (std::size_t k = value + 1; k < firstTexts_.size(); ++k) {
      if (!fits || meet(experiment_.values[value].path, experiment_.values[k].path)) {
        base::append(errors, errorsOf(put(tried, k, firstTexts_[k])));
      }
    }
    return tried;
  }

  const Experiment& experiment_;
  const std::size_t number_;
  const sim2d::KnownNames names_;
  std::vector<std::string> firstTexts_;
  sim2d::Scenario written_, first_;  // without and with the first texts of all paths
  sim2d::Scenario stage_;            // with those of the first `stageOf_` paths
  std::size_t stageOf_ = 0;
  std::vector<base::Diagnostics> own_;      // from setting the first text of each path
  std::vector<base::Diagnostics> brought_;  // errors of the first run, by the path that brings them
  std::set<ProblemKey> usual_;              // present with every text
  bool dependsOnSeed_ = false;
};

const sim2d::Robot* firstRobotOf(const sim2d::Scenario& scenario) {
  return base::findBy(scenario.robots, &sim2d::Robot::listed, true);
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
          (value.path == robot->name && isInMap(value.texts, option.robotSetting)));
}

/// Tries the values one after the other, and says what is wrong with them.
class ValueCheck {
 public:
  ValueCheck(const Experiment& experiment, std::vector<ExperimentTrial>& trials)
      : experiment_(experiment), trials_(trials) {
    for (const ExperimentValue& value : experiment.values) {
      keys_.push_back(keysOf(value));
    }
    for (const ExperimentTrial& trial : trials) {
      scenarios_.push_back(&trial.scenario());
    }
  }

  void check(std::size_t value, const YamlNode& node) {
    if (isToldTwice(experiment_.values[value], node) || replacesEarlier(value, node)) {
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

  /// Whether it sets what an earlier value sets, which would then have no effect.
  bool replacesEarlier(std::size_t value, const YamlNode& node) {
    for (std::size_t k = 0; k < value; ++k) {
      const std::string key = replacedKey(keys_[k], keys_[value], scenarios_);
      if (!key.empty()) {
        problems_.push_back(located(
            base::keyNode(node),
            base::error("experiment.overlap",
                        {experiment_.values[value].path, experiment_.values[k].path, key})));
        return true;
      }
    }
    return false;
  }

  /// Each text of a list at its place; of a range its ends and one step; of a draw both ends, and a
  /// number as it will be drawn.
  void tryTexts(const YamlNode& node) {
    const ExperimentValue& value = experiment_.values[value_];
    for (const std::size_t k : value.representativeTexts()) {
      tryText(value.texts[k], nodeOfText(value, k, node));
    }
    if (value.isDrawn() && value.texts.empty()) {
      tryDraws(node.items.front());
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
    if (base::startsWith(experiment_.values[value_].path, "*.")) {  // the same of each person
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
  std::vector<ValueKeys> keys_;                    // of each value
  std::vector<const sim2d::Scenario*> scenarios_;  // of the trials
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
    const std::string text = valueText(item);
    if (!seen.insert(text).second) {
      warnings.push_back(located(item, base::warning("experiment.twice", {text})));
    }
  }
}

base::Diagnostics invalidValues(const Experiment& experiment, std::vector<ExperimentTrial>& trials,
                                const YamlNode& values) {
  ValueCheck check(experiment, trials);
  for (const YamlNode& node : values.items) {
    if (const auto* const found =
            base::findBy(experiment.values, &ExperimentValue::path, node.key)) {
      check.check(static_cast<std::size_t>(found - experiment.values.data()), node);
    }
  }
  return check.takeProblems();
}

base::Diagnostics identicalRuns(const Experiment& experiment,
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

}  // namespace

base::Diagnostics checkValues(const Experiment& experiment, NumberedScenarios scenarios,
                              const YamlNode& root, bool areAllKnown) {
  std::vector<ExperimentTrial> trials;
  trials.reserve(scenarios.size());
  for (auto& each : scenarios) {
    trials.emplace_back(experiment, each.first, std::move(each.second));
  }
  base::Diagnostics problems;
  if (const YamlNode* const values = root.find("values")) {
    problems = invalidValues(experiment, trials, *values);
  }
  if (areAllKnown && !base::hasErrors(problems)) {
    base::append(problems, identicalRuns(experiment, trials, root));
  }
  return problems;
}

}  // namespace app
