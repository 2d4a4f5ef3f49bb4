#include "app/run/OutputFolder.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <set>
#include <string_view>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/ManifestFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Reserved names: files with them are removed.
constexpr const char* kCommitFolder = ".hunavsim-commit";
constexpr const char* kStagingPrefix = ".hunavsim-new-";

std::string inFolder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

fs::file_status statusOf(const std::string& path) {
  std::error_code ignored;  // an inaccessible file counts as missing
  return fs::symlink_status(path, ignored);
}

bool entryExists(const std::string& path) {
  return fs::exists(statusOf(path));
}

base::Diagnostic writeProblem(const std::string& path, const std::error_code& why) {
  return base::error("file.cannot-write", {why.message()}, path);
}

std::error_code systemError() {
  return {errno, std::generic_category()};
}

/// Flushes the directory entries to disk.
void flushFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);  // unsupported by some file systems; the order of renames holds anyway
    ::close(descriptor);
  }
}

/// All files below a folder, sorted relative names.
base::Result<std::vector<std::string>> filesBelow(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (!fs::is_directory(at->symlink_status())) {
      names.push_back(at->path().lexically_relative(folder).string());
    }
  }
  if (error) {
    return base::error("file.cannot-read", {error.message()}, folder);
  }
  std::sort(names.begin(), names.end());
  return names;
}

base::Diagnostics moveToFinalPath(const std::string& folder, const std::string& name) {
  const std::string to = inFolder(folder, name);
  std::error_code error;
  fs::create_directories(fs::path(to).parent_path(), error);
  if (error) {
    return {base::error("file.cannot-make-folder", {error.message()},
                        fs::path(to).parent_path().string())};
  }
  const std::string from = inFolder(inFolder(folder, kCommitFolder), name);
  return ::rename(from.c_str(), to.c_str()) == 0
             ? base::Diagnostics()
             : base::Diagnostics{writeProblem(to, systemError())};
}

/// Removes files that the old manifest lists and the new one does not, unless their content has
/// changed.
base::Diagnostics removeUnlisted(const std::string& folder, const std::string& next,
                                 const char* manifest) {
  const base::Result<FileHashes> before = manifestFiles(folder, manifest);
  const base::Result<FileHashes> now = manifestFiles(next, manifest);
  if (!before || !now) {
    return before ? now.diagnostics() : before.diagnostics();
  }
  for (const auto& [name, hash] : *before) {
    const std::string path = inFolder(folder, name);
    if (now->count(name) != 0 || !fs::is_regular_file(statusOf(path))) {
      continue;
    }
    const std::optional<std::string> found = sha256OfFile(path);
    if (!found) {
      return {base::error("file.cannot-read", {"it is missing or damaged"}, path)};
    }
    if (*found == hash && ::unlink(path.c_str()) != 0) {
      return {base::error("file.cannot-remove", {systemError().message()}, path)};
    }
  }
  return {};
}

/// Moves the files of kCommitFolder to their places and removes files that are no longer listed;
/// the manifest is moved last. Can be repeated after an interruption at any point.
base::Diagnostics finishCommit(const std::string& folder) {
  const std::string from = inFolder(folder, kCommitFolder);
  base::Diagnostics problems;
  const char* manifest = nullptr;  // null: already in its place
  const base::Result<std::vector<std::string>> names = filesBelow(from);
  if (!names) {
    return names.diagnostics();
  }
  for (const std::string& name : *names) {
    if (name == OutputFolder::kManifest || name == OutputFolder::kHiddenManifest) {
      manifest =
          name == OutputFolder::kManifest ? OutputFolder::kManifest : OutputFolder::kHiddenManifest;
    } else {
      base::append(problems, moveToFinalPath(folder, name));
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  if (manifest != nullptr) {
    problems = removeUnlisted(folder, from, manifest);
    if (problems.empty()) {
      problems = moveToFinalPath(folder, manifest);
    }
  }
  if (problems.empty()) {
    std::error_code ignored;           // a remaining empty folder is removed at the next commit
    if (::rmdir(from.c_str()) != 0) {  // it contains folders
      fs::remove_all(from, ignored);
    }
    flushFolder(folder);
  }
  return problems;
}

/// Removes staging folders of ended processes. Requires the lock, so none of them is active.
void removeStaging(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.rfind(kStagingPrefix, 0) == 0 && fs::is_directory(at->symlink_status())) {
      old.push_back(at->path());
    }
  }
  for (const fs::path& path : old) {
    fs::remove_all(path, error);
  }
}

Json outputsOf(const FileHashes& hashes) {
  Json outputs = Json::array();
  for (const auto& [name, hash] : hashes) {
    outputs.push_back({{"path", name}, {"sha256", hash}});
  }
  return outputs;
}

std::string folderOf(const std::string& file) {
  const fs::path folder = fs::path(file).parent_path();
  return folder.empty() ? "." : folder.string();
}

