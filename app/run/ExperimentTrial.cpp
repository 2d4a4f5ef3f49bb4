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

bool isAmong(const base::Diagnostics& problems, const ProblemKey& key) {
  return std::any_of(problems.begin(), problems.end(),
                     [&key](const auto& each) { return keyOf(each) == key; });
}

}  // namespace

ExperimentTrial::ExperimentTrial(const Experiment& experiment, std::size_t number,
                                 sim2d::Scenario written)
    : experiment_(experiment),
      number_(number),
      names_(sim2d::knownNames(programRegistries())),
      brought_(experiment.values.size()) {
  // What is wrong there is told of the runs, at the scenario.
  const base::Diagnostics ofRuns = applyOptions(written, experiment.optionsOfAll(), {});
  stages_.push_back(std::move(written));
  for (const base::Diagnostics& problems : {ofRuns, meaningErrors(stages_.front())}) {
    for (const base::Diagnostic& problem : problems) {
      usual_.insert(keyOf(problem));
    }
  }
  putFirstTexts();
  dependsOnSeed_ = sim2d::dependsOnSeed(stages_.back());
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
  std::vector<base::Diagnostics> errors;
  errors.reserve(experiment_.values.size());
  firstTexts_.reserve(experiment_.values.size());
  stages_.reserve(experiment_.values.size() + 1);
  for (std::size_t k = 0; k < experiment_.values.size(); ++k) {
    firstTexts_.push_back(firstTextOf(experiment_, experiment_.values[k], number_));
    stages_.push_back(stages_.back());
    for (const base::Diagnostic& problem : errorsOf(put(stages_.back(), k, firstTexts_.back()))) {
      usual_.insert(keyOf(problem));  // and is told of that text
    }
    errors.push_back(meaningErrors(stages_.back()));
  }
  findWhatBrings(errors);
}

/// `errors`: of each stage. What a later path puts right is none.
void ExperimentTrial::findWhatBrings(const std::vector<base::Diagnostics>& errors) {
  for (std::size_t k = 0; k < errors.size(); ++k) {
    for (const base::Diagnostic& problem : errors[k]) {
      const bool isLeft = isAmong(errors.back(), keyOf(problem));
      if (isLeft && usual_.insert(keyOf(problem)).second) {
        brought_[k].push_back(problem);
      }
    }
  }
}

ExperimentTrial::Outcome ExperimentTrial::outcomeOf(std::size_t value, const std::string& text) {
  sim2d::Scenario tried = stages_[value];
  Outcome outcome;
  outcome.own = put(tried, value, text);
  if (base::hasErrors(outcome.own)) {
    return outcome;
  }
  if (text == firstTexts_[value]) {
    outcome.beside = brought_[value];
    return outcome;
  }
  base::Diagnostics errors;
  for (std::size_t k = value + 1; k < firstTexts_.size(); ++k) {
    base::append(errors, errorsOf(put(tried, k, firstTexts_[k])));
  }
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
