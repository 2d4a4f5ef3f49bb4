#include "app/run/Experiment.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

/// An option of `run` that an experiment may give for all runs.
struct Given {
  const char* option;
  void (*put)(RunOptions& options, const std::string& text);
};
constexpr Given kGiven[] = {
    {"--duration",
     [](RunOptions& to, const std::string& text) { to.duration = base::parseDouble(text); }},
    {"--dt", [](RunOptions& to, const std::string& text) { to.dt = base::parseDouble(text); }},
    {"--stop-on-collision",
     [](RunOptions& to, const std::string& text) { to.stopOnCollision = text; }},
    {"--stuck-after",
     [](RunOptions& to, const std::string& text) { to.stuckAfter = base::parseDouble(text); }},
    {"--model", [](RunOptions& to, const std::string& text) { to.model = text; }},
    {"--robot", [](RunOptions& to, const std::string& text) { to.robot = text; }},
    {"--planner", [](RunOptions& to, const std::string& text) { to.planner = text; }},
    {"--metrics-profile",
     [](RunOptions& to, const std::string& text) { to.metrics.profile = text; }}};

}  // namespace

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

std::vector<std::string> Experiment::wordsOf(std::size_t index) const {
  const Run of = run(index);
  std::vector<std::string> words = {"run", scenarioPaths[of.scenario], "--seed",
                                    std::to_string(of.seed)};
  if (allowCode) {
    words.emplace_back("--allow-code");
  }
  for (const auto& [option, given] : options) {
    words.insert(words.end(), {option, given});
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    words.insert(words.end(), {"--set", values[k].path + "=" + of.values[k]});
  }
  return words;
}

RunOptions Experiment::optionsOf(std::size_t index) const {
  const Run of = run(index);
  RunOptions result = optionsOfAll();
  result.scenario = scenarioPaths[of.scenario];
  result.seed = of.seed;
  for (std::size_t k = 0; k < values.size(); ++k) {
    result.set.push_back(values[k].path + "=" + of.values[k]);
  }
  return result;
}

RunOptions Experiment::optionsOfAll() const {
  RunOptions result;
  for (const Given& given : kGiven) {
    if (const auto found = options.find(given.option); found != options.end()) {
      given.put(result, found->second);
    }
  }
  return result;
}

}  // namespace app
