#include "app/run/BatchFolder.h"

#include <algorithm>
#include <filesystem>
#include <map>

#include <nlohmann/json.hpp>

#include "app/run/DataPaths.h"
#include "app/run/ManifestFiles.h"
#include "app/run/OutputFolder.h"
#include "app/run/ResultFiles.h"
#include "app/run/RunFolder.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;

std::string fileIn(const std::string& folder, const char* name) {
  return (fs::path(folder) / name).string();
}

bool pathExists(const std::string& path) {
  std::error_code ignored;
  return fs::exists(fs::symlink_status(path, ignored));
}

/// The largest number of runs that earlier batches had in this folder; nullopt if the manifest is
/// not of a batch.
base::Result<std::optional<std::size_t>> batchRunCount(const std::string& folder) {
  const base::Result<std::string> text = manifestText(folder, "manifest.json");
  if (!text) {
    return text.diagnostics();
  }
  const auto manifest = nlohmann::json::parse(*text);
  std::optional<std::size_t> most;
  for (const char* key : {"runs", "replaces"}) {
    const auto runs = manifest.find(key);
    if (runs != manifest.end() && runs->is_number_unsigned()) {
      most = std::max(most.value_or(0), runs->get<std::size_t>());
    }
  }
  return most;
}

/// Error if results.csv differs from the one that the earlier batch wrote. While it is being
/// replaced, no manifest lists it.
base::Diagnostics checkResultsUnchanged(const std::string& folder) {
  const base::Result<FileHashes> listed = manifestFiles(folder, "manifest.json");
  if (!listed) {
    return listed.diagnostics();
  }
  const std::string results = fileIn(folder, "results.csv");
  const bool isOther =
      pathExists(results) && !listed->empty() && !matchesManifest(folder, *listed, "results.csv");
  return isOther ? base::Diagnostics{base::error("file.is-in-the-way", {}, results)}
                 : base::Diagnostics();
}

using NumberedRuns = std::vector<std::pair<std::size_t, std::string>>;

/// The run folders with their indices.
base::Result<NumberedRuns> numberedRuns(const std::string& runs) {
  NumberedRuns found;
  std::error_code error;
  if (!fs::is_directory(fs::symlink_status(runs, error))) {
    return found;
  }
  error.clear();
  for (fs::directory_iterator at(runs, error), end; !error && at != end; at.increment(error)) {
    const auto run = base::parseInt(at->path().filename().string());
    if (run && *run >= 0) {
      found.emplace_back(static_cast<std::size_t>(*run), at->path().string());
    }
  }
  if (error) {
    return base::error("file.cannot-read", {error.message()}, runs);
  }
  return found;
}

/// The paths that would be overwritten and do not belong to an earlier batch. With `force`, only
/// those that are never replaced: links, and files in place of folders.
base::Diagnostics foreignFilesIn(const std::string& folder, std::size_t runCount, bool force) {
  constexpr std::size_t kMaxReported = 5;
  const base::Result<std::optional<std::size_t>> former = batchRunCount(folder);
  if (!former) {
    return former.diagnostics();
  }
  std::optional<std::size_t> known = *former;
  if (!known && ResultStore::isResultDatabase(fileIn(folder, "results.sqlite"))) {
    known = runCount;
  }
  for (const char* name : {"manifest.json", "results.csv", "results.sqlite"}) {
    if (!known && !force && pathExists(fileIn(folder, name))) {
      return {base::error("batch.stranger", {}, fileIn(folder, name))};
    }
  }
  const std::string runs = fileIn(folder, "runs");
  std::error_code error;
  if (fs::is_symlink(fs::symlink_status(runs, error))) {
    return {base::error("batch.no-folder", {}, runs)};
  }
  const auto folders = numberedRuns(runs);
  if (!folders) {
    return folders.diagnostics();
  }
  base::Diagnostics problems;
  for (const auto& [index, path] : *folders) {
    if (index >= runCount || problems.size() >= kMaxReported) {
      continue;  // not written by this batch
    }
    const auto stranger = foreignEntryIn(path, index < known.value_or(0));
    const bool isFolder = stranger && *stranger != path;
    if (stranger && !(force && isFolder)) {
      problems.push_back(
          base::error(isFolder ? "batch.stranger" : "batch.no-folder", {}, *stranger));
    }
  }
  return problems;
}

/// Locates the first line that differs, in the present text.
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

