#include "app/run/BatchFolder.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "app/run/RunFolder.h"
#include "app/run/SeedEffect.h"
#include "app/run/TreeCoverage.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/SystemError.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

constexpr const char* kResults = "results.csv";
constexpr const char* kDatabase = "results.sqlite";

/// The largest number of runs that earlier batches had in this folder; nullopt if the manifest is
/// not of a batch.
std::optional<std::size_t> batchRunCount(const Manifest& manifest) {
  const auto json = nlohmann::json::parse(base::shallowJson(manifest.text));
  std::optional<std::size_t> most;
  for (const char* key : {"runs", "replaces"}) {
    const auto runs = json.find(key);
    if (runs != json.end() && runs->is_number_unsigned()) {
      most = std::max(most.value_or(0), runs->get<std::size_t>());
    }
  }
  return most;
}

using NumberedRuns = std::vector<std::pair<std::size_t, std::string>>;

/// The run folders with their indices.
base::Result<NumberedRuns> numberedRuns(const std::string& runs) {
  NumberedRuns found;
  std::error_code error;
  if (!fs::is_directory(statusOf(runs))) {
    return found;
  }
  for (fs::directory_iterator at(runs, error), end; !error && at != end; at.increment(error)) {
    const auto run = base::parseInt(at->path().filename().string());
    if (run && *run >= 0) {
      found.emplace_back(static_cast<std::size_t>(*run), at->path().string());
    }
  }
  if (error) {
    return base::error("file.cannot-read", {base::systemErrorMessage(error)}, runs);
  }
  return found;
}

/// The first five entries of `runs` that do not belong to an earlier batch of `knownCount` runs and
/// that a batch of `runCount` runs would overwrite.
base::Diagnostics foreignRuns(const NumberedRuns& runs, std::size_t runCount,
                              std::size_t knownCount, bool force) {
  constexpr std::size_t kMaxReported = 5;
  base::Diagnostics problems;
  for (const auto& [index, path] : runs) {
    if (index >= runCount || problems.size() >= kMaxReported) {
      continue;  // not written by this batch
    }
    const auto stranger = foreignEntryIn(path, index < knownCount);
    const bool isFolder = stranger && *stranger != path;
    if (stranger && !(force && isFolder)) {
      problems.push_back(
          base::error(isFolder ? "batch.stranger" : "batch.no-folder", {}, *stranger));
    }
  }
  return problems;
}

/// The paths that would be overwritten and do not belong to an earlier batch. With `force`, only
/// those that are never replaced: links, and files in place of folders.
base::Diagnostics foreignFilesIn(const OutputFolder& output, std::size_t runCount, bool force) {
  const std::string& folder = output.path();
  std::optional<std::size_t> known = batchRunCount(output.manifest());
  if (!known && ResultStore::isResultDatabase(pathIn(folder, kDatabase))) {
    known = runCount;
  }
  for (const char* name : {Manifest::kName, kResults, kDatabase}) {
    if (!known && !force && entryExists(pathIn(folder, name))) {
      return {base::error("batch.stranger", {}, pathIn(folder, name))};
    }
  }
  const std::string runs = pathIn(folder, "runs");
  if (fs::is_symlink(statusOf(runs))) {
    return {base::error("batch.no-folder", {}, runs)};
  }
  const auto folders = numberedRuns(runs);
  if (!folders) {
    return folders.diagnostics();
  }
  base::Diagnostics problems = foreignRuns(*folders, runCount, known.value_or(0), force);
  // While the batch is incomplete, no manifest lists its results.
  const std::string results = pathIn(folder, kResults);
  if (!force && !output.manifest().outputs.empty() && entryExists(results) &&
      !output.manifest().matches(folder, kResults)) {
    problems.push_back(base::error("file.is-in-the-way", {}, results));
  }
  return problems;
}

/// Locates the first line that differs, in the current text.
base::Diagnostic firstDifference(const Study& was, const Study& now) {
  const std::vector<std::string> before = base::split(was.experiment, '\n');
  const std::vector<std::string> after = base::split(now.experiment, '\n');
  std::size_t line = 0;
  while (line < before.size() && line < after.size() && before[line] == after[line]) {
    ++line;
  }
  const std::string text = line < before.size() ? base::trimmed(before[line]) : std::string();
  return base::error("batch.other-experiment", {text}, now.experimentPath,
                     static_cast<int>(line) + 1);
}

void removeQuietly(const std::string& path) {
  std::error_code ignored;  // a remaining file is overwritten later
  fs::remove(path, ignored);
}

/// By path, without the experiment.
std::map<std::string, std::string> hashesOf(const Study& study) {
  std::map<std::string, std::string> hashes;
  for (std::size_t k = 1; k < study.inputs.size(); ++k) {
    hashes[study.inputs[k].path] = study.inputs[k].sha256;
  }
  return hashes;
}

