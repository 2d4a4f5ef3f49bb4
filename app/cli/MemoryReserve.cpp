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
#include "app/run/ExceptionMessage.h"

namespace app {

namespace {

constexpr std::size_t kReserve =
    std::size_t{64} * 1024;  // [bytes]; below the mmap threshold of malloc

std::atomic<void*> reserve{nullptr};
std::string outOfMemoryMessage;                       // preallocated: written when allocation fails
std::terminate_handler previousHandler = std::abort;  // for other exceptions

void releaseReserveAndThrow() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

[[noreturn]] void reportOrAbort() {
  const std::type_info* thrown = abi::__cxa_current_exception_type();
  if (thrown != nullptr && *thrown == typeid(std::bad_alloc)) {
    [[maybe_unused]] const ssize_t written =
        ::write(STDERR_FILENO, outOfMemoryMessage.data(), outOfMemoryMessage.size());
    ::_exit(ExitRunFailed);
  }
  previousHandler();
  std::abort();
}

}  // namespace

void reserveMemory() {
  std::free(reserve.exchange(std::malloc(kReserve)));
  std::set_new_handler(releaseReserveAndThrow);
  outOfMemoryMessage = "error: " + exceptionMessage(std::bad_alloc()) + "\n";
  if (const auto before = std::set_terminate(reportOrAbort); before != reportOrAbort) {
    previousHandler = before;
  }
}

void requireMemory(std::size_t bytes) {
  void* volatile room = std::malloc(bytes);  // volatile: otherwise both calls may be removed
  if (room == nullptr) {
    throw std::bad_alloc();
  }
  std::free(room);
}

}  // namespace app
