#pragma once

#include <string>

namespace app {

/// SHA-256 of what stands in a file, in lower-case hexadecimal digits; empty when it cannot be
/// read.
std::string sha256OfFile(const std::string& path);

}  // namespace app
