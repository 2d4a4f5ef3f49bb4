// Loaded into a program by LD_PRELOAD: the calls of the C library that change or read files below a
// folder are counted, and one of them fails (FaultState.h). Calls that glibc makes inside itself
// cannot be seen: what stdio writes after fopen is not, its opening is.
#undef _FORTIFY_SOURCE

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <string_view>
#include <sys/mman.h>
#include <sys/sendfile.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include "tests/support/FaultState.h"

// NOLINTBEGIN: names and signatures are those of the C library

namespace {

using faults::Kind;

constexpr std::size_t kPathSize = 1100;

faults::State* state() {
  static faults::State* const kState = [] {
    const char* const path = std::getenv(faults::kStateVariable);
    const auto file =
        path != nullptr ? syscall(SYS_openat, AT_FDCWD, path, O_RDWR | O_CLOEXEC) : -1;
    if (file < 0) {
      return static_cast<faults::State*>(nullptr);
    }
    void* const place = ::mmap(nullptr, sizeof(faults::State), PROT_READ | PROT_WRITE, MAP_SHARED,
                               static_cast<int>(file), 0);
    syscall(SYS_close, file);
    return place != MAP_FAILED ? static_cast<faults::State*>(place) : nullptr;
  }();
  return kState;
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}
#define HUNAV_REAL(name) static auto* const kReal = real<decltype(::name)>(#name)

/// Path of an open file, as the kernel names it; empty: none.
std::string_view pathOf(int descriptor, char* to) {
  char link[40];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
  const ssize_t size = ::readlink(link, to, kPathSize - 1);
  return {to, size > 0 ? static_cast<std::size_t>(size) : 0};
}

/// Absolute, of a path that is given relative to an open folder.
std::string_view absolute(int folder, const char* path, char* to) {
  std::size_t size = 0;
  if (path[0] != '/') {
    if (folder != AT_FDCWD) {
      size = pathOf(folder, to).size();
    } else if (::getcwd(to, kPathSize / 2) != nullptr) {
      size = std::strlen(to);
    }
    to[size++] = '/';
  }
  const std::size_t rest = std::min(std::strlen(path), kPathSize - size - 1);
  std::memcpy(to + size, path, rest);
  return {to, size + rest};
}

bool isWatched(std::string_view path) {
  const std::string_view folder = state()->folder;
  return !folder.empty() && path.size() >= folder.size() &&
         path.substr(0, folder.size()) == folder &&
         (path.size() == folder.size() || path[folder.size()] == '/');
}

void noteProcess() {
  static int known = 0;
  const int self = ::getpid();
  if (known == self) {
    return;
  }
  known = self;
  const int place = state()->processCount++;
  if (place < static_cast<int>(std::size(state()->processes))) {
    state()->processes[place] = self;
  }
}

[[noreturn]] void die(bool withAll) {
  const int count =
      std::min(state()->processCount.load(), static_cast<int>(std::size(state()->processes)));
  for (int k = 0; k < count && withAll; ++k) {
    if (state()->processes[k] != ::getpid()) {
      ::kill(state()->processes[k], SIGKILL);
    }
  }
  ::kill(::getpid(), SIGKILL);
  while (true) {
    ::pause();
  }
}

void noteStruck(const char* call, std::string_view path) {
  std::snprintf(state()->struck, sizeof state()->struck, "%s %.*s", call,
                static_cast<int>(path.size()), path.data());
}

/// A line of a log, for who wants to see what a number stands for.
void tell(char what, int number, const char* call, std::string_view path) {
  static const char* const kLog = std::getenv(faults::kLogVariable);
  if (kLog == nullptr) {
    return;
  }
  char line[kPathSize + 100];
  const int size = std::snprintf(line, sizeof line, "%c %d %d %s %.*s\n", what, number, ::getpid(),
                                 call, static_cast<int>(path.size()), path.data());
  const auto file =
      syscall(SYS_openat, AT_FDCWD, kLog, O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
  syscall(SYS_write, file, line, std::min(static_cast<std::size_t>(size), sizeof line - 1));
  syscall(SYS_close, file);
}

/// Calls that a full disk refuses.
enum class Needs { Space, Nothing };

/// Counts a call that changes something; errno when it has to fail, else 0.
int changes(const char* call, std::string_view path, Needs needs) {
  if (state() == nullptr || !isWatched(path)) {
    return 0;
  }
  noteProcess();
  const int number = ++state()->changes;
  tell('w', number, call, path);
  const bool isMet = number == state()->at;
  if (isMet && state()->kind != Kind::Count && state()->kind != Kind::ReadError) {
    noteStruck(call, path);
  }
  switch (state()->kind) {
    case Kind::Kill:
    case Kind::KillAll:
    case Kind::Plug:
      if (isMet) {
        die(state()->kind != Kind::Kill);
      }
      return 0;
    case Kind::NoSpace:
      return number >= state()->at && needs == Needs::Space ? ENOSPC : 0;
    case Kind::WriteError:
      return isMet ? EIO : 0;
    case Kind::Count:
    case Kind::ReadError:
      break;
  }
  return 0;
}

int reads(const char* call, std::string_view path) {
  if (state() == nullptr || !isWatched(path)) {
    return 0;
  }
  noteProcess();
  const int number = ++state()->reads;
  tell('r', number, call, path);
  const bool isMet = number == state()->at && state()->kind == Kind::ReadError;
  if (isMet) {
    noteStruck(call, path);
  }
  return isMet ? EIO : 0;
}

int changesPath(const char* call, int folder, const char* path, Needs needs = Needs::Nothing) {
  char buffer[kPathSize];
  return state() == nullptr ? 0 : changes(call, absolute(folder, path, buffer), needs);
}

int changesOpen(const char* call, int descriptor, Needs needs = Needs::Nothing) {
  char buffer[kPathSize];
  return state() == nullptr ? 0 : changes(call, pathOf(descriptor, buffer), needs);
}

int readsOpen(const char* call, int descriptor) {
  char buffer[kPathSize];
  return state() == nullptr ? 0 : reads(call, pathOf(descriptor, buffer));
}

int opens(int folder, const char* path, int flags) {
  if (state() == nullptr || path == nullptr) {
    return 0;
  }
  char buffer[kPathSize];
  const std::string_view whole = absolute(folder, path, buffer);
  if ((flags & O_ACCMODE) == O_RDONLY && (flags & (O_CREAT | O_TRUNC)) == 0) {
    return reads("open", whole);
  }
  const bool isNew = (flags & O_CREAT) != 0 && ::faccessat(folder, path, F_OK, 0) != 0;
  return changes("open", whole, isNew ? Needs::Space : Needs::Nothing);
}

Kind kindNow() {
  return state() != nullptr ? state()->kind : Kind::Count;
}

/// Before a write (what is new is not on the disk), after a sync (all is).
void noteSynced(int descriptor, bool isSynced) {
  struct stat about = {};
  char buffer[kPathSize];
  if (kindNow() != Kind::Plug || !isWatched(pathOf(descriptor, buffer)) ||
      ::fstat(descriptor, &about) != 0 || !S_ISREG(about.st_mode)) {
    return;
  }
  const int count =
      std::min(state()->unsyncedCount.load(), static_cast<int>(std::size(state()->unsynced)));
  for (int k = 0; k < count; ++k) {
    faults::Inode& inode = state()->unsynced[k];
    if (inode.number == about.st_ino && inode.device == about.st_dev) {
      inode.syncedSize = isSynced || about.st_size == 0 ? about.st_size : inode.syncedSize;
      return;
    }
  }
  const int place = state()->unsyncedCount++;
  if (place < static_cast<int>(std::size(state()->unsynced))) {
    state()->unsynced[place] = {about.st_dev, about.st_ino, about.st_size};
  }
}

/// How many of the bytes a write puts there, or -1 with errno: a full disk takes half of the first.
ssize_t allowed(const char* call, int descriptor, std::size_t count) {
  const int error = changesOpen(call, descriptor, Needs::Space);
  if (error == ENOSPC && state()->isFull.exchange(1) == 0 && count > 1) {
    return static_cast<ssize_t>(count / 2);
  }
  errno = error != 0 ? error : errno;
  return error != 0 ? -1 : static_cast<ssize_t>(count);
}

int fails(int error) {
  errno = error;
  return -1;
}

mode_t modeOf(int flags, va_list& words) {
  const bool hasMode = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  return hasMode ? va_arg(words, mode_t) : 0;
}

template <class Real, class... Place>
ssize_t writeAt(Real* call, const char* name, int descriptor, const void* bytes, std::size_t count,
                Place... place) {
  const ssize_t most = allowed(name, descriptor, count);
  if (most < 0) {
    return -1;
  }
  noteSynced(descriptor, false);
  return call(descriptor, bytes, static_cast<std::size_t>(most), place...);
}

}  // namespace

#define HUNAV_OPEN(name)                                         \
  extern "C" int name(const char* path, int flags, ...) {        \
    HUNAV_REAL(name);                                            \
    va_list words;                                               \
    va_start(words, flags);                                      \
    const mode_t mode = modeOf(flags, words);                    \
    va_end(words);                                               \
    const int error = opens(AT_FDCWD, path, flags);              \
    return error != 0 ? fails(error) : kReal(path, flags, mode); \
  }
HUNAV_OPEN(open)
HUNAV_OPEN(open64)

#define HUNAV_OPENAT(name)                                               \
  extern "C" int name(int folder, const char* path, int flags, ...) {    \
    HUNAV_REAL(name);                                                    \
    va_list words;                                                       \
    va_start(words, flags);                                              \
    const mode_t mode = modeOf(flags, words);                            \
    va_end(words);                                                       \
    const int error = opens(folder, path, flags);                        \
    return error != 0 ? fails(error) : kReal(folder, path, flags, mode); \
  }
HUNAV_OPENAT(openat)
HUNAV_OPENAT(openat64)

// What glibc's headers make of calls without a mode.
extern "C" int __open_2(const char* path, int flags) {
  return ::open(path, flags);
}
extern "C" int __open64_2(const char* path, int flags) {
  return ::open64(path, flags);
}
extern "C" int __openat_2(int folder, const char* path, int flags) {
  return ::openat(folder, path, flags);
}
extern "C" int __openat64_2(int folder, const char* path, int flags) {
  return ::openat64(folder, path, flags);
}
extern "C" int creat(const char* path, mode_t mode) {
  return ::open(path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}
extern "C" int creat64(const char* path, mode_t mode) {
  return ::open64(path, O_CREAT | O_WRONLY | O_TRUNC, mode);
}

namespace {

int opensStream(const char* path, const char* mode) {
  const bool isWriting = std::strpbrk(mode, "wa+") != nullptr;
  const bool makes = std::strpbrk(mode, "wa") != nullptr;
  return opens(AT_FDCWD, path, (isWriting ? O_RDWR : O_RDONLY) | (makes ? O_CREAT : 0));
}

}  // namespace

extern "C" FILE* fopen(const char* path, const char* mode) {
  HUNAV_REAL(fopen);
  const int error = opensStream(path, mode);
  errno = error != 0 ? error : errno;
  return error != 0 ? nullptr : kReal(path, mode);
}
extern "C" FILE* fopen64(const char* path, const char* mode) {
  HUNAV_REAL(fopen64);
  const int error = opensStream(path, mode);
  errno = error != 0 ? error : errno;
  return error != 0 ? nullptr : kReal(path, mode);
}
extern "C" DIR* opendir(const char* path) {
  HUNAV_REAL(opendir);
  const int error = opens(AT_FDCWD, path, O_RDONLY);
  errno = error != 0 ? error : errno;
  return error != 0 ? nullptr : kReal(path);
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  HUNAV_REAL(write);
  return writeAt(kReal, "write", descriptor, bytes, count);
}
extern "C" ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t place) {
  HUNAV_REAL(pwrite);
  return writeAt(kReal, "pwrite", descriptor, bytes, count, place);
}
extern "C" ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t place) {
  HUNAV_REAL(pwrite64);
  return writeAt(kReal, "pwrite64", descriptor, bytes, count, place);
}
extern "C" ssize_t writev(int descriptor, const iovec* parts, int count) {
  HUNAV_REAL(writev);
  if (const int error = changesOpen("writev", descriptor, Needs::Space)) {
    return fails(error);
  }
  noteSynced(descriptor, false);
  return kReal(descriptor, parts, count);
}
extern "C" ssize_t sendfile(int to, int from, off_t* place, size_t count) noexcept {
  HUNAV_REAL(sendfile);
  if (const int error = changesOpen("sendfile", to, Needs::Space)) {
    return fails(error);
  }
  noteSynced(to, false);
  return kReal(to, from, place, count);
}
extern "C" ssize_t sendfile64(int to, int from, off64_t* place, size_t count) noexcept {
  HUNAV_REAL(sendfile64);
  if (const int error = changesOpen("sendfile64", to, Needs::Space)) {
    return fails(error);
  }
  noteSynced(to, false);
  return kReal(to, from, place, count);
}
extern "C" ssize_t copy_file_range(int from, off64_t* fromPlace, int to, off64_t* toPlace,
                                   size_t count, unsigned flags) {
  HUNAV_REAL(copy_file_range);
  if (const int error = changesOpen("copy_file_range", to, Needs::Space)) {
    return fails(error);
  }
  noteSynced(to, false);
  return kReal(from, fromPlace, to, toPlace, count, flags);
}

