#include "app/run/Experiment.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <numeric>
#include <utility>

#include "app/run/DataPaths.h"
#include "sim2d/base/Text.h"
#include "sim2d/base/yaml/YamlTree.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using base::YamlNode;

constexpr long long kMaximumRuns = 10'000'000;

bool isCoordinate(const ExperimentValue& value) {
  return value.kind == ExperimentValue::Kind::Between;
}

class Reader {
 public:
  explicit Reader(std::string path, std::optional<SensitivityRequest> sensitivity = std::nullopt)
      : sensitivity_(sensitivity) {
    experiment_.path = std::move(path);
  }

  base::Result<Experiment> read(std::string text) {
    experiment_.text = std::move(text);
    const YamlNode root = base::parseYaml(experiment_.text, experiment_.path, errors_);
    if (!base::hasErrors(errors_)) {
      readRoot(root);
    }
    if (base::hasErrors(errors_)) {
      return errors_;
    }
    return {std::move(experiment_), std::move(errors_)};
  }

 private:
  void error(const YamlNode& node, base::Diagnostic problem) {
    tell({located(node, std::move(problem))});
  }
  void error(const YamlNode& node, const char* code, base::ProblemValues values = {}) {
    error(node, base::error(code, std::move(values)));
  }

  void readRoot(const YamlNode& root) {
    if (!root.isMap()) {
      error(root, "experiment.no-map");
      return;
    }
    const YamlNode* format = root.find("hunavsim_experiment");
    if (format == nullptr && root.find("scenarios") == nullptr) {
      const bool isScenario = root.find("hunav_loader") != nullptr;
      error(root, isScenario ? "experiment.is-scenario" : "experiment.other-file");
      return;
    }
    checkKeys(root);
    if (format == nullptr) {
      error(root, "experiment.no-format");
    } else if (base::parseInt(format->text) != 1) {
      error(*format, "experiment.other-format", {format->text});
    }
    readScenarios(root);
    readSeeds(root.find("seeds"));
    for (const RunOption& option : kRunOptions) {
      if ((option.use & RunOption::InExperiment) != 0) {
        readOption(root, option);
      }
    }
    const bool isPossible = readValues(root);
    readRecord(root.find("record"));
    readCoverage(root.find("tree_coverage"));
    if (const YamlNode* const until = root.find("until")) {
      const base::Result<StoppingRule> rule = readStoppingRule(*until, experiment_);
      tell(rule.diagnostics());
      experiment_.until = rule ? std::optional(*rule) : std::nullopt;
    }
    if (isPossible) {
      tell(checkValues(experiment_, std::move(readable_), root, !base::hasErrors(errors_)));
    }
  }

  void checkKeys(const YamlNode& root) {
    std::vector<std::string> known = {
        "hunavsim_experiment", "scenarios", "seeds", "values", "design", "record", "until",
        "tree_coverage"};
    for (const RunOption& option : kRunOptions) {
      if ((option.use & RunOption::InExperiment) != 0) {
        known.push_back(option.key());
      }
    }
    for (const YamlNode& item : root.items) {
      if (std::find(known.begin(), known.end(), item.key) == known.end()) {
        errors_.push_back(base::error("experiment.unknown-key",
                                      {item.key, base::nearestName(item.key, known)},
                                      experiment_.path, item.keyLine, item.keyColumn));
      }
    }
  }

  void readScenarios(const YamlNode& root) {
    const YamlNode* list = root.find("scenarios");
    if (list == nullptr || !list->isList() || list->items.empty()) {
      error(list ? *list : root, "experiment.no-scenarios");
      return;
    }
    for (const YamlNode& item : list->items) {
      if (item.text.empty()) {
        error(item, "experiment.bad-scenario");
        continue;
      }
      experiment_.scenarios.push_back(item.text);
      experiment_.scenarioPaths.push_back(locate(item));
      sim2d::ScenarioReading reading = sim2d::readScenario(experiment_.scenarioPaths.back());
      if (reading.ok()) {
        readable_.emplace_back(experiment_.scenarios.size() - 1,
                               std::move(reading.scenario));  // of the others each run tells
      }
    }
  }

  std::string locate(const YamlNode& item) {
    const std::string& name = item.text;
    const fs::path beside = fs::path(experiment_.path).parent_path() / name;
    std::error_code ignored;
    if (fs::is_regular_file(beside, ignored)) {
      return beside.lexically_normal().string();
    }
    std::string shipped = scenarioFile(name);
    if (shipped != name) {
      return shipped;
    }
    error(item, "experiment.unknown-scenario", {name, beside.string()});
    return {};
  }

