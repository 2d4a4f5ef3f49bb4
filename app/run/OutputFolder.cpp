#include "app/run/OutputFolder.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <filesystem>
#include <set>
#include <system_error>
#include <unistd.h>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/run/RunFolder.h"
#include "app/run/Sha256.h"
#include "sim2d/base/JsonText.h"
#include "sim2d/base/Text.h"

namespace app {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* kCommit = ".commit";
constexpr const char* kWorkshop = ".new-";

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

Json manifestIn(const std::string& folder, const char* name) {
  const std::string path = inFolder(folder, name);
  const base::Result<std::string> text = fs::is_regular_file(statusOf(path))
                                             ? base::readTextFile(path)
                                             : base::Result<std::string>("");
  Json json = text ? Json::parse(*text, nullptr, false) : Json();
  return json.is_object() ? json : Json::object();
}

/// A name that stays in the folder.
bool isWithin(const std::string& name) {
  const fs::path path(name);
  return !name.empty() && path.is_relative() &&
         std::none_of(path.begin(), path.end(), [](const fs::path& part) { return part == ".."; });
}

std::map<std::string, std::string> listedIn(const Json& manifest) {
  std::map<std::string, std::string> listed;
  const auto outputs = manifest.find("outputs");
  for (const Json& output : outputs != manifest.end() && outputs->is_array() ? *outputs : Json()) {
    const Json path = output.is_object() ? output.value("path", Json()) : Json();
    const Json hash = output.is_object() ? output.value("sha256", Json()) : Json();
    if (path.is_string() && hash.is_string() && isWithin(path.get<std::string>())) {
      listed[path.get<std::string>()] = hash.get<std::string>();
    }
  }
  return listed;
}

bool isListed(const std::string& folder, const std::map<std::string, std::string>& listed,
              const std::string& name) {
  const auto found = listed.find(name);
  const std::string path = inFolder(folder, name);
  return found != listed.end() && fs::is_regular_file(statusOf(path)) &&
         sha256OfFile(path) == found->second;
}

/// All files below a folder, by their names in it, in order.
std::vector<std::string> filesBelow(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::recursive_directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    if (!fs::is_directory(at->symlink_status())) {
      names.push_back(at->path().lexically_relative(folder).string());
    }
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

/// What `.commit` holds goes to its places, what was listed and is no more is removed; the manifest
/// is the last. May be done again from any point.
base::Diagnostics finishCommit(const std::string& folder) {
  const std::string from = inFolder(folder, kCommit);
  base::Diagnostics problems;
  const char* manifest = nullptr;  // none: it is in its place already
  for (const std::string& name : filesBelow(from)) {
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
    const std::map<std::string, std::string> before = listedIn(manifestIn(folder, manifest));
    const std::map<std::string, std::string> now = listedIn(manifestIn(from, manifest));
    for (const auto& [name, hash] : before) {
      const std::string path = inFolder(folder, name);
      if (now.count(name) == 0 && isListed(folder, before, name) && ::unlink(path.c_str()) != 0) {
        return {base::error("file.cannot-remove", {systemError().message()}, path)};
      }
    }
    problems = putInPlace(folder, manifest);
  }
  if (problems.empty()) {
    std::error_code ignored;  // an empty folder that stays is taken away the next time
    fs::remove_all(from, ignored);
    flushFolder(folder);
  }
  return problems;
}

/// What processes that are gone were about to make. The lock is held: none of them lives.
void removeWorkshops(const std::string& folder) {
  std::error_code error;
  std::vector<fs::path> old;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.rfind(kWorkshop, 0) == 0 && fs::is_directory(at->symlink_status())) {
      old.push_back(at->path());
    }
  }
  for (const fs::path& path : old) {
    fs::remove_all(path, error);
  }
}

}  // namespace

OutputFolder::OutputFolder(std::string folder, bool force, bool isNew, const char* manifest)
    : folder_(std::move(folder)),
      workshop_(inFolder(folder_, kWorkshop + std::to_string(::getpid()))),
      force_(force),
      isNew_(isNew),
      manifest_(manifest) {}

base::Result<std::unique_ptr<OutputFolder>> OutputFolder::open(const std::string& folder,
                                                               bool force, const char* manifest) {
  const bool isNew = !stands(folder);
  const base::Diagnostics unwritable = checkWritableFolder(folder);
  if (base::hasErrors(unwritable)) {
    return unwritable;
  }
  base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::take(folder);
  if (!lock) {
    return lock.diagnostics();
  }
  std::unique_ptr<OutputFolder> output(new OutputFolder(folder, force, isNew, manifest));
  output->lock_ = *std::move(lock);
  if (stands(inFolder(folder, kCommit))) {
    const base::Diagnostics problems = finishCommit(folder);
    if (base::hasErrors(problems)) {
      return problems;
    }
  }
  removeWorkshops(folder);
  std::error_code error;
  fs::create_directory(output->workshop_, error);
  if (error) {
    return base::error("file.cannot-make-folder", {error.message()}, output->workshop_);
  }
  output->listed_ = listedIn(manifestIn(folder, manifest));
  return output;
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;  // what stays is taken away the next time
  fs::remove_all(workshop_, ignored);
  lock_.reset();
  if (isNew_) {
    ::rmdir(folder_.c_str());  // where nothing was put into it
  }
}

