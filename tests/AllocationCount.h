#pragma once

#include <atomic>
#include <cstdlib>
#include <malloc.h>
#include <new>

/// Counts what operator new hands out and what is held of it. Replaces the operators of the whole
/// program, so it is for the one source file of a test.
namespace {
std::atomic<long> allocations{0};
std::atomic<long> bytesHeld{0};

void* counted(void* memory) {
  ++allocations;
  bytesHeld += static_cast<long>(malloc_usable_size(memory));
  return memory;
}
void release(void* memory) {
  bytesHeld -= static_cast<long>(malloc_usable_size(memory));
  std::free(memory);
}
}  // namespace

void* operator new(std::size_t size) {
  if (void* const memory = std::malloc(size == 0 ? 1 : size)) {
    return counted(memory);
  }
  throw std::bad_alloc();
}
/// Of the same kind, or a sanitizer sees memory of its own given to our delete.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  void* const memory = std::malloc(size == 0 ? 1 : size);
  return memory != nullptr ? counted(memory) : nullptr;
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  if (void* const memory = std::aligned_alloc(step, (size + step - 1) / step * step)) {
    return counted(memory);
  }
  throw std::bad_alloc();
}
void operator delete(void* memory, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t /*alignment*/) noexcept {
  release(memory);
}
void operator delete(void* memory) noexcept {
  release(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  release(memory);
}