  void readSeeds(const YamlNode* node) {
    if (node == nullptr) {
      experiment_.seeds = {1};
      return;
    }
    if (node->isScalar()) {
      const std::optional<long long> count = base::parseInt(node->text);
      if (count && *count > kMaximumRuns) {
        error(*node, "experiment.too-many-runs", {*count, kMaximumRuns});
        return;
      }
      for (long long seed = 1; count && seed <= *count; ++seed) {
        experiment_.seeds.push_back(seed);
      }
    }
    const std::size_t before = errors_.size();
    for (const YamlNode& item : node->items) {
      const std::optional<long long> seed = base::parseInt(item.text);
      if (!seed || *seed < 0) {
        error(item, "experiment.bad-seed");
      } else {
        experiment_.seeds.push_back(*seed);
      }
    }
    if (experiment_.seeds.empty() && errors_.size() == before) {
      error(*node, "experiment.bad-seeds");
    }
  }

  void readOption(const YamlNode& root, const RunOption& option) {
    const YamlNode* const node = root.find(option.key());
    if (node == nullptr) {
      return;
    }
    if (const auto* const number = std::get_if<std::optional<double> RunSpec::*>(&option.member)) {
      const std::optional<double> value = base::parseDouble(node->text);
      if (value && option.rangeOfValue().contains(*value)) {
        experiment_.common.** number = value;
      } else {
        error(*node, "experiment.out-of-range", {option.key()});
      }
      return;
    }
    const RunOption::Names known = option.choices();
    if (node->text.empty()) {
      error(*node, "experiment.no-word", {option.key()});
    } else if (std::find(known.begin(), known.end(), node->text) == known.end()) {
      error(*node, "experiment.unknown-name",
            {option.key(), node->text, base::nearestName(node->text, known),
             base::join(known, ", ")});
    } else if (const auto* const name =
                   std::get_if<std::optional<std::string> RunSpec::*>(&option.member)) {
      experiment_.common.** name = node->text;
    } else {
      experiment_.common.*std::get<std::string RunSpec::*>(option.member) = node->text;
    }
  }

  /// False: there are too many runs.
  bool readValues(const YamlNode& root) {
    const YamlNode* const seeds = root.find("seeds");
    const YamlNode* const node = root.find("values");
    if (!isCountPossible(seeds != nullptr ? *seeds : root)) {
      return false;
    }
    if (node == nullptr) {
      if (sensitivity_) {
        error(root, "experiment.no-factors");
      }
      return true;
    }
    if (!node->isMap()) {
      error(*node, "experiment.bad-values");
      return true;
    }
    for (const YamlNode& item : node->items) {
      const base::Result<ExperimentValue> value = readExperimentValue(item);
      tell(value.diagnostics());
      if (value) {
        experiment_.values.push_back(*value);
      }
      if (!isCountPossible(item)) {
        return false;
      }
    }
    readDesignOf(root);
    return isCountPossible(*node);
  }

  void readDesignOf(const YamlNode& root) {
    const YamlNode* const node = root.find("design");
    const std::optional<Design> design = designIn(node);
    if (design && design->isForSensitivity()) {
      takeUniformAsCoordinates();
    }
    std::vector<ExperimentValue>& values = experiment_.values;
    const auto first = std::find_if(values.begin(), values.end(), isCoordinate);
    const YamlNode& valuesNode = *root.find("values");
    if (first == values.end() && sensitivity_) {
      error(valuesNode, "experiment.no-factors");
    } else if (first == values.end() && node != nullptr) {
      error(*node, "experiment.design-unused");
    } else if (first != values.end() && !design && node == nullptr) {
      error(*valuesNode.find(first->path), "experiment.no-design", {first->path});
    } else if (design && arePointsPossible(*design, node != nullptr ? *node : valuesNode)) {
      experiment_.design = *design;
      takeDesignPoints(*design, values);
      return;
    }
    values.erase(std::remove_if(values.begin(), values.end(), isCoordinate), values.end());
  }

  /// nullopt: none, or it cannot be read.
  std::optional<Design> designIn(const YamlNode* node) {
    std::optional<Design> design;
    if (node != nullptr) {
      const base::Result<Design> read = readDesign(*node);
      tell(read.diagnostics());
      if (!read) {
        return std::nullopt;
      }
      design = *read;
    }
    return sensitivity_ ? sensitivity_->appliedTo(design) : design;
  }