/// Removes temporary files of processes that have ended.
void removeTemporaryFiles(const std::string& folder) {
  std::error_code error;
  std::vector<std::string> unfinished;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const auto target = targetOfTemporary(at->path().filename().string());
    const bool isOwnFile = target && (*target == "manifest.json" || *target == "results.csv");
    if (isOwnFile && fs::is_regular_file(at->symlink_status(error))) {
      unfinished.push_back(at->path().string());
    }
  }
  std::for_each(unfinished.begin(), unfinished.end(), removeQuietly);
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
  study.runs = experiment.runCount();
  study.shard = shard;
  study.allowsCode = experiment.allowCode;
  return unread.empty() ? base::Result<Study>(std::move(study)) : base::Result<Study>(unread);
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
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::createAndAcquire(folder);
  if (!lock) {
    return lock.diagnostics();
  }
  std::unique_ptr<BatchFolder> batch(new BatchFolder(folder, *std::move(lock)));
  removeTemporaryFiles(folder);
  base::Diagnostics problems =
      foreignFilesIn(folder, study.runs, earlier == ExistingBatch::Replace);
  if (earlier != ExistingBatch::Replace) {
    base::append(problems, checkResultsUnchanged(folder));
  }
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
  const std::string path = fileIn(folder_, "results.sqlite");
  if (!pathExists(path) || earlier == ExistingBatch::Replace) {
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
                              : base::Diagnostics{base::error("batch.unfinished",
                                                              {found.finished(), runs}, folder_)};
  }
  base::Diagnostics problems = studyDifferences(found.study(), study);
  if (problems.empty()) {
    problems = changedInputFiles(found.study(), study);
  }
  if (problems.empty() && found.study().shard.number != study.shard.number) {
    problems.push_back(base::error("batch.other-shard",
                                   {found.study().shard.text(), study.shard.text()}, folder_));
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
  const base::Result<std::optional<std::size_t>> earlier = batchRunCount(folder_);
  if (!earlier) {
    return earlier.diagnostics();
  }
  const std::size_t former = earlier->value_or(0);
  base::Diagnostics problems = base::writeFileAtomically(
      fileIn(folder_, "manifest.json"), emptyManifest(study, former));  // kept if killed below
  if (base::hasErrors(problems)) {
    return problems;
  }
  for (const char* name :
       {"results.csv", "results.sqlite", "results.sqlite-wal", "results.sqlite-journal"}) {
    removeQuietly(fileIn(folder_, name));
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
      ResultStore::create(fileIn(folder_, "results.sqlite"), study);
  if (!store) {
    return store.diagnostics();
  }
  store_ = *std::move(store);
  return {};
}

std::string BatchFolder::runsFolder() const {
  return fileIn(folder_, "runs");
}

std::string BatchFolder::resultsFile() const {
  return fileIn(folder_, "results.csv");
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
      return pathExists((fs::path(place) / name).string());
    };
    if (run < store_->study().runs &&
        (!store_->has(run) || !(contains("manifest.json") || contains("trace.json")))) {
      base::append(problems, removeRunFolder(path));
    } else if (run < store_->study().runs && contains(FolderLock::kFile)) {
      const auto lock = FolderLock::acquire(path);  // the destructor removes the file
    }
  }
  std::error_code ignored;
  if (fs::is_directory(fs::symlink_status(runsFolder(), ignored))) {
    removeQuietly(runsFolder());  // has no effect while runs are kept in it
  }
  return problems;
}

base::Diagnostics BatchFolder::finish() {
  const base::Diagnostics removalProblems = removeIncompleteRuns();
  const std::string manifest = fileIn(folder_, "manifest.json");
  // While results.csv is replaced, no manifest lists it: if killed here, the batch can be resumed.
  base::Diagnostics problems =
      base::writeFileAtomically(manifest, emptyManifest(store_->study(), 0));
  if (!base::hasErrors(problems)) {
    problems = writeResults(*store_, resultsFile());
  }
  if (!base::hasErrors(problems)) {
    const std::optional<std::string> hash = sha256OfFile(resultsFile());
    const base::Result<std::string> text =
        hash ? batchManifest(*store_, *hash)
             : base::error("file.cannot-read", {"it is missing or damaged"}, resultsFile());
    manifest_ = text ? *text : std::string();
    problems = text ? base::writeFileAtomically(manifest, manifest_) : text.diagnostics();
  }
  base::append(problems, store_->close());
  base::append(problems, removalProblems);
  return problems;
}

base::Result<std::unique_ptr<ResultStore>> readResults(const std::string& folder) {
  const std::string path = fileIn(folder, "results.sqlite");
  if (!pathExists(path)) {
    return base::error("batch.no-results", {}, folder);
  }
  return ResultStore::open(path);
}

}  // namespace app
