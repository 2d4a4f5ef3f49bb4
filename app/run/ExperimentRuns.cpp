#include "app/run/Experiment.h"

namespace app {

std::size_t Experiment::runCount() const {
  std::size_t count = scenarios.size() * seeds.size();
  for (const ExperimentValue& value : values) {
    count *= value.isDrawn() ? 1 : value.texts.size();
  }
  return count;
}

Experiment::Run Experiment::run(std::size_t index) const {
  Run run;
  run.seed = seeds[index % seeds.size()];
  index /= seeds.size();
  run.values.resize(values.size());
  for (std::size_t k = values.size(); k-- > 0;) {
    const std::vector<std::string>& texts = values[k].texts;
    if (!values[k].isDrawn()) {
      run.values[k] = texts[index % texts.size()];
      index /= texts.size();
    }
  }
  run.scenario = index;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k].isDrawn()) {
      run.values[k] = drawnText(values[k], scenarios[run.scenario], run.seed);
    }
  }
  return run;
}

RunSpec Experiment::specOf(std::size_t index) const {
  const Run of = run(index);
  RunSpec spec = common;
  spec.scenario = scenarioPaths[of.scenario];
  spec.seed = of.seed;
  spec.allowCode = allowCode;
  for (std::size_t k = 0; k < values.size(); ++k) {
    spec.set.push_back(values[k].path + "=" + of.values[k]);
  }
  return spec;
}

}  // namespace app
