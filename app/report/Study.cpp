#include "app/report/Study.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "app/run/Experiment.h"
#include "app/run/ManifestFiles.h"
#include "sim2d/base/Text.h"
#include "sim2d/world/Runner.h"

namespace report {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string textIn(const Json& object, const char* key) {
  const auto found = object.is_object() ? object.find(key) : object.end();
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Reads the `run` options of the experiment, if the file is unchanged. Returns the errors if it
/// exists but cannot be read.
base::Diagnostics readRunOptions(Study& study) {
  std::error_code gone;
  if (study.inputs.empty() || !fs::exists(study.inputs.front().path, gone)) {
    return {};
  }
  const auto& [path, hash] = study.inputs.front();
  const base::Result<std::string> text = base::readTextFile(path);
  if (text && app::sha256Of(*text) != hash) {
    return {};
  }
  const base::Result<app::Experiment> experiment =
      text ? app::readExperiment(path) : base::Result<app::Experiment>(text.diagnostics());
  if (!experiment) {
    return experiment.diagnostics();
  }
  study.hasRunOptions = true;
  const std::vector<std::string> words = app::commandLineOf(experiment->common);
  study.runOptions.assign(words.begin() + 1, words.end());  // without `run`
  return {};
}

/// Reads "drawn": scenario -> seed -> path -> value.
void readDrawn(const Json& manifest, Study& study) {
  std::set<std::string> paths;
  const auto drawn = manifest.find("drawn");
  for (const Json& seeds : drawn != manifest.end() ? *drawn : Json()) {
    for (const Json& values : seeds) {
      for (auto value = values.begin(); values.is_object() && value != values.end(); ++value) {
        paths.insert(value.key());
      }
    }
  }
  study.drawn.assign(paths.begin(), paths.end());
}

base::Diagnostics readManifest(const fs::path& path, Study& study) {
  std::error_code ignored;  // inaccessible counts as missing
  if (!fs::exists(path, ignored)) {
    return {base::warning("report.no-manifest", {}, path.string())};
  }
  const base::Result<std::string> text = base::readTextFile(path.string(), base::kMaxRecord);
  if (!text) {
    return text.diagnostics();
  }
  const Json manifest = Json::parse(*text, nullptr, false);
  const bool isManifest = manifest.is_object() && manifest.contains("program") &&
                          manifest.contains("inputs") && manifest["inputs"].is_array() &&
                          manifest.contains("runs");
  if (!isManifest) {
    return {base::error("report.bad-manifest", {}, path.string())};
  }
  study.version = textIn(manifest["program"], "version");
  study.commit = textIn(manifest["program"], "commit");
  study.status = textIn(manifest, "status");
  for (const Json& input : manifest["inputs"]) {
    study.inputs.push_back({textIn(input, "path"), textIn(input, "sha256")});
  }
  study.shard = textIn(manifest, "shard");
  const auto code = manifest.find("code");
  study.allowsCode = code != manifest.end() && code->is_object() && code->value("allowed", false);
  const auto limit = manifest.find("time_limit");
  if (limit != manifest.end() && limit->is_number()) {
    study.timeLimit = limit->get<double>();
  }
  readDrawn(manifest, study);
  return {};
}

bool isPlainWord(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) {
    return base::isLetter(c) || base::isDigit(c) ||
           std::string_view("_-./=,:+@%").find(c) != std::string_view::npos;
  });
}

}  // namespace

std::string shellText(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) {
    text += text.empty() ? "" : " ";
    if (isPlainWord(word)) {
      text += word;
      continue;
    }
    text += '\'';
    for (const char c : word) {
      text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    text += '\'';
  }
  return text;
}

std::string Study::scenarioName(std::size_t run) const {
  return results.runs[run].scenario.substr(commonPrefixLength);
}

std::optional<std::string> Study::runFolder(std::size_t run) const {
  const fs::path place = fs::path(folder) / "runs" / std::to_string(results.runs[run].number);
  std::error_code ignored;  // inaccessible counts as missing
  return fs::exists(place / "trace.json", ignored) ? std::optional(place.string()) : std::nullopt;
}

