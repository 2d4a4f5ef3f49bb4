#pragma once

#include <cstddef>

namespace app {

/// Reserves memory for all threads of the program. The first failed allocation releases the reserve
/// before std::bad_alloc is thrown, because destructors may allocate during unwinding
/// (nlohmann::json). If that is not sufficient, the program prints the same message and exits with
/// the same code, without running destructors.
void reserveMemory();

/// Throws std::bad_alloc if this many bytes cannot be allocated now. Call before libraries that do
/// not check the result of malloc.
void requireMemory(std::size_t bytes);

}  // namespace app
