#include "app/run/OutputFolder.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <fcntl.h>
#include <filesystem>
#include <set>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <thread>
#include <unistd.h>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/run/ManifestFiles.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/SystemError.h"
#include "sim2d/base/Text.h"

namespace app {

namespace fs = std::filesystem;

namespace {

std::string systemMessage() {
  return std::generic_category().message(errno);
}

std::string hostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// The owner according to the file: process id, and host if it is another one.
base::Diagnostic heldByOther(const std::string& folder, int file) {
  std::array<char, 300> text{};
  const ssize_t count = ::pread(file, text.data(), text.size() - 1, 0);
  const std::vector<std::string> words =
      base::split(base::trimmed(count > 0 ? text.data() : ""), ' ');
  const std::string host = words.size() > 1 && words[1] != hostName() ? words[1] : "";
  return base::error("batch.locked", {words.front(), host}, folder);
}

/// Whether the open file is still the one with this name.
bool isSame(int file, const std::string& path) {
  struct stat open = {}, named = {};
  return ::fstat(file, &open) == 0 && ::stat(path.c_str(), &named) == 0 &&
         open.st_ino == named.st_ino && open.st_dev == named.st_dev;
}

base::Diagnostics moveToFinalPath(const std::string& folder, const std::string& name) {
  const std::string to = pathIn(folder, name);
  std::error_code error;
  fs::create_directories(fs::path(to).parent_path(), error);
  if (error) {
    return {base::error("file.cannot-make-folder", {base::systemErrorMessage(error)},
                        fs::path(to).parent_path().string())};
  }
  const std::string from = pathIn(pathIn(folder, FolderLock::kCommitFolder), name);
  return ::rename(from.c_str(), to.c_str()) == 0 ? base::Diagnostics()
                                                 : base::Diagnostics{writeProblem(to)};
}

/// Removes files that the old manifest lists and the new one does not, unless their content has
/// changed.
base::Diagnostics removeUnlisted(const std::string& folder, const std::string& next,
                                 const char* name) {
  const base::Result<Manifest> before = readManifest(folder, name);
  const base::Result<Manifest> now = readManifest(next, name);
  if (!before || !now) {
    return before ? now.diagnostics() : before.diagnostics();
  }
  for (const auto& [file, hash] : before->outputs) {
    const std::string path = pathIn(folder, file);
    if (now->outputs.count(file) != 0 || !fs::is_regular_file(statusOf(path))) {
      continue;
    }
    const std::optional<std::string> found = sha256OfFile(path);
    if (!found) {
      return {base::error("file.cannot-read", {"it is missing or damaged"}, path)};
    }
    if (*found == hash && ::unlink(path.c_str()) != 0) {
      return {base::error("file.cannot-remove", {systemMessage()}, path)};
    }
  }
  return {};
}

}  // namespace

base::Diagnostic writeProblem(const std::string& path) {
  return base::error("file.cannot-write", {systemMessage()}, path);
}

base::Result<std::unique_ptr<FolderLock>> FolderLock::acquireOnly(const std::string& folder) {
  const std::string path = pathIn(folder, kFile);
  while (true) {
    base::FileDescriptor opened(
        ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666));
    if (!opened.isOpen()) {
      return writeProblem(path);
    }
    const int file = opened.number();
    std::unique_ptr<FolderLock> lock(new FolderLock(path, std::move(opened)));
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      lock->path_.clear();  // another process owns the file
      return errno == EWOULDBLOCK ? heldByOther(folder, file) : writeProblem(path);
    }
    if (isSame(file, path)) {  // otherwise its owner has just removed it
      const std::string who = std::to_string(::getpid()) + " " + hostName() + "\n";
      if (::ftruncate(file, 0) != 0 ||
          ::pwrite(file, who.data(), who.size(), 0) != static_cast<ssize_t>(who.size())) {
        return writeProblem(path);
      }
      return lock;
    }
    lock->path_.clear();
  }
}