std::string Study::outcomeText(std::size_t run) const {
  if (!results.runs[run].ok) {
    return results.runs[run].reason.empty() ? "failed" : results.runs[run].reason;
  }
  const struct {
    const char* key;
    bool whenZero;
    const char* words;
  } signs[] = {{"robot_on_person_collision", false, "collided with a person"},
               {"person_on_robot_collision", false, "a person collided with the robot"},
               {"obstacle_collisions", false, "collided with an obstacle"},
               {"timeout", false, "timeout"},
               {"completed", true, "goal not reached"}};
  std::vector<std::string> texts;
  for (const auto& sign : signs) {
    const std::size_t metric = results.keyAt(sign.key);
    const bool isKnown = metric < results.keys.size();
    if (isKnown && (sign.whenZero ? valuesOf(metric)[run] == 0.0 : valuesOf(metric)[run] > 0.0)) {
      texts.emplace_back(sign.words);
    }
  }
  for (const sim2d::NavigationOutcome end :
       {sim2d::NavigationOutcome::NavigationFailed, sim2d::NavigationOutcome::GoalMissed}) {
    if (results.runs[run].reason.rfind(sim2d::navigationOutcomeName(end), 0) == 0) {
      texts.push_back(results.runs[run].reason);
    }
  }
  return texts.empty() ? "not successful" : base::join(texts, ", ");
}

std::vector<std::string> Study::batchCommand() const {
  std::vector<std::string> words = {"hunavsim", "batch", inputs.front().path, "-o", folder};
  if (allowsCode) {
    words.emplace_back("--allow-code");
  }
  if (timeLimit) {
    words.insert(words.end(), {"--time-limit", base::formatDouble(*timeLimit)});
  }
  if (!shard.empty()) {
    words.insert(words.end(), {"--shard", shard});
  }
  return words;
}

std::string Study::replayCommand(std::size_t run) const {
  if (const std::optional<std::string> kept = runFolder(run)) {
    return shellText({"hunavsim", *kept});
  }
  const Results::Run& row = results.runs[run];
  std::string scenario = row.scenario;
  for (const Input& input : inputs) {  // the path on disk, if known
    const fs::path path(input.path);
    if (input.path == row.scenario || endsWith(input.path, "/" + row.scenario) ||
        path.stem().string() == row.scenario) {
      scenario = input.path;
    }
  }
  std::vector<std::string> words = {"hunavsim", scenario, "--seed", std::to_string(row.seed)};
  words.insert(words.end(), runOptions.begin(), runOptions.end());
  for (std::size_t k = 0; k < results.paths.size(); ++k) {
    words.insert(words.end(), {"--set", results.paths[k] + "=" + row.values[k]});
  }
  return shellText(words);
}

base::Result<Study> readStudy(const StudyOptions& studyOptions) {
  const std::string file = (fs::path(studyOptions.folder) / "results.csv").string();
  const base::Result<std::string> text = base::readTextFile(file, base::kMaxRecord);
  Study manifest;
  base::Diagnostics problems = text.diagnostics();
  base::append(problems, readManifest(fs::path(studyOptions.folder) / "manifest.json", manifest));
  base::append(problems, app::checkManifestFiles(studyOptions.folder, {"results.csv"}));
  if (!text) {
    return problems;
  }
  base::Result<Results> results = parseResults(*text, file);
  base::append(problems, results.diagnostics());
  if (!results) {
    return problems;
  }
  Study study = std::move(manifest);
  study.folder = studyOptions.folder;
  study.results = *std::move(results);
  study.level = studyOptions.level;
  study.resamples = studyOptions.resamples;
  base::append(problems, selectCompared(studyOptions, study));
  if (base::hasErrors(problems)) {
    return problems;
  }
  study.resultsHash = app::sha256Of(*text);
  for (base::Diagnostic& problem : readRunOptions(study)) {
    problem.severity = base::Severity::Warning;
    problems.push_back(std::move(problem));
    study.isExperimentUnreadable = true;
  }
  return base::Result<Study>(std::move(study), std::move(problems));
}

}  // namespace report
