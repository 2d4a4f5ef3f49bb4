#pragma once

#include <new>
#include <string>
#include <system_error>

namespace base {

/// The message of an error of the operating system. Throws std::bad_alloc if memory is exhausted,
/// as allocations do, so that the program reports it in the same way everywhere.
inline std::string systemErrorMessage(const std::error_code& error) {
  if (error == std::errc::not_enough_memory) {
    throw std::bad_alloc();
  }
  return error.message();
}

}  // namespace base
