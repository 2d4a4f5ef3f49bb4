#include "app/run/ExperimentTrial.h"

#include <algorithm>
#include <utility>

#include "app/run/Bundle.h"
#include "app/run/Nav2Robots.h"
#include "app/run/ProgramRegistries.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/scenario/Variation.h"
#include "sim2d/world/World.h"

namespace app {

namespace {

std::string firstTextOf(const Experiment& experiment, const ExperimentValue& value,
                        std::size_t scenario) {
  return value.isDrawn() ? drawnText(value, experiment.scenarios[scenario],
                                     experiment.seeds.empty() ? 1 : experiment.seeds.front())
                         : value.texts.front();
}

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

}  // namespace

ExperimentTrial::ExperimentTrial(const Experiment& experiment, std::size_t number,
                                 sim2d::Scenario written)
    : experiment_(experiment),
      number_(number),
      names_(sim2d::knownNames(builtinRegistries())),
      brought_(experiment.values.size()) {
  // What is wrong there is told of the runs, at the scenario.
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

base::Diagnostics ExperimentTrial::put(sim2d::Scenario& scenario, std::size_t value,
                                       const std::string& text) const {
  return sim2d::setValue(scenario, experiment_.values[value].path, text);
}

base::Diagnostics ExperimentTrial::meaningErrors(const sim2d::Scenario& scenario) const {
  const std::string& path = experiment_.scenarioPaths[number_];
  base::Diagnostics found = sim2d::checkScenario(scenario, sim2d::Surroundings(), path, names_);
  base::append(found, wrongNav2Values(scenario, path));
  return errorsOf(found);
}

void ExperimentTrial::putFirstTexts() {
  first_ = stage_ = written_;
  for (std::size_t k = 0; k < experiment_.values.size(); ++k) {
    firstTexts_.push_back(firstTextOf(experiment_, experiment_.values[k], number_));
    own_.push_back(put(first_, k, firstTexts_.back()));
    for (const base::Diagnostic& problem : errorsOf(own_.back())) {
      usual_.insert(keyOf(problem));  // and is told of that text
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
void ExperimentTrial::findWhatBrings(const std::set<ProblemKey>& errors) {
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
const sim2d::Scenario& ExperimentTrial::stageBefore(std::size_t value) {
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
sim2d::Scenario ExperimentTrial::othersWith(std::size_t value, const std::string& text,
                                            sim2d::Scenario stage,
                                            base::Diagnostics& errors) const {
  sim2d::Scenario tried = first_;
  const bool fits = !base::hasErrors(put(tried, value, text));
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

ExperimentTrial::Outcome ExperimentTrial::outcomeOf(std::size_t value, const std::string& text) {
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

}  // namespace app
