#include "app/run/Experiment.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <yaml-cpp/yaml.h>

#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"
#include "sim2d/world/World.h"

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr long long kMaximumRuns = 10'000'000;

const std::vector<std::string>& knownKeys() {
  static const std::vector<std::string> keys = {
      "hunavsim_experiment", "scenarios", "seeds", "duration", "dt", "model", "robot", "planner",
      "metrics_profile",     "values",    "record"};
  return keys;
}

class Reader {
 public:
  explicit Reader(std::string path) { experiment_.path = std::move(path); }

  base::Result<Experiment> read() {
    const base::Result<std::string> text = base::readTextFile(experiment_.path);
    if (!text) {
      return text.diagnostics();
    }
    try {
      readRoot(YAML::Load(*text));
    } catch (const YAML::Exception& problem) {
      errors_.push_back(base::makeError(problem.msg, experiment_.path, problem.mark.line + 1,
                                        problem.mark.column + 1));
    }
    if (base::hasErrors(errors_)) {
      return errors_;
    }
    return {std::move(experiment_), std::move(errors_)};
  }

 private:
  void error(const YAML::Node& node, const std::string& message) {
    const YAML::Mark mark = node.Mark();
    errors_.push_back(base::makeError(message, experiment_.path, mark.is_null() ? 0 : mark.line + 1,
                                      mark.is_null() ? 0 : mark.column + 1));
  }

  void readRoot(const YAML::Node& root) {
    if (!root.IsMap()) {
      error(root, "an experiment is a map that begins with hunavsim_experiment: 1");
      return;
    }
    checkKeys(root);
    const YAML::Node format = root["hunavsim_experiment"];
    if (!format) {
      error(root, "the key hunavsim_experiment is missing (write hunavsim_experiment: 1)");
    } else if (base::parseInt(scalar(format)) != 1) {
      error(format, "this program reads experiments of format 1, not '" + scalar(format) + "'");
    }
    readScenarios(root);
    readSeeds(root["seeds"]);
    readNumber(root["duration"], "duration", 0.0, 1e6, experiment_.duration);
    readNumber(root["dt"], "dt", 0.000999, 0.1, experiment_.dt);
    readName(root["model"], "model", sim2d::modelNames(), experiment_.model);
    readName(root["robot"], "robot", sim2d::robotTypeNames(), experiment_.robot);
    readName(root["planner"], "planner", sim2d::plannerNames(), experiment_.planner);
    readWord(root["metrics_profile"], "metrics_profile", experiment_.metricsProfile);
    if (experiment_.metricsProfile && *experiment_.metricsProfile != "corrected" &&
        *experiment_.metricsProfile != "hunav2") {
      error(root["metrics_profile"], "metrics_profile is corrected or hunav2");
    }
    readValues(root["values"]);
    readRecord(root["record"]);
  }

  void checkKeys(const YAML::Node& root) {
    std::set<std::string> seen;
    for (const auto& pair : root) {
      const std::string key = scalar(pair.first);
      const std::vector<std::string>& known = knownKeys();
      if (std::find(known.begin(), known.end(), key) == known.end()) {
        const std::optional<std::string> meant = base::nearestName(key, known);
        error(pair.first, "unknown key '" + key + "'" +
                              (meant ? " (did you mean '" + *meant + "'?)" : std::string()));
      } else if (!seen.insert(key).second) {
        error(pair.first, "the key '" + key + "' stands twice");
      }
    }
  }

  static std::string scalar(const YAML::Node& node) {
    return node.IsScalar() ? node.Scalar() : std::string();
  }

  void readScenarios(const YAML::Node& root) {
    const YAML::Node list = root["scenarios"];
    if (!list || !list.IsSequence() || list.size() == 0) {
      error(list ? list : root, "scenarios is a list of at least one file or shipped name");
      return;
    }
    for (const YAML::Node& item : list) {
      if (!item.IsScalar() || scalar(item).empty()) {
        error(item, "a scenario is the name of a file or of a shipped scenario");
        continue;
      }
      experiment_.scenarios.push_back(scalar(item));
      experiment_.scenarioPaths.push_back(locate(item));
      sim2d::ScenarioReading reading = sim2d::readScenario(experiment_.scenarioPaths.back());
      if (reading.ok()) {
        readable_.push_back(std::move(reading.scenario));  // of the others each run tells
      }
    }
  }

  std::string locate(const YAML::Node& item) {
    const std::string name = scalar(item);
    const fs::path beside = fs::path(experiment_.path).parent_path() / name;
    std::error_code ignored;
    if (fs::is_regular_file(beside, ignored)) {
      return beside.lexically_normal().string();
    }
    const std::string shipped = scenarioFile(name);
    if (shipped != name) {
      return shipped;
    }
    error(item, "there is no scenario '" + name + "' (looked for " + beside.string() +
                    " and among the shipped scenarios)");
    return {};
  }

