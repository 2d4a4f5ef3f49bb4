#include "sim2d/base/NewFile.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace base {

namespace fs = std::filesystem;

namespace {

/// The file that is meant: what a symbolic link points at, so that the link stays.
fs::path targetOf(const std::string& path) {
  std::error_code error;
  if (fs::is_symlink(path, error)) {
    const fs::path real = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : real;
  }
  return path;
}

}  // namespace

Diagnostic fileError(std::string_view code, const std::string& path, const std::error_code& why) {
  return error(code, {why.message()}, path);
}

std::error_code lastError() {
  return {errno, std::generic_category()};
}

std::unique_ptr<NewFile> NewFile::open(const std::string& path, Diagnostics& problems) {
  const fs::path target = targetOf(path);
  std::error_code error;
  if (path.empty() || fs::is_directory(target, error)) {
    problems.push_back(
        fileError("file.cannot-write", path,
                  std::make_error_code(path.empty() ? std::errc::no_such_file_or_directory
                                                    : std::errc::is_a_directory)));
    return nullptr;
  }
  if (target.has_parent_path()) {
    error.clear();
    fs::create_directories(target.parent_path(), error);
    if (error) {
      problems.push_back(
          fileError("file.cannot-make-folder", target.parent_path().string(), error));
      return nullptr;
    }
  }
  auto file = std::make_unique<NewFile>(target);
  error = file->make();
  if (error) {
    problems.push_back(fileError("file.cannot-write", path, error));
    return nullptr;
  }
  return file;
}

NewFile::NewFile(fs::path target) : target_(std::move(target)) {}

NewFile::~NewFile() {
  close();
  for (const std::string& name : {name_, old_}) {
    if (!name.empty()) {
      ::unlink(name.c_str());
    }
  }
}

std::error_code NewFile::make() {
  const std::string stem = target_.string() + ".new-" + std::to_string(::getpid()) + "-";
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = stem + std::to_string(attempt);
    descriptor_ = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      name_ = name;
      return keepMode();
    }
    if (errno != EEXIST) {
      break;
    }
  }
  return lastError();
}

std::error_code NewFile::write(std::string_view content) const {
  while (!content.empty()) {
    const ssize_t count = ::write(descriptor_, content.data(), content.size());
    if (count < 0 && errno != EINTR) {
      return lastError();
    }
    content.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return {};
}

std::error_code NewFile::toDisk() const {
  return ::fsync(descriptor_) == 0 ? std::error_code() : lastError();
}

std::error_code NewFile::putInPlace() {
  if (!close() || ::rename(name_.c_str(), target_.c_str()) != 0) {
    return lastError();
  }
  name_.clear();
  return {};
}

std::error_code NewFile::keepOld() {
  std::error_code error;
  if (!fs::exists(target_, error)) {
    return error;
  }
  const std::string name = name_ + "-old";
  fs::create_hard_link(target_, name, error);
  if (error) {  // not every file system has them
    fs::copy_file(target_, name, error);
  }
  if (!error) {
    old_ = name;
  }
  return error;
}

std::error_code NewFile::takeBack() {
  if (old_.empty()) {
    return ::unlink(target_.c_str()) == 0 ? std::error_code() : lastError();
  }
  if (::rename(old_.c_str(), target_.c_str()) != 0) {
    return lastError();
  }
  old_.clear();
  return {};
}

/// A file that is replaced keeps its permissions.
std::error_code NewFile::keepMode() const {
  struct stat old = {};
  if (::stat(target_.c_str(), &old) == 0 && ::fchmod(descriptor_, old.st_mode & 07777U) != 0) {
    return lastError();
  }
  return {};
}

bool NewFile::close() {
  const int descriptor = descriptor_;
  descriptor_ = -1;
  return descriptor < 0 || ::close(descriptor) == 0;
}

}  // namespace base
