#include "app/run/ExperimentInputs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "app/run/RunFolder.h"
#include "sim2d/base/Text.h"
#include "sim2d/scenario/ScenarioFile.h"

namespace app {

namespace {

/// Each file once. What a value names and nobody has is told by the runs that want it.
class FileList {
 public:
  explicit FileList(std::vector<std::string> first) : paths_(std::move(first)) {
    known_.insert(paths_.begin(), paths_.end());
  }
  void add(const std::vector<std::string>& paths) {
    std::error_code ignored;
    for (const std::string& path : paths) {
      if (std::filesystem::is_regular_file(path, ignored) && known_.insert(path).second) {
        paths_.push_back(path);
      }
    }
  }
  std::vector<std::string> take() { return std::move(paths_); }

 private:
  std::vector<std::string> paths_;
  std::set<std::string> known_;
};

std::set<std::string> treePathsOf(const Bundle& bundle) {
  std::set<std::string> paths;
  for (const auto& [person, tree] : bundle.trees) {
    paths.insert(tree.path);
  }
  return paths;
}

/// No number names a file.
bool mayNameFile(const std::string& text) {
  return !base::parseDouble(text);
}

}  // namespace

std::vector<ForeignCode> foreignCodeOf(const Experiment& experiment, const sim2d::Scenario& first) {
  std::vector<ForeignCode> all = foreignCodeOf(first);
  for (const ExperimentValue& value : experiment.values) {
    for (const std::size_t k : value.tellingTexts()) {
      sim2d::Scenario changed = first;
      if (base::hasErrors(sim2d::setValue(changed, value.path, value.texts[k]))) {
        continue;  // told by who read the experiment
      }
      for (const ForeignCode& code : foreignCodeOf(changed)) {
        if (std::find(all.begin(), all.end(), code) == all.end()) {
          all.push_back(code);
        }
      }
    }
  }
  return all;
}

std::vector<std::string> filesOf(const Experiment& experiment, std::size_t scenario,
                                 const Bundle& first, KnownFiles& files) {
  FileList list(inputsOf(first));
  for (const ForeignCode& code : foreignCodeOf(experiment, *first.scenario)) {
    if (const std::optional<std::string> file = fileOf(code, first.path)) {
      list.add({*file});
    }
  }
  const std::set<std::string> trees = treePathsOf(first);
  const std::size_t run = scenario * (experiment.runCount() / experiment.scenarios.size());
  for (std::size_t k = 0; k < experiment.values.size(); ++k) {
    const ExperimentValue& value = experiment.values[k];
    for (const std::size_t text : value.tellingTexts()) {
      if (!mayNameFile(value.texts[text])) {
        continue;
      }
      RunOptions options = experiment.optionsOf(run);
      options.set[k] = value.path + "=" + value.texts[text];
      Bundle other = readBundle(options, first.settings, files);
      for (auto tree = other.trees.begin(); tree != other.trees.end();) {  // to be parsed
        tree = trees.count(tree->second.path) != 0 ? other.trees.erase(tree) : std::next(tree);
      }
      list.add(inputsOf(other));
    }
  }
  return list.take();
}

}  // namespace app
