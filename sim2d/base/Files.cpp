#include "sim2d/base/Files.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
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

constexpr std::size_t kPiece = 1U << 16U;  // [bytes] that a growing file writes at once

/// The file that is meant: what a symbolic link points at, so that the link stays.
std::string targetOf(const std::string& path) {
  std::error_code error;
  const bool isLink = fs::is_symlink(path, error);
  const fs::path real = isLink ? fs::weakly_canonical(path, error) : fs::path(path);
  return error ? path : real.string();
}

/// "cannot write the file: permission denied" at the file.
Diagnostic fileError(std::string_view code, const std::string& path, const std::error_code& why) {
  return error(code, {why.message()}, path);
}

/// Of the last call to the system.
std::error_code lastError() {
  return {errno, std::generic_category()};
}

std::error_code errorUnless(bool isDone) {
  return isDone ? std::error_code() : lastError();
}

constexpr std::string_view kNew = ".new-", kOld = "-old";

bool endsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && text.substr(text.size() - end.size()) == end;
}

/// Of "<file>.new-<process>-<number>", with "-old" or without, the process; none: another name.
std::optional<long long> makerOf(std::string_view name, std::string_view file) {
  if (name.substr(0, file.size()) != file || name.substr(file.size(), kNew.size()) != kNew) {
    return std::nullopt;
  }
  name.remove_prefix(file.size() + kNew.size());
  name.remove_suffix(endsWith(name, kOld) ? kOld.size() : 0);
  const std::vector<std::string> numbers = split(std::string(name), '-');
  const bool isMade =
      numbers.size() == 2 && std::all_of(numbers.begin(), numbers.end(), [](const auto& text) {
        return !text.empty() && std::all_of(text.begin(), text.end(), isDigit);
      });
  return isMade ? parseInt(numbers.front()) : std::nullopt;
}

/// On this machine: a name that it uses may be made again at any moment.
bool isAlive(long long process) {
  return ::kill(static_cast<pid_t>(process), 0) == 0 || errno != ESRCH;
}

/// The lock of a file that nobody who lives has; it lasts as long as this.
class FreeFile {
 public:
  explicit FreeFile(const std::string& path)
      : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK)),
        isFree_(file_ < 0 ? errno == ENOENT : ::flock(file_, LOCK_EX | LOCK_NB) == 0) {}
  ~FreeFile() {
    if (file_ >= 0) {
      ::close(file_);
    }
  }
  FreeFile(const FreeFile&) = delete;
  FreeFile& operator=(const FreeFile&) = delete;
  FreeFile(FreeFile&&) = delete;
  FreeFile& operator=(FreeFile&&) = delete;

  /// No: somebody has it, or that cannot be found out.
  bool isFree() const { return isFree_; }

 private:
  int file_;
  bool isFree_;
};

/// What killed processes left of their work on a file. One that lives on another machine has the
/// lock of the new file until its end, wherever that lies by now.
void removeLeftBehind(const std::string& target) {
  const std::string file = fs::path(target).filename().string();
  const fs::path folder = fs::path(target).parent_path();
  std::error_code error;  // a folder that cannot be looked at keeps what is in it
  std::vector<std::string> left;
  for (fs::directory_iterator at(folder.empty() ? fs::path(".") : folder, error), end;
       !error && at != end; at.increment(error)) {
    std::error_code ignored;
    const std::optional<long long> maker = makerOf(at->path().filename().string(), file);
    if (maker && !isAlive(*maker) && fs::is_regular_file(at->symlink_status(ignored))) {
      left.push_back(at->path().string());
    }
  }
  for (const std::string& name : left) {
    const bool isOld = endsWith(name, kOld);
    const std::string made = isOld ? name.substr(0, name.size() - kOld.size()) : name;
    const FreeFile maker(made);  // nobody else takes it up before it is gone
    if (maker.isFree() && (!isOld || FreeFile(target).isFree())) {
      ::unlink(name.c_str());
    }
  }
}