  void takeUniformAsCoordinates() {
    for (ExperimentValue& value : experiment_.values) {
      if (value.kind == ExperimentValue::Kind::Uniform) {
        value.kind = ExperimentValue::Kind::Between;
        value.isRange = true;
      }
    }
  }

  bool arePointsPossible(const Design& design, const YamlNode& node) {
    const auto count = static_cast<std::size_t>(
        std::count_if(experiment_.values.begin(), experiment_.values.end(), isCoordinate));
    const Design one{design.method, 1, design.seed};
    const std::size_t most = Design::kMaxPoints / one.pointCount(count);
    if (design.points > most) {
      error(node, "experiment.bad-points", {most});
    }
    return design.points <= most;
  }

  void tell(base::Diagnostics problems) {
    for (base::Diagnostic& problem : problems) {
      problem.file = experiment_.path;
      errors_.push_back(std::move(problem));
    }
  }

  bool isCountPossible(const YamlNode& node) {
    const auto countOf = [](const auto& list) {
      return static_cast<double>(std::max<std::size_t>(1, list.size()));
    };
    double count = countOf(experiment_.scenarios) * countOf(experiment_.seeds);
    for (const std::size_t size : experiment_.dimensions()) {
      count *= static_cast<double>(size);
    }
    const bool isPossible = count <= static_cast<double>(kMaximumRuns);
    if (!isPossible) {
      error(node, "experiment.too-many-runs", {count, kMaximumRuns});
    }
    return isPossible;
  }

  void readRecord(const YamlNode* node) {
    if (node == nullptr) {
      return;
    }
    const auto& names = Experiment::kRecordNames;
    const auto* const found = std::find(std::begin(names), std::end(names), node->text);
    if (found == std::end(names)) {
      error(*node, "experiment.bad-record");
      return;
    }
    experiment_.record = static_cast<Experiment::Record>(found - std::begin(names));
  }

  void readCoverage(const YamlNode* node) {
    if (node != nullptr && node->text != "true" && node->text != "false") {
      error(*node, "experiment.bad-coverage");
    }
    experiment_.treeCoverage = node != nullptr && node->text == "true";
  }

  const std::optional<SensitivityRequest> sensitivity_;
  Experiment experiment_;
  NumberedScenarios readable_;
  base::Diagnostics errors_;
};

}  // namespace

std::vector<std::size_t> Experiment::dimensions() const {
  std::vector<std::size_t> sizes;
  bool hasDesign = false;
  for (const ExperimentValue& value : values) {
    const bool isAgain = isCoordinate(value) && std::exchange(hasDesign, true);
    sizes.push_back(value.isDrawn() || isAgain ? 1 : std::max<std::size_t>(1, value.texts.size()));
  }
  return sizes;
}

std::size_t Experiment::runCount() const {
  const std::vector<std::size_t> sizes = dimensions();
  return std::accumulate(sizes.begin(), sizes.end(), scenarios.size() * seeds.size(),
                         std::multiplies<>());
}

Experiment::Run Experiment::run(std::size_t index) const {
  Run run;
  run.seed = seeds[index % seeds.size()];
  index /= seeds.size();
  run.values.resize(values.size());
  const std::vector<std::size_t> sizes = dimensions();
  std::size_t point = 0;  // of the design
  for (std::size_t k = values.size(); k-- > 0;) {
    if (values[k].kind == ExperimentValue::Kind::Grid) {
      run.values[k] = values[k].texts[index % sizes[k]];
    } else if (isCoordinate(values[k])) {
      point = index % sizes[k];  // the first coordinate comes last and has the size of the design
    }
    index /= sizes[k];
  }
  run.scenario = index;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (isCoordinate(values[k])) {
      run.values[k] = values[k].texts[point];
    }
  }
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

base::Result<Experiment> readExperiment(const std::string& path) {
  const base::Result<std::string> text = base::readTextFile(path);
  if (!text) {
    return text.diagnostics();
  }
  return parseExperiment(*text, path);
}

base::Result<Experiment> parseExperiment(std::string text, const std::string& path) {
  return Reader(path).read(std::move(text));
}

base::Result<Experiment> readSensitivityExperiment(const std::string& path,
                                                   const SensitivityRequest& request) {
  base::Result<std::string> text = base::readTextFile(path);
  return text ? Reader(path, request).read(*std::move(text))
              : base::Result<Experiment>(text.diagnostics());
}

}  // namespace app
