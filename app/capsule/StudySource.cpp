#include "app/capsule/StudySource.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/capsule/InputTree.h"
#include "app/run/BatchFolder.h"
#include "app/run/Experiment.h"
#include "app/run/ExperimentRunner.h"
#include "app/run/OutputFolder.h"
#include "app/run/PlannerFiles.h"
#include "app/run/RunSpec.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace capsule {

namespace {

namespace fs = std::filesystem;
using SourceJson = nlohmann::json;

constexpr const char* kDatabase = "results.sqlite";

/// Adds the files that a manifest of the folder `place` (relative to the study, with a final '/' or
/// empty) lists, and the manifest itself. Errors: files that have changed.
base::Diagnostics addListedFiles(const std::string& study, const std::string& place,
                                 const char* manifestName, std::set<std::string>& names) {
  const std::string folder = app::pathIn(study, place);
  const base::Result<app::Manifest> manifest = app::readManifest(folder, manifestName);
  if (!manifest) {
    return manifest.diagnostics();
  }
  base::Diagnostics problems;
  for (const auto& [name, hash] : manifest->outputs) {
    if (!manifest->matches(folder, name)) {
      problems.push_back(base::error("capsule.changed", {}, app::pathIn(folder, name)));
    }
    names.insert(place + name);
  }
  if (app::entryExists(app::pathIn(folder, manifestName))) {
    names.insert(place + manifestName);
  }
  return problems;
}

/// Files of the kept runs.
base::Diagnostics addRunFiles(const std::string& study, std::set<std::string>& names) {
  base::Diagnostics problems;
  std::error_code failure;
  const fs::path runs = fs::path(study) / "runs";
  if (!fs::is_directory(app::statusOf(runs.string()))) {
    return {};
  }
  for (fs::directory_iterator at(runs, failure), end; !failure && at != end;
       at.increment(failure)) {
    const std::string name = at->path().filename().string();
    if (base::parseInt(name) && fs::is_directory(at->symlink_status(failure))) {
      base::append(problems,
                   addListedFiles(study, "runs/" + name + "/", app::Manifest::kName, names));
    }
  }
  if (failure) {
    problems.push_back(base::error("file.cannot-read", {failure.message()}, runs.string()));
  }
  return problems;
}

/// Programs and libraries that runs of the experiment start.
std::set<std::string> codeFilesOf(const app::Experiment& experiment) {
  std::set<std::string> files;
  for (std::size_t k = 0; k < experiment.scenarioPaths.size(); ++k) {
    for (const app::ExternalCode& code : app::externalCodeOf(experiment, k)) {
      if (const auto file = app::codeFileOf(code, experiment.scenarioPaths[k])) {
        std::error_code ignored;
        files.insert(fs::absolute(*file, ignored).lexically_normal().string());
      }
    }
  }
  return files;
}

base::Diagnostics addInput(const app::InputHash& recorded, StudySource& source) {
  const auto path = locateInput(recorded.path, source.folder, recorded.sha256);
  if (!path) {
    return {base::error("capsule.input-changed", {}, recorded.path)};
  }
  source.inputs.push_back({recorded, *path, {}, false});
  return {};
}

base::Diagnostics readBatch(StudySource& source) {
  const base::Result<app::LockedResults> results = app::readResults(source.folder);
  if (!results) {
    return results.diagnostics();
  }
  const app::Study& study = results->store->study();
  source.version = study.version;
  source.commit = study.commit;
  source.runs = study.shard.runCount(study.runs);
  source.finished = results->store->finished();
  source.allowsCode = study.allowsCode;
  // It may have changed or may be gone: its text is in the results.
  const std::string experiment =
      app::experimentFileOf(study.experimentPath, source.folder)
          .value_or(app::absolutePath(study.experimentPath == app::kStandardInput
                                          ? "experiment.yaml"
                                          : study.experimentPath));
  source.inputs.push_back({study.inputs.front(), experiment, study.experiment, false});
  base::Diagnostics problems;
  for (std::size_t k = 1; k < study.inputs.size(); ++k) {
    base::append(problems, addInput(study.inputs[k], source));
  }
  const base::Result<app::Experiment> parsed = app::parseExperiment(study.experiment, experiment);
  const std::set<std::string> code = parsed ? codeFilesOf(*parsed) : std::set<std::string>();
  for (SourceInput& input : source.inputs) {
    input.isCode = code.count(input.path) != 0;
  }
  base::append(problems, app::errorsOf(parsed.diagnostics()));
  std::set<std::string> names = {kDatabase};
  for (const char* manifest : {app::Manifest::kName, app::Manifest::kHiddenName}) {
    base::append(problems, addListedFiles(source.folder, "", manifest, names));
  }
  base::append(problems, addRunFiles(source.folder, names));
  source.files.assign(names.begin(), names.end());
  return problems;
}

/// The file of the option --metrics is an input that manifests do not list.
void addMetricsFile(std::vector<std::string> words, StudySource& source) {
  words.erase(words.begin(), words.begin() + (words.empty() ? 0 : 1));
  const base::Result<app::RunSpec> spec = app::runSpecOfCommandLine(words);
  const std::string file = spec ? spec->metrics : std::string();
  const std::optional<std::string> hash = app::sha256OfFile(file);
  if (!file.empty() && file != app::kStandardInput && hash) {
    std::error_code ignored;
    source.inputs.push_back(
        {{file, *hash}, fs::absolute(file, ignored).lexically_normal().string(), {}, false});
  }
}

/// What the manifest of a run says of its making. Throws exceptions of the JSON library.
base::Diagnostics readRunFields(const SourceJson& manifest, StudySource& source) {
  source.version = manifest.at("program").at("version").get<std::string>();
  source.commit = manifest.at("program").at("commit").get<std::string>();
  source.allowsCode = manifest.at("code").at("allowed").get<bool>();
  base::Diagnostics problems;
  if (manifest.contains("from")) {
    problems.push_back(base::error("capsule.continued-run", {}, source.folder));
  }
  if (manifest.at("status") == "interrupted") {
    problems.push_back(base::error("capsule.unfinished", {}, source.folder));
  }
  const auto take = [&](const SourceJson& input, bool isCode) {
    const SourceJson& hash = input.at("sha256");
    const std::size_t before = source.inputs.size();
    base::append(problems, addInput({input.at("path").get<std::string>(),
                                     hash.is_string() ? hash.get<std::string>() : std::string()},
                                    source));
    if (source.inputs.size() > before) {
      source.inputs.back().isCode = isCode;
    }
  };
  for (const SourceJson& input : manifest.at("inputs")) {
    take(input, false);
  }
  for (const SourceJson& code : manifest.at("code").at("started")) {
    for (const SourceJson& file : code.at("files")) {
      take(file, true);
    }
  }
  addMetricsFile(manifest.at("command_line").get<std::vector<std::string>>(), source);
  return problems;
}

base::Diagnostics readSingleRun(const app::Manifest& manifest, StudySource& source) {
  base::Diagnostics problems;
  try {
    problems = readRunFields(SourceJson::parse(base::shallowJson(manifest.text)), source);
  } catch (const SourceJson::exception&) {
    return {base::error("capsule.no-study", {}, source.folder)};
  }
  std::set<std::string> names;
  base::append(problems, addListedFiles(source.folder, "", app::Manifest::kName, names));
  source.files.assign(names.begin(), names.end());
  return problems;
}

}  // namespace

base::Result<StudySource> readStudySource(const std::string& folder) {
  base::Diagnostics problems = app::completeCommit(folder);
  const base::Result<app::Manifest> manifest = app::readManifest(folder);
  base::append(problems, manifest.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  StudySource source;
  source.folder = folder;
  source.isBatch = app::ResultStore::isResultDatabase(app::pathIn(folder, kDatabase));
  if (source.isBatch && !app::entryExists(app::pathIn(folder, "results.csv"))) {
    return base::error("capsule.unfinished", {}, folder);
  }
  const bool isRun = SourceJson::parse(base::shallowJson(manifest->text)).contains("command_line");
  if (!source.isBatch && !isRun) {
    return base::error("capsule.no-study", {}, folder);
  }
  problems = source.isBatch ? readBatch(source) : readSingleRun(*manifest, source);
  if (source.finished < source.runs) {
    problems.push_back(base::warning("capsule.incomplete", {source.finished, source.runs}, folder));
  }
  return base::resultOf(std::move(source), std::move(problems));
}

}  // namespace capsule
