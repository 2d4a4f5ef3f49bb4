#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

#include "sim2d/base/FileSet.h"
#include "sim2d/base/Text.h"

namespace base {
namespace {

namespace fs = std::filesystem;

Diagnostic fileError(const std::string& what, const std::string& path, const std::error_code& why) {
  return makeError(what + ": " + why.message(), path);
}

std::error_code lastError() {
  return {errno, std::generic_category()};
}

/// A file of its own beside the target; closed and removed again unless it was put in place.
class NewFile {
 public:
  explicit NewFile(fs::path target) : target_(std::move(target)) {}
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  NewFile(NewFile&&) = delete;
  NewFile& operator=(NewFile&&) = delete;
  ~NewFile() {
    close();
    for (const std::string& name : {name_, old_}) {
      if (!name.empty()) {
        ::unlink(name.c_str());
      }
    }
  }

  std::error_code open() {
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

  std::error_code write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t count = ::write(descriptor_, content.data(), content.size());
      if (count < 0 && errno != EINTR) {
        return lastError();
      }
      content.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return ::fsync(descriptor_) == 0 ? std::error_code() : lastError();
  }

  std::error_code putInPlace() {
    if (!close() || ::rename(name_.c_str(), target_.c_str()) != 0) {
      return lastError();
    }
    name_.clear();
    return {};
  }

  /// The file that stands there gets a second name until this object ends.
  std::error_code keepOld() {
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

  /// After putInPlace: as it was before.
  std::error_code takeBack() {
    if (old_.empty()) {
      return ::unlink(target_.c_str()) == 0 ? std::error_code() : lastError();
    }
    if (::rename(old_.c_str(), target_.c_str()) != 0) {
      return lastError();
    }
    old_.clear();
    return {};
  }

 private:
  /// A file that is replaced keeps its permissions.
  std::error_code keepMode() const {
    struct stat old = {};
    if (::stat(target_.c_str(), &old) == 0 && ::fchmod(descriptor_, old.st_mode & 07777U) != 0) {
      return lastError();
    }
    return {};
  }

  bool close() {
    const int descriptor = descriptor_;
    descriptor_ = -1;
    return descriptor < 0 || ::close(descriptor) == 0;
  }

  fs::path target_;
  std::string name_;
  std::string old_;  // second name of the file that was replaced
  int descriptor_ = -1;
};

/// The file that is meant: what a symbolic link points at, so that the link stays.
fs::path targetOf(const std::string& path) {
  std::error_code error;
  if (fs::is_symlink(path, error)) {
    const fs::path real = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : real;
  }
  return path;
}

/// The content on the disk under a name of its own.
Diagnostics prepare(const FileContent& file, std::vector<std::unique_ptr<NewFile>>& made) {
  const fs::path target = targetOf(file.path);
  std::error_code error;
  if (file.path.empty() || fs::is_directory(target, error)) {
    return {fileError("cannot write the file", file.path,
                      std::make_error_code(file.path.empty() ? std::errc::no_such_file_or_directory
                                                             : std::errc::is_a_directory))};
  }
  if (target.has_parent_path()) {
    error.clear();
    fs::create_directories(target.parent_path(), error);
    if (error) {
      return {fileError("cannot make the folder", target.parent_path().string(), error)};
    }
  }
  made.push_back(std::make_unique<NewFile>(target));
  error = made.back()->open();
  if (!error) {
    error = made.back()->write(file.content);
  }
  return error ? Diagnostics{fileError("cannot write the file", file.path, error)} : Diagnostics();
}

}  // namespace

Result<std::string> readTextFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return fileError("cannot read the file", path,
                     error ? error : std::make_error_code(std::errc::no_such_file_or_directory));
  }
  if (fs::is_directory(status)) {
    return fileError("cannot read the file", path, std::make_error_code(std::errc::is_a_directory));
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return fileError("cannot read the file", path, lastError());
  }
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) {
    return fileError("cannot read the file", path, lastError());
  }
  return content;
}

Diagnostics writeFileAtomically(const std::string& path, std::string_view content) {
  return writeFilesTogether({{path, std::string(content)}});
}

Diagnostics writeFilesTogether(const std::vector<FileContent>& files) {
  Diagnostics problems;
  std::vector<std::unique_ptr<NewFile>> made;
  for (const FileContent& file : files) {
    append(problems, prepare(file, made));
  }
  if (!problems.empty()) {
    return problems;
  }
  for (std::size_t i = 0; i < made.size(); ++i) {
    std::error_code error;
    if (i + 1 < made.size()) {  // nothing can go wrong any more after the last one
      error = made[i]->keepOld();
    }
    if (!error) {
      error = made[i]->putInPlace();
    }
    if (error) {
      problems.push_back(fileError("cannot write the file", files[i].path, error));
      for (std::size_t done = i; done-- > 0;) {
        if (const std::error_code lost = made[done]->takeBack()) {
          problems.push_back(fileError("cannot put the old file back", files[done].path, lost));
        }
      }
      break;
    }
  }
  return problems;
}

}  // namespace base