/// Waits, because processes that record a file hold the lock briefly.
base::Result<std::unique_ptr<FolderLock>> waitForLock(const std::string& folder) {
  constexpr int kMaxAttempts = 200;
  constexpr std::chrono::milliseconds kBetween(50);
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::acquire(folder);
  for (int tries = 1;
       !lock && lock.diagnostics().front().code == "batch.locked" && tries < kMaxAttempts;
       ++tries) {
    std::this_thread::sleep_for(kBetween);
    lock = FolderLock::acquire(folder);
  }
  return lock;
}

base::Diagnostics addToHiddenManifest(const std::string& file, const std::string& hash,
                                      const char* kind) {
  const std::string folder = folderOf(file);
  const base::Result<std::unique_ptr<FolderLock>> lock = waitForLock(folder);
  const base::Result<std::string> former = manifestText(folder, OutputFolder::kHiddenManifest);
  const base::Result<FileHashes> listed = manifestFiles(folder, OutputFolder::kHiddenManifest);
  base::Diagnostics problems = lock.diagnostics();
  base::append(problems, former.diagnostics());
  base::append(problems, listed.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  FileHashes hashes = *listed;
  hashes[fs::path(file).filename().string()] = hash;
  Json json = Json::parse(*former);
  if (json.empty()) {
    json["kind"] = kind;
  }
  json["outputs"] = outputsOf(hashes);
  return base::writeFileAtomically(inFolder(folder, OutputFolder::kHiddenManifest),
                                   base::jsonText(json) + "\n");
}

}  // namespace

OutputFolder::OutputFolder(std::string folder, bool force, bool isNew, const char* manifest)
    : folder_(std::move(folder)),
      staging_(inFolder(folder_, kStagingPrefix + std::to_string(::getpid()))),
      force_(force),
      isNew_(isNew),
      manifest_(manifest) {}

base::Result<std::unique_ptr<OutputFolder>> OutputFolder::open(const std::string& folder,
                                                               bool force, const char* manifest) {
  const bool isNew = !entryExists(folder);
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::createAndAcquire(folder);
  if (!lock) {
    return lock.diagnostics();
  }
  std::unique_ptr<OutputFolder> output(new OutputFolder(folder, force, isNew, manifest));
  output->lock_ = *std::move(lock);
  if (fs::is_directory(statusOf(inFolder(folder, kCommitFolder)))) {
    const base::Diagnostics problems = finishCommit(folder);
    if (base::hasErrors(problems)) {
      return problems;
    }
  }
  removeStaging(folder);
  std::error_code error;
  fs::create_directory(output->staging_, error);
  if (error) {
    return base::error("file.cannot-make-folder", {error.message()}, output->staging_);
  }
  base::Result<FileHashes> listed = manifestFiles(folder, manifest);
  if (!listed) {
    return listed.diagnostics();
  }
  output->listed_ = *std::move(listed);
  return output;
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;  // a remaining folder is removed by the next open()
  fs::remove_all(staging_, ignored);
  lock_.reset();
  if (isNew_) {
    ::rmdir(folder_.c_str());  // only if empty
  }
}

bool OutputFolder::isOwnFile(const std::string& name) const {
  const std::string path = inFolder(folder_, name);
  return name == manifest_ ? !listed_.empty() && fs::is_regular_file(statusOf(path))
                           : matchesManifest(folder_, listed_, name);
}

/// A file whose content stays the same is not reported.
bool OutputFolder::isConflicting(const std::string& name) const {
  const std::string path = inFolder(folder_, name);
  const fs::file_status status = statusOf(path);
  if (!fs::exists(status) || (!fs::is_directory(status) && (force_ || isOwnFile(name)))) {
    return false;
  }
  const std::optional<std::string> made = sha256OfFile(inFolder(staging_, name));
  return !fs::is_regular_file(status) || !made || sha256OfFile(path) != made;
}