/// Input files that have changed: those of the earlier runs and those of the runs to come.
base::Diagnostics changedInputFiles(const Study& was, const Study& now) {
  const std::map<std::string, std::string> before = hashesOf(was), after = hashesOf(now);
  base::Diagnostics found;
  for (const auto& [path, hash] : after) {
    if (before.count(path) == 0) {
      found.push_back(base::error("batch.other-input", {}, path));
    }
  }
  for (const auto& [path, hash] : before) {
    if (after.count(path) == 0 && sha256OfFile(path) != hash) {
      found.push_back(base::error("batch.other-input", {}, path));
    }
  }
  return found;
}

/// Study::design.
std::string designJson(const Experiment& experiment) {
  if (!experiment.design || !experiment.design->isForSensitivity()) {
    return {};
  }
  nlohmann::ordered_json json = {{"method", experiment.design->methodName()},
                                 {"points", experiment.design->points},
                                 {"seed", experiment.design->seed}};
  for (const ExperimentValue& value : experiment.values) {
    if (value.kind == ExperimentValue::Kind::Between) {
      json["factors"].push_back(
          {{"path", value.path}, {"from", value.numbers[0]}, {"to", value.numbers[1]}});
    }
  }
  return json.dump();
}

}  // namespace

base::Result<Study> studyOf(const Experiment& experiment, const std::vector<InputHash>& inputs,
                            const Shard& shard) {
  Study study;
  base::Diagnostics unread;
  study.version = programVersion();
  study.commit = programCommit();
  study.experimentPath = experiment.path;
  study.experiment = experiment.text;
  study.inputs.reserve(inputs.size() + 1);
  study.inputs.push_back({experiment.path, sha256Of(experiment.text)});
  for (const InputHash& input : inputs) {
    if (input.sha256.empty()) {
      unread.push_back(base::error("file.cannot-read", {"it is missing or damaged"}, input.path));
    }
    study.inputs.push_back(input);
  }
  for (const ExperimentValue& value : experiment.values) {
    study.paths.push_back(value.path);
    if (value.isDrawn()) {
      study.drawn.push_back(value.path);
    }
  }
  study.design = designJson(experiment);
  study.runs = experiment.runCount();
  study.shard = shard;
  study.allowsCode = experiment.allowCode;
  study.until = experiment.until ? experiment.until->text() : std::string();
  return base::resultOf(std::move(study), std::move(unread));
}

base::Diagnostics studyDifferences(const Study& was, const Study& now) {
  base::Diagnostics found;
  if (was.version != now.version || was.commit != now.commit) {
    found.push_back(base::error("batch.other-program", {was.version + " (" + was.commit + ")",
                                                        now.version + " (" + now.commit + ")"}));
  }
  if (was.experiment != now.experiment) {
    found.push_back(firstDifference(was, now));
    return found;  // another experiment may read other files
  }
  if (was.design != now.design) {
    found.push_back(base::error("batch.other-design", {was.design, now.design}));
  }
  if (was.shard.count != now.shard.count) {
    found.push_back(base::error("batch.other-shards", {was.shard.count, now.shard.count}));
  }
  const std::map<std::string, std::string> hashes = hashesOf(was);
  for (const InputHash& input : now.inputs) {
    const auto same = hashes.find(input.path);
    if (same != hashes.end() && same->second != input.sha256) {
      found.push_back(base::error("batch.other-input", {}, input.path));
    }
  }
  return found;
}

