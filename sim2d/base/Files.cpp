#include "sim2d/base/Files.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <set>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <utility>

#include "sim2d/base/Text.h"

namespace base {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t kWriteSize = 1U << 16U;  // [bytes] written per system call

/// The file to replace: the target of a symbolic link, so that the link is kept.
std::string targetOf(const std::string& path) {
  std::error_code error;
  const bool isLink = fs::is_symlink(path, error);
  const fs::path real = isLink ? fs::weakly_canonical(path, error) : fs::path(path);
  return error ? path : real.string();
}

/// A diagnostic at `path` with the system's message: "cannot write the file: permission denied".
Diagnostic fileError(std::string_view code, const std::string& path, const std::error_code& why) {
  return error(code, {why.message()}, path);
}

/// The error of the last system call.
std::error_code lastError() {
  return {errno, std::generic_category()};
}

std::error_code errorUnless(bool isDone) {
  return isDone ? std::error_code() : lastError();
}

constexpr std::string_view kTemporarySuffix = ".new-", kBackupSuffix = "-old";

/// The process id in "<file>.new-<process>-<number>", optionally with "-old". None: another name.
std::optional<long long> writerPidOf(std::string_view name, std::string_view file) {
  if (!startsWith(name, file) || !startsWith(name.substr(file.size()), kTemporarySuffix)) {
    return std::nullopt;
  }
  name.remove_prefix(file.size() + kTemporarySuffix.size());
  name.remove_suffix(endsWith(name, kBackupSuffix) ? kBackupSuffix.size() : 0);
  const std::vector<std::string> numbers = split(std::string(name), '-');
  const bool isMade =
      numbers.size() == 2 && std::all_of(numbers.begin(), numbers.end(), [](const auto& text) {
        return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
      });
  return isMade ? parseInt(numbers.front()) : std::nullopt;
}

/// Whether the process runs on this machine: it may create its temporary files at any time.
bool isProcessRunning(long long process) {
  return ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

/// The lock of a file that no running process holds, as long as the descriptor lives; not open if
/// there is no file. None: another process holds the lock, or this cannot be determined.
std::optional<FileDescriptor> lockUnused(const std::string& path) {
  FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  const bool isUnlocked =
      file.isOpen() ? ::flock(file.number(), LOCK_EX | LOCK_NB) == 0 : errno == ENOENT;
  return isUnlocked ? std::make_optional(std::move(file)) : std::nullopt;
}

/// Removes temporary files of `target` that killed processes left. A writer on another machine
/// holds the lock of its new file until it ends, also after the rename.
void removeStaleFiles(const std::string& target) {
  const std::string file = fs::path(target).filename().string();
  const fs::path folder = fs::path(target).parent_path();
  std::error_code error;  // an unreadable folder is left unchanged
  std::vector<std::string> left;
  for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error), end;
       !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const std::optional<long long> maker = writerPidOf(at->path().filename().string(), file);
    if (maker && !isProcessRunning(*maker) && fs::is_regular_file(at->symlink_status(ignored))) {
      left.push_back(at->path().string());
    }
  }
  for (const std::string& name : left) {
    const bool isOld = endsWith(name, kBackupSuffix);
    const std::string made = isOld ? name.substr(0, name.size() - kBackupSuffix.size()) : name;
    const auto maker = lockUnused(made);  // so no other process opens it before removal
    if (maker && (!isOld || lockUnused(target))) {
      ::unlink(name.c_str());
    }
  }
}