extern "C" int fsync(int descriptor) {
  HUNAV_REAL(fsync);
  if (const int error = changesOpen("fsync", descriptor)) {
    return fails(error);
  }
  const int told = kReal(descriptor);
  noteSynced(descriptor, true);
  return told;
}
extern "C" int fdatasync(int descriptor) {
  HUNAV_REAL(fdatasync);
  if (const int error = changesOpen("fdatasync", descriptor)) {
    return fails(error);
  }
  const int told = kReal(descriptor);
  noteSynced(descriptor, true);
  return told;
}
extern "C" int ftruncate(int descriptor, off_t size) noexcept {
  HUNAV_REAL(ftruncate);
  const int error = changesOpen("ftruncate", descriptor);
  return error != 0 ? fails(error) : kReal(descriptor, size);
}
extern "C" int ftruncate64(int descriptor, off64_t size) noexcept {
  HUNAV_REAL(ftruncate64);
  const int error = changesOpen("ftruncate64", descriptor);
  return error != 0 ? fails(error) : kReal(descriptor, size);
}
extern "C" int fchmod(int descriptor, mode_t mode) noexcept {
  HUNAV_REAL(fchmod);
  const int error = changesOpen("fchmod", descriptor);
  return error != 0 ? fails(error) : kReal(descriptor, mode);
}
/// As the kernel does it: the descriptor is gone, whatever is told.
extern "C" int close(int descriptor) {
  HUNAV_REAL(close);
  const int flags = state() != nullptr ? ::fcntl(descriptor, F_GETFL) : -1;
  const bool isWritten = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
  const int error = isWritten ? changesOpen("close", descriptor) : 0;
  const int told = kReal(descriptor);
  return error != 0 ? fails(error) : told;
}

