#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

/// Counts what operator new hands out. Replaces the operators of the whole program, so it is for
/// the one source file of a test.
namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
  ++allocations;
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) {
    return memory;
  }
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
