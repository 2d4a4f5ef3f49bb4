#include "app/run/FolderLock.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include "app/run/ManifestFiles.h"
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
    return {base::error("file.cannot-make-folder", {error.message()},
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
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) {
      return writeProblem(path);
    }
    std::unique_ptr<FolderLock> lock(new FolderLock(path, file));
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
    return base::error("file.cannot-make-folder", {error ? error.message() : std::string()},
                       folder);
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
  ::close(file_);
}

void flushFolder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor >= 0) {
    ::fsync(descriptor);  // unsupported by some file systems; the order of renames holds anyway
    ::close(descriptor);
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
    return base::error("file.cannot-read", {error.message()}, folder);
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

}  // namespace app
