#include "sim2d/base/Files.h"

#include <cerrno>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

#include "sim2d/base/Text.h"

namespace base {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kPiece = 1U << 16U;  // [bytes] that a growing file writes at once

/// The file that is meant: what a symbolic link points at, so that the link stays.
fs::path targetOf(const std::string& path) {
  std::error_code error;
  if (fs::is_symlink(path, error)) {
    const fs::path real = fs::weakly_canonical(path, error);
    return error ? fs::path(path) : real;
  }
  return path;
}

/// "cannot write the file: permission denied" at the file.
Diagnostic fileError(std::string_view code, const std::string& path, const std::error_code& why) {
  return error(code, {why.message()}, path);
}

/// Of the last call to the system.
std::error_code lastError() {
  return {errno, std::generic_category()};
}

}  // namespace

/// A file of its own beside its place; closed and removed again unless it was put there.
class NewFile {
 public:
  /// Opened for writing. Folders are made, the permissions of a replaced file and symbolic links
  /// stay. Nothing and an error in `problems` when that cannot be.
  static std::unique_ptr<NewFile> open(const std::string& path, Diagnostics& problems);

  explicit NewFile(fs::path target);
  ~NewFile();
  NewFile(const NewFile&) = delete;
  NewFile& operator=(const NewFile&) = delete;
  NewFile(NewFile&&) = delete;
  NewFile& operator=(NewFile&&) = delete;

  std::error_code write(std::string_view content) const;
  std::error_code toDisk() const;  // what was written stays when the power fails
  std::error_code putInPlace();
  /// The file that stands there gets a second name until this object ends.
  std::error_code keepOld();
  /// After putInPlace: as it was before.
  std::error_code takeBack();

 private:
  std::error_code make();
  std::error_code keepMode() const;
  bool close();

  fs::path target_;
  std::string name_;
  std::string old_;  // second name of the file that was replaced
  int descriptor_ = -1;
};

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

GrowingFile::GrowingFile(std::string path)
    : path_(std::move(path)), part_(NewFile::open(path_, problems_)) {}

GrowingFile::~GrowingFile() = default;

void GrowingFile::note(const std::error_code& error) {
  if (error && problems_.empty()) {
    problems_.push_back(fileError("file.cannot-write", path_, error));
  }
}

void GrowingFile::flush() {
  if (problems_.empty() && part_) {
    note(part_->write(waiting_));
  }
  waiting_.clear();
}

void GrowingFile::append(std::string_view content) {
  waiting_ += content;
  if (waiting_.size() >= kPiece) {
    flush();
  }
}

const Diagnostics& GrowingFile::complete() {
  flush();
  if (problems_.empty() && part_) {
    note(part_->toDisk());
  }
  return problems_;
}

Diagnostics GrowingFile::finish() {
  complete();
  if (problems_.empty() && part_) {
    note(part_->putInPlace());
  }
  part_.reset();
  return problems_;
}

namespace {

/// The content on the disk under a name of its own.
Diagnostics prepare(const FileContent& file, std::vector<std::unique_ptr<NewFile>>& made) {
  Diagnostics problems;
  std::unique_ptr<NewFile> part = NewFile::open(file.path, problems);
  if (!part) {
    return problems;
  }
  std::error_code error = part->write(file.content);
  if (!error) {
    error = part->toDisk();
  }
  made.push_back(std::move(part));
  return error ? Diagnostics{fileError("file.cannot-write", file.path, error)} : Diagnostics();
}

}  // namespace

Result<std::string> readTextFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return fileError("file.cannot-read", path,
                     error ? error : std::make_error_code(std::errc::no_such_file_or_directory));
  }
  if (fs::is_directory(status)) {
    return fileError("file.cannot-read", path, std::make_error_code(std::errc::is_a_directory));
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return fileError("file.cannot-read", path, lastError());
  }
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) {
    return fileError("file.cannot-read", path, lastError());
  }
  return content;
}

Diagnostics writeFileAtomically(const std::string& path, std::string_view content) {
  return writeFilesTogether({{path, std::string(content)}});
}

Diagnostics writeFilesTogether(const std::vector<FileContent>& files) {
  Diagnostics problems;
  std::vector<std::unique_ptr<NewFile>> made;
  std::set<std::string> told;  // a folder that cannot be made, once
  for (const FileContent& file : files) {
    for (Diagnostic& problem : prepare(file, made)) {
      if (told.insert(problem.text()).second) {
        problems.push_back(std::move(problem));
      }
    }
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
      problems.push_back(fileError("file.cannot-write", files[i].path, error));
      for (std::size_t done = i; done-- > 0;) {
        if (const std::error_code lost = made[done]->takeBack()) {
          problems.push_back(fileError("file.cannot-restore", files[done].path, lost));
        }
      }
      break;
    }
  }
  return problems;
}

}  // namespace base
