#pragma once

#include <cerrno>
#include <dlfcn.h>
#include <functional>
#include <sys/wait.h>
#include <unistd.h>

/// Calls that change a folder, struck at a moment of choice: this program's rename, unlink and
/// fsync stand in the place of those of the C library. For one source file per program.
namespace struck {

inline int callsLeft = -1;  // until the process dies or, with `fault`, a call fails; < 0: never
inline int fault = 0;       // errno of the failing call; 0: the process dies before it

/// Whether this call is to fail.
inline bool isStruck() {
  if (callsLeft < 0 || --callsLeft >= 0) {
    return false;
  }
  if (fault == 0) {
    ::_exit(9);
  }
  errno = fault;
  return true;
}

template <class Function>
Function* systemCall(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

/// In a process of its own; its exit code.
inline int elsewhere(const std::function<int()>& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    ::_exit(work());
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace struck

extern "C" int rename(const char* from, const char* to) noexcept {
  static auto* const kReal = struck::systemCall<int(const char*, const char*)>("rename");
  return struck::isStruck() ? -1 : kReal(from, to);
}
extern "C" int unlink(const char* path) noexcept {
  static auto* const kReal = struck::systemCall<int(const char*)>("unlink");
  return struck::isStruck() ? -1 : kReal(path);
}
extern "C" int fsync(int descriptor) {
  static auto* const kReal = struck::systemCall<int(int)>("fsync");
  return struck::isStruck() ? -1 : kReal(descriptor);
}