  void readSeeds(const YAML::Node& node) {
    if (!node) {
      experiment_.seeds = {1};
      return;
    }
    if (node.IsScalar()) {
      const std::optional<long long> count = base::parseInt(scalar(node));
      if (!count || *count < 1 || *count > kMaximumRuns) {
        error(node, "seeds is a number of seeds >= 1 or a list of seeds");
        return;
      }
      for (long long seed = 1; seed <= *count; ++seed) {
        experiment_.seeds.push_back(seed);
      }
      return;
    }
    for (const YAML::Node& item : node) {
      const std::optional<long long> seed = base::parseInt(scalar(item));
      if (!seed || *seed < 0) {
        error(item, "a seed is a whole number >= 0");
      } else {
        experiment_.seeds.push_back(*seed);
      }
    }
    if (experiment_.seeds.empty()) {
      error(node, "seeds is a number of seeds >= 1 or a list of seeds");
    }
  }

  void readNumber(const YAML::Node& node, const std::string& key, double above, double maximum,
                  std::optional<std::string>& value) {
    if (!node) {
      return;
    }
    const std::optional<double> number = base::parseDouble(scalar(node));
    if (!number || !(*number > above && *number <= maximum)) {
      error(node, key + " is not a number in its range");
      return;
    }
    value = base::formatDouble(*number);
  }

  void readWord(const YAML::Node& node, const std::string& key, std::optional<std::string>& value) {
    if (!node) {
      return;
    }
    if (!node.IsScalar() || scalar(node).empty()) {
      error(node, key + " is a word");
      return;
    }
    value = scalar(node);
  }

  void readName(const YAML::Node& node, const std::string& key,
                const std::vector<std::string>& known, std::optional<std::string>& value) {
    readWord(node, key, value);
    if (value && std::find(known.begin(), known.end(), *value) == known.end()) {
      error(node,
            "there is no " + key + " '" + *value + "' (known: " + base::join(known, ", ") + ")");
    }
  }

  /// A path or a value that one of the scenarios does not take, before anything runs.
  void tryValue(const std::string& path, const YAML::Node& item) {
    for (const sim2d::Scenario& scenario : readable_) {
      sim2d::Scenario changed = scenario;
      const base::Diagnostics problems = sim2d::setValue(changed, path, textOf(item));
      if (base::hasErrors(problems)) {
        error(item, problems.front().message);
        return;
      }
    }
  }

  void readValues(const YAML::Node& node) {
    if (!node) {
      return;
    }
    if (!node.IsMap()) {
      error(node, "values is a map: path of --set -> list of values");
      return;
    }
    for (const auto& pair : node) {
      std::vector<std::string> texts;
      if (pair.second.IsSequence()) {
        for (const YAML::Node& item : pair.second) {
          texts.push_back(textOf(item));
          tryValue(scalar(pair.first), item);
        }
      }
      if (texts.empty()) {
        error(pair.second, "the values of '" + scalar(pair.first) + "' are not a list");
      }
      experiment_.values.emplace_back(scalar(pair.first), std::move(texts));
    }
  }

  static std::string textOf(const YAML::Node& node) {
    if (node.IsScalar()) {
      return scalar(node);
    }
    YAML::Emitter emitter;  // a list or map as value: in flow style, so that it stays one line
    emitter.SetSeqFormat(YAML::Flow);
    emitter.SetMapFormat(YAML::Flow);
    emitter << node;
    return emitter.c_str();
  }

  void readRecord(const YAML::Node& node) {
    if (!node || scalar(node) == "metrics") {
      return;
    }
    if (scalar(node) == "failed") {
      experiment_.record = Experiment::Record::Failed;
    } else if (scalar(node) == "all") {
      experiment_.record = Experiment::Record::All;
    } else {
      error(node, "record is metrics, failed or all");
    }
  }

  Experiment experiment_;
  std::vector<sim2d::Scenario> readable_;
  base::Diagnostics errors_;
};

}  // namespace

std::size_t Experiment::runCount() const {
  std::size_t count = scenarios.size() * seeds.size();
  for (const auto& dimension : values) {
    count *= dimension.second.size();
  }
  return count;
}

Experiment::Run Experiment::run(std::size_t index) const {
  Run run;
  run.seed = seeds[index % seeds.size()];
  index /= seeds.size();
  run.values.resize(values.size());
  for (std::size_t k = values.size(); k-- > 0;) {
    const std::vector<std::string>& texts = values[k].second;
    run.values[k] = texts[index % texts.size()];
    index /= texts.size();
  }
  run.scenario = index;
  return run;
}

base::Result<Experiment> readExperiment(const std::string& path) {
  return Reader(path).read();
}

}  // namespace app
