#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>

#include "app/report/Comparison.h"
#include "app/report/Study.h"
#include "app/run/ExperimentValues.h"
#include "app/run/ResultRow.h"
#include "sim2d/base/Text.h"

namespace report {

namespace {

constexpr const char* kUsualMetrics[] = {"success",
                                         "ended_by_success",
                                         "ended_by_failure",
                                         "ended_by_contact",
                                         "ended_by_time",
                                         "time_to_reach_goal",
                                         "path_length",
                                         "path_efficiency",
                                         "minimum_distance_to_people",
                                         "robot_on_person_collision",
                                         "intimate_space_intrusions",
                                         "personal_space_intrusions"};
constexpr const char* kScenario = "scenario";
constexpr const char* kPareto = "--pareto";

Metric metricOf(const std::string& key, bool isBoolean) {
  Metric metric{key, key, {}, isBoolean, 0};
  if (const std::optional<app::ColumnInfo> info = app::columnInfo(key)) {
    metric.name = info->name;
    metric.unit = info->unit;
    metric.isRate = isBoolean || info->isBoolean;
    metric.sense = info->sense;
  }
  return metric;
}

/// The distinct texts in order of first appearance.
std::vector<std::string> distinct(const std::vector<std::string>& texts) {
  std::vector<std::string> found;
  std::set<std::string> seen;
  for (const std::string& text : texts) {
    if (seen.insert(text).second) {
      found.push_back(text);
    }
  }
  return found;
}

std::vector<std::size_t> placesIn(const std::vector<std::string>& names,
                                  const std::vector<std::string>& texts) {
  std::map<std::string, std::size_t> places;
  for (const std::string& name : names) {
    places.emplace(name, places.size());
  }
  std::vector<std::size_t> found;
  found.reserve(texts.size());
  for (const std::string& text : texts) {
    found.push_back(places.at(text));
  }
  return found;
}

/// The length of the common folder prefix of all scenarios.
std::size_t commonPrefixLength(const std::vector<Results::Run>& runs) {
  std::string shared = runs.empty() ? std::string() : runs.front().scenario;
  for (const Results::Run& run : runs) {
    const auto same =
        std::mismatch(shared.begin(), shared.end(), run.scenario.begin(), run.scenario.end());
    shared.erase(same.first, shared.end());
  }
  return shared.rfind('/') + 1;  // 0: none
}

/// The last part of a path: "pedestrian_max_vel".
std::string shortPath(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

/// Sets the members of the study and checks the options.
class StudyBuilder {
 public:
  StudyBuilder(const StudyOptions& studyOptions, Study& study)
      : studyOptions_(studyOptions), study_(study) {}

  base::Diagnostics make() {
    const Results& results = study_.results;
    for (std::size_t k = 0; k < results.keys.size(); ++k) {
      study_.metrics.push_back(metricOf(results.keys[k], results.isBoolean[k]));
    }
    chooseMetrics();
    choosePareto();
    study_.commonPrefixLength = commonPrefixLength(study_.results.runs);
    selectCompared();
    nameCases();
    const std::string what = study_.compared.empty()        ? "Batch results"
                             : study_.compared == kScenario ? "Scenarios compared"
                             : hasPlanners(study_.compared)
                                 ? "Planners compared"
                                 : titleOf(shortPath(study_.compared)) + " compared";
    study_.title = what;
    return std::move(problems_);
  }

 private:
  static std::string titleOf(std::string word) {
    std::replace(word.begin(), word.end(), '_', ' ');
    if (!word.empty() && word[0] >= 'a' && word[0] <= 'z') {
      word[0] = static_cast<char>(word[0] - 'a' + 'A');
    }
    return word + (word == "Model" ? "s" : "");
  }

  /// The index of a key given by the user; reports unknown keys.
  std::optional<std::size_t> placeOf(const std::string& key, const char* option) {
    const std::size_t place = study_.results.keyAt(key);
    if (place < study_.results.keys.size()) {
      return place;
    }
    problems_.push_back(base::error("metrics.unknown-metric",
                                    {key, base::nearestName(key, study_.results.keys)}, option));
    return std::nullopt;
  }

  void chooseMetrics() {
    for (const std::string& key : distinct(studyOptions_.metrics)) {
      if (const auto place = placeOf(key, "--metrics")) {
        study_.shown.push_back(*place);
      }
    }
    for (const auto& [key, weight] : studyOptions_.weights) {
      const auto place = placeOf(key, "--weights");
      if (place && study_.metrics[*place].sense == 0) {
        problems_.push_back(base::error("report.no-better", {key}, "--weights"));
      }
    }
    study_.hasChosenMetrics = !studyOptions_.metrics.empty();
    if (study_.hasChosenMetrics) {
      return;
    }
    for (const char* key : kUsualMetrics) {
      const std::size_t place = study_.results.keyAt(key);
      if (place < study_.results.keys.size() && hasValues(place)) {
        study_.shown.push_back(place);
      }
    }
    constexpr std::size_t kFew = 6;
    for (std::size_t k = 0; study_.shown.empty() && k < study_.results.keys.size(); ++k) {
      if (hasValues(k)) {  // custom metrics
        study_.shown.push_back(k);
      }
    }
    study_.shown.resize(std::min(study_.shown.size(), std::max(kFew, std::size(kUsualMetrics))));
  }

  bool hasValues(std::size_t metric) const {
    for (std::size_t run = 0; run < study_.runCount(); ++run) {
      if (!std::isnan(valueOf(study_, metric, run))) {
        return true;
      }
    }
    return false;
  }

  void choosePareto() {
    const std::string x =
        studyOptions_.paretoX.empty() ? "time_to_reach_goal" : studyOptions_.paretoX;
    const std::string y =
        studyOptions_.paretoY.empty() ? "minimum_distance_to_people" : studyOptions_.paretoY;
    const std::size_t known = study_.results.keys.size();
    const bool isAsked = !studyOptions_.paretoX.empty();
    const std::size_t atX = isAsked ? placeOf(x, kPareto).value_or(known) : study_.results.keyAt(x);
    const std::size_t atY = isAsked ? placeOf(y, kPareto).value_or(known) : study_.results.keyAt(y);
    if (atX < known && atY < known && hasValues(atX) && hasValues(atY)) {
      study_.pareto = {atX, atY};
    }
  }

  /// The values of a path, or the scenario names, per run.
  std::vector<std::string> column(const std::string& path) const {
    const auto& paths = study_.results.paths;
    const auto at =
        static_cast<std::size_t>(std::find(paths.begin(), paths.end(), path) - paths.begin());
    std::vector<std::string> texts;
    texts.reserve(study_.runCount());
    for (std::size_t run = 0; run < study_.runCount(); ++run) {
      texts.push_back(at < paths.size() ? study_.results.runs[run].values[at]
                                        : study_.scenarioName(run));
    }
    return texts;
  }
  bool isDrawn(const std::string& path) const {
    return std::find(study_.drawn.begin(), study_.drawn.end(), path) != study_.drawn.end();
  }
  /// Whether the experiment varies the path; drawn values belong to the seed.
  bool isVaried(const std::string& path) const {
    return !isDrawn(path) && distinct(column(path)).size() > 1;
  }

  bool hasPlanners(const std::string& path) const {
    return app::arePlanners(path, distinct(column(path)));
  }

  std::string defaultComparedPath() const {
    const auto& paths = study_.results.paths;
    for (const bool wantsPlanner : {true, false}) {
      for (const std::string& path : paths) {
        if ((!wantsPlanner || hasPlanners(path)) && isVaried(path)) {
          return path;
        }
      }
    }
    return isVaried(kScenario) ? kScenario : std::string();
  }

  void selectCompared() {
    const auto& paths = study_.results.paths;
    study_.compared = studyOptions_.compare.empty() ? defaultComparedPath() : studyOptions_.compare;
    if (!studyOptions_.compare.empty() && studyOptions_.compare != kScenario &&
        std::find(paths.begin(), paths.end(), studyOptions_.compare) == paths.end()) {
      std::vector<std::string> known;
      std::copy_if(paths.begin(), paths.end(), std::back_inserter(known),
                   [this](const std::string& path) { return !isDrawn(path); });
      known.emplace_back(kScenario);
      problems_.push_back(base::error(
          "report.unknown-path", {studyOptions_.compare, base::join(known, ", ")}, "--compare"));
      study_.compared.clear();
    } else if (isDrawn(study_.compared)) {
      problems_.push_back(base::error("report.drawn-path", {study_.compared}, "--compare"));
    }
    const std::vector<std::string> texts =
        study_.compared.empty() ? std::vector<std::string>(study_.runCount(), "all runs")
                                : column(study_.compared);
    study_.options = distinct(texts);
    study_.optionOf = placesIn(study_.options, texts);
    study_.options = app::optionLabels(study_.options);
  }

  /// Names the cases by the other varied values.
  void nameCases() {
    std::vector<std::string> texts(study_.runCount());
    const auto add = [&](const std::string& path, bool withName) {
      if (path == study_.compared || !isVaried(path)) {
        return;
      }
      const std::vector<std::string> words = column(path);
      for (std::size_t run = 0; run < texts.size(); ++run) {
        texts[run] += (texts[run].empty() ? "" : ", ") +
                      (withName ? shortPath(path) + " " + words[run] : words[run]);
      }
    };
    add(kScenario, false);
    for (const std::string& path : study_.results.paths) {
      add(path, true);
    }
    for (std::size_t run = 0; run < texts.size(); ++run) {
      if (texts[run].empty()) {
        texts[run] = study_.compared == kScenario ? "all" : study_.scenarioName(run);
      }
    }
    study_.cases = distinct(texts);
    study_.caseOf = placesIn(study_.cases, texts);
  }

  const StudyOptions& studyOptions_;
  Study& study_;
  base::Diagnostics problems_;
};

}  // namespace

base::Diagnostics selectCompared(const StudyOptions& studyOptions, Study& study) {
  return StudyBuilder(studyOptions, study).make();
}

}  // namespace report