base::Diagnostics OutputFolder::conflictingFiles(const std::vector<std::string>& names) const {
  base::Diagnostics problems;
  std::set<std::string> all(names.begin(), names.end());
  all.insert(manifest_);
  for (const std::string& name : all) {
    if (isConflicting(name)) {
      problems.push_back(base::error("file.is-in-the-way", {}, inFolder(folder_, name)));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::write(const std::string& name, std::string_view content) {
  if (!isWithin(name)) {
    return {base::error("file.outside", {folder_}, name)};
  }
  newHashes_.erase(name);
  return withFinalPaths(base::writeFileAtomically(inFolder(staging_, name), content));
}

base::Diagnostics OutputFolder::withFinalPaths(base::Diagnostics problems) const {
  for (base::Diagnostic& problem : problems) {
    if (problem.file == staging_) {
      problem.file = folder_;
    } else if (problem.file.rfind(staging_, 0) == 0) {
      problem.file = inFolder(folder_, problem.file.substr(staging_.size() + 1));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::commit(const std::string& manifest, EarlierFiles earlier) {
  const base::Result<std::vector<std::string>> names = filesBelow(staging_);
  const base::Result<std::string> former =
      earlier == EarlierFiles::Kept ? manifestText(folder_, manifest_) : std::string("{}");
  base::Diagnostics problems =
      names ? conflictingFiles(*names) : withFinalPaths(names.diagnostics());
  base::append(problems, former.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  FileHashes hashes = earlier == EarlierFiles::Kept ? listed_ : FileHashes();
  for (const std::string& name : removedOnCommit_) {
    hashes.erase(name);
  }
  for (const std::string& name : *names) {
    const auto known = newHashes_.find(name);
    const std::optional<std::string> hash =
        known != newHashes_.end() ? known->second : sha256OfFile(inFolder(staging_, name));
    if (!hash) {
      return {
          base::error("file.cannot-read", {"it is missing or damaged"}, inFolder(folder_, name))};
    }
    hashes[name] = *hash;
  }
  Json json = Json::parse(*former);
  if (json.empty()) {
    json = Json::parse(manifest);
  }
  json["outputs"] = outputsOf(hashes);
  problems = write(manifest_, base::jsonText(json) + "\n");
  if (base::hasErrors(problems)) {
    return problems;
  }
  flushFolder(staging_);
  const std::string commit = inFolder(folder_, kCommitFolder);
  if (::rename(staging_.c_str(), commit.c_str()) != 0) {
    return {writeProblem(commit, systemError())};
  }
  flushFolder(folder_);
  return finishCommit(folder_);
}

base::Diagnostics writeIntoForeignFolder(const std::string& folder,
                                         const std::vector<base::FileContent>& files,
                                         const char* kind, bool force,
                                         const std::vector<std::string>& dropped) {
  const base::Result<std::unique_ptr<OutputFolder>> output =
      OutputFolder::open(folder, force, OutputFolder::kHiddenManifest);
  if (!output) {
    return output.diagnostics();
  }
  base::Diagnostics problems;
  for (const base::FileContent& file : files) {
    base::append(problems, (*output)->write(file.path, file.content));
  }
  if (base::hasErrors(problems)) {
    return problems;
  }
  (*output)->removeOnCommit(dropped);
  return (*output)->commit(base::jsonText(Json{{"kind", kind}}), OutputFolder::EarlierFiles::Kept);
}

base::Diagnostics checkOverwrite(const std::string& file, bool force) {
  const fs::file_status status = statusOf(file);
  if (!fs::exists(status) || (force && !fs::is_directory(status))) {
    return {};
  }
  const std::string folder = folderOf(file);
  const base::Result<FileHashes> listed = manifestFiles(folder, OutputFolder::kHiddenManifest);
  if (!listed) {
    return listed.diagnostics();
  }
  const bool isOwnFile = matchesManifest(folder, *listed, fs::path(file).filename().string());
  return isOwnFile ? base::Diagnostics{}
                   : base::Diagnostics{base::error("file.is-in-the-way", {}, file)};
}

base::Diagnostics writeFile(const std::string& file, const std::string& content, bool force) {
  const bool isThere = sha256OfFile(file) == sha256Of(content);  // of an aborted command
  base::Diagnostics problems = isThere ? base::Diagnostics{} : checkOverwrite(file, force);
  return base::hasErrors(problems) ? problems : base::writeFileAtomically(file, content);
}

base::Diagnostics recordOutputFile(const std::string& file, const char* kind) {
  const std::optional<std::string> hash = sha256OfFile(file);
  return hash ? addToHiddenManifest(file, *hash, kind)
              : base::Diagnostics{
                    base::error("file.cannot-read", {"it is missing or damaged"}, file)};
}

bool isInternalEntry(const std::string& name) {
  return name == kCommitFolder || name == FolderLock::kFile || name.rfind(kStagingPrefix, 0) == 0;
}

std::optional<std::string> targetOfTemporary(const std::string& name) {
  // <name>.new-<number>-<number>
  constexpr std::string_view kMark = ".new-", kDigits = "0123456789";
  constexpr std::size_t kNpos = std::string::npos;
  const std::size_t end = name.rfind(kMark);
  const std::size_t first = end + kMark.size();
  const std::size_t dash = end == kNpos ? kNpos : name.find_first_not_of(kDigits, first);
  const bool fits = end > 0 && dash != kNpos && dash > first && name[dash] == '-' &&
                    dash + 1 < name.size() && name.find_first_not_of(kDigits, dash + 1) == kNpos;
  return fits ? std::optional(name.substr(0, end)) : std::nullopt;
}

base::Diagnostics completeCommit(const std::string& folder) {
  if (!fs::is_directory(statusOf(inFolder(folder, kCommitFolder)))) {
    return {};
  }
  const base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::acquire(folder);
  return lock ? finishCommit(folder) : lock.diagnostics();
}

}  // namespace app