base::Result<std::unique_ptr<FolderLock>> FolderLock::acquire(const std::string& folder) {
  base::Result<std::unique_ptr<FolderLock>> lock = acquireOnly(folder);
  if (lock && fs::is_directory(statusOf(pathIn(folder, kCommitFolder)))) {
    const base::Diagnostics problems = finishCommit(folder);
    if (base::hasErrors(problems)) {
      return problems;
    }
  }
  return lock;
}

base::Result<std::unique_ptr<FolderLock>> FolderLock::createAndAcquire(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder, error)) {
    return base::error("file.cannot-make-folder",
                       {error ? base::systemErrorMessage(error) : std::string()}, folder);
  }
  if (::access(folder.c_str(), W_OK) != 0) {
    return base::error("file.no-permission", {}, folder);
  }
  return acquire(folder);
}

FolderLock::~FolderLock() {
  if (!path_.empty()) {
    ::unlink(path_.c_str());
  }
}

void flushFolder(const std::string& folder) {
  const base::FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (opened.isOpen()) {
    // Unsupported by some file systems; the order of renames holds anyway.
    ::fsync(opened.number());
  }
}

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
    return base::error("file.cannot-read", {base::systemErrorMessage(error)}, folder);
  }
  std::sort(names.begin(), names.end());
  return names;
}

