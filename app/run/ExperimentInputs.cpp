#include "app/run/ExperimentInputs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/run/RunFolder.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

/// Whether a value may say what a robot starts: of a planner's key, or of the whole robot.
bool mayNameCode(const ExperimentValue& value) {
  constexpr const char* kKeys[] = {"planner", "command", "planner_parameters", "file"};
  const std::string& path = value.path;
  const std::string last = path.substr(path.rfind('.') + 1);  // the whole without a dot
  return last == path || std::any_of(std::begin(kKeys), std::end(kKeys),
                                     [&](const char* key) { return last == key; });
}

/// Goes through all texts of these values together; of very many through each beside the first ones
/// alone.
class CodeSearch {
 public:
  explicit CodeSearch(const Experiment& experiment) {
    std::size_t together = 1;
    for (const ExperimentValue& value : experiment.values) {
      std::vector<std::string> others = mayNameCode(value) ? otherTextsOf(value) : Texts();
      if (!others.empty()) {
        together = std::min(kMostTogether + 1, together * (others.size() + 1));
        values_.emplace_back(value.path, std::move(others));
      }
    }
    isTogether_ = together <= kMostTogether;
  }

  void look(const sim2d::Scenario& scenario, std::size_t from = 0) {
    for (const ForeignCode& code : foreignCodeOf(scenario)) {
      if (std::find(found_.begin(), found_.end(), code) == found_.end()) {
        found_.push_back(code);
      }
    }
    for (std::size_t k = from; k < values_.size(); ++k) {
      for (const std::string& text : values_[k].second) {
        sim2d::Scenario changed = scenario;
        if (!base::hasErrors(sim2d::setValue(changed, values_[k].first, text))) {  // told elsewhere
          look(changed, isTogether_ ? k + 1 : values_.size());
        }
      }
    }
  }
  std::vector<ForeignCode> take() { return std::move(found_); }

 private:
  using Texts = std::vector<std::string>;

  /// Without numbers, which name no code, and the one that the first run has.
  static Texts otherTextsOf(const ExperimentValue& value) {
    Texts texts;
    for (const std::size_t k : value.tellingTexts()) {
      if ((k > 0 || value.isDrawn()) && !base::parseDouble(value.texts[k])) {
        texts.push_back(value.texts[k]);
      }
    }
    return texts;
  }

  static constexpr std::size_t kMostTogether = 2000;
  std::vector<std::pair<std::string, Texts>> values_;  // path, texts
  bool isTogether_ = true;
  std::vector<ForeignCode> found_;
};

}  // namespace

std::vector<ForeignCode> foreignCodeOf(const Experiment& experiment, const sim2d::Scenario& first) {
  CodeSearch search(experiment);
  search.look(first);
  return search.take();
}

std::vector<std::string> inputFilesOf(const Bundle& bundle) {
  std::vector<std::string> paths = inputsOf(bundle);
  for (const ForeignCode& code : foreignCodeOf(*bundle.scenario)) {
    const std::optional<std::string> file = codeFileOf(code, bundle.path);
    if (file && std::find(paths.begin(), paths.end(), *file) == paths.end()) {
      paths.push_back(*file);
    }
  }
  return paths;
}

}  // namespace app
