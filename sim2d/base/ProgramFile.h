#pragma once

#include <string>

/// Files of the running program. Thread-safe.
namespace base {

/// Path of the running executable; empty: unknown.
std::string programFile();
/// The file that contains this code: the executable, or the Python module.
std::string codeFile();

}  // namespace base