base::Result<std::unique_ptr<BatchFolder>> BatchFolder::open(const std::string& folder,
                                                             const Study& study,
                                                             ExistingBatch earlier) {
  // Forced, because foreignFilesIn() decides what may be overwritten.
  base::Result<std::unique_ptr<OutputFolder>> output = OutputFolder::open(folder, true);
  if (!output) {
    return output.diagnostics();
  }
  std::unique_ptr<BatchFolder> batch(new BatchFolder(*std::move(output)));
  base::Diagnostics problems =
      foreignFilesIn(*batch->output_, study.runs, earlier == ExistingBatch::Replace);
  if (!base::hasErrors(problems)) {
    problems = batch->resumeExisting(study, earlier);
  }
  if (!base::hasErrors(problems) && !batch->store_) {
    problems = batch->begin(study);
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  return batch;
}

/// Takes over the store of an earlier batch if it is to be resumed.
base::Diagnostics BatchFolder::resumeExisting(const Study& study, ExistingBatch earlier) {
  const std::string path = pathIn(output_->path(), kDatabase);
  if (!entryExists(path) || earlier == ExistingBatch::Replace) {
    return {};
  }
  base::Result<std::unique_ptr<ResultStore>> store = ResultStore::open(path);
  if (!store) {
    return store.diagnostics();
  }
  const ResultStore& found = **store;
  if (earlier == ExistingBatch::Refuse) {
    const std::size_t runs = found.study().shard.runCount(found.study().runs);
    return found.isComplete() ? base::Diagnostics()
                              : base::Diagnostics{base::error(
                                    "batch.unfinished", {found.finished(), runs}, output_->path())};
  }
  base::Diagnostics problems = studyDifferences(found.study(), study);
  if (problems.empty()) {
    problems = changedInputFiles(found.study(), study);
  }
  if (problems.empty() && found.study().shard.number != study.shard.number) {
    problems.push_back(base::error(
        "batch.other-shard", {found.study().shard.text(), study.shard.text()}, output_->path()));
  }
  if (problems.empty()) {
    problems = (*store)->removeFailed(earlier == ExistingBatch::Retry);
  }
  if (problems.empty() && study.timeLimit > 0.0 && !found.isComplete()) {
    problems = (*store)->setTimeLimit(study.timeLimit);
  }
  if (problems.empty()) {
    store_ = *std::move(store);
  }
  return problems;
}

/// The manifest is written first, so that the folder is that of a batch even if this one is
/// interrupted.
base::Diagnostics BatchFolder::begin(const Study& study) {
  const std::size_t former = batchRunCount(output_->manifest()).value_or(0);
  base::Diagnostics problems =
      output_->commit(emptyManifest(study, former), OutputFolder::EarlierFiles::Removed);
  if (base::hasErrors(problems)) {
    return problems;
  }
  for (const char* name : {kResults, kDatabase, "results.sqlite-wal", "results.sqlite-journal"}) {
    removeQuietly(pathIn(output_->path(), name));
  }
  const auto folders = numberedRuns(runsFolder());
  if (!folders) {
    return folders.diagnostics();
  }
  for (const auto& [run, path] : *folders) {
    if (run < std::max(former, study.runs)) {
      base::append(problems, removeRunFolder(path));
    }
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  base::Result<std::unique_ptr<ResultStore>> store =
      ResultStore::create(pathIn(output_->path(), kDatabase), study);
  if (!store) {
    return store.diagnostics();
  }
  store_ = *std::move(store);
  return {};
}

std::string BatchFolder::runsFolder() const {
  return pathIn(output_->path(), "runs");
}

std::string BatchFolder::resultsFile() const {
  return pathIn(output_->path(), kResults);
}

std::string BatchFolder::manifest() const {
  const base::Result<Manifest> manifest = readManifest(output_->path());
  return manifest ? manifest->text : std::string();
}

std::vector<std::size_t> BatchFolder::missing() const {
  std::vector<std::size_t> runs;
  const Study& study = store_->study();
  for (std::size_t run = study.shard.number - 1; run < study.runs; run += study.shard.count) {
    if (!store_->has(run)) {
      runs.push_back(run);
    }
  }
  return runs;
}

/// Removes run folders of interrupted runs. A run that is in the table is complete and stays, even
/// without its manifest.
base::Diagnostics BatchFolder::removeIncompleteRuns() const {
  const auto folders = numberedRuns(runsFolder());
  base::Diagnostics problems = folders.diagnostics();
  for (const auto& [run, path] : folders ? *folders : NumberedRuns()) {
    const auto contains = [&place = path](const char* name) {
      return entryExists(pathIn(place, name));
    };
    if (run < store_->study().runs &&
        (!store_->has(run) || !(contains("manifest.json") || contains("trace.json")))) {
      base::append(problems, removeRunFolder(path));
    } else if (run < store_->study().runs && contains(FolderLock::kFile)) {
      const auto lock = FolderLock::acquire(path);  // the destructor removes the file
    }
  }
  if (fs::is_directory(statusOf(runsFolder()))) {
    removeQuietly(runsFolder());  // has no effect while runs are kept in it
  }
  return problems;
}

base::Diagnostics BatchFolder::finish() {
  const base::Diagnostics removalProblems = removeIncompleteRuns();
  base::Diagnostics problems =
      output_->withFinalPaths(writeResults(*store_, pathIn(output_->staging(), kResults)));
  const base::Result<std::vector<CoveredTree>> trees = treeCoverageOf(*store_);
  base::append(problems, trees.diagnostics());
  if (trees && !trees->empty()) {
    base::append(problems, output_->write(kTreeCoverageFile, treeCoverageCsv(*trees)));
  }
  const base::Result<std::string> manifest = batchManifest(*store_);
  base::append(problems, manifest.diagnostics());
  if (!base::hasErrors(problems)) {
    problems = output_->commit(*manifest, OutputFolder::EarlierFiles::Removed);
  }
  constantCells_ = seedEffectOf(*store_).constantCells();
  base::append(problems, store_->close());
  base::append(problems, removalProblems);
  return problems;
}

base::Result<LockedResults> readResults(const std::string& folder) {
  const std::string path = pathIn(folder, kDatabase);
  if (!entryExists(path)) {
    return base::error("batch.no-results", {}, folder);
  }
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::acquire(folder);
  if (!lock) {
    return lock.diagnostics();
  }
  base::Result<std::unique_ptr<ResultStore>> store = ResultStore::open(path);
  if (!store) {
    return store.diagnostics();
  }
  return LockedResults{*std::move(lock), *std::move(store)};
}

std::optional<std::string> experimentFileOf(const std::string& named, const std::string& folder) {
  if (named == kStandardInput) {
    return std::nullopt;
  }
  std::error_code ignored;
  for (const fs::path& base : {fs::path(), fs::path(folder), fs::path(folder) / ".."}) {
    if (!named.empty() && fs::is_regular_file(base / named, ignored)) {
      return fs::absolute(base / named, ignored).lexically_normal().string();
    }
  }
  return std::nullopt;
}

}  // namespace app
