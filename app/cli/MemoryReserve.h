#pragma once

#include <cstddef>

namespace app {

/// For the whole program, from every thread. When memory ends, std::bad_alloc is thrown as ever,
/// and the first time some memory that was set aside is given back, since destructors may need some
/// on the way to whoever tells it (those of nlohmann::json do). Where that is not enough either,
/// the program ends with the same line and exit code, not by a signal; no destructor runs then.
void setMemoryAside();

/// Throws std::bad_alloc where so much [bytes] cannot be had now: before libraries are called that
/// do not look at what malloc hands out.
void requireMemory(std::size_t bytes);

}  // namespace app