/// A new file with its lock; negative: errno tells why not.
int makeLocked(const std::string& name) {
  const int file = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  struct stat made = {};
  if (file >= 0) {
    // Where a disk has no locks nobody takes it away either.
    const bool isTaken = ::flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
    if (isTaken || (::fstat(file, &made) == 0 && made.st_nlink == 0)) {  // taken for left behind
      ::close(file);
      errno = EEXIST;
      return -1;
    }
  }
  return file;
}

}  // namespace

GrowingFile::GrowingFile(std::string path) : path_(std::move(path)), target_(targetOf(path_)) {
  std::error_code error;
  if (path_.empty() || fs::is_directory(target_, error)) {
    note(std::make_error_code(path_.empty() ? std::errc::no_such_file_or_directory
                                            : std::errc::is_a_directory));
    return;
  }
  error.clear();
  const fs::path folder = fs::path(target_).parent_path();
  if (!folder.empty()) {
    fs::create_directories(folder, error);
  }
  if (error) {
    problems_.push_back(fileError("file.cannot-make-folder", folder.string(), error));
  } else {
    note(open());
  }
}

GrowingFile::~GrowingFile() {
  removeRest();
}

void GrowingFile::note(const std::error_code& error) {
  if (error && problems_.empty()) {
    problems_.push_back(fileError("file.cannot-write", path_, error));
  }
}

std::error_code GrowingFile::open() {
  removeLeftBehind(target_);
  const std::string stem = target_ + std::string(kNew) + std::to_string(::getpid()) + "-";
  for (int attempt = 0; attempt < 1000; ++attempt) {
    const std::string name = stem + std::to_string(attempt);
    descriptor_ = makeLocked(name);
    if (descriptor_ >= 0) {
      new_ = name;
      struct stat old = {};  // a file that is replaced keeps its permissions
      return errorUnless(::stat(target_.c_str(), &old) != 0 ||
                         ::fchmod(descriptor_, old.st_mode & 07777U) == 0);
    }
    if (errno != EEXIST) {
      break;
    }
  }
  return lastError();
}

void GrowingFile::append(std::string_view content) {
  waiting_ += content;
  if (waiting_.size() >= kPiece) {
    flush();
  }
}

void GrowingFile::flush() {
  if (isOpen()) {
    note(write());
  }
  waiting_.clear();
}

std::error_code GrowingFile::write() const {
  std::string_view rest = waiting_;
  while (!rest.empty()) {
    const ssize_t count = ::write(descriptor_, rest.data(), rest.size());
    if (count < 0 && errno != EINTR) {
      return lastError();
    }
    rest.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
  }
  return {};
}

const Diagnostics& GrowingFile::complete() {
  flush();
  if (isOpen()) {
    note(errorUnless(::fsync(descriptor_) == 0));
  }
  return problems_;
}

Diagnostics GrowingFile::finish() {
  complete();
  if (isOpen()) {
    note(putInPlace());
  }
  removeRest();
  return problems_;
}

std::error_code GrowingFile::putInPlace() {
  if (::rename(new_.c_str(), target_.c_str()) != 0) {
    return lastError();
  }
  new_.clear();
  return {};
}

std::error_code GrowingFile::keepOld() {
  std::error_code error;
  if (!fs::exists(target_, error)) {
    return error;
  }
  const std::string name = new_ + std::string(kOld);
  fs::create_hard_link(target_, name, error);
  if (error) {  // not every file system has them
    fs::copy_file(target_, name, error);
  }
  if (!error) {
    old_ = name;
  }
  return error;
}

std::error_code GrowingFile::takeBack() {
  if (old_.empty()) {
    return errorUnless(::unlink(target_.c_str()) == 0);
  }
  if (::rename(old_.c_str(), target_.c_str()) != 0) {
    return lastError();
  }
  old_.clear();
  return {};
}

bool GrowingFile::close() {
  const int descriptor = std::exchange(descriptor_, -1);
  return descriptor < 0 || ::close(descriptor) == 0;
}

void GrowingFile::removeRest() {
  for (std::string* name : {&new_, &old_}) {
    if (!name->empty()) {
      ::unlink(name->c_str());
      name->clear();
    }
  }
  close();  // and the lock; all is on the disk since complete()
}