bool OutputFolder::isOurs(const std::string& name) const {
  const std::string path = inFolder(folder_, name);
  return name == manifest_ ? !listed_.empty() && fs::is_regular_file(statusOf(path))
                           : isListed(folder_, listed_, name);
}

/// Also what is as it would be after is in nobody's way.
bool OutputFolder::isInTheWay(const std::string& name) const {
  const std::string path = inFolder(folder_, name);
  const fs::file_status status = statusOf(path);
  if (!fs::exists(status) || (!fs::is_directory(status) && (force_ || isOurs(name)))) {
    return false;
  }
  const std::optional<std::string> made = sha256OfFile(inFolder(workshop_, name));
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
  return atTheirPlaces(base::writeFileAtomically(inFolder(workshop_, name), content));
}

base::Diagnostics OutputFolder::atTheirPlaces(base::Diagnostics problems) const {
  for (base::Diagnostic& problem : problems) {
    if (problem.file.rfind(workshop_, 0) == 0) {
      problem.file = inFolder(folder_, problem.file.substr(workshop_.size() + 1));
    }
  }
  return problems;
}

base::Diagnostics OutputFolder::commit(const std::string& manifest, Earlier earlier) {
  const std::vector<std::string> names = filesBelow(workshop_);
  base::Diagnostics problems = inTheWay(names);
  if (base::hasErrors(problems)) {
    return problems;
  }
  Hashes hashes = earlier == Earlier::Kept ? listed_ : Hashes();
  for (const std::string& name : names) {
    const std::optional<std::string> hash = sha256OfFile(inFolder(workshop_, name));
    if (!hash) {
      return {base::error("file.cannot-read", {"it is gone or damaged"}, inFolder(folder_, name))};
    }
    hashes[name] = *hash;
  }
  Json json = earlier == Earlier::Kept ? manifestIn(folder_, manifest_) : Json::object();
  if (json.empty()) {
    json = Json::parse(manifest);
  }
  json["outputs"] = Json::array();
  for (const auto& [name, hash] : hashes) {
    json["outputs"].push_back({{"path", name}, {"sha256", hash}});
  }
  problems = write(manifest_, base::jsonText(json) + "\n");
  if (base::hasErrors(problems)) {
    return problems;
  }
  flushFolder(workshop_);
  const std::string commit = inFolder(folder_, kCommit);
  if (::rename(workshop_.c_str(), commit.c_str()) != 0) {
    return {writeProblem(commit, systemError())};
  }
  flushFolder(folder_);
  return finishCommit(folder_);
}

base::Diagnostics writeIntoOthers(const std::string& folder,
                                  const std::vector<base::FileContent>& files, const char* kind,
                                  bool force) {
  const base::Result<std::unique_ptr<OutputFolder>> output =
      OutputFolder::open(folder, force, OutputFolder::kHiddenManifest);
  if (!output) {
    return output.diagnostics();
  }
  base::Diagnostics problems;
  for (const base::FileContent& file : files) {
    base::append(problems, (*output)->write(file.path, file.content));
  }
  return base::hasErrors(problems)
             ? problems
             : (*output)->commit(base::jsonText(Json{{"kind", kind}}), OutputFolder::Earlier::Kept);
}

bool isRestOfOutput(const std::string& name) {
  return name == kCommit || name == ".lock" || name.rfind(kWorkshop, 0) == 0;
}

base::Diagnostics settleFolder(const std::string& folder) {
  if (!stands(inFolder(folder, kCommit))) {
    return {};
  }
  const base::Result<std::unique_ptr<FolderLock>> lock = FolderLock::take(folder);
  return lock ? finishCommit(folder) : lock.diagnostics();
}

base::Diagnostics checkListed(const std::string& folder, const std::vector<std::string>& names) {
  const std::map<std::string, std::string> listed =
      listedIn(manifestIn(folder, OutputFolder::kManifest));
  base::Diagnostics problems;
  for (const std::string& name : names) {
    const bool isMeant = listed.count(name) != 0 || stands(inFolder(folder, name));
    if (!listed.empty() && isMeant && !isListed(folder, listed, name)) {
      problems.push_back(base::error("trace.other-run", {}, inFolder(folder, name)));
    }
  }
  return problems;
}

}  // namespace app
