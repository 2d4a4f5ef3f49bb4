#pragma once

#include <optional>
#include <string>

namespace app {

/// SHA-256 (FIPS 180-4) of what stands in a file, in lower-case hexadecimal digits; nothing when it
/// cannot be read.
std::optional<std::string> sha256OfFile(const std::string& path);

}  // namespace app