Diagnostics writeFileAtomically(const std::string& path, std::string_view content) {
  return writeFilesTogether({{path, std::string(content)}});
}

/// All or none of them, as far as the disk lets us.
Diagnostics GrowingFile::putTogether(const std::vector<FileContent>& files,
                                     const std::vector<std::unique_ptr<GrowingFile>>& made) {
  for (std::size_t i = 0; i < made.size(); ++i) {
    std::error_code error;
    if (i + 1 < made.size()) {  // nothing can go wrong any more after the last one
      error = made[i]->keepOld();
    }
    if (!error) {
      error = made[i]->putInPlace();
    }
    if (!error) {
      continue;
    }
    Diagnostics problems = {fileError("file.cannot-write", files[i].path, error)};
    for (std::size_t done = i; done-- > 0;) {
      if (const std::error_code lost = made[done]->takeBack()) {
        problems.push_back(fileError("file.cannot-restore", files[done].path, lost));
      }
    }
    return problems;
  }
  return {};
}

Diagnostics writeFilesTogether(const std::vector<FileContent>& files) {
  Diagnostics problems;
  std::vector<std::unique_ptr<GrowingFile>> made;
  std::set<std::string> told;  // a folder that cannot be made, once
  for (const FileContent& file : files) {
    made.push_back(std::make_unique<GrowingFile>(file.path));
    made.back()->append(file.content);
    for (const Diagnostic& problem : made.back()->complete()) {
      if (told.insert(problem.text()).second) {
        problems.push_back(problem);
      }
    }
  }
  return problems.empty() ? GrowingFile::putTogether(files, made) : problems;
}

bool ScratchFile::fail() {
  problem_ = lastError();
  return false;
}

bool ScratchFile::openIn(const std::string& folder) {
  int descriptor = -1;
#ifdef O_TMPFILE
  descriptor = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, S_IRUSR | S_IWUSR);
#endif
  if (descriptor < 0) {  // a file system that knows no files without a name
    std::string name = folder + "/hunavsim-XXXXXX";
    descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0) {
      return fail();
    }
    ::unlink(name.c_str());
  }
  file_.reset(::fdopen(descriptor, "w+b"));
  if (file_ == nullptr) {
    fail();
    ::close(descriptor);
  }
  return file_ != nullptr;
}

bool ScratchFile::open() {
  if (file_ != nullptr) {
    return true;
  }
  if (!folder_.empty()) {
    return openIn(folder_);
  }
  const char* const wanted = std::getenv("TMPDIR");
  return (wanted != nullptr && *wanted != '\0' && openIn(wanted)) || openIn("/var/tmp") ||
         openIn("/tmp");
}

bool ScratchFile::hasRoom(std::size_t size) {
  struct statvfs disk = {};
  if (leavesFree_ <= 0 || ::fstatvfs(fileno(file_.get()), &disk) != 0) {
    return true;  // writing tells
  }
  const double left = static_cast<double>(disk.f_bavail) * static_cast<double>(disk.f_frsize);
  if (left >= static_cast<double>(leavesFree_) + static_cast<double>(size)) {
    return true;
  }
  errno = ENOSPC;
  return fail();
}

std::optional<ScratchFile::Piece> ScratchFile::append(std::string_view bytes) {
  if (!open() || !hasRoom(bytes.size())) {
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
    errno = EIO;  // when nothing is written without a reason
    const ssize_t count = pwrite(fileno(file_.get()), bytes.data(), bytes.size(), place);
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

void ScratchFile::announce(const Piece& piece) const {
  if (file_ != nullptr) {
    ::posix_fadvise(fileno(file_.get()), piece.place, static_cast<off_t>(piece.size),
                    POSIX_FADV_WILLNEED);
  }
}

bool ScratchFile::read(const Piece& piece, char* to) const {
  std::size_t done = 0;
  while (file_ && done < piece.size) {
    const auto place = piece.place + static_cast<long long>(done);
    const ssize_t count = pread(fileno(file_.get()), to + done, piece.size - done, place);
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
