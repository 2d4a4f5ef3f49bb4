#include "app/cli/MemoryReserve.h"

#include <atomic>
#include <cstdlib>
#include <cxxabi.h>
#include <exception>
#include <new>
#include <string>
#include <typeinfo>
#include <unistd.h>

#include "app/cli/CommandRegistry.h"
#include "app/run/Reason.h"

namespace app {

namespace {

constexpr std::size_t kReserve =
    std::size_t{64} * 1024;  // [bytes]; below what malloc maps by itself

std::atomic<void*> reserve{nullptr};
std::string lastLine;                        // written when nothing can be allocated any more
std::terminate_handler others = std::abort;  // for all that is not about memory

void giveBackAndThrow() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

[[noreturn]] void tellOrAbort() {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown != nullptr && *thrown == typeid(std::bad_alloc)) {
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, lastLine.data(), lastLine.size());
    ::_exit(ExitRunFailed);
  }
  others();
  std::abort();
}

}  // namespace

void setMemoryAside() {
  std::free(reserve.exchange(std::malloc(kReserve)));
  std::set_new_handler(giveBackAndThrow);
  lastLine = "error: " + reasonOf(std::bad_alloc()) + "\n";
  if (const auto before = std::set_terminate(tellOrAbort); before != tellOrAbort) {
    others = before;
  }
}

void requireMemory(std::size_t bytes) {
  void* volatile room = std::malloc(bytes);  // volatile: an optimiser would leave both calls out
  if (room == nullptr) {
    throw std::bad_alloc();
  }
  std::free(room);
}

}  // namespace app
