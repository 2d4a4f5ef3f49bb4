#include "app/cli/MemoryReserve.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace app {

namespace {

constexpr std::size_t kReserve = 64 * 1024;  // [bytes]; below what malloc maps by itself

std::atomic<void*> reserve{nullptr};

void giveBackAndThrow() {
  std::free(reserve.exchange(nullptr));
  throw std::bad_alloc();
}

}  // namespace

void setMemoryAside() {
  std::free(reserve.exchange(std::malloc(kReserve)));
  std::set_new_handler(giveBackAndThrow);
}

}  // namespace app
