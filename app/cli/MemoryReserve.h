#pragma once

namespace app {

/// When memory ends, std::bad_alloc is thrown as ever, and the first time some memory that was set
/// aside is given back: destructors that need some on the way to whoever tells it would end the
/// program otherwise (those of nlohmann::json do). For the whole program, from every thread.
void setMemoryAside();

}  // namespace app
