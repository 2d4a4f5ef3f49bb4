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
#include <type_traits>
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
#define HUNAV_REAL(name)                                      \
  [] {                                                        \
    static auto* const kReal = real<decltype(::name)>(#name); \
    return kReal;                                             \
  }()

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

/// The failure with this error, or what the real call returns.
template <class Real, class... Words>
auto unless(int error, Real* call, Words... words) {
  using Told = decltype(call(words...));
  if (error == 0) {
    return call(words...);
  }
  errno = error;
  if constexpr (std::is_pointer_v<Told>) {
    return Told{nullptr};
  } else {
    return Told{-1};
  }
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

template <class Real, class... Words>
ssize_t writeTo(int descriptor, const char* name, Real* call, Words... words) {
  if (const int error = changesOpen(name, descriptor, Needs::Space)) {
    return fails(error);
  }
  noteSynced(descriptor, false);
  return call(words...);
}

template <class Real>
int syncTo(int descriptor, const char* name, Real* call) {
  if (const int error = changesOpen(name, descriptor)) {
    return fails(error);
  }
  const int told = call(descriptor);
  noteSynced(descriptor, true);
  return told;
}

}  // namespace

#define HUNAV_OPEN(name)                                                              \
  extern "C" int name(const char* path, int flags, ...) {                             \
    va_list words;                                                                    \
    va_start(words, flags);                                                           \
    const mode_t mode = modeOf(flags, words);                                         \
    va_end(words);                                                                    \
    return unless(opens(AT_FDCWD, path, flags), HUNAV_REAL(name), path, flags, mode); \
  }
HUNAV_OPEN(open)
HUNAV_OPEN(open64)

#define HUNAV_OPENAT(name)                                                                  \
  extern "C" int name(int folder, const char* path, int flags, ...) {                       \
    va_list words;                                                                          \
    va_start(words, flags);                                                                 \
    const mode_t mode = modeOf(flags, words);                                               \
    va_end(words);                                                                          \
    return unless(opens(folder, path, flags), HUNAV_REAL(name), folder, path, flags, mode); \
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
  return unless(opensStream(path, mode), HUNAV_REAL(fopen), path, mode);
}
extern "C" FILE* fopen64(const char* path, const char* mode) {
  return unless(opensStream(path, mode), HUNAV_REAL(fopen64), path, mode);
}
extern "C" DIR* opendir(const char* path) {
  return unless(opens(AT_FDCWD, path, O_RDONLY), HUNAV_REAL(opendir), path);
}

extern "C" ssize_t write(int descriptor, const void* bytes, size_t count) {
  return writeAt(HUNAV_REAL(write), "write", descriptor, bytes, count);
}
extern "C" ssize_t pwrite(int descriptor, const void* bytes, size_t count, off_t place) {
  return writeAt(HUNAV_REAL(pwrite), "pwrite", descriptor, bytes, count, place);
}
extern "C" ssize_t pwrite64(int descriptor, const void* bytes, size_t count, off64_t place) {
  return writeAt(HUNAV_REAL(pwrite64), "pwrite64", descriptor, bytes, count, place);
}
extern "C" ssize_t writev(int descriptor, const iovec* parts, int count) {
  return writeTo(descriptor, "writev", HUNAV_REAL(writev), descriptor, parts, count);
}
extern "C" ssize_t sendfile(int to, int from, off_t* place, size_t count) noexcept {
  return writeTo(to, "sendfile", HUNAV_REAL(sendfile), to, from, place, count);
}
extern "C" ssize_t sendfile64(int to, int from, off64_t* place, size_t count) noexcept {
  return writeTo(to, "sendfile64", HUNAV_REAL(sendfile64), to, from, place, count);
}
extern "C" ssize_t copy_file_range(int from, off64_t* fromPlace, int to, off64_t* toPlace,
                                   size_t count, unsigned flags) {
  return writeTo(to, "copy_file_range", HUNAV_REAL(copy_file_range), from, fromPlace, to, toPlace,
                 count, flags);
}

extern "C" int fsync(int descriptor) {
  return syncTo(descriptor, "fsync", HUNAV_REAL(fsync));
}
extern "C" int fdatasync(int descriptor) {
  return syncTo(descriptor, "fdatasync", HUNAV_REAL(fdatasync));
}
extern "C" int ftruncate(int descriptor, off_t size) noexcept {
  return unless(changesOpen("ftruncate", descriptor), HUNAV_REAL(ftruncate), descriptor, size);
}
extern "C" int ftruncate64(int descriptor, off64_t size) noexcept {
  return unless(changesOpen("ftruncate64", descriptor), HUNAV_REAL(ftruncate64), descriptor, size);
}
extern "C" int fchmod(int descriptor, mode_t mode) noexcept {
  return unless(changesOpen("fchmod", descriptor), HUNAV_REAL(fchmod), descriptor, mode);
}
/// As the kernel does it: the descriptor is gone, whatever is told.
extern "C" int close(int descriptor) {
  const int flags = state() != nullptr ? ::fcntl(descriptor, F_GETFL) : -1;
  const bool isWritten = flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
  const int error = isWritten ? changesOpen("close", descriptor) : 0;
  const int told = HUNAV_REAL(close)(descriptor);
  return error != 0 ? fails(error) : told;
}

extern "C" int rename(const char* from, const char* to) noexcept {
  return unless(changesPath("rename", AT_FDCWD, to), HUNAV_REAL(rename), from, to);
}
extern "C" int renameat(int fromFolder, const char* from, int folder, const char* to) noexcept {
  return unless(changesPath("renameat", folder, to), HUNAV_REAL(renameat), fromFolder, from, folder,
                to);
}
extern "C" int renameat2(int fromFolder, const char* from, int folder, const char* to,
                         unsigned flags) noexcept {
  return unless(changesPath("renameat2", folder, to), HUNAV_REAL(renameat2), fromFolder, from,
                folder, to, flags);
}
extern "C" int link(const char* from, const char* to) noexcept {
  return unless(changesPath("link", AT_FDCWD, to, Needs::Space), HUNAV_REAL(link), from, to);
}
extern "C" int linkat(int fromFolder, const char* from, int folder, const char* to,
                      int flags) noexcept {
  return unless(changesPath("linkat", folder, to, Needs::Space), HUNAV_REAL(linkat), fromFolder,
                from, folder, to, flags);
}
extern "C" int unlink(const char* path) noexcept {
  return unless(changesPath("unlink", AT_FDCWD, path), HUNAV_REAL(unlink), path);
}
extern "C" int unlinkat(int folder, const char* path, int flags) noexcept {
  return unless(changesPath("unlinkat", folder, path), HUNAV_REAL(unlinkat), folder, path, flags);
}
extern "C" int remove(const char* path) noexcept {
  return unless(changesPath("remove", AT_FDCWD, path), HUNAV_REAL(remove), path);
}
extern "C" int rmdir(const char* path) noexcept {
  return unless(changesPath("rmdir", AT_FDCWD, path), HUNAV_REAL(rmdir), path);
}
extern "C" int mkdir(const char* path, mode_t mode) noexcept {
  return unless(changesPath("mkdir", AT_FDCWD, path, Needs::Space), HUNAV_REAL(mkdir), path, mode);
}
extern "C" int mkdirat(int folder, const char* path, mode_t mode) noexcept {
  return unless(changesPath("mkdirat", folder, path, Needs::Space), HUNAV_REAL(mkdirat), folder,
                path, mode);
}

extern "C" ssize_t read(int descriptor, void* to, size_t count) {
  return unless(readsOpen("read", descriptor), HUNAV_REAL(read), descriptor, to, count);
}
extern "C" ssize_t pread(int descriptor, void* to, size_t count, off_t place) {
  return unless(readsOpen("pread", descriptor), HUNAV_REAL(pread), descriptor, to, count, place);
}
extern "C" ssize_t pread64(int descriptor, void* to, size_t count, off64_t place) {
  return unless(readsOpen("pread64", descriptor), HUNAV_REAL(pread64), descriptor, to, count,
                place);
}
extern "C" ssize_t __read_chk(int descriptor, void* to, size_t count, size_t /*room*/) {
  return ::read(descriptor, to, count);
}
extern "C" ssize_t __pread64_chk(int descriptor, void* to, size_t count, off64_t place,
                                 size_t /*room*/) {
  return ::pread64(descriptor, to, count, place);
}

// NOLINTEND