base::Diagnostics finishCommit(const std::string& folder) {
  const std::string from = pathIn(folder, FolderLock::kCommitFolder);
  base::Diagnostics problems;
  const char* manifest = nullptr;  // null: already in its place
  const base::Result<std::vector<std::string>> names = filesBelow(from);
  if (!names) {
    return names.diagnostics();
  }
  for (const std::string& name : *names) {
    if (name == Manifest::kName || name == Manifest::kHiddenName) {
      manifest = name == Manifest::kName ? Manifest::kName : Manifest::kHiddenName;
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

base::Diagnostics completeCommit(const std::string& folder) {
  const bool isOpen = fs::is_directory(statusOf(pathIn(folder, FolderLock::kCommitFolder)));
  return isOpen ? FolderLock::acquire(folder).diagnostics() : base::Diagnostics();
}

bool isInternalEntry(const std::string& name) {
  return name == FolderLock::kCommitFolder || name == FolderLock::kFile ||
         name.rfind(FolderLock::kStagingPrefix, 0) == 0;
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

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// Removes staging folders of ended processes. Requires the lock, so none of them is active.
void removeStaging(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.rfind(FolderLock::kStagingPrefix, 0) == 0 && fs::is_directory(at->symlink_status())) {
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
  constexpr int kMaxTries = 200;
  constexpr std::chrono::milliseconds kBetween(50);
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::acquire(folder);
  for (int tries = 1;
       !lock && lock.diagnostics().front().code == "batch.locked" && tries < kMaxTries; ++tries) {
    std::this_thread::sleep_for(kBetween);
    lock = FolderLock::acquire(folder);
  }
  return lock;
}

base::Diagnostics addToHiddenManifest(const std::string& file, const std::string& hash,
                                      const char* kind) {
  const std::string folder = folderOf(file);
  const base::Result<std::unique_ptr<FolderLock>> lock = waitForLock(folder);
  const base::Result<Manifest> former = readManifest(folder, Manifest::kHiddenName);
  if (!lock || !former) {
    return lock ? former.diagnostics() : lock.diagnostics();
  }
  FileHashes hashes = former->outputs;
  hashes[fs::path(file).filename().string()] = hash;
  Json json = Json::parse(base::shallowJson(former->text));
  if (json.empty()) {
    json["kind"] = kind;
  }
  json["outputs"] = outputsOf(hashes);
  return base::writeFileAtomically(pathIn(folder, Manifest::kHiddenName),
                                   base::jsonText(json) + "\n");
}

}  // namespace

OutputFolder::OutputFolder(std::string folder, bool force, bool isNew, const char* manifest)
    : folder_(std::move(folder)),
      staging_(pathIn(folder_, FolderLock::kStagingPrefix + std::to_string(::getpid()))),
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
  removeStaging(folder);
  std::error_code error;
  fs::create_directory(output->staging_, error);
  if (error) {
    return base::error("file.cannot-make-folder", {base::systemErrorMessage(error)},
                       output->staging_);
  }
  base::Result<Manifest> former = readManifest(folder, manifest);
  if (!former) {
    return former.diagnostics();
  }
  output->former_ = *std::move(former);
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
  const std::string path = pathIn(folder_, name);
  return name == manifest_ ? !former_.outputs.empty() && fs::is_regular_file(statusOf(path))
                           : former_.matches(folder_, name);
}

/// A file whose content stays the same is not reported.
bool OutputFolder::isConflicting(const std::string& name) const {
  const std::string path = pathIn(folder_, name);
  const fs::file_status status = statusOf(path);
  if (!fs::exists(status) || (!fs::is_directory(status) && (force_ || isOwnFile(name)))) {
    return false;
  }
  const std::optional<std::string> made = sha256OfFile(pathIn(staging_, name));
  return !fs::is_regular_file(status) || !made || sha256OfFile(path) != made;
}

base::Diagnostics OutputFolder::conflictingFiles(const std::vector<std::string>& names) const {
  base::Diagnostics problems;
  std::set<std::string> all(names.begin(), names.end());
  all.insert(manifest_);
  for (const std::string& name : all) {
    if (isConflicting(name)) {
      problems.push_back(base::error("file.is-in-the-way", {}, pathIn(folder_, name)));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::write(const std::string& name, std::string_view content) {
  if (!isWithin(name)) {
    return {base::error("file.outside", {folder_}, name)};
  }
  newHashes_.erase(name);
  return withFinalPaths(base::writeFileAtomically(pathIn(staging_, name), content));
}

base::Diagnostics OutputFolder::withFinalPaths(base::Diagnostics problems) const {
  for (base::Diagnostic& problem : problems) {
    if (problem.file == staging_) {
      problem.file = folder_;
    } else if (problem.file.rfind(staging_, 0) == 0) {
      problem.file = pathIn(folder_, problem.file.substr(staging_.size() + 1));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::commit(const std::string& manifest, EarlierFiles earlier) {
  const base::Result<std::vector<std::string>> names = filesBelow(staging_);
  base::Diagnostics problems =
      names ? conflictingFiles(*names) : withFinalPaths(names.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  FileHashes hashes = earlier == EarlierFiles::Kept ? former_.outputs : FileHashes();
  for (const std::string& name : removedOnCommit_) {
    hashes.erase(name);
  }
  for (const std::string& name : *names) {
    const auto known = newHashes_.find(name);
    const std::optional<std::string> hash =
        known != newHashes_.end() ? known->second : sha256OfFile(pathIn(staging_, name));
    if (!hash) {
      return {base::error("file.cannot-read", {"it is missing or damaged"}, pathIn(folder_, name))};
    }
    hashes[name] = *hash;
  }
  Json json = earlier == EarlierFiles::Kept ? Json::parse(base::shallowJson(former_.text)) : Json();
  if (json.empty()) {
    json = Json::parse(manifest);
  }
  json["outputs"] = outputsOf(hashes);
  const std::string text = base::jsonText(json) + "\n";
  problems = write(manifest_, text);
  if (base::hasErrors(problems)) {
    return problems;
  }
  flushFolder(staging_);
  const std::string commit = pathIn(folder_, FolderLock::kCommitFolder);
  if (::rename(staging_.c_str(), commit.c_str()) != 0) {
    return {writeProblem(commit)};
  }
  former_.text = text;
  former_.outputs = hashes;
  flushFolder(folder_);
  return finishCommit(folder_);
}

base::Diagnostics writeIntoForeignFolder(const std::string& folder,
                                         const std::vector<base::FileContent>& files,
                                         const char* kind, bool force,
                                         const std::vector<std::string>& dropped) {
  const base::Result<std::unique_ptr<OutputFolder>> output =
      OutputFolder::open(folder, force, Manifest::kHiddenName);
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
  const base::Result<Manifest> manifest = readManifest(folder, Manifest::kHiddenName);
  if (!manifest) {
    return manifest.diagnostics();
  }
  const bool isOwnFile = manifest->matches(folder, fs::path(file).filename().string());
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

}  // namespace app
