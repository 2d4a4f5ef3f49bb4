#include "app/window/StudyCode.h"

#include <algorithm>
#include <utility>

#include "app/run/ExperimentInputs.h"
#include "app/run/RunOptions.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

bool holds(const std::vector<ForeignCode>& all, const ForeignCode& code) {
  return std::find(all.begin(), all.end(), code) != all.end();
}

}  // namespace

/// What is wrong with scenarios and values is told by who runs them.
std::vector<ForeignCode> codeOf(const Experiment& experiment) {
  std::vector<ForeignCode> all;
  const std::size_t runs = experiment.runCount() / experiment.scenarios.size();
  for (std::size_t k = 0; k < experiment.scenarios.size(); ++k) {
    sim2d::Scenario first = sim2d::readScenario(experiment.scenarioPaths[k]).scenario;
    applyOptions(first, experiment.optionsOf(k * runs), {});
    for (const ForeignCode& code : foreignCodeOf(experiment, first)) {
      if (!holds(all, code)) {
        all.push_back(code);
      }
    }
  }
  return all;
}

bool StudyCode::allows(const std::vector<ForeignCode>& code) const {
  return std::all_of(code.begin(), code.end(),
                     [this](const ForeignCode& each) { return holds(allowed_, each); });
}

void StudyCode::allow(const std::vector<ForeignCode>& code) {
  allowed_.insert(allowed_.end(), code.begin(), code.end());
  if (const auto then = std::exchange(then_, {})) {
    then();
  }
}

void StudyCode::forget() {
  allowed_.clear();
  then_ = {};
}

}  // namespace app
