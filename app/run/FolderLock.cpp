#include "app/run/FolderLock.h"

#include <array>
#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>
#include <vector>

#include "sim2d/base/Text.h"

namespace app {

namespace {

std::string hostName() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

base::Diagnostic lockProblem(const std::string& path) {
  const int error = errno;
  return base::error("file.cannot-write", {std::system_category().message(error)}, path);
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

}  // namespace

base::Result<std::unique_ptr<FolderLock>> FolderLock::acquire(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / kFile).string();
  while (true) {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
    if (file < 0) {
      return lockProblem(path);
    }
    std::unique_ptr<FolderLock> lock(new FolderLock(path, file));
    if (::flock(file, LOCK_EX | LOCK_NB) != 0) {
      lock->path_.clear();  // another process owns the file
      return errno == EWOULDBLOCK ? heldByOther(folder, file) : lockProblem(path);
    }
    if (isSame(file, path)) {  // otherwise its owner has just removed it
      const std::string who = std::to_string(::getpid()) + " " + hostName() + "\n";
      if (::ftruncate(file, 0) != 0 ||
          ::pwrite(file, who.data(), who.size(), 0) != static_cast<ssize_t>(who.size())) {
        return lockProblem(path);
      }
      return lock;
    }
    lock->path_.clear();
  }
}

base::Result<std::unique_ptr<FolderLock>> FolderLock::createAndAcquire(const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder, error)) {
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

}  // namespace app