/// Creates a file and locks it. Not open: errno has the reason.
FileDescriptor createLockedFile(const std::string& name) {
  FileDescriptor file(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  struct stat made = {};
  if (file.isOpen()) {
    // File systems without locks also report no lock holder, so nobody removes the file.
    const bool isTaken = ::flock(file.number(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (isTaken ||
        (::fstat(file.number(), &made) == 0 && made.st_nlink == 0)) {  // removed as stale
      file.close();
      errno = EEXIST;
    }
  }
  return file;
}

}  // namespace

AtomicFileWriter::AtomicFileWriter(std::string path)
    : path_(std::move(path)), targetPath_(targetOf(path_)) {
  std::error_code error;
  if (path_.empty() || fs::is_directory(targetPath_, error)) {
    note(std::make_error_code(path_.empty() ? std::errc::no_such_file_or_directory
                                            : std::errc::is_a_directory));
    return;
  }
  error.clear();
  const fs::path folder = fs::path(targetPath_).parent_path();
  if (!folder.empty()) {
    fs::create_directories(folder, error);
  }
  if (error) {
    problems_.push_back(fileError("file.cannot-make-folder", folder.string(), error));
  } else {
    note(open());
  }
}

AtomicFileWriter::~AtomicFileWriter() {
  removeTemporaryFiles();
}

void AtomicFileWriter::note(const std::error_code& error) {
  if (error && problems_.empty()) {
    problems_.push_back(fileError("file.cannot-write", path_, error));
  }
}

std::error_code AtomicFileWriter::open() {
  removeStaleFiles(targetPath_);
  const std::string stem =
      targetPath_ + std::string(kTemporarySuffix) + std::to_string(::getpid()) + "-";
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = stem + std::to_string(attempt);
    descriptor_ = createLockedFile(name);
    if (descriptor_.isOpen()) {
      temporaryPath_ = name;
      struct stat old = {};  // keep the old permissions
      return errorUnless(::stat(targetPath_.c_str(), &old) != 0 ||
                         ::fchmod(descriptor_.number(), old.st_mode & 07777U) == 0);
    }
    if (errno != EEXIST) {
      break;
    }
  }
  return lastError();
}

void AtomicFileWriter::append(std::string_view content) {
  buffer_ += content;
  if (buffer_.size() >= kWriteSize) {
    flush();
  }
}

void AtomicFileWriter::flush() {
  if (isOpen()) {
    note(write());
  }
  buffer_.clear();
}

std::error_code AtomicFileWriter::write() const {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_.number(), rest.data(), rest.size());
    if (count < 0 && errno != EINTR) {
      return lastError();
    }
    rest.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return {};
}

const Diagnostics& AtomicFileWriter::complete() {
  flush();
  if (isOpen()) {
    note(errorUnless(::fsync(descriptor_.number()) == 0));
  }
  return problems_;
}

Diagnostics AtomicFileWriter::finish() {
  complete();
  if (isOpen()) {
    note(replaceTarget());
  }
  removeTemporaryFiles();
  return problems_;
}

std::error_code AtomicFileWriter::replaceTarget() {
  if (::rename(temporaryPath_.c_str(), targetPath_.c_str()) != 0) {
    return lastError();
  }
  temporaryPath_.clear();
  return {};
}

std::error_code AtomicFileWriter::backUpTarget() {
  std::error_code error;
  if (!fs::exists(targetPath_, error)) {
    return error;
  }
  const std::string name = temporaryPath_ + std::string(kBackupSuffix);
  fs::create_hard_link(targetPath_, name, error);
  if (error) {  // not every file system supports links
    fs::copy_file(targetPath_, name, error);
  }
  if (!error) {
    backupPath_ = name;
  }
  return error;
}

std::error_code AtomicFileWriter::restoreTarget() {
  if (backupPath_.empty()) {
    return errorUnless(::unlink(targetPath_.c_str()) == 0);
  }
  if (::rename(backupPath_.c_str(), targetPath_.c_str()) != 0) {
    return lastError();
  }
  backupPath_.clear();
  return {};
}

void AtomicFileWriter::removeTemporaryFiles() {
  for (std::string* name : {&temporaryPath_, &backupPath_}) {
    if (!name->empty()) {
      ::unlink(name->c_str());
      name->clear();
    }
  }
  descriptor_.close();  // releases the lock; complete() has synced the data
}

Diagnostics writeFileAtomically(const std::string& path, std::string_view content) {
  return writeFilesAtomically({{path, std::string(content)}});
}

/// Replaces all targets or none, as far as the file system permits.
Diagnostics AtomicFileWriter::replaceAll(
    const std::vector<FileContent>& files,
    const std::vector<std::unique_ptr<AtomicFileWriter>>& made) {
  for (std::size_t i = 0; i < made.size(); ++i) {
    std::error_code error;
    if (i + 1 < made.size()) {  // no step can fail after the last file
      error = made[i]->backUpTarget();
    }
    if (!error) {
      error = made[i]->replaceTarget();
    }
    if (!error) {
      continue;
    }
    Diagnostics problems = {fileError("file.cannot-write", files[i].path, error)};
    for (std::size_t done = i; done-- > 0;) {
      if (const std::error_code lost = made[done]->restoreTarget()) {
        problems.push_back(fileError("file.cannot-restore", files[done].path, lost));
      }
    }
    return problems;
  }
  return {};
}