extern "C" int rename(const char* from, const char* to) noexcept {
  HUNAV_REAL(rename);
  const int error = changesPath("rename", AT_FDCWD, to);
  return error != 0 ? fails(error) : kReal(from, to);
}
extern "C" int renameat(int fromFolder, const char* from, int folder, const char* to) noexcept {
  HUNAV_REAL(renameat);
  const int error = changesPath("renameat", folder, to);
  return error != 0 ? fails(error) : kReal(fromFolder, from, folder, to);
}
extern "C" int renameat2(int fromFolder, const char* from, int folder, const char* to,
                         unsigned flags) noexcept {
  HUNAV_REAL(renameat2);
  const int error = changesPath("renameat2", folder, to);
  return error != 0 ? fails(error) : kReal(fromFolder, from, folder, to, flags);
}
extern "C" int link(const char* from, const char* to) noexcept {
  HUNAV_REAL(link);
  const int error = changesPath("link", AT_FDCWD, to, Needs::Space);
  return error != 0 ? fails(error) : kReal(from, to);
}
extern "C" int linkat(int fromFolder, const char* from, int folder, const char* to,
                      int flags) noexcept {
  HUNAV_REAL(linkat);
  const int error = changesPath("linkat", folder, to, Needs::Space);
  return error != 0 ? fails(error) : kReal(fromFolder, from, folder, to, flags);
}
extern "C" int unlink(const char* path) noexcept {
  HUNAV_REAL(unlink);
  const int error = changesPath("unlink", AT_FDCWD, path);
  return error != 0 ? fails(error) : kReal(path);
}
extern "C" int unlinkat(int folder, const char* path, int flags) noexcept {
  HUNAV_REAL(unlinkat);
  const int error = changesPath("unlinkat", folder, path);
  return error != 0 ? fails(error) : kReal(folder, path, flags);
}
extern "C" int remove(const char* path) noexcept {
  HUNAV_REAL(remove);
  const int error = changesPath("remove", AT_FDCWD, path);
  return error != 0 ? fails(error) : kReal(path);
}
extern "C" int rmdir(const char* path) noexcept {
  HUNAV_REAL(rmdir);
  const int error = changesPath("rmdir", AT_FDCWD, path);
  return error != 0 ? fails(error) : kReal(path);
}
extern "C" int mkdir(const char* path, mode_t mode) noexcept {
  HUNAV_REAL(mkdir);
  const int error = changesPath("mkdir", AT_FDCWD, path, Needs::Space);
  return error != 0 ? fails(error) : kReal(path, mode);
}
extern "C" int mkdirat(int folder, const char* path, mode_t mode) noexcept {
  HUNAV_REAL(mkdirat);
  const int error = changesPath("mkdirat", folder, path, Needs::Space);
  return error != 0 ? fails(error) : kReal(folder, path, mode);
}

extern "C" ssize_t read(int descriptor, void* to, size_t count) {
  HUNAV_REAL(read);
  const int error = readsOpen("read", descriptor);
  return error != 0 ? fails(error) : kReal(descriptor, to, count);
}
extern "C" ssize_t pread(int descriptor, void* to, size_t count, off_t place) {
  HUNAV_REAL(pread);
  const int error = readsOpen("pread", descriptor);
  return error != 0 ? fails(error) : kReal(descriptor, to, count, place);
}
extern "C" ssize_t pread64(int descriptor, void* to, size_t count, off64_t place) {
  HUNAV_REAL(pread64);
  const int error = readsOpen("pread64", descriptor);
  return error != 0 ? fails(error) : kReal(descriptor, to, count, place);
}
extern "C" ssize_t __read_chk(int descriptor, void* to, size_t count, size_t /*room*/) {
  return ::read(descriptor, to, count);
}
extern "C" ssize_t __pread64_chk(int descriptor, void* to, size_t count, off64_t place,
                                 size_t /*room*/) {
  return ::pread64(descriptor, to, count, place);
}

// NOLINTEND
