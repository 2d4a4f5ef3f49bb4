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

#include "app/run/ListedFiles.h"
#include "app/run/Sha256.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

// Names that nobody else gives: what bears them is taken away.
constexpr const char* kCommit = ".hunavsim-commit";
constexpr const char* kStaging = ".hunavsim-new-";

std::string inFolder(const std::string& folder, const std::string& name) {
  return (fs::path(folder) / name).string();
}

fs::file_status statusOf(const std::string& path) {
  std::error_code ignored;  // what cannot be looked at is not there
  return fs::symlink_status(path, ignored);
}

bool stands(const std::string& path) {
  return fs::exists(statusOf(path));
}

base::Diagnostic writeProblem(const std::string& path, const std::error_code& why) {
  return base::error("file.cannot-write", {why.message()}, path);
}

std::error_code systemError() {
  return {errno, std::generic_category()};
}

/// Names in a folder are on the disk.
void flushFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);  // not every file system can; the order of renames holds without
    ::close(descriptor);
  }
}

/// All files below a folder, by their names in it, in order.
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

base::Diagnostics putInPlace(const std::string& folder, const std::string& name) {
  const std::string to = inFolder(folder, name);
  std::error_code error;
  fs::create_directories(fs::path(to).parent_path(), error);
  if (error) {
    return {base::error("file.cannot-make-folder", {error.message()},
                        fs::path(to).parent_path().string())};
  }
  const std::string from = inFolder(inFolder(folder, kCommit), name);
  return ::rename(from.c_str(), to.c_str()) == 0
             ? base::Diagnostics()
             : base::Diagnostics{writeProblem(to, systemError())};
}

/// Of the files that a manifest listed those that the next one does not are removed, unless
/// somebody has changed them.
base::Diagnostics removeUnlisted(const std::string& folder, const std::string& next,
                                 const char* manifest) {
  const base::Result<FileHashes> before = listedFiles(folder, manifest);
  const base::Result<FileHashes> now = listedFiles(next, manifest);
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
      return {base::error("file.cannot-read", {"it is gone or damaged"}, path)};
    }
    if (*found == hash && ::unlink(path.c_str()) != 0) {
      return {base::error("file.cannot-remove", {systemError().message()}, path)};
    }
  }
  return {};
}