Diagnostics writeFilesAtomically(const std::vector<FileContent>& files) {
  Diagnostics problems;
  std::vector<std::unique_ptr<AtomicFileWriter>> made;
  std::set<std::string> told;  // report an uncreatable folder once
  for (const FileContent& file : files) {
    made.push_back(std::make_unique<AtomicFileWriter>(file.path));
    made.back()->append(file.content);
    for (const Diagnostic& problem : made.back()->complete()) {
      if (told.insert(problem.text()).second) {
        problems.push_back(problem);
      }
    }
  }
  return problems.empty() ? AtomicFileWriter::replaceAll(files, made) : problems;
}

bool ScratchFile::fail() {
  problem_ = lastError();
  return false;
}

bool ScratchFile::openIn(const std::string& folder) {
#ifdef O_TMPFILE
  file_ = FileDescriptor(::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR));
#endif
  if (!file_.isOpen()) {  // the file system does not support O_TMPFILE
    std::string name = folder + "/hunavsim-XXXXXX";
    file_ = FileDescriptor(::mkostemp(name.data(), O_CLOEXEC));
    if (!file_.isOpen()) {
      return fail();
    }
    ::unlink(name.c_str());
  }
  return true;
}

bool ScratchFile::open() {
  if (file_.isOpen()) {
    return true;
  }
  if (!folder_.empty()) {
    return openIn(folder_);
  }
  const char* const wanted = std::getenv("TMPDIR");
  return (wanted != nullptr && *wanted != '\0' && openIn(wanted)) || openIn("/var/tmp") ||
         openIn("/tmp");
}

bool ScratchFile::hasFreeSpace(std::size_t size) {
  struct statvfs disk = {};
  if (minFreeSpace_ <= 0 || ::fstatvfs(file_.number(), &disk) != 0) {
    return true;  // the write reports a full disk
  }
  const double left = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  if (left >= static_cast<double>(minFreeSpace_) + static_cast<double>(size)) {
    return true;
  }
  errno = ENOSPC;
  return fail();
}

std::optional<ScratchFile::Piece> ScratchFile::append(std::string_view bytes) {
  if (!open() || !hasFreeSpace(bytes.size())) {
    return std::nullopt;
  }
  const Piece piece{end_, bytes.size()};
  if (!overwrite(piece, bytes)) {
    return std::nullopt;
  }
  end_ += static_cast<long long>(bytes.size());
  return piece;
}

bool ScratchFile::overwrite(const Piece& piece, std::string_view bytes) {
  long long place = piece.place;
  while (!bytes.empty()) {
    errno = EIO;  // in case a call writes nothing and sets no error
    const ssize_t count = pwrite(file_.number(), bytes.data(), bytes.size(), place);
    if (count <= 0 && errno != EINTR) {
      return fail();
    }
    if (count > 0) {
      bytes.remove_prefix(static_cast<std::size_t>(count));
      place += count;
    }
  }
  return true;
}

void ScratchFile::prefetch(const Piece& piece) const {
  if (file_.isOpen()) {
    ::posix_fadvise(file_.number(), piece.place, static_cast<off_t>(piece.size),
                    POSIX_FADV_WILLNEED);
  }
}

bool ScratchFile::read(const Piece& piece, char* to) const {
  std::size_t done = 0;
  while (file_.isOpen() && done < piece.size) {
    const auto place = piece.place + static_cast<long long>(done);
    const ssize_t count = pread(file_.number(), to + done, piece.size - done, place);
    if (count <= 0) {
      return false;
    }
    done += static_cast<std::size_t>(count);
  }
  return done == piece.size;
}

std::optional<std::string> ScratchFile::read(const Piece& piece) const {
  std::string bytes(piece.size, '\0');
  return read(piece, bytes.data()) ? std::make_optional(std::move(bytes)) : std::nullopt;
}

}  // namespace base