/// What kCommit holds goes to its places, what was listed and is no more is removed; the manifest
/// is the last. May be done again from any point.
base::Diagnostics finishCommit(const std::string& folder) {
  const std::string from = inFolder(folder, kCommit);
  base::Diagnostics problems;
  const char* manifest = nullptr;  // none: it is in its place already
  const base::Result<std::vector<std::string>> names = filesBelow(from);
  if (!names) {
    return names.diagnostics();
  }
  for (const std::string& name : *names) {
    if (name == OutputFolder::kManifest || name == OutputFolder::kHiddenManifest) {
      manifest =
          name == OutputFolder::kManifest ? OutputFolder::kManifest : OutputFolder::kHiddenManifest;
    } else {
      base::append(problems, putInPlace(folder, name));
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  if (manifest != nullptr) {
    problems = removeUnlisted(folder, from, manifest);
    if (problems.empty()) {
      problems = putInPlace(folder, manifest);
    }
  }
  if (problems.empty()) {
    std::error_code ignored;           // an empty folder that stays is taken away the next time
    if (::rmdir(from.c_str()) != 0) {  // there were folders in it
      fs::remove_all(from, ignored);
    }
    flushFolder(folder);
  }
  return problems;
}

/// What processes that are gone were about to make. The lock is held: none of them lives.
void removeStaging(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.rfind(kStaging, 0) == 0 && fs::is_directory(at->symlink_status())) {
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

/// Processes that record a file hold the lock briefly.
base::Result<std::unique_ptr<FolderLock>> waitForLock(const std::string& folder) {
  constexpr int kMostTries = 200;
  constexpr std::chrono::milliseconds kBetween(50);
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::take(folder);
  for (int tries = 1;
       !lock && lock.diagnostics().front().code == "batch.locked" && tries < kMostTries; ++tries) {
    std::this_thread::sleep_for(kBetween);
    lock = FolderLock::take(folder);
  }
  return lock;
}

base::Diagnostics listFile(const std::string& file, const std::string& hash, const char* kind) {
  const std::string folder = folderOf(file);
  const base::Result<std::unique_ptr<FolderLock>> lock = waitForLock(folder);
  const base::Result<std::string> former = manifestText(folder, OutputFolder::kHiddenManifest);
  const base::Result<FileHashes> listed = listedFiles(folder, OutputFolder::kHiddenManifest);
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
      staging_(inFolder(folder_, kStaging + std::to_string(::getpid()))),
      force_(force),
      isNew_(isNew),
      manifest_(manifest) {}

base::Result<std::unique_ptr<OutputFolder>> OutputFolder::open(const std::string& folder,
                                                               bool force, const char* manifest) {
  const bool isNew = !stands(folder);
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::makeAndTake(folder);
  if (!lock) {
    return lock.diagnostics();
  }
  std::unique_ptr<OutputFolder> output(new OutputFolder(folder, force, isNew, manifest));
  output->lock_ = *std::move(lock);
  if (fs::is_directory(statusOf(inFolder(folder, kCommit)))) {
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
  base::Result<FileHashes> listed = listedFiles(folder, manifest);
  if (!listed) {
    return listed.diagnostics();
  }
  output->listed_ = *std::move(listed);
  return output;
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;  // what stays is taken away the next time
  fs::remove_all(staging_, ignored);
  lock_.reset();
  if (isNew_) {
    ::rmdir(folder_.c_str());  // where nothing was put into it
  }
}

bool OutputFolder::isOurs(const std::string& name) const {
  const std::string path = inFolder(folder_, name);
  return name == manifest_ ? !listed_.empty() && fs::is_regular_file(statusOf(path))
                           : isAsListed(folder_, listed_, name);
}

/// Also what is as it would be after is in nobody's way.
bool OutputFolder::isInTheWay(const std::string& name) const {
  const std::string path = inFolder(folder_, name);
  const fs::file_status status = statusOf(path);
  if (!fs::exists(status) || (!fs::is_directory(status) && (force_ || isOurs(name)))) {
    return false;
  }
  const std::optional<std::string> made = sha256OfFile(inFolder(staging_, name));
  return !fs::is_regular_file(status) || !made || sha256OfFile(path) != made;
}

base::Diagnostics OutputFolder::inTheWay(const std::vector<std::string>& names) const {
  base::Diagnostics problems;
  std::set<std::string> all(names.begin(), names.end());
  all.insert(manifest_);
  for (const std::string& name : all) {
    if (isInTheWay(name)) {
      problems.push_back(base::error("file.is-in-the-way", {}, inFolder(folder_, name)));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::write(const std::string& name, std::string_view content) {
  if (!isWithin(name)) {
    return {base::error("file.outside", {folder_}, name)};
  }
  known_.erase(name);
  return atTheirPlaces(base::writeFileAtomically(inFolder(staging_, name), content));
}

base::Diagnostics OutputFolder::atTheirPlaces(base::Diagnostics problems) const {
  for (base::Diagnostic& problem : problems) {
    if (problem.file == staging_) {
      problem.file = folder_;
    } else if (problem.file.rfind(staging_, 0) == 0) {
      problem.file = inFolder(folder_, problem.file.substr(staging_.size() + 1));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::commit(const std::string& manifest, Earlier earlier) {
  const base::Result<std::vector<std::string>> names = filesBelow(staging_);
  const base::Result<std::string> former =
      earlier == Earlier::Kept ? manifestText(folder_, manifest_) : std::string("{}");
  base::Diagnostics problems = names ? inTheWay(*names) : atTheirPlaces(names.diagnostics());
  base::append(problems, former.diagnostics());
  if (base::hasErrors(problems)) {
    return problems;
  }
  FileHashes hashes = earlier == Earlier::Kept ? listed_ : FileHashes();
  for (const std::string& name : dropped_) {
    hashes.erase(name);
  }
  for (const std::string& name : *names) {
    const auto known = known_.find(name);
    const std::optional<std::string> hash =
        known != known_.end() ? known->second : sha256OfFile(inFolder(staging_, name));
    if (!hash) {
      return {base::error("file.cannot-read", {"it is gone or damaged"}, inFolder(folder_, name))};
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
  const std::string commit = inFolder(folder_, kCommit);
  if (::rename(staging_.c_str(), commit.c_str()) != 0) {
    return {writeProblem(commit, systemError())};
  }
  flushFolder(folder_);
  return finishCommit(folder_);
}

base::Diagnostics writeIntoOthers(const std::string& folder,
                                  const std::vector<base::FileContent>& files, const char* kind,
                                  bool force, const std::vector<std::string>& dropped) {
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
  (*output)->drop(dropped);
  return (*output)->commit(base::jsonText(Json{{"kind", kind}}), OutputFolder::Earlier::Kept);
}

base::Diagnostics otherFileInTheWay(const std::string& file, bool force) {
  const fs::file_status status = statusOf(file);
  if (!fs::exists(status) || (force && !fs::is_directory(status))) {
    return {};
  }
  const std::string folder = folderOf(file);
  const base::Result<FileHashes> listed = listedFiles(folder, OutputFolder::kHiddenManifest);
  if (!listed) {
    return listed.diagnostics();
  }
  const bool isOurs = isAsListed(folder, *listed, fs::path(file).filename().string());
  return isOurs ? base::Diagnostics{}
                : base::Diagnostics{base::error("file.is-in-the-way", {}, file)};
}

base::Diagnostics writeFile(const std::string& file, const std::string& content, bool force) {
  const bool isThere = sha256OfFile(file) == sha256Of(content);  // of a command that was ended
  base::Diagnostics problems = isThere ? base::Diagnostics{} : otherFileInTheWay(file, force);
  return base::hasErrors(problems) ? problems : base::writeFileAtomically(file, content);
}

base::Diagnostics noteFile(const std::string& file, const char* kind) {
  const std::optional<std::string> hash = sha256OfFile(file);
  return hash ? listFile(file, *hash, kind)
              : base::Diagnostics{base::error("file.cannot-read", {"it is gone or damaged"}, file)};
}

bool isRestOfOutput(const std::string& name) {
  return name == kCommit || name == FolderLock::kFile || name.rfind(kStaging, 0) == 0;
}

std::optional<std::string> nameOfUnfinished(const std::string& name) {
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

base::Diagnostics settleFolder(const std::string& folder) {
  if (!fs::is_directory(statusOf(inFolder(folder, kCommit)))) {
    return {};
  }
  const base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::take(folder);
  return lock ? finishCommit(folder) : lock.diagnostics();
}

}  // namespace app
